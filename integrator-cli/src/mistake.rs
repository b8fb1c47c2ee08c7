//! What is wrong with an input, as rustc would say it.

use crate::source::Source;
use proc_macro2::Span;
use std::{fmt::Write, ops::Range};

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

    /// A message about a whole line, the first of which has the number 1.
    pub(crate) fn in_line(source: &Source, line: usize, message: &str) -> Self {
        Self(framed(source, Some((line, None)), message))
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
    // Of a place over several lines, the first one is shown.
    let end = if end.line == start.line { end.column } else { usize::MAX };
    framed(source, is_place(span).then_some((start.line, Some(start.column..end))), message)
}

/// A message with the line and the columns that it is about.
fn framed(source: &Source, place: Option<(usize, Option<Range<usize>>)>, message: &str) -> String {
    let (message, advice) = message.split_once('\n').unwrap_or((message, ""));
    let mut shown = format!("error: {message}\n");
    let advise = |mut shown: String, gutter: &str| {
        for line in advice.lines() {
            let _ = writeln!(shown, "{gutter} = {line}");
        }
        shown
    };
    let place =
        place.and_then(|(number, columns)| Some((number, columns, source.text.lines().nth(number.wrapping_sub(1))?)));
    let Some((number, columns, line)) = place else {
        let _ = writeln!(shown, " --> {}", source.name);
        return advise(shown, " ");
    };
    let number = number.to_string();
    let gutter = " ".repeat(number.len());
    let column = columns.as_ref().map(|columns| format!(":{}", columns.start + 1)).unwrap_or_default();
    let _ = writeln!(shown, "{gutter}--> {}:{number}{column}", source.name);
    let _ = writeln!(shown, "{gutter} |\n{number} | {line}");
    if let Some(columns) = columns {
        let length = columns.end.min(line.chars().count()).saturating_sub(columns.start).max(1);
        // Tabs stay tabs, so that the carets stand below what they mean.
        let indent: String = line.chars().take(columns.start).map(|c| if c == '\t' { c } else { ' ' }).collect();
        let _ = writeln!(shown, "{gutter} | {indent}{}", "^".repeat(length));
    }
    if !advice.is_empty() {
        let _ = writeln!(shown, "{gutter} |");
    }
    advise(shown, &gutter)
}
