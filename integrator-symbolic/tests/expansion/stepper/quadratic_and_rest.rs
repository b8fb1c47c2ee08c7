#[hamiltonian(split = harmonic + anharmonic, compose = Aba864)]
impl HenonHeiles {
    fn harmonic(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py) + 0.5 * self.stiffness * (x * x + y * y)
    }
    fn anharmonic(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        self.lambda * (x * x * y - y * y * y / 3.0)
    }
}
