//! The claims of the notes, each with the number that decides it.

use crate::{measured::BRACKET, notes::Notes, study::Study};

/// A claim.
pub(crate) struct Claim {
    pub(crate) name: &'static str,
    /// What it says, and in which number.
    pub(crate) says: &'static str,
    /// Whether it is about an energy that is conserved, so that it says nothing of a Hamiltonian that reads the time.
    of_energy: bool,
    /// The number; none where it could not be measured.
    value: fn(&Study, &Notes) -> Option<f64>,
    /// Between these the claim holds.
    within: [f64; 2],
}

/// What became of a claim.
pub(crate) struct Verdict {
    pub(crate) name: &'static str,
    pub(crate) says: &'static str,
    pub(crate) value: f64,
    pub(crate) holds: bool,
}

/// A slope is off by a few hundredths where the next term of the error still shows, and a mistyped method by one.
const fn order(order: f64) -> [f64; 2] {
    [order - 0.15, order + 0.15]
}

/// An energy that has changed by less than a hundredth has not grown or decayed to speak of.
const CHANGED: f64 = 0.01;

/// The distance from a closed form: each step rounds a few times, and the oscillator adds these roundings up, at worst
/// in the same sense; in the closed form the roundings of `r` and of the angle are multiplied by the number of steps.
pub(crate) const CLOSED: f64 = crate::oscillator::STEPS as f64 * 16.0 * f64::EPSILON;

/// A thousand steps whose roundings differ in two orbits: as far apart as they were after a step, times a shear that
/// grows with the steps.
const SHIFTED: f64 = 1e6 * 8.0 * f64::EPSILON;

/// Areas are measured to the resolution of their outline.
const AREA: f64 = 1e-6;

/// The relative change of the energy after a period. Later, a system may have escaped.
fn energy_change(study: &Study, method: &str) -> Option<f64> {
    let (_, change) = study.method(method)?.energies.iter().take_while(|(periods, _)| *periods <= 1.0).last()?;
    Some(*change)
}

