//! Threads, where there is an operating system to give some.

#[cfg(feature = "std")]
use alloc::boxed::Box;
use alloc::vec::Vec;
#[cfg(feature = "std")]
use std::{num::NonZeroUsize, sync::OnceLock, thread};

/// How many threads the machine has, asked once.
#[cfg(feature = "std")]
pub(crate) fn all_threads() -> usize {
    static ALL: OnceLock<usize> = OnceLock::new();
    *ALL.get_or_init(|| thread::available_parallelism().map_or(1, NonZeroUsize::get))
}

/// The one that is there.
#[cfg(not(feature = "std"))]
pub(crate) fn all_threads() -> usize {
    1
}

/// Does a job for each of these, all at the same time, the last one in this thread.
#[cfg(feature = "std")]
pub(crate) fn at_once<T: Send>(all: Vec<T>, job: impl Fn(T) + Sync) {
    // What is done alone is done in every sweep of a short lattice, and needs no place of its own.
    if all.len() < 2 {
        return all.into_iter().for_each(job);
    }
    let mut jobs = Vec::with_capacity(all.len());
    for one in all {
        jobs.push(Box::new(|| job(one)) as Job<'_>);
    }
    all_at_once(jobs);
}

/// A job behind a pointer: what starts threads is compiled once for all of them.
#[cfg(feature = "std")]
type Job<'j> = Box<dyn FnOnce() + Send + 'j>;

#[cfg(feature = "std")]
fn all_at_once(mut jobs: Vec<Job<'_>>) {
    let last = jobs.pop();
    thread::scope(|scope| {
        for job in jobs {
            scope.spawn(job);
        }
        last.into_iter().for_each(|job| job());
    });
}

/// Does a job for each of these, one after the other.
#[cfg(not(feature = "std"))]
pub(crate) fn at_once<T: Send>(all: Vec<T>, job: impl Fn(T) + Sync) {
    all.into_iter().for_each(job);
}
