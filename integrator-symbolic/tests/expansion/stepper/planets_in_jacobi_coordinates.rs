#[hamiltonian(coordinates = jacobi(self.mass), split = kepler + interaction, compose = Aba1064)]
impl Solar {
    fn kinetic(&self, p: &[[f64; 3]; 6]) -> f64 {
        let mut t = 0.0;
        for i in 0..6 {
            for d in 0..3 {
                t += p[i][d] * p[i][d] / (2.0 * self.mass[i]);
            }
        }
        t
    }
    fn potential(&self, q: &[[f64; 3]; 6]) -> f64 {
        let mut v = 0.0;
        for i in 0..6 {
            for j in 0..i {
                let mut r2 = 0.0;
                for d in 0..3 {
                    let dx = q[i][d] - q[j][d];
                    r2 += dx * dx;
                }
                v -= self.gravity * self.mass[i] * self.mass[j] / r2.sqrt();
            }
        }
        v
    }
}
