//! Threads, where there is an operating system to give some.

use alloc::{boxed::Box, vec::Vec};
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

/// A job behind a pointer: what starts threads is compiled once for all of them.
pub(crate) type Job<'j> = Box<dyn FnOnce() + Send + 'j>;

/// Does all of these at the same time, the last one in this thread.
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

/// Does all of these, one after the other.
#[cfg(not(feature = "std"))]
pub(crate) fn at_once(jobs: Vec<Job<'_>>) {
    jobs.into_iter().for_each(|job| job());
}
