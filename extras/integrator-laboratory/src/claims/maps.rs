//! Maps: brackets, areas, reversals.

use super::{
    CHANGED, Claim,
    advice::{CHAOS, OUTLINE, SOLVED, STRAIGHT, SYMPLECTIC},
    farthest,
};
use crate::{measured::BRACKET, study::Study, tangents::Deviation};

/// Areas are measured to the resolution of their outline, and other than before where they change by a hundred times that.
const AREA: f64 = 1e-6;
const OTHER_AREA: f64 = 100.0 * AREA;

/// The tolerance of a return: the roundings of a hundred or so steps, which an implicit method ends with as well, times
/// a shear that grows with the steps.
const BACK: f64 = 1e-9;

/// The largest distance of the bracket of a method from its formula.
fn off(study: &Study, method: &str) -> Option<f64> {
    Some(study.brackets.as_ref()?.iter().find(|row| row.name == method)?.off())
}

pub(super) const CLAIMS: &[Claim] = &[
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
        within: [OTHER_AREA, f64::INFINITY],
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
];
