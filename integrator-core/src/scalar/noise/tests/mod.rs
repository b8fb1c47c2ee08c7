//! The words, the normal numbers and their distribution.

mod accuracy;
mod distribution;
mod lanes;
mod words;

use super::philox::ROUNDS;

/// The number of normal numbers whose distribution is tested, or the requested one: a hundred million in `.ci/run`.
fn draws() -> usize {
    std::env::var("NOISE_DRAWS").ok().and_then(|count| count.parse().ok()).unwrap_or(1_000_000)
}

/// The probability that a good generator fails one check, at most: checks have a fixed seed, so that they fail always or
/// never.
const LEVEL: f64 = 1e-6;

/// A standard normal number is farther out with a probability of 5.7e-7.
const STANDARD_ERRORS: f64 = 5.0;

/// Philox4x32 as the article writes it, with any number of rounds.
fn rounds(count: usize, counter: [u32; 4], key: [u32; 2]) -> [u32; 4] {
    let ([mut left, mut right], mut words) = (key, counter);
    for _ in 0..count {
        let [first, second] = [0xd251_1f53 * u64::from(words[0]), 0xcd9e_8d57 * u64::from(words[2])]
            .map(|x| [(x >> 32) as u32, x as u32]);
        words = [second[0] ^ words[1] ^ left, second[1], first[0] ^ words[3] ^ right, first[1]];
        (left, right) = (left.wrapping_add(0x9e37_79b9), right.wrapping_add(0xbb67_ae85));
    }
    words
}

/// A word that depends on all bits of a number: the finaliser of G. Steele's `SplitMix`.
fn scrambled(number: usize) -> u32 {
    let mut x = (number as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (x ^ (x >> 31)) as u32
}

/// A counter in which one word counts and the others do not.
fn counter_along(word: usize, count: usize) -> [u32; 4] {
    let mut counter = [0x0012_3456, 17, 0, 3];
    counter[word] = (counter[word] as usize + count) as u32;
    counter
}

/// The names of the checks of a generator, and whether each holds.
type Checks = Vec<(String, bool)>;

/// The names of the checks that fail.
fn failures(checks: &Checks) -> Vec<&str> {
    checks.iter().filter(|(_, holds)| !holds).map(|(name, _)| name.as_str()).collect()
}

/// A table of bad generators, and the checks that failed for one of them.
#[derive(Default)]
struct Bad(Vec<String>);

impl Bad {
    /// Asserts that a bad generator fails the expected checks.
    fn fails(&mut self, name: &str, checks: &Checks, expected: &[&str]) {
        let failed = failures(checks);
        for check in expected {
            assert!(failed.contains(check), "{name}: the check `{check}` holds; those that fail: {failed:?}");
        }
        self.0.extend(failed.into_iter().map(str::to_owned));
    }

    /// Asserts that each check failed for some bad generator.
    fn cover(&self, checks: &Checks) {
        for (name, _) in checks {
            assert!(self.0.contains(name), "no bad generator fails the check `{name}`");
        }
    }
}
