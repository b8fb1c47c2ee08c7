//! Coordinates in consecutive planes of sites.

use crate::{
    scalar::real::Real,
    state::{
        aligned::Aligned,
        coords::{Coords, packed},
        phase::Phase,
        precision::{Precision, Slot},
    },
};
use alloc::{vec, vec::Vec};

impl<K: Precision, const L: usize, const M: usize, const N: usize> Coords for [[[K; L]; M]; N] {
    type Leaf = K;
    type With<T: Precision> = [[[T; L]; M]; N];
    type Slots<R: Real> = [[[K::Slot<R>; L]; M]; N];

    const LENGTH: Option<usize> = Some(N);
    const COMPONENTS: usize = M * L;
    const ROWS: Option<usize> = Some(M);

    fn length(&self) -> usize {
        self.len()
    }
    fn from_flat(flat: Vec<K>) -> Option<Self> {
        let planes = Vec::<[[K; L]; M]>::from_flat(flat)?;
        planes.try_into().ok()
    }
    fn flat(&self) -> &[K] {
        self.as_flattened().as_flattened()
    }
    fn flat_mut(&mut self) -> &mut [K] {
        self.as_flattened_mut().as_flattened_mut()
    }
    fn map<T: Precision>(&self, leaf: impl Fn(K) -> T) -> [[[T; L]; M]; N] {
        let mut mapped = [[[T::default(); L]; M]; N];
        for (mapped, own) in mapped.flat_mut().iter_mut().zip(self.flat()) {
            *mapped = leaf(*own);
        }
        mapped
    }
    #[inline(always)]
    fn slots_from<R: Real>(_count: usize, slot: impl Fn(usize) -> K::Slot<R>) -> Self::Slots<R> {
        let mut slots = [[[Slot::zero(); L]; M]; N];
        for (k, to) in slots.as_flattened_mut().as_flattened_mut().iter_mut().enumerate() {
            *to = slot(k);
        }
        slots
    }
    #[inline(always)]
    fn slots<R: Real>(slots: &Self::Slots<R>) -> &[K::Slot<R>] {
        slots.as_flattened().as_flattened()
    }
    #[inline(always)]
    fn slots_mut<R: Real>(slots: &mut Self::Slots<R>) -> &mut [K::Slot<R>] {
        slots.as_flattened_mut().as_flattened_mut()
    }
}

impl<K: Precision, const L: usize, const M: usize> Coords for Vec<[[K; L]; M]> {
    type Leaf = K;
    type With<T: Precision> = Vec<[[T; L]; M]>;
    type Slots<R: Real> = Aligned<[[K::Slot<R>; L]; M]>;

    const LENGTH: Option<usize> = None;
    const COMPONENTS: usize = M * L;
    const ROWS: Option<usize> = Some(M);

    fn length(&self) -> usize {
        self.len()
    }
    fn from_flat(flat: Vec<K>) -> Option<Self> {
        let (rows, rest) = flat.as_chunks::<L>();
        let (planes, rows) = rows.as_chunks::<M>();
        (rest.is_empty() && rows.is_empty()).then(|| planes.to_vec())
    }
    fn flat(&self) -> &[K] {
        self.as_flattened().as_flattened()
    }
    fn flat_mut(&mut self) -> &mut [K] {
        self.as_flattened_mut().as_flattened_mut()
    }
    fn map<T: Precision>(&self, leaf: impl Fn(K) -> T) -> Vec<[[T; L]; M]> {
        let mut mapped = vec![[[T::default(); L]; M]; self.len()];
        for (mapped, own) in mapped.flat_mut().iter_mut().zip(self.flat()) {
            *mapped = leaf(*own);
        }
        mapped
    }
    #[inline(always)]
    fn slots_from<R: Real>(count: usize, slot: impl Fn(usize) -> K::Slot<R>) -> Self::Slots<R> {
        let planes = count.checked_div(M * L).unwrap_or(0);
        let (mut slots, mut number) = (Aligned::filled(planes, [[Slot::zero(); L]; M]), 0);
        for to in slots.as_flattened_mut().as_flattened_mut() {
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
        slots.as_flattened().as_flattened()
    }
    fn slots_mut<R: Real>(slots: &mut Self::Slots<R>) -> &mut [K::Slot<R>] {
        slots.as_flattened_mut().as_flattened_mut()
    }
}
