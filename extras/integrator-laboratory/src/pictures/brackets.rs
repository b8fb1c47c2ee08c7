//! The Poisson bracket after one step, along the orbit.

use crate::{numbers::plain, study::Study};
use integrator_plot::{Axis, Chart, Mark, colour::INK};

/// Lines by formula, dots by the derivative of the step.
pub(super) fn brackets(study: &Study) -> Option<Chart> {
    let (rows, bracket, curvature) = (study.brackets.as_ref()?, study.bracket(), &study.curvature);
    let inverse = if rows.len() > 2 {
        format!("; backward Euler divides by 1 + h² {curvature}, at the end of the step")
    } else {
        String::new()
    };
    let claim = format!(
        "After one step {bracket} is 1 for symplectic Euler, and 1 + h² {curvature} for forward Euler{inverse}. Lines: these formulas along \
         the orbit. Dots: the exact derivative of the step."
    );
    let farthest = rows.iter().map(|row| row.off()).fold(0.0, f64::max);
    let chart = Chart::new(format!("Poisson bracket of one step: {}", study.system))
        .claim(claim)
        .measured(format!("step {}; largest distance from the formulas: {}", plain(study.step), plain(farthest)))
        .along(Axis::linear("periods"))
        .up(Axis::linear(bracket))
        .with_names_at_ends();
    Some(rows.iter().fold(chart, |chart, row| {
        let ink = crate::colour(row.name).unwrap_or(INK);
        let chart = chart.line(row.name, row.formula.iter().copied()).coloured(ink).wide(1.25);
        chart.series(Mark::Dots, "", row.measured.iter().copied()).coloured(ink).wide(1.0)
    }))
}
