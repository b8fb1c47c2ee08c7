//! Energy against time.

use super::style::{of_adaptive, of_method};
use crate::{
    measured::Measured,
    methods::LOOSE,
    numbers::{plain, signed},
    study::Study,
};
use integrator_plot::{Axis, Chart, Mark, colour::GREY};

/// Up to this order, changes can be seen on a linear axis.
const LOW: u32 = 2;
/// The periods in which they are.
const SHOWN: f64 = 4.0;

/// The methods of low order on a linear axis, for a few periods: growth, decay and swing.
pub(super) fn low_orders(study: &Study) -> Chart {
    let low = || study.methods.iter().filter(|measured| measured.order <= LOW);
    // The symplectic ones decide the axis, with room for the others to leave it.
    let kept = low().filter(|measured| measured.symplectic).map(Measured::largest_energy_change);
    let most = 2.0 * kept.fold(0.005, f64::max);
    let chart = Chart::new(format!("Energy in the first periods: {}", study.system))
        .claim("The energy of symplectic methods oscillates with the motion. With forward and backward Euler it leaves the frame within a period; with the explicit midpoint rule it grows.")
        .measured(format!("steps of {}", plain(study.step)))
        .along(Axis::linear("periods"))
        .up(Axis::linear("(E − E₀) / K").between(-most, most));
    let still = chart.line("", [(0.0, 0.0), (SHOWN, 0.0)]).coloured(GREY).wide(1.0);
    low().fold(still, |chart, measured| {
        let shown = measured.energies.iter().copied().take_while(|(periods, _)| *periods <= SHOWN);
        of_method(chart, Mark::Line, measured, shown)
    })
}

/// All methods on a signed logarithmic axis: of each period the change that is largest, with its sign.
pub(super) fn extremes(study: &Study) -> Chart {
    let least = study.methods.iter().map(Measured::largest_energy_change).fold(f64::INFINITY, f64::min);
    let smallest = 10.0_f64.powf(least.max(f64::EPSILON).log10().floor());
    let ends = |name: &str| Some(format!("{name} {}", signed(study.method(name)?.energy_change())));
    let numbers: Vec<String> = ["forward Euler", "Runge–Kutta 4"].into_iter().filter_map(ends).collect();
    let claim = format!(
        "The largest energy change in each period: a gain is drawn upwards, a loss downwards. Symplectic methods, solid, stay level. Others, dashed, \
         drift whatever their order; adaptive ones have a tolerance of {}.",
        plain(LOOSE)
    );
    let chart = Chart::new(format!("Energy error against time: {}", study.system))
        .claim(claim)
        .measured(format!("steps of {}; at the end: {}", plain(study.step), numbers.join(", ")))
        .along(Axis::linear("periods"))
        .up(Axis::signed_logarithmic("(E − E₀) / K", smallest))
        .with_names_at_ends()
        .sized(1150, 820);
    let chart = study
        .methods
        .iter()
        .fold(chart, |chart, measured| of_method(chart, Mark::Line, measured, extreme_of_periods(&measured.energies)));
    study
        .adaptive
        .iter()
        .fold(chart, |chart, adaptive| of_adaptive(chart, Mark::Line, adaptive, extreme_of_periods(&adaptive.energies)))
}

/// The change of largest size in each whole period. Where its sign changes, the curve is broken: it does not pass through all
/// that lies between on a logarithmic axis.
fn extreme_of_periods(energies: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let Some((end, _)) = energies.last() else { return Vec::new() };
    let chunks = energies.chunk_by(|a, b| a.0.floor() == b.0.floor());
    // A period that is not over would end curves with less than they have.
    let whole = chunks.filter(|chunk| chunk.first().is_some_and(|first| first.0.floor() + 0.9 < *end));
    let extreme = whole.filter_map(|chunk| {
        let (time, _) = chunk.first()?;
        let change = chunk.iter().map(|(_, change)| *change).max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
        Some((time.floor() + 0.5, change))
    });
    let mut curve: Vec<(f64, f64)> = Vec::new();
    for (time, change) in extreme {
        if curve.last().is_some_and(|(_, last)| last * change < 0.0) {
            curve.push((time, f64::NAN));
        }
        curve.push((time, change));
    }
    curve
}
