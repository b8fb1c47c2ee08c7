//! The examples of H that does not separate, in short runs by implicit methods: each has a number that is known from elsewhere.

#[path = "../examples/double_pendulum_flips/pendulum.rs"]
mod double_pendulum;
#[path = "../examples/ellipsoid/surface.rs"]
mod ellipsoid;
#[path = "../examples/heavy_top/elliptic.rs"]
mod elliptic;
#[path = "../examples/kerr/geodesic.rs"]
mod kerr;
#[path = "../examples/tokamak/particle.rs"]
#[allow(dead_code, reason = "the example finds the boundary by bisection")]
mod tokamak;
#[path = "../examples/heavy_top/top.rs"]
mod top;

use integrator_core::prelude::*;

/// The innermost stable orbit has a closed form (Bardeen, Press and Teukolsky 1972), and Carter's constant is an integral that H
/// does not show.
#[test]
fn a_rotating_black_hole_has_its_innermost_orbit_and_the_constant_of_carter() {
    for spin in [0.0, 0.9] {
        let hole = kerr::Kerr { spin };
        let (found, exact) = (hole.innermost_by_tangents().expect("orbits"), hole.innermost());
        // Without spin, the squared frequency is (r - 6)/(r³ (r - 3)): the trace changes by 25/648 of the distance from this orbit,
        // and is rounded to some 1e-13. With spin it changes more.
        assert!((found / exact - 1.0).abs() < 1e-11, "spin {spin}: {found}, {exact}");
    }
    let (hole, start) = (kerr::Kerr { spin: 0.9 }, kerr::inclined());
    let mut run = hole.run(start, 1.0).expect("a start");
    assert!((run.energy() + 0.5).abs() < 1e-14, "the mass is {}", -2.0 * run.energy());
    let carter = hole.carter(&start);
    run.advance(3_000).expect("an orbit");
    let state = run.state();
    // Roundings of 3,000 steps, as a walk, of terms of H up to a hundred: 55 times 1e-14; those of Carter's constant are less.
    assert!((run.energy() + 0.5).abs() < 5e-13, "{:e}", run.energy() + 0.5);
    assert!((hole.carter(&state) / carter - 1.0).abs() < 1e-12, "{:e}", hole.carter(&state) / carter - 1.0);
    assert_eq!([state.p[0], state.p[3]], [start.p[0], start.p[3]], "H depends on neither the time nor the angle");
}

/// Nutation is an elliptic function of time, and an upright top falls if its spin is below two.
#[test]
fn a_heavy_top_nutates_as_in_closed_form_and_falls_below_a_spin_of_two() {
    let heavy = top::Top { axial: 0.5 };
    for precession in [-0.4, 0.0, 0.2] {
        let release = top::Release { height: 0.5, spin: 3.0, precession };
        let (exact, found) = (release.nutation(), top::motion(&heavy, &release, 0.25, 40).expect("steps"));
        // Roundings of 400 steps, as a walk: 20 times 2e-16, times the derivatives of H, which are up to 6.
        assert!(found.energy_error < 5e-14, "{precession}: {:e}", found.energy_error);
        // The period has a derivative by the energy of about one, so that 40 of them are off by 40 times the error of H at most.
        assert!(found.height_error < 2e-12, "{precession}: {:e}", found.height_error);
        for (found, exact) in [(found.period, exact.period()), (found.precession, exact.precession())] {
            assert!((found / exact - 1.0).abs() < 1e-13, "{precession}: {found} and {exact}");
        }
    }
    for (spin, upright) in [(1.9_f64, 0.805_f64.acos()), (2.1, 0.0)] {
        let release = top::Release { height: 1.0_f64.to_radians().cos(), spin, precession: 0.0 };
        let found = top::largest_tilt(&heavy, &release, 0.1, 200).expect("steps");
        // The cosine of one degree is rounded, by 7e-13 of the angle.
        assert!((found / release.nutation().lowest.acos() - 1.0).abs() < 1e-11, "{spin}: {found}");
        // The tilt of an upright top, spin²/2 - 1 = cos θ, changes by the square of the first tilt, and a sleeping top has a few times
        // the first tilt.
        assert!((found - upright).abs() < 0.06, "{spin}: {found} and {upright}");
    }
}

