//! Kepler's ellipse in closed form.

/// Position and velocity at time `t` on the ellipse of eccentricity `e` with `μ = 1` and semi-major axis 1, which passes
/// its pericentre on the positive x axis at time 0.
pub(crate) fn ellipse(e: f64, t: f64) -> ([f64; 2], [f64; 2]) {
    // Kepler's equation u - e sin u = t, by Newton's method from a start that is within e of the root.
    let mut u = t;
    for _ in 0..12 {
        u -= (u - e * u.sin() - t) / (1.0 - e * u.cos());
    }
    let (sine, cosine) = u.sin_cos();
    let (minor, rate) = ((1.0 - e * e).sqrt(), 1.0 / (1.0 - e * cosine));
    ([cosine - e, minor * sine], [-sine * rate, minor * cosine * rate])
}

#[test]
fn the_ellipse_keeps_energy_and_area() {
    for t in [-3.0, 0.0, 0.1, 2.5, 40.0] {
        let ([x, y], [vx, vy]) = ellipse(0.6, t);
        let energy = (vx * vx + vy * vy) / 2.0 - 1.0 / x.hypot(y);
        // Kepler's equation is solved up to the rounding of t, and the speed at pericentre is 2.
        let rounding = 100.0 * f64::EPSILON * (1.0 + f64::abs(t));
        assert!((energy + 0.5).abs() < rounding && (x * vy - y * vx - 0.8).abs() < rounding, "at {t}");
    }
}
