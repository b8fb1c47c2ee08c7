//! Picture of the attractor and of a part of it.

use integrator_plot::{Axis, Chart, Panels, colour};

/// Part of the section that the second panel shows: in `x` and in `x'`.
const PART: [[f64; 2]; 2] = [[0.9, 1.2], [0.1, 0.4]];

/// Draws the section of the attractor, and a part of it.
pub(crate) fn picture(points: &[(f64, f64)], exponent: f64, dimension: f64) -> Panels {
    let [[left, right], [low, high]] = PART;
    let chart = |title: &str| Chart::new(title).along(Axis::linear("x")).up(Axis::linear("x'"));
    let whole = chart("Strange attractor")
        .claim("Once per period of the drive. The square is the part on the right")
        .cloud("", points.iter().copied())
        .coloured(colour::COLOURS[6])
        .line("", [(left, low), (right, low), (right, high), (left, high), (left, low)])
        .coloured(colour::COLOURS[3]);
    let inside = points.iter().copied().filter(|(x, v)| (left..right).contains(x) && (low..high).contains(v));
    let part = chart("A part of it").claim("Sheets consist of sheets").cloud("", inside).coloured(colour::COLOURS[6]);
    Panels::new("Duffing's oscillator", "Friction shrinks areas, and chaos stretches and folds them")
        .measured(format!("largest Lyapunov exponent {exponent:.3}, dimension {dimension:.2}"))
        .columns(2)
        .panel(620, 560)
        .chart(whole)
        .chart(part)
}
