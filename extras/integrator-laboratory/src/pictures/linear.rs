//! The oscillator, diagonalised: eigenvalues of steps, and the energy that they gain or lose.

use crate::{
    linear::{LONGEST, Map},
    numbers::plain,
    roots::{points, turned},
    study::Study,
};
use integrator_plot::{
    Axis, Chart, Mark, Panels,
    colour::{GREY, INK},
};
use nalgebra::ComplexField;

/// Eigenvalues beside the unit circle, and the factors by which a step multiplies the energy.
pub(super) fn linear(study: &Study) -> Option<Panels> {
    let linear = study.models.linear.as_ref()?;
    let claim = "On the oscillator z′ = Az with ω = 1 each step is a matrix. Dots: its measured eigenvalue in the upper half plane. Lines: the \
                 closed form, R(ih) for Runge–Kutta methods and exp(iθ) with 2 cos θ = tr M for compositions. A step multiplies the energy \
                 by |λ|²: Runge–Kutta 4 loses h⁶/72.";
    let eigenvalues = Chart::new("Eigenvalues")
        .claim("grey: the unit circle, on which those of symplectic methods lie")
        .along(Axis::linear("Re λ").between(-0.2, 1.3))
        .up(Axis::linear("Im λ").between(0.0, 1.5))
        .with_equal_units()
        .line("", points(&(0..=60).map(|part| turned(0.03 * f64::from(part))).collect::<Vec<_>>()))
        .coloured(GREY)
        .wide(4.0);
    let eigenvalues = curves(eigenvalues, linear.maps.iter(), |_, value| (value.re, value.im));
    let factors = Chart::new("Gain or loss of energy in a step")
        .claim("methods whose eigenvalues leave the circle")
        .along(Axis::logarithmic("hω"))
        .up(Axis::logarithmic("| |λ|² − 1 |").between(1e-13, 10.0))
        .with_names_at_ends();
    let leaving = linear.maps.iter().filter(|map| !map.symplectic);
    let factors = curves(factors, leaving, |x, value| (x, (value.modulus_squared() - 1.0).abs()));
    let panels = Panels::new(format!("The oscillator, diagonalised: {}", study.system), claim).measured(format!(
        "largest distance from the closed form: {}; of symplectic methods from the circle: {}",
        plain(linear.off()),
        plain(linear.off_circle())
    ));
    Some(panels.columns(2).panel(560, 400).chart(eigenvalues).chart(factors))
}

/// A line in closed form and dots as measured for each method.
fn curves<'m>(
    chart: Chart,
    maps: impl Iterator<Item = &'m Map>,
    place: impl Fn(f64, crate::roots::Complex) -> (f64, f64),
) -> Chart {
    maps.fold(chart, |chart, map| {
        let ink = crate::colour(map.name).unwrap_or(INK);
        let exact = map.formula.map(|formula| {
            (2..=60).map(|part| LONGEST * f64::from(part) / 60.0).map(|x| place(x, formula(x))).collect::<Vec<_>>()
        });
        let measured = map.measured.iter().map(|(x, value)| place(*x, *value));
        // Those on the circle lie on each other.
        let name = if map.symplectic { "" } else { map.name };
        let chart = match exact {
            Some(line) => chart.line(name, line).coloured(ink).wide(1.25),
            None => chart.line(name, measured.clone()).coloured(ink).dashed().wide(0.75),
        };
        chart.series(Mark::Dots, "", measured).coloured(ink).wide(1.0)
    })
}
