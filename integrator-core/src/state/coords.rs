//! Shapes of coordinates: arrays and vectors of numbers, points or planes.

use crate::{
    scalar::real::Real,
    state::{
        aligned::Aligned,
        phase::Phase,
        precision::{Precision, Slot},
    },
};
#[cfg(any(all(feature = "checkpoint", feature = "std"), feature = "output"))]
use alloc::{format, string::String};
use alloc::{vec, vec::Vec};
use core::fmt::Debug;

/// Returns the column names of `count` coordinates: `q0`, `q1` and so on.
///
/// `q0_2` is the third component of the first point; `q0_1_2` is the third site of the second row of the first plane.
#[cfg(any(all(feature = "checkpoint", feature = "std"), feature = "output"))]
pub fn column_names<C: Coords>(letter: char, count: usize) -> impl Iterator<Item = String> {
    (0..count).map(move |index| match (C::COMPONENTS, C::ROWS) {
        (0 | 1, None) | (0, _) => format!("{letter}{index}"),
        (components, None | Some(0)) => format!("{letter}{}_{}", index / components, index % components),
        (components, Some(rows)) => {
            let (plane, number, sites) = (index / components, index % components, components / rows);
            format!("{letter}{plane}_{}_{}", number / sites, number % sites)
        }
    })
}

/// The number of coordinates that are searched without a branch.
const CHUNK: usize = 256;

/// The positions or the momenta of a system, in the shape that the user wrote.
///
/// The shapes are `[K; N]`, `[[K; D]; N]`, `[[[K; L]; M]; N]`, `Vec<K>`, `Vec<[K; D]>` and `Vec<[[K; L]; M]>`. The
/// scalar type `K` is `f64`, `f32`, [`Compensated<f64>`](crate::Compensated) or [`Fixed<f64>`](crate::Fixed).
#[diagnostic::on_unimplemented(
    message = "positions and momenta have to be arrays or vectors, and these are `{Self}`",
    label = "neither an array nor a `Vec` of numbers or points",
    note = "write `[1.0]` in place of `1.0` for a single coordinate, `[[x, y], [x, y]]` for points, and `vec![...]` \
            if their number is known at run time"
)]
pub trait Coords: Clone + Debug + PartialEq + Send + Sync + 'static {
    /// The scalar type of a coordinate.
    type Leaf: Precision;
    /// The type of this shape with another scalar type.
    type With<K: Precision>: Coords<Leaf = K, With<f64> = Self::With<f64>>;
    /// The type of this shape with slots in place of coordinates.
    type Slots<R: Real>: Clone + Send + Sync + 'static;

    /// The number of scalars, points or planes, if the type fixes it.
    const LENGTH: Option<usize>;
    /// The number of components of a point, or of sites in a row of a plane; otherwise one.
    const COMPONENTS: usize;
    /// The number of rows of a plane, if the shape has planes.
    const ROWS: Option<usize> = None;

    /// Returns the number of scalars, points or planes.
    fn length(&self) -> usize;
    /// Builds coordinates from their flat form, or returns `None` if the shape has another size.
    fn from_flat(flat: Vec<Self::Leaf>) -> Option<Self>;
    /// Returns all coordinates, one point after the other.
    fn flat(&self) -> &[Self::Leaf];
    /// Returns all coordinates for writing.
    fn flat_mut(&mut self) -> &mut [Self::Leaf];
    /// Converts every coordinate to another scalar type.
    fn map<K: Precision>(&self, leaf: impl Fn(Self::Leaf) -> K) -> Self::With<K>;
    /// Creates slots for `count` coordinates, in the order of [`Coords::flat`]. An array has a fixed number of them.
    fn slots_from<R: Real>(count: usize, slot: impl Fn(usize) -> <Self::Leaf as Precision>::Slot<R>) -> Self::Slots<R>;
    /// Returns slots as a flat slice.
    fn slots<R: Real>(slots: &Self::Slots<R>) -> &[<Self::Leaf as Precision>::Slot<R>];
    /// Returns slots as a flat slice for writing.
    fn slots_mut<R: Real>(slots: &mut Self::Slots<R>) -> &mut [<Self::Leaf as Precision>::Slot<R>];
    /// Fills slots with the positions or the momenta of one state per lane.
    #[inline(always)]
    fn pack<R: Real>(states: &[&Phase<Self>], half: fn(&Phase<Self>) -> &Self) -> Self::Slots<R> {
        Self::slots_from(half(states[0]).flat().len(), |k| Self::Leaf::pack(&|lane| half(states[lane]).flat()[k]))
    }
    /// Returns the slots of the positions or the momenta of one state per lane as a list.
    fn listed<R: Real>(
        states: &[&Phase<Self>],
        half: fn(&Phase<Self>) -> &Self,
    ) -> Vec<<Self::Leaf as Precision>::Slot<R>> {
        let count = half(states[0]).flat().len();
        let mut slots = Vec::with_capacity(count);
        for k in 0..count {
            slots.push(Self::Leaf::pack(&|lane| half(states[lane]).flat()[k]));
        }
        slots
    }
    /// Returns one number per slot, in the same shape.
    #[inline(always)]
    fn numbers<R: Real>(
        slots: &Self::Slots<R>,
        number: impl Fn(<Self::Leaf as Precision>::Slot<R>) -> R,
    ) -> <Self::With<f64> as Coords>::Slots<R> {
        let slots = Self::slots(slots);
        Self::With::<f64>::slots_from(slots.len(), |k| number(slots[k]))
    }

    /// Writes one lane of `slots` into `self`.
    #[inline(always)]
    fn unpack<R: Real>(&mut self, slots: &Self::Slots<R>, lane: usize) {
        self.unlisted(Self::slots(slots), lane);
    }
    /// Writes one lane of a list of slots into `self`.
    #[inline(always)]
    fn unlisted<R: Real>(&mut self, slots: &[<Self::Leaf as Precision>::Slot<R>], lane: usize) {
        let (leaves, mut k) = (self.flat_mut(), 0);
        while k < leaves.len() {
            leaves[k] = Self::Leaf::unpack(slots[k], lane);
            k += 1;
        }
    }
    /// Whether every coordinate of every lane is finite.
    #[inline(always)]
    fn finite<R: Real>(slots: &Self::Slots<R>) -> bool {
        all_finite(Self::slots(slots))
    }
}

