#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64; 32]) -> f64 {
        let mut t = 0.0;
        for i in 0..32 {
            t += 0.5 * p[i] * p[i];
        }
        t
    }
    fn potential(&self, q: &[f64; 32]) -> f64 {
        let mut v = self.spring(q[0]) + self.spring(-q[31]);
        for i in 0..31 {
            v += self.spring(q[i + 1] - q[i]);
        }
        v
    }
    fn spring(&self, d: f64) -> f64 {
        0.5 * d * d + self.alpha / 3.0 * d.powi(3) + self.beta / 4.0 * d.powi(4)
    }
}
