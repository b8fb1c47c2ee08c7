//! Parts with names: shears, flows that the user wrote, and `T` and `V` in another order are certified, and a member of
//! an ensemble has the bits of its run alone.

use integrator_core::{
    Abah844, Chin4A, Composition, Ensemble, KahanLi8, Verlet,
    check::{CertifyError, FlowLaw, Shortfall, certify},
    prelude::*,
};

/// A shear and a potential.
#[derive(Clone)]
struct Twist {
    rate: f64,
}

#[hamiltonian(split = twist + potential, compose = Yoshida4)]
impl Twist {
    fn twist(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        self.rate * q[0].sin() * p[1].powi(2) + 0.5 * p[1] * p[1]
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        (q[0] * q[1]).cos() + 0.5 * (q[0] * q[0] + q[1] * q[1])
    }
}

/// Three parts, none of which commutes with another.
#[derive(Clone)]
struct Three {
    rate: f64,
}

#[hamiltonian(split = motion + twist + potential, compose = Yoshida4)]
impl Three {
    fn motion(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn twist(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        self.rate * q[0].sin() * p[1]
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        (q[0] * q[1]).cos() + 0.5 * (q[0] * q[0] + q[1] * q[1])
    }
}

/// Planets in democratic heliocentric coordinates: positions from the star, momenta from the centre of mass.
#[derive(Clone)]
struct Heliocentric {
    mass: [f64; 2],
}

#[hamiltonian(split = kepler + (jump + interaction), compose = Abah844)]
impl Heliocentric {
    fn kepler(&self, q: [[f64; 2]; 2], p: [[f64; 2]; 2]) -> f64 {
        let mut energy = 0.0;
        for i in 0..2 {
            let square = p[i].iter().map(|p| p * p).sum::<f64>();
            let distance = q[i].iter().map(|q| q * q).sum::<f64>().sqrt();
            energy += 0.5 * square / self.mass[i] - self.mass[i] / distance;
        }
        energy
    }
    fn jump(&self, p: [[f64; 2]; 2]) -> f64 {
        let mut square = 0.0;
        for d in 0..2 {
            square += (p[0][d] + p[1][d]).powi(2);
        }
        0.5 * square
    }
    fn interaction(&self, q: [[f64; 2]; 2]) -> f64 {
        let d = [q[0][0] - q[1][0], q[0][1] - q[1][1]];
        -self.mass[0] * self.mass[1] / (d[0] * d[0] + d[1] * d[1]).sqrt()
    }
}

/// Planets of these masses on orbits about a star of mass 1.
fn planets(mass: [f64; 2]) -> Phase<[[f64; 2]; 2]> {
    let q = [[1.0, 0.0], [0.0, 2.2]];
    let v = [[0.0, 1.05], [-0.7, 0.0]];
    Phase { q, p: std::array::from_fn(|i| v[i].map(|v| v * mass[i])) }
}

/// Points in a list, each with a shear that reaches its neighbour.
#[derive(Clone)]
struct Chained {
    rate: f64,
}

#[hamiltonian(split = potential + shear)]
impl Chained {
    fn potential(&self, q: &[[f64; 2]]) -> f64 {
        q.iter().map(|q| q[0].powi(4) + 0.5 * q[1] * q[1]).sum()
    }
    fn shear(&self, q: &[[f64; 2]], p: &[[f64; 2]]) -> f64 {
        let mut energy = 0.0;
        for i in 1..q.len() {
            energy += self.rate * q[i][0] * q[i - 1][0].sin() * p[i][1] + 0.5 * p[i][1] * p[i - 1][1];
        }
        energy
    }
}

/// Electrons and the wave that they share, whose momentum is multiplied by a sum over the electrons: the model of a
/// free-electron laser. The number of electrons is that of the start less one.
#[derive(Clone)]
struct Laser {
    rate: f64,
}

#[hamiltonian(split = motion + exchange)]
impl Laser {
    fn motion(&self, q: &[f64], p: &[f64]) -> f64 {
        let n = q.len();
        let mut energy = 0.5 * q[n - 1].powi(2);
        for j in 0..n - 1 {
            energy += 0.5 * p[j] * p[j];
        }
        energy
    }
    fn exchange(&self, q: &[f64], p: &[f64]) -> f64 {
        let mut bunching = 0.0;
        for j in 0..q.len() - 1 {
            bunching += q[j].sin();
        }
        let wave = p[q.len() - 1];
        0.5 * wave * wave + self.rate * wave * bunching
    }
}

/// A particle whose momentum is moved by a bath of oscillators, in arrays: the particle is the first coordinate.
#[derive(Clone)]
struct Bath {
    rate: f64,
}

#[hamiltonian(split = particle + bath)]
impl Bath {
    fn particle(&self, q: [f64; 3], p: [f64; 3]) -> f64 {
        let mut bath = 0.0;
        for j in 1..3 {
            bath += self.rate * q[j].sin();
        }
        0.5 * (p[0] - bath).powi(2)
    }
    fn bath(&self, q: [f64; 3], p: [f64; 3]) -> f64 {
        let mut energy = q[0].cos();
        for j in 1..3 {
            energy += 0.5 * p[j] * p[j];
        }
        energy
    }
}

/// An oscillator whose flow the user wrote, beside an anharmonic rest.
#[derive(Clone)]
struct Turning {
    frequency: f64,
    /// What the flow loses per unit of time: nothing, if it is right.
    loss: f64,
}

#[hamiltonian(split = oscillator + rest, compose = Chin4A)]
impl Turning {
    fn oscillator(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
        0.5 * self.frequency * (q[0] * q[0] + p[0] * p[0])
    }
    #[flow(oscillator)]
    fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {
        let (sine, cosine) = (self.frequency * duration).sin_cos();
        let kept = 1.0 - self.loss * duration;
        (q[0], p[0]) = (kept * (cosine * q[0] + sine * p[0]), kept * (cosine * p[0] - sine * q[0]));
    }
    fn rest(&self, q: [f64; 1]) -> f64 {
        0.25 * q[0].powi(4)
    }
}

/// Members of an ensemble beside each one alone.
macro_rules! assert_members_are_alone {
    ($system:expr, $start:expr) => {{
        let members: Vec<_> = (0..11).map(|k| ($system(0.5 + 0.1 * k as f64), $start(k as f64))).collect();
        let mut all = Ensemble::new(KahanLi8, members.clone(), 0.01).expect("an ensemble");
        all.advance(40).expect("finite");
        for ((system, start), together) in members.into_iter().zip(all.states()) {
            let mut alone = system.run_with(KahanLi8, start, 0.01).expect("a run");
            alone.advance(40).expect("finite");
            assert_eq!(alone.state(), together);
        }
    }};
}

fn points(k: f64) -> Phase<Vec<[f64; 2]>> {
    Phase { q: vec![[0.3, 0.1 * k], [0.2, -0.4], [-0.5, 0.6]], p: vec![[0.1, 0.2], [-0.3, 0.05 * k], [0.4, -0.1]] }
}

#[test]
fn shears_are_certified() {
    let twist = Twist { rate: 0.7 };
    let start = Phase { q: [0.4, -0.2], p: [0.3, 0.5] };
    certify::<_, _, f64>(&twist, Yoshida4, start, 0.02).unwrap_or_else(|error| panic!("{error}"));
    certify::<_, _, f64>(&Chained { rate: 0.7 }, Verlet, points(1.0), 0.02).unwrap_or_else(|error| panic!("{error}"));
    assert_members_are_alone!(|rate| Twist { rate }, |k: f64| Phase { q: [0.1 * k, -0.2], p: [0.3, 0.5] });
    assert_members_are_alone!(|rate| Chained { rate }, points);
}

#[test]
fn shears_whose_sums_run_over_other_coordinates_are_certified() {
    let listed = |k: f64| Phase { q: vec![0.4, -0.2, 0.1 * k, 0.7], p: vec![0.3, 0.5, -0.1, 0.6] };
    let three = |k: f64| Phase { q: [0.4, 0.1 * k, -0.2], p: [0.3, 0.5, -0.1] };
    certify::<_, _, f64>(&Laser { rate: 0.7 }, Verlet, listed(2.0), 0.02).unwrap_or_else(|error| panic!("{error}"));
    certify::<_, _, f64>(&Bath { rate: 0.7 }, Verlet, three(2.0), 0.02).unwrap_or_else(|error| panic!("{error}"));
    assert_members_are_alone!(|rate| Laser { rate }, listed);
    assert_members_are_alone!(|rate| Bath { rate }, three);
}

#[test]
fn three_parts_are_certified() {
    let start = Phase { q: [0.4, -0.2], p: [0.3, 0.5] };
    let three = Three { rate: 0.7 };
    certify::<_, _, f64>(&three, Yoshida4, start, 0.02).unwrap_or_else(|error| panic!("{error}"));
    certify::<_, _, f64>(&three, KahanLi8, start, 0.1).unwrap_or_else(|error| panic!("{error}"));
    assert_members_are_alone!(|rate| Three { rate }, |k: f64| Phase { q: [0.1 * k, -0.2], p: [0.3, 0.5] });
}

#[test]
fn a_part_that_is_a_pair_is_certified() {
    let system = Heliocentric { mass: [1e-3, 5e-4] };
    certify::<_, _, f64>(&system, Abah844, planets(system.mass), 0.1).unwrap_or_else(|error| panic!("{error}"));
    assert_members_are_alone!(|mass| Heliocentric { mass: [1e-3 * mass, 5e-4] }, |k: f64| planets([1e-3, 1e-4 * k]));
}

/// The error of order `ε² h⁴` of two steps of which one is half of the other, against steps of eighth order.
#[test]
fn a_part_that_is_a_pair_costs_no_order() {
    fn end<X: Composition<Heliocentric>>(composition: X, steps: u32) -> [[f64; 2]; 2] {
        let system = Heliocentric { mass: [1e-2, 5e-3] };
        let mut run = system.run_with(composition, planets(system.mass), 12.0 / f64::from(steps)).expect("a run");
        run.advance(u64::from(steps)).expect("finite");
        run.state().q
    }
    let exact = end(KahanLi8, 600);
    let error = |q: [[f64; 2]; 2]| {
        q.iter().flatten().zip(exact.iter().flatten()).map(|(q, exact)| (q - exact).abs()).fold(0.0, f64::max)
    };
    let order = |coarse: [[f64; 2]; 2], fine| (error(coarse) / error(fine)).log2();
    let (kept, second) = (order(end(Abah844, 60), end(Abah844, 120)), order(end(Verlet, 60), end(Verlet, 120)));
    assert!((kept - 4.0).abs() < 0.5 && (second - 2.0).abs() < 0.5, "orders {kept} and {second}");
}

#[test]
fn flows_of_the_user_are_certified_or_refused() {
    let start = Phase { q: [0.4], p: [0.3] };
    let right = Turning { frequency: 1.3, loss: 0.0 };
    for certificate in
        [certify::<_, _, f64>(&right, KahanLi8, start, 0.05), certify::<_, _, f64>(&right, Chin4A, start, 0.05)]
    {
        certificate.unwrap_or_else(|error| panic!("{error}"));
    }
    let wrong = Turning { frequency: 1.3, loss: 1e-9 };
    let Err(CertifyError::Refused { shortfalls, .. }) = certify::<_, _, f64>(&wrong, Chin4A, start, 0.05) else {
        panic!("a flow that loses energy is certified");
    };
    let laws = shortfalls.iter().filter_map(|shortfall| match shortfall {
        Shortfall::Flow { part, law, .. } => Some((part.as_str(), *law)),
        _ => None,
    });
    let laws: Vec<_> = laws.collect();
    assert!(laws.contains(&("oscillator", FlowLaw::Symplecticity)), "{laws:?}");
    assert_members_are_alone!(|frequency| Turning { frequency, loss: 0.0 }, |k: f64| Phase { q: [0.1 * k], p: [0.5] });
}

/// `V + T` is `T + V` with the letters exchanged: each composition is then the one that begins with the other flow.
#[test]
fn the_order_of_parts_is_that_of_the_letters() {
    struct Pendulum;
    #[hamiltonian(split = field + motion)]
    impl Pendulum {
        fn field(&self, q: [f64; 1]) -> f64 {
            -q[0].cos()
        }
        fn motion(&self, p: [f64; 1]) -> f64 {
            0.5 * p[0] * p[0]
        }
    }
    let start = Phase { q: [0.5], p: [0.2] };
    let mut run = Pendulum.run(start, 0.1).expect("a run");
    run.advance(1).expect("finite");
    // Verlet is A(1/2) B(1) A(1/2), and A is the field here.
    let [q, p]: [f64; 2] = [0.5, 0.2];
    let middle = p - 0.05 * q.sin();
    let q = q + 0.1 * middle;
    let expected = Phase { q: [q], p: [middle - 0.05 * q.sin()] };
    let close = |a: f64, b: f64| (a - b).abs() <= 4.0 * f64::EPSILON * b.abs();
    assert!(close(run.state().q[0], expected.q[0]) && close(run.state().p[0], expected.p[0]), "{:?}", run.state());
}
