//! The labels along an axis, all in the same notation.

use std::ops::RangeInclusive;

/// Multiples of 1, 2 or 5 times a power of ten.
pub(crate) fn linear(range: RangeInclusive<f64>, at_most: usize) -> Vec<(f64, String)> {
    let (least, most) = (*range.start(), *range.end());
    let length = most - least;
    if !(length.is_finite() && length > 0.0) {
        return Vec::new();
    }
    let wanted = length / at_most.max(2) as f64;
    let mut exponent = wanted.log10().floor() as i32;
    let digit = match wanted / 10.0_f64.powi(exponent) {
        part if part <= 1.0 + 1e-9 => 1.0,
        part if part <= 2.0 + 1e-9 => 2.0,
        part if part <= 5.0 + 1e-9 => 5.0,
        _ => {
            exponent += 1;
            1.0
        }
    };
    let step = digit * 10.0_f64.powi(exponent);
    let (first, last) = ((least / step).ceil() as i64, (most / step).floor() as i64);
    let largest = least.abs().max(most.abs()).log10().floor() as i32;
    // Numbers with many zeros are written with an exponent.
    let scale = if (-4..=4).contains(&largest) && exponent >= -4 { 0 } else { largest };
    let decimals = (scale - exponent).max(0) as usize;
    let label = |i: i64| {
        let number = format!("{:.decimals$}", i as f64 * step / 10.0_f64.powi(scale)).replace('-', "−");
        if i == 0 {
            "0".to_owned()
        } else if scale == 0 {
            number
        } else {
            format!("{number}·10{}", superscript(scale))
        }
    };
    (first..=last).map(|i| (i as f64 * step, label(i))).collect()
}

/// Powers of ten, where there is room for them with 2 and 5 times as much. The range is one of decimal logarithms, and so
/// are the places.
pub(crate) fn logarithmic(range: RangeInclusive<f64>, at_most: usize) -> Vec<(f64, String)> {
    let (first, last) = (range.start().ceil() as i32, range.end().floor() as i32);
    let powers = (last - first + 1).max(0) as usize;
    if powers > 2 {
        let stride = powers.div_ceil(at_most.max(2)).max(1) as i32;
        let kept = (first..=last).filter(|exponent| exponent.rem_euclid(stride) == 0);
        return kept.map(|exponent| (f64::from(exponent), power(exponent, short(first, last)))).collect();
    }
    let mut ticks = Vec::new();
    let (first, last) = (first - 1, last.max(first));
    let short = short(first, last);
    for exponent in first..=last {
        for digit in [1_u32, 2, 5] {
            let height = f64::from(exponent) + f64::from(digit).log10();
            if range.contains(&height) {
                ticks.push((height, times_power(digit, exponent, short)));
            }
        }
    }
    if ticks.len() < 2 { linear_heights(range, at_most) } else { ticks }
}

/// Powers of ten of both signs, and zero. The range is one of heights: one for the smallest number that has a logarithm, one
/// more for each decade.
pub(crate) fn signed(range: RangeInclusive<f64>, smallest: f64, at_most: usize) -> Vec<(f64, String)> {
    let height = |exponent: i32| 1.0 + f64::from(exponent) - smallest.log10();
    // The power at the edge of the linear band, and the largest one.
    let first = (smallest.log10() - 1e-9).ceil() as i32;
    let most = range.start().abs().max(range.end().abs());
    let last = (most - 1.0 + smallest.log10() + 1e-9).floor() as i32;
    let short = short(first, last);
    let powers = (last - first + 1).max(1) as usize;
    let sides = if *range.start() < -1.0 && *range.end() > 1.0 { 2 } else { 1 };
    let stride = (sides * powers).div_ceil(at_most.saturating_sub(1).max(2)).max(1);
    let mut ticks = Vec::new();
    // The largest powers are kept, so that a curve which leaves is read best.
    for exponent in (first..=last).rev().step_by(stride) {
        ticks.push((-height(exponent), format!("−{}", power(exponent, short))));
        ticks.push((height(exponent), power(exponent, short)));
    }
    ticks.push((0.0, "0".to_owned()));
    ticks.retain(|(height, _)| range.contains(height));
    ticks.sort_by(|a, b| a.0.total_cmp(&b.0));
    if ticks.len() < 2 {
        let inner = linear((range.start() * smallest)..=(range.end() * smallest), at_most);
        return inner.into_iter().map(|(number, text)| (number / smallest, text)).collect();
    }
    ticks
}

