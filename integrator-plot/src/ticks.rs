//! The numbers along an axis.

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
    let stride = powers.div_ceil(at_most.max(2)).max(1);
    if powers > 2 {
        let kept = (first..=last).filter(|exponent| exponent.rem_euclid(stride as i32) == 0);
        return kept.map(|exponent| (f64::from(exponent), power(exponent))).collect();
    }
    let mut ticks = Vec::new();
    for exponent in first - 1..=last.max(first) {
        for digit in [1_i32, 2, 5] {
            let height = f64::from(exponent) + f64::from(digit).log10();
            let text = match exponent {
                _ if digit == 1 => power(exponent),
                0..=4 => format!("{}", digit * 10_i32.pow(exponent.unsigned_abs())),
                -3..=-1 => format!("0.{digit:0>width$}", width = exponent.unsigned_abs() as usize),
                _ => format!("{digit}·{}", power(exponent)),
            };
            if range.contains(&height) {
                ticks.push((height, text));
            }
        }
    }
    if ticks.len() < 2 { linear_heights(range, at_most) } else { ticks }
}

/// Less than a factor of two or so: numbers at equal distances.
fn linear_heights(range: RangeInclusive<f64>, at_most: usize) -> Vec<(f64, String)> {
    let [least, most] = [range.start(), range.end()].map(|height| 10.0_f64.powf(*height));
    linear(least..=most, at_most.min(4)).into_iter().map(|(number, text)| (number.log10(), text)).collect()
}

/// A power of ten: as a number while that is short, else with an exponent.
fn power(exponent: i32) -> String {
    match exponent {
        0..=4 => format!("{}", 10_u32.pow(exponent.unsigned_abs())),
        -3..=-1 => format!("{:.*}", exponent.unsigned_abs() as usize, 10.0_f64.powi(exponent)),
        _ => format!("10{}", superscript(exponent)),
    }
}

fn superscript(exponent: i32) -> String {
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
    use super::{linear, logarithmic, power};

    fn texts(ticks: Vec<(f64, String)>) -> String {
        ticks.into_iter().map(|(_, text)| text).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn powers_are_short() {
        for (exponent, text) in [(-12, "10⁻¹²"), (-2, "0.01"), (0, "1"), (3, "1000"), (7, "10⁷")] {
            assert_eq!(power(exponent), text);
        }
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
    fn logarithmic_ticks_fill_an_axis_of_any_length() {
        let cases = [
            (-8.2..=-4.9, 8, "10⁻⁸ 10⁻⁷ 10⁻⁶ 10⁻⁵"),
            (-16.0..=0.0, 5, "10⁻¹⁶ 10⁻¹² 10⁻⁸ 10⁻⁴ 1"),
            (-2.1..=-0.9, 8, "0.01 0.02 0.05 0.1"),
            (3.5..=4.2, 8, "5000 10000"),
            (0.1..=0.2, 4, "1.3 1.4 1.5"),
        ];
        for (range, at_most, expected) in cases {
            assert_eq!(texts(logarithmic(range, at_most)), expected);
        }
    }
}
