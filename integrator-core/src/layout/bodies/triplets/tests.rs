//! The gradient of triplets has the same bits with lists and without, in vectors of any width, and for members of an ensemble.

use super::{KickByTriplets, Neighbours, Sum};
use crate::{
    hamiltonian,
    layout::bodies::load_store::WIDTH,
    scalar::{
        dual::Dual,
        fma::{Avx512, Fma, Fused},
        instruction_set::InstructionSet,
        real::Real,
        simd::lanes::Lanes,
    },
    state::phase::Phase,
    system::{System, motion::Motion},
};
use alloc::{vec, vec::Vec};

const BODIES: usize = 509;

/// Bodies with angles in a box that is open along an axis.
struct Network {
    weights: Vec<f64>,
    side: f64,
    cutoff: f64,
}

#[hamiltonian]
impl Network {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let image = |x: f64| x - self.side * (x / self.side).round();
        let leg = |i: usize, j: usize| [image(q[j][0] - q[i][0]), image(q[j][1] - q[i][1]), q[j][2] - q[i][2]];
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..q.len() {
                let u = leg(i, j);
                let a = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
                if j != i && a < self.cutoff {
                    for k in j + 1..q.len() {
                        let w = leg(i, k);
                        let b = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
                        if k != i && b < self.cutoff {
                            let between = u[0] * w[0] + u[1] * w[1] + u[2] * w[2];
                            v += self.weights[i] * between * (self.cutoff - a).powi(2) * (self.cutoff - b).powi(2);
                        }
                    }
                }
            }
        }
        v
    }
}

impl Network {
    fn new(cutoff: f64) -> Self {
        Self { weights: (0..BODIES).map(|i| 1.0 + (i % 5) as f64 / 4.0).collect(), side: 8.0, cutoff }
    }

    /// Bodies in the box, and some outside of it whose images are inside.
    fn start(seed: usize) -> Phase<Vec<[f64; 3]>> {
        let at = |i: usize, d: usize| 8.0 * ((i * (7 + 4 * d) + seed) as f64 * 0.618_033_988_75).fract();
        let far = |i: usize| if i.is_multiple_of(50) { 16.0 } else { 0.0 };
        let q = (0..BODIES).map(|i| [at(i, 0) + far(i), at(i, 1), at(i * i, 2)]).collect();
        Phase::new(q, vec![[0.0; 3]; BODIES])
    }
}

type Rows<R> = <Network as System>::Motion<R, f64>;

fn motion<R: Real>(members: &[(&Network, &Phase<Vec<[f64; 3]>>)]) -> Rows<R> {
    let constants: Vec<_> = members.iter().map(|(network, _)| network.parameters(BODIES)).collect();
    let constants: Vec<_> = constants.iter().cycle().take(R::LANES).collect();
    let states: Vec<_> = members.iter().cycle().take(R::LANES).map(|(_, state)| *state).collect();
    Motion::<Vec<[f64; 3]>, _>::load(&constants, &states)
}

/// The bits of momenta, by bodies, in a lane of an `R`.
fn bits<R: Real>(p: &[[R::Row<WIDTH>; 3]], lane: usize) -> Vec<[u64; 3]> {
    let of_body = |body: usize| p[body / WIDTH].map(|row| row.lane(body % WIDTH * R::LANES + lane).to_bits());
    (0..BODIES).map(of_body).collect()
}

/// The bits of the gradient as a kick has it, with lists.
fn listed<R: Real>(motion: &Rows<R>, lane: usize) -> Vec<[u64; 3]> {
    let mut force = motion.at_rest();
    Network::kick::<R, f64>(&mut force, -1.0, 0.0);
    bits::<R>(&force.p, lane)
}

/// The same without lists.
fn unlisted<R: Real>(motion: &Rows<R>, lane: usize) -> Vec<[u64; 3]> {
    let mut p = motion.at_rest().p;
    let sum = Sum::<Network, R, _, 3, 2> {
        q: &motion.q,
        constants: motion.constants(),
        bodies: BODIES,
        parameters: &motion.parameters,
        time: 0.0,
        threads: 1,
    };
    let neighbours = &mut Neighbours::<R, 3>::none();
    R::enter(KickByTriplets { sum, neighbours, cutoffs: None, factor: Real::of(1.0), p: &mut p });
    bits::<R>(&p, lane)
}

#[test]
fn lists_change_no_bit_in_vectors_of_any_width() {
    fn holds<R: Real>(set: InstructionSet) {
        if !InstructionSet::available().contains(&set) {
            return;
        }
        let (network, start) = (Network::new(1.7), Network::start(3));
        let motion = motion::<R>(&[(&network, &start)]);
        for lane in [0, R::LANES - 1] {
            let (listed, unlisted) = (listed::<R>(&motion, lane), unlisted::<R>(&motion, lane));
            assert!(listed == unlisted, "lane {lane} of {}", core::any::type_name::<R>());
            assert!(listed.iter().flatten().any(|bits| f64::from_bits(*bits) != 0.0) || lane > 0);
        }
    }
    holds::<f64>(InstructionSet::Baseline);
    holds::<f32>(InstructionSet::Baseline);
    holds::<Fused<f64, Fma>>(InstructionSet::Fused);
    holds::<Fused<f64, Avx512>>(InstructionSet::Avx512);
    holds::<Dual>(InstructionSet::Baseline);
    holds::<Lanes<f64, 2>>(InstructionSet::Baseline);
}

/// Two instruction sets with the same operations, one of them in wider vectors.
#[test]
fn wider_vectors_change_no_bit() {
    let (network, start) = (Network::new(1.7), Network::start(4));
    let members = [(&network, &start)];
    let scalar = listed::<Lanes<f64, 1>>(&motion(&members), 0);
    assert!(listed::<f64>(&motion(&members), 0) == scalar);
    if InstructionSet::available().contains(&InstructionSet::Avx512) {
        let narrow = listed::<Fused<f64, Fma>>(&motion(&members), 0);
        assert!(listed::<Fused<f64, Avx512>>(&motion(&members), 0) == narrow);
    }
}

#[test]
fn members_have_the_bits_of_each_alone() {
    // Another place, and another cutoff.
    let members = [Network::new(1.7), Network::new(0.9), Network::new(5.0)];
    let starts = [1, 2, 3].map(Network::start);
    for pair in [[0, 1], [2, 1]] {
        let both = pair.map(|number| (&members[number], &starts[number]));
        let together = motion::<Lanes<f64, 2>>(&both);
        for lane in [0, 1] {
            let alone = motion::<f64>(&both[lane..=lane]);
            assert!(listed(&together, lane) == listed(&alone, 0), "members {pair:?}");
        }
    }
}
