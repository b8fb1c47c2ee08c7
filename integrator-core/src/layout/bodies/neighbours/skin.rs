//! The width of the skin of a list: wide ones contain more pairs, narrow ones are rebuilt more often.

/// The first skin, in cutoffs.
pub(crate) const FIRST_SKIN: f64 = 0.12;

/// The cost of testing a candidate for a list and of sorting it in, relative to a pair of a list in a sum. Measured on liquid
/// argon, and on a melt of polymers with shorter lists.
const LOOK: f64 = 2.0;

/// Skins that are tried, in cutoffs: from `NARROWEST`, each wider than the one before by `STEP`.
const NARROWEST: f64 = 0.02;
const STEP: f64 = 1.2;
const TRIED: usize = 20;

/// The skin with the least work for each sum, if lists with the last skin were good for this number of sums: bodies
/// move by as much in each.
pub(crate) fn next_skin(cutoff: f64, last: f64, sums: u32, dimension: usize) -> f64 {
    let by_sum = last / f64::from(sums.max(1));
    let work = |skin: f64| {
        let (mut pairs, mut candidates) = (1.0, LOOK);
        for _ in 0..dimension.min(3) {
            pairs *= cutoff + skin;
            candidates *= 3.0 * (cutoff + skin);
        }
        // The volume of a ball is about half that of the cube around it.
        4.0 * pairs + candidates / (skin / by_sum).max(1.0)
    };
    let (mut best, mut skin) = (NARROWEST * cutoff, NARROWEST * cutoff);
    for _ in 1..TRIED {
        skin *= STEP;
        if work(skin) < work(best) {
            best = skin;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::{FIRST_SKIN, next_skin};

    #[test]
    fn fast_bodies_have_wide_skins() {
        let skin = |sums| next_skin(2.5, FIRST_SKIN * 2.5, sums, 3);
        let skins = [5, 10, 100, 1000].map(skin);
        assert!(skins.is_sorted_by(|wide, narrow| wide > narrow), "{skins:?}");
        // What moves too far for any list has short ones, and so has what does not move.
        let too_far = next_skin(2.5, 1.0, 1, 3);
        assert!([too_far, skin(u32::MAX)].iter().all(|skin| (0.04..0.1).contains(skin)));
        assert_eq!(skin(0), skin(1));
    }
}
