//! Shortfalls: the claims that a stepper does not meet.

use crate::{
    check::{
        certificate::{Certificate, Orders, SecondPart},
        error::CheckError,
        property::{agreement::Disagreement, energy::EnergyDrift, flow_laws::FlowLaw, invariants::InvariantDrift},
    },
    error::{Error, Misread, Number, debug_as_display},
};
use std::fmt;

debug_as_display!(CertifyError, Shortfall);

/// The reason why there is no certificate.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CertifyError {
    /// A run cannot begin with this start or this step.
    #[error(transparent)]
    Run(#[from] Error),
    /// The system has friction, so that its motion is not Hamiltonian.
    #[error(
        "certificates are for Hamiltonian motion, and this system has friction\nhelp: certify it without `#[friction]`"
    )]
    Friction,
    /// The stepper was measured and does not satisfy its claims.
    #[error("no certificate for {}:{}\nmeasured: {certificate}", certificate.system, Lines(shortfalls))]
    Refused {
        /// All measurements. A quantity that could not be measured is NaN.
        certificate: Box<Certificate>,
        /// The claims that are not satisfied, at least one.
        shortfalls: Vec<Shortfall>,
    },
}

/// A claim that a stepper does not satisfy.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Shortfall {
    /// The tangent map is not symplectic.
    #[error("symplectic defect {defect:.1e} exceeds the rounding tolerance {tolerance:.1e}")]
    Symplecticity {
        /// The defect of one step.
        defect: f64,
        /// The defect that rounding explains.
        tolerance: f64,
    },
    /// The method does not claim to be symplectic. A step that is accurate to the rounding leaves no defect to be
    /// measured.
    #[error(
        "{method} is not symplectic\nnote: a small defect shows that this step is accurate, and says nothing about \
         longer steps"
    )]
    NotSymplectic {
        /// The name of the method.
        method: &'static str,
    },
    /// The observed order is lower than the claimed one.
    #[error(
        "observed order {observed:.2} falls short of the claimed order {claimed}\nhelp: use a smaller step if the motion \
         is faster than these steps resolve\nnote: otherwise, the sequence has another order"
    )]
    Order {
        /// The slope.
        observed: f64,
        /// The order that the composition claims.
        claimed: u32,
    },
    /// `H` oscillates with the time that it reads, faster than the steps can follow.
    #[error(
        "half the period of the drive is {half:.1e}, but a step takes {}\nhelp: use a step below {half:.1e}\nnote: longer \
         steps meet the drive at any phase, so the run follows another motion",
        Number(*step)
    )]
    DriveNotResolved {
        /// Half the period.
        half: f64,
        /// The step of the certificate.
        step: f64,
    },
    /// The order was observed up to a time only.
    #[error("order {claimed} was observed only up to t = {}: beyond it, {}", Number(readable(*time)), Shrinking(*observed))]
    OrderLost {
        /// The time up to which the order was observed.
        time: f64,
        /// The power of the step with which errors scale after that time.
        observed: f64,
        /// The order that the composition claims.
        claimed: u32,
    },
    /// A composition that claims symmetry does not return to the start.
    #[error(
        "a run forward and back ends {distance:.1e} from its start, but a symmetric composition ends within \
         {tolerance:.1e}"
    )]
    Reversibility {
        /// The relative distance.
        distance: f64,
        /// The distance that rounding explains.
        tolerance: f64,
    },
    /// The energy error is so large that the run follows another orbit.
    #[error(
        "in {} steps of {}, the energy deviates by {:.2} of the largest kinetic energy (or that of the first part), and \
         in the mean by {:.2} of the mean one\nhelp: use a smaller step",
        .0.steps, Number(.0.step), Number(.0.deviation), Number(.0.mean_deviation / .0.mean_kinetic)
    )]
    EnergyLost(EnergyDrift),
    /// The energy has a trend.
    #[error(
        "the energy drifts: in {} steps of {}, it deviates by {:.1e} of the kinetic energy (or that of the first part), \
         with a trend of {:.1e}",
        .0.steps, Number(.0.step), .0.deviation, .0.drift()
    )]
    EnergyDrift(EnergyDrift),
    /// The energy error does not shrink with the step as the order predicts.
    #[error(
        "the energy deviates by {:.1e} of the kinetic energy (or that of the first part) in steps of {}, and by {:.1e} \
         in steps of {}, but order {order} explains a factor of about {}\nhelp: use a smaller step\nnote: the step is \
         too large for this motion, or the energy jumps",
        .drift.deviation, Number(.drift.step), .finer.deviation, Number(.finer.step), 1_u64 << (*order).min(63)
    )]
    EnergyNotExplained {
        /// The energy drift in the step of the certificate.
        drift: Box<EnergyDrift>,
        /// The energy drift in steps of half the length.
        finer: Box<EnergyDrift>,
        /// The order that the composition claims.
        order: u32,
    },
    /// An energy jumps along the orbit.
    #[error(
        "`{function}` jumps by {by:.1e} near t = {time}, at {state:?} (positions first)\nhelp: replace the jump by a \
         smooth transition, or choose an orbit that does not cross it\nnote: a jump has no force, so a step across it \
         does not conserve this energy",
        time = Number(*time)
    )]
    EnergyJumps {
        /// `kinetic`, `potential` or `hamiltonian`, or the name of a part of H.
        function: &'static str,
        /// The size of the jump.
        by: f64,
        /// The time, up to a few steps.
        time: f64,
        /// The state after the jump, positions first.
        state: Vec<f64>,
    },
    /// The second part of H is not small, and the composition claims its orders for a small one.
    #[error(
        "the second part of H is {:.1e} of the first or of both together, but the orders {} are claimed for a small \
         second part\nhelp: use a composition for any two parts, or split H so that its second part is small",
        .0.size, Orders(.0.orders)
    )]
    NotSmall(SecondPart),
    /// A flow does not belong to its energy.
    #[error(
        "gradient error {error:.1e} exceeds the rounding tolerance {tolerance:.1e}\nnote: the flows are not those of T \
         and V"
    )]
    Gradient {
        /// The relative error.
        error: f64,
        /// The error that rounding explains.
        tolerance: f64,
    },
    /// The flow of a part of H violates a law of flows, or does not belong to its energy.
    #[error(
        "the flow of `{part}` {law} (error {error:.1e}, tolerance {tolerance:.1e}, t = {time}, duration {duration:.1e})\nhelp: \
         check your own `#[flow]`; if there is none, please report this part as a bug",
        time = Number(*time)
    )]
    Flow {
        /// The name of the part, or of several parts if their energies are not known separately.
        part: String,
        /// The law that the flow violates.
        law: FlowLaw,
        /// The error of the flow.
        error: f64,
        /// The error that rounding explains, and the uncertainty of differences.
        tolerance: f64,
        /// The duration of the flow; for a derivative at zero, the time in which the state would change by its size.
        duration: f64,
        /// The time.
        time: f64,
        /// The state, positions first.
        state: Vec<f64>,
    },
    /// A function that is stated to be conserved is not.
    #[error(
        "`{}` is not conserved: its Poisson bracket with H is {:.1e} of the terms that should cancel\nhelp: check its \
         formula, and whether H has the symmetry\nnote: a function is conserved if and only if this bracket is zero",
        .0.name, .0.bracket
    )]
    NotInvariant(InvariantDrift),
    /// The generated code disagrees with a function of the user.
    #[error(transparent)]
    Misread(Misread),
    /// A derivative of the generated code is not that of the user's function: a derivative that is stated by
    /// `#[derivative]` is wrong, or the function was misread.
    #[error(
        "{} is {stated} by differences, but {generated} in the generated code (t = {time})\nhelp: check the derivatives \
         that `#[derivative]` states; if there are none, please report `{function}` as a bug\nnote: the tolerance is \
         {tolerance:.1e}",
        derivative(function, *order), stated = Number(*stated), generated = Number(*generated), time = Number(*time)
    )]
    Derivative {
        /// `kinetic`, `potential` or `hamiltonian`, or the name of a part of H.
        function: &'static str,
        /// 1 for a force or a velocity, compared with the function itself; 2 for the tangent of these, compared with
        /// them.
        order: u32,
        /// The derivative by differences.
        stated: f64,
        /// The derivative in the generated code.
        generated: f64,
        /// The uncertainty of the differences, and rounding.
        tolerance: f64,
        /// The time.
        time: f64,
        /// The state, positions first.
        state: Vec<f64>,
    },
    /// A check has no result.
    #[error("{check} could not be measured: {reason}")]
    Unmeasured {
        /// The name of the check.
        check: &'static str,
        /// The reason.
        reason: CheckError,
    },
}

