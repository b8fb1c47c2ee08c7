//! Picture of draws from the posterior and of the probability of distress by temperature.

use crate::{posterior::Posterior, statistics::moments};
use integrator_plot::{Axis, Chart, Panels, colour};

/// Temperature on the morning of the Challenger launch, in °F.
pub(crate) const MORNING: f64 = 31.0;

/// Returns the probability of distress at a temperature for each draw.
pub(crate) fn probabilities(posterior: &Posterior, draws: &[[f64; 2]], temperature: f64) -> Vec<f64> {
    draws.iter().map(|b| posterior.probability(*b, temperature)).collect()
}

/// Returns a quantile of a series.
fn quantile(mut series: Vec<f64>, share: f64) -> f64 {
    series.sort_by(f64::total_cmp);
    series[(share * (series.len() - 1) as f64) as usize]
}

/// Draws the posterior and the probability of distress. There has to be at least one draw.
pub(crate) fn picture(posterior: &Posterior, draws: &[[f64; 2]], mean: [f64; 2], acceptance: f64) -> Panels {
    let at = |temperature: f64| probabilities(posterior, draws, temperature);
    let curve = |of: &dyn Fn(Vec<f64>) -> f64| -> Vec<_> {
        (30..=85).map(f64::from).map(|temperature| (temperature, of(at(temperature)))).collect()
    };
    let scatter = Chart::new("Draws from the posterior")
        .claim("Dot: posterior mean, by a sum over a grid")
        .measured(format!("{:.0} % of the trajectories are accepted", 100.0 * acceptance))
        .along(Axis::linear("intercept"))
        .up(Axis::linear("slope per °F"))
        .cloud("", draws.iter().map(|b| posterior.per_degree(*b).into()))
        .coloured(colour::COLOURS[6])
        .dots("", [posterior.per_degree(mean).into()])
        .coloured(colour::COLOURS[3]);
    let risk = Chart::new("Probability of distress")
        .claim("Black: mean. Grey: middle 90 %. Dots: launches with distress (above) and without (below)")
        .along(Axis::linear("temperature in °F"))
        .up(Axis::linear("probability"))
        .line("", curve(&|series| moments(&series).0))
        .line("", curve(&|series| quantile(series, 0.05)))
        .coloured(colour::GREY)
        .line("", curve(&|series| quantile(series, 0.95)))
        .coloured(colour::GREY)
        .dots("", posterior.launches())
        .coloured(colour::COLOURS[3]);
    Panels::new("O-ring distress on the space shuttle", "Posterior of a logistic regression of 23 launches")
        .measured(format!("probability at {MORNING} °F: {:.0} %", 100.0 * moments(&at(MORNING)).0))
        .columns(2)
        .panel(620, 520)
        .chart(scatter)
        .chart(risk)
}
