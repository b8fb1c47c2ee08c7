//! Energy against time.

use super::{Drawing, style::styled};
use crate::{measured::Measured, study::Study};
use integrator_plot::{Axis, Chart, colour::GREY};

/// Up to this order, changes can be seen on a linear axis.
const LOW: u32 = 2;

/// The methods of low order on a linear axis: growth and decay.
pub(super) fn low_orders(study: &Study) -> Drawing {
    let low = || study.methods.iter().filter(|measured| measured.order <= LOW);
    // The symplectic ones decide the axis, with room for the others to leave it.
    let kept = low().filter(|measured| measured.keeps_bracket()).map(Measured::largest_energy_change);
    let most = 4.0 * kept.fold(0.005, f64::max);
    let numbers = low().map(|measured| format!("{} {:+.1e}", measured.name, measured.energy_change()));
    let chart = Chart::new(format!("Energy against time: {}", study.system))
        .claim("Forward Euler gains energy, backward Euler loses it; that of symplectic methods oscillates.")
        .measured(format!("at the end: {}", numbers.collect::<Vec<_>>().join(", ")))
        .along(Axis::linear("periods"))
        .up(Axis::linear("(E − E₀) / |E₀|").between(-most, most));
    let still = chart.line("", ends(study).map(|periods| (periods, 0.0))).coloured(GREY);
    let low = styled(study).filter(|(measured, _)| measured.order <= LOW);
    Drawing::Chart(low.fold(still, |chart, (measured, style)| {
        style.apply(chart.line(measured.name, measured.energies.iter().copied()))
    }))
}

/// All methods on a logarithmic axis: drifts are lines that rise.
pub(super) fn all(study: &Study) -> Drawing {
    // By which factor the second half of the time raises the largest error.
    let growth = |name: &str| {
        let errors: Vec<(f64, f64)> = envelope(study.method(name)?).collect();
        Some(format!("{name} {:.2}", errors.last()?.1 / errors.get(errors.len() / 2)?.1))
    };
    let growths: Vec<String> = ["Verlet", "Runge–Kutta 4", "Yoshida 4"].into_iter().filter_map(growth).collect();
    let chart = Chart::new(format!("Energy error against time: {}", study.system))
        .claim("The error of a symplectic method stays where it is, that of the others grows with time, whatever their order.")
        .measured(format!("step {}; at the end over half of the time: {}", study.step, growths.join(", ")))
        .along(Axis::linear("periods"))
        .up(Axis::logarithmic("|E − E₀| / |E₀|, largest so far"))
        .sized(1100, 720);
    Drawing::Chart(
        styled(study)
            .fold(chart, |chart, (measured, style)| style.apply(chart.line(measured.name, envelope(measured)))),
    )
}

/// The largest error so far, from the first step on.
fn envelope(measured: &Measured) -> impl Iterator<Item = (f64, f64)> {
    let changes = measured.energies.iter().skip(1);
    changes.scan(f64::EPSILON, |largest, (periods, change)| {
        *largest = largest.max(change.abs());
        Some((*periods, *largest))
    })
}

fn ends(study: &Study) -> impl Iterator<Item = f64> {
    let last = study.methods.iter().filter_map(|measured| measured.energies.last()).map(|(periods, _)| *periods);
    [0.0, last.fold(0.0, f64::max)].into_iter()
}
