//! Instructions per step: stored counts and measured counts.
//!
//! Load on the machine changes times and no counts, so counts are compared to two per cent.

use std::{collections::BTreeMap, fmt};

/// By how much a count may exceed the one that is kept, relative to it.
pub const SLACK: f64 = 0.02;

/// Instructions per step, by problem.
pub type Counts = BTreeMap<String, f64>;

/// One problem's two counts.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Its name.
    pub problem: String,
    /// What the repository has, if it knows the problem.
    pub kept: Option<f64>,
    /// What was counted, if the problem still exists.
    pub counted: Option<f64>,
}

impl Difference {
    /// How much the count has grown, relative to what is kept; nothing if one of the two is missing.
    pub fn growth(&self) -> Option<f64> {
        Some(self.counted? / self.kept? - 1.0)
    }

    /// Whether the kept count still holds: a known problem, no slower by more than the slack.
    pub fn holds(&self) -> bool {
        self.growth().is_some_and(|growth| growth <= SLACK)
    }

    /// Whether it is so much faster that the kept count would let a later slowdown through.
    pub fn is_outdone(&self) -> bool {
        self.growth().is_some_and(|growth| growth < -SLACK)
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = |count: Option<f64>| count.map_or("-".to_owned(), |count| format!("{count:.1}"));
        let growth = self.growth().map_or("new or gone".to_owned(), |growth| format!("{:+.1} %", 100.0 * growth));
        let remark = match () {
            () if !self.holds() => "  over the slack",
            () if self.is_outdone() => "  faster: bless it",
            () => "",
        };
        let (kept, counted) = (number(self.kept), number(self.counted));
        write!(f, "{:<24} {kept:>12} {counted:>12} {growth:>12}{remark}", self.problem)
    }
}

/// Every problem that is kept or was counted.
pub fn compare(kept: &Counts, counted: &Counts) -> Vec<Difference> {
    let mut problems: Vec<&String> = kept.keys().chain(counted.keys()).collect();
    problems.sort();
    problems.dedup();
    let of = |counts: &Counts, problem: &String| counts.get(problem).copied();
    let difference = |problem: &String| Difference {
        problem: problem.clone(),
        kept: of(kept, problem),
        counted: of(counted, problem),
    };
    problems.into_iter().map(difference).collect()
}

/// Reads the file that the repository keeps.
///
/// # Errors
/// If a row is not a name and a number.
pub fn read(text: &str) -> Result<Counts, csv::Error> {
    csv::Reader::from_reader(text.as_bytes()).deserialize().collect()
}

/// The text of that file.
pub fn write(counts: &Counts) -> String {
    let rows = counts.iter().map(|(problem, count)| format!("{problem},{count:.1}\n"));
    rows.fold("problem,instructions per step\n".to_owned(), |text, row| text + &row)
}

/// The instructions of a whole program, from what callgrind writes.
pub fn total(callgrind: &str) -> Option<u64> {
    callgrind.lines().find_map(|line| line.strip_prefix("totals: ")?.trim().parse().ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(rows: &[(&str, f64)]) -> Counts {
        rows.iter().map(|(problem, count)| ((*problem).to_owned(), *count)).collect()
    }

    #[test]
    fn a_slowdown_fails_and_the_slack_does_not() {
        let kept = counts(&[("faster", 100.0), ("gone", 100.0), ("same", 100.0), ("slack", 100.0), ("slower", 100.0)]);
        let counted = counts(&[("faster", 90.0), ("new", 100.0), ("same", 100.0), ("slack", 101.9), ("slower", 102.1)]);
        let verdicts: Vec<(String, bool, bool)> = compare(&kept, &counted)
            .into_iter()
            .map(|difference| (difference.problem.clone(), difference.holds(), difference.is_outdone()))
            .collect();
        let expected = [
            ("faster", true, true),
            ("gone", false, false),
            ("new", false, false),
            ("same", true, false),
            ("slack", true, false),
            ("slower", false, false),
        ];
        assert_eq!(verdicts, expected.map(|(problem, holds, outdone)| (problem.to_owned(), holds, outdone)));
    }

    #[test]
    fn written_counts_are_read_back() {
        let kept = counts(&[("kepler", 41.5), ("pendulum", 60.0)]);
        assert_eq!(read(&write(&kept)).expect("rows"), kept);
        assert!(read("problem,instructions per step\nkepler,many\n").is_err());
    }

    #[test]
    fn the_total_is_found() {
        assert_eq!(total("version: 1\nevents: Ir\nsummary: 12\n\ntotals: 345\n"), Some(345));
        assert_eq!(total("events: Ir\n"), None);
    }
}
