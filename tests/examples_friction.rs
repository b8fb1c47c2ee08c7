//! The examples with friction and heat baths, in short runs: each has a number that is known from elsewhere.

#[path = "../examples/heat_conduction/conductor.rs"]
mod conductor;
#[path = "../examples/duffing/oscillator.rs"]
#[allow(dead_code, reason = "the picture of the example draws the section")]
mod duffing;
#[path = "../examples/driven_pendulum/pendulum.rs"]
#[allow(dead_code, reason = "the picture of the example draws sections")]
mod pendulum;

use conductor::{Chain, STEP, harmonic, stationary};
use duffing::{DELTA, Duffing, PERIOD, STEPS};
use integrator_core::prelude::*;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// The torques of Taylor's table, and Feigenbaum's number as the limit of ratios.
#[test]
fn the_period_of_a_driven_pendulum_doubles_where_the_literature_finds_it() {
    let doublings = pendulum::doublings(6).expect("finite states");
    for (found, table) in doublings.iter().zip([1.0663, 1.0793, 1.0821, 1.0827]) {
        // One unit of the last digit of the table; the step moves torques by 6e-6.
        assert!((found - table).abs() < 1e-4, "{found} and {table}");
    }
    let ratios = pendulum::ratios(&doublings);
    let errors: Vec<_> = ratios.iter().map(|ratio| (ratio - 4.669_201_609).abs()).collect();
    // Nonlinear terms of the torque are smaller by the ratio itself with each doubling, and so are these errors. A limit that was
    // off by a third of the last error would change the last quotient by as much.
    for pair in errors[1..].windows(2) {
        assert!((3.5..6.0).contains(&(pair[0] / pair[1])), "{ratios:?}");
    }
}

/// Friction is solved exactly: areas shrink by `exp(-δ t)`, and exponents add up to `-δ`.
#[test]
fn areas_of_a_driven_oscillator_shrink_by_the_friction() {
    let [chaotic, weak] = [0.5, 0.1].map(|drive| Duffing { drive });
    let state = duffing::settled(chaotic, 1.0, 20).expect("finite states");
    let area = duffing::contraction(chaotic, state, 1).expect("finite states") / (-DELTA * PERIOD).exp();
    // Roundings of 200 steps, as a walk: 14 times 2e-16. Products of components of vectors are up to a hundred times their area.
    assert!((area - 1.0).abs() < 1e-12, "{area}");
    let found = duffing::exponents(chaotic, state, 500).expect("exponents");
    // As above, with a thousand factors of the decompositions, of which at most a few units of rounding each add up.
    assert!((found.sum() + DELTA).abs() < 1e-11, "{}", found.sum());
    // An independent program, Runge and Kutta's, measures the same exponent along another part of the orbit. Both uncertainties are
    // standard errors.
    let (reference, error) = runge_kutta(state, 500);
    let difference = found.exponents[0] - reference;
    assert!(found.exponents[0] > 0.05, "chaos");
    assert!(difference.abs() < 4.0 * found.uncertainties[0].hypot(error), "{found:?} and {reference} ± {error}");
    let dimension = duffing::dimension([found.exponents[0], found.exponents[1]]);
    assert!(dimension > 1.1 && dimension < 1.4, "{dimension}");
    // Multipliers of a stable oscillation are complex with the modulus exp(-δ T/2). The exponents of a finite time differ by the
    // logarithm of the ratio of axes of an ellipse, less than e⁴, over the time.
    let state = duffing::settled(weak, 1.0, 40).expect("finite states");
    let found = duffing::exponents(weak, state, 400).expect("exponents");
    assert!(found.exponents.iter().all(|x| (x + DELTA / 2.0).abs() < 4.0 / found.time), "{found:?}");
}

