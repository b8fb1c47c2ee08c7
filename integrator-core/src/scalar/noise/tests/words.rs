//! Words: known answers, and cheap tests of their bits.

use super::{Bad, Checks, LEVEL, ROUNDS, STANDARD_ERRORS, counter_along, draws, failures, rounds, scrambled};
use crate::scalar::noise::philox;

#[test]
fn words_are_those_of_random123() {
    let table = [
        ([0; 4], [0; 2], [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8]),
        ([u32::MAX; 4], [u32::MAX; 2], [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd]),
        (
            [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344],
            [0xa409_3822, 0x299f_31d0],
            [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1],
        ),
    ];
    for (counter, key, words) in table {
        assert_eq!(philox(counter, key), words, "{counter:x?} with {key:x?}");
    }
}

#[test]
fn words_are_those_of_the_article() {
    for number in 0..10_000 {
        let [a, b, c, d, e, f] = std::array::from_fn(|word| scrambled(6 * number + word));
        assert_eq!(philox([a, b, c, d], [e, f]), rounds(ROUNDS, [a, b, c, d], [e, f]));
    }
}

/// Four words of a counter and a key.
type Words<'a> = &'a dyn Fn([u32; 4], [u32; 2]) -> [u32; 4];

/// How far a sum of independent bits is from its mean, in standard errors.
fn of_bits(ones: usize, count: usize) -> f64 {
    (2.0 * ones as f64 - count as f64).abs() / (count as f64).sqrt()
}

/// How far χ² is from its mean, in standard errors: Wilson and Hilferty's cube root of it is nearly normal.
fn of_cells(counts: &[usize], probability: impl Fn(usize) -> f64) -> f64 {
    let total = counts.iter().sum::<usize>() as f64;
    let squares = counts.iter().enumerate().map(|(cell, count)| {
        let expected = total * probability(cell);
        (*count as f64 - expected).powi(2) / expected
    });
    let (square, freedom) = (squares.sum::<f64>(), counts.len() as f64 - 1.0);
    let spread = 2.0 / (9.0 * freedom);
    ((square / freedom).cbrt() - (1.0 - spread)).abs() / spread.sqrt()
}

/// Gaps are counted one by one below this.
const GAPS: usize = 48;

/// All checks of words.
///
/// Of a sum of independent numbers, a check fails at five standard errors. Where it takes the largest of many sums, its
/// distance is that at which the probability of one of them, `2·exp(-z²/2)` by Hoeffding, is `LEVEL` divided by their number.
fn checks(words: Words<'_>, count: usize) -> Checks {
    let key = [0xdead_beef, 0x0123_4567];
    let of_many = |sums: usize| (2.0 * (2.0 * sums as f64 / LEVEL).ln()).sqrt();
    let (mut ones, mut bytes, mut changes) = ([0; 128], [0; 256], [0; 2]);
    let (mut gaps, mut gap) = ([0; GAPS + 1], 0);
    let mut differences = [0; 4];
    let quarter = count / 4;
    for (along, differences) in differences.iter_mut().enumerate() {
        let mut previous = words(counter_along(along, quarter), key);
        for number in 0..quarter {
            let now = words(counter_along(along, number), key);
            for (place, (&word, before)) in now.iter().zip(previous).enumerate() {
                for bit in 0..32 {
                    ones[32 * place + bit] += (word >> bit & 1) as usize;
                }
                for byte in word.to_le_bytes() {
                    bytes[usize::from(byte)] += 1;
                }
                changes[0] += ((word ^ (word >> 1)) & 0x7fff_ffff).count_ones() as usize;
                changes[1] += 31;
                *differences += (word ^ before).count_ones() as usize;
                if word < 1 << 28 {
                    gaps[gap.min(GAPS)] += 1;
                    gap = 0;
                } else {
                    gap += 1;
                }
            }
            previous = now;
        }
    }
    let bits = ones.iter().map(|ones| of_bits(*ones, 4 * quarter)).fold(0.0, f64::max);
    let gap = |gap: usize| 0.9375_f64.powi(gap as i32) * if gap == GAPS { 1.0 } else { 0.0625 };
    let (avalanche, pairs) = avalanche(words, (count / 400).max(500));
    let mut distances = vec![
        ("bits".to_owned(), bits, of_many(128)),
        ("bytes".to_owned(), of_cells(&bytes, |_| 1.0 / 256.0), STANDARD_ERRORS),
        ("runs".to_owned(), of_bits(changes[0], changes[1]), STANDARD_ERRORS),
        ("gaps".to_owned(), of_cells(&gaps, gap), STANDARD_ERRORS),
        ("avalanche".to_owned(), avalanche, of_many(pairs)),
    ];
    for (along, ones) in differences.into_iter().enumerate() {
        distances.push((format!("neighbours in word {along}"), of_bits(ones, 128 * quarter), STANDARD_ERRORS));
    }
    distances.into_iter().map(|(name, distance, limit)| (name, distance <= limit)).collect()
}

