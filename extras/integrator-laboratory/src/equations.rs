//! The equations that the macro derived, in the symbols of the page.

/// Writes a formula of [`EQUATIONS`](integrator_core::Hamiltonian::EQUATIONS) for readers: `symbols` are those of all positions,
/// then all momenta, and `components` is the number of coordinates of a point.
pub(crate) fn readable(line: &str, symbols: &[String], components: usize) -> String {
    let freedom = symbols.len() / 2;
    let (mut text, mut rest) = (String::new(), line);
    while let Some(letter) = rest.chars().next() {
        let first = if letter == 'p' { freedom } else { 0 };
        if let Some((index, length)) = numbered(rest, components).filter(|(index, _)| *index < freedom) {
            text.push_str(&symbols[first + index]);
            rest = &rest[length..];
            continue;
        }
        match letter {
            '-' => text.push('−'),
            '^' => {
                let digits = rest[1..].chars().take_while(char::is_ascii_digit).count();
                text.extend(
                    rest[1..=digits].chars().filter_map(|digit| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit.to_digit(10)? as usize)),
                );
                if digits == 0 {
                    text.push('^');
                }
                rest = &rest[digits..];
            }
            letter => text.push(letter),
        }
        rest = &rest[letter.len_utf8()..];
    }
    text.replace("sqrt(", "√(")
}

/// The number of the coordinate with which a text begins, such as `q[1]` or `p[2][0]`, and the length of its name.
fn numbered(text: &str, components: usize) -> Option<(usize, usize)> {
    let mut rest = text.strip_prefix(['q', 'p'])?;
    let mut indices = Vec::new();
    while let Some((index, after)) = rest.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
        indices.push(index.parse::<usize>().ok()?);
        rest = after;
    }
    let index = match (&indices[..], components) {
        ([index], 1) => *index,
        ([point, component], count) if *component < count => point.checked_mul(count)? + component,
        _ => return None,
    };
    Some((index, text.len() - rest.len()))
}

#[cfg(test)]
mod tests {
    use super::readable;

    #[test]
    fn coordinates_have_the_symbols_of_the_page() {
        let symbols = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
        let pendulum = |line| readable(line, &symbols(&["θ", "ω"]), 1);
        assert_eq!(pendulum("dp[0]/dt = -sin(q[0])"), "dω/dt = −sin(θ)");
        assert_eq!(pendulum("T = p[0]^2 / 2"), "T = ω² / 2");
        assert_eq!(pendulum("V = depth^(3/2) sqrt(q[0]^12 + 1)"), "V = depth^(3/2) √(θ¹² + 1)");
        // Coordinates of a loop, and those that there are not, keep their indices.
        assert_eq!(pendulum("dq[i + 1]/dt = p[i] - q[7]"), "dq[i + 1]/dt = p[i] − q[7]");
        let plane = symbols(&["x₁", "y₁", "x₂", "y₂", "a", "b", "c", "d"]);
        assert_eq!(readable("dp[1][0]/dt = q[0][1] + q[1]", &plane, 2), "dc/dt = y₁ + q[1]");
    }
}
