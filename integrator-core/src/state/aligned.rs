//! Aligned arrays, which begin at the border of a cache line.

use alloc::vec::Vec;
use core::ops::{Deref, DerefMut};

/// The size of a cache line in bytes; no register is longer. A load across the border of two lines takes two accesses.
const LINE: usize = 64;

/// An array on the heap whose first element is the first of a cache line.
pub struct Aligned<T> {
    /// The elements, after as many unused ones as the alignment takes.
    elements: Vec<T>,
    first: usize,
}

impl<T: Copy> Aligned<T> {
    /// The array with the same element this number of times.
    pub(crate) fn filled(length: usize, element: T) -> Self {
        let (mut elements, first) = Self::room(length);
        elements.resize(first + length, element);
        Self { elements, first }
    }

    /// Room for this number of elements, and how many unused ones are before them.
    fn room(length: usize) -> (Vec<T>, usize) {
        if length == 0 {
            return (Vec::new(), 0);
        }
        let size = size_of::<T>().max(1);
        let elements = Vec::<T>::with_capacity(length + LINE / size);
        let left = elements.as_ptr().addr().wrapping_neg() % LINE;
        // Where no whole number of elements fills the rest of the line, the array is not aligned.
        let first = if left.is_multiple_of(size) { left / size } else { 0 };
        (elements, first)
    }
}

impl<T: Copy> Clone for Aligned<T> {
    fn clone(&self) -> Self {
        let (mut elements, first) = Self::room(self.len());
        for _ in 0..first {
            elements.push(self[0]);
        }
        elements.extend_from_slice(self);
        Self { elements, first }
    }
    fn clone_from(&mut self, from: &Self) {
        if self.len() == from.len() {
            self.copy_from_slice(from);
        } else {
            *self = from.clone();
        }
    }
}

impl<T> Deref for Aligned<T> {
    type Target = [T];
    #[inline(always)]
    fn deref(&self) -> &[T] {
        &self.elements[self.first..]
    }
}

impl<T> DerefMut for Aligned<T> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.elements[self.first..]
    }
}

#[cfg(test)]
mod tests {
    use super::{Aligned, LINE};

    /// An array, its clone, and a clone into another array have its elements, and begin at a line.
    fn begins_at_a_line<T: Copy + PartialEq + core::fmt::Debug>(of: fn(usize) -> T, aligned: bool) {
        for length in [0, 1, 7, 8, 100, 5_000] {
            let mut array = Aligned::filled(length, of(0));
            array.iter_mut().enumerate().for_each(|(index, element)| *element = of(index));
            let mut other = Aligned::filled(3, of(1));
            other.clone_from(&array);
            let filled = Aligned::filled(length, of(1));
            assert!(filled.len() == length && filled.iter().all(|element| *element == of(1)), "{length} elements");
            assert!(length == 0 || (filled.as_ptr() as usize).is_multiple_of(LINE) || !aligned, "{length} elements");
            for array in [array.clone(), array, other] {
                assert!(array.iter().copied().eq((0..length).map(of)), "{length} elements");
                let at_a_line = (array.as_ptr() as usize).is_multiple_of(LINE);
                assert!(length == 0 || at_a_line || !aligned, "{length} elements");
            }
        }
    }

    #[test]
    fn arrays_begin_at_a_line_with_all_their_elements() {
        begins_at_a_line(|i| i as f64, true);
        begins_at_a_line(|i| i as f32, true);
        begins_at_a_line(|i| [i as f64, 0.5], true);
        // 24 bytes: few of these fill no line.
        begins_at_a_line(|i| [i as f64, 0.5, 0.25], false);
    }
}
