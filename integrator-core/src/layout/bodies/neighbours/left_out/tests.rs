//! Sums over lists that leave pairs out are those of the pairs that remain.

use crate::{
    hamiltonian,
    layout::bodies::{load_store::WIDTH, pair_sums::ManyBody},
    scalar::{real::Real, simd::lanes::Lanes},
    state::phase::Phase,
    system::{System, motion::Motion},
};
use alloc::{vec, vec::Vec};

/// Soft bodies that do not act on those of their own molecule.
struct Molecules {
    of: Vec<usize>,
    side: f64,
    /// The size of the region where bodies start.
    extent: f64,
}

#[hamiltonian]
impl Molecules {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let image = |x: f64| x - self.side * (x / self.side).round();
                let square = (0..3).map(|d| image(q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                if self.of[i] != self.of[j] && square < 4.0 {
                    energy += (4.0 - square).powi(2);
                }
            }
        }
        energy
    }
}

const BODIES: usize = 500;

impl Molecules {
    fn of_size(size: usize, side: f64, extent: f64) -> Self {
        Self { of: (0..BODIES).map(|i| i * 7 % BODIES / size).collect(), side, extent }
    }

    fn start(&self) -> Phase<Vec<[f64; 3]>> {
        let point = |i: usize| [0.61, 0.37, 0.83].map(|x| (i as f64 * x).fract() * self.extent);
        Phase::new((0..BODIES).map(point).collect(), vec![[0.0; 3]; BODIES])
    }
}

type Rows<R> = <Molecules as System>::Motion<R, f64>;

fn motion<R: Real>(members: &[&Molecules]) -> Rows<R> {
    let constants: Vec<_> = members.iter().map(|member| member.parameters(BODIES)).collect();
    let (constants, start) = (constants.iter().collect::<Vec<_>>(), members[0].start());
    Motion::<Vec<[f64; 3]>, _>::load(&constants, &vec![&start; members.len()])
}

/// The gradient of a member as a kick has it.
fn gradient<R: Real>(motion: &Rows<R>, lane: usize) -> Vec<[u64; 3]> {
    let mut force = motion.at_rest();
    Molecules::kick::<R, f64>(&mut force, -1.0, 0.0);
    let of_body = |body: usize| force.p[body / WIDTH].map(|row| row.lane(body % WIDTH * R::LANES + lane).to_bits());
    (0..BODIES).map(of_body).collect()
}

/// The same by the pairs of the user's own condition, in the order of the numbers of bodies.
fn expected(system: &Molecules) -> Vec<[u64; 3]> {
    let motion = motion::<f64>(&[system]);
    let body = |body: usize| {
        let of_lane = |row: &<f64 as Real>::Row<WIDTH>| row.lane(body % WIDTH);
        (motion.q[body / WIDTH].each_ref().map(of_lane), motion.constants()[body / WIDTH].each_ref().map(of_lane))
    };
    let all: Vec<_> = (0..BODIES).map(body).collect();
    let of_body = |i: usize| {
        let mut sum = [0.0; 3];
        for j in (0..BODIES).filter(|j| system.of[i] != system.of[*j]) {
            let ((q, own), (other, of_other)) = (all[i], all[j]);
            let force = Molecules::pair::<f64, f64>(&motion.parameters, q, other, own, of_other, 0.0);
            for (sum, force) in sum.iter_mut().zip(force) {
                *sum += force;
            }
        }
        sum.map(f64::to_bits)
    };
    (0..BODIES).map(of_body).collect()
}

#[test]
fn lists_leave_out_the_pairs_that_never_act() {
    let system = Molecules::of_size(25, 8.0, 8.0);
    assert_eq!(<Molecules as ManyBody<3, 1>>::LEAVES_OUT, Some(1), "only lists read the molecules");
    let mut motion = motion::<f64>(&[&system]);
    assert!(gradient(&motion, 0) == expected(&system));
    // What was listed is less than what is within the cutoff.
    Molecules::kick::<f64, f64>(&mut motion, 0.0, 0.0);
    let lists = motion.neighbours.last().expect("lists").lists.clone();
    let listed = |lists: &super::Lists| {
        let heads = lists.portions.iter().flatten().flat_map(|portion| &portion.heads);
        heads.flat_map(|head| head.counts).sum::<u32>()
    };
    let other = self::motion::<f64>(&[&Molecules::of_size(1, 8.0, 8.0)]);
    let mut all = other.clone();
    Molecules::kick::<f64, f64>(&mut all, 0.0, 0.0);
    let all = all.neighbours.last().expect("lists").lists.clone();
    assert!(listed(&lists) < listed(&all), "{} of {}", listed(&lists), listed(&all));
    let energies = [motion.potential::<Molecules>(0.0), system.potential(&system.start().q)];
    assert!((energies[0] - energies[1]).abs() < 1e-12 * energies[1], "{energies:?}");
    assert!(energies[1] < other.potential::<Molecules>(0.0), "what is left out has an energy");
}

#[test]
fn pairs_without_lists_are_left_out_too() {
    // Lists would be as long as all pairs, or the cutoff covers the box.
    for (side, extent) in [(1e6, 2.0), (3.0, 8.0)] {
        let system = Molecules::of_size(25, side, extent);
        let motion = motion::<f64>(&[&system]);
        let energies = [motion.potential::<Molecules>(0.0), system.potential(&system.start().q)];
        assert!((energies[0] - energies[1]).abs() < 1e-12 * energies[1], "{side}: {energies:?}");
        let rounded = |bits: u64| f64::from_bits(bits);
        for (own, other) in gradient(&motion, 0).into_iter().zip(expected(&system)) {
            for (own, other) in own.map(rounded).into_iter().zip(other.map(rounded)) {
                assert!((own - other).abs() < 1e-9, "{side}: {own} for {other}");
            }
        }
    }
}

#[test]
fn members_leave_out_their_own_pairs() {
    let members = [Molecules::of_size(25, 8.0, 8.0), Molecules::of_size(10, 8.0, 8.0)];
    let together = motion::<Lanes<f64, 2>>(&[&members[0], &members[1]]);
    for (lane, member) in members.iter().enumerate() {
        assert!(gradient(&together, lane) == expected(member), "member {lane}");
    }
}
