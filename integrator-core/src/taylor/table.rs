//! The Taylor coefficients of all coordinates of a part of the state.

use super::series::{COEFFICIENTS, over};
use crate::{aligned::Aligned, coords::Coords, real::Real, row::Row};
use core::ops::{Index, IndexMut};

/// How many coordinates are computed on at once.
pub(super) const EIGHT: usize = 8;

/// Eight numbers side by side.
pub(super) type Eight<R> = <R as Real>::Row<EIGHT>;

/// Up to how many coordinates lie close together; rows of more begin where a register is read at once.
pub(super) const FEW: usize = 4;

/// How coordinates lie in the rows of a table.
#[derive(Clone, Copy)]
pub struct Layout {
    /// How many numbers or points there are.
    length: usize,
    components: usize,
    /// How far a component of the points is from the next one.
    stride: usize,
    /// How far the coefficients of one order are from those of the next.
    width: usize,
}

impl Layout {
    /// For so many numbers or points: a number that code knows, where the type tells it.
    #[inline(always)]
    pub fn of<C: Coords>(length: usize) -> Self {
        let length = C::LENGTH.unwrap_or(length);
        let components = C::COMPONENTS;
        let few = length * components <= FEW;
        let stride = if few { length } else { length.next_multiple_of(EIGHT) };
        Self { length, components, stride, width: components * stride }
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
    /// The coordinate in a place: components one after the other, each of all points. Places beyond the last point
    /// repeat it.
    pub(super) fn coordinate(self, place: usize) -> usize {
        (place % self.stride).min(self.length - 1) * self.components + place / self.stride
    }
    /// Where a coordinate is in a row.
    pub fn place(self, coordinate: usize) -> usize {
        coordinate % self.components * self.stride + coordinate / self.components
    }
}

/// The coefficients by order and coordinate.
pub struct Table<R> {
    numbers: Aligned<R>,
}

impl<R: Real> Table<R> {
    /// Room for coefficients that lie so.
    pub fn new(layout: Layout) -> Self {
        Self { numbers: Aligned::new(COEFFICIENTS * layout.width, |_| R::of(0.0)) }
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
        if self.layout.is_few() {
            for number in &mut self[order] {
                *number = over(*number, order);
            }
        } else {
            for numbers in self[order].chunks_exact_mut(EIGHT) {
                over(<Eight<R> as Row<R>>::read(numbers), order).write(numbers);
            }
        }
    }

    /// Whether coordinates are so few that they are not computed on in registers.
    #[inline(always)]
    pub(super) fn is_few(&self) -> bool {
        self.layout.is_few()
    }

    /// How far a component of the points is from the next one.
    #[inline(always)]
    pub fn stride(&self) -> usize {
        self.layout.stride
    }
}
