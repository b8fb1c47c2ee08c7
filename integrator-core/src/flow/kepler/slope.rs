//! The derivative of the flow of a Kepler part, from where its orbit leads.
//!
//! Kepler's equation `t = r₀ s + η G₂ + ζ G₃` is solved in numbers without derivatives. Those of its root follow from its own, with
//! `∂t/∂s = r` at the end,
//!
//! ```text
//! r δs = δt - s δr₀ - G₂ δη - G₃ δζ - (η ∂G₂/∂β + ζ ∂G₃/∂β) δβ        δGₙ = Gₙ₋₁ δs + ∂Gₙ/∂β δβ
//! ```
//!
//! so that no search is differentiated, and no series but those of the functions `Gₙ`, by `β` alone.
//!
//! Comes in: the arc that a way was found from. Goes out: the derivative of the increments along any direction of the body's position,
//! momentum and constants, and of the duration. Always true: values are those of the flow without derivatives, since they are
//! computed by it.

use super::{
    fall::AlongFalls,
    stumpff::functions,
    universal::{Body, Increments, Orbit, Solution, increments},
};
use crate::scalar::{
    dual::Dual,
    implicit::{Image, Implicit},
    real::{Mask, Real},
};

/// The way of a body, which follows from its position and momentum, its inverse mass and strength, and the duration.
pub(super) struct Way;

/// The quantities that the derivatives of a way are computed from.
pub(super) struct Slopes<F: Real, const D: usize> {
    body: Body<F, D>,
    duration: F,
    solution: Solution<F>,
    velocity: [F; D],
    /// The derivatives of `G₁` to `G₃` by `β`.
    by_beta: [F; 3],
    /// The derivatives by `μ` and `β` of the time within half a period.
    of_time: [F; 2],
}

impl<F: Real, const D: usize> Slopes<F, D> {
    #[inline(always)]
    fn of(body: Body<F, D>, duration: F, solution: Solution<F>) -> Self {
        let Orbit { mu, beta, time, .. } = solution.orbit;
        let mut velocity = body.p;
        for number in &mut velocity {
            *number = body.inverse_mass * *number;
        }
        let functions: [Dual<F>; 4] = functions(Dual::along(beta, F::of(1.0)), Dual::along(solution.s, F::of(0.0)));
        let by_beta = [functions[1].slope(), functions[2].slope(), functions[3].slope()];
        // Whole periods, 2π μ / β^(3/2) each.
        let (zero, revolved) = (F::of(0.0), duration - time);
        let often = revolved.equal(zero).not();
        let mut of_time = [zero; 2];
        if often.any() {
            of_time = [-(revolved / mu), F::of(1.5) * revolved / beta].map(|slope| F::select(often, slope, zero));
        }
        Self { body, duration, solution, velocity, by_beta, of_time }
    }

