//! Lines of identical sites, several vectors of sites at a time.
//!
//! Comes in: what a kernel computes at each site from its own coordinate and that of the next one. Goes out: what a site
//! gets from itself and from the site before. Always true: where `n` vectors hold the sites, site `i` is in lane `i / n`
//! of vector `i % n`, so that the vector after another one has its next sites, but for the last vector, whose next sites
//! are those of the first one, a lane ahead. What a site computes depends on its number alone, whether it is computed
//! in a vector or on its own.

use super::table::{Coefficients, EIGHT, Layout, Wide, is_narrow};
use crate::scalar::{real::Real, simd::row::Row};
use alloc::vec::Vec;
use core::{marker::PhantomData, ops::Range};

/// Several vectors of eight numbers, or one number.
pub type Bundle<R> = <R as Real>::Bundle;

/// The sites beyond the ends of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// The last site is followed by the first.
    Ring,
    /// Before the first site and after the last one is a site at rest, with the coordinate zero, or nothing.
    Open {
        /// Whether a site at rest is before the first. The sums treat one after the last site.
        first_at_rest: bool,
    },
}

impl Ends {
    /// The number of bonds from sites at rest to the first site.
    #[inline(always)]
    fn before(self) -> usize {
        usize::from(matches!(self, Self::Open { first_at_rest: true }))
    }
}

/// The largest number of vectors that are computed together.
const MOST: usize = 4;

/// The number of vectors in `V`.
const fn vectors<R: Real, V: Real>() -> usize {
    V::LANES / Wide::<R>::LANES
}

/// The number of sites in a vector.
const fn lanes<R: Real>() -> usize {
    Wide::<R>::LANES / R::LANES
}

/// The number of vectors that hold sites.
#[inline(always)]
fn count<R: Real>(layout: Layout) -> usize {
    layout.width() / lanes::<R>()
}

/// The number of vectors that are computed. After those with sites is the one of the site at rest before the first.
#[inline(always)]
fn computing<R: Real>(layout: Layout, ends: Ends) -> usize {
    count::<R>(layout) + ends.before()
}

/// A vector with another number in one lane; or the other number, where a vector is one.
#[inline(always)]
fn with_lane<R: Real>(vector: Wide<R>, lane: usize, other: Wide<R>) -> Wide<R> {
    if const { is_narrow::<R>() } {
        return other;
    }
    let mut numbers = [R::of(0.0); EIGHT];
    numbers[lane] = R::of(1.0);
    let is_other = Wide::<R>::of(0.0).less(<Wide<R> as Row<R>>::read(&numbers));
    Wide::<R>::select(is_other, other, vector)
}

/// The values that the sites of a vector compute, each of this number of orders.
type Results<R, const VALUES: usize, const ORDERS: usize> = [[Wide<R>; ORDERS]; VALUES];

/// The sites of a line, which compute this number of values of this number of orders per call. `B` is the record of
/// several vectors, `T` that of one.
pub struct Line<R: Real, B, T, const VALUES: usize, const ORDERS: usize> {
    bundles: Vec<B>,
    /// The vectors that fill no bundle.
    singles: Vec<T>,
    results: Vec<Results<R, VALUES, ORDERS>>,
}

impl<R: Real, B, T, const VALUES: usize, const ORDERS: usize> Default for Line<R, B, T, VALUES, ORDERS> {
    fn default() -> Self {
        Self { bundles: Vec::new(), singles: Vec::new(), results: Vec::new() }
    }
}

/// The results of a few vectors, which stay in registers if there are enough. After a store and a load, results would
/// arrive later than the sums over known numbers. `VECTORS` is zero if there are too many vectors.
pub struct Few<R: Real, const VALUES: usize, const ORDERS: usize, const VECTORS: usize> {
    results: [Results<R, VALUES, ORDERS>; VECTORS],
}

impl<R: Real, const VALUES: usize, const ORDERS: usize, const VECTORS: usize> Few<R, VALUES, ORDERS, VECTORS> {
    /// Whether registers hold them: where each vector is one, bundles have the most.
    const IN_REGISTERS: bool = VECTORS > 0 && vectors::<R, Bundle<R>>() == MOST;

    /// Before any vector has computed.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { results: [[[Wide::<R>::of(0.0); ORDERS]; VALUES]; VECTORS] }
    }
}

