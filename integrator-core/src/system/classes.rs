//! Classes of bodies with equal values, and tables over pairs of classes.

use crate::{
    scalar::{real::Real, simd::row::Row},
    state::digest::{Digest, Digested},
    system::{
        not_finite::Constants,
        prepared::OfMembers,
        shared_table::{SharedTable, table},
    },
};
use alloc::{vec, vec::Vec};
use core::ops::Range;

/// The first and the last body of a class.
type Ends = [usize; 2];

/// The class of each of these bodies, and the ends of each class. Classes are numbered in the order of their first bodies.
fn classified(bodies: Range<usize>, is_equal: &dyn Fn(usize, usize) -> bool) -> (Vec<usize>, Vec<Ends>) {
    let (mut of_bodies, mut ends): (Vec<usize>, Vec<Ends>) = (Vec::new(), Vec::new());
    for body in bodies {
        // Bodies of a class are often next to each other.
        let same_as_last = of_bodies.last().copied().filter(|class| is_equal(ends[*class][0], body));
        let class = same_as_last.or_else(|| ends.iter().position(|[first, _]| is_equal(*first, body)));
        let class = class.unwrap_or_else(|| {
            ends.push([body; 2]);
            ends.len() - 1
        });
        ends[class][1] = body;
        of_bodies.push(class);
    }
    (of_bodies, ends)
}

/// Returns the number of the class of each body, and zero for those out of range.
pub fn classes(bodies: Range<usize>, length: usize, is_equal: &dyn Fn(usize, usize) -> bool) -> Vec<f64> {
    let mut numbers = vec![0.0; length];
    let (of_bodies, _) = classified(bodies.clone(), is_equal);
    for (body, class) in bodies.zip(of_bodies) {
        numbers[body] = class as f64;
    }
    numbers
}

/// Returns numbers of the first bodies, and zero for the others of at most `length` bodies.
pub fn padded(mut numbers: Vec<f64>, length: usize) -> Vec<f64> {
    numbers.resize(length.max(numbers.len()), 0.0);
    numbers
}

/// Returns a number for each body, the same for bodies with equal values. Small integers are their own numbers and need no
/// search. Other values get negative numbers.
pub fn numbers_of_values(
    length: usize,
    small: &dyn Fn(usize) -> Option<f64>,
    is_equal: &dyn Fn(usize, usize) -> bool,
) -> Vec<f64> {
    // A body without a partner is never compared, and lists may lack it.
    if length < 2 {
        return vec![0.0; length];
    }
    let others: Vec<usize> = (0..length).filter(|body| small(*body).is_none()).collect();
    let (of_others, _) = classified(0..others.len(), &|a, b| is_equal(others[a], others[b]));
    let mut of_others = of_others.into_iter();
    let number = |body| small(body).or_else(|| of_others.next().map(|class| -1.0 - class as f64)).unwrap_or(0.0);
    (0..length).map(number).collect()
}

/// Values of a function of pairs, by the classes of their bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct ByClass<R> {
    /// The number of classes of the second body.
    columns: usize,
    /// Whether both bodies have the same classes, and the entries of exchanged bodies are equal.
    is_symmetric: bool,
    /// The rows, one for each class of the first body.
    pub(super) entries: SharedTable<R>,
}

impl ByClass<f64> {
    /// Creates the table. Entries of classes without a pair are zero.
    ///
    /// `value` is `None` for two bodies that are no pair. Pairs are all bodies `i < j`, or all `i > j`. So two
    /// classes contain a pair if and only if the first body of one and the last body of the other are a pair.
    pub fn new(
        bodies: [Range<usize>; 2],
        is_equal: [&dyn Fn(usize, usize) -> bool; 2],
        value: &dyn Fn(usize, usize) -> Option<f64>,
    ) -> Self {
        let [rows, columns] = bodies;
        let (rows, columns) = (classified(rows, is_equal[0]), classified(columns, is_equal[1]));
        let (are_alike, rows, columns) = (rows == columns, rows.1, columns.1);
        let value_of = |row: &Ends, column: &Ends| {
            let pairs = [[row[0], column[1]], [row[1], column[0]]];
            pairs.into_iter().find_map(|[i, j]| value(i, j))
        };
        // Without a pair in this order, nothing reads the entry, which may be that of exchanged bodies.
        let entry = |row: &Ends, column: &Ends| {
            let exchanged = || are_alike.then(|| value_of(column, row)).flatten();
            value_of(row, column).or_else(exchanged).unwrap_or(0.0)
        };
        let entries: Vec<_> =
            rows.iter().flat_map(|row| columns.iter().map(move |column| entry(row, column))).collect();
        let count = columns.len();
        let is_symmetric = are_alike
            && (0..count)
                .all(|row| (0..row).all(|column| entries[row * count + column] == entries[column * count + row]));
        Self { columns: count, is_symmetric, entries: entries.into() }
    }
}

