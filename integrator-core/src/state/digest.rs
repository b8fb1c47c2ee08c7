//! Fingerprints of prepared constants, by which the parameters of two systems are distinguished.

use alloc::vec::Vec;

/// FNV-1a over words of 64 bits, with the high bits mixed back into the low ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digest(u64);

impl Digest {
    /// The fingerprint of no constants.
    #[cfg(feature = "checkpoint")]
    pub(crate) const EMPTY: Self = Self(0xcbf2_9ce4_8422_2325);

    /// The fingerprint of all constants that were added.
    #[cfg(feature = "checkpoint")]
    pub(crate) fn value(self) -> u64 {
        self.0
    }

    /// Adds a prepared constant.
    pub fn add(&mut self, constant: &impl Digested) {
        constant.add_to(self);
    }

    fn word(&mut self, word: u64) {
        let mixed = (self.0 ^ word).wrapping_mul(0x0000_0100_0000_01b3);
        self.0 = mixed ^ (mixed >> 32);
    }
}

/// A prepared number, or a table of prepared numbers over the indices of loops.
pub trait Digested {
    /// Adds it to a digest.
    fn add_to(&self, digest: &mut Digest);
}

impl Digested for f64 {
    fn add_to(&self, digest: &mut Digest) {
        digest.word(self.to_bits());
    }
}

impl Digested for usize {
    fn add_to(&self, digest: &mut Digest) {
        digest.word(*self as u64);
    }
}

impl<T: Digested> Digested for [T] {
    fn add_to(&self, digest: &mut Digest) {
        self.len().add_to(digest);
        self.iter().for_each(|element| element.add_to(digest));
    }
}

impl<T: Digested, const N: usize> Digested for [T; N] {
    fn add_to(&self, digest: &mut Digest) {
        self.as_slice().add_to(digest);
    }
}

impl<T: Digested> Digested for Vec<T> {
    fn add_to(&self, digest: &mut Digest) {
        self.as_slice().add_to(digest);
    }
}

#[cfg(all(test, feature = "checkpoint"))]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn other_constants_have_other_digests() {
        let of = |table: Vec<Vec<f64>>, count: usize| {
            let mut digest = Digest::EMPTY;
            digest.add(&table);
            digest.add(&count);
            digest.value()
        };
        let tables = [
            vec![],
            vec![vec![]],
            vec![vec![], vec![]],
            vec![vec![0.25]],
            vec![vec![0.3]],
            vec![vec![0.25, 0.3]],
            vec![vec![0.25], vec![0.3]],
            vec![vec![0.3], vec![0.25]],
            vec![vec![-0.25]],
            vec![vec![0.25 + f64::EPSILON / 4.0]],
        ];
        let found: HashSet<u64> =
            tables.iter().flat_map(|table| (0..5).map(|count| of(table.clone(), count))).collect();
        assert_eq!(found.len(), 5 * tables.len());
    }
}
