//! Conservation of the modified Hamiltonian (the shadow) of a composition.
//!
//! In: a system `T(p) + V(q)`, a composition, a start, a step. Out: the powers of the step with which the deviations of
//! `H` and of the modified Hamiltonians decrease. Always true: the modified Hamiltonians come from the table of the
//! composition and from derivatives of the generated flows. A stepper with wrong forces, stages or times conserves
//! another quantity and shows a lower power.

use crate::{
    check::{
        CheckError, ModifiedHamiltonian,
        modified::OfFlat,
        oracle::compensated_steps::CompensatedSteps,
        property::order::{CLEARANCE, LADDER, NEEDED, POINTS, observed_order},
        start::IntoStart,
        statistics::{
            least_squares::fit_finest,
            path::PARTS,
            points::{flat_start, plain},
        },
    },
    composition::{Composition, catalogue::Verlet},
    error::Error,
    hamiltonian::Hamiltonian,
    scalar::tolerance::{largest, length, within},
    state::{flat::Flat, precision::Precision},
    system::Shaped,
};
use std::fmt;

/// The tolerance of a measured power. Powers are whole, so that a smaller one is not mistaken for the next.
const POWER_TOLERANCE: f64 = 0.5;

/// The number of samples of a run.
const LOOKS: u64 = 2 * PARTS;

/// The power of the step with which an energy deviation decreases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShadowPower {
    /// The power for a correct stepper.
    pub exact: i32,
    /// The measured power; infinite if the deviation is below the rounding for every step size.
    pub measured: f64,
    /// The standard error of the measured power.
    pub uncertainty: f64,
}

/// The powers of the step with which the deviations of `H` and of the modified Hamiltonians decrease.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Shadow {
    /// The name of the composition.
    pub composition: &'static str,
    /// The powers for `H`, then for the modified Hamiltonians with one more term each. The exact powers of Verlet are
    /// 2, 4 and 6.
    pub powers: Vec<ShadowPower>,
    /// The time over which the powers were measured.
    pub span: f64,
}

impl Shadow {
    /// Whether each modified Hamiltonian is conserved better than the previous one, by the expected powers of the step.
    pub fn is_conserved(&self) -> bool {
        self.powers.iter().all(|power| power.measured >= f64::from(power.exact) - POWER_TOLERANCE)
    }
}

/// One line for each modification.
impl fmt::Display for Shadow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let verdict = if self.is_conserved() { "is conserved" } else { "IS NOT CONSERVED" };
        writeln!(f, "the modified Hamiltonian of {} {verdict}, over a time of {:.1e}", self.composition, self.span)?;
        for (index, ShadowPower { exact, measured, uncertainty }) in self.powers.iter().enumerate() {
            let what = match index {
                0 => "H".to_owned(),
                _ => format!("H with the terms below h^{exact}"),
            };
            if measured.is_infinite() {
                writeln!(f, "  {what} is conserved to the rounding (expected {exact})")?;
                continue;
            }
            writeln!(f, "  {what} deviates by h^{measured:.2} +- {uncertainty:.2} (expected {exact})")?;
        }
        Ok(())
    }
}

/// Measures how the energy deviations of `H` and of the modified Hamiltonians decrease with the step.
///
/// The powers are slopes of the logarithm of the mean squared deviation from the start over the logarithm of the step.
/// Runs are compensated and extend over the span of [`observed_order`], which takes `h` as a first guess only. As
/// there, a slope is fitted to the finest four to six steps with deviations above the rounding.
///
/// Many mistakes leave a step symplectic and its energy bounded, such as a force that is too strong by a thousandth.
/// They are found here. The modified Hamiltonians are those of [`ModifiedHamiltonian`]: three powers for Verlet, two
/// for a composition of order 4, and one for higher orders.
///
/// # Errors
/// - The Hamiltonian depends on time, or its parts are not `T(p)` and `V(q)`.
/// - The start or the step is invalid for a run.
/// - Too few deviations are above the rounding.
/// - An energy has no fifth derivatives, as for functions with user-supplied derivatives.
///
/// ```
/// use integrator_core::{check::shadow, prelude::*};
///
/// struct Pendulum;
///
/// #[hamiltonian]
/// impl Pendulum {
///     fn kinetic(&self, p: [f64; 1]) -> f64 {
///         0.5 * p[0] * p[0]
///     }
///     fn potential(&self, q: [f64; 1]) -> f64 {
///         -q[0].cos()
///     }
/// }
///
/// let shadow = shadow(&Pendulum, Verlet, Phase::new([1.0_f64], [0.5]), 0.1)?;
/// println!("{shadow}");
/// assert!(shadow.is_conserved());
/// # Ok::<(), integrator_core::check::CheckError>(())
/// ```
pub fn shadow<H: Hamiltonian, X: Composition<H>, K: Precision>(
    system: &H,
    composition: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
) -> Result<Shadow, CheckError> {
    let start = start.into_start();
    let values = plain::<H, K>(&start.phase).at_time(start.time);
    let modified = ModifiedHamiltonian::new(system, composition, &values.phase, h)?.into_flat();
    // How long the motion can be followed does not depend on the composition that is under suspicion.
    let span = observed_order::<H, Verlet, K>(system, Verlet, start, h)?.span;
    let run = |step: f64, stride: u64| {
        let mut run = CompensatedSteps::new(system, composition, values.clone(), step)?;
        (0..LOOKS).map(|_| run.advance(stride)).collect()
    };
    measure(&run, &modified, &flat_start(&values).phase, span)
}