/// The name of a derivative.
fn derivative(function: &str, order: u32) -> String {
    match (function, order) {
        ("kinetic", 1) => "the derivative of `kinetic`, a velocity,".to_owned(),
        ("kinetic", _) => "the derivative of the velocity, a second one of `kinetic`,".to_owned(),
        ("potential", 1) => "the derivative of `potential`, a force,".to_owned(),
        ("potential", _) => "the derivative of the force, a second one of `potential`,".to_owned(),
        (_, 1) => format!("a derivative of `{function}`, a force or a velocity,"),
        _ => format!("a derivative of a force or a velocity, a second one of `{function}`,"),
    }
}

/// Shortfalls, each on a line of its own. Checks that failed for the same reason share one.
struct Lines<'s>(&'s [Shortfall]);

impl fmt::Display for Lines<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut reported: Vec<String> = Vec::new();
        for shortfall in self.0 {
            let Shortfall::Unmeasured { reason, .. } = shortfall else {
                write!(f, "\n  {}", indented(shortfall))?;
                continue;
            };
            // Reasons that hold a NaN differ from themselves, but their texts do not.
            let reason = reason.to_string();
            if !reported.contains(&reason) {
                let same = |other: &&Shortfall| matches!(other, Shortfall::Unmeasured { reason: of, .. } if of.to_string() == reason);
                let checks: Vec<&str> = self.0.iter().filter(same).filter_map(Shortfall::check).collect();
                write!(f, "\n  {} could not be measured: {}", list(&checks), indented(&reason))?;
                reported.push(reason);
            }
        }
        Ok(())
    }
}

