//! Hénon and Heiles's star: the coordinates in the two lanes of a register, all sums written out.
//!
//! The force is `-(x + 2xy, y + x² - y²)`; half of the products of order `k` stand for the others, and the product of a
//! pair of orders is `xⱼ (yₘ, xₘ) + yⱼ (xₘ, -yₘ)`, so that one register of each order has its lanes changed and two have
//! a coordinate twice. What order 0 contributes has the constants of its order folded in, and waits for nothing else.

use super::{
    course::{COEFFICIENTS, Course, Expansion, Kept, follow, orders_from_one, with_order},
    estrin::estrin,
    horizon::{Sizes, reach},
    weights::INTEGRALS,
};
use crate::{
    enter::{PairKernel, enter_pair},
    vector::Two,
};
use integrator_core::Phase;

#[derive(Clone)]
struct Star<T, const N: usize> {
    tolerance: f64,
    q: Kept<T>,
    p: Kept<T>,
    /// Coefficients of positions
    positions: [T; COEFFICIENTS],
    /// and of momenta.
    momenta: [T; COEFFICIENTS],
}

impl<T: Two, const N: usize> Expansion for Star<T, N> {
    type State = Phase<[f64; 2]>;

    #[inline(always)]
    fn expand(&mut self) -> f64 {
        let (q, p) = (self.q.value, self.p.value);
        let zero = T::splat(0.0);
        let z = &mut self.positions;
        let momenta = &mut self.momenta;
        // (y, x), (x, x) and (y, -y).
        let [turned, xx, yy] = &mut [[zero; COEFFICIENTS]; 3];
        let conjugate = T::of(1.0, -1.0);
        macro_rules! keep {
            ($k:expr) => {
                turned[$k] = z[$k].swap();
                xx[$k] = z[$k].firsts();
                yy[$k] = z[$k].seconds() * conjugate;
            };
        }
        (z[0], z[1]) = (q, p);
        momenta[0] = p;
        keep!(0);
        keep!(1);
        // The force of order 0: twice the half of the product, and the spring.
        let half = T::splat(0.5);
        let product = xx[0].fma(turned[0], yy[0] * z[0]);
        momenta[1] = zero - (product + q);
        z[2] = momenta[1] * half;
        keep!(2);
        // Minus twice the factors of order k, with the spring.
        let minus_two = T::splat(-2.0);
        let direct = minus_two.fma(yy[0], T::splat(-1.0));
        let across = minus_two * xx[0];
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
                    let known = minus_two * (sum + other);
                    let integral = T::splat(INTEGRALS.twice[k]);
                    let known = (across * integral).fma(turned[k], known * integral);
                    z[k + 2] = (direct * integral).fma(z[k], known);
                    momenta[k + 1] = z[k + 2] * T::splat((k + 2) as f64);
                    if k + 2 < N {
                        keep!(k + 2);
                    }
                }
            )*};
        }
        orders_from_one!(orders);
        let size = |x: T| f64::max(x.first().abs(), x.swap().first().abs());
        let part = |series: &[T]| Sizes {
            value: size(series[0]),
            slope: size(series[1]),
            before: size(series[N - 1]),
            last: size(series[N]),
        };
        reach::<N>(self.tolerance, [part(&self.positions), part(&self.momenta)])
    }

    #[inline(always)]
    fn proceed(&mut self, by: f64) {
        let by = T::splat(by);
        let q = estrin::<T, N>(&self.positions, by);
        self.q.add(q);
        self.p.add(estrin::<T, N>(&self.momenta, by));
    }

    #[inline(always)]
    fn state(&self) -> Self::State {
        let both = |x: T| [x.first(), x.swap().first()];
        Phase::new(both(self.q.value), both(self.p.value))
    }
}

struct Trajectory<'s, const N: usize> {
    start: &'s Phase<[f64; 2]>,
    course: Course,
    see: &'s mut dyn FnMut(Phase<[f64; 2]>),
}

impl<const N: usize> PairKernel for Trajectory<'_, N> {
    type Out = u64;
    #[inline(always)]
    fn run<T: Two>(self) -> u64 {
        let zero = T::splat(0.0);
        let star = Star::<T, N> {
            tolerance: self.course.tolerance,
            q: Kept::of(T::load(&self.start.q)),
            p: Kept::of(T::load(&self.start.p)),
            positions: [zero; COEFFICIENTS],
            momenta: [zero; COEFFICIENTS],
        };
        follow(self.course, star, self.see)
    }
}

/// Follows the star, shows its states, and counts the steps.
///
/// # Panics
/// If the order is not one of [`ORDERS`](super::ORDERS).
pub fn henon_heiles(start: &Phase<[f64; 2]>, course: Course, see: &mut dyn FnMut(Phase<[f64; 2]>)) -> u64 {
    with_order!(course.order, N => enter_pair(Trajectory::<N> { start, course, see }))
}
