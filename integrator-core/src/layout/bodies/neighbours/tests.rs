//! Lists contain every interacting pair, and results do not depend on when they were built.

use super::{Arc, Cutoffs, Neighbours, Sum, cells::Cells, listed::Listed, lists::Lists};
use crate::{
    hamiltonian,
    layout::bodies::{load_store::WIDTH, pair_sums::ManyBody},
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

/// Numbers between zero and one that look like chance.
fn somewhere(seed: u64) -> impl FnMut() -> f64 {
    let mut state = 0x9e37_79b9_7f4a_7c15 ^ seed;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Soft bodies of different masses that repel each other in a box, with gravity along an axis without an end.
#[derive(Clone)]
struct Soft {
    masses: Vec<f64>,
    sides: [f64; 2],
    cutoff: f64,
}

#[hamiltonian]
impl Soft {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            for d in 0..3 {
                energy += p[i][d].powi(2) / (2.0 * self.masses[i]);
            }
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            energy += self.masses[i] * q[i][2];
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                let x = x - self.sides[0] * (x / self.sides[0]).round();
                let y = y - self.sides[1] * (y / self.sides[1]).round_ties_even();
                let square = x * x + y * y + z * z;
                if square < self.cutoff.powi(2) {
                    let overlap = square.sqrt() - self.cutoff;
                    energy += self.masses[i] * self.masses[j] * overlap * overlap;
                }
            }
        }
        energy
    }
}

const BODIES: usize = 1027;

impl Soft {
    fn new(cutoff: f64) -> Self {
        Self { masses: (0..BODIES).map(|i| 1.0 + (i % 5) as f64 / 4.0).collect(), sides: [9.0, 11.0], cutoff }
    }

    /// Bodies in the box, and some outside of it whose images are inside.
    fn start(&self, seed: u64) -> Phase<Vec<[f64; 3]>> {
        let mut next = somewhere(seed);
        let mut point = || [20.0 * next() - 5.0, 11.0 * next(), 10.0 * next() - 3.0];
        let q = (0..BODIES).map(|_| point()).collect();
        let p = (0..BODIES).map(|_| point().map(|x| x / 10.0)).collect();
        Phase::new(q, p)
    }
}

/// The motions of members in the lanes of an `R`; directions of derivatives are the state itself.
type Rows<R> = <Soft as System>::Motion<R, f64>;

fn motion<R: Real>(members: &[(&Soft, &Phase<Vec<[f64; 3]>>)]) -> Rows<R> {
    let constants: Vec<_> = members.iter().map(|(soft, _)| soft.parameters(BODIES)).collect();
    let constants: Vec<_> = constants.iter().cycle().take(R::LANES).collect();
    let states: Vec<_> = members.iter().cycle().take(R::LANES).map(|(_, state)| *state).collect();
    Motion::<Vec<[f64; 3]>, _>::load(&constants, &states)
}

/// The bits of the gradient as a kick has it, by bodies, in a lane of an `R`.
fn gradient<R: Real>(motion: &Rows<R>, lane: usize) -> Vec<[u64; 3]> {
    let mut force = motion.at_rest();
    Soft::kick::<R, f64>(&mut force, -1.0, 0.0);
    let of_body = |body: usize| force.p[body / WIDTH].map(|row| row.lane(body % WIDTH * R::LANES + lane).to_bits());
    (0..BODIES).map(of_body).collect()
}

/// Tests that the gradient of sampled bodies is bitwise identical to one sum over all others in the order of their
/// numbers.
fn compare_bits<R: Real>(motion: &Rows<R>, lane: usize) {
    let body = |body: usize| {
        let of_lane = |row: &R::Row<WIDTH>| R::state(&|lane| row.lane(body % WIDTH * R::LANES + lane));
        (motion.q[body / WIDTH].each_ref().map(of_lane), motion.constants()[body / WIDTH].map(|row| of_lane(&row)))
    };
    let (all, gradient): (Vec<_>, _) = ((0..BODIES).map(body).collect(), gradient(motion, lane));
    for i in (0..BODIES).step_by(9) {
        let (q, constants) = all[i];
        let mut sum = [R::of(0.0); 3];
        for (j, (other, of_other)) in all.iter().enumerate() {
            if i != j {
                let force = Soft::pair::<R, R>(&motion.parameters, q, *other, constants, *of_other, 0.0);
                for (sum, force) in sum.iter_mut().zip(force) {
                    *sum += force;
                }
            }
        }
        let own = Soft::one_body::<R, R>(&motion.parameters, q, constants, 0.0).expect("gravity");
        let expected = [0, 1, 2].map(|d| (own[d] + sum[d]).lane(lane).to_bits());
        assert!(gradient[i] == expected, "body {i}, lane {lane} of {}", core::any::type_name::<R>());
    }
}

