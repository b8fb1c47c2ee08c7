//! A geodesic of Schwarzschild's space, `H = gᵃᵇ pₐ p_b / 2`, in one piece and by two coupled copies.

use integrator_core::{GaussLegendre6, KahanLi6, Phase, Run, hamiltonian, prelude::Hamiltonian};

macro_rules! geodesic {
    ($name:ident, $($split:tt)*) => {
        struct $name;

        /// Coordinates `(t, r, φ)` in the plane of the orbit, about a mass of one; affine parameter in place of the time.
        #[hamiltonian($($split)*)]
        impl $name {
            fn hamiltonian(&self, [_, r, _]: [f64; 3], [pt, pr, pphi]: [f64; 3]) -> f64 {
                let metric = 1.0 - 2.0 / r;
                0.5 * (metric * pr * pr + pphi * pphi / (r * r) - pt * pt / metric)
            }
        }
    };
}
geodesic!(Geodesic, split = none);
geodesic!(Copied, split = symmetric(omega = 1.0), compose = KahanLi6);

/// A circular orbit of radius 10 has the angular momentum `√(r²/(r - 3))` and the energy `(1 - 2/r)/√(1 - 3/r)`.
fn circle(r: f64) -> Phase<[f64; 3]> {
    Phase::new([0.0, r, 0.0], [-(1.0 - 2.0 / r) / (1.0 - 3.0 / r).sqrt(), 0.0, (r * r / (r - 3.0)).sqrt()])
}

#[test]
fn a_circular_orbit_stays_one() {
    let start = circle(10.0);
    let mut run = Geodesic.run_with(GaussLegendre6, start, 1.0).expect("a start");
    // A timelike geodesic has H = -1/2.
    assert!((run.energy() + 0.5).abs() < 1e-15);
    run.advance(1_000).expect("an end");
    let Phase { q: [time, r, phi], .. } = run.state();
    // dt/dτ = 1/√(1 - 3/r), and dφ/dt = r^(-3/2), as Kepler's. Roundings of a thousand steps, of numbers up to 1200.
    assert!((r - 10.0).abs() < 1e-11, "{r}");
    assert!((time - 1000.0 / 0.7_f64.sqrt()).abs() < 1e-9, "{time}");
    assert!((phi - time / 1000.0_f64.sqrt()).abs() < 1e-10, "{phi}");
}

#[test]
fn both_ways_lead_along_the_same_orbit() {
    let mut start = circle(10.0);
    start.p[1] = 0.05;
    let end = |mut run: Run<[f64; 3]>, steps| {
        run.advance(steps).expect("an end");
        run.state()
    };
    let one = end(Geodesic.run_with(GaussLegendre6, start, 0.5).expect("a start"), 200);
    let [coarse, fine] = [(0.5, 200), (0.25, 400)].map(|(h, steps)| end(Copied.run(start, h).expect("a start"), steps));
    let apart = |a: &Phase<[f64; 3]>| a.q.iter().zip(one.q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!((one.q[1] - 10.0).abs() > 0.1, "an orbit that is no circle");
    assert!(apart(&coarse) < 1e-5 && apart(&fine) < apart(&coarse) / 16.0, "{:e}, {:e}", apart(&coarse), apart(&fine));
}