/// Less than a factor of two or so: numbers at equal distances.
fn linear_heights(range: RangeInclusive<f64>, at_most: usize) -> Vec<(f64, String)> {
    let [least, most] = [range.start(), range.end()].map(|height| 10.0_f64.powf(*height));
    linear(least..=most, at_most.min(4)).into_iter().map(|(number, text)| (number.log10(), text)).collect()
}

/// Whether all powers between these exponents are short as plain numbers.
fn short(first: i32, last: i32) -> bool {
    first >= -3 && last <= 4
}

/// A power of ten: as a plain number or with an exponent.
fn power(exponent: i32, short: bool) -> String {
    if short { times_power(1, exponent, true) } else { format!("10{}", superscript(exponent)) }
}

fn times_power(digit: u32, exponent: i32, short: bool) -> String {
    match short {
        true if exponent < 0 => {
            let decimals = exponent.unsigned_abs() as usize;
            format!("{:.decimals$}", f64::from(digit) * 10.0_f64.powi(exponent))
        }
        true => (digit * 10_u32.pow(exponent.unsigned_abs())).to_string(),
        false if digit == 1 => power(exponent, false),
        false => format!("{digit}·{}", power(exponent, false)),
    }
}

/// An exponent in raised digits.
pub(crate) fn superscript(exponent: i32) -> String {
    let raised = |digit: char| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit as u32 - '0' as u32).unwrap_or(digit),
    };
    exponent.to_string().chars().map(raised).collect()
}

#[cfg(test)]
mod tests {
    use super::{linear, logarithmic, signed};

    fn texts(ticks: Vec<(f64, String)>) -> String {
        ticks.into_iter().map(|(_, text)| text).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn linear_ticks_are_round() {
        let cases = [
            (-1.0..=1.0, 5, "−1.0 −0.5 0 0.5 1.0"),
            (0.0..=83.0, 6, "0 20 40 60 80"),
            (0.0..=3e-7, 4, "0 1·10⁻⁷ 2·10⁻⁷ 3·10⁻⁷"),
            (0.0..=2.5e6, 3, "0 1·10⁶ 2·10⁶"),
            (0.97..=1.03, 3, "0.98 1.00 1.02"),
        ];
        for (range, at_most, expected) in cases {
            assert_eq!(texts(linear(range, at_most)), expected);
        }
        assert!(linear(1.0..=1.0, 5).is_empty() && linear(f64::NAN..=1.0, 5).is_empty());
    }

    #[test]
    fn logarithmic_ticks_fill_an_axis_of_any_length_in_one_notation() {
        let cases = [
            (-8.2..=-4.9, 8, "10⁻⁸ 10⁻⁷ 10⁻⁶ 10⁻⁵"),
            (-16.0..=0.0, 5, "10⁻¹⁶ 10⁻¹² 10⁻⁸ 10⁻⁴ 10⁰"),
            (-5.1..=-2.9, 8, "10⁻⁵ 10⁻⁴ 10⁻³"),
            (-2.2..=1.2, 8, "0.01 0.1 1 10"),
            (-2.1..=-0.9, 8, "0.01 0.02 0.05 0.1"),
            (-6.1..=-4.9, 8, "10⁻⁶ 2·10⁻⁶ 5·10⁻⁶ 10⁻⁵"),
            (3.5..=4.2, 8, "5000 10000"),
            (0.1..=0.2, 4, "1.3 1.4 1.5"),
        ];
        for (range, at_most, expected) in cases {
            assert_eq!(texts(logarithmic(range, at_most)), expected);
        }
    }

    #[test]
    fn signed_ticks_have_both_signs_and_zero() {
        let cases = [
            (-4.0..=4.0, 1e-3, 12, "−1 −0.1 −0.01 −0.001 0 0.001 0.01 0.1 1"),
            (-3.0..=9.0, 1e-8, 8, "−10⁻⁶ 0 10⁻⁸ 10⁻⁶ 10⁻⁴ 10⁻² 10⁰"),
            (-0.5..=0.5, 1e-8, 4, "−5·10⁻⁹ 0 5·10⁻⁹"),
        ];
        for (range, smallest, at_most, expected) in cases {
            let ticks = signed(range, smallest, at_most);
            assert!(ticks.windows(2).all(|pair| pair[0].0 < pair[1].0), "{ticks:?}");
            if at_most == 8 {
                assert!(
                    ticks.iter().any(|(height, text)| *height == 0.0 && text == "0") && ticks.len() <= 8,
                    "{ticks:?}"
                );
            } else {
                assert_eq!(texts(ticks), expected);
            }
        }
    }
}
