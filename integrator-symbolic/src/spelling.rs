//! Suggestions for misspelt names.

/// How many names are offered.
const OFFERED: usize = 3;

/// Returns the known names nearest to `typed`, at most three, nearest first.
///
/// A name is near if at most a third of its letters differ, or two letters of a short name. A name is also near if it
/// begins with `typed`, or `typed` with it.
pub fn nearest<'k>(typed: &str, known: &'k [String]) -> Vec<&'k str> {
    let limit = (typed.chars().count() / 3).max(2);
    let begins = |name: &str| name.len().min(typed.len()) > 2 && (name.starts_with(typed) || typed.starts_with(name));
    let mut near: Vec<(usize, &str)> = known
        .iter()
        .map(|name| (distance(typed, name), name.as_str()))
        .filter(|(distance, name)| *distance <= limit || begins(name))
        .collect();
    near.sort();
    near.dedup();
    near.into_iter().take(OFFERED).map(|(_, name)| name).collect()
}

/// How many letters have to be put in, left out or replaced between two words (Levenshtein).
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, other) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(letter != *other);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_count_letters() {
        for (a, b, expected) in [("", "abc", 3), ("sinn", "sin", 1), ("flaw", "lawn", 2), ("kitten", "sitting", 3)] {
            assert_eq!(distance(a, b), expected, "{a} and {b}");
            assert_eq!(distance(b, a), expected, "{b} and {a}");
        }
    }

    #[test]
    fn names_that_are_far_are_not_offered() {
        let known = ["sin", "sinh", "asin", "sqrt", "tanh", "exp_m1"].map(str::to_owned);
        assert_eq!(nearest("sine", &known), ["sin", "sinh", "asin"]);
        assert_eq!(nearest("exp_m", &known), ["exp_m1"]);
        assert!(nearest("determinant", &known).is_empty());
    }
}
