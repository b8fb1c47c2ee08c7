//! Systems whose flows are also text for devices: one for each kind of line that the text may have.

use integrator_core::prelude::*;

/// Sine and cosine.
#[derive(Clone)]
pub(crate) struct Pendulum {
    pub(crate) mass: f64,
    pub(crate) length: f64,
}

#[hamiltonian(gpu)]
impl Pendulum {
    const GRAVITY: f64 = 9.81;

    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.mass * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.mass * Self::GRAVITY * self.length * q[0].cos()
    }
}

/// A polynomial without parameters.
#[derive(Clone)]
pub(crate) struct HenonHeiles;

#[hamiltonian(gpu)]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

/// A loop over components, and a root cubed.
#[derive(Clone)]
pub(crate) struct Kepler {
    pub(crate) attraction: f64,
}

#[hamiltonian(gpu)]
impl Kepler {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        p.iter().map(|x| x * x).sum::<f64>() / 2.0
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        -self.attraction / q.iter().map(|x| x * x).sum::<f64>().sqrt()
    }
}

/// Tables over the indices of a loop, a branch, and the time; names that mean something else in C++.
#[derive(Clone)]
pub(crate) struct Wells {
    pub(crate) double: [f64; 3],
    pub(crate) switch: f64,
    pub(crate) long: bool,
}

#[hamiltonian(gpu)]
impl Wells {
    fn kinetic(&self, p: [[f64; 2]; 3]) -> f64 {
        let mut energy = 0.0;
        for class in 0..3 {
            energy += (1.0 + p[class][0] * p[class][0]).sqrt() + 0.5 * p[class][1] * p[class][1] * self.double[class];
        }
        energy
    }
    fn potential(&self, q: [[f64; 2]; 3], t: f64) -> f64 {
        let mut energy = 0.0;
        for class in 0..3 {
            let r = q[class][0].abs();
            if r > self.switch {
                energy += (r - self.switch).powi(3) * self.double[class].exp();
            } else {
                energy -= (-q[class][1] * q[class][1]).exp() * t.cos();
            }
            if self.long {
                energy += 0.1 * q[class][0] * q[(class + 1) % 3][1] + 0.01 * q[class][1].powi(4);
            }
        }
        energy
    }
}

/// Three parts, the one in the middle a shear, with a drift of another form.
#[derive(Clone)]
pub(crate) struct Twisted {
    pub(crate) rate: f64,
}

#[hamiltonian(split = kinetic + twist + potential, compose = Yoshida4, gpu)]
impl Twisted {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (1.0 + p[0] * p[0] + p[1] * p[1]).sqrt()
    }
    fn twist(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        self.rate * q[0] * q[0] * p[1]
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        q[0].atan2(2.0 + q[1].atan()) + 0.5 * q[1] * q[1] + (1.0 + q[0] * q[0]).powf(0.3)
    }
}

/// A charge in a wave: a part with a kinetic momentum, which reads the time.
#[derive(Clone)]
pub(crate) struct Charge {
    pub(crate) number: f64,
}

#[hamiltonian(split = along_x + along_y + well, compose = Yoshida4, gpu)]
impl Charge {
    fn along_x(&self, q: [f64; 2], p: [f64; 2], t: f64) -> f64 {
        0.5 * (p[0] - 0.7 * (self.number * q[0] - q[1] - t).sin()).powi(2)
    }
    fn along_y(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        (1.0 + (p[1] + q[0] * q[1] * q[1]).powi(2)).sqrt() * (2.0 + q[0].cos())
    }
    fn well(&self, q: [f64; 2]) -> f64 {
        0.5 * (q[0] * q[0] + q[1] * q[1]) + 0.25 * q[1].powi(4)
    }
}

/// Two parts in a pair.
#[derive(Clone)]
pub(crate) struct Paired {
    pub(crate) rate: f64,
}

#[hamiltonian(split = kinetic + (twist + potential), compose = Verlet, functions = fast, gpu)]
impl Paired {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn twist(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        self.rate * q[0] * q[0] * p[1]
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        0.5 * q[0] * q[0] + q[0].sin() * (0.1 * q[1]).exp()
    }
}

/// A soft field that reads the time, with inner steps for the stiff rest; a field has the name of their number.
#[derive(Clone)]
pub(crate) struct Stiff {
    pub(crate) inner_steps: f64,
}

#[hamiltonian(split = well + 8 * (spring + kinetic), compose = Verlet, gpu)]
impl Stiff {
    fn well(&self, q: [f64; 2], t: f64) -> f64 {
        -self.inner_steps * (1.0 + 0.5 * t.cos()) * (q[0] - q[1]).cos()
    }
    fn spring(&self, q: [f64; 2]) -> f64 {
        20.0 * self.inner_steps * (q[0] * q[0] + q[1].powi(4))
    }
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
}

/// Four parts in the inner steps of another composition, all but one of which read the time.
#[derive(Clone)]
pub(crate) struct Turned {
    pub(crate) rate: f64,
}

#[hamiltonian(split = well + 3 * BlanesMoan4(spring + turn + twist + kinetic), compose = Verlet, gpu)]
impl Turned {
    fn well(&self, q: [f64; 2]) -> f64 {
        0.3 * (q[0] + q[1]).sin()
    }
    fn spring(&self, q: [f64; 2], t: f64) -> f64 {
        (2.0 + t.sin()) * (q[0] * q[0] + q[1] * q[1])
    }
    fn turn(&self, q: [f64; 2], p: [f64; 2], t: f64) -> f64 {
        self.rate * t.sin() * q[0] * q[0] * p[1]
    }
    fn twist(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        self.rate * q[1].cos() * p[0]
    }
    fn kinetic(&self, p: [f64; 2], t: f64) -> f64 {
        (0.5 + 0.1 * t.cos()) * (p[0] * p[0] + p[1] * p[1])
    }
}

