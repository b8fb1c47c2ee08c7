//! Threads, where there is an operating system.
//!
//! Comes in: jobs that borrow. Goes out: nothing, when all of them are done. Always true: no job depends on who does it.

#[cfg(feature = "std")]
mod workers;

use alloc::{boxed::Box, vec::Vec};
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
    let mut others = HandedOver::to(jobs.len());
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

/// Does the same work on so many threads, this one among them: whoever is free takes what is next.
///
/// # Panics
/// If the work does, once all threads have ended it.
#[cfg(feature = "std")]
pub(crate) fn on_threads(threads: usize, work: &(dyn Fn() + Sync)) {
    at_once((0..threads.max(1)).map(|_| Box::new(work) as Job<'_>).collect());
}
