//! A grid of points in a plane, evaluated row by row.

use integrator_core::{chaos::Verdict, check::CheckError};

/// A grid of points over a rectangle.
pub(crate) struct Grid {
    pub(crate) along: (f64, f64),
    pub(crate) up: (f64, f64),
    pub(crate) columns: usize,
    pub(crate) rows: usize,
}

impl Grid {
    /// Returns the points of a row, at the centres of its cells. Row 0 is the lowest.
    pub(crate) fn places(&self, row: usize) -> Vec<(f64, f64)> {
        let middle = |(least, most): (f64, f64), cell: usize, cells: usize| {
            least + (most - least) * (cell as f64 + 0.5) / cells as f64
        };
        let place = |column| (middle(self.along, column, self.columns), middle(self.up, row, self.rows));
        (0..self.columns).map(place).collect()
    }

    /// Evaluates the points row by row, until `go_on` returns false.
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

/// Returns the regular share of the orbits.
pub(crate) fn regular(rows: &[Vec<f64>]) -> f64 {
    let orbits = rows.iter().flatten().filter(|megno| megno.is_finite());
    let regular = orbits.clone().filter(|megno| Verdict::of_megno(**megno) == Verdict::Regular);
    regular.count() as f64 / orbits.count() as f64
}
