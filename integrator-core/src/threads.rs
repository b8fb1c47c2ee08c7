//! Threads, where there is an operating system.
//!
//! Comes in: jobs that borrow. Goes out: nothing, when all of them are done. Always true: no job depends on who does it.

#[cfg(feature = "std")]
mod workers;

use alloc::{boxed::Box, vec::Vec};
use core::sync::atomic::{AtomicBool, Ordering};
#[cfg(feature = "std")]
use std::{num::NonZeroUsize, sync::OnceLock, thread};
#[cfg(feature = "std")]
use workers::HandedOver;

/// The number of threads of the machine, queried once.
#[cfg(feature = "std")]
pub(crate) fn all_threads() -> usize {
    static ALL: OnceLock<usize> = OnceLock::new();
    *ALL.get_or_init(|| thread::available_parallelism().map_or(1, NonZeroUsize::get))
}

/// The one thread of a machine without an operating system.
#[cfg(not(feature = "std"))]
pub(crate) fn all_threads() -> usize {
    1
}

/// A job behind a pointer, so that the code that hands it over is compiled once.
pub(crate) type Job<'j> = Box<dyn FnOnce() + Send + 'j>;

/// Runs all jobs in parallel, the last one in this thread.
///
/// # Panics
/// If one of them does, once all have ended.
#[cfg(feature = "std")]
pub(crate) fn at_once(mut jobs: Vec<Job<'_>>) {
    let last = jobs.pop();
    let mut others = HandedOver::with_room_for(jobs.len());
    for job in jobs {
        others.hand_over(job);
    }
    last.into_iter().for_each(|job| job());
    others.finish();
}

/// Runs all jobs, one after the other.
#[cfg(not(feature = "std"))]
pub(crate) fn at_once(jobs: Vec<Job<'_>>) {
    jobs.into_iter().for_each(|job| job());
}

/// The smallest number of bytes for which copying or reading them is given to a thread.
const FEWEST_BYTES: usize = 1 << 19;

/// Returns the number of elements of each of this number of threads, or of all threads of the machine.
pub(crate) fn each<T>(elements: &[T], threads: Option<usize>) -> usize {
    let most = size_of_val(elements) / FEWEST_BYTES;
    elements.len().div_ceil(threads.unwrap_or_else(all_threads).min(most).max(1)).max(1)
}

/// Copies elements to as many others, on this number of threads or on all.
pub(crate) fn copy<T: Copy + Send + Sync>(from: &[T], to: &mut [T], threads: Option<usize>) {
    let each = each(from, threads);
    if from.len() <= each {
        return to.copy_from_slice(from);
    }
    let (mut jobs, mut from, mut to) = (Vec::<Job<'_>>::new(), from, to);
    while !from.is_empty() {
        let (these, rest) = from.split_at(each.min(from.len()));
        let (those, rest_of_those) = to.split_at_mut(these.len());
        jobs.push(Box::new(|| those.copy_from_slice(these)));
        (from, to) = (rest, rest_of_those);
    }
    at_once(jobs);
}

/// Whether all parts of a slice pass a test, on this number of threads or on all.
pub(crate) fn all<T: Sync>(elements: &[T], threads: Option<usize>, test: fn(&[T]) -> bool) -> bool {
    let each = each(elements, threads);
    if elements.len() <= each {
        return test(elements);
    }
    let (passed, mut elements) = (AtomicBool::new(true), elements);
    let (mut jobs, passes) = (Vec::<Job<'_>>::new(), &passed);
    while !elements.is_empty() {
        let (part, rest) = elements.split_at(each.min(elements.len()));
        jobs.push(Box::new(move || {
            passes.fetch_and(test(part), Ordering::Relaxed);
        }));
        elements = rest;
    }
    at_once(jobs);
    passed.into_inner()
}

/// Does the same work on this number of threads, including the current one. A free thread takes the next piece.
///
/// # Panics
/// If the work does, once all threads have ended it.
#[cfg(feature = "std")]
pub(crate) fn on_threads(threads: usize, work: &(dyn Fn() + Sync)) {
    at_once((0..threads.max(1)).map(|_| Box::new(work) as Job<'_>).collect());
}

/// The results of all pieces of work, in their order. A free thread takes the next piece.
///
/// # Panics
/// If the work does, once all threads have ended it.
#[cfg(feature = "std")]
pub(crate) fn in_turns<W: Send, T: Send>(pieces: Vec<W>, work: &(dyn Fn(W) -> T + Sync)) -> Vec<T> {
    use std::sync::{Mutex, PoisonError};
    let count = pieces.len();
    let (pieces, done) = (Mutex::new(pieces.into_iter().enumerate()), Mutex::new(Vec::with_capacity(count)));
    let next = || pieces.lock().unwrap_or_else(PoisonError::into_inner).next();
    let take = || {
        while let Some((number, piece)) = next() {
            let result = work(piece);
            done.lock().unwrap_or_else(PoisonError::into_inner).push((number, result));
        }
    };
    on_threads(all_threads().min(count), &take);
    let mut done = done.into_inner().unwrap_or_else(PoisonError::into_inner);
    done.sort_unstable_by_key(|(number, _)| *number);
    done.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::{FEWEST_BYTES, all, copy, each};
    use alloc::{vec, vec::Vec};

    #[test]
    fn no_thread_is_given_little() {
        for length in [0, 1, FEWEST_BYTES, FEWEST_BYTES + 1, 5 * FEWEST_BYTES / 2, 8 * FEWEST_BYTES + 3] {
            let bytes = vec![0_u8; length];
            for threads in [0, 1, 2, 3, usize::MAX] {
                let parts: Vec<usize> = bytes.chunks(each(&bytes, Some(threads))).map(<[u8]>::len).collect();
                // The last part lacks what others are rounded up by.
                let enough = parts.iter().all(|part| part + parts.len() > FEWEST_BYTES);
                assert!(parts.len() <= threads.max(1) && (parts.len() <= 1 || enough), "{threads} threads: {parts:?}");
            }
        }
    }

    #[test]
    fn all_elements_are_copied_and_checked() {
        // Twice and a half what a thread is given at least.
        let from: Vec<u64> = (0..(5 << 19) / 16).collect();
        for threads in [None, Some(1), Some(2), Some(3)] {
            let mut to = vec![0; from.len()];
            copy(&from, &mut to, threads);
            assert_eq!(to, from);
            for wrong in [0, 1 << 17, from.len() - 1] {
                let whole = all(&to, threads, |part| part.iter().all(|number| *number < 1 << 60));
                to[wrong] = 1 << 60;
                let broken = all(&to, threads, |part| part.iter().all(|number| *number < 1 << 60));
                assert!(whole && !broken, "{threads:?}, {wrong}");
                to[wrong] = 0;
            }
        }
    }
}