/// Slots of many positions or momenta: those of a single state are read from one list.
#[inline(always)]
pub(crate) fn packed<C: Coords, R: Real>(states: &[&Phase<C>], half: fn(&Phase<C>) -> &C) -> C::Slots<R> {
    let first = half(states[0]).flat();
    if const { R::LANES == 1 } {
        return C::slots_from(first.len(), |k| C::Leaf::pack(&|_| first[k]));
    }
    C::slots_from(first.len(), |k| C::Leaf::pack(&|lane| half(states[lane]).flat()[k]))
}

/// Whether all slots are finite in every lane.
#[inline(always)]
pub(crate) fn all_finite<R: Real, S: Slot<R>>(slots: &[S]) -> bool {
    // In chunks without a branch, so that the search is vectorised.
    for chunk in slots.chunks(CHUNK) {
        let mut finite = true;
        for slot in chunk {
            finite &= slot.value().finite();
        }
        if !finite {
            return false;
        }
    }
    true
}

impl<K: Precision, const N: usize> Coords for [K; N] {
    type Leaf = K;
    type With<L: Precision> = [L; N];
    type Slots<R: Real> = [K::Slot<R>; N];

    const LENGTH: Option<usize> = Some(N);
    const COMPONENTS: usize = 1;

    fn length(&self) -> usize {
        self.len()
    }
    fn from_flat(flat: Vec<K>) -> Option<Self> {
        flat.try_into().ok()
    }
    fn flat(&self) -> &[K] {
        self
    }
    fn flat_mut(&mut self) -> &mut [K] {
        self
    }
    fn map<L: Precision>(&self, leaf: impl Fn(K) -> L) -> [L; N] {
        let mut mapped = [L::default(); N];
        for (mapped, own) in mapped.iter_mut().zip(self) {
            *mapped = leaf(*own);
        }
        mapped
    }
    #[inline(always)]
    fn slots_from<R: Real>(_count: usize, slot: impl Fn(usize) -> K::Slot<R>) -> [K::Slot<R>; N] {
        let mut slots = [Slot::zero(); N];
        for (k, to) in slots.iter_mut().enumerate() {
            *to = slot(k);
        }
        slots
    }
    #[inline(always)]
    fn slots<R: Real>(slots: &Self::Slots<R>) -> &[K::Slot<R>] {
        slots
    }
    #[inline(always)]
    fn slots_mut<R: Real>(slots: &mut Self::Slots<R>) -> &mut [K::Slot<R>] {
        slots
    }
}

impl<K: Precision, const D: usize, const N: usize> Coords for [[K; D]; N] {
    type Leaf = K;
    type With<L: Precision> = [[L; D]; N];
    type Slots<R: Real> = [[K::Slot<R>; D]; N];

    const LENGTH: Option<usize> = Some(N);
    const COMPONENTS: usize = D;

