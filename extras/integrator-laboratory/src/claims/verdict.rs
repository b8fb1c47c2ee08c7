//! A claim with its measured result, as it is printed and shown on a page.

use crate::numbers::plain;

/// A claim and its measured result.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// An identifier for programs: letters, digits and underscores.
    pub name: String,
    /// The claim in words, including the measured quantity.
    pub says: String,
    /// The interval in which the claim holds.
    pub within: [f64; 2],
    /// The measured number; NaN if it could not be measured.
    pub measured: f64,
    /// The name of the picture that shows it; empty if none does.
    pub picture: String,
    /// The unit of the numbers, such as `K`; empty for a number without one.
    pub unit: &'static str,
    /// What it may mean that the claim fails, and what to try.
    pub meaning: &'static str,
}

impl Verdict {
    /// Creates a claim that holds if the number lies in the interval, whose ends may be infinite.
    pub fn new(name: impl Into<String>, says: impl Into<String>, within: [f64; 2], measured: Option<f64>) -> Self {
        Self {
            name: name.into(),
            says: says.into(),
            within,
            measured: measured.unwrap_or(f64::NAN),
            picture: String::new(),
            unit: "",
            meaning: "",
        }
    }

    /// Names the picture that shows the claim, as in [`Laboratory::picture`](crate::Laboratory::picture).
    #[must_use]
    pub fn shown_in(self, picture: impl Into<String>) -> Self {
        Self { picture: picture.into(), ..self }
    }

    /// States what it may mean that the claim fails, and what to try.
    #[must_use]
    pub fn meaning(self, meaning: &'static str) -> Self {
        Self { meaning, ..self }
    }

    /// Returns what it may mean that the claim fails, and what to try.
    pub(crate) fn advice(&self) -> &'static str {
        if self.measured.is_nan() {
            "Nothing could be measured: a method did not come to an end. Try a shorter step."
        } else if self.meaning.is_empty() {
            "Try half the step; if the number stays, the method or the claim is wrong."
        } else {
            self.meaning
        }
    }

    /// Returns the measured number, for readers.
    pub(crate) fn found(&self) -> String {
        in_unit(plain(self.measured), self.unit)
    }

    /// Whether the claim holds.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.within[0] <= self.measured && self.measured <= self.within[1]
    }

    /// Returns `ok` or `FAILED`.
    #[must_use]
    pub fn word(&self) -> &'static str {
        if self.holds() { "ok" } else { "FAILED" }
    }

    /// Returns the expected number, for readers.
    #[must_use]
    pub fn expected(&self) -> String {
        let range = match self.within {
            [least, most] if least == most => format!("exactly {}", plain(least)),
            [least, most] if least == -most => format!("0, to {}", plain(most)),
            [least, f64::INFINITY] => format!("at least {}", plain(least)),
            [f64::NEG_INFINITY, most] => format!("at most {}", plain(most)),
            [0.0, most] => format!("at most {}", plain(most)),
            [least, most] => format!("between {} and {}", plain(least), plain(most)),
        };
        in_unit(range, self.unit)
    }
}

fn in_unit(number: String, unit: &str) -> String {
    if unit.is_empty() { number } else { format!("{number} {unit}") }
}

#[cfg(test)]
mod tests {
    use super::Verdict;

    #[test]
    fn expectations_are_stated_in_words() {
        let cases = [
            ([0.0, 0.0], "exactly 0"),
            ([-1e-12, 1e-12], "0, to 10⁻¹²"),
            ([0.01, f64::INFINITY], "at least 0.01"),
            ([f64::NEG_INFINITY, -0.01], "at most −0.01"),
            ([0.0, 1.5], "at most 1.5"),
            ([1.85, 2.15], "between 1.85 and 2.15"),
        ];
        for (within, text) in cases {
            assert_eq!(Verdict::new("", "", within, Some(0.0)).expected(), text);
        }
        let missing = Verdict::new("", "", [0.0, 1.0], None);
        assert!(!missing.holds() && missing.word() == "FAILED");
        assert!(Verdict::new("", "", [0.0, 1.0], Some(1.0)).holds());
    }
}
