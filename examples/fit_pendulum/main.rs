//! How long is a pendulum? Least squares of its length, and of how it began, from 200 looks at its angle.
//!
//! `sensitive(length)` in the annotation is all that the fit needs: the derivatives of every angle by the length and by the
//! start run along with the motion, exact for the very steps. The method of Gauss and Newton takes them as they are.
//!
//! Printed: the numbers that were hidden and those that were found, each with its standard error. Look at the length: it is
//! found to less than a millimetre by looks that are off by a degree, since what a wrong length does adds up over the swings.

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
    println!("{:>18} {:>10} {:>10} {:>10}", "", "hidden", "found", "error");
    for (i, name) in ["length", "angle", "angular momentum"].into_iter().enumerate() {
        let error = found.covariance[(i, i)].sqrt();
        println!("{name:>18} {:>10.5} {:>10.5} {error:>10.5}", hidden[i], found.unknown[i]);
    }
    let (period, error) = found.small_period();
    println!("small swings take {period:.5} ± {error:.5}; {} iterations", found.iterations);
    println!("a look is off by {:.4}, and by {NOISE} was made", found.residual);
    Ok(())
}