/// Units of length up to those that `docs/reliability.md` names, whose squares are doubles, among them some whose squares
/// are beyond singles.
const DECADES: [i32; 8] = [-100, -60, -22, -19, 19, 22, 60, 100];

/// All pairs within a distance, by brute force and as lists have them: every pair, hardly any that is farther away, none
/// twice, in order. Lengths are in this unit.
fn compare<const D: usize>(bodies: usize, sides: [f64; D], radius: f64, threads: usize, unit: f64) {
    let mut next = somewhere(bodies as u64 + D as u64);
    let (sides, radius) = (sides.map(|side| side * unit), radius * unit);
    let extent = sides.map(|side| if side > 0.0 { side } else { 7.0 * unit });
    let points: Vec<[f64; D]> = (0..bodies).map(|_| extent.map(|extent| extent * (3.0 * next() - 1.0))).collect();
    let lists = Lists::new(bodies, &[Cells::new(points.clone(), sides, radius)], threads, None);
    let square = |a: [f64; D], b: [f64; D]| -> f64 {
        let apart = |d: usize| {
            let x = a[d] - b[d];
            if sides[d] > 0.0 { x - sides[d] * (x / sides[d]).round() } else { x }
        };
        (0..D).map(|d| apart(d).powi(2)).sum()
    };
    let mut body_of = vec![0; bodies];
    for (body, slot) in lists.slot_of.iter().enumerate() {
        body_of[*slot as usize] = body;
    }
    let portions = lists.portions.as_ref().expect("short lists");
    let mut listed = 0;
    for portion in portions {
        for (row, head) in portion.rows.clone().zip(&portion.heads) {
            for lane in 0..WIDTH.min(bodies - row * WIDTH) {
                let body = body_of[row * WIDTH + lane];
                let step = |step: usize| portion.steps[head.first + step][lane];
                let near = (0..head.counts[lane] as usize).map(step);
                let near: Vec<usize> = near.map(|slot| body_of[slot as usize]).collect();
                let within = |radius: f64| {
                    let near = |other: &usize| *other != body && square(points[body], points[*other]) < radius * radius;
                    (0..bodies).filter(near).collect::<Vec<_>>()
                };
                let (least, most) = (within(radius), within(radius * 1.0001));
                assert!(near.is_sorted_by(|a, b| a < b), "body {body} of {bodies} in {sides:?}, radius {radius}");
                assert!(
                    least.iter().all(|other| near.contains(other)),
                    "body {body} of {bodies} in {sides:?}: {near:?}"
                );
                assert!(
                    near.iter().all(|other| most.contains(other)),
                    "body {body} of {bodies} in {sides:?}: {near:?}"
                );
                assert_eq!(head.before[lane] as usize, near.iter().filter(|other| **other < body).count());
                listed += near.len();
            }
        }
    }
    assert!(listed > 0, "{bodies} bodies in {sides:?}, radius {radius}");
}

#[test]
fn lists_have_every_pair_within_the_radius() {
    for threads in [1, 3] {
        compare(400, [0.0], 0.05, threads, 1.0);
        compare(400, [9.0], 0.05, threads, 1.0);
        compare(600, [0.0, 8.0], 0.7, threads, 1.0);
        compare(600, [0.0; 3], 2.0, threads, 1.0);
        compare(700, [6.0, 7.5, 9.0], 1.4, threads, 1.0);
        // Three cells along an axis, two of which are on both sides; fewer, so that it is not divided.
        compare(600, [6.1, 5.9, 40.0], 2.0, threads, 1.0);
        compare(600, [3.0, 0.0, 3.1], 1.5, threads, 1.0);
        compare(500, [5.0, 0.0, 6.0, 4.0], 1.6, threads, 1.0);
        // So few bodies in a cell that a whole row of cells is looked at together, and its ends are beside it, too.
        compare(80, [6.1, 8.0, 8.2], 2.0, threads, 1.0);
        compare(80, [0.0, 8.0, 8.2], 2.0, threads, 1.0);
    }
}

#[test]
fn lists_have_every_pair_in_any_unit_of_length() {
    for decade in DECADES {
        let unit = 10.0_f64.powi(decade);
        compare(400, [0.0; 3], 2.0, 1, unit);
        compare(400, [6.0, 0.0, 9.0], 1.4, 1, unit);
        compare(400, [3.0, 0.0, 3.1], 1.5, 1, unit);
    }
}

