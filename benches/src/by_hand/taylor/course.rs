//! Integration along a trajectory, from one Taylor polynomial to the next.

use crate::vector::Vector;

/// Orders of the hand-written steppers.
pub const ORDERS: [usize; 3] = [16, 20, 24];

/// The highest of these orders.
pub(crate) const HIGHEST: usize = 24;

/// Number of coefficients in small systems. Accelerations give the coefficients of positions two orders higher.
pub(crate) const COEFFICIENTS: usize = HIGHEST + 2;

/// Parameters of an integration.
#[derive(Clone, Copy, Debug)]
pub struct Course {
    /// One of [`ORDERS`].
    pub order: usize,
    /// Relative size of the last coefficients' contributions to a coordinate.
    pub tolerance: f64,
    /// Duration of the integration.
    pub span: f64,
    /// Number of equal intervals; a state is passed on after each.
    pub looks: u32,
}

/// A state with its Taylor polynomial.
pub(crate) trait Expansion: Clone {
    /// State passed to the caller.
    type State;
    /// Computes the coefficients at the current state. Returns the step for which they are valid.
    fn expand(&mut self) -> f64;
    /// Advances the state along the polynomial.
    fn proceed(&mut self, by: f64);
    /// Returns the current state.
    fn state(&self) -> Self::State;
}

/// Passes the states to `see`, and returns the number of polynomials.
#[inline(always)]
pub(crate) fn follow<E: Expansion>(course: Course, mut expansion: E, see: &mut dyn FnMut(E::State)) -> u64 {
    // Time of the expansion in doubled precision, because steps of very different lengths are added.
    let (mut begin, mut lost) = (0.0, 0.0);
    let mut reach = expansion.expand();
    let mut polynomials = 1;
    for look in 1..=course.looks {
        let end = course.span * f64::from(look) / f64::from(course.looks);
        loop {
            let ahead = (end - begin) - lost;
            if ahead <= reach {
                let mut there = expansion.clone();
                there.proceed(ahead);
                see(there.state());
                break;
            }
            expansion.proceed(reach);
            let next = begin + reach;
            let back = next - begin;
            lost += (begin - (next - back)) + (reach - back);
            begin = next;
            reach = expansion.expand();
            polynomials += 1;
        }
    }
    polynomials
}

/// Calls `$of::<N>` with the order as a constant.
macro_rules! with_order {
    ($order:expr, $of:ident => $call:expr) => {
        match $order {
            16 => {
                const $of: usize = 16;
                $call
            }
            20 => {
                const $of: usize = 20;
                $call
            }
            24 => {
                const $of: usize = 24;
                $call
            }
            order => panic!("there is no hand-written stepper of order {order}"),
        }
    };
}
pub(crate) use with_order;

/// Calls `$do!(k)` for every order from 1 to the highest one, as a literal, so that all sums are unrolled.
macro_rules! orders_from_one {
    ($do:ident) => {
        $do! { 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 }
    };
}
pub(crate) use orders_from_one;

/// Values and their accumulated rounding errors (Kahan 1965).
#[derive(Clone, Copy)]
pub(crate) struct Kept<V> {
    pub(crate) value: V,
    carried: V,
}

impl<V: Vector> Kept<V> {
    #[inline(always)]
    pub(crate) fn of(value: V) -> Self {
        Self { value, carried: V::splat(0.0) }
    }
    #[inline(always)]
    pub(crate) fn add(&mut self, change: V) {
        let update = change + self.carried;
        let sum = self.value + update;
        self.carried = update - (sum - self.value);
        self.value = sum;
    }
}
