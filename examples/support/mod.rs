//! What the longer examples share: where their pictures go, and how they show how far they are and stop on Ctrl-C.

use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use std::{
    fmt::Write,
    process::exit,
    sync::{
        Once,
        atomic::{AtomicBool, Ordering},
    },
};

/// Set when Ctrl-C is pressed.
static STOPPED: AtomicBool = AtomicBool::new(false);
static HANDLER: Once = Once::new();

/// Returns the folder of pictures: the one after `--out`, or `target/pictures`.
#[cfg(feature = "pictures")]
pub(crate) fn folder() -> std::path::PathBuf {
    let mut arguments = std::env::args().skip_while(|argument| argument != "--out");
    arguments.nth(1).map_or_else(|| "target/pictures".into(), std::path::PathBuf::from)
}

/// Progress of a long computation: a bar with rate and remaining time on a terminal. Ctrl-C ends the computation with the
/// results so far; pressed again, it ends the program.
pub(crate) struct Watch(ProgressBar);

impl Watch {
    /// Creates the progress of `count` items with the name `things`.
    pub(crate) fn new(total: u64, things: &'static str) -> Self {
        HANDLER.call_once(|| {
            let pressed = || {
                if STOPPED.swap(true, Ordering::Relaxed) {
                    exit(130);
                }
            };
            if let Err(error) = ctrlc::set_handler(pressed) {
                eprintln!("Ctrl-C ends the program at once: {error}");
            }
        });
        let style = ProgressStyle::with_template("{bar:30} {percent:>3} % of {human_len} {msg}, {rate}, {eta} left");
        let bar = ProgressBar::new(total).with_message(things);
        Self(match style {
            Ok(style) => bar.with_style(style.with_key("rate", rate)),
            Err(_) => bar,
        })
    }

    /// Reports the number of finished items. Returns whether to continue.
    pub(crate) fn done(&self, count: u64) -> bool {
        self.0.set_position(count);
        !STOPPED.load(Ordering::Relaxed)
    }
    /// Prints a line above the bar.
    #[allow(dead_code, reason = "not every example has a table")]
    pub(crate) fn line(&self, text: &str) {
        self.0.suspend(|| println!("{text}"));
    }
}

impl Drop for Watch {
    /// Removes the bar.
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

/// Returns the rate per second with two digits.
fn rate(state: &ProgressState, text: &mut dyn Write) {
    // Writing to a string does not fail.
    let _ = match state.per_sec() {
        rate if rate < 1e4 => write!(text, "{rate:.0}/s"),
        rate => write!(text, "{rate:.1e}/s"),
    };
}
