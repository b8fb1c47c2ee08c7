//! The methods, one row each.

use crate::{
    admitted::{by_taylor, with_gradients},
    errors::{Exact, Rung, tolerances},
    measured::{Measured, energies, measure},
    modified::{self, Modified},
    plan::Plan,
    problem::Problem,
};
use integrator_core::{
    prelude::*,
    reference::{
        AdamsBashforth4, AdamsBashforthMoulton4, AdamsBashforthMoulton4Pec, AnyReference, BackwardEuler, Bdf,
        DormandPrince5, DormandPrince8, ExplicitMidpoint, ForwardEuler, GaussLegendre4, GaussLegendre6,
        GraggBulirschStoer, ImplicitMidpoint, RungeKutta4, StaggeredLeapfrog,
    },
};
use integrator_plot::{Colour, colour::COLOURS};
use std::error::Error;

/// What the page says of a method.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    pub(crate) name: &'static str,
    /// In the notation of `formula.rs`: `z` is `(q, p)`, `f` its derivative, `S` a step.
    pub(crate) formula: &'static str,
    /// What it is, in a sentence.
    pub(crate) says: &'static str,
    /// The colour of all its curves.
    pub(crate) colour: Colour,
    /// Whether the page asks for the longest steps that it can take.
    pub(crate) limit: bool,
}

/// A method that chooses its own steps.
#[derive(Clone, Debug)]
pub(crate) struct Adaptive {
    pub(crate) row: Row,
    pub(crate) errors: Vec<Rung>,
    /// Periods, and the relative change of the energy, with the tolerance [`LOOSE`].
    pub(crate) energies: Vec<(f64, f64)>,
}

/// The tolerance with which energies of methods that choose their steps are followed.
pub(crate) const LOOSE: f64 = 1e-4;

/// Colours beyond those of charts, for whoever has so many curves.
const MORE: [Colour; 7] = [
    Colour(120, 94, 240),
    Colour(150, 150, 60),
    Colour(220, 38, 127),
    Colour(0, 130, 140),
    Colour(0, 60, 220),
    Colour(110, 110, 110),
    Colour(128, 0, 32),
];

/// Measures the methods that choose their own steps: over the whole time in one go, for all they begin anew with each step
/// of a run.
pub(crate) fn adaptive<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<Adaptive>, Box<dyn Error>> {
    macro_rules! rows {
        ($($name:literal $method:ident $colour:expr, $says:literal;)*) => {
            vec![$(Adaptive {
                row: Row { name: $name, formula: "", says: $says, colour: $colour, limit: false },
                errors: tolerances(problem, |tolerance| AnyReference::from($method { tolerance }), plan, exact)?,
                energies: energies(problem, AnyReference::from($method { tolerance: LOOSE }), plan)?,
            }),*]
        };
    }
    let mut rows = rows! {
        "Dormand–Prince 5" DormandPrince5 MORE[4], "Runge–Kutta with steps by an estimate of the error";
        "Dormand–Prince 8" DormandPrince8 MORE[5], "the same of order 8";
        "backward differences" Bdf MORE[6], "for stiff systems";
    };
    rows.extend(by_taylor(problem, plan, exact)?);
    Ok(rows)
}

