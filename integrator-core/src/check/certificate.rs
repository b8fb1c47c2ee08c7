//! Certificates: the measurements as data and as a printed report.

use crate::{
    check::property::{
        agreement::Agreement, energy::EnergyDrift, flow_laws::FlowErrors, invariants::InvariantDrift, order::Order,
        stability::Stability,
    },
    error::Number,
};
use std::fmt;

/// The measurements of one composition for one system, start and step.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Certificate {
    /// The type of the system.
    pub system: &'static str,
    /// The name of the composition.
    pub composition: &'static str,
    /// The step.
    pub step: f64,
    /// The time at the start.
    pub time: f64,
    /// The declared order of the composition.
    pub claimed_order: u32,
    /// Whether the composition is declared symmetric.
    pub symmetric: bool,
    /// Whether the Hamiltonian is independent of time. Energy is conserved only then.
    pub autonomous: bool,
    /// The symplectic defect of one step: [`symplectic_defect`](crate::check::symplectic_defect).
    pub symplectic_defect: f64,
    /// The slope of [`observed_order`](crate::check::observed_order); NaN if it could not be measured.
    pub observed_order: f64,
    /// The step sizes and the standard error of that slope.
    pub order: Option<Order>,
    /// The time along the orbit up to which the order was observed; NaN if it could not be measured.
    pub order_until: f64,
    /// The distance from the start after a run forward and back.
    ///
    /// It is [`reversibility`](crate::check::reversibility()) over the span of [`Certificate::order`], in the coarsest
    /// steps of that fit, or in [`Certificate::step`] if that is longer.
    pub reversibility: f64,
    /// The [`energy_drift`](crate::check::energy_drift) over 8192 steps; `None` for a time-dependent Hamiltonian.
    ///
    /// The steps are longer if 8192 steps are too short to distinguish a trend from part of an oscillation.
    pub energy_drift: Option<EnergyDrift>,
    /// The energy drift over the same time in steps of half the length; `None` if rounding explains the deviation.
    pub finer_energy_drift: Option<EnergyDrift>,
    /// The largest [`gradient_error`](crate::check::gradient_error) along the orbit. NaN if the parts are not `T(p)`
    /// and `V(q)`; [`Certificate::flows`] has the errors then.
    pub gradient_error: f64,
    /// The errors of the flows of parts for one step, at the start and along the orbit; `None` if the parts are `T(p)`
    /// and `V(q)`.
    pub flows: Option<FlowErrors>,
    /// The number of comparisons between the generated code and the user's functions, at the start and along the orbit.
    ///
    /// `None` if one of them disagrees, or if no comparison was possible.
    pub agreement: Option<Agreement>,
    /// The relative size of the second part of `H`. It is measured if the composition claims
    /// [`GENERALISED_ORDERS`](crate::Scheme::GENERALISED_ORDERS) and both parts move the same coordinates.
    pub second_part: Option<SecondPart>,
    /// The measurements of each `#[invariant]`.
    pub invariants: Vec<InvariantDrift>,
    /// The phase advance in relation to the stability limit of the composition. It causes a warning at most, never a
    /// failed certification.
    pub stability: Option<Stability>,
    /// The tolerances: the errors that rounding explains.
    pub tolerances: Tolerances,
}

/// The errors that rounding explains.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Tolerances {
    /// The tolerance of [`Certificate::symplectic_defect`].
    pub symplectic_defect: f64,
    /// The tolerance of [`Certificate::reversibility`].
    pub reversibility: f64,
    /// The tolerance of [`Certificate::gradient_error`].
    pub gradient_error: f64,
}

/// The size of the second part of `H`, and the orders that are claimed if it is small.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SecondPart {
    /// The root mean square of the derivatives of the second part along the orbit, relative to the first part or to
    /// both together, whichever is smaller.
    ///
    /// Each derivative is measured in units of the derivatives of both parts by its coordinate.
    pub size: f64,
    /// The powers of the step that multiply the first, second, ... power of the second part in the error.
    pub orders: &'static [u32],
}

/// Generalised orders as `(10, 6, 4)`.
pub(crate) struct Orders(pub(crate) &'static [u32]);

impl fmt::Display for Orders {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let orders: Vec<String> = self.0.iter().map(u32::to_string).collect();
        write!(f, "({})", orders.join(", "))
    }
}

/// One line for each measurement that could be made.
impl fmt::Display for Certificate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} on {}, h = {}", self.composition, self.system, Number(self.step))?;
        if self.time != 0.0 {
            write!(f, ", from t = {}", Number(self.time))?;
        }
        let Tolerances { symplectic_defect, reversibility, gradient_error } = self.tolerances;
        let line = |f: &mut fmt::Formatter<'_>, name, number: f64, rest: String| match number.is_nan() {
            true => Ok(()),
            false => write!(f, "\n  {name:<18} {number:.1e} {rest}"),
        };
        let explained = |tolerance: f64| format!("(rounding tolerance {tolerance:.1e})");
        line(f, "symplectic defect", self.symplectic_defect, explained(symplectic_defect))?;
        if let Some(order) = &self.order {
            self.write_order(order, f)?;
        }
        let returned =
            if self.symmetric { explained(reversibility) } else { "(the composition is not symmetric)".to_owned() };
        line(f, "reversibility", self.reversibility, returned)?;
        match &self.energy_drift {
            Some(drift) => self.write_energy(drift, f)?,
            None if self.autonomous => {}
            None => write!(f, "\n  energy drift       not measured: H depends on time")?,
        }
        line(f, "gradient error", self.gradient_error, explained(gradient_error))?;
        if let Some(flows) = &self.flows {
            let FlowErrors { symplecticity, inverse, addition, energy, generator } = flows;
            write!(f, "\n  flows of the parts symplectic {symplecticity:.0e}, inverse {inverse:.0e}, ")?;
            write!(f, "sum {addition:.0e}, energy {energy:.0e}, derivative {generator:.0e} in units of the rounding")?;
        }
        if let Some(Agreement { energies, derivatives, left_out }) = self.agreement {
            write!(f, "\n  own functions      {energies} energies and {derivatives} derivatives agree, ")?;
            write!(f, "{left_out} could not be compared")?;
        }
        if let Some(SecondPart { size, orders }) = self.second_part {
            let orders = Orders(orders);
            write!(f, "\n  second part        {size:.1e} of the first or of both (orders {orders} if it is small)")?;
        }
        for invariant in &self.invariants {
            write!(f, "\n  invariant          {invariant}")?;
        }
        self.stability.iter().try_for_each(|stability| write!(f, "\n  stability          {stability}"))
    }
}

impl Certificate {
    fn write_order(&self, order: &Order, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Order { slope, points, finest, coarsest, span, .. } = order;
        write!(f, "\n  observed order     {:.2} (claimed {}", Number(*slope), self.claimed_order)?;
        write!(f, "; {points} steps from {finest:.1e} to {coarsest:.1e} over a time of {span:.1e}")?;
        if !self.order_until.is_nan() {
            write!(f, "; observed up to t = {:.1e}", self.order_until)?;
        }
        write!(f, ")")
    }

    fn write_energy(&self, drift: &EnergyDrift, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let EnergyDrift { deviation, course, slope, uncertainty, step, steps, .. } = drift;
        write!(f, "\n  energy drift       {course}: at most {deviation:.1e} in {steps} steps of {step:.1e}")?;
        if let Some(EnergyDrift { deviation, .. }) = self.finer_energy_drift {
            write!(f, ", {deviation:.1e} with half the step")?;
        }
        write!(f, "; slope {slope:.1e} +- {uncertainty:.1e} per unit time")
    }
}