/// Returns the largest exponent with its standard error, from the equations of motion and their linearisation. It starts after the
/// time that the other measurement takes.
fn runge_kutta(state: Phase<[f64; 1]>, periods: u64) -> (f64, f64) {
    let field = |t: f64, [x, v, dx, dv]: [f64; 4]| {
        [v, x - x.powi(3) - 0.3 * v + 0.5 * (1.2 * t).cos(), dv, dx - 3.0 * x * x * dx - 0.3 * dv]
    };
    let h = TAU / 1.2 / STEPS as f64;
    let mut y = [state.q[0], state.p[0], 1.0, 0.0];
    let mut growths = Vec::new();
    for period in 0..2 * periods {
        for step in 0..STEPS {
            let (t, moved) = (step as f64 * h, |k: [f64; 4], by: f64| std::array::from_fn(|i| y[i] + by * k[i]));
            let a = field(t, y);
            let b = field(t + h / 2.0, moved(a, h / 2.0));
            let c = field(t + h / 2.0, moved(b, h / 2.0));
            let d = field(t + h, moved(c, h));
            y = std::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        }
        let length = y[2].hypot(y[3]);
        (y[2], y[3]) = (y[2] / length, y[3] / length);
        if period >= periods {
            growths.push(length.ln() / (STEPS as f64 * h));
        }
    }
    // Means over 25 periods are independent of each other.
    let spans: Vec<f64> = growths.chunks(25).map(|span| span.iter().sum::<f64>() / span.len() as f64).collect();
    let mean = conductor::Mean::of(spans.iter().copied());
    (mean.value, mean.error)
}

/// Springs alone have the current and the temperatures of Rieder, Lebowitz and Lieb.
#[test]
fn a_harmonic_chain_conducts_as_in_closed_form() {
    let springs = Chain { sites: 8, pinning: 0.0, rate: 1.0, baths: [1.5, 0.5] };
    let found = stationary(springs, 32, 3_000, 1_500).expect("finite states");
    let (current, temperatures) = harmonic(springs);
    // Steps change frequencies by a part of h² ω²/24 with ω < 2, and means by about as much. Standard errors of 32 copies follow
    // Student's distribution: six of them are exceeded with a probability of 1e-6.
    let bias = STEP * STEP / 6.0;
    for (mean, exact) in found.temperatures.iter().zip(&temperatures) {
        assert!((mean.value - exact).abs() < 6.0 * mean.error + bias, "{mean:?} and {exact}");
        assert!(mean.error < 0.03, "{mean:?}");
    }
    assert!((found.current.value - current).abs() < 6.0 * found.current.error + bias, "{:?}, {current}", found.current);
    // Errors are small enough to exclude a linear profile, which has 1.32 at the second site.
    assert!((temperatures[1] - 0.972).abs() < 1e-3 && found.current.error < 0.1 * current);
}

/// The closed form solves the equation of stationary covariances, `A C + C Aᵀ + D = 0`, for odd and even lengths.
#[test]
fn the_closed_form_of_a_harmonic_chain_solves_the_equation_of_covariances() {
    for sites in [2, 5, 6] {
        let chain = Chain { sites, pinning: 0.0, rate: 0.7, baths: [1.5, 0.5] };
        let mut drift = DMatrix::<f64>::zeros(2 * sites, 2 * sites);
        let mut noise = drift.clone();
        for site in 0..sites {
            drift[(site, sites + site)] = 1.0;
            drift[(sites + site, site)] = -2.0;
            for neighbour in [site + 1, site.wrapping_sub(1)] {
                if neighbour < sites {
                    drift[(sites + site, neighbour)] = 1.0;
                }
            }
        }
        for (end, temperature) in [0, sites - 1].into_iter().zip(chain.baths) {
            drift[(sites + end, sites + end)] = -chain.rate;
            noise[(sites + end, sites + end)] = 2.0 * chain.rate * temperature;
        }
        let one = DMatrix::identity(2 * sites, 2 * sites);
        let equations = drift.kronecker(&one) + one.kronecker(&drift);
        let covariances = equations.lu().solve(&-DVector::from_column_slice(noise.as_slice())).expect("one solution");
        let (current, temperatures) = harmonic(chain);
        for (site, temperature) in temperatures.iter().enumerate() {
            let found = covariances[(sites + site) * (2 * sites + 1)];
            // A linear system of up to 144 unknowns with entries of order one.
            assert!((found - temperature).abs() < 1e-12, "{site} of {sites}: {found} and {temperature}");
        }
        assert!(
            (chain.rate * (chain.baths[0] - temperatures[0]) - current).abs() < 1e-12,
            "the bath gives the current"
        );
    }
}

/// Pinned sites have the conductivity of Aoki and Kusnezov.
#[test]
fn a_pinned_chain_obeys_the_law_of_fourier() {
    let pinned = Chain { sites: 16, pinning: 1.0, rate: 1.0, baths: [1.4, 0.6] };
    let found = stationary(pinned, 32, 1_000, 1_500).expect("finite states");
    let conductivity = found.conductivity;
    assert!(conductivity.error < 0.3, "{conductivity:?}");
    assert!((conductivity.value - 2.83).abs() < 4.0 * conductivity.error, "{conductivity:?}");
}
