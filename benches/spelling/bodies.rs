//! Gravity of 200 bodies: softening, conditions, flat coordinates; and test particles in the field of eight bodies.

use crate::{Group, spellings};
use integrator_core::prelude::*;

const BODIES: usize = 200;
const STEP: f64 = 0.001;

/// The bodies that have a field, before test particles.
const SOURCES: usize = 8;
const PARTICLES: usize = 2000;

struct Bodies {
    masses: Vec<f64>,
    softening: f64,
}

fn bodies() -> Bodies {
    Bodies { masses: (0..BODIES).map(|i| 0.001 * (1 + i % 7) as f64).collect(), softening: 0.01 }
}

fn sources() -> Bodies {
    Bodies { masses: bodies().masses[..SOURCES].to_vec(), softening: 0.01 }
}

fn position(i: usize) -> [f64; 3] {
    [0, 1, 2].map(|d| ((i * 7 + d * 13) as f64 * 0.37).sin())
}

macro_rules! bodies {
    ($name:ident, $coordinates:ty, |$self:ident, $q:ident| $potential:expr, |$p:ident| $kinetic:expr) => {
        struct $name(Bodies);

        #[hamiltonian]
        impl $name {
            fn kinetic(&self, $p: $coordinates) -> f64 {
                $kinetic
            }
            fn potential(&$self, $q: $coordinates) -> f64 {
                $potential
            }
        }
    };
    ($name:ident, |$self:ident, $q:ident, $i:ident, $j:ident| $energy:expr) => {
        bodies!($name, &[[f64; 3]], |$self, $q| {
            let mut v = 0.0;
            for $i in 0..$q.len() {
                for $j in 0..$i {
                    v += $energy;
                }
            }
            v
        }, |p| p.iter().flatten().map(|p| 0.5 * p * p).sum());
    };
}

bodies!(First, |self, q, i, j| {
    let mut r2 = self.0.softening;
    for d in 0..3 {
        r2 += (q[i][d] - q[j][d]).powi(2);
    }
    -self.0.masses[i] * self.0.masses[j] / r2.sqrt()
});
bodies!(Last, |self, q, i, j| {
    let r2: f64 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum();
    -self.0.masses[i] * self.0.masses[j] / (r2 + self.0.softening).sqrt()
});
bodies!(Conditional, |self, q, i, j| if self.0.masses[i] > 0.0 {
    let r2: f64 = q[i].iter().zip(&q[j]).map(|(a, b)| (a - b).powi(2)).sum();
    -self.0.masses[i] * self.0.masses[j] / (r2 + self.0.softening).sqrt()
} else {
    0.0
});
bodies!(
    Counted,
    &[[f64; 3]],
    |self, q| {
        let n = self.0.masses.len();
        let mut v = 0.0;
        for i in 0..n - 1 {
            for j in i + 1..n {
                let r2: f64 = q[i].iter().zip(&q[j]).map(|(a, b)| (a - b).powi(2)).sum();
                v -= self.0.masses[i] * self.0.masses[j] / (r2 + self.0.softening).sqrt();
            }
        }
        v
    },
    |p| p.iter().flatten().map(|p| 0.5 * p * p).sum()
);
bodies!(
    Flat,
    &[f64],
    |self, q| {
        let mut v = 0.0;
        for i in 0..q.len() / 3 {
            for j in 0..i {
                let mut r2 = self.0.softening;
                for k in 0..3 {
                    r2 += (q[3 * i + k] - q[3 * j + k]).powi(2);
                }
                v -= self.0.masses[i] * self.0.masses[j] / r2.sqrt();
            }
        }
        v
    },
    |p| p.iter().map(|p| 0.5 * p * p).sum()
);

macro_rules! particles {
    ($name:ident, |$q:ident, $i:ident, $j:ident| $square:expr) => {
        bodies!(
            $name,
            &[[f64; 3]],
            |self, $q| {
                let n = self.0.masses.len();
                let mut v = 0.0;
                for $i in n..$q.len() {
                    for $j in 0..n {
                        let r2: f64 = $square;
                        v -= self.0.masses[$j] / (r2 + self.0.softening).sqrt();
                    }
                }
                v
            },
            |p| p.iter().flatten().map(|p| 0.5 * p * p).sum()
        );
    };
}

particles!(Components, |q, i, j| {
    let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
    x * x + y * y + z * z
});
particles!(OverComponents, |q, i, j| (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum());

pub(crate) fn groups() -> Vec<Group<'static>> {
    let mut gravity = Group::new("gravity", 400);
    let points = || Phase::new((0..BODIES).map(position).collect(), vec![[0.0; 3]; BODIES]);
    spellings!(gravity, bodies(), points(), STEP;
        "softening first" First, "softening last" Last, "condition on a mass" Conditional, "number of masses" Counted,
    );
    let flat = || Phase::new((0..BODIES).flat_map(position).collect(), vec![0.0; 3 * BODIES]);
    spellings!(gravity, bodies(), flat(), STEP; "flat coordinates" Flat);
    let mut particles = Group::new("test particles", 200);
    let count = SOURCES + PARTICLES;
    let points = || Phase::new((0..count).map(position).collect(), vec![[0.0; 3]; count]);
    spellings!(particles, sources(), points(), STEP;
        "components" Components, "sum over components" OverComponents,
    );
    vec![gravity, particles]
}
