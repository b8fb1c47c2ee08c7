//! Threads, where there is an operating system.

use alloc::{boxed::Box, vec::Vec};
#[cfg(feature = "std")]
use std::{num::NonZeroUsize, sync::OnceLock, thread};

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

/// A job behind a pointer, so that the code that starts threads is compiled once.
pub(crate) type Job<'j> = Box<dyn FnOnce() + Send + 'j>;

/// Runs all jobs in parallel, the last one in this thread.
#[cfg(feature = "std")]
pub(crate) fn at_once(mut jobs: Vec<Job<'_>>) {
    let last = jobs.pop();
    thread::scope(|scope| {
        for job in jobs {
            scope.spawn(job);
        }
        last.into_iter().for_each(|job| job());
    });
}

/// Runs all jobs, one after the other.
#[cfg(not(feature = "std"))]
pub(crate) fn at_once(jobs: Vec<Job<'_>>) {
    jobs.into_iter().for_each(|job| job());
}
