//! Parts that are quadratic forms in q and p, moved by matrix exponentials: oscillators, magnetic fields, turning frames.
//!
//! All of it holds on every instruction set. A process uses one, so [`instruction_sets`] runs these tests again in a
//! process for each of the others.

#[path = "support/instruction_sets.rs"]
mod instruction_sets;

use integrator_core::{
    Aba864, Ensemble, KahanLi8,
    check::{CertifyError, Shortfall, certify},
    prelude::*,
};

/// Hénon and Heiles's potential with a small cubic term.
#[derive(Clone)]
struct HenonHeiles {
    epsilon: f64,
}

#[hamiltonian(split = harmonic + anharmonic, compose = Aba864)]
impl HenonHeiles {
    fn harmonic(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py) + 0.5 * (x * x + y * y)
    }
    fn anharmonic(&self, q: [f64; 2]) -> f64 {
        let [x, y] = q;
        self.epsilon * (x * x * y - y.powi(3) / 3.0)
    }
}

/// A charge in a magnetic field along z and an electric quadrupole, with an octupole beside it.
#[derive(Clone)]
struct PenningTrap {
    mass: f64,
    /// Charge times field.
    magnetic: f64,
    /// Charge times curvature of the potential along z.
    electric: f64,
    octupole: f64,
}

#[hamiltonian(split = trap + octupole, compose = Aba864)]
impl PenningTrap {
    fn trap(&self, [x, y, z]: [f64; 3], [px, py, pz]: [f64; 3]) -> f64 {
        // The kinetic momentum is p - e A, with A = B/2 (-y, x, 0).
        let (ux, uy) = (px + 0.5 * self.magnetic * y, py - 0.5 * self.magnetic * x);
        (ux * ux + uy * uy + pz * pz) / (2.0 * self.mass) + 0.5 * self.electric * (z * z - 0.5 * (x * x + y * y))
    }
    fn octupole(&self, q: [f64; 3]) -> f64 {
        let [x, y, z] = q;
        let radius = x * x + y * y;
        self.octupole * (z.powi(4) - 3.0 * z * z * radius + 0.375 * radius * radius)
    }
}

/// Bodies of different masses that fall in a turning frame, each held by a spring that is not linear.
#[derive(Clone)]
struct Turning {
    rate: f64,
    masses: Vec<f64>,
}

#[hamiltonian(split = springs + frame, compose = Yoshida4)]
impl Turning {
    fn springs(&self, q: &[[f64; 2]]) -> f64 {
        q.iter().map(|[x, y]| (x * x + y * y).powi(2)).sum()
    }
    fn frame(&self, q: &[[f64; 2]], p: &[[f64; 2]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            let [[x, y], [px, py]] = [q[i], p[i]];
            energy += (px * px + py * py) / (2.0 * self.masses[i]) - self.rate * (x * py - y * px) + 0.3 * y;
        }
        energy
    }
}

/// A chain of oscillators, all of which couple: each spring is linear, each site is not.
#[derive(Clone)]
struct Chain {
    coupling: f64,
}

#[hamiltonian(split = linear + sites, compose = Aba864)]
impl Chain {
    fn linear(&self, q: [f64; 5], p: [f64; 5]) -> f64 {
        let mut energy = 0.0;
        for i in 0..5 {
            energy += 0.5 * p[i] * p[i];
        }
        for i in 1..5 {
            energy += 0.5 * self.coupling * (q[i] - q[i - 1]).powi(2);
        }
        energy
    }
    fn sites(&self, q: [f64; 5]) -> f64 {
        q.iter().map(|x| 0.25 * x.powi(4)).sum()
    }
}

/// The Penning trap in one function.
struct Sorted(PenningTrap);

#[hamiltonian(split = quadratic + rest, compose = Aba864)]
impl Sorted {
    fn hamiltonian(&self, [x, y, z]: [f64; 3], [px, py, pz]: [f64; 3]) -> f64 {
        let (ux, uy) = (px + 0.5 * self.0.magnetic * y, py - 0.5 * self.0.magnetic * x);
        let radius = x * x + y * y;
        let trap = (ux * ux + uy * uy + pz * pz) / (2.0 * self.0.mass) + 0.5 * self.0.electric * (z * z - 0.5 * radius);
        trap + self.0.octupole * (z.powi(4) - 3.0 * z * z * radius + 0.375 * radius * radius)
    }
}

fn trap(k: f64) -> PenningTrap {
    PenningTrap { mass: 1.5, magnetic: 6.0 + 0.1 * k, electric: 2.0, octupole: 0.05 }
}

fn charge(k: f64) -> Phase<[f64; 3]> {
    Phase { q: [0.4, -0.1 * k, 0.3], p: [0.2, 0.1, -0.2] }
}

