#[hamiltonian(split = kepler + (jump + interaction), compose = Abah1064)]
impl Planets {
    fn kepler(&self, q: [[f64; 3]; 4], p: [[f64; 3]; 4]) -> f64 {
        let mut energy = 0.0;
        for i in 0..4 {
            let square = p[i].iter().map(|p| p * p).sum::<f64>();
            let [x, y, z] = q[i];
            energy += 0.5 * square / self.mass[i] - self.pull * self.mass[i] / (x * x + y * y + z * z).sqrt();
        }
        energy
    }
    fn jump(&self, p: [[f64; 3]; 4]) -> f64 {
        let mut square = 0.0;
        for d in 0..3 {
            let total = p.iter().map(|p| p[d]).sum::<f64>();
            square += total * total;
        }
        square / (2.0 * self.star)
    }
    fn interaction(&self, q: [[f64; 3]; 4]) -> f64 {
        let mut energy = 0.0;
        for i in 0..4 {
            for j in 0..i {
                let d = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                energy -= self.gravity * self.mass[i] * self.mass[j] / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
            }
        }
        energy
    }
}
