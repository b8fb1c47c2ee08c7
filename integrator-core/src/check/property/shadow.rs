//! Conservation of Verlet's modified Hamiltonian (its shadow).
//!
//! In: a system with quadratic `T`, `Verlet` or `VelocityVerlet`, a start, a step. Out: the power of the step with
//! which the deviations of `H`, and of its modifications by the terms of order 2 and of order 2 and 4, shrink. Always
//! true: second and third derivatives of `V` are exact ones of the generated code; a stepper whose forces, stages or
//! clock are wrong conserves another quantity and shows a lower power, whatever else it conserves.

use crate::{
    check::{
        CheckError,
        oracle::compensated_steps::CompensatedSteps,
        property::{
            gradient::{Part, flow},
            order::{CLEARANCE, LADDER, NEEDED, POINTS, observed_order},
        },
        start::Start,
        statistics::{
            least_squares::fit_finest,
            path::PARTS,
            points::{origin, plain},
        },
    },
    composition::{
        Composition, Scheme,
        catalogue::{VelocityVerlet, Verlet},
    },
    hamiltonian::{QuadraticKinetic, Shaped},
    scalar::{
        dual::Dual,
        tolerance::{largest, length, within},
    },
    state::{coords::Coords, flat::shaped, phase::Phase, precision::Precision},
    system::motion::Motion,
};

/// A composition whose modified Hamiltonian is known to order 4, for quadratic `T`.
pub trait Shadowed: Scheme {
    /// The modified Hamiltonian.
    const TERMS: Terms;
}

/// The modified Hamiltonian `H + h²·H₂ + h⁴·H₄ + O(h⁶)` of a symmetric composition for `T = ½ pᵀ M⁻¹ p`, by its
/// coefficients. With the velocity `v = M⁻¹ p`, the gradient `g` of `V`, and indices contracted with `M⁻¹`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Terms {
    /// In `H₂`, those of `V″(v, v)` and `|g|²`.
    pub second: [f64; 2],
    /// In `H₄`, those of `V⁗(v, v, v, v)`, `V‴(v, v, g)`, `|V″v|²` and `V″(g, g)`.
    pub fourth: [f64; 4],
}

impl Shadowed for Verlet {
    const TERMS: Terms =
        Terms { second: [-1.0 / 24.0, 1.0 / 12.0], fourth: [7.0 / 5760.0, -1.0 / 80.0, -1.0 / 240.0, 1.0 / 60.0] };
}

impl Shadowed for VelocityVerlet {
    const TERMS: Terms =
        Terms { second: [1.0 / 12.0, -1.0 / 24.0], fourth: [-1.0 / 720.0, 1.0 / 120.0, 1.0 / 60.0, -1.0 / 240.0] };
}

/// The tolerance of a measured power. Powers are even, so that a smaller one is not mistaken for the next.
const POWER_TOLERANCE: f64 = 0.5;

/// The powers of the step with which the deviations of `H` and of its modifications shrink.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Shadow {
    /// The powers of `H`, `H + h²·H₂` and `H + h²·H₂ + h⁴·H₄`: 2, 4 and 6 for a right stepper.
    pub powers: [f64; 3],
    /// Their standard errors.
    pub uncertainties: [f64; 3],
    /// The time over which they were measured.
    pub span: f64,
}

impl Shadow {
    /// Whether each modification stays two orders better than what it modifies.
    pub fn is_conserved(&self) -> bool {
        self.powers.iter().zip([2.0, 4.0, 6.0]).all(|(power, exact)| *power >= exact - POWER_TOLERANCE)
    }
}

