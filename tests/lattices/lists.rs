//! Sums over lists, whose terms share vectors: the order of additions is that of the lists.

use integrator_core::prelude::*;
use std::panic::catch_unwind;

/// Forces that do not depend on where anything is.
#[derive(Clone)]
struct Weights {
    links: Vec<(usize, usize)>,
    weights: Vec<f64>,
}

#[hamiltonian]
impl Weights {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for (k, &(a, b)) in self.links.iter().enumerate() {
            energy += self.weights[k] * (q[b] - q[a]);
        }
        energy
    }
}

/// The number of bodies: few, so that most vectors name one of them several times.
const BODIES: usize = 5;
/// A power of two, so that momenta have the bits of sums.
const STEP: f64 = 1.0 / 64.0;

impl Weights {
    /// So many links, whose weights round each other off.
    fn example(count: usize) -> Self {
        let mut state = 7_u64;
        let mut next = move |below: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % below
        };
        let (mut links, mut weights) = (Vec::new(), Vec::new());
        for _ in 0..count {
            let a = next(BODIES as u64) as usize;
            links.push((a, (a + 1 + next(BODIES as u64 - 1) as usize) % BODIES));
            let size = [1.0, 1_048_576.0, 18_014_398_509_481_984.0][next(3) as usize];
            weights.push((1.0 + next(8) as f64) * size * if next(2) == 0 { 1.0 } else { -1.0 });
        }
        Self { links, weights }
    }

    /// The momenta after a step from rest, where of so many links at a time all first ends get their addends before the second
    /// ones.
    fn momenta(&self, together: usize) -> Vec<f64> {
        let mut sums = [0.0; BODIES];
        for (links, weights) in self.links.chunks(together).zip(self.weights.chunks(together)) {
            for (&(a, _), weight) in links.iter().zip(weights) {
                sums[a] -= weight;
            }
            for (&(_, b), weight) in links.iter().zip(weights) {
                sums[b] += weight;
            }
        }
        sums.iter().map(|sum| -STEP * sum).collect()
    }
}

#[test]
fn addends_arrive_in_the_order_of_the_list() {
    let mut differ = [false; 2];
    for count in 0..=67 {
        let system = Weights::example(count);
        let mut run = system.run(Phase::new(vec![0.0; BODIES], vec![0.0; BODIES]), STEP).expect("a start");
        run.advance(1).expect("finite states");
        assert_eq!(run.state().p, system.momenta(1), "{count} links");
        for (differ, together) in differ.iter_mut().zip([4, 8]) {
            *differ |= system.momenta(together) != system.momenta(1);
        }
    }
    assert_eq!(differ, [true; 2], "another order has other bits");
}

/// Bonds that tear, and angles.
#[derive(Clone)]
struct Molecule {
    bonds: Vec<(usize, usize, f64)>,
    stiffness: Vec<f64>,
    torn: f64,
    angles: Vec<(usize, usize, usize)>,
}

#[hamiltonian]
impl Molecule {
    fn kinetic(&self, p: &[[f64; 2]]) -> f64 {
        p.iter().map(|p| 0.5 * (p[0] * p[0] + p[1] * p[1])).sum()
    }
    fn potential(&self, q: &[[f64; 2]]) -> f64 {
        let mut energy = 0.0;
        for (k, &(a, b, length)) in self.bonds.iter().enumerate() {
            let distance = (q[a][0] - q[b][0]).hypot(q[a][1] - q[b][1]);
            if distance < self.torn {
                energy += 0.5 * self.stiffness[k] * (distance - length).powi(2);
            }
        }
        for &(a, b, c) in &self.angles {
            let (u, v) = ([q[a][0] - q[b][0], q[a][1] - q[b][1]], [q[c][0] - q[b][0], q[c][1] - q[b][1]]);
            energy += (u[0] * v[0] + u[1] * v[1]).atan2(u[0] * v[1] - u[1] * v[0]).cos();
        }
        energy
    }
}

impl Molecule {
    /// A ragged chain with so many bonds, one of them twice, in a list that is in no order.
    fn example(count: usize) -> Self {
        let bonds: Vec<_> = (0..count).map(|k| (k * 7 % count, k * 7 % count + 1, 1.0 + 0.01 * k as f64)).collect();
        let bonds: Vec<_> = bonds.iter().chain(bonds.first()).copied().collect();
        let stiffness = (0..bonds.len()).map(|k| 1.0 + 0.1 * k as f64).collect();
        let angles = (1..count).map(|k| (k - 1, k, k + 1)).collect();
        Self { bonds, stiffness, torn: 1.4, angles }
    }

    /// The same with another stiffness, which does not keep it from sharing lanes.
    fn of_member(mut self, member: usize) -> Self {
        self.stiffness.iter_mut().for_each(|stiffness| *stiffness += 0.05 * member as f64);
        self
    }

    /// Atoms on a zigzag.
    fn start(&self, member: usize) -> Phase<Vec<[f64; 2]>> {
        let atoms = self.angles.len() + 2;
        let at = |i: usize| [0.9 * i as f64, (0.5 + 0.02 * member as f64) * (i % 2) as f64 + 0.03 * (i * i % 7) as f64];
        Phase::new((0..atoms).map(at).collect(), vec![[0.1, -0.05]; atoms])
    }
}

/// The states of members side by side are those of the runs that they would be alone, in whatever portions.
macro_rules! members_are_alone {
    ($of:expr) => {
        for count in [1, 2, 3, 9, 22] {
            let member = |i: usize| (Molecule::example(count).of_member(i), $of(Molecule::example(count).start(i)));
            let mut together = Ensemble::new(Verlet, (0..9).map(member), 0.05).expect("starts");
            together.advance(30).expect("finite states");
            for i in 0..9 {
                let (system, start) = member(i);
                let mut alone = system.run_with(Verlet, start, 0.05).expect("a start");
                for portion in [1, 12, 17] {
                    alone.advance(portion).expect("finite states");
                }
                assert!(together.state(i) == Some(alone.state()), "{count} bonds, member {i}");
            }
        }
    };
}

#[test]
fn vectorised_terms_change_no_bit() {
    members_are_alone!(|start: Phase<Vec<[f64; 2]>>| start);
    members_are_alone!(|start: Phase<Vec<[f64; 2]>>| Phase::compensated(start.q, start.p));
}

#[test]
fn a_list_that_names_no_atom_is_an_index_out_of_bounds() {
    let mut system = Molecule::example(9);
    let start = system.start(0);
    system.angles[3].2 = 1000;
    let run = move || system.run(start, 0.05).map(|mut run| run.advance(1));
    assert!(catch_unwind(run).is_err(), "as in the text of the energy");
}
