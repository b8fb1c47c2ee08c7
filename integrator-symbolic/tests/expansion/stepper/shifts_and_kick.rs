// A charge in a wave along x, whose vector potential depends on x, and in a field along y that grows with y.
#[hamiltonian(split = along_x + along_y + well, compose = Yoshida4)]
impl Charge {
    fn along_x(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        (p[0] - self.field * (self.number * q[0] - q[1]).sin()).powi(2) / (2.0 * self.mass)
    }

    fn along_y(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        (self.charge * q[0] * q[1].powi(2) - p[1]).powi(2) / (2.0 * self.mass)
    }

    fn well(&self, q: [f64; 2]) -> f64 {
        0.5 * (q[0] * q[0] + q[1] * q[1])
    }
}
