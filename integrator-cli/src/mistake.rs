//! What is wrong with an input, as rustc would say it.

use crate::source::Source;
use proc_macro2::Span;
use std::fmt::Write;

/// Everything that is wrong, ready to be printed.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Mistake(pub(crate) String);

impl Mistake {
    /// A message that belongs to no place in a text.
    pub(crate) fn plain(message: impl Into<String>) -> Self {
        Self(format!("error: {}\n", message.into()))
    }

    /// Messages, each with the line of its place and carets below it.
    pub(crate) fn at(source: &Source, messages: impl IntoIterator<Item = (Span, String)>) -> Self {
        let shown = messages.into_iter().map(|(span, message)| shown(source, span, &message));
        Self(shown.collect::<Vec<_>>().join("\n"))
    }

    /// All mistakes that the macros note in something; `within` is the place of those that have none.
    pub(crate) fn of(source: &Source, error: syn::Error, within: Span) -> Self {
        let placed = error.into_iter().map(|error| {
            let span = if is_place(error.span()) { error.span() } else { within };
            (span, error.to_string())
        });
        Self::at(source, placed)
    }

    /// Several of them, one after the other.
    pub(crate) fn joined(mistakes: Vec<Self>) -> Self {
        Self(mistakes.into_iter().map(|mistake| mistake.0).collect::<Vec<_>>().join("\n"))
    }
}

/// Whether a span is one of the text: what a macro makes up is nowhere.
fn is_place(span: Span) -> bool {
    span.byte_range() != (0..0)
}

fn shown(source: &Source, span: Span, message: &str) -> String {
    let (start, end) = (span.start(), span.end());
    let (message, advice) = message.split_once('\n').unwrap_or((message, ""));
    let mut shown = format!("error: {message}\n");
    let line = source.text.lines().nth(start.line.wrapping_sub(1)).filter(|_| is_place(span));
    let advise = |mut shown: String, gutter: &str| {
        for line in advice.lines() {
            let _ = writeln!(shown, "{gutter} = {line}");
        }
        shown
    };
    let Some(line) = line else {
        let _ = writeln!(shown, " --> {}", source.name);
        return advise(shown, " ");
    };
    let length = line.chars().count();
    // Of a place over several lines, the first one is shown.
    let end = if end.line == start.line { end.column } else { length };
    let carets = "^".repeat(end.saturating_sub(start.column).max(1));
    // Tabs stay tabs, so that the carets stand below what they mean.
    let indent: String = line.chars().take(start.column).map(|c| if c == '\t' { c } else { ' ' }).collect();
    let number = start.line.to_string();
    let gutter = " ".repeat(number.len());
    let _ = writeln!(shown, "{gutter}--> {}:{number}:{}", source.name, start.column + 1);
    let _ = writeln!(shown, "{gutter} |\n{number} | {line}\n{gutter} | {indent}{carets}");
    if !advice.is_empty() {
        let _ = writeln!(shown, "{gutter} |");
    }
    advise(shown, &gutter)
}