/// The states of a run with a step, read at an interval of steps.
type Looks<'r> = dyn Fn(f64, u64) -> Result<Vec<Flat>, Error> + 'r;

fn measure(run: &Looks<'_>, modified: &OfFlat<'_>, start: &Flat, span: f64) -> Result<Shadow, CheckError> {
    let count = modified.series.powers().len() + 1;
    let mut points = vec![Vec::new(); count];
    let mut drowned = vec![false; count];
    for stride in LADDER {
        let step = span / (LOOKS * stride) as f64;
        // A step too coarse to stay finite is no reason to give up the finer ones.
        let Ok(states) = run(step, stride) else { continue };
        let Deviations { deviations, rounding } = deviations(modified, start, &states, step);
        if deviations.iter().any(|deviation| deviation.is_nan()) {
            return Err(CheckError::NotFinite { what: "the modified Hamiltonian" });
        }
        for ((deviation, points), drowned) in deviations.iter().zip(&mut points).zip(&mut drowned) {
            *drowned |= within(*deviation, CLEARANCE * rounding);
            if !*drowned && deviation.is_finite() {
                points.push((step.abs().ln(), deviation.ln()));
            }
        }
        if drowned.iter().all(|drowned| *drowned) {
            break;
        }
    }
    let mut powers = Vec::with_capacity(count);
    for (index, points) in points.iter().enumerate() {
        let exact = modified.series.off_by(index);
        // A series may end: the first term of the order 1 is the last one but for a factor on an oscillator.
        if index > 0 && points.is_empty() && drowned[index] {
            powers.push(ShadowPower { exact, measured: f64::INFINITY, uncertainty: 0.0 });
            continue;
        }
        let Some((_, slope)) = fit_finest(points, NEEDED..=POINTS) else {
            let coarsest = (span / LOOKS as f64).abs();
            return Err(CheckError::TooFewPoints { found: points.len(), needed: NEEDED, coarsest });
        };
        powers.push(ShadowPower { exact, measured: slope.value, uncertainty: slope.uncertainty });
    }
    Ok(Shadow { composition: modified.series.composition, powers, span })
}

/// Deviations of `H` and its modifications in a run.
struct Deviations {
    /// The roots of the mean squared deviations from the start.
    deviations: Vec<f64>,
    /// A bound on the rounding errors of these, from the state and the sum of its energy.
    rounding: f64,
}

fn deviations(modified: &OfFlat<'_>, start: &Flat, states: &[Flat], h: f64) -> Deviations {
    let (first, mut terms) = modified.energies(start, h);
    let mut changes = vec![Vec::with_capacity(states.len()); first.len()];
    for state in states {
        let (energies, present) = modified.energies(state, h);
        terms = largest([terms, present]);
        for ((changes, energy), first) in changes.iter_mut().zip(&energies).zip(&first) {
            changes.push(energy - first);
        }
    }
    let count = (states.len() as f64).sqrt();
    // Each of the coordinates is rounded, and each of the terms of the energies, to half an ε of the largest at most.
    let rounding = (4.0 * start.q.len() as f64).sqrt() * f64::EPSILON * terms;
    Deviations { deviations: changes.into_iter().map(|changes| length(changes) / count).collect(), rounding }
}
