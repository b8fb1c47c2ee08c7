#[hamiltonian]
impl Comet {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        let square = q[0] * q[0] + q[1] * q[1];
        -self.pull / square.sqrt() - self.twist / (square * square.sqrt())
    }
    fn rate(&self, q: [f64; 2]) -> f64 {
        1.0 / (q[0] * q[0] + q[1] * q[1])
    }
}
