//! The way along a trajectory, from polynomial to polynomial.

use crate::vector::Vector;

/// The orders that there are hand-written steppers of.
pub const ORDERS: [usize; 3] = [16, 20, 24];

/// The highest of them.
pub(crate) const HIGHEST: usize = 24;

/// How many coefficients small systems have room for: those of accelerations belong to positions two orders above.
pub(crate) const COEFFICIENTS: usize = HIGHEST + 2;

/// A method, and how long and how often it is looked at.
#[derive(Clone, Copy, Debug)]
pub struct Course {
    /// One of [`ORDERS`].
    pub order: usize,
    /// The share of a coordinate's size that the last coefficients may add.
    pub tolerance: f64,
    /// How long a trajectory is followed.
    pub span: f64,
    /// In how many equal parts; a state is shown after each.
    pub looks: u32,
}

/// A motion that is a polynomial for a while.
pub(crate) trait Expansion: Clone {
    /// What it shows.
    type State;
    /// Finds the coefficients where it is, and how far they reach.
    fn expand(&mut self) -> f64;
    /// Goes on along the polynomial.
    fn proceed(&mut self, by: f64);
    /// Where it is.
    fn state(&self) -> Self::State;
}

/// Shows the states, and counts the polynomials.
#[inline(always)]
pub(crate) fn follow<E: Expansion>(course: Course, mut expansion: E, see: &mut dyn FnMut(E::State)) -> u64 {
    // The time of the expansion in twice the precision: reaches of all lengths are added up.
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

/// Calls `$do!(k)` for every order from 1 on that a hand-written stepper may compute, as a literal, so that all sums
/// are written out.
macro_rules! orders_from_one {
    ($do:ident) => {
        $do! { 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 }
    };
}
pub(crate) use orders_from_one;

/// Numbers and what their updates have lost so far (Kahan 1965).
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
