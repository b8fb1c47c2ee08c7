//! Close encounters and extreme numbers: the result is correct, or the user gets an error or a warning.

use integrator_bench::problems::Kepler;
use integrator_core::{
    Coords,
    check::{CertifyError, certify, stability},
    prelude::*,
};
use std::fmt;

/// Bodies in the plane with mutual gravity.
struct ThreeBodies {
    masses: [f64; 3],
}

#[hamiltonian]
impl ThreeBodies {
    fn kinetic(&self, p: [[f64; 2]; 3]) -> f64 {
        let mut energy = 0.0;
        for i in 0..3 {
            energy += (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * self.masses[i]);
        }
        energy
    }
    fn potential(&self, q: [[f64; 2]; 3]) -> f64 {
        let mut energy = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let [x, y] = [q[i][0] - q[j][0], q[i][1] - q[j][1]];
                energy -= self.masses[i] * self.masses[j] / (x * x + y * y).sqrt();
            }
        }
        energy
    }
}

struct Spring;

#[hamiltonian]
impl Spring {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0] * q[0]
    }
}

/// Result of a run.
pub(crate) enum Outcome {
    /// The energy is conserved up to this relative error.
    Right(f64),
    /// The run, a certificate or the stability check reports the problem.
    Told(String),
    /// The energy has this relative error, and the user gets no report.
    Silent(f64),
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Right(share) => write!(f, "right: the energy stays within {share:.0e}"),
            Self::Told(reason) => write!(f, "told: {reason}"),
            Self::Silent(share) => write!(f, "WRONG: the energy is off by {share:.0e}, and nothing says so"),
        }
    }
}

/// An orbit and its result.
pub(crate) struct Encounter {
    pub(crate) name: String,
    pub(crate) outcome: Outcome,
}

impl Encounter {
    pub(crate) fn is_silently_wrong(&self) -> bool {
        matches!(self.outcome, Outcome::Silent(_))
    }
    pub(crate) fn is_right(&self) -> bool {
        matches!(self.outcome, Outcome::Right(_))
    }
}

impl fmt::Display for Encounter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.name, self.outcome)
    }
}

/// Orbits that the step resolves; their results have to be correct.
pub(crate) fn resolved(steps: u64) -> Vec<Encounter> {
    let mut resolved = Vec::new();
    for eccentricity in [0.9, 0.99, 0.999] {
        resolved.push(follow(
            &format!("Kepler, e = {eccentricity}"),
            &Kepler,
            pericentre(eccentricity),
            0.02 * f64::powf(1.0 - eccentricity, 1.5),
            steps,
            // Rounding of the kinetic energy at the pericentre (at most 4e3 of the total), accumulated as a random
            // walk.
            1e-9,
        ));
    }
    resolved.push(follow("three bodies before they meet", &PYTHAGOREAN, at_rest(), 1.8 / steps as f64, steps, 1e-9));
    let single = |numbers: [f64; 2]| numbers.map(|number| number as f32);
    let Phase { q, p } = pericentre(0.9);
    // `f32` rounds 2^29 times as coarsely as `f64`.
    resolved.push(follow("Kepler, e = 0.9, in f32", &Kepler, Phase::new(single(q), single(p)), 1e-3, steps, 1e-2));
    for scale in [1e-100, 1e-60, 1e60, 1e100] {
        resolved.push(in_units(scale, steps));
    }
    resolved.push(denormal(steps));
    resolved
}

/// Orbits that these steps do not resolve: collisions, close encounters of three bodies, and units beyond the range of
/// `f64`.
pub(crate) fn unresolved(steps: u64, colliding: &[f64], meeting: &[f64]) -> Vec<Encounter> {
    let mut unresolved = Vec::new();
    for &h in colliding {
        let fall = Phase::new([1.0, 0.0], [0.0, 0.0]);
        unresolved.push(follow(&format!("head-on collision, h = {h}"), &Kepler, fall, h, steps, 1e-9));
    }
    for &h in meeting {
        unresolved.push(follow(&format!("three bodies meet, h = {h}"), &PYTHAGOREAN, at_rest(), h, steps, 1e-9));
    }
    for scale in [1e-300, 1e-150, 1e150, 1e300] {
        unresolved.push(in_units(scale, steps));
    }
    unresolved
}

