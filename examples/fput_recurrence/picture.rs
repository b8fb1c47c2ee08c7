//! Picture of the energies of the lowest modes over time.

use crate::chain::ModeShares;
use integrator_plot::{Axis, Chart, colour};

/// Draws the modes of an accurate run, the lowest mode with the original step, and the recurrence `(periods, share)`.
pub(crate) fn picture<const MODES: usize>(
    exact: &[ModeShares<MODES>],
    theirs: &[ModeShares<1>],
    (periods, share): (f64, f64),
) -> Chart {
    let chart = Chart::new("Recurrence in the chain of Fermi, Pasta, Ulam and Tsingou")
        .claim("The energy moves from the lowest mode to the next ones and returns, instead of spreading over all 31 modes")
        .measured(format!("{:.1} % of the energy is back after {periods:.1} periods", 100.0 * share))
        .along(Axis::linear("time in periods of the lowest mode"))
        .up(Axis::linear("share of the energy"))
        .sized(1200, 640);
    let curve = |mode: usize| exact.iter().map(move |(time, shares)| (*time, shares[mode]));
    let chart = (0..MODES).fold(chart, |chart, mode| chart.line(format!("mode {}", mode + 1), curve(mode)));
    let lowest = theirs.iter().map(|(time, shares)| (*time, shares[0]));
    chart.line("mode 1, original step", lowest).coloured(colour::GREY).dashed()
}
