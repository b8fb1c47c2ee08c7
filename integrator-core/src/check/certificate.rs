//! What was measured, and how it reads.

use crate::check::{energy::EnergyDrift, order::Order, stability::Stability, stated::Agreement};
use std::fmt;

/// What was measured of one composition on one system, with one start and one step.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Certificate {
    /// The type of the system.
    pub system: &'static str,
    /// The name of the composition.
    pub composition: &'static str,
    /// The step.
    pub step: f64,
    /// The order that the composition claims.
    pub claimed_order: u32,
    /// Whether it claims to be symmetric.
    pub symmetric: bool,
    /// Whether the Hamiltonian does not read the time; only then is there an energy to conserve.
    pub autonomous: bool,
    /// How far one step is from symplectic: [`symplectic_defect`](crate::check::symplectic_defect).
    pub symplectic_defect: f64,
    /// The slope of [`observed_order`](crate::check::observed_order), NaN where none could be measured.
    pub observed_order: f64,
    /// The range and the scatter of that slope.
    pub order: Option<Order>,
    /// How far a run forward and back ends from its start: [`reversibility`](crate::check::reversibility()) over the
    /// span of [`Certificate::order`], in its coarsest steps or in [`Certificate::step`] if that is longer.
    pub reversibility: f64,
    /// What became of the energy: [`energy_drift`](crate::check::energy_drift) over 8192 steps, longer ones where so
    /// many are too short to tell a trend from the flank of an oscillation. Nothing for a Hamiltonian that reads the
    /// time.
    pub energy_drift: Option<EnergyDrift>,
    /// How far the flows are from the gradients of the energies: the largest
    /// [`gradient_error`](crate::check::gradient_error) along the path.
    pub gradient_error: f64,
    /// How often the generated code was held against the user's own functions, at the start and along the path, and agreed.
    /// Nothing where it does not, or where no comparison could be made.
    pub agreement: Option<Agreement>,
    /// How near the step is to the one at which the composition becomes unstable. A warning at most: no certificate is
    /// refused for it.
    pub stability: Option<Stability>,
    /// What rounding explains.
    pub tolerances: Tolerances,
}

/// The sizes that rounding alone explains.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Tolerances {
    /// Of [`Certificate::symplectic_defect`].
    pub symplectic_defect: f64,
    /// Of [`Certificate::reversibility`].
    pub reversibility: f64,
    /// Of [`Certificate::gradient_error`].
    pub gradient_error: f64,
}

impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Tolerances { symplectic_defect, reversibility, gradient_error } = self.tolerances;
        writeln!(f, "{} on {}, h = {}", self.composition, self.system, self.step)?;
        writeln!(f, "  symplectic defect  {:.1e} (rounding explains {symplectic_defect:.1e})", self.symplectic_defect)?;
        write!(f, "  observed order     {:.2} (claimed {}", self.observed_order, self.claimed_order)?;
        if let Some(Order { points, finest, coarsest, span, .. }) = self.order {
            write!(f, "; {points} steps from {finest:.1e} to {coarsest:.1e} over a time of {span:.1e}")?;
        }
        writeln!(f, ")")?;
        write!(f, "  reversibility      {:.1e} ", self.reversibility)?;
        if self.symmetric {
            writeln!(f, "(rounding explains {reversibility:.1e})")?;
        } else {
            writeln!(f, "(not symmetric, none claimed)")?;
        }
        match self.energy_drift {
            Some(EnergyDrift { deviation, course, slope, uncertainty, step, steps, .. }) => writeln!(
                f,
                "  energy drift       {course}: {deviation:.1e} at most in {steps} steps of {step:.1e}; \
                 slope {slope:.1e} +- {uncertainty:.1e} per unit time"
            )?,
            None if self.autonomous => writeln!(f, "  energy drift       not measured")?,
            None => writeln!(f, "  energy drift       left out: H reads the time")?,
        }
        writeln!(f, "  gradient error     {:.1e} (rounding explains {gradient_error:.1e})", self.gradient_error)?;
        match self.agreement {
            Some(Agreement { energies, derivatives, left_out }) => writeln!(
                f,
                "  own functions      {energies} energies and {derivatives} derivatives agree, {left_out} could not be compared"
            )?,
            None => writeln!(f, "  own functions      no agreement")?,
        }
        match self.stability {
            Some(stability) => write!(f, "  stability          {stability}"),
            None => write!(f, "  stability          not measured"),
        }
    }
}