    /// The derivative of a way that is no fall.
    #[inline(always)]
    fn along(&self, [dq, dp]: [[F; D]; 2], [of_inverse_mass, of_strength, of_duration]: [F; 3]) -> [[F; D]; 2] {
        let Self { body: Body { q, p, inverse_mass, strength }, velocity, .. } = *self;
        let Solution { orbit, inverse: [inverse, arrival], s, functions: [first, second, third], .. } = self.solution;
        let Solution { free, bound, .. } = self.solution;
        let (Orbit { mu, distance, eta, beta, zeta, time }, zero) = (orbit, F::of(0.0));
        let [first_by_beta, second_by_beta, third_by_beta] = self.by_beta;

        let mut of_velocity = dp;
        let [mut of_distance, mut of_eta, mut of_square, mut square] = [zero; 4];
        for d in 0..D {
            of_velocity[d] = inverse_mass.fma(dp[d], of_inverse_mass * p[d]);
            of_distance = q[d].fma(dq[d], of_distance);
            of_eta = q[d].fma(of_velocity[d], dq[d].fma(velocity[d], of_eta));
            of_square = velocity[d].fma(of_velocity[d], of_square);
            square = velocity[d].fma(velocity[d], square);
        }
        // The distance of what no force acts on is one.
        let of_distance = F::select(free, zero, inverse * of_distance);
        let of_eta = F::select(free, zero, of_eta);
        let of_square = of_square + of_square;
        let of_mu = strength.fma(of_inverse_mass, inverse_mass * of_strength);
        let fall = (-mu * inverse).fma(of_distance, of_mu) * inverse;
        let of_beta = (fall + fall) - of_square;
        let of_zeta = square.fma(of_distance, distance.fma(of_square, -of_mu));
        let of_time = self.of_time[0].fma(of_mu, self.of_time[1].fma(of_beta, of_duration));

        let by_beta = eta.fma(second_by_beta, zeta * third_by_beta);
        let late = by_beta.fma(of_beta, third.fma(of_zeta, second.fma(of_eta, s.fma(of_distance, -of_time))));
        let of_s = -(arrival * late);
        let zeroth = (-beta).fma(second, F::of(1.0));
        let of_first = zeroth.fma(of_s, first_by_beta * of_beta);
        let of_second = first.fma(of_s, second_by_beta * of_beta);
        let of_third = second.fma(of_s, third_by_beta * of_beta);
        let of_r = eta.fma(of_first, zeta.fma(of_second, first.fma(of_eta, second.fma(of_zeta, of_distance))));

        // Those of f - 1, g, -m r df/dt and r (1 - dg/dt).
        let (by_position, by_momentum) = (strength * inverse * first, mu * second);
        let of_by_momentum = mu.fma(of_second, second * of_mu);
        let of_by_position = inverse * (-by_position).fma(of_distance, strength.fma(of_first, first * of_strength));
        let (f, of_f) = (-(inverse * by_momentum), inverse * (inverse * by_momentum).fma(of_distance, -of_by_momentum));
        let (near, far) = (distance.fma(first, eta * second), (-mu).fma(third, time));
        let of_near = distance.fma(of_first, first.fma(of_distance, eta.fma(of_second, second * of_eta)));
        let of_far = (-mu).fma(of_third, (-third).fma(of_mu, of_time));
        let [g, of_g] = [(near, far), (of_near, of_far)].map(|(near, far)| F::select(bound, near, far));
        let (mut of_q, mut of_p, nearer) = (dq, dp, -(arrival * of_r));
        for d in 0..D {
            of_q[d] = f.fma(dq[d], of_f.fma(q[d], g.fma(of_velocity[d], of_g * velocity[d])));
            let pull = by_position.fma(q[d], by_momentum * p[d]);
            let of_pull =
                by_position.fma(dq[d], of_by_position.fma(q[d], by_momentum.fma(dp[d], of_by_momentum * p[d])));
            of_p[d] = -(arrival * pull.fma(nearer, of_pull));
        }
        [of_q, of_p]
    }
}

impl<const D: usize> Implicit<D, 3> for Way {
    type Solution<F: Real> = Solution<F>;
    type Slopes<F: Real> = Slopes<F, D>;

    #[inline(always)]
    fn solve<F: Real>([q, p]: [[F; D]; 2], [inverse_mass, strength, duration]: [F; 3]) -> (Image<F, D>, Solution<F>) {
        let (Increments { q, p, failed }, solution) = increments(&Body { q, p, inverse_mass, strength }, duration);
        (Image { point: [q, p], failed }, solution)
    }

    #[inline(always)]
    fn slopes<F: Real>(
        [q, p]: [[F; D]; 2],
        [inverse_mass, strength, duration]: [F; 3],
        solution: Solution<F>,
    ) -> Slopes<F, D> {
        Slopes::of(Body { q, p, inverse_mass, strength }, duration, solution)
    }

    #[inline(always)]
    fn slope<F: Real>(at: &Slopes<F, D>, point: [[F; D]; 2], constants: [F; 3]) -> [[F; D]; 2] {
        let to = at.along(point, constants);
        let falling = at.solution.falling;
        if !falling.any() {
            return to;
        }
        let Slopes { body, duration, .. } = *at;
        F::enter(AlongFalls { body, duration, falling, others: to, point, constants })
    }
}