#[test]
fn sums_have_the_bits_of_the_order_of_numbers() {
    let soft = Soft::new(2.1);
    fn holds<R: Real>(soft: &Soft, set: InstructionSet) {
        if InstructionSet::available().contains(&set) {
            let start = soft.start(1);
            let motion = motion::<R>(&[(soft, &start)]);
            // Derivatives are in the last lane.
            for lane in (0..R::LANES).step_by(R::LANES.max(2) - 1) {
                compare_bits(&motion, lane);
            }
        }
    }
    holds::<f64>(&soft, InstructionSet::Baseline);
    holds::<f32>(&soft, InstructionSet::Baseline);
    holds::<Fused<f64, Fma>>(&soft, InstructionSet::Fused);
    holds::<Fused<f32, Fma>>(&soft, InstructionSet::Fused);
    holds::<Fused<f64, Avx512>>(&soft, InstructionSet::Avx512);
    holds::<Dual>(&soft, InstructionSet::Baseline);
    holds::<Dual<Fused<f64, Avx512>, 2>>(&soft, InstructionSet::Avx512);
    holds::<Fused<f32, Avx512>>(&soft, InstructionSet::Avx512);
    // Everyone is everyone's neighbour, and no list is made.
    let wide = Soft { sides: [90.0, 110.0], ..Soft::new(40.0) };
    let start = wide.start(2);
    let motion = motion::<f64>(&[(&wide, &start)]);
    compare_bits(&motion, 0);
    let cutoffs = Cutoffs::of::<Soft, f64, 3>(&motion.parameters, 0.0);
    assert!(Listed::new::<f64, _>(&motion.q, BODIES, &cutoffs, 0.1, 1, None).lists.portions.is_none());
}

#[test]
fn sums_have_these_bits_in_any_unit_of_length() {
    for decade in DECADES {
        let unit = 10.0_f64.powi(decade);
        let soft = Soft { sides: [9.0, 11.0].map(|side| side * unit), ..Soft::new(2.1 * unit) };
        let scaled = |seed| {
            let mut start = Soft::new(2.1).start(seed);
            start.q.as_flattened_mut().iter_mut().for_each(|x| *x *= unit);
            start
        };
        let [one, other] = [1, 2].map(scaled);
        compare_bits(&motion::<f64>(&[(&soft, &one)]), 0);
        // Members share lists, which are made without single precision.
        compare_bits(&motion::<Lanes<f64, 2>>(&[(&soft, &one), (&soft, &other)]), 1);
    }
}

#[test]
fn members_have_the_bits_of_each_alone() {
    // Another place, another cutoff, and one whose cutoff covers everything, with its pairs in tiles.
    let members = [Soft::new(2.1), Soft::new(1.3), Soft::new(f64::INFINITY)];
    let starts = [1, 2, 3].map(|seed| members[0].start(seed));
    for pair in [[0, 1], [2, 0]] {
        let both = pair.map(|number| (&members[number], &starts[number]));
        let together = motion::<Lanes<f64, 2>>(&both);
        for lane in [0, 1] {
            let alone = motion::<f64>(&both[lane..=lane]);
            assert!(gradient(&together, lane) == gradient(&alone, 0), "members {pair:?}");
        }
    }
}

#[test]
fn no_bit_depends_on_when_lists_were_made() {
    let soft = Soft::new(2.1);
    let mut motion = motion::<f64>(&[(&soft, &soft.start(4))]);
    let cutoffs = Cutoffs::of::<Soft, f64, 3>(&motion.parameters, 0.0);
    let mut neighbours = Neighbours::<f64, 3>::none();
    let mut made = 0;
    for step in 0..16 {
        Soft::drift::<f64, f64>(&mut motion, 0.05, 0.0);
        let mut kept = motion.at_rest().p;
        let sum = Sum::<Soft, _, _, 3, 3> {
            q: &motion.q,
            constants: motion.constants(),
            bodies: BODIES,
            parameters: &motion.parameters,
            time: 0.0,
            threads: 1 + step % 3,
        };
        neighbours.kick(sum, &cutoffs, None, Real::of(1.0), &mut kept);
        made += usize::from(neighbours.sums == 1);
        // A motion that has just been loaded makes lists of its own.
        let bits: Vec<_> =
            (0..BODIES).map(|body| kept[body / WIDTH].map(|row| row.lane(body % WIDTH).to_bits())).collect();
        assert!(bits == gradient(&motion, 0), "step {step}");
    }
    assert!((2..10).contains(&made), "lists were made {made} times");
}

