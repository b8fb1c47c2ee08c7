//! The Taylor coefficients of all positions, or of all momenta.

use super::series::{COEFFICIENTS, scaled_by_order, scaled_by_two_orders};
use crate::{
    scalar::{real::Real, simd::row::Row},
    state::{aligned::Aligned, coords::Coords},
};
use alloc::vec::Vec;
use core::{
    num::NonZero,
    ops::{Index, IndexMut},
};

/// The lanes of a vector of coordinates.
pub(super) const EIGHT: usize = 8;

/// A vector of eight numbers, or one number.
pub type Wide<R> = <R as Real>::Wide;

/// Whether numbers are computed one by one.
pub(super) const fn is_narrow<R: Real>() -> bool {
    Wide::<R>::LANES == R::LANES
}

/// The most coordinates that are stored without padding; larger order slices are padded to whole vectors.
pub(super) const FEW: usize = 4;

/// Whether coordinates are stored without padding.
const fn are_few(length: usize, components: usize) -> bool {
    length * components <= FEW
}

/// Whether all coordinates of a type are stored without padding.
pub(super) const fn are_always_few<C: Coords>() -> bool {
    match C::LENGTH {
        Some(length) => are_few(length, C::COMPONENTS),
        None => false,
    }
}

/// The layout of an order slice: components one after the other, each of all points.
#[derive(Clone, Copy)]
pub struct Layout {
    /// The number of numbers or points.
    length: usize,
    components: usize,
    interleaved: bool,
    /// The number of vectors over which points are distributed cyclically; one, where neighbours share vectors.
    vectors: NonZero<usize>,
    /// The distance from a component of the points to the next one.
    stride: usize,
    /// The length of an order slice.
    width: usize,
}

impl Layout {
    /// The layout of this number of numbers or points: a compile-time constant, where the type has it. Interleaved,
    /// points are in the same lanes as their neighbours, so that iterations over points and neighbours read whole
    /// vectors.
    #[inline(always)]
    pub fn of<C: Coords>(length: usize, interleaved: bool) -> Self {
        let length = C::LENGTH.unwrap_or(length);
        let components = C::COMPONENTS;
        let few = are_few(length, components);
        let stride = if few { length } else { length.next_multiple_of(EIGHT) };
        let vectors = if interleaved && !few { NonZero::new(stride / EIGHT) } else { None };
        let vectors = vectors.unwrap_or(NonZero::<usize>::MIN);
        Self { length, components, interleaved, vectors, stride, width: components * stride }
    }
    /// The number of numbers or points.
    #[inline(always)]
    pub(super) fn length(self) -> usize {
        self.length
    }
    /// Whether coordinates are too few to be computed in vectors.
    #[inline(always)]
    pub(super) fn is_few(self) -> bool {
        self.width <= FEW
    }
    /// The length of an order slice, with padding.
    #[inline(always)]
    pub(super) fn width(self) -> usize {
        self.width
    }
    /// The distance from a component of the points to the next one.
    #[inline(always)]
    pub(super) fn stride(self) -> usize {
        self.stride
    }
    /// Whether neighbours are in the same lanes of different vectors.
    pub(super) fn is_interleaved(self) -> bool {
        self.interleaved
    }
    /// The coordinate at an index of an order slice. Padding repeats the last one.
    pub(super) fn coordinate(self, index: usize) -> usize {
        let (component, within) = (index / self.stride, index % self.stride);
        let point = match self.vectors.get() {
            1 => within,
            vectors => within % EIGHT * vectors + within / EIGHT,
        };
        point.min(self.length - 1) * self.components + component
    }
    /// The index of a component of a point in an order slice.
    #[inline(always)]
    pub fn index(self, point: usize, component: usize) -> usize {
        let within = match self.vectors.get() {
            1 => point,
            _ => point % self.vectors * EIGHT + point / self.vectors,
        };
        component * self.stride + within
    }
    /// The index of the component of the point that is nearest to these in an order slice.
    pub fn near(self, point: i64, component: i64) -> usize {
        let nearest = |number: i64, count: usize| (number.max(0) as usize).min(count.saturating_sub(1));
        self.index(nearest(point, self.length), nearest(component, self.components))
    }
    /// The number of coordinates.
    pub(super) fn coordinates(self) -> usize {
        self.length * self.components
    }
    /// Values of all coordinates in the order of an order slice.
    pub(super) fn arranged<V: Copy>(self, values: &[V]) -> Vec<V> {
        (0..self.width).map(|index| values[self.coordinate(index)]).collect()
    }
    /// The index of a coordinate in an order slice.
    pub fn index_of(self, coordinate: usize) -> usize {
        self.index(coordinate / self.components, coordinate % self.components)
    }
}

/// The coefficients by order and coordinate.
pub struct Table<R> {
    numbers: Aligned<R>,
}

