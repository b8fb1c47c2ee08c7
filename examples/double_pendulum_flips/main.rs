//! Draws a map of the time until a double pendulum flips, from rest at each pair of angles (Heyl 2008).
//!
//! The picture `double_pendulum_flips.png` has a white region around the hanging pendulum, where no rod flips until t = 100. The line
//! is `3 cos a + cos b = 2`: within it, the energy does not suffice for a flip. Outside, times vary strongly between neighbouring
//! points where the motion is chaotic, and some regions do not flip although their energy suffices.
//!
//! H is in one piece. An ensemble integrates all pendulums in SIMD lanes, each until it flips. Reversing the signs of both angles does
//! not change the time, so only half of the plane is integrated. The program prints:
//!
//! - the share of pendulums that flipped until several times, for two steps. Chaotic motions depend on the step, but shares hardly do.
//! - the number of pendulums that flipped within the line, and the largest error of H.
//! - the squared frequencies of small swings, and the closed form `3 ± 6/√7`.

mod pendulum;
#[path = "../support/mod.rs"]
mod support;

use integrator_plot::{Axis, Chart, colour};
use pendulum::{cannot_flip, flips, modes, row, small_swings};
use std::{error::Error, f64::consts::PI, time::Instant};
use support::{Watch, folder};

/// Rows and columns of the map.
const CELLS: u32 = 200;
const UNTIL: u32 = 100;

fn main() -> Result<(), Box<dyn Error>> {
    let starts: Vec<_> = (0..CELLS / 2).flat_map(|i| row(i, CELLS)).collect();
    let clock = Instant::now();
    let watch = Watch::new(u64::from(2 * UNTIL), "units of time");
    let coarse = flips(&starts, 5, UNTIL, |unit| watch.done(u64::from(unit)))?;
    let found = flips(&starts, 10, UNTIL, |unit| watch.done(u64::from(UNTIL + unit)))?;
    drop(watch);
    let seconds = clock.elapsed().as_secs_f64();
    println!("{} pendulums with two steps in {seconds:.1} s", starts.len());
    println!("time   share of flips, 5 steps per unit   10 steps per unit");
    for time in [3.0, 10.0, 30.0, 100.0] {
        let share = |times: &[f64]| times.iter().filter(|t| **t <= time).count() as f64 / times.len() as f64;
        println!("{time:<6} {:33.4} {:19.4}", share(&coarse.times), share(&found.times));
    }
    let inside = starts.iter().zip(&found.times).filter(|(start, time)| cannot_flip(**start) && time.is_finite());
    println!("flips_within_the_line={}", inside.count());
    println!("energy_error_max={:.1e}, with half the step {:.1e}", coarse.energy_error, found.energy_error);
    for mode in modes() {
        println!("squared frequency of small swings {:.10}, closed form {mode:.10}", small_swings(mode)?);
    }

    let mirrored = found.times.iter().chain(found.times.iter().rev()).copied().collect::<Vec<_>>();
    let rows = mirrored.chunks_exact(CELLS as usize);
    let axis = Axis::logarithmic("time of the first flip in √(l/g)").between(1.0, f64::from(UNTIL));
    let angle = |name: &str| Axis::linear(format!("angle of the {name} rod in rad")).between(-PI, PI);
    let upper = || border(400);
    let map = Chart::new("Time until a double pendulum flips")
        .claim("Released at rest; white: no flip until t = 100; line: too little energy within it")
        .field([-PI..=PI, -PI..=PI], axis, rows)
        .along(angle("first"))
        .up(angle("second"))
        .line("", upper().chain(upper().map(|(a, b)| (-a, -b))))
        .coloured(colour::INK)
        .sized(900, 860);
    map.save(folder().join("double_pendulum_flips.png"))?;
    println!("the picture is {}", folder().join("double_pendulum_flips.png").display());
    Ok(())
}

/// Returns the upper half of the border of the region in which rods cannot flip.
fn border(points: u32) -> impl Iterator<Item = (f64, f64)> {
    let most = (1.0_f64 / 3.0).acos();
    (0..=points).map(move |point| {
        let a = most * (2.0 * f64::from(point) / f64::from(points) - 1.0);
        (a, (2.0 - 3.0 * a.cos()).min(1.0).acos())
    })
}
