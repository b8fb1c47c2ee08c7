//! Bodies that act on each other in pairs: however many there are, and however they are laid out, they move as the plain
//! loops over pairs say.

use integrator_core::{
    check::{gradient_error, symplectic_defect},
    prelude::*,
};

/// Stars of different masses, softened, in a trap of their own.
#[derive(Clone)]
struct Cluster {
    masses: Vec<f64>,
    stiffness: f64,
    softening: f64,
}

#[hamiltonian]
impl Cluster {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / (2.0 * self.masses[i]);
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            energy += 0.5 * self.stiffness * (q[i][0].powi(2) + q[i][1].powi(2));
            for j in 0..i {
                let mut square = self.softening;
                for d in 0..3 {
                    square += (q[i][d] - q[j][d]).powi(2);
                }
                energy -= self.masses[i] * self.masses[j] / square.sqrt();
            }
        }
        energy
    }
}

impl Cluster {
    fn of(bodies: usize) -> Self {
        Self { masses: (0..bodies).map(|i| 1.0 + (i % 7) as f64 / 3.0).collect(), stiffness: 0.3, softening: 0.01 }
    }

    /// The gradient at body `i` and, of each component, the sum of the absolute values of what is added up.
    fn gradient(&self, q: &[[f64; 3]], i: usize) -> [[f64; 2]; 3] {
        let mut sums = [q[i][0], q[i][1], 0.0].map(|x| [self.stiffness * x, (self.stiffness * x).abs()]);
        for j in (0..q.len()).filter(|j| *j != i) {
            let apart = [0, 1, 2].map(|d| q[i][d] - q[j][d]);
            let square = self.softening + apart.iter().map(|x| x * x).sum::<f64>();
            for (sum, apart) in sums.iter_mut().zip(apart) {
                let force = self.masses[i] * self.masses[j] * apart / (square * square.sqrt());
                *sum = [sum[0] + force, sum[1] + force.abs()];
            }
        }
        sums
    }
}

/// Somewhere in a box that grows with the number of bodies, and moving.
fn somewhere(bodies: usize) -> Phase<Vec<[f64; 3]>> {
    let size = (bodies as f64).cbrt();
    let at = |i: usize| [0.618, 0.414, 0.732].map(|x: f64| size * (x * (i + 1) as f64).fract());
    Phase::new((0..bodies).map(at).collect(), (0..bodies).map(|i| at(i + 1000)).collect())
}

/// The last ones are many enough to be summed in chunks, and in more of these.
fn sizes() -> impl Iterator<Item = usize> {
    (0..=20).chain([64, 100, 300, MANY, MANY + 5, 8 * MANY + 3])
}

const MANY: usize = 512;

#[test]
fn any_number_of_bodies_is_kicked_by_the_plain_sum() {
    for bodies in sizes() {
        let (system, start) = (Cluster::of(bodies), somewhere(bodies));
        let mut run = system.run_with(Euler, start.clone(), 1.0).expect("a run");
        run.advance(1).expect("finite");
        let end = run.state();
        // Of many, every so many are looked at: whole rows and what is left over, in all of their lanes.
        for i in (0..bodies).step_by(1 + bodies / 100) {
            for (d, [gradient, size]) in system.gradient(&start.q, i).into_iter().enumerate() {
                let (kicked, expected) = (end.p[i][d], start.p[i][d] - gradient);
                // A sum of n terms in another order moves by n/2 ulp of the sum of their sizes, a term by ten ulp or so.
                let limit = (bodies as f64 + 10.0) * f64::EPSILON * (size + 1.0);
                assert!((kicked - expected).abs() <= limit, "body {i} of {bodies}: {kicked} for {expected}");
                let way = kicked / system.masses[i];
                let moved = start.q[i][d] + way;
                // Roundings of 1/m, of its product with p and of the sum here and there.
                let limit = 2.0 * f64::EPSILON * (way.abs() + moved.abs());
                assert!((end.q[i][d] - moved).abs() <= limit, "body {i} of {bodies}");
            }
        }
        let energy = system.kinetic(&end.p) + system.potential(&end.q);
        assert!((run.energy() - energy).abs() <= 1e-11 * (1.0 + energy.abs()), "{bodies} bodies");
    }
}

#[test]
fn threads_change_no_bit_of_many_bodies() {
    let (system, start) = (Cluster::of(MANY + 3), somewhere(MANY + 3));
    let end = |threads| {
        let mut run = system.run_with(Euler, start.clone(), 1e-3).expect("a run").with_threads(threads);
        run.advance(1).expect("finite");
        run.state()
    };
    let alone = end(1);
    // Shares that divide among the threads, shares that do not, and more threads than shares.
    for threads in [2, 3, 100] {
        assert!(end(threads) == alone, "{threads} threads");
    }
}