impl<R: Real> Table<R> {
    /// Coefficients that are zero.
    pub fn new(layout: Layout) -> Self {
        Self { numbers: Aligned::filled(COEFFICIENTS * layout.width, R::of(0.0)) }
    }
    /// The coefficients by order, in a unit of time that is a power of two.
    #[inline(always)]
    pub fn of(&mut self, layout: Layout, unit: R) -> Coefficients<'_, R> {
        Coefficients { numbers: self.numbers_mut(layout), layout, unit }
    }
    /// Returns all coefficients, order by order.
    #[inline(always)]
    pub(super) fn numbers_mut(&mut self, layout: Layout) -> &mut [R] {
        &mut self.numbers[..COEFFICIENTS * layout.width]
    }
    /// The coefficients of an order.
    #[inline(always)]
    pub(super) fn order(&self, layout: Layout, order: usize) -> &[R] {
        &self.numbers[order * layout.width..][..layout.width]
    }
}

impl<R: Copy> Clone for Table<R> {
    fn clone(&self) -> Self {
        Self { numbers: self.numbers.clone() }
    }
    fn clone_from(&mut self, from: &Self) {
        self.numbers.clone_from(&from.numbers);
    }
}

/// The table of a few coordinates, which the compiler holds in registers where it knows the orders.
#[derive(Clone, Copy)]
pub(super) struct SmallTable<R> {
    numbers: [R; COEFFICIENTS * FEW],
}

impl<R: Real> SmallTable<R> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self { numbers: [R::of(0.0); COEFFICIENTS * FEW] }
    }
    /// The coefficients, in a unit of time that is a power of two.
    #[inline(always)]
    pub(super) fn of(&mut self, layout: Layout, unit: R) -> Coefficients<'_, R> {
        Coefficients { numbers: &mut self.numbers, layout, unit }
    }
}

/// The coefficients of the coordinates by order; in each order, components one after the other. Those of order `k` are
/// multiplied by the `k`-th power of the unit of time, a power of two near a step, so that they neither overflow nor
/// underflow.
pub struct Coefficients<'t, R> {
    numbers: &'t mut [R],
    layout: Layout,
    unit: R,
}

impl<R> Index<usize> for Coefficients<'_, R> {
    type Output = [R];

    #[inline(always)]
    fn index(&self, order: usize) -> &[R] {
        &self.numbers[order * self.layout.width..][..self.layout.width]
    }
}

impl<R> IndexMut<usize> for Coefficients<'_, R> {
    #[inline(always)]
    fn index_mut(&mut self, order: usize) -> &mut [R] {
        &mut self.numbers[order * self.layout.width..][..self.layout.width]
    }
}

impl<'t, R: Real> Coefficients<'t, R> {
    /// The coefficients of order 0 alone.
    pub(super) fn of_values(numbers: &'t mut [R], layout: Layout) -> Self {
        Self { numbers, layout, unit: R::of(1.0) }
    }
}

impl<R: Real> Coefficients<'_, R> {
    /// The unit of time.
    #[inline(always)]
    pub fn unit(&self) -> R {
        self.unit
    }

    /// Returns the coefficient of an order of a coordinate, from that of its derivative of the order below.
    #[inline(always)]
    pub fn integral<W: Row<R>>(&self, derivative: W, order: usize) -> W {
        scaled_by_order(derivative, W::splat(self.unit), order)
    }

    /// Returns the coefficient of the order above of a coordinate, from that of its second derivative of the order below.
    #[inline(always)]
    pub fn second_integral<W: Row<R>>(&self, derivative: W, order: usize) -> W {
        scaled_by_two_orders(derivative, W::splat(self.unit * self.unit), order)
    }

    /// Returns [`Self::second_integral`] times the order above.
    #[inline(always)]
    pub fn rate<W: Row<R>>(&self, derivative: W, order: usize) -> W {
        scaled_by_order(derivative, W::splat(self.unit * self.unit), order)
    }

    /// Makes coefficients of an order from those of the derivatives.
    #[inline(always)]
    pub fn integrate(&mut self, order: usize) {
        let unit = self.unit;
        if const { is_narrow::<R>() } || self.layout.is_few() {
            for number in &mut self[order] {
                *number = scaled_by_order(*number, unit, order);
            }
        } else {
            let unit = <Wide<R> as Row<R>>::splat(unit);
            for numbers in self[order].chunks_exact_mut(EIGHT) {
                scaled_by_order(<Wide<R> as Row<R>>::read(numbers), unit, order).write(numbers);
            }
        }
    }

    /// Whether coordinates are too few to be computed in vectors.
    #[inline(always)]
    pub(super) fn is_few(&self) -> bool {
        self.layout.is_few()
    }

    /// The layout of an order slice.
    #[inline(always)]
    pub fn layout(&self) -> Layout {
        self.layout
    }

    /// The distance from a component of the points to the next one.
    #[inline(always)]
    pub fn stride(&self) -> usize {
        self.layout.stride
    }
}
