#[hamiltonian(gpu)]
impl Planets {
    fn kinetic(&self, p: [[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for d in 0..3 {
                energy += p[i][d].powi(2) / (2.0 * self.mass[i]);
            }
        }
        energy
    }
    fn potential(&self, q: [[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for j in 0..i {
                let mut r2 = 0.0;
                for d in 0..3 {
                    r2 += (q[i][d] - q[j][d]).powi(2);
                }
                energy -= self.gravity * self.mass[i] * self.mass[j] / r2.sqrt();
            }
        }
        energy
    }
}