#[test]
fn lists_that_are_kept_for_too_long_are_wrong() {
    let soft = Soft::new(2.1);
    let mut motion = motion::<f64>(&[(&soft, &soft.start(5))]);
    let cutoffs = Cutoffs::of::<Soft, f64, 3>(&motion.parameters, 0.0);
    let mut listed = Listed::new::<f64, _>(&motion.q, BODIES, &cutoffs, 0.1, 1, None);
    Soft::drift::<f64, f64>(&mut motion, 0.5, 0.0);
    assert!(!listed.holds(&motion.q));
    listed.slack = f64::INFINITY;
    let mut kept = motion.at_rest().p;
    let mut neighbours = Neighbours { listed: Some(Arc::new(listed)), ..Neighbours::<f64, 3>::none() };
    let sum = Sum::<Soft, _, _, 3, 3> {
        q: &motion.q,
        constants: motion.constants(),
        bodies: BODIES,
        parameters: &motion.parameters,
        time: 0.0,
        threads: 1,
    };
    neighbours.kick(sum, &cutoffs, None, Real::of(1.0), &mut kept);
    let bits: Vec<_> = (0..BODIES).map(|body| kept[body / WIDTH].map(|row| row.lane(body % WIDTH).to_bits())).collect();
    assert!(bits != gradient(&motion, 0));
}

#[test]
fn lists_that_are_borrowed_change_no_bit() {
    let soft = Soft::new(2.1);
    let mut first = motion::<f64>(&[(&soft, &soft.start(8))]);
    Soft::kick::<f64, f64>(&mut first, 0.01, 0.0);
    let mut copy = first.clone();
    assert!(copy.neighbours.listed.is_none() && copy.neighbours.last().is_some(), "one list for both");
    let bits = gradient(&first, 0);
    assert!(gradient(&copy, 0) == bits);
    // What was borrowed and handed back stays where it is.
    first.neighbours.share(&copy.neighbours);
    assert!(first.neighbours.listed.is_some());
    // Who lent it needs it no more, and neither waits for the other.
    Soft::drift::<f64, f64>(&mut first, 1.0, 0.0);
    Soft::kick::<f64, f64>(&mut first, 0.01, 0.0);
    assert!(copy.neighbours.last().is_none());
    Soft::kick::<f64, f64>(&mut copy, 0.0, 0.0);
    assert!(copy.neighbours.listed.is_some() && gradient(&copy, 0) == bits);
}

#[test]
fn lists_that_are_found_change_no_bit() {
    let soft = Soft::new(2.1);
    let mut first = motion::<f64>(&[(&soft, &soft.start(7))]);
    assert!(Motion::<Vec<[f64; 3]>, _>::found(&first).is_none(), "nobody was asked who is near");
    Soft::kick::<f64, f64>(&mut first, 0.01, 0.0);
    let found = Motion::<Vec<[f64; 3]>, _>::found(&first).expect("lists");
    Soft::drift::<f64, f64>(&mut first, 0.01, 0.0);
    let with = |rows: &Rows<f64>| {
        let mut rows = rows.clone();
        rows.neighbours = Neighbours::none();
        Motion::<Vec<[f64; 3]>, _>::use_found(&mut rows, &found);
        rows
    };
    let (with, without) = (with(&first), first.at_rest());
    assert!(with.neighbours.listed.as_ref().is_some_and(|listed| listed.holds(&with.q)), "a drift within the skin");
    assert!(gradient(&with, 0) == gradient(&without, 0));
    assert!(with.potential::<Soft>(0.0) == without.potential::<Soft>(0.0));
    // Lists for doubles are too short for singles, whose distances are rounded more.
    let mut singles = Neighbours::<f32, 3>::none();
    singles.use_found(&found, BODIES);
    assert!(singles.listed.is_none());
    let mut fewer = Neighbours::<f64, 3>::none();
    fewer.use_found(&found, BODIES - 1);
    assert!(fewer.listed.is_none());
}

#[test]
fn energies_are_those_of_all_pairs() {
    for soft in [Soft::new(2.1), Soft::new(0.3)] {
        let start = soft.start(6);
        let motion = motion::<f64>(&[(&soft, &start)]);
        let listed = <Soft as System>::potential::<f64, f64>(&motion, 0.0);
        let stated = soft.potential(&start.q);
        // So many terms of one sign and of a few roundings each, and those of gravity.
        let limit = 1e3 * BODIES as f64 * f64::EPSILON * (1.0 + stated.abs());
        assert!((listed - stated).abs() <= limit, "{listed} for {stated}");
    }
}
