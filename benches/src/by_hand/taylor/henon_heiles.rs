//! The Hénon–Heiles system: two coordinates in the lanes of a register, with all sums unrolled.
//!
//! The force is `-(x + 2xy, y + x² - y²)`. By symmetry, half of the products of order `k` suffice. The product of a
//! pair of orders is `xⱼ (yₘ, xₘ) + yⱼ (xₘ, -yₘ)`, so each order needs one register with swapped lanes and two
//! registers that repeat a coordinate. The newest products come last.

use super::{
    course::{COEFFICIENTS, Course, orders_from_one, with_order},
    planar::{Force, Trajectory},
    weights::INTEGRALS,
};
use crate::{enter::enter_pair, vector::Two};
use integrator_core::Phase;

#[derive(Clone)]
struct Star;

impl Force for Star {
    #[inline(always)]
    fn orders<T: Two, const N: usize>([q, p]: [T; 2], z: &mut [T; COEFFICIENTS], momenta: &mut [T; COEFFICIENTS]) {
        let zero = T::splat(0.0);
        // (y, x), (x, x) and (y, -y).
        let [turned, xx, yy] = &mut [[zero; COEFFICIENTS]; 3];
        (z[0], z[1]) = (q, p);
        momenta[0] = p;
        for k in 0..2 {
            (turned[k], xx[k], yy[k]) = (z[k].swap(), z[k].firsts(), z[k].seconds().conjugate());
        }
        let half = T::splat(0.5);
        momenta[1] = zero - (xx[0].fma(turned[0], yy[0] * z[0]) + q);
        z[2] = momenta[1] * half;
        (turned[2], xx[2], yy[2]) = (z[2].swap(), z[2].firsts(), z[2].seconds().conjugate());
        // The linear force also multiplies the newest coefficients, so it is added to a factor of the products. The
        // products are doubled later, hence the half.
        let spring = yy[0] + half;
        macro_rules! orders {
            ($($k:literal)*) => {$(
                let k: usize = $k;
                if k < N {
                    let (mut sum, mut other) = (zero, zero);
                    if k.is_multiple_of(2) {
                        let middle = k / 2;
                        sum = half * xx[middle] * turned[middle];
                        other = half * yy[middle] * z[middle];
                    }
                    for j in (1..k.div_ceil(2)).rev() {
                        sum = xx[j].fma(turned[k - j], sum);
                        other = yy[j].fma(z[k - j], other);
                    }
                    sum = xx[0].fma(turned[k], sum);
                    other = spring.fma(z[k], other);
                    let next = (sum + other) * T::splat(-2.0 * INTEGRALS.twice[k]);
                    z[k + 2] = next;
                    (turned[k + 2], xx[k + 2], yy[k + 2]) = (next.swap(), next.firsts(), next.seconds().conjugate());
                    momenta[k + 1] = next * T::splat((k + 2) as f64);
                }
            )*};
        }
        orders_from_one!(orders);
    }
}

/// Integrates the star, passes its states to `see`, and returns the number of steps.
///
/// # Panics
/// If the order is not one of [`ORDERS`](super::ORDERS).
pub fn henon_heiles(start: &Phase<[f64; 2]>, course: Course, see: &mut dyn FnMut(Phase<[f64; 2]>)) -> u64 {
    with_order!(course.order, N => enter_pair(Trajectory::<Star, N>::new(start, course, see)))
}