/// Inner steps within inner steps within others; the outermost of these compositions begins and ends with those within.
#[derive(Clone)]
pub(crate) struct Deep {
    pub(crate) stiffness: [f64; 3],
}

#[hamiltonian(
    split = tide + 3 * VelocityVerlet(well + 2 * Yoshida4(spring + 3 * VelocityVerlet(bond + turn + kinetic))),
    compose = Verlet,
    gpu
)]
impl Deep {
    fn tide(&self, q: [f64; 2], t: f64) -> f64 {
        (0.1 * t).cos() * (q[0] - q[1])
    }
    fn well(&self, q: [f64; 2]) -> f64 {
        self.stiffness[0] * (1.0 + q[0] * q[0]).sqrt()
    }
    fn spring(&self, q: [f64; 2], t: f64) -> f64 {
        self.stiffness[1] * (1.0 + 0.1 * t.sin()) * q[1] * q[1]
    }
    fn bond(&self, q: [f64; 2], t: f64) -> f64 {
        self.stiffness[2] * (1.0 + 0.1 * t.cos()) * (q[0] - q[1]).powi(2)
    }
    fn turn(&self, q: [f64; 2], p: [f64; 2], t: f64) -> f64 {
        0.1 * t.cos() * q[0] * q[0] * p[1]
    }
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
}

/// A motion that leaves the finite numbers.
#[derive(Clone)]
pub(crate) struct Runaway {
    pub(crate) strength: f64,
}

#[hamiltonian(gpu)]
impl Runaway {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.strength * q[0].powi(4)
    }
}

/// Functions of the device's own, some of which have no kernel of this library's.
#[derive(Clone)]
pub(crate) struct Native {
    pub(crate) stiffness: f64,
}

#[hamiltonian(gpu(functions = native))]
impl Native {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        self.stiffness * (q[0].cosh() + q[1].hypot(1.0)) + (q[0] - q[1]).sin() * q[1].tanh() + (0.1 * q[0]).exp2()
    }
}

/// A constant that is an index.
const FIRST: usize = 2;

/// Fields that are indices, and how often a loop runs.
#[derive(Clone)]
pub(crate) struct Picked {
    pub(crate) site: usize,
    pub(crate) count: usize,
    pub(crate) partner: [usize; 2],
}

#[hamiltonian(gpu)]
impl Picked {
    fn kinetic(&self, p: [f64; 4]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 4]) -> f64 {
        let mut energy = 0.3 * q[self.site].powi(4) + q[FIRST].cos();
        for i in 0..self.count {
            energy += (i as f64 + 1.0) * (q[i] - q[self.partner[i % 2]]).powi(2);
        }
        energy
    }
}

/// Bodies that attract each other: an even number of them, in space.
#[derive(Clone)]
pub(crate) struct Planets {
    pub(crate) gravity: f64,
    pub(crate) mass: [f64; 6],
}

#[hamiltonian(gpu)]
impl Planets {
    fn kinetic(&self, p: [[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for d in 0..3 {
                energy += p[i][d].powi(2) / (2.0 * self.mass[i]);
            }
        }
        energy
    }
    fn potential(&self, q: [[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for j in 0..i {
                let mut r2 = 0.0;
                for d in 0..3 {
                    r2 += (q[i][d] - q[j][d]).powi(2);
                }
                energy -= self.gravity * self.mass[i] * self.mass[j] / r2.sqrt();
            }
        }
        energy
    }
}

/// An odd number of bodies on a line, in a trap that comes and goes, whose actions are not all reactions.
#[derive(Clone)]
pub(crate) struct Charges {
    pub(crate) charge: [f64; 5],
}

#[hamiltonian(gpu)]
impl Charges {
    fn kinetic(&self, p: [f64; 5]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 5], t: f64) -> f64 {
        let mut energy = 0.0;
        for i in 0..5 {
            energy += 0.5 * self.charge[i] * q[i] * q[i] * (1.0 + 0.5 * t.cos());
            for j in 0..i {
                energy += self.charge[i] * self.charge[j] / (1.0 + (q[i] - q[j]).powi(2)) + 0.1 * (q[i] * q[j]).sin();
            }
        }
        energy
    }
}

/// A ring of sites whose masses and springs differ.
#[derive(Clone)]
pub(crate) struct Ring {
    pub(crate) mass: [f64; 16],
    pub(crate) alpha: [f64; 16],
}

#[hamiltonian(gpu)]
impl Ring {
    fn kinetic(&self, p: [f64; 16]) -> f64 {
        let mut energy = 0.0;
        for i in 0..16 {
            energy += p[i] * p[i] / (2.0 * self.mass[i]);
        }
        energy
    }
    fn potential(&self, q: [f64; 16]) -> f64 {
        let mut energy = 0.0;
        for i in 0..16 {
            let r = q[(i + 1) % 16] - q[i];
            energy += r * r / 2.0 + self.alpha[i] * r.powi(3) / 3.0;
        }
        energy
    }
}

/// A line of sites between walls, with springs to the next two.
#[derive(Clone)]
pub(crate) struct Walls {
    pub(crate) stiffness: [f64; 11],
}

#[hamiltonian(gpu)]
impl Walls {
    fn kinetic(&self, p: [f64; 12]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: [f64; 12], t: f64) -> f64 {
        let mut energy = q[0].powi(2) + q[11].powi(4);
        for i in 0..11 {
            energy += self.stiffness[i] * (q[i + 1] - q[i]).powi(4) / 4.0;
        }
        for i in 0..10 {
            energy += (1.0 + 0.2 * t.cos()) * (q[i + 2] - q[i]).powi(2) / 8.0;
        }
        energy
    }
}