fn bodies(k: f64) -> Phase<Vec<[f64; 2]>> {
    Phase { q: vec![[0.3, 0.1 * k], [0.2, -0.4], [-0.5, 0.6]], p: vec![[0.1, 0.2], [-0.3, 0.05 * k], [0.4, -0.1]] }
}

fn turning(k: f64) -> Turning {
    Turning { rate: 0.2 + 0.1 * k, masses: vec![1.0, 2.0, 1.0] }
}

fn chain(k: f64) -> Phase<[f64; 5]> {
    Phase { q: [0.1, -0.2, 0.3, 0.1 * k, -0.1], p: [0.0, 0.2, -0.1, 0.1, 0.3] }
}

fn times<const N: usize>(factor: f64, Phase { q, p }: Phase<[f64; N]>) -> Phase<[f64; N]> {
    Phase { q: q.map(|q| factor * q), p: p.map(|p| factor * p) }
}

#[test]
fn quadratic_forms_are_certified() {
    let start = Phase { q: [0.3, -0.2], p: [0.1, 0.4] };
    certify::<_, _, f64>(&HenonHeiles { epsilon: 1.0 }, Aba864, start, 0.1).unwrap_or_else(|error| panic!("{error}"));
    certify::<_, _, f64>(&trap(0.0), Aba864, charge(1.0), 0.05).unwrap_or_else(|error| panic!("{error}"));
    certify::<_, _, f64>(&turning(1.0), Yoshida4, bodies(1.0), 0.05).unwrap_or_else(|error| panic!("{error}"));
    certify::<_, _, f64>(&Chain { coupling: 0.7 }, Aba864, chain(1.0), 0.1).unwrap_or_else(|error| panic!("{error}"));
}

/// A cubic term is as large as the amplitude, beside the quadratic one, and a quartic one of a large amplitude is larger.
#[test]
fn the_size_of_the_second_part_is_certified() {
    let size = |amplitude: f64, epsilon: f64| {
        let start = times(amplitude, Phase { q: [0.3, -0.2], p: [0.1, 0.4] });
        let certificate =
            certify(&HenonHeiles { epsilon }, Aba864, start, 0.1).unwrap_or_else(|error| panic!("{error}"));
        let part = certificate.second_part.expect("two parts that move the same momenta");
        assert_eq!(part.orders, [8, 6, 4]);
        part.size
    };
    // The forces are x² - y² and 2 x y beside x and y, and all coordinates are below 0.5 in units of the amplitude.
    let small = size(1.0 / 64.0, 1.0);
    assert!(0.0 < small && small < 1.0 / 64.0, "{small}");
    // The same motion in other units, by powers of two, has the same bits.
    assert_eq!(size(1.0, 1.0 / 64.0), small);

    let stretched = times(10.0, chain(1.0));
    let Err(CertifyError::Refused { certificate, shortfalls }) =
        certify(&Chain { coupling: 0.7 }, Aba864, stretched, 0.001)
    else {
        panic!("certified")
    };
    let part = certificate.second_part.expect("a size");
    assert!(shortfalls.contains(&Shortfall::NotSmall(part)), "{certificate}");
    assert!(Shortfall::NotSmall(part).to_string().contains("(8, 6, 4)"));
    // A composition for any parts claims nothing of their sizes.
    let outcome = certify(&Chain { coupling: 0.7 }, KahanLi8, stretched, 0.001);
    assert!(outcome.is_ok_and(|certificate| certificate.second_part.is_none()));
}

#[test]
fn terms_of_one_function_are_sorted_into_the_same_parts() {
    let end = |run: Result<Run<[f64; 3]>, Error>| {
        let mut run = run.expect("a run");
        run.advance(100).expect("finite");
        (run.state(), run.energy())
    };
    let (one, two) = (end(Sorted(trap(0.0)).run(charge(1.0), 0.1)), end(trap(0.0).run(charge(1.0), 0.1)));
    let pairs = one.0.q.iter().chain(&one.0.p).chain([&one.1]).zip(two.0.q.iter().chain(&two.0.p).chain([&two.1]));
    for (one, two) in pairs {
        // Coefficients are rounded in another order, and each of a hundred steps rounds numbers below one.
        assert!((one - two).abs() <= 1e-13, "{one} {two}");
    }
    certify::<_, _, f64>(&Sorted(trap(0.0)), Aba864, charge(1.0), 0.05).unwrap_or_else(|error| panic!("{error}"));
}