/// A message below a heading: its advice is indented further.
fn indented(message: &impl fmt::Display) -> String {
    message.to_string().replace('\n', "\n    ")
}

/// The exponent with which errors scale after the time up to which the order was observed.
struct Shrinking(f64);

impl fmt::Display for Shrinking {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(observed) = self;
        if observed.is_nan() {
            return f.write_str("runs of all step sizes diverge");
        }
        write!(
            f,
            "the error scales as h^{observed:.1}\nhelp: use a smaller step if the motion is much faster there\nnote: this \
             is typical of a kink, a jump or a cutoff of the potential"
        )
    }
}

/// A number with the digits that are worth reading.
fn readable(number: f64) -> f64 {
    format!("{number:.4e}").parse().unwrap_or(number)
}

/// Names, as they are read aloud.
fn list(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [name] => (*name).to_owned(),
        [names @ .., last] => format!("{} and {last}", names.join(", ")),
    }
}

impl Shortfall {
    pub(crate) fn of(disagreement: Disagreement) -> Self {
        match disagreement {
            Disagreement::Misread(misread) => Self::Misread(misread),
            Disagreement::Derivative { function, order, stated, generated, tolerance, time, state } => {
                Self::Derivative { function, order, stated, generated, tolerance, time, state }
            }
        }
    }

    /// Returns the name of the check that could not be measured, if any.
    fn check(&self) -> Option<&'static str> {
        match self {
            Self::Unmeasured { check, .. } => Some(check),
            _ => None,
        }
    }
}