/// A pack or two of members and a rest, against each member alone.
macro_rules! same {
    ($member:expr) => {{
        let mut swarm = Ensemble::new(Yoshida4, (0..19).map($member), 1e-3).expect("an ensemble");
        swarm.advance(20).expect("finite");
        for number in 0..19 {
            let (system, start) = $member(number);
            let mut alone = system.run_with(Yoshida4, start, 1e-3).expect("a run");
            alone.advance(20).expect("finite");
            assert_eq!(swarm.state(number), Some(alone.state()), "member {number}");
        }
    }};
}

/// The same system with its size in its type, for a few sizes: short rows, a whole one, more than one.
macro_rules! fixed {
    ($($module:ident: $bodies:literal,)*) => {
        $(mod $module {
            use super::Cluster;
            use integrator_core::prelude::*;

            #[derive(Clone)]
            pub(super) struct Fixed(pub(super) Cluster);

            #[hamiltonian]
            impl Fixed {
                fn kinetic(&self, p: &[[f64; 3]; $bodies]) -> f64 {
                    let mut energy = 0.0;
                    for i in 0..$bodies {
                        for d in 0..3 {
                            energy += p[i][d].powi(2) / (2.0 * self.0.masses[i]);
                        }
                    }
                    energy
                }
                fn potential(&self, q: &[[f64; 3]; $bodies]) -> f64 {
                    let mut energy = 0.0;
                    for i in 0..$bodies {
                        energy += 0.5 * self.0.stiffness * (q[i][0].powi(2) + q[i][1].powi(2));
                        for j in i + 1..$bodies {
                            let mut square = self.0.softening;
                            for d in 0..3 {
                                square += (q[i][d] - q[j][d]).powi(2);
                            }
                            energy -= self.0.masses[i] * self.0.masses[j] / square.sqrt();
                        }
                    }
                    energy
                }
            }
        })*

        #[test]
        fn a_size_in_the_type_changes_nothing_but_roundings() {
            $({
                let Phase { q, p } = somewhere($bodies);
                let system = Cluster::of($bodies);
                let start = Phase::new(q.clone().try_into().expect("an array"), p.clone().try_into().expect("an array"));
                let mut fixed = $module::Fixed(system.clone()).run_with(Yoshida4, start, 1e-3).expect("a run");
                let mut plain = system.run_with(Yoshida4, Phase::new(q, p), 1e-3).expect("a run");
                fixed.advance(100).expect("finite");
                plain.advance(100).expect("finite");
                // 700 kicks and drifts, each rounded to a few ulp of numbers below ten, in a tenth of a time unit.
                let (fixed, plain) = (fixed.state(), plain.state());
                for (a, b) in fixed.q.iter().chain(&fixed.p).flatten().zip(plain.q.iter().chain(&plain.p).flatten()) {
                    assert!((a - b).abs() < 1e-11, "{} bodies: {a} for {b}", $bodies);
                }
            })*
        }
    };
}
fixed! { three: 3, six: 6, eight: 8, nine: 9, }

/// Six bodies with parameters of their own.
fn six_bodies(number: usize) -> (six::Fixed, [[f64; 3]; 6], [[f64; 3]; 6]) {
    let Phase { q, p } = somewhere(6 + number);
    let system = Cluster { stiffness: 0.1 * number as f64, ..Cluster::of(6) };
    let some = |all: Vec<[f64; 3]>| std::array::from_fn(|i| all[i + number]);
    (six::Fixed(system), some(q), some(p))
}

#[test]
fn members_of_an_ensemble_are_identical_to_their_lone_runs() {
    same!(|number| {
        let (system, q, p) = six_bodies(number);
        (system, Phase::new(q, p))
    });
    same!(|number| {
        let (system, q, p) = six_bodies(number);
        (system, Phase::compensated(q, p))
    });
    let singles = |points: [[f64; 3]; 6]| points.map(|point| point.map(|x| x as f32));
    same!(|number| {
        let (system, q, p) = six_bodies(number);
        (system, Phase::new(singles(q), singles(p)))
    });
}

#[test]
fn members_with_bodies_in_slices_are_identical_to_their_lone_runs() {
    same!(|number| (Cluster::of(5 + number / 10), somewhere(5 + number / 10)));
    same!(|number| (Cluster::of(11), somewhere(11 + number / 19)));
}

/// Atoms on a line whose forces end at a distance, and rotors whose action is no reaction.
struct Line {
    charges: [f64; 10],
    reach: f64,
}

