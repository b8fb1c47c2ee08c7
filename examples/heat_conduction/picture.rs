//! Picture of temperature profiles.

use crate::conductor::Stationary;
use integrator_plot::{Axis, Chart, colour};

/// Draws the measured profiles of the harmonic and of the pinned chain, and the closed form of the first.
pub(crate) fn picture(harmonic: &Stationary, closed_form: &[f64], pinned: &Stationary) -> Chart {
    let places = |count: usize| (0..count).map(move |site| (site as f64 + 0.5) / count as f64);
    let profile = |measured: &Stationary| {
        let temperatures: Vec<f64> = measured.temperatures.iter().map(|mean| mean.value).collect();
        places(temperatures.len()).zip(temperatures).collect::<Vec<_>>()
    };
    let conductivity = pinned.conductivity;
    Chart::new("Temperature in chains between two heat baths")
        .claim("With pinning the temperature falls linearly (Fourier's law). Without, it is the same in the whole bulk")
        .measured(format!("conductivity with pinning {:.2} ± {:.2}", conductivity.value, conductivity.error))
        .along(Axis::linear("place in the chain"))
        .up(Axis::linear("mean square of the momentum"))
        .sized(1000, 640)
        .line("harmonic, closed form", places(closed_form.len()).zip(closed_form.iter().copied()))
        .coloured(colour::GREY)
        .dots("harmonic", profile(harmonic))
        .coloured(colour::COLOURS[6])
        .dots("with pinning", profile(pinned))
        .coloured(colour::COLOURS[3])
}