/// Some vectors of a line, as many as `V` has; `T` is their record.
pub struct Vectors<'l, R: Real, V, T, const VALUES: usize, const ORDERS: usize> {
    /// The record of the vectors.
    pub kept: &'l mut T,
    first: usize,
    results: &'l mut [Results<R, VALUES, ORDERS>],
    vectors: PhantomData<V>,
}

impl<R: Real, B: Default, T: Default, const VALUES: usize, const ORDERS: usize> Line<R, B, T, VALUES, ORDERS> {
    /// Whether there are no records yet.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.results.is_empty()
    }

    /// Makes the records, for coordinates in this layout.
    #[cold]
    #[inline(never)]
    pub fn build(&mut self, layout: Layout, ends: Ends) {
        self.bundles.resize_with(self.bundles(layout, ends).len(), B::default);
        self.singles.resize_with(self.singles(layout, ends).len(), T::default);
        self.results.resize(computing::<R>(layout, ends), [[Wide::<R>::of(0.0); ORDERS]; VALUES]);
    }

    /// The numbers of the bundles.
    #[inline(always)]
    pub fn bundles(&self, layout: Layout, ends: Ends) -> Range<usize> {
        0..computing::<R>(layout, ends) / vectors::<R, Bundle<R>>()
    }

    /// The vectors of a bundle.
    #[inline(always)]
    pub fn bundle(&mut self, number: usize) -> Vectors<'_, R, Bundle<R>, B, VALUES, ORDERS> {
        let together = vectors::<R, Bundle<R>>();
        let first = number * together;
        let results = &mut self.results[first..][..together];
        Vectors { kept: &mut self.bundles[number], first, results, vectors: PhantomData }
    }

    /// The numbers of the vectors that fill no bundle.
    #[inline(always)]
    pub fn singles(&self, layout: Layout, ends: Ends) -> Range<usize> {
        0..computing::<R>(layout, ends) % vectors::<R, Bundle<R>>()
    }

    /// Returns a vector that fills no bundle.
    #[inline(always)]
    pub fn single(&mut self, number: usize, layout: Layout, ends: Ends) -> Vectors<'_, R, Wide<R>, T, VALUES, ORDERS> {
        let first = self.bundles(layout, ends).len() * vectors::<R, Bundle<R>>() + number;
        let results = &mut self.results[first..][..1];
        Vectors { kept: &mut self.singles[number], first, results, vectors: PhantomData }
    }

    /// Returns the results of all sites.
    #[inline(always)]
    pub fn computed<'l, const VECTORS: usize>(
        &'l self,
        few: &'l Few<R, VALUES, ORDERS, VECTORS>,
        layout: Layout,
        ends: Ends,
    ) -> Computed<'l, R, VALUES, ORDERS> {
        let (count, all) = (count::<R>(layout), computing::<R>(layout, ends));
        let in_registers = const { Few::<R, VALUES, ORDERS, VECTORS>::IN_REGISTERS };
        let results = if in_registers { &few.results[..] } else { &self.results };
        Computed { results: &results[..all], count, ends }
    }
}

/// The results of the sites of a line.
pub struct Computed<'l, R: Real, const VALUES: usize, const ORDERS: usize> {
    results: &'l [Results<R, VALUES, ORDERS>],
    /// The number of vectors that hold sites.
    count: usize,
    ends: Ends,
}

