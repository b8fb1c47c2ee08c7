//! Lists of the entries of several lists, and of the pairs that these name, for code that the macro generates.

use alloc::vec::Vec;

/// Returns the entries of a number of lists, one list after the other.
pub fn entries<T>(lists: usize, length: &dyn Fn(usize) -> usize, entry: &dyn Fn(usize, usize) -> T) -> Vec<T> {
    let mut entries = Vec::new();
    for list in 0..lists {
        for place in 0..length(list) {
            entries.push(entry(list, place));
        }
    }
    entries
}

/// Returns the pairs that the entries of a number of lists name. A pair comes once, in either order of its members, where
/// the first of its entries is.
pub fn distinct_pairs(
    lists: usize,
    length: &dyn Fn(usize) -> usize,
    pair: &dyn Fn(usize, usize) -> [usize; 2],
) -> Vec<[usize; 2]> {
    let pairs = entries(lists, length, pair);
    let first = first_entries(&pairs);
    first.iter().enumerate().filter(|(entry, first)| entry == *first).map(|(entry, _)| pairs[entry]).collect()
}

/// Returns the sum of the numbers of all entries that name a pair, for each of the pairs that [`distinct_pairs`] returns.
pub fn weights(
    lists: usize,
    length: &dyn Fn(usize) -> usize,
    pair: &dyn Fn(usize, usize) -> [usize; 2],
    number: &dyn Fn(usize, usize) -> f64,
) -> Vec<f64> {
    let first = first_entries(&entries(lists, length, pair));
    let mut sums = entries(lists, length, number);
    for (entry, first) in first.iter().copied().enumerate() {
        if first != entry {
            sums[first] += sums[entry];
        }
    }
    first.iter().enumerate().filter(|(entry, first)| entry == *first).map(|(entry, _)| sums[entry]).collect()
}

/// The number of the first entry that names the same pair as each entry.
fn first_entries(pairs: &[[usize; 2]]) -> Vec<usize> {
    let key = |entry: usize| {
        let [a, b] = pairs[entry];
        [a.min(b), a.max(b)]
    };
    let mut sorted: Vec<usize> = (0..pairs.len()).collect();
    sorted.sort_by_key(|entry| key(*entry));
    let mut first: Vec<usize> = (0..pairs.len()).collect();
    for same in sorted.chunk_by(|a, b| key(*a) == key(*b)) {
        same.iter().for_each(|entry| first[*entry] = same[0]);
    }
    first
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_pair_comes_once_with_all_of_its_numbers() {
        // Both ends name most bonds, one end alone names 0, 3, a site names itself, and 2, 1 comes twice in one list.
        let lists: [&[usize]; 4] = [&[1, 3], &[2, 0], &[1, 1, 2], &[]];
        let (length, pair) = (|list: usize| lists[list].len(), |list: usize, place: usize| [list, lists[list][place]]);
        let number = |list: usize, place: usize| (1 << (3 * list + place)) as f64;
        assert_eq!(entries(4, &length, &|list, place| lists[list][place]), [1, 3, 2, 0, 1, 1, 2]);
        assert_eq!(distinct_pairs(4, &length, &pair), [[0, 1], [0, 3], [1, 2], [2, 2]]);
        assert_eq!(weights(4, &length, &pair, &number), [1.0 + 16.0, 2.0, 8.0 + 64.0 + 128.0, 256.0]);
    }
}
