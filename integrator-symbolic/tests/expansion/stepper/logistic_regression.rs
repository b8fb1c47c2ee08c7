#[hamiltonian(compose = McLachlan2)]
impl Regression {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, b: &[f64]) -> f64 {
        let mut v = 0.0;
        for row in 0..self.outcomes.len() {
            let mut z = b[0];
            for k in 0..b.len() - 1 {
                z += self.covariates[row][k] * b[k + 1];
            }
            v += z.exp().ln_1p() - self.outcomes[row] * z;
        }
        v
    }
}