    fn length(&self) -> usize {
        self.len()
    }
    fn from_flat(flat: Vec<K>) -> Option<Self> {
        let (points, rest) = flat.as_chunks::<D>();
        if rest.is_empty() { points.try_into().ok() } else { None }
    }
    fn flat(&self) -> &[K] {
        self.as_flattened()
    }
    fn flat_mut(&mut self) -> &mut [K] {
        self.as_flattened_mut()
    }
    fn map<L: Precision>(&self, leaf: impl Fn(K) -> L) -> [[L; D]; N] {
        let mut mapped = [[L::default(); D]; N];
        for (mapped, own) in mapped.as_flattened_mut().iter_mut().zip(self.flat()) {
            *mapped = leaf(*own);
        }
        mapped
    }
    #[inline(always)]
    fn slots_from<R: Real>(_count: usize, slot: impl Fn(usize) -> K::Slot<R>) -> [[K::Slot<R>; D]; N] {
        let mut slots = [[Slot::zero(); D]; N];
        for (k, to) in slots.as_flattened_mut().iter_mut().enumerate() {
            *to = slot(k);
        }
        slots
    }
    #[inline(always)]
    fn slots<R: Real>(slots: &Self::Slots<R>) -> &[K::Slot<R>] {
        slots.as_flattened()
    }
    #[inline(always)]
    fn slots_mut<R: Real>(slots: &mut Self::Slots<R>) -> &mut [K::Slot<R>] {
        slots.as_flattened_mut()
    }
}

impl<K: Precision> Coords for Vec<K> {
    type Leaf = K;
    type With<L: Precision> = Vec<L>;
    type Slots<R: Real> = Aligned<K::Slot<R>>;

    const LENGTH: Option<usize> = None;
    const COMPONENTS: usize = 1;

    fn length(&self) -> usize {
        self.len()
    }
    fn from_flat(flat: Vec<K>) -> Option<Self> {
        Some(flat)
    }
    fn flat(&self) -> &[K] {
        self
    }
    fn flat_mut(&mut self) -> &mut [K] {
        self
    }
    fn map<L: Precision>(&self, leaf: impl Fn(K) -> L) -> Vec<L> {
        let mut mapped = Vec::with_capacity(self.len());
        for own in self {
            mapped.push(leaf(*own));
        }
        mapped
    }
    #[inline(always)]
    fn slots_from<R: Real>(count: usize, slot: impl Fn(usize) -> K::Slot<R>) -> Self::Slots<R> {
        let (mut slots, mut number) = (Aligned::filled(count, Slot::zero()), 0);
        for to in slots.iter_mut() {
            *to = slot(number);
            number += 1;
        }
        slots
    }
    #[inline(always)]
    fn pack<R: Real>(states: &[&Phase<Self>], half: fn(&Phase<Self>) -> &Self) -> Self::Slots<R> {
        packed::<Self, R>(states, half)
    }
    fn slots<R: Real>(slots: &Self::Slots<R>) -> &[K::Slot<R>] {
        slots
    }
    fn slots_mut<R: Real>(slots: &mut Self::Slots<R>) -> &mut [K::Slot<R>] {
        slots
    }
}

impl<K: Precision, const D: usize> Coords for Vec<[K; D]> {
    type Leaf = K;
    type With<L: Precision> = Vec<[L; D]>;
    type Slots<R: Real> = Aligned<[K::Slot<R>; D]>;

    const LENGTH: Option<usize> = None;
    const COMPONENTS: usize = D;

    fn length(&self) -> usize {
        self.len()
    }
    fn from_flat(flat: Vec<K>) -> Option<Self> {
        let (points, rest) = flat.as_chunks::<D>();
        rest.is_empty().then(|| points.to_vec())
    }
    fn flat(&self) -> &[K] {
        self.as_flattened()
    }
    fn flat_mut(&mut self) -> &mut [K] {
        self.as_flattened_mut()
    }
    fn map<L: Precision>(&self, leaf: impl Fn(K) -> L) -> Vec<[L; D]> {
        let mut mapped = vec![[L::default(); D]; self.len()];
        for (mapped, own) in mapped.as_flattened_mut().iter_mut().zip(self.flat()) {
            *mapped = leaf(*own);
        }
        mapped
    }
    #[inline(always)]
    fn slots_from<R: Real>(count: usize, slot: impl Fn(usize) -> K::Slot<R>) -> Self::Slots<R> {
        let points = count.checked_div(D).unwrap_or(0);
        let (mut slots, mut number) = (Aligned::filled(points, [Slot::zero(); D]), 0);
        for to in slots.as_flattened_mut() {
            *to = slot(number);
            number += 1;
        }
        slots
    }
    #[inline(always)]
    fn pack<R: Real>(states: &[&Phase<Self>], half: fn(&Phase<Self>) -> &Self) -> Self::Slots<R> {
        packed::<Self, R>(states, half)
    }
    fn slots<R: Real>(slots: &Self::Slots<R>) -> &[K::Slot<R>] {
        slots.as_flattened()
    }
    fn slots_mut<R: Real>(slots: &mut Self::Slots<R>) -> &mut [K::Slot<R>] {
        slots.as_flattened_mut()
    }
}
