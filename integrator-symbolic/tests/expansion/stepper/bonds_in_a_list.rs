#[hamiltonian]
impl Network {
    fn kinetic(&self, p: &[[f64; 2]]) -> f64 {
        p.iter().map(|p| p[0] * p[0] + p[1] * p[1]).sum::<f64>() / 2.0
    }

    fn potential(&self, q: &[[f64; 2]]) -> f64 {
        let mut energy = 0.0;
        for (k, &(a, b)) in self.bonds.iter().enumerate() {
            let distance = (q[a][0] - q[b][0]).hypot(q[a][1] - q[b][1]);
            if distance < self.reach {
                energy += 0.5 * self.stiffness[k] * (distance - 1.0).powi(2);
            }
        }
        for &i in &self.held {
            energy += q[i][1].cos();
        }
        energy
    }
}
