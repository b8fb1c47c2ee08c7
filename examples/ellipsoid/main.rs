//! Follows geodesics on a triaxial ellipsoid and checks Joachimsthal's integral.
//!
//! H is in one piece: the metric depends on the position. The ellipsoid has the axes 1.01 : 1 : 0.8. The program prints:
//!
//! - for a geodesic around the shortest axis over a million steps: the largest relative errors of H and of Joachimsthal's
//!   integral, which does not follow from a symmetry. The largest latitude is that of the line of curvature which the geodesic
//!   touches, 45.1 degrees.
//! - for geodesics from an umbilic point in several directions: the distance from the opposite umbilic point after half the
//!   perimeter of the ellipse through both. All these geodesics meet there (Jacobi 1839).

mod surface;

use integrator_core::prelude::*;
use std::{error::Error, f64::consts::TAU, time::Instant};
use surface::Ellipsoid;

const STEP: f64 = 0.05;
const STEPS: u64 = 1_000_000;
/// Steps between samples.
const INTERVAL: u64 = 10;

fn main() -> Result<(), Box<dyn Error>> {
    let ellipsoid = Ellipsoid { axes: [1.01, 1.0, 0.8] };
    let latitude = 45.1_f64.to_radians();
    let (mut run, clock) = (ellipsoid.run(ellipsoid.circumpolar(latitude), STEP)?, Instant::now());
    let (mut errors, mut largest) = ([0.0_f64; 2], 0.0_f64);
    for _ in 0..STEPS / INTERVAL {
        run.advance(INTERVAL)?;
        let found = [2.0 * run.energy(), run.invariant("joachimsthal")? / ellipsoid.integral(latitude)];
        errors = std::array::from_fn(|i| errors[i].max((found[i] - 1.0).abs()));
        largest = largest.max(ellipsoid.latitude(run.state().q));
        // H depends on φ, and an angle of 1e5 would be rounded by 1e-11.
        run.map_state(|state| state.q[1] %= TAU)?;
    }
    println!("{STEPS} steps of {STEP} with samples in {:.2} s", clock.elapsed().as_secs_f64());
    println!("H                       {:.1e}", errors[0]);
    println!("Joachimsthal's integral {:.1e}", errors[1]);
    println!("largest latitude        {:.9} degrees", largest.to_degrees());
    println!("\nhalf the perimeter: {:.12}", 0.5 * ellipsoid.perimeter());
    println!("degrees from the south   distance from the opposite umbilic point");
    for degrees in [30.0_f64, 60.0, 90.0, 120.0, 150.0] {
        println!("{degrees:<24} {:.1e}", ellipsoid.miss(degrees.to_radians(), STEP)?);
    }
    Ok(())
}
