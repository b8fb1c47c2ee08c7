// Parts with a kinetic momentum along x and along y.
#[hamiltonian(split = along_x + along_y + well, compose = Yoshida4, gpu)]
impl Charge {
    fn along_x(&self, q: [f64; 2], p: [f64; 2], t: f64) -> f64 {
        0.5 * (p[0] - 0.7 * (self.number * q[0] - q[1] - t).sin()).powi(2)
    }

    fn along_y(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        0.5 * (p[1] + q[0] * q[1] * q[1]).powi(2)
    }

    fn well(&self, q: [f64; 2]) -> f64 {
        0.5 * (q[0] * q[0] + q[1] * q[1])
    }
}
