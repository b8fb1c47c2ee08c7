//! Long calls: without the GIL, stopped by Ctrl-C, with a bar of progress.

use crate::errors::{Fault, input_error};
use pyo3::{exceptions::PyRuntimeError, prelude::*};
use std::{
    io::{Write, stderr},
    ops::ControlFlow,
    sync::{
        atomic::{AtomicBool, Ordering},
        mpsc::{self, RecvTimeoutError},
    },
    thread,
    time::{Duration, Instant},
};

/// The number of characters of a full bar.
const WIDTH: usize = 30;

/// The time between two checks for signals.
const BETWEEN: Duration = Duration::from_millis(50);

/// What a long call reports to, about ten times a second: how many steps or samples are done, of how many.
pub(crate) type Report<'r> = &'r mut dyn FnMut(u64, u64) -> ControlFlow<()>;

/// Calls `work` without the GIL. `work` reports its progress, and stops if it is told to.
///
/// # Errors
/// `KeyboardInterrupt`, or what another signal handler raises; and the errors of `work`.
pub(crate) fn portions(
    py: Python<'_>,
    bar: bool,
    work: impl FnOnce(Report<'_>) -> Result<(), Fault> + Send,
) -> Result<(), Fault> {
    let begin = Instant::now();
    let (outcome, raised) = py.detach(|| {
        let mut raised = None;
        let outcome = work(&mut |done, all| {
            if bar {
                draw(done as f64 / all.max(1) as f64, begin.elapsed());
            }
            // A signal is seen once: the first stays, also where the work ends before it stops.
            raised = raised.take().or_else(signalled);
            if raised.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        (outcome, raised)
    });
    if bar {
        eprintln!();
    }
    raised.map_or(outcome, |raised| Err(raised.into()))
}

/// What the handler of a signal raises, if a signal arrived.
pub(crate) fn signalled() -> Option<PyErr> {
    Python::attach(|py| py.check_signals()).err()
}

/// Draws a bar of progress in the current line of stderr.
fn draw(fraction: f64, elapsed: Duration) {
    let (full, seconds) = ((fraction * WIDTH as f64) as usize, elapsed.as_secs_f64() * (1.0 / fraction - 1.0));
    let (bar, rest, percent) = ("#".repeat(full), ".".repeat(WIDTH - full), (100.0 * fraction) as u32);
    let mut to = stderr().lock();
    // A terminal that is gone is no reason to stop.
    let _ = write!(to, "\r[{bar}{rest}] {percent} %, {seconds:.0} s left\x1b[K");
    let _ = to.flush();
}

/// Finds out every 50 ms, between many short pieces of work, that a check is due, mostly at the cost of a counter.
pub(crate) struct Pulse {
    last: Instant,
    every: u64,
    left: u64,
}

impl Pulse {
    pub(crate) fn new() -> Self {
        Self { last: Instant::now(), every: 1, left: 1 }
    }

    /// Whether it is time for a check.
    pub(crate) fn is_due(&mut self) -> bool {
        self.left -= 1;
        if self.left > 0 {
            return false;
        }
        self.every = if self.last.elapsed() < BETWEEN { 2 * self.every } else { self.every.div_ceil(2) };
        self.left = self.every;
        self.last = Instant::now();
        true
    }
}

/// Calls `work` on another thread without the GIL, while this thread waits for signals. `work` is told whether to go on.
///
/// # Errors
/// `KeyboardInterrupt`, or what another signal handler raises; and the errors of `work`.
pub(crate) fn interruptible<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&(dyn Fn() -> bool + Sync)) -> Result<T, Fault> + Send,
) -> Result<T, Fault> {
    py.detach(|| {
        let stop = AtomicBool::new(false);
        thread::scope(|scope| {
            let (done, waits) = mpsc::channel();
            let stop = &stop;
            scope.spawn(move || done.send(work(&|| !stop.load(Ordering::Relaxed))));
            loop {
                match waits.recv_timeout(BETWEEN) {
                    Ok(result) => return result,
                    Err(RecvTimeoutError::Timeout) => {}
                    Err(RecvTimeoutError::Disconnected) => {
                        return Err(PyRuntimeError::new_err("a function of the system panicked").into());
                    }
                }
                if let Some(raised) = signalled() {
                    stop.store(true, Ordering::Relaxed);
                    return Err(raised.into());
                }
            }
        })
    })
}

/// Reads a number of steps or of samples.
pub(crate) fn count(object: &Bound<'_, PyAny>) -> PyResult<u64> {
    object.extract().map_err(|_| {
        input_error(format!(
            "a number of steps or samples is {object}: expected an integer that is not negative\nhelp: runs with a negative h \
             go backwards"
        ))
    })
}
