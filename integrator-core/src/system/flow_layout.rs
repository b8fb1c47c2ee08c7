//! The layouts of the flows of a run, for its user.

use crate::system::System;
use core::fmt;

/// The layouts in which a run computes its flows, returned by [`Run::layout`](crate::Run::layout).
///
/// A layout has the name by which [`layout = ...`](macro@crate::hamiltonian#layout) requests it, such as `"line"` or
/// `"lists"`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layouts {
    parts: &'static [&'static str],
    names: &'static [&'static str],
    /// Whether there are enough bodies for neighbour lists.
    is_listed: bool,
}

impl Layouts {
    /// The layouts of a run of `H`; `is_listed` if it has enough bodies for neighbour lists.
    pub(crate) const fn of<H: System>(is_listed: bool) -> Self {
        Self { parts: H::PARTS, names: H::LAYOUT, is_listed }
    }

    /// The layouts of no flows.
    pub(crate) const NONE: Self = Self { parts: &[], names: &[], is_listed: false };

    /// Returns the name of the layout of the kick, or of the last part.
    pub fn kick(&self) -> &'static str {
        self.names.last().copied().unwrap_or(PLAIN)
    }

    /// Returns the name of the layout of the drift, or of the first part.
    pub fn drift(&self) -> &'static str {
        self.names.first().copied().unwrap_or(PLAIN)
    }

    /// Returns the names of the parts, each with the name of its layout.
    pub fn parts(self) -> impl Iterator<Item = (&'static str, &'static str)> {
        let names = self.names.iter().copied().chain(core::iter::repeat(PLAIN));
        self.parts.iter().copied().zip(names)
    }

    /// Returns whether the run has enough bodies for neighbour lists: at least 384, and a kick with the layout `"lists"`, or
    /// `"triplets"` and a cutoff of all pairs.
    ///
    /// With fewer bodies, or in a box narrower than two cutoffs, the kick sums over all pairs. For a run from an ensemble,
    /// all members must have enough bodies.
    pub fn is_listed(&self) -> bool {
        self.is_listed
    }
}

/// The name of the layout of a flow that is computed as its formula is written.
const PLAIN: &str = "plain";

impl fmt::Display for Layouts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (number, (part, name)) in self.parts().enumerate() {
            let comma = if number == 0 { "" } else { ", " };
            write!(f, "{comma}{part}: {name}")?;
            match name {
                "lists" if !self.is_listed => f.write_str(" (too few bodies: pairs)")?,
                "triplets" if !self.is_listed => f.write_str(" (no lists: neighbours among all pairs)")?,
                _ => {}
            }
        }
        Ok(())
    }
}
