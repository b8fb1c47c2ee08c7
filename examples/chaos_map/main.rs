//! Draws maps of chaos by the mean MEGNO, which tends to 2 on regular orbits and grows on chaotic ones.
//!
//! - `chaos_map_galaxy.png`: the Hénon–Heiles system at energy 1/8, with islands of regular orbits in a chaotic sea.
//! - `chaos_map_belt.png`: asteroids under Jupiter's attraction. Orbits are chaotic near Jupiter and at the edges of resonances,
//!   which lines mark.
//!
//! Each point is an orbit with a deviation vector; SIMD lanes integrate many orbits at once. The program prints the regular share of
//! both maps.

#[path = "../trojan/asteroid.rs"]
#[allow(dead_code, reason = "the other example reads more of it")]
mod asteroid;
mod belt;
mod galaxy;
mod grid;
#[path = "../support/mod.rs"]
mod support;

use grid::Grid;
use integrator_plot::{self as plot, Axis, colour};
use std::error::Error;
use support::{Watch, folder};

/// Largest MEGNO of the colour scale.
const MOST: f64 = 6.0;

fn main() -> Result<(), Box<dyn Error>> {
    let section = Grid { along: (-0.45, 0.75), up: (-0.5, 0.5), columns: 400, rows: 400 };
    let belt = Grid { along: (1.9, 4.6), up: (0.0, 0.5), columns: 120, rows: 60 };
    let watch = Watch::new((section.rows + belt.rows) as u64, "rows");
    let mut done = 0;
    let mut goes_on = || {
        done += 1;
        watch.done(done)
    };
    let of_section = section.rows(|places| galaxy::megno(places.iter().copied()), &mut goes_on)?;
    let of_belt = belt.rows(|places| belt::megno(places.iter().copied()), &mut goes_on)?;
    drop(watch);

    let shares = [&of_section, &of_belt].map(|rows| grid::regular(rows));
    let picture = |grid: &Grid, rows: &[Vec<f64>], title: &str, names: [&str; 2]| {
        let [(left, right), (low, high)] = [grid.along, grid.up];
        let high = low + (high - low) * rows.len() as f64 / grid.rows as f64;
        // Points without an orbit stay white.
        let shown = rows.iter().map(|row| row.iter().map(|megno| megno.clamp(0.0, MOST)).collect::<Vec<_>>());
        let chart = plot::map(left..=right, low..=high, "mean MEGNO, 6 or more", shown).title(title);
        let [along, up] = names.map(Axis::linear);
        chart.along(along.between(left, right)).up(up.between(low, high))
    };
    let galaxy = picture(&section, &of_section, "Chaos in the Hénon–Heiles system, E = 1/8", ["y", "p_y"])
        .claim("Regular orbits are dark, chaotic ones light; section x = 0, p_x > 0");
    galaxy.save(folder().join("chaos_map_galaxy.png"))?;
    let mut asteroids =
        picture(&belt, &of_belt, "Chaos in the asteroid belt", ["semi-major axis in AU", "eccentricity"]).claim(
            "76 periods of Jupiter, from a perihelion in its direction; lines: resonances 3:1, 5:2, 7:3, 2:1, 3:2, 4:3",
        );
    for axis in belt::resonances() {
        let line = [(axis, belt.up.0), (axis, belt.up.1)];
        asteroids = asteroids.line("", line).coloured(colour::WHITE).wide(1.0);
    }
    asteroids.save(folder().join("chaos_map_belt.png"))?;
    println!("the pictures are {}", folder().join("chaos_map_*.png").display());
    println!("regular_share_of_section={:.3}", shares[0]);
    println!("regular_share_of_belt={:.3}", shares[1]);
    Ok(())
}