/// Rods that are released too low never flip, and both signs of the angles have the same times (Heyl 2008).
#[test]
fn a_double_pendulum_flips_where_its_energy_suffices() {
    let cells = 10;
    let starts: Vec<_> = (0..cells).flat_map(|row| double_pendulum::row(row, cells)).collect();
    let flips = |steps, until| double_pendulum::flips(&starts, steps, until, |_| true).expect("steps");
    let times = flips(5, 10).times;
    let within: Vec<_> = (0..starts.len()).filter(|start| double_pendulum::cannot_flip(starts[*start])).collect();
    assert!(within.len() > 20 && within.iter().all(|start| times[*start].is_nan()), "{times:?}");
    let bits: Vec<_> = times.iter().map(|time| time.to_bits()).collect();
    assert_eq!(bits, bits.iter().rev().copied().collect::<Vec<_>>(), "{times:?}");
    // The lowest row from Lagrange's equations by the classical Runge-Kutta method with a step of 0.005. Here a flip is seen at the end
    // of a step of 0.2.
    let none = f64::NAN;
    let lagrange = [1.350, 7.580, none, 9.475, none, none, 0.730, 1.035, 1.670, 4.850];
    for (found, expected) in times.iter().zip(lagrange) {
        assert!(
            found.is_nan() && expected.is_nan() || (-0.005..0.2).contains(&(found - expected)),
            "{found}, {expected}"
        );
    }
    // The order is 8: half the step has an error of H smaller by 256, to which higher orders add. The order 4 would have 16.
    let [coarse, fine] = [5, 10].map(|steps| flips(steps, 3).energy_error);
    assert!(fine < coarse / 32.0, "{coarse:e} and {fine:e}");
    for mode in double_pendulum::modes() {
        let found = double_pendulum::small_swings(mode).expect("steps");
        // Swings of the rods against each other by 8e-6 have a frequency that differs by about the square of this.
        assert!((found / mode - 1.0).abs() < 1e-10, "{found} and {mode}");
    }
}

/// Geodesics have Joachimsthal's integral and oscillate between lines of curvature, and those from an umbilic point meet at the
/// opposite one (Jacobi 1839).
#[test]
fn geodesics_on_an_ellipsoid_have_their_integral_and_meet_at_umbilic_points() {
    let (ellipsoid, latitude) = (ellipsoid::Ellipsoid { axes: [1.01, 1.0, 0.8] }, 45.1_f64.to_radians());
    let start = ellipsoid.circumpolar(latitude);
    let (mut run, mut largest) = (ellipsoid.run(start, 0.05).expect("a start"), 0.0_f64);
    for _ in 0..200 {
        run.advance(5).expect("a geodesic");
        largest = largest.max(ellipsoid.latitude(run.state().q));
    }
    let joachimsthal = run.invariant("joachimsthal").expect("its name") / ellipsoid.integral(latitude);
    // Roundings of 1,000 steps, as a walk: 32 times 2e-16, times derivatives of about one.
    let errors = [2.0 * run.energy() - 1.0, joachimsthal - 1.0];
    assert!(errors.iter().all(|error| error.abs() < 5e-14), "{errors:?}");
    // Samples miss the time of the largest latitude by 0.125 at most, in which a latitude decreases by the square of this.
    assert!((-0.016..1e-13).contains(&(largest - latitude)), "{largest} and {latitude}");
    for degrees in [60.0_f64, 90.0, 140.0] {
        let miss = ellipsoid.miss(degrees.to_radians(), 0.05).expect("a geodesic");
        // Roundings of 57 steps; neighbouring geodesics from one point separate by their angle at most.
        assert!(miss < 2e-14, "{degrees}: {miss:e}");
    }
}

/// For a small gyroradius, the width of a banana orbit follows from the toroidal momentum, and particles are trapped up to a pitch of
/// `√(2 ε / (1 + ε))`.
#[test]
fn a_particle_in_a_tokamak_has_the_orbits_of_a_small_gyroradius() {
    let (tokamak, minor, h) = (tokamak::Tokamak { safety: 2.0 }, 0.2, 2.0);
    let error = |speed: f64| {
        let widths = [0.3, -0.3].map(|pitch| tokamak.banana(minor, speed, pitch, h).expect("an orbit"));
        0.5 * (widths[0] + widths[1]) / tokamak.banana_of_theory(minor, speed, 0.3) - 1.0
    };
    let [coarse, fine] = [1.6e-2, 8e-3].map(error);
    // The first order in the gyroradius cancels in the mean of both directions, so half the gyroradius has a quarter of the error. The
    // smaller width is 0.29 of the minor radius, the fourth power of which is 0.007.
    assert!((3.0..6.0).contains(&(coarse / fine)), "{coarse} and {fine}");
    assert!(((4.0 * fine - coarse) / 3.0).abs() < 0.01, "{coarse} and {fine}");
    // The boundary is that of a flux surface within the orbit, which extends from the start by 0.28 of the minor radius at most. The
    // pitch varies by half of this, since it is a square root.
    let boundary = tokamak::boundary_of_theory(minor);
    for pitch in [-0.8, 1.2] {
        let r = tokamak.returns(minor, 8e-3, pitch * boundary, h).expect("an orbit");
        assert_eq!(r > 1.0, pitch.abs() < 1.0, "{pitch}: {r}");
    }
    let start = tokamak.start(minor, 8e-3, 0.3);
    let mut run = tokamak.run(start, h).expect("a start");
    run.advance(500).expect("an orbit");
    // Roundings of 500 steps, as a walk: 22 times 2e-16 of momenta of 0.2, relative to the speed of 8e-3, twice for the square.
    let error = run.energy() / 3.2e-5 - 1.0;
    assert!(error.abs() < 5e-13, "{error:e}");
    assert_eq!(run.state().p[1], start.p[1], "H does not depend on the toroidal angle");
}
