//! Points of a plane, row by row.

use integrator_core::{chaos::Verdict, check::CheckError};

/// A rectangle of so many points.
pub(crate) struct Grid {
    pub(crate) along: (f64, f64),
    pub(crate) up: (f64, f64),
    pub(crate) columns: usize,
    pub(crate) rows: usize,
}

impl Grid {
    /// The points of a row, counted from below: the middles of its cells.
    pub(crate) fn places(&self, row: usize) -> Vec<(f64, f64)> {
        let middle = |(least, most): (f64, f64), cell: usize, cells: usize| {
            least + (most - least) * (cell as f64 + 0.5) / cells as f64
        };
        let place = |column| (middle(self.along, column, self.columns), middle(self.up, row, self.rows));
        (0..self.columns).map(place).collect()
    }

    /// Numbers for the points of each row, as long as it is to go on.
    pub(crate) fn rows(
        &self,
        of_places: impl Fn(&[(f64, f64)]) -> Result<Vec<f64>, CheckError>,
        goes_on: &mut impl FnMut() -> bool,
    ) -> Result<Vec<Vec<f64>>, CheckError> {
        let mut rows = Vec::with_capacity(self.rows);
        for row in 0..self.rows {
            rows.push(of_places(&self.places(row))?);
            if !goes_on() {
                break;
            }
        }
        Ok(rows)
    }
}

/// The share of the orbits that are regular.
pub(crate) fn regular(rows: &[Vec<f64>]) -> f64 {
    let orbits = rows.iter().flatten().filter(|megno| megno.is_finite());
    let regular = orbits.clone().filter(|megno| Verdict::of_megno(**megno) == Verdict::Regular);
    regular.count() as f64 / orbits.count() as f64
}
