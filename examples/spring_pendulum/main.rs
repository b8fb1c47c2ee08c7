//! Integrates a pendulum whose rod is a stiff spring: the spring in short inner steps, gravity in long outer steps.
//!
//! The program prints:
//!
//! - the largest energy error over a hundred swings against the outer step, and how often gravity and the spring were evaluated.
//!   Inner steps are equally short in all rows. Eight of them per outer step save 7/8 of the evaluations of gravity at nearly the
//!   same error. Outer steps near the period of the spring, `h·ω = 2π`, are useless.
//! - the period of swings of 90 degrees for several springs. It exceeds the period `t` of a rigid pendulum, for which Gauss has a
//!   formula, by `30 π / (t ω²)`.
//!
//! The picture `spring_pendulum.png` shows the largest energy error against the outer step. Gravity pulls equally at any length of
//! the spring. Its kicks drive the spring if the outer step is a whole period of it, `h·ω = 2π`. The force of a rubber band depends
//! on the length: its kicks also drive the spring at half a period, `h·ω = π`, and at all multiples of it.

mod pendulum;
mod picture;
#[path = "../support/mod.rs"]
mod support;

use integrator_core::prelude::*;
use integrator_plot::write;
use pendulum::{Pendulum, energy_error, error_at, excess_of_a_right_angle, period, rigid_period};
use picture::{Curve, picture};
use std::{
    error::Error,
    f64::consts::{FRAC_PI_2, PI, TAU},
};
use support::{Watch, folder};

/// Frequency of the spring, about 30 times that of the swing.
const FREQUENCY: f64 = 30.0;
/// Inner step.
const SHORT: f64 = 0.01 * TAU / FREQUENCY;
/// Distance of the outer steps of the picture, in half periods of the spring, and their number.
const APART: f64 = 0.0025;
const POINTS: u64 = 1300;

fn main() -> Result<(), Box<dyn Error>> {
    let pendulum = Pendulum { frequency: FREQUENCY, band: 0.0 };
    println!("inner steps   h·ω / π   energy error   gravity   spring");
    for inner_steps in [1, 2, 4, 8, 16, 32, 64, 96] {
        let h = f64::from(inner_steps) * SHORT;
        let mut run = pendulum.run_with(Verlet.nested(inner_steps), pendulum.start(1.0, 0.05), h)?;
        let error = energy_error(&mut run, 100.0 * TAU)?;
        let evaluations = run.evaluations_of_parts();
        let [(_, gravity), (_, spring), _] = evaluations[..] else { return Err("not three parts".into()) };
        println!("{inner_steps:11} {:9.2} {error:14.1e} {gravity:9} {spring:8}", h * FREQUENCY / PI);
    }
    let rigid = rigid_period(FRAC_PI_2);
    println!(
        "\nperiod of a rigid pendulum: {rigid:.6}; (period - rigid) · frequency² tends to {:.4}",
        excess_of_a_right_angle()
    );
    println!("frequency     period   (period - rigid) · frequency²");
    for frequency in [10.0, 20.0, 40.0, 80.0, 160.0] {
        let found = period(&Pendulum { frequency, band: 0.0 }, FRAC_PI_2, 0.1 / frequency, 5)?;
        println!("{frequency:9} {found:10.6} {:31.4}", (found - rigid) * frequency.powi(2));
    }
    let watch = Watch::new(2 * POINTS, "runs");
    let mut curves = [Curve::new(), Curve::new()];
    for (number, (curve, band)) in curves.iter_mut().zip([0.0, 4.0]).enumerate() {
        let pendulum = Pendulum { frequency: FREQUENCY, band };
        for point in 1..=POINTS {
            let halves = APART * point as f64;
            curve.push((halves, error_at(&pendulum, 0.5, halves, 200.0)?));
            if !watch.done(number as u64 * POINTS + point) {
                break;
            }
        }
    }
    drop(watch);
    let file = folder().join("spring_pendulum");
    write(&file, &picture(curves))?;
    println!("\nthe picture is {}", file.with_extension("png").display());
    Ok(())
}
