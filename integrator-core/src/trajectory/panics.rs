//! Panics of the user's functions, held back until the data that they interrupted is consistent again.
//!
//! Without `std` nothing is held back, and guards alone restore what was interrupted.

#[cfg(feature = "std")]
use std::{
    any::Any,
    panic::{AssertUnwindSafe, catch_unwind, resume_unwind},
    sync::{Mutex, PoisonError},
};

/// A panic that was caught.
#[cfg(feature = "std")]
pub(crate) struct Panic(Box<dyn Any + Send>);

#[cfg(feature = "std")]
impl Panic {
    /// Resumes the panic.
    pub(crate) fn resume(self) -> ! {
        resume_unwind(self.0)
    }
}

/// No panic can be caught.
#[cfg(not(feature = "std"))]
pub(crate) enum Panic {}

#[cfg(not(feature = "std"))]
impl Panic {
    /// Never called.
    pub(crate) fn resume(self) -> ! {
        match self {}
    }
}

/// Calls a function that may end in a panic of the user's functions. Whatever it changes has to be whole after a panic,
/// or restored by the caller.
pub(crate) fn attempt<T>(function: impl FnOnce() -> T) -> Result<T, Panic> {
    let (mut function, mut value) = (Some(function), None);
    catch(&mut || value = function.take().map(|function| function()))?;
    // Called once, and not interrupted.
    Ok(value.unwrap_or_else(|| unreachable!("a function that has ended has a value")))
}

/// Not generic: what catches panics is compiled once.
fn catch(function: &mut dyn FnMut()) -> Result<(), Panic> {
    #[cfg(feature = "std")]
    return catch_unwind(AssertUnwindSafe(function)).map_err(Panic);
    #[cfg(not(feature = "std"))]
    {
        function();
        Ok(())
    }
}

/// The first panic of several threads.
#[cfg(feature = "std")]
#[derive(Default)]
pub(crate) struct Panics(Mutex<Option<Panic>>);

#[cfg(feature = "std")]
impl Panics {
    /// Calls a function; nothing if it panicked.
    pub(crate) fn attempt<T>(&self, function: impl FnOnce() -> T) -> Option<T> {
        match attempt(function) {
            Ok(value) => Some(value),
            Err(panic) => {
                self.0.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(panic);
                None
            }
        }
    }

    /// Resumes the first panic, if there was one.
    pub(crate) fn resume(self) {
        if let Some(panic) = self.0.into_inner().unwrap_or_else(PoisonError::into_inner) {
            panic.resume();
        }
    }
}
