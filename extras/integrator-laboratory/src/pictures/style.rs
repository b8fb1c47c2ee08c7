//! The style of each method in all charts: a fixed colour, with solid lines for symplectic methods and dashed lines for
//! others.

use crate::{measured::Measured, methods::Adaptive, rows::Row};
use integrator_plot::{Chart, Mark};

/// The methods that a page shows at first: as many lines as one can tell apart. The others are optional.
const FIRST: [&str; 8] = [
    "forward Euler",
    "backward Euler",
    "symplectic Euler",
    "Verlet",
    "implicit midpoint",
    "Runge–Kutta 4",
    "Yoshida 4",
    "Dormand–Prince 5",
];

/// One more series of a chart, of a method.
pub(super) fn series(
    chart: Chart,
    mark: Mark,
    (row, symplectic): (&Row, bool),
    name: String,
    points: impl IntoIterator<Item = (f64, f64)>,
) -> Chart {
    let chart = chart.series(mark, name, points).coloured(row.colour).wide(1.75);
    let chart = if symplectic { chart } else { chart.dashed() };
    if FIRST.contains(&row.name) { chart } else { chart.optional() }
}

/// A series of a method with steps of the run.
pub(super) fn of_method(
    chart: Chart,
    mark: Mark,
    measured: &Measured,
    points: impl IntoIterator<Item = (f64, f64)>,
) -> Chart {
    series(chart, mark, (&measured.row, measured.symplectic), measured.name().to_owned(), points)
}

/// A series of a method that chooses its steps.
pub(super) fn of_adaptive(
    chart: Chart,
    mark: Mark,
    adaptive: &Adaptive,
    points: impl IntoIterator<Item = (f64, f64)>,
) -> Chart {
    series(chart, mark, (&adaptive.row, false), adaptive.row.name.to_owned(), points)
}
