//! Model problems, which are the same for all systems.

use super::{Claim, advice::STEPPER, farthest};

/// Elements of a matrix are rounded some tens of times; the root for an eigenvalue multiplies this by `1 / sin θ`, ten at most.
const EIGENVALUE: f64 = 10.0 * 64.0 * f64::EPSILON;

/// The same of a modulus, relative to the loss in the shortest of these steps, 2·10⁻⁴.
const LOSS: f64 = 64.0 * f64::EPSILON / 2e-4;

/// The state on an ellipse of eccentricity 0.8 varies by a factor of nine, of which a series has the 16th root: 1.15. Late terms
/// show a radius up to a tenth, and steps are seen to a hundredth. Steps of equal length have a ratio of 34.
const SHARES: f64 = 1.5;

pub(super) const CLAIMS: &[Claim] = &[
    Claim {
        name: "a_parasitic_root_grows",
        shown: ("roots", "", STEPPER),
        says: "On an oscillator in steps of 0.6/ω, Adams and Bashforth’s method grows by its largest root, a parasitic one: the relative difference of the growth per step",
        applies: |_| true,
        value: |study| Some((study.models.multistep.as_ref()?.growth - 1.0).abs()),
        within: [0.0, 1e-6],
    },
    Claim {
        name: "principal_roots_follow_the_motion",
        shown: ("roots", "", STEPPER),
        says: "The principal roots of multistep methods of order 4 differ from exp(ihω) by h⁵: the largest difference of the exponents from 5",
        applies: |_| true,
        value: |study| {
            farthest(study.models.multistep.as_ref()?.roots.iter().map(|roots| Some((roots.exponent - 5.0).abs())))
        },
        within: [0.0, 0.15],
    },
    Claim {
        name: "explicit_steps_explode_on_a_stiff_equation",
        shown: ("gear", "", STEPPER),
        says: "Forward Euler explodes on y′ = −50 (y − cos t) in steps longer than 2/50: the error in steps of 2.1/50 at t = 1.5",
        applies: |_| true,
        value: |study| Some(study.models.gear.explodes),
        within: [10.0, f64::INFINITY],
    },
    Claim {
        name: "backward_differences_stay_on_a_stiff_equation",
        shown: ("gear", "", STEPPER),
        says: "Backward differences (Gear) of orders 1 to 6 follow its slow curve in steps of 5/50: the largest error",
        applies: |_| true,
        value: |study| Some(study.models.gear.stays),
        within: [0.0, 0.01],
    },
    Claim {
        name: "backward_differences_have_their_orders",
        shown: ("gear", "", STEPPER),
        says: "Backward differences of orders 1 to 6 have these orders on a stiff equation: the largest difference of an exponent",
        applies: |_| true,
        value: |study| Some(study.models.gear.exponents_off()),
        within: [0.0, 0.15],
    },
    Claim {
        name: "backward_differences_are_stable_in_sectors",
        shown: ("regions", "degrees", STEPPER),
        says: "Backward differences of orders 1 to 6 are A(α)-stable with α = 90°, 90°, 86.03°, 73.35°, 51.84° and 17.84°: the largest difference",
        applies: |_| true,
        value: |study| Some(study.models.gear.angles_off()),
        within: [0.0, 0.01],
    },
    Claim {
        name: "backward_differences_of_order_6_are_stable",
        shown: ("regions", "", STEPPER),
        says: "The parasitic roots of the formula of order 6 lie inside of the unit circle: the largest modulus",
        applies: |_| true,
        value: |study| Some(study.models.gear.parasitic[0]),
        within: [0.0, 0.999],
    },
    Claim {
        name: "backward_differences_of_order_7_are_not",
        shown: ("regions", "", STEPPER),
        says: "One of the formula of order 7 lies outside, so that there is no method of this order: the largest modulus",
        applies: |_| true,
        value: |study| Some(study.models.gear.parasitic[1]),
        within: [1.001, f64::INFINITY],
    },
    Claim {
        name: "adaptive_steps_follow_the_force",
        shown: ("adaptive", "", STEPPER),
        says: "On an ellipse of eccentricity 0.8 its steps are shorter where the force is large, with the power −3/4: the exponent",
        applies: |_| true,
        value: |study| Some(study.models.ellipse.as_ref()?.exponent),
        within: [-0.85, -0.65],
    },
    Claim {
        name: "taylor_steps_are_a_share_of_the_radius",
        shown: ("radius", "", STEPPER),
        says: "On the same ellipse the steps of Taylor’s method are one share of the radius of convergence: the largest share over the smallest",
        applies: |_| true,
        value: |study| {
            let [least, most] = study.models.radius.as_ref()?.shares();
            Some(most / least)
        },
        within: [1.0, SHARES],
    },
    Claim {
        name: "eigenvalues_have_closed_forms",
        shown: ("linear", "", STEPPER),
        says: "On an oscillator each step is a matrix. Its eigenvalues agree with their closed form for every method and step: the largest distance",
        applies: |_| true,
        value: |study| Some(study.models.linear.as_ref()?.off()),
        within: [0.0, EIGENVALUE],
    },
    Claim {
        name: "symplectic_eigenvalues_lie_on_the_unit_circle",
        shown: ("linear", "", STEPPER),
        says: "Eigenvalues of symplectic methods lie on the unit circle: the largest distance",
        applies: |_| true,
        value: |study| Some(study.models.linear.as_ref()?.off_circle()),
        within: [0.0, EIGENVALUE],
    },
    Claim {
        name: "runge_kutta_4_loses_h6_over_72",
        shown: ("linear", "", STEPPER),
        says: "In each step Runge–Kutta 4 loses the part h⁶/72 − h⁸/576 of the oscillator’s energy, for ω = 1: the largest relative difference",
        applies: |_| true,
        value: |study| study.models.linear.as_ref()?.loss_off(),
        within: [0.0, LOSS],
    },
];
