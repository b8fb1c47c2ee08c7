//! The fit: orbits as a list of numbers of about one, and the minimum by L-BFGS.

use crate::{
    STEPS,
    planets::{Orbit, PLANETS, STEP, Transit, misses, start},
};
use argmin::{
    core::{CostFunction, Executor, Gradient, State},
    solver::{linesearch::MoreThuenteLineSearch, quasinewton::LBFGS},
};
use integrator_core::Hamiltonian;
use std::{
    cell::{Cell, RefCell},
    error::Error,
    f64::consts::TAU,
    time::{Duration, Instant},
};

/// The numbers of a planet.
const NUMBERS: usize = 5;
/// The most iterations of the fit.
const ITERATIONS: u64 = 300;

/// The sizes of the changes of a planet's numbers that change times by about their errors.
const SCALES: [f64; NUMBERS] = [1e-4, 1e-5, 3e-3, 3e-3, 0.1];

/// Circular orbits through linear times of transits, with equal masses.
pub(crate) fn of_linear_times(measured: &[Transit]) -> [Orbit; PLANETS] {
    std::array::from_fn(|planet| {
        let times: Vec<f64> =
            measured.iter().filter(|transit| transit.planet == planet).map(|transit| transit.time).collect();
        let intervals = (times.len() - 1) as f64;
        let period = (times[times.len() - 1] - times[0]) / intervals;
        let numbers = (0..).map(f64::from).zip(&times);
        let first = numbers.map(|(number, time)| time - number * period).sum::<f64>() / times.len() as f64;
        Orbit { longitude: -TAU * first / period, period, eccentricity: [0.0; 2], mass: 3e-5_f64.ln() }
    })
}

/// Orbits at a distance from others, in units of [`SCALES`].
fn moved(orbits: &[Orbit; PLANETS], by: &[f64]) -> [Orbit; PLANETS] {
    std::array::from_fn(|planet| {
        let by: [f64; NUMBERS] = std::array::from_fn(|number| SCALES[number] * by[NUMBERS * planet + number]);
        let Orbit { longitude, period, eccentricity: [k, h], mass } = orbits[planet];
        Orbit {
            longitude: longitude + by[0],
            period: period * (1.0 + by[1]),
            eccentricity: [k + by[2], h + by[3]],
            mass: mass + by[4],
        }
    })
}

/// The numbers of an evaluation, its value and its derivatives.
type Evaluation = (Vec<f64>, f64, Vec<f64>);

/// The problem for the minimiser.
struct Fit<'m> {
    from: [Orbit; PLANETS],
    measured: &'m [Transit],
    error: f64,
    evaluations: &'m Cell<u64>,
    /// The last evaluation, since the minimiser asks for its value and its derivatives one after the other.
    last: RefCell<Option<Evaluation>>,
}

impl Fit<'_> {
    /// The logarithm of the sum of squares, whose first steps have the right size, and its derivatives with respect to all numbers.
    fn evaluate(&self, numbers: &[f64]) -> Result<(f64, Vec<f64>), integrator_core::Error> {
        if let Some((at, value, slopes)) = &*self.last.borrow()
            && at == numbers
        {
            return Ok((*value, slopes.clone()));
        }
        self.evaluations.set(self.evaluations.get() + 1);
        let (system, point) = start(&moved(&self.from, numbers));
        let (gradient, by_masses) = misses(&system, point, self.measured, self.error)?;
        // The start and the masses are closed forms of the numbers: their derivatives are differences with an error of 1e-10.
        let slope = |number: usize| {
            let width = 1e-3;
            let [up, down] = [width, -width].map(|by| {
                let mut numbers = numbers.to_vec();
                numbers[number] += by;
                start(&moved(&self.from, &numbers))
            });
            let mut sum = 0.0;
            for body in 0..=PLANETS {
                for direction in 0..2 {
                    sum += gradient.start.q[body][direction] * (up.1.q[body][direction] - down.1.q[body][direction]);
                    sum += gradient.start.p[body][direction] * (up.1.p[body][direction] - down.1.p[body][direction]);
                }
            }
            let masses = up.0.masses().into_iter().zip(down.0.masses()).zip(by_masses);
            sum += masses.map(|((up, down), slope)| slope * (up - down)).sum::<f64>();
            sum / (2.0 * width) / gradient.value
        };
        let (value, slopes) = (gradient.value.ln(), (0..NUMBERS * PLANETS).map(slope).collect::<Vec<_>>());
        *self.last.borrow_mut() = Some((numbers.to_vec(), value, slopes.clone()));
        Ok((value, slopes))
    }
}

impl CostFunction for Fit<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, numbers: &Vec<f64>) -> Result<f64, argmin::core::Error> {
        Ok(self.evaluate(numbers)?.0)
    }
}

impl Gradient for Fit<'_> {
    type Param = Vec<f64>;
    type Gradient = Vec<f64>;

    fn gradient(&self, numbers: &Vec<f64>) -> Result<Vec<f64>, argmin::core::Error> {
        Ok(self.evaluate(numbers)?.1)
    }
}

/// The orbits with the smallest sum of squares near some, that sum, and the number of gradients.
pub(crate) fn fitted(
    from: [Orbit; PLANETS],
    measured: &[Transit],
    error: f64,
) -> Result<([Orbit; PLANETS], f64, u64), Box<dyn Error>> {
    let evaluations = Cell::new(0);
    let fit = Fit { from, measured, error, evaluations: &evaluations, last: RefCell::new(None) };
    let solver = LBFGS::new(MoreThuenteLineSearch::new(), 20);
    let begin = vec![0.0; NUMBERS * PLANETS];
    let found = Executor::new(fit, solver).configure(|state| state.param(begin).max_iters(ITERATIONS)).run()?;
    let state = found.state();
    let numbers = state.get_best_param().ok_or("no minimum was found")?;
    Ok((moved(&from, numbers), state.get_best_cost().exp(), evaluations.get()))
}

/// The time that a gradient by differences takes: two runs for each number.
pub(crate) fn time_of_differences(orbits: &[Orbit; PLANETS]) -> Result<Duration, integrator_core::Error> {
    let clock = Instant::now();
    for _ in 0..2 * NUMBERS * PLANETS {
        let (system, point) = start(orbits);
        system.run(point, STEP)?.advance(STEPS)?;
    }
    Ok(clock.elapsed())
}
