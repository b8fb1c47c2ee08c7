//! Instructions per step: stored counts and measured counts.
//!
//! Load on the machine changes times but not counts. A tolerance of two per cent therefore suffices.

use std::{collections::BTreeMap, fmt};

/// Largest relative excess of a count over the stored one.
pub const SLACK: f64 = 0.02;

/// Instructions per step, by problem.
pub type Counts = BTreeMap<String, f64>;

/// Stored and measured count of a problem.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Name of the problem.
    pub problem: String,
    /// Stored count, if there is one.
    pub kept: Option<f64>,
    /// Measured count, if the problem still exists.
    pub counted: Option<f64>,
}

impl Difference {
    /// Returns the relative growth of the count, or `None` if one of the two is missing.
    pub fn growth(&self) -> Option<f64> {
        Some(self.counted? / self.kept? - 1.0)
    }

    /// Returns whether both counts exist and the growth is within the tolerance.
    pub fn holds(&self) -> bool {
        self.growth().is_some_and(|growth| growth <= SLACK)
    }

    /// Returns whether the count is so much smaller that the stored one would hide a later slowdown.
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

/// Compares the counts of all problems that are stored or measured.
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

/// Parses the stored counts.
///
/// # Errors
/// If a row does not consist of a name and a number.
pub fn read(text: &str) -> Result<Counts, csv::Error> {
    csv::Reader::from_reader(text.as_bytes()).deserialize().collect()
}

/// Formats counts for storage.
pub fn write(counts: &Counts) -> String {
    let rows = counts.iter().map(|(problem, count)| format!("{problem},{count:.1}\n"));
    rows.fold("problem,instructions per step\n".to_owned(), |text, row| text + &row)
}

/// Parses the instruction count of a whole program from the output of callgrind.
pub fn total(callgrind: &str) -> Option<u64> {
    callgrind.lines().find_map(|line| line.strip_prefix("totals: ")?.trim().parse().ok())
}