/// For each bit that goes in and each that comes out, how often the second flips with the first: the farthest from one half,
/// in standard errors, and the number of pairs.
fn avalanche(words: Words<'_>, trials: usize) -> (f64, usize) {
    let mut flips = vec![[0; 128]; 192];
    for trial in 0..trials {
        let input: [u32; 6] = std::array::from_fn(|word| scrambled(6 * trial + word));
        let of_input = |[a, b, c, d, e, f]: [u32; 6]| words([a, b, c, d], [e, f]);
        let before = of_input(input);
        for (bit, flips) in flips.iter_mut().enumerate() {
            let mut other = input;
            other[bit / 32] ^= 1 << (bit % 32);
            for (place, (one, two)) in before.into_iter().zip(of_input(other)).enumerate() {
                for bit in 0..32 {
                    flips[32 * place + bit] += ((one ^ two) >> bit & 1) as usize;
                }
            }
        }
    }
    let pairs = flips.as_flattened();
    (pairs.iter().map(|flips| of_bits(*flips, trials)).fold(0.0, f64::max), pairs.len())
}

#[test]
fn words_look_random() {
    let checks = checks(&philox, draws() / 5);
    assert!(failures(&checks).is_empty(), "{:?}", failures(&checks));
}

#[test]
fn every_check_of_words_fails_for_some_bad_generator() {
    let halved = |along: usize| {
        move |mut counter: [u32; 4], key| {
            counter[along] >>= 1;
            philox(counter, key)
        }
    };
    let of_rounds = |count| move |counter, key| rounds(count, counter, key);
    let all_neighbours =
        ["neighbours in word 0", "neighbours in word 1", "neighbours in word 2", "neighbours in word 3"];
    let table: [(&str, Words<'_>, &[&str]); 13] = [
        ("counters", &|counter, _| counter, &["bits", "bytes", "runs", "gaps", "avalanche"]),
        ("one round", &of_rounds(1), &["bits", "avalanche"]),
        ("two rounds", &of_rounds(2), &["avalanche"]),
        ("three rounds", &of_rounds(3), &["avalanche"]),
        ("four rounds", &of_rounds(4), &["avalanche"]),
        ("a fixed bit", &|counter, key| philox(counter, key).map(|word| word | 1 << 7), &["bits", "bytes"]),
        (
            "bytes of equal halves",
            &|counter, key| philox(counter, key).map(|word| (word & 0x0f0f_0f0f) * 0x11),
            &["bytes"],
        ),
        ("runs of two", &|counter, key| philox(counter, key).map(|word| (word & 0x5555_5555) * 3), &["runs"]),
        (
            "a leading digit that counts",
            &|counter, key| {
                let words = philox(counter, key);
                let count = counter.into_iter().fold(0, u32::wrapping_add);
                std::array::from_fn(|place| words[place] >> 4 | count.wrapping_mul(1 << 30) | (place as u32) << 28)
            },
            &["gaps"],
        ),
        ("equal neighbours in word 0", &halved(0), &all_neighbours[..1]),
        ("equal neighbours in word 1", &halved(1), &all_neighbours[1..2]),
        ("equal neighbours in word 2", &halved(2), &all_neighbours[2..3]),
        ("equal neighbours in word 3", &halved(3), &all_neighbours[3..]),
    ];
    let mut bad = Bad::default();
    for (name, words, expected) in table {
        bad.fails(name, &checks(words, 40_000), expected);
    }
    bad.cover(&checks(&philox, 4_000));
}
