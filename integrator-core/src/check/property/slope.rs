//! Derivatives by differences: Richardson's extrapolation, compared between two widths.

use crate::scalar::tolerance::{largest, within};

/// The widths at which differences begin, in units of the largest coordinate, and how often each is halved: they reach
/// from a tenth of it down to where rounding takes half of the digits.
const WIDTHS: [f64; 6] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6];
const LEVELS: usize = 6;

/// The largest uncertainty of a derivative that is compared, in units of its terms. Orders of magnitude below
/// the mistakes that are made in a derivative by hand, and above what differences reach where a function is smooth.
pub(crate) const KNOWN: f64 = 1e-6;

/// The safety factor on the estimated error of a difference: the estimate is the last correction of an
/// extrapolation, which the next ones fall short of where it converges.
pub(crate) const SAFETY: f64 = 8.0;

/// A derivative by differences.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slope {
    pub(crate) value: f64,
    pub(crate) uncertainty: f64,
    /// The size of the differences that it was made of.
    pub(crate) scale: f64,
}

/// The derivative at zero of a function that returns its rounding too; `None` where no two widths lead to the same, or
/// where the slopes from both sides differ.
pub(crate) fn slope_of(value: &dyn Fn(f64) -> [f64; 2]) -> Option<Slope> {
    let mut best: Option<Slope> = None;
    for width in WIDTHS {
        let Some(slope) = extrapolated(value, width) else { continue };
        if let Some(before) = best {
            let both = before.uncertainty + slope.uncertainty;
            let still = before.scale == 0.0 && slope.scale == 0.0;
            if (still || within(both, KNOWN * before.scale)) && within(before.value - slope.value, both) {
                return Some(if slope.uncertainty < before.uncertainty { slope } else { before });
            }
        }
        best = Some(slope);
    }
    None
}

/// The derivative at zero from differences over a width and its halves, by Richardson's extrapolation: central ones,
/// whose error is a series in the square of the width, and those to either side, in its powers, which have to agree
/// with each other or there is a kink in between.
fn extrapolated(value: &dyn Fn(f64) -> [f64; 2], width: f64) -> Option<Slope> {
    let [middle, mut rounding] = value(0.0);
    let (mut central, mut right, mut left) = ([0.0; LEVELS], [0.0; LEVELS], [0.0; LEVELS]);
    let mut narrowest = width;
    for level in 0..LEVELS {
        narrowest = width / (1_u32 << level) as f64;
        let [[above, of_above], [below, of_below]] = [value(narrowest), value(-narrowest)];
        rounding = f64::max(rounding, f64::max(of_above, of_below));
        central[level] = (above - below) / (2.0 * narrowest);
        right[level] = (above - middle) / narrowest;
        left[level] = (middle - below) / narrowest;
    }
    let scale = largest([right[0], left[0]]);
    if right.iter().chain(&left).all(|difference| *difference == 0.0) {
        // Nothing changes over the whole width by more than a rounding.
        return Some(Slope { value: 0.0, uncertainty: 2.0 * rounding / width, scale });
    }
    // The weights of an extrapolation add up to less than 2 in size where errors fall by four, and to 9 where by two.
    let noise = rounding / narrowest;
    let [(value, error), (right, of_right), (left, of_left)] =
        [(central, 4.0), (right, 2.0), (left, 2.0)].map(|(differences, fall)| limit(differences, fall));
    let uncertainty = error + 2.0 * noise;
    let one_sided = of_right + of_left + 18.0 * noise;
    let smooth = within(right - left, SAFETY * one_sided) && within(one_sided, KNOWN.sqrt() * scale);
    let known = smooth && uncertainty.is_finite();
    known.then_some(Slope { value, uncertainty, scale })
}

/// The limit of a sequence whose error is a series in powers of `1/fall`, and its last correction.
fn limit(mut row: [f64; LEVELS], fall: f64) -> (f64, f64) {
    let mut error = f64::INFINITY;
    let mut factor = 1.0;
    for column in 1..LEVELS {
        factor *= fall;
        let before = row[LEVELS - 1];
        for level in (column..LEVELS).rev() {
            row[level] += (row[level] - row[level - 1]) / (factor - 1.0);
        }
        error = f64::max((row[LEVELS - 1] - before).abs(), (row[LEVELS - 1] - row[LEVELS - 2]).abs());
    }
    (row[LEVELS - 1], error)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_found_where_there_are_any() {
        type Function = fn(f64) -> f64;
        let smooth: [(&str, Function, f64); 6] = [
            ("sin", |x| (0.3 + x).sin(), 0.3_f64.cos()),
            ("1/r", |x| 1.0 / (0.001 + x).abs(), -1e6),
            ("a fast wave", |x| (1e3 * x).sin(), 1e3),
            ("a constant", |_| 7.0, 0.0),
            ("a parabola at rest", |x| 0.5 * x * x, 0.0),
            ("a kink nearby", |x| (x - 1e-3).abs(), -1.0),
        ];
        for (name, function, expected) in smooth {
            let found = slope_of(&|x| [function(x), 4.0 * f64::EPSILON * function(x).abs()]);
            let Slope { value, uncertainty, scale } = found.unwrap_or_else(|| panic!("{name} has a slope"));
            assert!((value - expected).abs() <= SAFETY * uncertainty, "{name}: {found:?}");
            assert!(uncertainty <= KNOWN * scale.max(1.0), "{name}: {found:?}");
        }
        let rough: [(&str, Function); 4] = [
            ("a kink", f64::abs),
            ("a jump", |x| if x < 0.0 { 1.0 } else { 2.0 }),
            ("a cusp", |x| x.abs().sqrt()),
            ("the edge of a domain", f64::sqrt),
        ];
        for (name, function) in rough {
            let found = slope_of(&|x| [function(x), 4.0 * f64::EPSILON * function(x).abs()]);
            assert!(found.is_none_or(|slope| slope.uncertainty > KNOWN * slope.scale), "{name}: {found:?}");
        }
    }
}
