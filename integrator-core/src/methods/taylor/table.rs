//! The Taylor coefficients of all coordinates of a part of the state.

use super::series::{COEFFICIENTS, over};
use crate::{
    scalar::{real::Real, simd::row::Row},
    state::{aligned::Aligned, coords::Coords},
};
use core::{
    num::NonZero,
    ops::{Index, IndexMut},
};

/// How many coordinates lie side by side.
pub(super) const EIGHT: usize = 8;

/// Numbers that are computed on at once: eight side by side, or one.
pub(super) type Wide<R> = <R as Real>::Wide;

/// Whether numbers are computed on one by one.
pub(super) const fn is_narrow<R: Real>() -> bool {
    Wide::<R>::LANES == R::LANES
}

/// Up to how many coordinates lie close together; rows of more begin where a register is read at once.
pub(super) const FEW: usize = 4;

/// Whether coordinates lie close together.
const fn are_few(length: usize, components: usize) -> bool {
    length * components <= FEW
}

/// Whether all coordinates of a type do.
pub(super) const fn are_always_few<C: Coords>() -> bool {
    match C::LENGTH {
        Some(length) => are_few(length, C::COMPONENTS),
        None => false,
    }
}

/// How coordinates lie in the rows of a table: components one after the other, each of all points.
#[derive(Clone, Copy)]
pub struct Layout {
    /// How many numbers or points there are.
    length: usize,
    components: usize,
    interleaved: bool,
    /// To how many registers points are dealt out, one after the other; one, where neighbours lie side by side.
    registers: NonZero<usize>,
    /// How far a component of the points is from the next one.
    stride: usize,
    /// How far the coefficients of one order are from those of the next.
    width: usize,
}

impl Layout {
    /// For so many numbers or points: a number that code knows, where the type tells it. Interleaved, points lie
    /// in the same lanes of registers as those a little further on, so that what reads points and their neighbours reads
    /// whole registers.
    #[inline(always)]
    pub fn of<C: Coords>(length: usize, interleaved: bool) -> Self {
        let length = C::LENGTH.unwrap_or(length);
        let components = C::COMPONENTS;
        let few = are_few(length, components);
        let stride = if few { length } else { length.next_multiple_of(EIGHT) };
        let registers = if interleaved && !few { NonZero::new(stride / EIGHT) } else { None };
        let registers = registers.unwrap_or(NonZero::<usize>::MIN);
        Self { length, components, interleaved, registers, stride, width: components * stride }
    }
    /// How many numbers or points there are.
    #[inline(always)]
    pub(super) fn length(self) -> usize {
        self.length
    }
    /// Whether coordinates are so few that they are not computed on in registers.
    #[inline(always)]
    pub(super) fn is_few(self) -> bool {
        self.width <= FEW
    }
    /// How many places there are in a row.
    #[inline(always)]
    pub(super) fn width(self) -> usize {
        self.width
    }
    /// How far a component of the points is from the next one.
    #[inline(always)]
    pub(super) fn stride(self) -> usize {
        self.stride
    }
    /// Whether points lie where what reads their neighbours reads whole registers.
    pub(super) fn is_interleaved(self) -> bool {
        self.interleaved
    }
    /// The coordinate in a place. Places that no point has repeat the last one.
    pub(super) fn coordinate(self, place: usize) -> usize {
        let (component, within) = (place / self.stride, place % self.stride);
        let point = match self.registers.get() {
            1 => within,
            registers => within % EIGHT * registers + within / EIGHT,
        };
        point.min(self.length - 1) * self.components + component
    }
    /// Where a component of a point is in a row.
    #[inline(always)]
    pub fn place(self, point: usize, component: usize) -> usize {
        let within = match self.registers.get() {
            1 => point,
            _ => point % self.registers * EIGHT + point / self.registers,
        };
        component * self.stride + within
    }
    /// Where a coordinate is in a row.
    pub fn place_of(self, coordinate: usize) -> usize {
        self.place(coordinate / self.components, coordinate % self.components)
    }
}

/// The coefficients by order and coordinate.
pub struct Table<R> {
    numbers: Aligned<R>,
}

impl<R: Real> Table<R> {
    /// Room for coefficients that lie so.
    pub fn new(layout: Layout) -> Self {
        Self { numbers: Aligned::new(COEFFICIENTS * layout.width, &|_| R::of(0.0)) }
    }
    /// The coefficients.
    #[inline(always)]
    pub fn of(&mut self, layout: Layout) -> Coefficients<'_, R> {
        Coefficients { numbers: self.numbers_mut(layout), layout }
    }
    /// All of them, order by order.
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

/// Room for the coefficients of a few coordinates, which the compiler holds in registers where it knows the orders.
#[derive(Clone, Copy)]
pub(super) struct Rows<R> {
    numbers: [R; COEFFICIENTS * FEW],
}

impl<R: Real> Rows<R> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self { numbers: [R::of(0.0); COEFFICIENTS * FEW] }
    }
    /// The coefficients.
    #[inline(always)]
    pub(super) fn of(&mut self, layout: Layout) -> Coefficients<'_, R> {
        Coefficients { numbers: &mut self.numbers, layout }
    }
}

/// The coefficients of the coordinates by order; in each order, components one after the other.
pub struct Coefficients<'t, R> {
    numbers: &'t mut [R],
    layout: Layout,
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

impl<R: Real> Coefficients<'_, R> {
    /// Divides the coefficients of an order by it.
    #[inline(always)]
    pub fn divide(&mut self, order: usize) {
        if const { is_narrow::<R>() } || self.layout.is_few() {
            for number in &mut self[order] {
                *number = over(*number, order);
            }
        } else {
            for numbers in self[order].chunks_exact_mut(EIGHT) {
                over(<Wide<R> as Row<R>>::read(numbers), order).write(numbers);
            }
        }
    }

    /// Whether coordinates are so few that they are not computed on in registers.
    #[inline(always)]
    pub(super) fn is_few(&self) -> bool {
        self.layout.is_few()
    }

    /// How coordinates lie in a row.
    #[inline(always)]
    pub fn layout(&self) -> Layout {
        self.layout
    }

    /// How far a component of the points is from the next one.
    #[inline(always)]
    pub fn stride(&self) -> usize {
        self.layout.stride
    }
}
