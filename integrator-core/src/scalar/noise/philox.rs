//! Philox4x32-10: a bijection of counters for each key.
//!
//! Source: J. K. Salmon, M. A. Moraes, R. O. Dror, D. E. Shaw, *Parallel random numbers: as easy as 1, 2, 3*, SC '11,
//! section 3.3, with the constants of Random123.

/// The multipliers of the words 0 and 2.
const MULTIPLIERS: [u64; 2] = [0xd251_1f53, 0xcd9e_8d57];
/// What the words of the key grow by in each round: the golden ratio and √3 - 1.
const WEYL: [u32; 2] = [0x9e37_79b9, 0xbb67_ae85];
/// The number of rounds.
pub(super) const ROUNDS: usize = 10;
/// The lower half of a word of 64 bits.
pub(super) const LOW: u64 = 0xffff_ffff;

/// Returns four random words of a counter and a key.
#[cfg(test)]
pub(crate) fn philox(counter: [u32; 4], key: [u32; 2]) -> [u32; 4] {
    mixed(counter.map(u64::from), round_keys(key)).map(|word| word as u32)
}

/// Returns the keys of all rounds.
#[inline(always)]
pub(super) fn round_keys(key: [u32; 2]) -> [[u64; 2]; ROUNDS] {
    let mut keys = [[0; 2]; ROUNDS];
    let mut of_round = key;
    for key in &mut keys {
        *key = [u64::from(of_round[0]), u64::from(of_round[1])];
        of_round = [of_round[0].wrapping_add(WEYL[0]), of_round[1].wrapping_add(WEYL[1])];
    }
    keys
}

/// Returns four random words in the lower halves; the upper ones are not cleared.
///
/// Words of 64 bits, because vectors multiply the lower halves of these in one instruction. So the upper halves need not
/// be cleared between rounds.
#[inline(always)]
pub(super) fn mixed(counter: [u64; 4], keys: [[u64; 2]; ROUNDS]) -> [u64; 4] {
    let mut words = counter;
    for key in keys {
        let product = [MULTIPLIERS[0] * (words[0] & LOW), MULTIPLIERS[1] * (words[2] & LOW)];
        words =
            [(product[1] >> 32) ^ words[1] ^ key[0], product[1], (product[0] >> 32) ^ words[3] ^ key[1], product[0]];
    }
    words
}