/// Measures the powers of the step with which the deviations of `H` and of the modified Hamiltonians shrink: the slopes
/// of the logarithm of the mean squared deviation from the start over the logarithm of the step.
///
/// Runs are compensated and go over the span of [`observed_order`], of which `h` is a first guess only; as there, a
/// slope is fitted to the finest steps whose deviation stands out of the rounding, four to six of them. Much of what is
/// wrong leaves a step symplectic and its energy bounded, such as a force that is a thousandth too strong; it does not
/// leave this.
///
/// # Errors
/// A Hamiltonian that reads the time, or whose parts are no `T(p)` and `V(q)`; a start or a step that no run would begin with; a start from which too few
/// deviations stand out of the rounding.
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
/// assert!(shadow.is_conserved());
/// # Ok::<(), integrator_core::check::CheckError>(())
/// ```
pub fn shadow<H: QuadraticKinetic, X: Composition<H> + Shadowed, K: Precision>(
    system: &H,
    composition: X,
    start: impl Into<Start<Shaped<H, K>>>,
    h: f64,
) -> Result<Shadow, CheckError> {
    if !H::AUTONOMOUS {
        return Err(CheckError::NotAutonomous);
    }
    if !H::SEPARABLE {
        return Err(CheckError::NotSeparable { what: "the shadow of Verlet" });
    }
    let _ = composition;
    let start = start.into();
    // How long the motion can be followed does not depend on the composition that is under suspicion.
    let span = observed_order::<H, Verlet, K>(system, Verlet, start.clone(), h)?.span;
    let start = plain::<H, K>(&start.phase).at_time(start.time);
    let parameters = system.parameters(start.phase.q.length());
    let mut points: [Vec<(f64, f64)>; 3] = Default::default();
    let mut drowned = [false; 3];
    for steps in LADDER.map(|steps| PARTS * steps) {
        let step = span / steps as f64;
        let Ok(Deviations { deviations, rounding }) = deviations::<H, X>(system, &parameters, &start, step, steps)
        else {
            continue;
        };
        for ((deviation, points), drowned) in deviations.iter().zip(&mut points).zip(&mut drowned) {
            *drowned |= within(*deviation, CLEARANCE * rounding);
            if !*drowned && deviation.is_finite() {
                points.push((step.abs().ln(), deviation.ln()));
            }
        }
    }
    let mut shadow = Shadow { powers: [f64::NAN; 3], uncertainties: [f64::NAN; 3], span };
    for (index, points) in points.iter().enumerate() {
        let Some((_, slope)) = fit_finest(points, NEEDED..=POINTS) else {
            let coarsest = (span / PARTS as f64).abs();
            return Err(CheckError::TooFewPoints { found: points.len(), needed: NEEDED, coarsest });
        };
        shadow.powers[index] = slope.value;
        shadow.uncertainties[index] = slope.uncertainty;
    }
    Ok(shadow)
}

/// Deviations of `H` and its modifications in a run.
struct Deviations {
    /// The roots of the mean squared deviations from the start.
    deviations: [f64; 3],
    /// A bound on the rounding errors of these, from the state and the sum of its energy.
    rounding: f64,
}

fn deviations<H: QuadraticKinetic, X: Composition<H> + Shadowed>(
    system: &H,
    parameters: &H::Parameters<f64>,
    start: &Start<H::Coords>,
    h: f64,
    steps: u64,
) -> Result<Deviations, CheckError> {
    let mut run = CompensatedSteps::new(system, X::default(), start.clone(), h)?;
    let at = |point: &Phase<H::Coords>| Point::<H> { parameters, point }.energies(&X::TERMS, h);
    let (first, mut terms) = at(&start.phase);
    let mut changes: [Vec<f64>; 3] = Default::default();
    for _ in 0..steps {
        let (energies, present) = at(&shaped(&start.phase, &run.advance(1)?));
        terms = largest([terms, present]);
        for (index, changes) in changes.iter_mut().enumerate() {
            changes.push(energies[index] - first[index]);
        }
    }
    let count = (steps as f64).sqrt();
    // Each of the coordinates is rounded, and each of the terms of the energies, to half an ε of the largest at most.
    let rounding = (4.0 * start.phase.q.flat().len() as f64).sqrt() * f64::EPSILON * terms;
    Ok(Deviations { deviations: changes.map(|changes| length(changes) / count), rounding })
}

/// Derivatives of `V` at a point.
struct Point<'p, H: QuadraticKinetic> {
    parameters: &'p H::Parameters<f64>,
    point: &'p Phase<H::Coords>,
}