/// The most entries that are compared one by one, in all lanes, which is faster than to read one for each lane.
const COMPARED: usize = 16;

impl<R: Real> ByClass<R> {
    /// Returns the entries in these rows and columns.
    #[inline(always)]
    pub fn entry<W: Row<R>>(&self, row: W, column: W) -> W {
        // Two classes, the most common number, need no places.
        if let (2, [a, b, c, d]) = (self.columns, &self.entries[..]) {
            let [first, second, third, fourth] = [a, b, c, d].map(|entry| W::splat(*entry));
            let [in_second_row, in_second_column] = [W::of(0.5).less(row), W::of(0.5).less(column)];
            let [left, right] = [W::select(in_second_row, third, first), W::select(in_second_row, fourth, second)];
            return W::select(in_second_column, right, left);
        }
        let first = self.entries.first().copied().unwrap_or(R::of(0.0));
        let mut entries = W::splat(first);
        if self.entries.len() <= COMPARED {
            let place = row.fma(W::of(self.columns as f64), column);
            for (at, entry) in self.entries.iter().enumerate().skip(1) {
                entries = W::select(place.equal(W::of(at as f64)), W::splat(*entry), entries);
            }
            return entries;
        }
        let (mut rows, mut columns, mut found) = ([R::of(0.0); 8], [R::of(0.0); 8], [first; 8]);
        row.write(&mut rows);
        column.write(&mut columns);
        for body in 0..W::LANES / R::LANES {
            // In integers, since the place of an entry may be too large for a short number.
            let entry = |lane| {
                let place = rows[body].lane(lane) as usize * self.columns + columns[body].lane(lane) as usize;
                self.entries.get(place).unwrap_or(&first)
            };
            found[body] = match R::LANES {
                1 => *entry(0),
                _ => R::state(&|lane| entry(lane).lane(lane)),
            };
        }
        W::read(&found)
    }
    /// Returns the entry of two classes for each pair: the first class is that of the row where the bodies are in order, and of the
    /// column elsewhere.
    #[inline(always)]
    pub fn entry_in_order<W: Row<R>>(&self, in_order: W::Mask, first: W, second: W) -> W {
        if self.is_symmetric {
            return self.entry(first, second);
        }
        self.entry(W::select(in_order, first, second), W::select(in_order, second, first))
    }
    /// Returns a table of as many zeros.
    pub fn zeros(mut self) -> Self {
        self.entries = table(self.entries.len(), &|_| R::of(0.0));
        self
    }
    /// Whether another table has as many rows and columns.
    pub fn is_like(&self, other: &Self) -> bool {
        self.columns == other.columns && self.entries.len() == other.entries.len()
    }
}

impl<R: Real> OfMembers<ByClass<f64>> for ByClass<R> {
    fn in_lanes<'c>(of_lane: &dyn Fn(usize) -> &'c ByClass<f64>) -> Self
    where
        ByClass<f64>: 'c,
    {
        let is_symmetric = (0..R::LANES).all(|lane| of_lane(lane).is_symmetric);
        Self { columns: of_lane(0).columns, is_symmetric, entries: OfMembers::in_lanes(&|lane| &of_lane(lane).entries) }
    }
}

impl Constants for ByClass<f64> {
    fn not_finite(&self) -> Option<(Vec<usize>, f64)> {
        let value = self.entries.iter().copied().find(|entry| !entry.is_finite())?;
        Some((Vec::new(), value))
    }
}

