//! Geodesics on a triaxial ellipsoid.

use integrator_core::{GaussLegendre, prelude::*};
use std::f64::consts::{PI, TAU};

/// An ellipsoid with these semi-axes, in descending order.
#[derive(Clone, Copy)]
pub(crate) struct Ellipsoid {
    pub(crate) axes: [f64; 3],
}

/// `H = gⁱʲ pᵢ pⱼ / 2` in the angles (θ, φ), where the point is `(a sin θ cos φ, b sin θ sin φ, c cos θ)`. At H = 1/2 the time is the
/// length of the geodesic. The coordinates are singular at the ends of the shortest axis.
#[hamiltonian(split = none, compose = GaussLegendre<8>)]
impl Ellipsoid {
    fn hamiltonian(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        let [south, east] = self.rates(q, p);
        0.5 * (p[0] * south + p[1] * east / q[0].sin())
    }

    /// Joachimsthal's integral, `Σ xᵢ²/aᵢ⁴ · Σ x′ᵢ²/aᵢ²` for a point `x` that moves with the velocity `x′`. It makes the motion
    /// integrable (Jacobi 1839).
    #[invariant]
    fn joachimsthal(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        let ([a, b, c], [south, east]) = (self.axes, self.rates(q, p));
        let ((st, ct), (sp, cp)) = (q[0].sin_cos(), q[1].sin_cos());
        let position = (st * cp / a).powi(2) + (st * sp / b).powi(2) + (ct / c).powi(2);
        let velocity = [ct * cp * south - sp * east, ct * sp * south + cp * east, -st * south];
        position * (velocity[0].powi(2) + velocity[1].powi(2) + velocity[2].powi(2))
    }

    /// Returns the rate of θ, and that of φ times the sine of θ, by the inverse of the metric.
    fn rates(&self, [theta, phi]: [f64; 2], [ptheta, pphi]: [f64; 2]) -> [f64; 2] {
        let [a, b, c] = self.axes;
        let ((st, ct), (sp, cp)) = (theta.sin_cos(), phi.sin_cos());
        let (along, across) = ((a * cp).powi(2) + (b * sp).powi(2), (a * sp).powi(2) + (b * cp).powi(2));
        let (mixed, pphi) = ((a * a - b * b) * sp * cp * ct, pphi / st);
        let determinant = (a * b * ct).powi(2) + (c * st).powi(2) * across;
        let south = across * ptheta + mixed * pphi;
        let east = mixed * ptheta + (along * ct * ct + (c * st).powi(2)) * pphi;
        [south / determinant, east / determinant]
    }
}

impl Ellipsoid {
    /// Returns the start of a geodesic of unit speed at φ = 0, and at this `z/c`, by its angle from the south to the east.
    fn start(&self, height: f64, azimuth: f64) -> Phase<[f64; 2]> {
        let [a, b, c] = self.axes;
        let sine = (1.0 - height * height).sqrt();
        let (east, south) = azimuth.sin_cos();
        Phase::new([height.acos(), 0.0], [south * (a * height).hypot(c * sine), east * b * sine])
    }

    /// Returns the start of the geodesic that touches the line of curvature at the ellipsoidal latitude β. It oscillates between β
    /// and -β.
    pub(crate) fn circumpolar(&self, latitude: f64) -> Phase<[f64; 2]> {
        self.start(latitude.sin() * self.umbilic_height(), 0.5 * PI)
    }

    /// Returns the start of a geodesic at the umbilic point with positive x and z.
    pub(crate) fn umbilic(&self, azimuth: f64) -> Phase<[f64; 2]> {
        self.start(self.umbilic_height(), azimuth)
    }

    /// Returns `z/c` of the umbilic points, at which both curvatures are equal.
    fn umbilic_height(&self) -> f64 {
        let [a, b, c] = self.axes.map(|axis| axis * axis);
        ((b - c) / (a - c)).sqrt()
    }

    /// Returns Joachimsthal's integral of the geodesic that touches the line of curvature at a latitude β.
    pub(crate) fn integral(&self, latitude: f64) -> f64 {
        let [a, b, c] = self.axes.map(|axis| axis * axis);
        let (sine, cosine) = latitude.sin_cos();
        (b * sine * sine + c * cosine * cosine) / (a * b * c)
    }

    /// Returns the ellipsoidal latitude β of a point.
    pub(crate) fn latitude(&self, [theta, phi]: [f64; 2]) -> f64 {
        let [a, b, c] = self.axes.map(|axis| axis * axis);
        let ((st, ct), (sp, cp)) = (theta.sin_cos(), phi.sin_cos());
        // The confocal coordinates of the point are the roots of λ² - sum λ + product.
        let shares = [(st * cp).powi(2), (st * sp).powi(2), ct * ct];
        let sum = a * (1.0 - shares[0]) + b * (1.0 - shares[1]) + c * (1.0 - shares[2]);
        let product = a * b * c * (shares[0] / a + shares[1] / b + shares[2] / c);
        let smaller = 2.0 * product / (sum + (sum * sum - 4.0 * product).sqrt());
        ((smaller - c) / (b - c)).sqrt().asin()
    }

    /// Returns the length of the ellipse through the ends of the longest and the shortest axis, by the arithmetic-geometric mean
    /// (Gauss). The umbilic points lie on it.
    pub(crate) fn perimeter(&self) -> f64 {
        let [mut larger, _, mut smaller] = self.axes;
        let (mut sum, mut weight) = (0.5 * (larger * larger + smaller * smaller), 0.5);
        // The number of correct digits doubles each time.
        for _ in 0..6 {
            let difference = 0.5 * (larger - smaller);
            (larger, smaller) = (0.5 * (larger + smaller), (larger * smaller).sqrt());
            weight *= 2.0;
            sum -= weight * difference * difference;
        }
        TAU * sum / larger
    }

    /// Returns the distance between a geodesic from an umbilic point and the opposite umbilic point, after half the perimeter.
    ///
    /// # Errors
    /// A step has no solution.
    pub(crate) fn miss(&self, azimuth: f64, h: f64) -> Result<f64, Error> {
        let start = self.umbilic(azimuth);
        let mut run = self.run(start, h)?;
        run.advance_to(0.5 * self.perimeter())?;
        let point = |[theta, phi]: [f64; 2]| {
            let [a, b, c] = self.axes;
            [a * theta.sin() * phi.cos(), b * theta.sin() * phi.sin(), c * theta.cos()]
        };
        let [from, to] = [start.q, run.state().q].map(point);
        Ok((0..3).map(|i| (from[i] + to[i]).powi(2)).sum::<f64>().sqrt())
    }
}
