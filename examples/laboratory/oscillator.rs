//! The harmonic oscillator `H = p²/2 + q²/2`: the longest stable steps of compositions.

use crate::systems::Oscillator;
use integrator_core::{Method, prelude::*};
use integrator_laboratory::Verdict;

/// Returns the claims about the oscillator.
pub(crate) fn claims() -> Vec<Verdict> {
    let verlet = "Verlet is stable on the oscillator up to a step of 2/ω: the longest step with which the energy stays";
    let yoshida =
        "Yoshida's triple jump is stable up to a shorter step, since one of its steps goes back: the longest one";
    let claims = vec![
        Verdict::new("verlet_stability_limit", verlet, [1.999, 2.001], Some(longest(Verlet))),
        Verdict::new("yoshida4_stability_limit", yoshida, [1.5, 1.7], Some(longest(Yoshida4))),
    ];
    claims.into_iter().map(|claim| claim.shown_in("limits")).collect()
}

/// Returns the longest stable step to a thousandth. A longer step multiplies the energy by a constant factor, some ten per
/// cent at a thousandth beyond the limit.
fn longest<M: Method<Oscillator>>(method: M) -> f64 {
    let stays = |h: f64| {
        let Ok(mut run) = Oscillator.run_with(method, Phase::new([1.0], [0.0]), h) else { return false };
        run.advance(4_000).is_ok() && run.energy() < 1e6
    };
    let (mut short, mut long) = (1.0, 4.0);
    while long - short > 1e-5 {
        let middle = 0.5 * (short + long);
        if stays(middle) { short = middle } else { long = middle }
    }
    short
}