/// Measures every method on a problem.
pub(crate) fn all<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<Measured>, Box<dyn Error>> {
    macro_rules! rows {
        ($($name:literal $method:expr, $colour:expr, $limit:literal, $formula:literal, $says:literal;)*) => {
            vec![$(measure(
                Row { name: $name, formula: $formula, says: $says, colour: $colour, limit: $limit },
                $method, problem, plan, exact,
            )?),*]
        };
    }
    let mut rows = rows! {
        "forward Euler" AnyReference::from(ForwardEuler), COLOURS[0], false,
            "z_{n+1} = z_n + h f(z_n)",
            "Along the tangent at the beginning: outwards on every closed orbit.";
        "backward Euler" BackwardEuler, COLOURS[1], false,
            "z_{n+1} = z_n + h f(z_{n+1})",
            "Along the tangent at the end: inwards on every closed orbit.";
        "symplectic Euler" Euler, COLOURS[5], true,
            "p_{n+1} = p_n − h V'(q_n) ; q_{n+1} = q_n + h T'(p_{n+1})",
            "Kick, then drift with the new momentum: the flow of V, then that of T, each of which preserves areas.";
        "leapfrog" AnyReference::from(StaggeredLeapfrog), COLOURS[7], false,
            "p_{n+1/2} = p_{n−1/2} − h V'(q_n) ; q_{n+1} = q_n + h T'(p_{n+1/2})",
            "Momenta half a step from positions: Verlet, seen at other times.";
        "Verlet" Verlet, COLOURS[6], true,
            "S_2(h) = e^{{h}/{2}T} e^{hV} e^{{h}/{2}T}",
            "Half a drift, a kick, half a drift: symplectic, and its own inverse in steps back.";
        "explicit midpoint" AnyReference::from(ExplicitMidpoint), COLOURS[2], false,
            "z_{n+1} = z_n + h f(z_n + {h}/{2} f(z_n))",
            "Of second order like Verlet, and yet its energy grows.";
        "implicit midpoint" ImplicitMidpoint, COLOURS[3], true,
            "z_{n+1} = z_n + h f({z_n + z_{n+1}}/{2})",
            "Symplectic for any H, without a splitting, for an equation in each step.";
        "Gauss–Legendre 4" GaussLegendre4, MORE[0], true,
            "z_{n+1} = z_n + {h}/{2}(k_1 + k_2) ; k_i = f(z_n + h Σ_j a_{ij} k_j)",
            "Two stages at Gauss's nodes: the implicit midpoint rule of order 4.";
        "Gauss–Legendre 6" GaussLegendre6, MORE[3], false,
            "z_{n+1} = z_n + {h}/{18}(5 k_1 + 8 k_2 + 5 k_3) ; k_i = f(z_n + h Σ_j a_{ij} k_j)",
            "Three stages: order 6.";
        "Runge–Kutta 4" AnyReference::from(RungeKutta4), COLOURS[4], true,
            "z_{n+1} = z_n + {h}/{6}(k_1 + 2 k_2 + 2 k_3 + k_4)",
            "The classical one. Its errors are small, and always in the same sense.";
        "Adams–Bashforth 4" AnyReference::from(AdamsBashforth4), Colour(200, 150, 90), false,
            "z_{n+1} = z_n + {h}/{24}(55 f_n − 59 f_{n−1} + 37 f_{n−2} − 9 f_{n−3})",
            "Four past forces in place of stages, for one new force a step. The first three steps are Runge and Kutta's.";
        "Adams–Bashforth–Moulton 4" AnyReference::from(AdamsBashforthMoulton4), MORE[1], false,
            "z_{n+1}^* = z_n + {h}/{24}(55 f_n − 59 f_{n−1} + 37 f_{n−2} − 9 f_{n−3}) ; z_{n+1} = z_n + {h}/{24}(9 f_{n+1}^* + 19 f_n − 5 f_{n−1} + f_{n−2})",
            "Predicts like Adams and Bashforth, evaluates the force, corrects with it, and evaluates it again for later steps (PECE).";
        "Adams PEC 4" AnyReference::from(AdamsBashforthMoulton4Pec), Colour(110, 160, 200), false,
            "z_{n+1}^* = z_n + {h}/{24}(55 f_n^* − 59 f_{n−1}^* + 37 f_{n−2}^* − 9 f_{n−3}^*) ; z_{n+1} = z_n + {h}/{24}(9 f_{n+1}^* + 19 f_n^* − 5 f_{n−1}^* + f_{n−2}^*)",
            "Later steps read the force where it was predicted: half the work, and less stable.";
        "Gragg–Bulirsch–Stoer" AnyReference::from(GraggBulirschStoer), MORE[2], false,
            "T_{jk} = T_{j,k−1} + {T_{j,k−1} − T_{j−1,k−1}}/{{(n_j/n_{j−k})}^2 − 1}",
            "Modified midpoint steps, extrapolated to none: accurate in long steps, and not symplectic.";
        "Yoshida 4" Yoshida4, Colour(0, 90, 60), true,
            "S_4(h) = S_2(w_1 h) S_2(w_0 h) S_2(w_1 h) ; w_1 = {1}/{2 − 2^{1/3}}, w_0 = 1 − 2 w_1",
            "Three steps of Verlet, the one in the middle back in time, so that errors of third order cancel.";
        "Blanes–Moan 6" BlanesMoan6, Colour(90, 90, 200), false,
            "S_6(h) = Π_i e^{a_i h T} e^{b_i h V}",
            "Drifts and kicks whose eleven coefficients were found by search.";
        "Kahan–Li 8" KahanLi8, Colour(110, 70, 30), false,
            "S_8(h) = Π_{i=1}^{17} S_2(w_i h)",
            "Seventeen steps of Verlet, the same from both ends.";
    };
    rows.extend(with_gradients(problem, plan, exact)?);
    Ok(rows)
}

/// Measures what the compositions conserve whose modified Hamiltonian has terms up to the fourth power of the step.
pub(crate) fn modified<H: Hamiltonian>(problem: &Problem<'_, H>, plan: &Plan, methods: &[Measured]) -> Vec<Modified> {
    macro_rules! rows {
        ($($name:literal $method:ident;)*) => {
            [$(methods
                .iter()
                .find(|measured| measured.name() == $name)
                .and_then(|measured| modified::modified(measured.row, $method, problem, plan))),*]
        };
    }
    let rows = rows! {
        "symplectic Euler" Euler;
        "Verlet" Verlet;
        "Yoshida 4" Yoshida4;
    };
    rows.into_iter().flatten().collect()
}
