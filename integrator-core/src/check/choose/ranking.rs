//! The ranking of compositions, as data and as a table.

use crate::composition::Class;
use std::fmt;

/// A composition with the longest step that met the tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Choice {
    /// Its name.
    pub composition: &'static str,
    /// Its order.
    pub order: u32,
    /// The class of Hamiltonians that it admits.
    pub class: Class,
    /// The step to use.
    pub step: f64,
    /// The number of these steps in the span.
    pub steps: u64,
    /// The error that was measured with this step.
    pub error: f64,
    /// The work over the span: force evaluations, where a gradient counts as one more and a processor once.
    pub evaluations: u64,
    /// The time that these steps took on this machine, the shortest of three runs.
    pub seconds: f64,
}

/// Compositions that reach a tolerance, cheapest first; there is at least one. Displays as a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Ranking(pub(super) Vec<Choice>);

impl Ranking {
    /// The cheapest.
    pub fn best(&self) -> &Choice {
        &self.0[0]
    }

    /// All of them.
    pub fn choices(&self) -> &[Choice] {
        &self.0
    }
}

impl fmt::Display for Ranking {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:<23} {:>5} {:>12} {:>9}", "composition", "order", "step", "steps")?;
        write!(f, " {:>8} {:>12} {:>13}", "error", "evaluations", "milliseconds")?;
        for Choice { composition, order, step, steps, error, evaluations, seconds, .. } in &self.0 {
            let milliseconds = seconds * 1e3;
            write!(f, "\n{composition:<23} {order:>5} {step:>12.6} {steps:>9}")?;
            write!(f, " {error:>8.1e} {evaluations:>12} {milliseconds:>13.3}")?;
        }
        Ok(())
    }
}
