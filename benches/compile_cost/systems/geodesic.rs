use integrator_core::prelude::*;

pub struct System {
    pub mass: f64,
}

/// A geodesic around a black hole, in one piece.
#[hamiltonian(split = none)]
impl System {
    fn hamiltonian(&self, [_, r, _]: [f64; 3], [pt, pr, pphi]: [f64; 3]) -> f64 {
        let metric = 1.0 - 2.0 * self.mass / r;
        0.5 * (metric * pr * pr + pphi * pphi / (r * r) - pt * pt / metric)
    }
    fn rate(&self, [_, r, _]: [f64; 3]) -> f64 {
        1.0 / (r * r.sqrt())
    }
}

pub fn system() -> System {
    System { mass: 1.0 }
}

pub fn start() -> Phase<[f64; 3]> {
    Phase::new([0.0, 40.0, 0.0], [-0.979, 0.0, 3.83])
}
