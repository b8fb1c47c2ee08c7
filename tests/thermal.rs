//! Long runs in heat baths against statistical mechanics: temperature of a liquid, diffusion, escape from a well.

use integrator_core::prelude::*;

/// Argon in a periodic box, in units of Lennard-Jones.
struct Argon {
    side: f64,
}

#[hamiltonian(compose = Obabo, split = kinetic + potential + friction)]
impl Argon {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / 2.0;
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                let x = x - self.side * (x / self.side).round_ties_even();
                let y = y - self.side * (y / self.side).round_ties_even();
                let z = z - self.side * (z / self.side).round_ties_even();
                let square = x * x + y * y + z * z;
                if square < 6.25 {
                    let sixth = square.powi(-3);
                    energy += 4.0 * (sixth * sixth - sixth);
                }
            }
        }
        energy
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        10.0
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        0.72
    }
}

/// The mean of numbers, and the deviation of this mean if they are independent.
fn mean(numbers: &[f64]) -> (f64, f64) {
    let count = numbers.len() as f64;
    let mean = numbers.iter().sum::<f64>() / count;
    let variance = numbers.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (count - 1.0);
    (mean, (variance / count).sqrt())
}

#[test]
fn a_liquid_has_the_temperature_of_the_bath() {
    let atoms = 125;
    let argon = Argon { side: (f64::from(atoms) / 0.8442).cbrt() };
    let place = |i: i32| [i % 5, i / 5 % 5, i / 25].map(|k| f64::from(k) * argon.side / 5.0);
    let start = Phase::new((0..atoms).map(place).collect(), vec![[0.0; 3]; atoms as usize]);
    let mut run = argon.run(start, 0.004).expect("a run").with_seed(1);
    run.advance(500).expect("until the momenta have forgotten the lattice");
    // Blocks of 0.4 units of time, where friction lets the kinetic energy forget itself in 0.05.
    let mut block = || {
        let temperatures = (0..20).map(|_| {
            run.advance(5).expect("steps");
            run.kinetic_temperature()
        });
        temperatures.sum::<f64>() / 20.0
    };
    let blocks: Vec<f64> = (0..16).map(|_| block()).collect();
    let (temperature, deviation) = mean(&blocks);
    // A deviation that 16 numbers estimate is too small by a quarter once in ten times.
    assert!((temperature - 0.72).abs() < 4.0 * deviation && deviation < 0.012, "{temperature} ± {deviation}");
    let balance = run.advance_with_balance(100).expect("steps");
    // Work by the error of the step is small, at all times, against the energy that the bath exchanges in 0.4 units of time.
    assert!(balance.work.abs() < 0.02 * run.kinetic(), "{balance:?}");
}

/// A particle without forces, of mass 2.
struct Free {
    gamma: f64,
}

#[hamiltonian(split = kinetic + potential + friction)]
impl Free {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 4.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        1e-30 * q[0]
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        self.gamma
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        0.6
    }
}

#[test]
fn diffusion_is_that_of_the_step_at_every_friction() {
    let (members, h, steps, mass, kt) = (6_000, 0.25, 200, 2.0, 0.6);
    for gamma in [0.5_f64, 2.0, 8.0] {
        let starts = (0..members).map(|_| (Free { gamma }, Phase::new([0.0], [0.0])));
        let mut swarm = Ensemble::new(Baoab, starts, h).expect("an ensemble").with_seed(3);
        swarm.advance(steps).expect("steps");
        let found = swarm.states().map(|state| state.q[0] * state.q[0]).sum::<f64>() / f64::from(members);
        // <q²>, <qp> and <p²> by the letters of a step: half a drift, friction with noise, half a drift.
        let [mut squares, mut mixed, mut momenta] = [0.0; 3];
        let (left, half) = ((-gamma * h).exp(), h / 2.0 / mass);
        for _ in 0..steps {
            (squares, mixed) = (squares + 2.0 * half * mixed + half * half * momenta, mixed + half * momenta);
            (mixed, momenta) = (left * mixed, left * left * momenta + mass * kt * (1.0 - left * left));
            (squares, mixed) = (squares + 2.0 * half * mixed + half * half * momenta, mixed + half * momenta);
        }
        let deviation = (2.0 / f64::from(members)).sqrt();
        assert!((found / squares - 1.0).abs() < 4.0 * deviation, "{found}, not {squares}");
        // Einstein's relation holds for long times and short steps: both corrections are seen at some friction.
        let einstein = 2.0 * kt / (mass * gamma) * h * f64::from(steps as u32);
        assert!((squares / einstein - 1.0).abs() < 0.6, "{squares} and {einstein}");
    }
}

