//! Fits the length of a pendulum and its initial state to 200 noisy angles by least squares.
//!
//! The fit needs `sensitive(length)` in the annotation. The run then integrates the derivatives of every angle with respect to
//! the length and the initial state, exact for the discrete steps. The Gauss–Newton method uses them directly.
//!
//! The program prints the true and the fitted parameters with their standard errors. The length is found to less than a
//! millimetre from angles with an error of a degree, because the effect of a wrong length accumulates over the swings.

mod fit;
#[path = "../support/normal.rs"]
mod normal;

use fit::{Fit, NOISE, Unknown, fit, series};
use integrator_core::Error;
use normal::normal;

fn main() -> Result<(), Error> {
    let hidden = Unknown::new(1.0, 1.2, 0.5);
    let mut random = fastrand::Rng::with_seed(1);
    let seen = series(hidden, 200, || normal(&mut random))?;
    let found: Fit = fit(&seen, Unknown::new(1.03, 1.0, 0.0))?;
    println!("{:>18} {:>10} {:>10} {:>10}", "", "true", "fitted", "error");
    for (i, name) in ["length", "angle", "angular momentum"].into_iter().enumerate() {
        let error = found.covariance[(i, i)].sqrt();
        println!("{name:>18} {:>10.5} {:>10.5} {error:>10.5}", hidden[i], found.unknown[i]);
    }
    let (period, error) = found.small_period();
    println!("period of small oscillations: {period:.5} ± {error:.5}; {} iterations", found.iterations);
    println!("residual {:.4}, for noise of {NOISE}", found.residual);
    Ok(())
}
