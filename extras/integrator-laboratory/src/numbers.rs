//! Formatting of numbers for readers.

/// Formats a number to three digits, in plain notation if that is short, otherwise with a power of ten.
#[must_use]
pub fn plain(number: f64) -> String {
    if number.is_nan() {
        return "not measured".to_owned();
    }
    if number.is_infinite() {
        return if number > 0.0 { "beyond all bounds" } else { "below all bounds" }.to_owned();
    }
    if number == 0.0 {
        return "0".to_owned();
    }
    let rounded = format!("{number:.2e}");
    let (digits, exponent) = rounded.split_once('e').unwrap_or((&rounded, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let text = match exponent {
        -3..=4 => {
            let decimals = (2 - exponent).max(0) as usize;
            trimmed(&format!("{number:.decimals$}")).to_owned()
        }
        _ => {
            let raised: String = exponent.to_string().chars().map(raised).collect();
            match trimmed(digits) {
                "1" => format!("10{raised}"),
                "-1" => format!("-10{raised}"),
                digits => format!("{digits}·10{raised}"),
            }
        }
    };
    text.replace('-', "−")
}

/// Formats as [`plain`], with a sign for positive numbers.
#[must_use]
pub fn signed(number: f64) -> String {
    if number > 0.0 && number.is_finite() { format!("+{}", plain(number)) } else { plain(number) }
}

/// Without zeros at the end of a fraction.
fn trimmed(digits: &str) -> &str {
    if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits }
}

fn raised(digit: char) -> char {
    match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit as u32 - '0' as u32).unwrap_or(digit),
    }
}

#[cfg(test)]
mod tests {
    use super::{plain, signed};

    #[test]
    fn numbers_are_short() {
        let cases = [
            (1.42, "1.42"),
            (2.0, "2"),
            (1.998, "2"),
            (0.00412, "0.00412"),
            (-0.5, "−0.5"),
            (12345.6, "12346"),
            (4.1e-12, "4.1·10⁻¹²"),
            (-1e-16, "−10⁻¹⁶"),
            (1e6, "10⁶"),
            (0.0, "0"),
            (f64::NAN, "not measured"),
            (f64::INFINITY, "beyond all bounds"),
        ];
        for (number, text) in cases {
            assert_eq!(plain(number), text);
        }
        assert_eq!([signed(0.1), signed(-0.1), signed(0.0)], ["+0.1", "−0.1", "0"]);
    }
}
