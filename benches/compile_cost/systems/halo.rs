use integrator_core::prelude::*;

pub struct System {
    pub core: f64,
    pub speed: f64,
    pub length: f64,
}

/// A bar that rotates in a logarithmic halo; its potential changes its form at the end of the bar.
#[hamiltonian]
impl System {
    fn kinetic(&self, [px, py, pz]: [f64; 3]) -> f64 {
        (px * px + py * py + pz * pz) / 2.0
    }
    fn potential(&self, [x, y, z]: [f64; 3], t: f64) -> f64 {
        let halo = (self.core * self.core + x * x + y * y + z * z / 0.81).ln() / 2.0;
        let (sine, cosine) = (self.speed * t).sin_cos();
        let (along, across) = (x * cosine + y * sine, y * cosine - x * sine);
        let radius = (x * x + y * y + z * z).sqrt();
        let strength = if radius < self.length { radius / self.length - 2.0 } else { -(self.length / radius).powi(3) };
        halo + 0.1 * strength * (along * along - across * across) / (radius * radius + self.core)
    }
}

pub fn system() -> System {
    System { core: 0.2, speed: 0.5, length: 1.0 }
}

pub fn start() -> Phase<[f64; 3]> {
    Phase::new([0.8, 0.1, 0.2], [0.0, 0.5, 0.1])
}