/// Three bodies at rest at the corners of a triangle with sides 3, 4 and 5 (Burrau 1913).
const PYTHAGOREAN: ThreeBodies = ThreeBodies { masses: [3.0, 4.0, 5.0] };

fn at_rest() -> Phase<[[f64; 2]; 3]> {
    Phase::new([[1.0, 3.0], [-2.0, -1.0], [1.0, -1.0]], [[0.0; 2]; 3])
}

/// The pericentre of an orbit with semi-major axis 1.
fn pericentre(eccentricity: f64) -> Phase<[f64; 2]> {
    let momentum = ((1.0 + eccentricity) / (1.0 - eccentricity)).sqrt();
    Phase::new([1.0 - eccentricity, 0.0], [0.0, momentum])
}

/// A nearly circular orbit of radius `scale`; its square or cube may overflow or underflow.
fn in_units(scale: f64, steps: u64) -> Encounter {
    let start = Phase::new([scale, 0.0], [0.0, 1.1 / scale.sqrt()]);
    follow(&format!("Kepler in units of {scale:e}"), &Kepler, start, 0.02 * scale * scale.sqrt(), steps, 1e-9)
}

/// Integrates an orbit with a composition of order 8. An energy error up to `tolerance` is correct.
fn follow<H, C>(name: &str, system: &H, start: Phase<C>, h: f64, steps: u64, tolerance: f64) -> Encounter
where
    H: Hamiltonian,
    H::Coords: Coords<With<C::Leaf> = C>,
    C: Coords,
{
    const LOOKS: u64 = 64;
    let astray = || -> Result<f64, Error> {
        let mut run = system.run_with::<C::Leaf, _>(KahanLi8, start.clone(), h)?;
        let begin = run.energy();
        let mut farthest = 0.0;
        for _ in 0..LOOKS {
            run.advance(steps / LOOKS)?;
            let share = ((run.energy() - begin) / begin).abs();
            if share.is_nan() || share > farthest {
                farthest = share;
            }
        }
        Ok(farthest)
    };
    let outcome = match astray() {
        Err(error) => Outcome::Told(error.to_string()),
        Ok(share) if share <= tolerance => Outcome::Right(share),
        Ok(share) => match stability::<H, _, C::Leaf>(system, KahanLi8, &start, h) {
            Ok(stability) if !stability.is_near() => match certify::<H, _, C::Leaf>(system, KahanLi8, start.clone(), h)
            {
                Ok(_) => Outcome::Silent(share),
                Err(CertifyError::Refused { shortfalls, .. }) => {
                    Outcome::Told(shortfalls.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))
                }
                Err(error) => Outcome::Told(error.to_string()),
            },
            Ok(stability) => Outcome::Told(stability.to_string()),
            Err(error) => Outcome::Told(error.to_string()),
        },
    };
    Encounter { name: name.to_owned(), outcome }
}

/// An oscillation in subnormal numbers; its energy underflows. The amplitude has to be conserved up to the spacing of
/// these numbers per step.
fn denormal(steps: u64) -> Encounter {
    let amplitude = 1e-310_f64;
    let farthest = || -> Result<f64, Error> {
        let mut run = Spring.run_with(KahanLi8, Phase::new([amplitude], [0.0]), 0.1)?;
        let mut farthest = 0.0_f64;
        for _ in 0..steps {
            run.advance(1)?;
            farthest = farthest.max(run.state().q[0].abs() / amplitude - 1.0);
        }
        Ok(farthest)
    };
    let outcome = match farthest() {
        Ok(share) if share < 1e-6 => Outcome::Right(share),
        Ok(share) => Outcome::Silent(share),
        Err(error) => Outcome::Told(error.to_string()),
    };
    Encounter { name: "an oscillation of denormals".to_owned(), outcome }
}