impl<R: Real, const VALUES: usize, const ORDERS: usize> Computed<'_, R, VALUES, ORDERS> {
    /// The numbers of the vectors that hold sites.
    #[inline(always)]
    pub fn vectors(&self) -> Range<usize> {
        0..self.count
    }

    /// Returns the results of the sites of a vector.
    #[inline(always)]
    pub fn own(&self, vector: usize) -> Results<R, VALUES, ORDERS> {
        self.results[vector]
    }

    /// Returns the results of the sites of a vector, with zero for the last site.
    #[inline(always)]
    pub fn own_without_last(&self, vector: usize) -> Results<R, VALUES, ORDERS> {
        let mut own = self.results[vector];
        if vector + 1 == self.count {
            for result in own.as_flattened_mut() {
                *result = with_lane::<R>(*result, EIGHT - 1, Wide::<R>::of(0.0));
            }
        }
        own
    }

    /// Returns the results of the sites before those of a vector: zero where there is no site.
    #[inline(always)]
    pub fn before(&self, vector: usize) -> Results<R, VALUES, ORDERS> {
        // From a vector to the next one in a lane.
        let (count, next) = (self.count, EIGHT / lanes::<R>());
        if vector >= next {
            return self.results[vector - next];
        }
        let mut before = self.results[(vector + next - 1) % next + count - next];
        for result in before.as_flattened_mut() {
            *result = result.permute(&[7, 0, 1, 2, 3, 4, 5, 6]);
        }
        if let Ends::Open { first_at_rest } = self.ends
            && vector == 0
        {
            let mut first = [[Wide::<R>::of(0.0); ORDERS]; VALUES];
            if first_at_rest {
                first = self.results[count];
            }
            for (result, first) in before.as_flattened_mut().iter_mut().zip(first.as_flattened()) {
                *result = with_lane::<R>(*result, 0, *first);
            }
        }
        before
    }
}

impl<R: Real, V: Row<Wide<R>>, T, const VALUES: usize, const ORDERS: usize> Vectors<'_, R, V, T, VALUES, ORDERS> {
    /// The coefficients of the sites, of the orders from this one on.
    #[inline(always)]
    pub fn own(&self, from: &Coefficients<'_, R>, order: usize) -> [V; ORDERS] {
        let mut values = [V::of(0.0); ORDERS];
        for at in 0..ORDERS {
            let mut numbers = [Wide::<R>::of(0.0); MOST];
            for (number, vector) in numbers[..vectors::<R, V>()].iter_mut().zip(self.first..) {
                *number = own::<R>(&from[order + at], vector);
            }
            values[at] = V::read(&numbers);
        }
        values
    }

    /// The coefficients of the next sites.
    #[inline(always)]
    pub fn next(&self, from: &Coefficients<'_, R>, order: usize, ends: Ends) -> [V; ORDERS] {
        let mut values = [V::of(0.0); ORDERS];
        for at in 0..ORDERS {
            let mut numbers = [Wide::<R>::of(0.0); MOST];
            for (number, vector) in numbers[..vectors::<R, V>()].iter_mut().zip(self.first..) {
                *number = next::<R>(&from[order + at], vector, ends);
            }
            values[at] = V::read(&numbers);
        }
        values
    }

    /// Stores what the sites computed.
    #[inline(always)]
    pub fn store<const VECTORS: usize>(self, few: &mut Few<R, VALUES, ORDERS, VECTORS>, values: [[V; ORDERS]; VALUES]) {
        let in_registers = const { Few::<R, VALUES, ORDERS, VECTORS>::IN_REGISTERS };
        let results = if in_registers { &mut few.results[self.first..][..vectors::<R, V>()] } else { self.results };
        for value in 0..VALUES {
            for at in 0..ORDERS {
                let mut numbers = [Wide::<R>::of(0.0); MOST];
                values[value][at].write(&mut numbers);
                for (results, number) in results.iter_mut().zip(numbers) {
                    results[value][at] = number;
                }
            }
        }
    }
}

/// The coefficients of the sites of a vector; after the last one are sites at rest.
#[inline(always)]
fn own<R: Real>(slice: &[R], vector: usize) -> Wide<R> {
    let begin = vector * lanes::<R>();
    if begin < slice.len() { Row::read(&slice[begin..]) } else { Wide::<R>::of(0.0) }
}

/// The coefficients of the sites next to those of a vector; after sites at rest are the first ones.
#[inline(always)]
fn next<R: Real>(slice: &[R], vector: usize, ends: Ends) -> Wide<R> {
    let begin = vector * lanes::<R>() + EIGHT;
    if begin < slice.len() {
        return Row::read(&slice[begin..]);
    }
    let lane = begin - slice.len();
    if lane == EIGHT {
        return Row::read(slice);
    }
    if const { is_narrow::<R>() } {
        return match ends {
            Ends::Open { .. } if lane == EIGHT - 1 => Wide::<R>::of(0.0),
            _ => Row::read(&slice[(lane + 1) % EIGHT..]),
        };
    }
    let next = <Wide<R> as Row<R>>::read(slice).permute(&[1, 2, 3, 4, 5, 6, 7, 0]);
    match ends {
        Ends::Ring => next,
        Ends::Open { .. } => with_lane::<R>(next, EIGHT - 1, Wide::<R>::of(0.0)),
    }
}

