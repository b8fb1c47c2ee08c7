//! Common code of Hénon–Heiles and Kepler: two coordinates in the lanes of a register.

use super::{
    course::{COEFFICIENTS, Course, Expansion, Kept, follow},
    estrin::estrin,
    horizon::{Sizes, reach},
};
use crate::{enter::PairKernel, vector::Two};
use integrator_core::Phase;
use std::marker::PhantomData;

/// The force on a particle of mass 1.
pub(crate) trait Force: Clone {
    /// Computes the coefficients of positions up to order `N + 1` and of momenta up to `N` from position and momentum.
    fn orders<T: Two, const N: usize>(
        begin: [T; 2],
        positions: &mut [T; COEFFICIENTS],
        momenta: &mut [T; COEFFICIENTS],
    );
}

#[derive(Clone)]
struct Point<F, T, const N: usize> {
    tolerance: f64,
    q: Kept<T>,
    p: Kept<T>,
    /// Coefficients of positions.
    positions: [T; COEFFICIENTS],
    /// Coefficients of momenta.
    momenta: [T; COEFFICIENTS],
    force: PhantomData<F>,
}

impl<F: Force, T: Two, const N: usize> Expansion for Point<F, T, N> {
    type State = Phase<[f64; 2]>;

    #[inline(always)]
    fn expand(&mut self) -> f64 {
        F::orders::<T, N>([self.q.value, self.p.value], &mut self.positions, &mut self.momenta);
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
        self.q.add(estrin::<T, N>(&self.positions, by));
        self.p.add(estrin::<T, N>(&self.momenta, by));
    }

    #[inline(always)]
    fn state(&self) -> Self::State {
        let both = |x: T| [x.first(), x.swap().first()];
        Phase::new(both(self.q.value), both(self.p.value))
    }
}

/// Integration of such a particle.
pub(crate) struct Trajectory<'s, F, const N: usize> {
    start: &'s Phase<[f64; 2]>,
    course: Course,
    see: &'s mut dyn FnMut(Phase<[f64; 2]>),
    force: PhantomData<F>,
}

impl<'s, F, const N: usize> Trajectory<'s, F, N> {
    pub(crate) fn new(start: &'s Phase<[f64; 2]>, course: Course, see: &'s mut dyn FnMut(Phase<[f64; 2]>)) -> Self {
        Self { start, course, see, force: PhantomData }
    }
}

impl<F: Force, const N: usize> PairKernel for Trajectory<'_, F, N> {
    type Out = u64;
    #[inline(always)]
    fn run<T: Two>(self) -> u64 {
        let zero = T::splat(0.0);
        let point = Point::<F, T, N> {
            tolerance: self.course.tolerance,
            q: Kept::of(T::load(&self.start.q)),
            p: Kept::of(T::load(&self.start.p)),
            positions: [zero; COEFFICIENTS],
            momenta: [zero; COEFFICIENTS],
            force: PhantomData,
        };
        follow(self.course, point, self.see)
    }
}
