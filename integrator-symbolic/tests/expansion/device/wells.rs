#[hamiltonian(gpu)]
impl Wells {
    fn kinetic(&self, p: [[f64; 2]; 3]) -> f64 {
        let mut energy = 0.0;
        for i in 0..3 {
            energy += (1.0 + p[i][0] * p[i][0]).sqrt() + 0.5 * p[i][1] * p[i][1] * self.weight[i];
        }
        energy
    }
    fn potential(&self, q: [[f64; 2]; 3], t: f64) -> f64 {
        let mut energy = 0.0;
        for i in 0..3 {
            let r = q[i][0].abs();
            if r > self.edge {
                energy += (r - self.edge).powi(3) * SCALE;
            } else {
                energy -= (-q[i][1] * q[i][1]).exp() * t.cos();
            }
            if self.coupled {
                energy += 0.1 * q[i][0] * q[(i + 1) % 3][1];
            }
        }
        energy
    }
}