/// The distance of a run with this step from one with a tenth of it, after a time of 20.
fn error(epsilon: f64, steps: u64) -> f64 {
    let end = |steps: u64| {
        let start = Phase::compensated([0.3, -0.2], [0.1, 0.4]);
        let mut run = HenonHeiles { epsilon }.run(start, 20.0 / steps as f64).expect("a run");
        run.advance(steps).expect("finite");
        let Phase { q: [x, y], p: [px, py] } = run.state();
        [x, y, px, py].map(|slot| slot.value)
    };
    let (coarse, fine) = (end(steps), end(10 * steps));
    coarse.into_iter().zip(fine).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn errors_fall_with_the_step_and_with_the_non_quadratic_part() {
    // (8, 6, 4): terms ε h^8, ε² h^6 and ε³ h^4. At ε = 1 the last one is left in the end, and orders are even.
    let slope = (error(1.0, 40) / error(1.0, 80)).log2();
    assert!(slope > 3.5, "{slope}");
    // At a small ε it is the first one; a composition of T + V has an error that does not fall with ε.
    let slope = (error(1e-4, 16) / error(1e-4, 24)).ln() / 1.5_f64.ln();
    assert!(slope > 7.0, "{slope}");
    let of_epsilon = (error(1e-3, 16) / error(1e-4, 16)).log10();
    assert!((of_epsilon - 1.0).abs() < 0.1, "{of_epsilon}");
}

#[test]
fn a_penning_trap_turns_with_its_three_frequencies() {
    let trap = PenningTrap { octupole: 0.0, ..trap(0.0) };
    let (steps, h) = (10_000_u32, 0.37);
    let start = charge(1.0);
    let mut run = trap.run(start, h).expect("a run");
    run.advance(u64::from(steps)).expect("finite");
    let t = f64::from(steps) * h;
    let (cyclotron, axial) = (trap.magnetic / trap.mass, (trap.electric / trap.mass).sqrt());
    let root = (cyclotron * cyclotron - 2.0 * axial * axial).sqrt();
    let [fast, slow] = [0.5 * (cyclotron + root), 0.5 * (cyclotron - root)];
    // x + iy = a e^(-i fast t) + b e^(-i slow t), with the velocity (p - e A) / m.
    let ([x, y, z], [px, py, pz]) = (start.q, start.p);
    let [vx, vy] = [(px + 0.5 * trap.magnetic * y) / trap.mass, (py - 0.5 * trap.magnetic * x) / trap.mass];
    // i v = fast a + slow b, with a + b = x + iy.
    let a = [(-vy - slow * x) / (fast - slow), (vx - slow * y) / (fast - slow)];
    let b = [x - a[0], y - a[1]];
    let turned = |[re, im]: [f64; 2], frequency: f64| {
        let (sine, cosine) = (frequency * t).sin_cos();
        [re * cosine + im * sine, im * cosine - re * sine]
    };
    let (a, b) = (turned(a, fast), turned(b, slow));
    let (sine, cosine) = (axial * t).sin_cos();
    let expected = [a[0] + b[0], a[1] + b[1], z * cosine + pz / (trap.mass * axial) * sine];
    // Each step rounds a state of this size a few times, and phases of 1e4 radians are rounded to 1e-12 in the formula.
    for (found, expected) in run.state().q.iter().zip(expected) {
        assert!((found - expected).abs() <= 1e-11, "{found} {expected}");
    }
}

/// Members of an ensemble beside each one alone.
macro_rules! assert_members_are_alone {
    ($system:expr, $start:expr) => {{
        let members: Vec<_> = (0..11).map(|k| ($system(k as f64), $start(k as f64))).collect();
        let mut all = Ensemble::new(KahanLi8, members.clone(), 0.01).expect("an ensemble");
        all.advance(40).expect("finite");
        for ((system, start), together) in members.into_iter().zip(all.states()) {
            let mut alone = system.run_with(KahanLi8, start, 0.01).expect("a run");
            alone.advance(40).expect("finite");
            assert_eq!(alone.state(), together);
        }
    }};
}

#[test]
fn a_member_has_the_bits_of_its_run_alone() {
    let henon_heiles = |k: f64| HenonHeiles { epsilon: 0.1 * k };
    let plane = |k: f64| Phase { q: [0.03 * k, -0.2], p: [0.1, 0.4] };
    assert_members_are_alone!(henon_heiles, plane);
    assert_members_are_alone!(trap, |k: f64| Phase { q: [0.4_f32, -0.1 * k as f32, 0.3], p: [0.2, 0.1, -0.2] });
    assert_members_are_alone!(turning, bodies);
    assert_members_are_alone!(turning, |k: f64| Phase::compensated(bodies(k).q, bodies(k).p));
    // One member does not couple what the others do.
    assert_members_are_alone!(|k: f64| Chain { coupling: 0.1 * k }, chain);
}