impl<R: Digested> Digested for ByClass<R> {
    fn add_to(&self, digest: &mut Digest) {
        digest.add(&self.columns);
        digest.add(&self.entries);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{scalar::simd::lanes::Lanes, system::equal_values::SmallInteger};
    use core::cmp::Ordering;

    const KINDS: [char; 6] = ['b', 'b', 'a', 'c', 'a', 'a'];

    #[test]
    fn classes_are_numbered_by_their_first_bodies() {
        let is_equal = |a: usize, b: usize| KINDS[a] == KINDS[b];
        assert_eq!(classes(0..6, 6, &is_equal), [0.0, 0.0, 1.0, 2.0, 1.0, 1.0]);
        assert_eq!(classes(1..6, 6, &is_equal), [0.0, 0.0, 1.0, 2.0, 1.0, 1.0]);
        assert_eq!(classes(0..2, 3, &is_equal), [0.0, 0.0, 0.0]);
    }

    #[test]
    fn equal_values_have_equal_numbers_and_others_have_not() {
        macro_rules! check {
            ($values:expr) => {
                let values = $values;
                let small = |body: usize| SmallInteger(&values[body]).value();
                let numbers = numbers_of_values(values.len(), &small, &|a, b| values[a] == values[b]);
                for (a, of_a) in numbers.iter().enumerate() {
                    for (b, of_b) in numbers.iter().enumerate() {
                        assert_eq!(values[a] == values[b], of_a == of_b, "{a}, {b}: {numbers:?}");
                    }
                }
            };
        }
        check!([3_usize, 7, 3, usize::MAX, 0, usize::MAX - 1, usize::MAX]);
        check!([-1_i64, 1, 0, i64::MIN, -1, 1 << 24, 1 << 24, (1 << 24) - 1]);
        check!(["a", "b", "a"]);
        check!([true, false, true]);
        check!(['a', 'b', 'a', char::MAX]);
        check!([Some(0.5), None, Some(0.5)]);
    }

    #[test]
    fn an_entry_is_the_value_of_a_pair_with_these_values() {
        let is_equal = |a: usize, b: usize| KINDS[a] == KINDS[b];
        let is_pair = |order: Ordering, i: usize, j: usize| i.cmp(&j) == order;
        for (order, bodies) in [(Ordering::Less, [0..5, 1..6]), (Ordering::Greater, [1..6, 0..5])] {
            let number = |i: usize, j: usize| f64::from(u32::from(KINDS[i]) * 1000 + u32::from(KINDS[j]));
            let value = |i: usize, j: usize| is_pair(order, i, j).then(|| number(i, j));
            let table = ByClass::new(bodies.clone(), [&is_equal, &is_equal], &value);
            let [rows, columns] = bodies.map(|bodies| classes(bodies, 6, &is_equal));
            for (i, row) in rows.iter().enumerate() {
                for (j, column) in columns.iter().enumerate().filter(|(j, _)| is_pair(order, i, *j)) {
                    assert_eq!(table.entry(*row, *column), number(i, j), "{order:?}: {i}, {j}");
                }
            }
        }
        // No pair, no value.
        let table = ByClass::new([0..5, 1..6], [&is_equal, &is_equal], &|i, j| (i < j).then_some(1.0));
        assert_eq!(table.entries[6..], [0.0, 1.0, 0.0], "{table:?}");
    }

    #[test]
    fn an_entry_in_order_is_that_of_a_pair_of_the_loops() {
        let is_equal = |a: usize, b: usize| KINDS[a] == KINDS[b];
        let sum = |i: usize, j: usize| f64::from(u32::from(KINDS[i]) + u32::from(KINDS[j]));
        let ratio = |i: usize, j: usize| f64::from(u32::from(KINDS[i])) / f64::from(u32::from(KINDS[j]));
        let numbers = classes(0..6, 6, &is_equal);
        for is_symmetric in [true, false] {
            let value = |i, j| if is_symmetric { sum(i, j) } else { ratio(i, j) };
            let table = ByClass::new([0..6, 0..6], [&is_equal; 2], &|i, j| (i > j).then(|| value(i, j)));
            assert_eq!(table.is_symmetric, is_symmetric, "{table:?}");
            for (i, j) in (0..6).flat_map(|i| (0..i).map(move |j| (i, j))) {
                for (in_order, [first, second]) in [(true, [i, j]), (false, [j, i])] {
                    let entry = table.entry_in_order(in_order, numbers[first], numbers[second]);
                    assert_eq!(entry, value(i, j), "{i}, {j}, in order: {in_order}");
                }
            }
        }
    }

    /// The place of an entry of a large table has more bits than a short number.
    #[test]
    fn short_numbers_find_every_entry() {
        const CLASSES: usize = 4097;
        let mut entries = vec![0.0_f32; CLASSES * CLASSES];
        entries[CLASSES * CLASSES - 2] = 1.0;
        let table = ByClass { columns: CLASSES, is_symmetric: false, entries: entries.into() };
        let last = (CLASSES - 1) as f32;
        assert_eq!([last - 2.0, last - 1.0, last].map(|column| table.entry(last, column)), [0.0, 1.0, 0.0]);
    }

    #[test]
    fn vectors_read_the_entries_of_each_lane() {
        type Both = Lanes<f64, 8>;
        for classes in [1, 2, 3, 7] {
            let is_equal = |a: usize, b: usize| a % classes == b % classes;
            let value = |i: usize, j: usize| Some((10 * (i % classes) + j % classes) as f64);
            let table = ByClass::new([0..20, 0..20], [&is_equal, &is_equal], &value);
            let numbers = [5, 3].map(|step| Both::state(&|lane| (lane * step % classes) as f64));
            let entries = table.entry(numbers[0], numbers[1]);
            for lane in 0..8 {
                let expected = 10.0 * numbers[0].lane(lane) + numbers[1].lane(lane);
                assert_eq!(entries.lane(lane), expected, "{classes} classes, lane {lane}");
            }
        }
    }
}