impl<H: QuadraticKinetic> Point<'_, H> {
    /// `H` and its modifications for a step `h`, and the size of the terms of `H`.
    fn energies(&self, terms: &Terms, h: f64) -> ([f64; 3], f64) {
        let motion = H::Motion::<f64, f64>::load(&[self.parameters], &[self.point]);
        let (kinetic, potential) = (H::kinetic::<f64, f64>(&motion, 0.0), H::potential::<f64, f64>(&motion, 0.0));
        let energy = kinetic + potential;
        let still = origin(self.point);
        let at_rest = Phase { q: self.point.q.clone(), p: still.p.clone() };
        let gradient = flow::<H, f64>(self.parameters, Part::Potential, [&at_rest, &still], 0.0, 0);
        let v = self.velocity(self.point.p.flat());
        let g = self.velocity(&gradient);
        let bent = self.hessian(&v);
        let second = [dot(&v, &bent), dot(&g, &gradient)];
        let fourth = [
            self.fourth_derivative(&v),
            dot(&v, &self.third_derivative(&g, &v, 0.0)),
            dot(&bent, &self.velocity(&bent)),
            dot(&g, &self.hessian(&g)),
        ];
        let second = energy + h.powi(2) * dot(&terms.second, &second);
        ([energy, second, second + h.powi(4) * dot(&terms.fourth, &fourth)], kinetic.abs() + potential.abs())
    }

    /// `M⁻¹` times `momenta`: what a drift of unit duration adds to positions of zero.
    fn velocity(&self, momenta: &[f64]) -> Vec<f64> {
        let mut point = origin(self.point);
        point.p.flat_mut().copy_from_slice(momenta);
        flow::<H, f64>(self.parameters, Part::Kinetic, [&point, &point], 0.0, 0)
    }

    /// The second derivative of `V` along `direction`.
    fn hessian(&self, direction: &[f64]) -> Vec<f64> {
        let mut point = self.point.clone();
        point.p.flat_mut().copy_from_slice(direction);
        let mut motion = H::Motion::<f64, f64>::load(&[self.parameters], &[&point]);
        H::hessian::<f64>(&mut motion, 0.0);
        motion.store(0, &mut point);
        point.p.flat().to_vec()
    }

    /// The third derivative of `V` along `one` and `other`, by duals through the generated Hessian, at this point moved
    /// by `offset` along `other`.
    fn third_derivative(&self, one: &[f64], other: &[f64], offset: f64) -> Vec<f64> {
        let (mut point, mut tangent) = (self.point.clone(), origin(self.point));
        for (q, direction) in point.q.flat_mut().iter_mut().zip(other) {
            *q += offset * direction;
        }
        point.p.flat_mut().copy_from_slice(other);
        tangent.q.flat_mut().copy_from_slice(one);
        let mut motion = H::Motion::<Dual, f64>::load(&[self.parameters; 2], &[&point, &tangent]);
        H::hessian::<Dual>(&mut motion, 0.0);
        motion.store(1, &mut tangent);
        tangent.p.flat().to_vec()
    }

    /// The fourth derivative of `V` along `direction`, four times: a difference of exact third ones, whose errors of
    /// order 2 cancel between two widths. It enters with h⁴, so that the root of ε is more than it needs.
    fn fourth_derivative(&self, direction: &[f64]) -> f64 {
        let lengths = [self.point.q.flat(), direction].map(|numbers| length(numbers.iter().copied()));
        let scale = if lengths[0] > 0.0 && lengths[1] > 0.0 { lengths[0] / lengths[1] } else { 1.0 };
        let width = f64::EPSILON.powf(0.2) * scale;
        let third = |offset| dot(direction, &self.third_derivative(direction, direction, offset));
        let [narrow, wide] = [width, 2.0 * width].map(|width| (third(width) - third(-width)) / (2.0 * width));
        (4.0 * narrow - wide) / 3.0
    }
}

/// The scalar product.
fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}