/// A particle in a double well, whose barrier of height 5 kT is at 0.
struct Wells {
    gamma: f64,
}

#[hamiltonian(split = kinetic + potential + friction)]
impl Wells {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        5.0 * (q[0] * q[0] - 1.0).powi(2)
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        self.gamma
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        1.0
    }
}

/// The rate of escape from one well by Kramers, Grote and Hynes (J. T. Hynes, Annu. Rev. Phys. Chem. 36, 573 (1985)), for friction
/// without memory: that of transition state theory times `λ/ω`, where `λ² + γλ = ω²` at the barrier. It is for high barriers;
/// the correction for this one is that of strong friction, where the rate is known by quadrature.
fn rate(gamma: f64) -> f64 {
    let potential = |q: f64| 5.0 * (q * q - 1.0).powi(2);
    let [well, barrier] = [40.0_f64.sqrt(), 20.0_f64.sqrt()];
    let lambda = (gamma * gamma / 4.0 + barrier * barrier).sqrt() - gamma / 2.0;
    let high = |transmission: f64| transmission * well / std::f64::consts::TAU * (-5.0_f64).exp();
    // Strong friction: 1/(2 k) = γ ∫ exp(V) ∫ exp(-V) / 4 over one well and the barrier, up to corrections of exp(-5).
    let sum = |of: &dyn Fn(f64) -> f64, from: f64, to: f64| {
        (0..4_000).map(|i| of(from + (f64::from(i) + 0.5) * (to - from) / 4_000.0)).sum::<f64>() * (to - from) / 4_000.0
    };
    let strong = 1.0 / (sum(&|q| potential(q).exp(), -1.0, 1.0) * sum(&|q| (-potential(q)).exp(), -3.0, 0.0));
    high(lambda / barrier) * strong / high(barrier)
}

#[test]
fn particles_escape_from_a_well_at_the_rate_of_kramers() {
    let (members, h, steps) = (3_000, 0.04, 1_500_u32);
    let mut found = Vec::new();
    for gamma in [5.0, 20.0] {
        let starts = (0..members).map(|_| (Wells { gamma }, Phase::new([-1.0], [0.0])));
        let mut swarm = Ensemble::new(Baoab, starts, h).expect("an ensemble").with_seed(4);
        swarm.advance(u64::from(steps)).expect("steps");
        let right = swarm.states().filter(|state| state.q[0] > 0.0).count() as f64 / f64::from(members);
        // Both wells fill as (1 ± exp(-2 k t))/2; the count is binomial.
        let deviation = (right * (1.0 - right) / f64::from(members)).sqrt();
        let fraction = |rate: f64| (1.0 - (-2.0 * rate * h * f64::from(steps)).exp()) / 2.0;
        let expected = fraction(rate(gamma));
        // The corrections to both theories are of the second order in kT over the barrier, 1/25.
        assert!((right - expected).abs() < 4.0 * deviation + expected / 25.0, "{right}, not {expected} ± {deviation}");
        found.push((right, deviation));
    }
    let [(weak, deviation), (strong, _)] = [found[0], found[1]];
    assert!(weak - strong > 8.0 * deviation, "friction slows the escape: {found:?}");
}
