//! The claims of the course, each with the number that decides it.

use crate::{
    measured::{BRACKET, Measured},
    modified::Modified,
    numbers::plain,
    portrait::SEEN,
    problem::steps_per_period,
    study::Study,
    tangents::Deviation,
};

/// A claim and its measured result.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// An identifier for programs: letters, digits and underscores.
    pub name: String,
    /// The claim in words, including the measured quantity.
    pub says: String,
    /// The interval in which the claim holds.
    pub within: [f64; 2],
    /// The measured number; NaN if it could not be measured.
    pub measured: f64,
    /// The name of the picture that shows it; empty if none does.
    pub picture: String,
    /// The unit of the numbers, such as `K`; empty for a number without one.
    pub unit: &'static str,
    /// What it may mean that the claim fails, and what to try.
    pub meaning: &'static str,
}

impl Verdict {
    /// Creates a claim that holds if the number lies in the interval, whose ends may be infinite.
    pub fn new(name: impl Into<String>, says: impl Into<String>, within: [f64; 2], measured: Option<f64>) -> Self {
        Self {
            name: name.into(),
            says: says.into(),
            within,
            measured: measured.unwrap_or(f64::NAN),
            picture: String::new(),
            unit: "",
            meaning: "",
        }
    }

    /// Names the picture that shows the claim, as in [`Laboratory::picture`](crate::Laboratory::picture).
    #[must_use]
    pub fn shown_in(self, picture: impl Into<String>) -> Self {
        Self { picture: picture.into(), ..self }
    }

    /// States what it may mean that the claim fails, and what to try.
    #[must_use]
    pub fn meaning(self, meaning: &'static str) -> Self {
        Self { meaning, ..self }
    }

    /// Returns what it may mean that the claim fails, and what to try.
    pub(crate) fn advice(&self) -> &'static str {
        if self.measured.is_nan() {
            "Nothing could be measured: a method did not come to an end. Try a shorter step."
        } else if self.meaning.is_empty() {
            "Try half the step; if the number stays, the method or the claim is wrong."
        } else {
            self.meaning
        }
    }

    /// Returns the measured number, for readers.
    pub(crate) fn found(&self) -> String {
        in_unit(plain(self.measured), self.unit)
    }

    /// Whether the claim holds.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.within[0] <= self.measured && self.measured <= self.within[1]
    }

    /// Returns `ok` or `FAILED`.
    #[must_use]
    pub fn word(&self) -> &'static str {
        if self.holds() { "ok" } else { "FAILED" }
    }

    /// Returns the expected number, for readers.
    #[must_use]
    pub fn expected(&self) -> String {
        let range = match self.within {
            [least, most] if least == most => format!("exactly {}", plain(least)),
            [least, most] if least == -most => format!("0, to {}", plain(most)),
            [least, f64::INFINITY] => format!("at least {}", plain(least)),
            [f64::NEG_INFINITY, most] => format!("at most {}", plain(most)),
            [0.0, most] => format!("at most {}", plain(most)),
            [least, most] => format!("between {} and {}", plain(least), plain(most)),
        };
        in_unit(range, self.unit)
    }
}

fn in_unit(number: String, unit: &str) -> String {
    if unit.is_empty() { number } else { format!("{number} {unit}") }
}

/// What it may mean that a claim fails, and what to try.
const CONVEX: &str = "The potential may be concave along the orbit, so that this is not a property of the method here; or the orbit has left \
     within a period: try half the step.";
const SYMPLECTIC: &str =
    "A symplectic method has no such error at any step: the method or the derivative of a flow has a defect.";
const SOLVED: &str = "An implicit step may be too long for its equation to be solved to rounding: try half the step. Otherwise a method \
     claims to be symplectic and is not, which is a defect.";
const STRAIGHT: &str = "The motion may be nearly that of a free particle, or the step so short that the effect is small: try a longer step.";
const OUTLINE: &str = "The set of initial states may be so large that its outline is folded: try a smaller one. Otherwise the method has a defect.";
const CHAOS: &str =
    "Rounding grows along a chaotic or escaping orbit: try a shorter period. Otherwise the method has a defect.";