/// One row for each claim.
pub(crate) const CLAIMS: [Claim; 19] = [
    Claim {
        name: "forward_euler_energy_grows",
        says: "forward Euler gains energy: the relative change after a period",
        of_energy: true,
        value: |study, _| energy_change(study, "forward Euler"),
        within: [CHANGED, f64::INFINITY],
    },
    Claim {
        name: "backward_euler_energy_decays",
        says: "backward Euler loses energy: the relative change after a period",
        of_energy: true,
        value: |study, _| energy_change(study, "backward Euler"),
        within: [f64::NEG_INFINITY, -CHANGED],
    },
    Claim {
        name: "symplectic_methods_keep_the_energy",
        says: "the energy of symplectic methods oscillates and does not drift: Verlet's largest change in the second half over that in the first",
        of_energy: true,
        value: |study, _| {
            let energies = &study.method("Verlet")?.energies;
            let largest = |part: &[(f64, f64)]| part.iter().map(|(_, change)| change.abs()).fold(0.0, f64::max);
            let (first, second) = energies.split_at(energies.len() / 2);
            Some(largest(second) / largest(first))
        },
        within: [0.0, 1.5],
    },
    Claim {
        name: "symplectic_euler_bracket_is_one",
        says: "symplectic Euler preserves the Poisson bracket: {q₁, p₁} − 1 after a step",
        of_energy: false,
        value: |study, _| Some(study.method("symplectic Euler")?.bracket - 1.0),
        within: [-BRACKET, BRACKET],
    },
    Claim {
        name: "implicit_midpoint_bracket_is_one",
        says: "so does the implicit midpoint rule, without a splitting: {q₁, p₁} − 1 after a step",
        of_energy: false,
        value: |study, _| Some(study.method("implicit midpoint")?.bracket - 1.0),
        within: [-BRACKET, BRACKET],
    },
    Claim {
        name: "forward_euler_bracket_is_not_one",
        says: "forward Euler does not: |{q₁, p₁} − 1| after a step",
        of_energy: false,
        value: |study, _| Some((study.method("forward Euler")?.bracket - 1.0).abs()),
        // Off by h² T'' V'', where rounding would be a millionth of this.
        within: [1e6 * BRACKET, f64::INFINITY],
    },
    Claim {
        name: "brackets_tell_symplectic_methods",
        says: "methods that claim to be symplectic preserve it for every step, no other does: how many are on the wrong side",
        of_energy: false,
        value: |study, _| {
            let wrong = study.methods.iter().filter(|measured| measured.symplectic != measured.keeps_bracket());
            Some(wrong.count() as f64)
        },
        within: [0.0, 0.0],
    },
    Claim {
        name: "symplectic_methods_preserve_areas",
        says: "they preserve the area of a blob: the largest relative change",
        of_energy: false,
        value: |study, _| {
            let methods = study.methods.iter().filter(|measured| measured.keeps_bracket());
            methods.map(|measured| (measured.blob.area() - 1.0).abs()).reduce(f64::max)
        },
        within: [0.0, AREA],
    },
    Claim {
        name: "forward_euler_area_is_not_preserved",
        says: "forward Euler does not: the relative change",
        of_energy: false,
        value: |study, _| Some((study.method("forward Euler")?.blob.area() - 1.0).abs()),
        within: [CHANGED, f64::INFINITY],
    },
    Claim {
        name: "leapfrog_order_2",
        says: "the leapfrog with staggered momenta has order 2: the exponent",
        of_energy: false,
        value: |study, _| study.method("leapfrog")?.slope,
        within: order(2.0),
    },
    Claim {
        name: "verlet_order_2",
        says: "the error of Verlet falls with the square of the step: the exponent",
        of_energy: false,
        value: |study, _| study.method("Verlet")?.slope,
        within: order(2.0),
    },
    Claim {
        name: "midpoint_order_2",
        says: "the explicit midpoint rule has order 2: the exponent",
        of_energy: false,
        value: |study, _| study.method("explicit midpoint")?.slope,
        within: order(2.0),
    },
    Claim {
        name: "implicit_midpoint_order_2",
        says: "so has the implicit one: the exponent",
        of_energy: false,
        value: |study, _| study.method("implicit midpoint")?.slope,
        within: order(2.0),
    },
    Claim {
        name: "rk4_order_4",
        says: "the classical Runge–Kutta method has order 4: the exponent",
        of_energy: false,
        value: |study, _| study.method("Runge–Kutta 4")?.slope,
        within: order(4.0),
    },
    Claim {
        name: "abm4_order_4",
        says: "so has the predictor–corrector of Adams, Bashforth and Moulton: the exponent",
        of_energy: false,
        value: |study, _| study.method("Adams–Bashforth–Moulton 4")?.slope,
        within: order(4.0),
    },
    Claim {
        name: "yoshida4_order_4",
        says: "Yoshida's triple jump has order 4: the exponent",
        of_energy: false,
        value: |study, _| study.method("Yoshida 4")?.slope,
        within: order(4.0),
    },
    Claim {
        name: "oscillator_closed_forms",
        says: "on the oscillator every method ends where its diagonalised matrix says: the largest relative distance",
        of_energy: false,
        value: |_, notes| notes.closed_forms.iter().map(|(_, distance)| *distance).reduce(f64::max),
        within: [0.0, CLOSED],
    },
    Claim {
        name: "verlet_equals_shifted_leapfrog",
        says: "Verlet's inner half steps are the leapfrog, shifted by half a step: the largest relative distance",
        of_energy: false,
        value: |study, _| Some(study.shifted),
        within: [0.0, SHIFTED],
    },
    Claim {
        name: "pendulum_period",
        says: "the period of the pendulum is an elliptic integral: the least relative distance of Kahan–Li 8",
        of_energy: false,
        value: |_, notes| {
            let errors = &notes.periods.iter().find(|row| row.name == "Kahan–Li 8")?.errors;
            errors.iter().map(|(_, error)| *error).reduce(f64::min)
        },
        // Some hundreds of roundings, spread over four swings.
        within: [0.0, 1e-13],
    },
];

impl Claim {
    /// Holds the claim against what was measured.
    pub(crate) fn verdict(&self, study: &Study, notes: &Notes) -> Verdict {
        let value = (self.value)(study, notes).unwrap_or(f64::NAN);
        let holds = self.within[0] <= value && value <= self.within[1];
        Verdict { name: self.name, says: self.says, value, holds }
    }
}

impl Verdict {
    /// `ok`, or what it is instead.
    pub(crate) fn word(&self) -> &'static str {
        if self.holds { "ok" } else { "FAILED" }
    }
}

/// What became of all claims that say something of the system.
pub(crate) fn verdicts(study: &Study, notes: &Notes) -> Vec<Verdict> {
    let claims = CLAIMS.iter().filter(|claim| study.autonomous || !claim.of_energy);
    claims.map(|claim| claim.verdict(study, notes)).collect()
}
