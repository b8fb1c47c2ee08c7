//! A composition for quadratic T, asked for in a run of another T.

use integrator_core::prelude::*;

composition! {
    /// Of order 4 if `T` is quadratic in `p`, otherwise of order 3. By McLachlan and Atela.
    pub struct Mine: order 4 =
        V(0.134496199277431089210659254937312760687) T(0.515352837431122936363778587573609500315)
        V(-0.22481980307942080594522736361864931224) T(-0.0857820194129736460164250123389618937825)
        V(0.756320000515668291264290794964469486466) T(0.441583023616466524250195001287251255228) V(_) T(_);
}

struct Relativistic;

#[hamiltonian]
impl Relativistic {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        (1.0 + p[0] * p[0]).sqrt()
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
}

fn main() {
    let _ = Relativistic.run_with(Mine, Phase::new([0.1], [0.0]), 0.1);
}