#[cfg(test)]
mod tests {
    use super::{super::table::Table, *};
    use crate::scalar::{
        fma::{Avx512, Fma, Fused},
        instruction_set::InstructionSet,
    };

    /// Tests that sites read and get the numbers that loops over sites would. Sums of these numbers are exact.
    fn sites_are_those_of_a_loop<R: Real, const FEW: usize>(sites: usize, ends: Ends) {
        let layout = Layout::of::<Vec<f64>>(sites, true);
        let number = |site: usize| site as f64 + 1.0;
        let mut table = Table::<R>::new(layout);
        let mut q = table.of(layout, R::of(1.0));
        for (site, at) in (0..sites).flat_map(|site| [(site, 0), (site, 1)]) {
            q[3 + at][layout.index(site, 0)] = R::of(number(site) * (at + 1) as f64);
        }
        let mut line = Line::<R, u8, u8, 2, 2>::default();
        assert!(line.is_empty());
        line.build(layout, ends);
        let mut few = Few::<R, 2, 2, FEW>::zero();
        for vectors in line.singles(layout, ends) {
            let vectors = line.single(vectors, layout, ends);
            let (own, next) = (vectors.own(&q, 3), vectors.next(&q, 3, ends));
            vectors.store(&mut few, [own, next]);
        }
        for vectors in line.bundles(layout, ends) {
            let vectors = line.bundle(vectors);
            let (own, next) = (vectors.own(&q, 3), vectors.next(&q, 3, ends));
            vectors.store(&mut few, [own, next]);
        }

        let computed = line.computed(&few, layout, ends);
        let number = |site: Option<usize>| site.map_or(0.0, number);
        let after = |site: usize| match ends {
            Ends::Ring => Some((site + 1) % sites),
            Ends::Open { .. } => (site + 1 < sites).then_some(site + 1),
        };
        for site in 0..sites {
            let index = layout.index(site, 0);
            let (vector, lane) = (index / lanes::<R>(), index % lanes::<R>() * R::LANES);
            let found = |[values, nexts]: Results<R, 2, 2>| {
                [values[0], values[1], nexts[0], nexts[1]].map(|found| found.lane(lane))
            };
            let expected = |own: f64, next: f64| [own, 2.0 * own, next, 2.0 * next];
            let own = expected(number(Some(site)), number(after(site)));
            assert_eq!(found(computed.own(vector)), own, "{site} of {sites}, {ends:?}");
            let last = if site + 1 == sites { [0.0; 4] } else { own };
            assert_eq!(found(computed.own_without_last(vector)), last, "{site} of {sites}, {ends:?}");
            let before = match (site.checked_sub(1), ends) {
                (None, Ends::Open { first_at_rest: false }) => [0.0; 4],
                (None, Ends::Open { .. }) => expected(0.0, number(Some(0))),
                (None, Ends::Ring) => expected(number(Some(sites - 1)), number(Some(0))),
                (Some(before), _) => expected(number(Some(before)), number(Some(site))),
            };
            assert_eq!(found(computed.before(vector)), before, "{site} of {sites}, {ends:?}");
        }
    }

    fn lines_of_all_kinds<R: Real>() {
        for ends in [Ends::Ring, Ends::Open { first_at_rest: false }, Ends::Open { first_at_rest: true }] {
            for sites in [8, 16, 24, 32, 40, 72] {
                sites_are_those_of_a_loop::<R, 0>(sites, ends);
                sites_are_those_of_a_loop::<R, 10>(sites, ends);
            }
        }
    }

    #[test]
    fn vectors_of_sites_match_a_loop() {
        lines_of_all_kinds::<f64>();
        lines_of_all_kinds::<f32>();
        let available = InstructionSet::available();
        if available.contains(&InstructionSet::Fused) {
            lines_of_all_kinds::<Fused<f64, Fma>>();
            lines_of_all_kinds::<Fused<f32, Fma>>();
        }
        if available.contains(&InstructionSet::Avx512) {
            lines_of_all_kinds::<Fused<f64, Avx512>>();
            lines_of_all_kinds::<Fused<f32, Avx512>>();
        }
    }
}
