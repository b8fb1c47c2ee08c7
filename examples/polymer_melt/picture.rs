//! Picture of the cost of an accuracy, with inner steps and without.

use integrator_plot::{Axis, Chart, Mark, Marker, colour};

/// Points of milliseconds and energy errors.
pub(crate) type Curve = Vec<(f64, f64)>;

/// Draws the errors of Verlet's method and of runs with inner steps, and how much less time those take.
pub(crate) fn picture(verlet: Curve, nested: Curve, ratio: f64) -> Chart {
    Chart::new("A polymer melt with stiff bonds")
        .claim("2,000 beads over a time of 1: bonds take inner steps, and the Lennard-Jones forces of pairs take outer steps")
        .measured(format!("eight inner steps take {ratio:.1} times less time for the same error"))
        .along(Axis::logarithmic("milliseconds on one core"))
        .up(Axis::logarithmic("largest energy error"))
        .series(Mark::Dotted, "Verlet", verlet)
        .coloured(colour::INK)
        .series(Mark::Dotted, "eight inner steps", nested)
        .coloured(colour::COLOURS[1])
        .marked(Marker::Square)
}