#[hamiltonian]
impl Line {
    fn kinetic(&self, p: &[f64; 10]) -> f64 {
        (0..10).map(|i| 0.5 * p[i] * p[i]).sum::<f64>()
    }
    fn potential(&self, q: &[f64; 10]) -> f64 {
        let mut energy = 0.0;
        for i in 1..10 {
            for j in 0..i {
                let apart = (q[i] - q[j]).abs();
                if apart < self.reach {
                    energy += self.charges[i] * self.charges[j] * (self.reach - apart).powi(4);
                }
                energy += 0.1 * (q[i] * q[j]).cos();
            }
        }
        energy
    }
}

#[test]
fn forces_that_end_and_forces_without_reaction_are_the_derivatives() {
    let line = Line { charges: std::array::from_fn(|i| 1.0 + 0.1 * i as f64), reach: 2.5 };
    let start = Phase::new(std::array::from_fn(|i| i as f64 + 0.2 * (i as f64).sin()), [0.1; 10]);
    // Rounding alone: of a few additions per component, and of a product of a few matrices.
    let gradient = gradient_error(&line, start, 0.0).expect("a finite gradient");
    assert!(gradient < 1e-13, "{gradient:e}");
    let defect = symplectic_defect(&line, Yoshida4, start, 0.01).expect("a finite map");
    assert!(defect < 1e-13, "{defect:e}");
}

#[test]
fn a_kick_by_the_gradient_of_a_force_keeps_its_order() {
    let Phase { q, p } = somewhere(6);
    let start = Phase::new(q.try_into().expect("an array"), p.try_into().expect("an array"));
    let system = six::Fixed(Cluster { softening: 0.3, ..Cluster::of(6) });
    let certificate = certify(&system, Chin4A, start, 0.01).expect("a certificate");
    assert!(certificate.symplectic_defect < 1e-12, "{certificate}");
    assert!((3.8..4.3).contains(&certificate.observed_order), "{certificate}");
}

/// A liquid in a box, whose bodies act on each other up to a distance.
#[derive(Clone)]
struct Liquid {
    side: f64,
    cutoff: f64,
}

#[hamiltonian]
impl Liquid {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().map(|p| 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let mut square: f64 = 0.0;
                for d in 0..3 {
                    let apart = q[i][d] - q[j][d];
                    square += (apart - self.side * (apart / self.side).round()).powi(2);
                }
                if square < self.cutoff.powi(2) {
                    energy += (self.cutoff.powi(2) - square).powi(3);
                }
            }
        }
        energy
    }
}

/// Enough for lists of neighbours, and a rest in the last row.
const LISTED: usize = 1027;

impl Liquid {
    fn new(cutoff: f64) -> Self {
        Self { side: 10.0, cutoff }
    }

    /// Half of the bodies are in the box, the others beside it.
    fn start(number: usize) -> Phase<Vec<[f64; 3]>> {
        let at = |i: usize| [0.618, 0.414, 0.732].map(|x: f64| 20.0 * (x * (i + 1 + LISTED * number) as f64).fract());
        let going = |i: usize| at(i + 1000).map(|x| 0.1 * x - 1.0);
        Phase::new((0..LISTED).map(at).collect(), (0..LISTED).map(going).collect())
    }
}

/// Fast enough to leave the skin of a list within a few steps.
#[test]
fn no_bit_of_a_liquid_depends_on_how_it_was_run() -> Result<(), Error> {
    let (liquid, start) = (Liquid::new(1.2), Liquid::start(0));
    let mut whole = liquid.run_with(VelocityVerlet, start.clone(), 0.04)?.with_threads(1);
    let energy = whole.energy();
    // Terms of one sign and of a few roundings each; both sums have the order of the loops.
    let stated = liquid.kinetic(&start.p) + liquid.potential(&start.q);
    assert!((energy - stated).abs() <= 1e-12 * stated, "{energy} for {stated}");
    whole.advance(6)?;
    for threads in [3, usize::MAX] {
        let mut parts = liquid.run_with(VelocityVerlet, start.clone(), 0.04)?.with_threads(threads);
        for steps in [1, 3, 2] {
            parts.advance(steps)?;
            assert_ne!(parts.state(), start);
        }
        assert_eq!(whole.state(), parts.state(), "{threads} threads");
    }

    let members = [(Liquid::new(1.2), start), (Liquid::new(0.9), Liquid::start(1))];
    let mut both = Ensemble::new(VelocityVerlet, members.clone(), 0.04)?;
    both.advance(2)?;
    for (number, (liquid, start)) in members.into_iter().enumerate() {
        let mut alone = liquid.run_with(VelocityVerlet, start, 0.04)?;
        alone.advance(2)?;
        assert_eq!(both.state(number), Some(alone.state()), "member {number}");
    }
    Ok(())
}
