//! The durations of the inner steps of a stage, which add up to its duration.

use crate::scalar::exact::two_product;

/// The durations of inner steps.
#[derive(Clone, Copy)]
pub(super) struct Durations {
    /// The duration of all other steps.
    pub(super) each: f64,
    /// The duration of some steps, from the second one on, which differs by one spacing of numbers.
    ///
    /// The first step and the last one have the same duration. The first flow of a composition has a half in each of them, and
    /// lasts as long as all steps only then.
    corrected: f64,
    /// The number of these steps, at most half of all.
    count: usize,
}

impl Durations {
    /// The durations of this number of steps; if they are exact, they add up to `duration` without a rounding error.
    #[inline(always)]
    pub(super) fn of(duration: f64, steps: usize, are_exact: bool) -> Self {
        let each = duration / steps as f64;
        if !are_exact || !each.is_normal() {
            return Self { each, corrected: each, count: 0 };
        }
        let [product, lost] = two_product(each, steps as f64);
        // A multiple of the spacing at `each`, since `duration` and the product are.
        let rest = (duration - product) - lost;
        let bits = each.to_bits();
        let is_longer = (rest > 0.0) == (each > 0.0);
        let corrected = f64::from_bits(if is_longer { bits + 1 } else { bits - 1 });
        Self { each, corrected, count: (rest / (corrected - each)) as usize }
    }

    #[inline(always)]
    pub(super) fn of_step(&self, step: usize) -> f64 {
        if step.wrapping_sub(1) < self.count { self.corrected } else { self.each }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Hamiltonian, Phase, composition::catalogue::Verlet};
    use dashu_float::{FBig, round::mode::HalfEven};

    type Big = FBig<HalfEven, 2>;

    fn big(x: f64) -> Big {
        Big::try_from(x).expect("a finite number").with_precision(400).value()
    }

    #[test]
    fn the_durations_of_all_steps_add_up() {
        let (mut uneven, mut state) = (0, 1_u64);
        for case in 0..4000 {
            // A linear congruential generator: any mantissa, at any of a few hundred exponents, of either sign.
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let mantissa = 1.0 + (state >> 12) as f64 / (1_u64 << 52) as f64;
            let exponent = case % 400 - 200;
            let duration = if case % 3 == 0 { -mantissa } else { mantissa } * 2.0_f64.powi(exponent);
            let steps = 1 + (state as usize >> 3) % 300;
            let sum = |are_exact: bool| -> [Big; 2] {
                let durations = Durations::of(duration, steps, are_exact);
                let of_step = |step: usize| big(durations.of_step(step));
                // The first flow of a composition is half of one at both ends, and is merged with its like in between.
                let ends = big(durations.of_step(0) / 2.0) + big(durations.of_step(steps - 1) / 2.0);
                [(0..steps).map(of_step).sum(), (1..steps).map(of_step).sum::<Big>() + ends]
            };
            for sum in sum(true) {
                assert_eq!(sum, big(duration), "{duration:e} in {steps} steps");
            }
            uneven += u32::from(sum(false)[0] != big(duration));
        }
        // Quotients by powers of two are exact, and few others.
        assert!(uneven > 3500, "{uneven} sums of rounded durations are wrong");
    }

    #[test]
    fn durations_differ_by_one_spacing() {
        let durations = Durations::of(0.1, 7, true);
        let spacing = durations.each.next_up() - durations.each;
        assert_eq!((durations.corrected - durations.each).abs(), spacing);
        assert!((1..=3).contains(&durations.count), "{}", durations.count);
        assert_eq!(Durations::of(0.1, 8, true).count, 0, "an eighth is exact");
    }

    #[test]
    fn extreme_durations_do_no_harm() {
        for duration in [0.0, -0.0, 5e-324, -5e-324, 1e-310, 3e-308, f64::MAX, -f64::MAX, f64::INFINITY, f64::NAN] {
            for steps in [1, 3, 7] {
                let durations = Durations::of(duration, steps, true);
                assert!(durations.count <= steps / 2, "{duration:e}: {}", durations.count);
            }
        }
    }

    /// A mass on a stiff spring and a soft one.
    struct Springs;

    #[crate::hamiltonian(split = soft + 3 * (stiff + kinetic))]
    impl Springs {
        fn soft(&self, q: [f64; 1]) -> f64 {
            0.5 * q[0] * q[0]
        }
        fn stiff(&self, q: [f64; 1]) -> f64 {
            4.0 * q[0] * q[0]
        }
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            0.5 * p[0] * p[0]
        }
    }

    /// A matrix of many digits.
    #[derive(Clone)]
    struct Matrix([[Big; 2]; 2]);

    impl Matrix {
        fn drift(duration: Big) -> Self {
            Self([[big(1.0), duration], [big(0.0), big(1.0)]])
        }
        fn kick(stiffness: f64, duration: Big) -> Self {
            Self([[big(1.0), big(0.0)], [big(-stiffness) * duration, big(1.0)]])
        }
        fn after(&self, first: &Self) -> Self {
            let term = |row: usize, k: usize, column: usize| self.0[row][k].clone() * first.0[k][column].clone();
            Self([0, 1].map(|row| [0, 1].map(|column| term(row, 0, column) + term(row, 1, column))))
        }
        fn power(&self, exponent: u64) -> Self {
            let (mut power, mut result) = (self.clone(), Self::drift(big(0.0)));
            for bit in 0..64 {
                if exponent >> bit & 1 == 1 {
                    result = power.after(&result);
                }
                if exponent >> bit > 1 {
                    power = power.after(&power);
                }
            }
            result
        }
        /// This number of steps, the inner ones of this duration.
        fn of_steps(h: f64, inner: &Big, steps: u64) -> Self {
            let around = |ends: Self, middle: &Self| ends.after(middle).after(&ends);
            let half = inner.clone() / big(2.0);
            let three = around(Self::kick(8.0, half), &Self::drift(inner.clone())).power(3);
            around(Self::kick(1.0, big(h / 2.0)), &three).power(steps)
        }
    }

    #[test]
    fn the_phase_of_a_compensated_oscillator_does_not_drift() {
        const STEPS: u64 = 1 << 20;
        for h in [0.3, -0.2, 0.1, 0.29] {
            let mut run = Springs.run_with(Verlet, Phase::compensated([1.0], [0.0]), h).expect("a start");
            run.advance(STEPS).expect("finite");
            let Phase { q: [q], p: [p] } = run.state();
            let punctual = Matrix::of_steps(h, &(big(h) / big(3.0)), STEPS);
            let off = |q: Big, p: Big| {
                let [q, p] = [q - punctual.0[0][0].clone(), p - punctual.0[1][0].clone()];
                q.to_f64().value().hypot(p.to_f64().value())
            };
            let rounded = Matrix::of_steps(h, &big(h / 3.0), STEPS);
            let rounded = off(rounded.0[0][0].clone(), rounded.0[1][0].clone());
            let run = off(big(q.value) + big(q.carried), big(p.value) + big(p.carried));
            // A corrected step shifts the motion by its spacing at another time than the rounding did. Inner steps are nearly
            // flows of one H, which commute, so that only their error terms are left of that: some (0.1 √8)² of it. Roundings of
            // kicks, some 1e-17 each, are a thousand times more in a random walk.
            assert!(run < rounded / 20.0, "with h = {h} it is off by {run:e}, and would be by {rounded:e}");
        }
    }
}
