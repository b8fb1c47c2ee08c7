//! Threads, where there is an operating system to give some.

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
pub(crate) fn at_once<T: Send>(mut all: Vec<T>, job: impl Fn(T) + Sync) {
    let last = all.pop();
    if all.is_empty() {
        last.into_iter().for_each(job);
    } else {
        thread::scope(|scope| {
            for one in all {
                scope.spawn(|| job(one));
            }
            last.into_iter().for_each(&job);
        });
    }
}

/// Does a job for each of these, one after the other.
#[cfg(not(feature = "std"))]
pub(crate) fn at_once<T: Send>(all: Vec<T>, job: impl Fn(T) + Sync) {
    all.into_iter().for_each(job);
}
