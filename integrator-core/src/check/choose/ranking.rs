//! The ranking of compositions, as data and as a table.

use crate::{composition::Class, error::Number};
use std::fmt;

/// A composition with the longest step that reaches the goal, or Taylor's method with the loosest tolerance that does.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Choice {
    /// The splitting.
    pub splitting: Split,
    /// The name of the composition, or `Taylor`.
    pub composition: &'static str,
    /// The order of the composition.
    pub order: u32,
    /// The class of Hamiltonians that the composition can integrate.
    pub class: Class,
    /// The step to use, in fictitious time if the method has one. For [`Taylor`](crate::taylor::Taylor), the mean of
    /// the steps that it chose.
    pub step: f64,
    /// The number of steps in the span.
    pub steps: u64,
    /// The tolerance to use, if the method chooses its own steps.
    pub tolerance: Option<f64>,
    /// The measured error with this step.
    pub error: f64,
    /// The work over the span: force evaluations, where a gradient counts as one more and a processor once. For
    /// [`Taylor`](crate::taylor::Taylor), orders of series.
    pub evaluations: u64,
    /// The processor time of these steps on this machine, the shortest of three runs.
    pub seconds: f64,
}

impl Choice {
    /// The method as it is written, without its path.
    fn name(&self) -> String {
        match (self.tolerance, self.splitting.inner_steps) {
            (Some(tolerance), _) => format!("{}({tolerance:.1e})", self.composition),
            (None, Some(steps)) => format!("{}.nested({steps})", self.composition),
            (None, None) => self.composition.to_owned(),
        }
    }
}

/// The name of a splitting. Displays as `Planets (kepler + interaction)`, or as `Pendulum (in one piece)` without
/// parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Split {
    /// The type name of the system, without its path.
    pub system: &'static str,
    /// The names of the parts; empty if `H` is not split.
    pub parts: &'static [&'static str],
    /// The number of inner steps, if it is not that of the annotation.
    pub inner_steps: Option<u32>,
}

impl fmt::Display for Split {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts = if self.parts.is_empty() { "in one piece" } else { &self.parts.join(" + ") };
        let steps = self.inner_steps.map(|steps| format!(", {steps} inner steps")).unwrap_or_default();
        f.pad(&format!("{} ({parts}{steps})", self.system))
    }
}

/// A splitting without a result in the ranking.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Unranked {
    /// The splitting.
    pub splitting: Split,
    /// The composition with the smallest error for this splitting.
    pub composition: &'static str,
    /// The smallest error.
    pub error: f64,
    /// The reason if no composition was tried: the [fictitious time](super::LogarithmicSteps) does not advance from
    /// this start.
    pub not_tried: Option<&'static str>,
}

/// Compositions that reach a goal, cheapest first; there is at least one. Displays as a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Ranking {
    pub(super) choices: Vec<Choice>,
    pub(super) unranked: Vec<Unranked>,
    /// Whether splittings were to be compared.
    pub(super) among: bool,
}

impl Ranking {
    /// Returns the cheapest choice.
    pub fn best(&self) -> &Choice {
        &self.choices[0]
    }

    /// Returns all choices, cheapest first.
    pub fn choices(&self) -> &[Choice] {
        &self.choices
    }

    /// Returns the splittings that do not reach the goal in sixteen times the time of the best choice.
    ///
    /// An error that remains large indicates that the splitting has a different Hamiltonian.
    pub fn unranked(&self) -> &[Unranked] {
        &self.unranked
    }
}

impl fmt::Display for Ranking {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self.choices.iter().map(|choice| choice.splitting.to_string().len()).max().unwrap_or(0);
        if self.among {
            write!(f, "{:<width$} ", "splitting")?;
        }
        write!(f, "{:<23} {:>5} {:>12} {:>9}", "composition", "order", "step", "steps")?;
        write!(f, " {:>8} {:>12} {:>13}", "error", "evaluations", "milliseconds")?;
        for choice in &self.choices {
            let Choice { splitting, order, step, steps, error, evaluations, seconds, .. } = choice;
            let (composition, step, milliseconds) = (choice.name(), Number(*step), Number(seconds * 1e3));
            writeln!(f)?;
            if self.among {
                write!(f, "{splitting:<width$} ")?;
            }
            write!(f, "{composition:<23} {order:>5} {step:>12.6} {steps:>9}")?;
            write!(f, " {error:>8.1e} {evaluations:>12} {milliseconds:>13.3}")?;
        }
        for Unranked { splitting, composition, error, not_tried } in &self.unranked {
            if let Some(reason) = not_tried {
                write!(f, "\n{splitting}: not tried, {reason}")?;
                continue;
            }
            write!(
                f,
                "\n{splitting}: not in sixteen times the time of the best; {composition} comes closest with {error:.1e}"
            )?;
        }
        Ok(())
    }
}