const ORDER: &str = "The step may be too long for the first term of the error, or the force not smooth (a kink, a jump, a cutoff): try half the \
     step. If the exponent stays, the method has a defect.";
const SAME: &str = "Both are the same map, so that only rounding may differ: along a chaotic orbit it grows; otherwise one of the two has a defect.";
const TOLERANCE: &str = "The orbit may pass a kink or a jump of the force, which a tolerance does not resolve; or the reference is no better: try a \
     shorter period.";
const DRIFT: &str = "The step may resonate with the motion or be near the limit of stability, or the orbit is chaotic: try a step shorter by a \
     tenth, then half of it. If the error still grows, the method has a defect.";
const KEEPS: &str = "The longest step of the portraits may be too short for a method of this order, or the method conserves this energy: no defect.";
const STEPPER: &str = "This does not depend on the system: the method or the formula has a defect.";
const SERIES: &str = "The step may be too long for the series of the modified Hamiltonian: try half the step.";

/// A claim about methods, which is checked for every system.
struct Claim {
    name: &'static str,
    /// The picture, the unit of the number, and what it may mean that the claim fails.
    shown: (&'static str, &'static str, &'static str),
    says: &'static str,
    /// Whether the claim applies to the system.
    applies: fn(&Study) -> bool,
    /// The number; none where it could not be measured.
    value: fn(&Study) -> Option<f64>,
    within: [f64; 2],
}

/// A slope is off by a few hundredths where the next term of the error still shows, and a mistyped method by one.
const fn order(order: f64) -> [f64; 2] {
    [order - 0.15, order + 0.15]
}

/// An energy that has changed by less than a hundredth of the largest kinetic energy has not grown or decayed to speak of.
pub(crate) const CHANGED: f64 = 0.01;

/// The largest ratio of the energy errors of the second and the first half of a run without drift.
const STAYS: f64 = 1.5;

/// A thousand steps whose roundings differ in two orbits: as far apart as they were after a step, times a shear that
/// grows with the steps.
const SHIFTED: f64 = 1e6 * 8.0 * f64::EPSILON;

/// A power is off by a few tenths where the next one still shows, and by one at least where a term is wrong.
const POWER: f64 = 0.4;

/// An exponent from two long steps is off by the next term of the error, and by two where a column gains nothing.
const COLUMN: f64 = 1.0;

/// A column that gains two orders has errors that are smaller by orders of magnitude, one that gains nothing has the same.
const GAIN: f64 = 0.5;

/// Twenty Euler steps, each rounded a few times, in sums whose weights are below nine.
const CORNER: f64 = 20.0 * 4.0 * 9.0 * f64::EPSILON;

/// Areas are measured to the resolution of their outline.
const AREA: f64 = 1e-6;

/// The tolerance of a return: the roundings of a hundred or so steps, which an implicit method ends with as well, times
/// a shear that grows with the steps.
const BACK: f64 = 1e-9;

/// The change of the energy after a period. Later, a system may have escaped.
fn energy_change(study: &Study, method: &str) -> Option<f64> {
    let (_, change) = study.method(method)?.energies.iter().take_while(|(periods, _)| *periods <= 1.0).last()?;
    Some(*change)
}

/// The largest distance of the bracket of a method from its formula.
fn off(study: &Study, method: &str) -> Option<f64> {
    Some(study.brackets.as_ref()?.iter().find(|row| row.name == method)?.off())
}

/// The farthest of several numbers; none if one is missing.
fn farthest(mut numbers: impl Iterator<Item = Option<f64>>) -> Option<f64> {
    numbers.try_fold(0.0, |most: f64, number| Some(most.max(number?)))
}

/// The exponent of a row.
macro_rules! orders {
    ($($name:literal $says:literal $method:literal $order:literal,)*) => {
        [$(Claim {
            name: $name,
            shown: ("errors", "", ORDER),
            says: $says,
            applies: |_| true,
            value: |study| study.method($method)?.slope,
            within: order($order),
        }),*]
    };
}

const ORDERS: [Claim; 11] = orders! {
    "leapfrog_order_2" "The leapfrog with staggered momenta has order 2: the exponent of its errors" "leapfrog" 2.0,
    "verlet_order_2" "The error of Verlet falls with the square of the step: its exponent" "Verlet" 2.0,
    "midpoint_order_2" "The explicit midpoint rule has order 2: the exponent" "explicit midpoint" 2.0,
    "implicit_midpoint_order_2" "The implicit midpoint rule has order 2: the exponent" "implicit midpoint" 2.0,
    "gauss_legendre4_order_4" "Two stages of Gauss and Legendre have order 4: the exponent" "Gauss–Legendre 4" 4.0,
    "rk4_order_4" "The classical Runge–Kutta method has order 4: the exponent" "Runge–Kutta 4" 4.0,
    "ab4_order_4" "The formula of Adams and Bashforth has order 4: the exponent" "Adams–Bashforth 4" 4.0,
    "pec4_order_4" "Without the last evaluation it keeps order 4: the exponent" "Adams PEC 4" 4.0,
    "abm4_order_4" "The predictor–corrector of Adams, Bashforth and Moulton has order 4: the exponent" "Adams–Bashforth–Moulton 4" 4.0,
    "yoshida4_order_4" "Yoshida's triple jump has order 4: the exponent" "Yoshida 4" 4.0,
    "blanes_moan6_order_6" "The composition of Blanes and Moan has order 6: the exponent" "Blanes–Moan 6" 6.0,
};

/// The claims about methods of second-order equations, where H is one.
const OF_SECOND_ORDER: [Claim; 2] = orders! {
    "stoermer4_order_4" "Störmer's formula over four positions has order 4: the exponent" "Störmer 4" 4.0,
    "stoermer_cowell4_order_4" "With Cowell's corrector it has order 4 as well: the exponent" "Störmer–Cowell 4" 4.0,
};

/// The claims about a composition with a force gradient, where there is one.
const OF_GRADIENTS: [Claim; 1] = orders! {
    "chin_4a_order_4" "Chin's composition with a force gradient has order 4 without a step back: the exponent" "Chin 4A" 4.0,
};

/// The claim about Taylor's method, where there are recurrences.
const OF_TAYLOR: Claim = Claim {
    name: "taylor_follows_its_tolerance",
    shown: ("work_precision", "", TOLERANCE),
    says: "The errors of Taylor's method fall with its tolerance: the exponent",
    applies: |_| true,
    value: |study| by_tolerance(study, "Taylor"),
    within: [0.5, 1.5],
};

/// The exponent of the errors of a method against its tolerance.
fn by_tolerance(study: &Study, method: &str) -> Option<f64> {
    let adaptive = study.adaptive.iter().find(|adaptive| adaptive.row.name == method)?;
    let seen: Vec<_> = adaptive.errors.iter().filter(|rung| rung.error > ROUNDED).collect();
    let [first, .., last] = seen[..] else { return None };
    Some((first.error / last.error).ln() / (first.step / last.step).ln())
}

/// Errors below this have as much of rounding in them as of a tolerance.
const ROUNDED: f64 = 1e-12;

const CLAIMS: [Claim; 31] = [
    Claim {
        name: "forward_euler_energy_grows",
        shown: ("energy", "K", CONVEX),
        says: "Forward Euler gains energy: the change after a period, in units of the largest kinetic energy",
        applies: |study| study.resolved,
        value: |study| energy_change(study, "forward Euler"),
        within: [CHANGED, f64::INFINITY],
    },
    Claim {
        name: "backward_euler_energy_decays",
        shown: ("energy", "K", CONVEX),
        says: "Backward Euler loses energy: the change after a period, in units of the largest kinetic energy",
        applies: |study| study.resolved,
        value: |study| energy_change(study, "backward Euler"),
        within: [f64::NEG_INFINITY, -CHANGED],
    },
    Claim {
        name: "symplectic_euler_bracket_is_one",
        shown: ("brackets", "", SYMPLECTIC),
        says: "Symplectic Euler preserves the Poisson bracket: {q₁, p₁} − 1 after a step",
        applies: |_| true,
        value: |study| Some(study.method("symplectic Euler")?.bracket() - 1.0),
        within: [-BRACKET, BRACKET],
    },
    Claim {
        name: "implicit_midpoint_bracket_is_one",
        shown: ("brackets", "", SOLVED),
        says: "The implicit midpoint rule preserves the Poisson bracket without a splitting: {q₁, p₁} − 1 after a step",
        applies: |_| true,
        value: |study| Some(study.method("implicit midpoint")?.bracket() - 1.0),
        within: [-BRACKET, BRACKET],
    },
    Claim {
        name: "forward_euler_bracket_is_not_one",
        shown: ("brackets", "", STRAIGHT),
        says: "Forward Euler does not preserve the Poisson bracket: |{q₁, p₁} − 1| after a step",
        applies: |_| true,
        value: |study| Some((study.method("forward Euler")?.bracket() - 1.0).abs()),
        // Off by h² T'' V'', where rounding would be a millionth of this.
        within: [1e6 * BRACKET, f64::INFINITY],
    },
    Claim {
        name: "forward_euler_bracket_has_a_formula",
        shown: ("brackets", "", SYMPLECTIC),
        says: "After a step of forward Euler {q₁, p₁} is 1 + h² T″V″: the largest distance along a period",
        applies: |study| study.brackets.is_some(),
        value: |study| off(study, "forward Euler"),
        within: [0.0, BRACKET],
    },
    Claim {
        name: "backward_euler_bracket_is_the_inverse",
        shown: ("brackets", "", SOLVED),
        says: "After a step of backward Euler {q₁, p₁} is 1 / (1 + h² T″V″), at the end of the step: the largest distance along a period",
        applies: |study| study.brackets.as_ref().is_some_and(|rows| rows.len() > 2),
        value: |study| off(study, "backward Euler"),
        within: [0.0, BRACKET],
    },
    Claim {
        name: "brackets_stay_one_at_every_step",
        shown: ("tangents", "", SOLVED),
        says: "Symplectic methods preserve the Poisson bracket at every step: the largest |{q₁, p₁} − 1| in units of the rounding bound",
        applies: |_| true,
        value: |study| {
            let methods = study.methods.iter().filter(|measured| measured.symplectic);
            let mut deviations = methods.flat_map(|measured| &measured.deviations).peekable();
            deviations.peek()?;
            Some(deviations.map(Deviation::excess).fold(0.0, f64::max))
        },
        within: [0.0, 1.0],
    },
    Claim {
        name: "forward_euler_bracket_leaves_one",
        shown: ("tangents", "", STRAIGHT),
        says: "The bracket of forward Euler departs from one: |{q₁, p₁} − 1| after four periods, or when it overflows",
        applies: |_| true,
        value: |study| Some((study.method("forward Euler")?.deviations.last()?.bracket - 1.0).abs()),
        within: [CHANGED, f64::INFINITY],
    },
    Claim {
        name: "maps_tell_symplectic_methods",
        shown: ("maps", "", SOLVED),
        says: "Exactly the symplectic methods have symplectic maps, for every step: the number of exceptions after eight steps, when multistep methods have left their starter",
        applies: |_| true,
        value: |study| {
            let wrong = study.methods.iter().filter(|measured| measured.symplectic != measured.keeps_areas());
            Some(wrong.count() as f64)
        },
        within: [0.0, 0.0],
    },
    Claim {
        name: "symplectic_methods_preserve_areas",
        shown: ("areas", "", OUTLINE),
        says: "Symplectic methods preserve the area of a set of initial states: the largest relative change",
        applies: |_| true,
        value: |study| {
            let methods = study.methods.iter().filter(|measured| measured.symplectic);
            farthest(methods.map(|measured| Some((measured.blob.area() - 1.0).abs())))
        },
        within: [0.0, AREA],
    },
    Claim {
        name: "forward_euler_area_is_not_preserved",
        shown: ("areas", "", STRAIGHT),
        says: "Forward Euler does not preserve the area of a set of initial states: the relative change",
        applies: |_| true,
        value: |study| Some((study.method("forward Euler")?.blob.area() - 1.0).abs()),
        within: [CHANGED, f64::INFINITY],
    },
    Claim {
        name: "symmetric_methods_come_back",
        shown: ("reversal", "of the orbit", CHAOS),
        says: "Symmetric methods return when the momenta are reversed: the largest distance from the start",
        applies: |study| study.autonomous,
        value: |study| {
            let methods = study.methods.iter().filter(|measured| measured.symmetric);
            farthest(methods.map(|measured| measured.reversal.apart))
        },
        within: [0.0, BACK],
    },
    Claim {
        name: "forward_euler_does_not_come_back",
        shown: ("reversal", "of the orbit", STRAIGHT),
        says: "Forward Euler does not return: the distance from the start",
        applies: |study| study.autonomous,
        value: |study| Some(study.method("forward Euler")?.reversal.apart.unwrap_or(f64::INFINITY)),
        within: [CHANGED, f64::INFINITY],
    },
    Claim {
        name: "symplectic_euler_does_not_come_back",
        shown: ("reversal", "of the orbit", STRAIGHT),
        says: "Symplectic Euler does not return either, since it kicks first in both directions: the distance from the start",
        applies: |study| study.autonomous,
        value: |study| study.method("symplectic Euler")?.reversal.apart,
        within: [CHANGED, f64::INFINITY],
    },
    Claim {
        name: "runge_kutta_4_does_not_come_back",
        shown: ("reversal", "of the orbit", STRAIGHT),
        says: "Runge–Kutta 4 does not return: the distance from the start, a billionth by rounding alone",
        applies: |study| study.autonomous,
        value: |study| study.method("Runge–Kutta 4")?.reversal.apart,
        within: [1e3 * BACK, f64::INFINITY],
    },
    Claim {
        name: "each_column_of_the_extrapolation_gains_two_orders",
        shown: ("extrapolation", "", ORDER),
        says: "Each column of the extrapolation gains two orders: the least excess of the exponents of its errors over 3, 5, 7, 9",
        applies: |_| true,
        value: |study| study.extrapolation.as_ref()?.least_excess(),
        within: [-COLUMN, f64::INFINITY],
    },
    Claim {
        name: "each_column_of_the_extrapolation_is_more_accurate",
        shown: ("extrapolation", "", ORDER),
        says: "Each column of the extrapolation is more accurate than the one before: the largest ratio of their errors in the finest row",
        applies: |_| true,
        value: |study| study.extrapolation.as_ref()?.largest_ratio(),
        within: [0.0, GAIN],
    },
    Claim {
        name: "the_extrapolation_ends_in_gragg_bulirsch_stoer",
        shown: ("extrapolation", "of the orbit", SAME),
        says: "The last entry of the extrapolation is the step of Gragg, Bulirsch and Stoer: the relative distance",
        applies: |_| true,
        value: |study| Some(study.extrapolation.as_ref()?.corner),
        within: [0.0, CORNER],
    },
    Claim {
        name: "verlet_equals_shifted_leapfrog",
        shown: ("shifted", "of the orbit", SAME),
        says: "Verlet is the leapfrog shifted by half a step: the largest relative distance",
        applies: |_| true,
        value: |study| Some(study.shifted.apart),
        within: [0.0, SHIFTED],
    },
    Claim {
        name: "dormand_prince_5_follows_its_tolerance",
        shown: ("adaptive", "", TOLERANCE),
        says: "The errors of the adaptive Runge–Kutta method of Dormand and Prince, order 5, fall with its tolerance: the exponent",
        applies: |_| true,
        value: |study| by_tolerance(study, "Dormand–Prince 5"),
        within: [0.5, 1.5],
    },
    Claim {
        name: "adaptive_steps_follow_the_force",
        shown: ("adaptive", "", STEPPER),
        says: "On an ellipse of eccentricity 0.8 its steps are shorter where the force is large, with the power −3/4: the exponent",
        applies: |_| true,
        value: |study| Some(study.steps.as_ref()?.exponent),
        within: [-0.85, -0.65],
    },
    Claim {
        name: "adaptive_runge_kutta_energy_changes",
        shown: ("adaptive", "K", KEEPS),
        says: "Adaptive steps do not conserve the energy: the size of its change with a tolerance of a hundredth",
        applies: |study| study.resolved,
        value: |study| Some(study.steps.as_ref()?.change.abs()),
        within: [CHANGED, f64::INFINITY],
    },
    Claim {
        name: "a_parasitic_root_grows",
        shown: ("roots", "", STEPPER),
        says: "On an oscillator in steps of 0.6/ω, Adams and Bashforth’s method grows by its largest root, a parasitic one: the relative difference of the growth per step",
        applies: |_| true,
        value: |study| Some((study.multistep.as_ref()?.growth - 1.0).abs()),
        within: [0.0, 1e-6],
    },
    Claim {
        name: "principal_roots_follow_the_motion",
        shown: ("roots", "", STEPPER),
        says: "The principal roots of multistep methods of order 4 differ from exp(ihω) by h⁵: the largest difference of the exponents from 5",
        applies: |_| true,
        value: |study| farthest(study.multistep.as_ref()?.roots.iter().map(|roots| Some((roots.exponent - 5.0).abs()))),
        within: [0.0, 0.15],
    },
    Claim {
        name: "explicit_steps_explode_on_a_stiff_equation",
        shown: ("gear", "", STEPPER),
        says: "Forward Euler explodes on y′ = −50 (y − cos t) in steps longer than 2/50: the error in steps of 2.1/50 at t = 1.5",
        applies: |_| true,
        value: |study| Some(study.gear.explodes),
        within: [10.0, f64::INFINITY],
    },
    Claim {
        name: "backward_differences_stay_on_a_stiff_equation",
        shown: ("gear", "", STEPPER),
        says: "Backward differences (Gear) of orders 1 to 6 follow its slow curve in steps of 5/50: the largest error",
        applies: |_| true,
        value: |study| Some(study.gear.stays),
        within: [0.0, 0.01],
    },
    Claim {
        name: "backward_differences_have_their_orders",
        shown: ("gear", "", STEPPER),
        says: "Backward differences of orders 1 to 6 have these orders on a stiff equation: the largest difference of an exponent",
        applies: |_| true,
        value: |study| Some(study.gear.exponents_off()),
        within: [0.0, 0.15],
    },
    Claim {
        name: "backward_differences_are_stable_in_sectors",
        shown: ("regions", "degrees", STEPPER),
        says: "Backward differences of orders 1 to 6 are A(α)-stable with α = 90°, 90°, 86.03°, 73.35°, 51.84° and 17.84°: the largest difference",
        applies: |_| true,
        value: |study| Some(study.gear.angles_off()),
        within: [0.0, 0.01],
    },
    Claim {
        name: "backward_differences_of_order_6_are_stable",
        shown: ("regions", "", STEPPER),
        says: "The parasitic roots of the formula of order 6 lie inside of the unit circle: the largest modulus",
        applies: |_| true,
        value: |study| Some(study.gear.parasitic[0]),
        within: [0.0, 0.999],
    },
    Claim {
        name: "backward_differences_of_order_7_are_not",
        shown: ("regions", "", STEPPER),
        says: "One of the formula of order 7 lies outside, so that there is no method of this order: the largest modulus",
        applies: |_| true,
        value: |study| Some(study.gear.parasitic[1]),
        within: [1.001, f64::INFINITY],
    },
];

impl Claim {
    /// Holds the claim against what was measured.
    fn verdict(&self, study: &Study) -> Verdict {
        let (picture, unit, meaning) = self.shown;
        let says = self.says.replace("{q₁, p₁}", &study.bracket()).replace("T″V″", &study.curvature);
        let verdict = Verdict::new(self.name, says, self.within, (self.value)(study));
        Verdict { unit, ..verdict.shown_in(picture).meaning(meaning) }
    }
}

/// Returns the verdict on the energy of one method, in the steps of its portrait.
fn of_portrait(measured: &Measured) -> Verdict {
    let portrait = &measured.portrait;
    let (name, steps) = (measured.name(), plain(steps_per_period(portrait.count)));
    let word = measured.word();
    if measured.symplectic {
        let says = format!(
            "The energy of {name} oscillates and does not drift, in {steps} steps per period: its largest error in the second half over that in the first"
        );
        let verdict = Verdict::new(format!("{word}_energy_stays"), says, [0.0, STAYS], Some(portrait.growth()));
        return verdict.shown_in("portraits").meaning(DRIFT);
    }
    let periods = plain(portrait.periods);
    let says = format!(
        "{name} gains or loses energy, in {steps} steps per period: the size of the change after {periods} periods, in units of the largest kinetic energy"
    );
    let verdict =
        Verdict::new(format!("{word}_energy_changes"), says, [SEEN, f64::INFINITY], Some(portrait.change.abs()));
    Verdict { unit: "K", ..verdict.shown_in("portraits").meaning(KEEPS) }
}

impl Measured {
    /// The name as a word of letters, digits and underscores.
    pub(crate) fn word(&self) -> String {
        word(self.name())
    }
}

fn word(name: &str) -> String {
    let letter = |letter: char| if letter.is_ascii_alphanumeric() { letter.to_ascii_lowercase() } else { '_' };
    name.replace('ö', "oe").chars().map(letter).collect()
}

/// Returns the verdict on a modified Hamiltonian.
fn of_modified(modified: &Modified) -> Verdict {
    let name = modified.row.name;
    let [first, last] = [modified.powers.first(), modified.powers.last()].map(|power| power.copied().unwrap_or(0));
    let says = format!(
        "{name} conserves a modified Hamiltonian: with the terms of its series, the change of the energy falls with powers of the step \
         from {first} to {last}; by how much the measured ones exceed these, at least"
    );
    let verdict =
        Verdict::new(format!("{}_modified_energy_stays", word(name)), says, [-POWER, f64::INFINITY], modified.excess);
    verdict.shown_in("modified").meaning(SERIES)
}

/// Returns the verdicts on all claims that apply to the system.
pub(crate) fn verdicts(study: &Study) -> Vec<Verdict> {
    let of_gradients = study.method("Chin 4A").map_or(&OF_GRADIENTS[..0], |_| &OF_GRADIENTS[..]);
    let of_second_order = study.method("Störmer 4").map_or(&OF_SECOND_ORDER[..0], |_| &OF_SECOND_ORDER[..]);
    let of_taylor = study.adaptive.iter().filter(|adaptive| adaptive.row.name == "Taylor").map(|_| &OF_TAYLOR);
    let claims = CLAIMS
        .iter()
        .chain(&ORDERS)
        .chain(of_second_order)
        .chain(of_gradients)
        .chain(of_taylor)
        .filter(|claim| (claim.applies)(study));
    let portraits = study.methods.iter().filter(|_| study.resolved).map(of_portrait);
    let modified = study.modified.iter().filter(|_| study.resolved).map(of_modified);
    claims.map(|claim| claim.verdict(study)).chain(portraits).chain(modified).collect()
}

#[cfg(test)]
mod tests {
    use super::Verdict;

    #[test]
    fn expectations_are_stated_in_words() {
        let cases = [
            ([0.0, 0.0], "exactly 0"),
            ([-1e-12, 1e-12], "0, to 10⁻¹²"),
            ([0.01, f64::INFINITY], "at least 0.01"),
            ([f64::NEG_INFINITY, -0.01], "at most −0.01"),
            ([0.0, 1.5], "at most 1.5"),
            ([1.85, 2.15], "between 1.85 and 2.15"),
        ];
        for (within, text) in cases {
            assert_eq!(Verdict::new("", "", within, Some(0.0)).expected(), text);
        }
        let missing = Verdict::new("", "", [0.0, 1.0], None);
        assert!(!missing.holds() && missing.word() == "FAILED");
        assert!(Verdict::new("", "", [0.0, 1.0], Some(1.0)).holds());
    }
}
