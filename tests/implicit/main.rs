//! Implicit methods on systems of every kind of split, and on those that have none.

mod geodesic;
mod rated;

use integrator_core::{
    Compensated, Coords, Ensemble, Error, GaussLegendre, GaussLegendre4, GaussLegendre6, Hamiltonian, ImplicitMidpoint,
    InLanes, Method, Phase, Run, Unsolved,
    check::{certify, observed_order, reversibility, symplectic_defect},
    hamiltonian,
};

/// Two rods that hang one from the other: the mass matrix depends on the angle between them.
#[derive(Clone)]
struct DoublePendulum;

#[hamiltonian(split = none, compose = GaussLegendre4)]
impl DoublePendulum {
    fn hamiltonian(&self, [a, b]: [f64; 2], [pa, pb]: [f64; 2]) -> f64 {
        let (sine, cosine) = (a - b).sin_cos();
        (pa * pa + 2.0 * pb * pb - 2.0 * pa * pb * cosine) / (2.0 * (1.0 + sine * sine)) - 2.0 * a.cos() - b.cos()
    }
}

const HUNG: Phase<[f64; 2]> = Phase { q: [1.0, -0.5], p: [0.2, 0.3] };

/// The same H in one split or another.
macro_rules! henon_heiles {
    ($name:ident, $($split:tt)*) => {
        #[derive(Clone)]
        struct $name;

        #[hamiltonian($($split)*)]
        impl $name {
            fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
                0.5 * (px * px + py * py + x * x + y * y) + x * x * y - y.powi(3) / 3.0
            }
        }
    };
}
henon_heiles!(InParts, split = quadratic + rest);
henon_heiles!(Separate,);

/// Bodies that attract each other, in Jacobi coordinates or not.
macro_rules! bodies {
    ($name:ident, $($split:tt)*) => {
        struct $name {
            mass: [f64; 3],
        }

        #[hamiltonian($($split)*)]
        impl $name {
            fn kinetic(&self, p: [[f64; 2]; 3]) -> f64 {
                (0..3).map(|i| (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * self.mass[i])).sum()
            }
            fn potential(&self, q: [[f64; 2]; 3]) -> f64 {
                let mut energy = 0.0;
                for i in 0..3 {
                    for j in 0..i {
                        let [x, y] = [0, 1].map(|d| q[i][d] - q[j][d]);
                        energy -= self.mass[i] * self.mass[j] / (x.powi(2) + y.powi(2)).sqrt();
                    }
                }
                energy
            }
        }
    };
}
bodies!(Planets, coordinates = jacobi(self.mass), split = kepler + interaction);
bodies!(Inertial,);

fn end<H: Hamiltonian, X: Method<H>>(system: &H, method: X, start: &Phase<H::Coords>, h: f64, steps: u64) -> Vec<f64> {
    let mut run = system.run_with::<f64, X>(method, start.clone(), h).expect("a start");
    run.advance(steps).expect("an end");
    let Phase { q, p }: Phase<H::Coords> = run.state();
    [q.flat(), p.flat()].concat()
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn the_result_does_not_depend_on_the_split() {
    let start = Phase::new([0.1, 0.2], [0.3, -0.1]);
    for steps in [1, 100] {
        let [one, other] =
            [end(&InParts, GaussLegendre6, &start, 0.2, steps), end(&Separate, GaussLegendre6, &start, 0.2, steps)];
        // The same equations, rounded in another order: some ε in each step, which a regular motion adds up.
        assert!(apart(&one, &other) <= 16.0 * steps as f64 * f64::EPSILON, "{one:?}, {other:?}");
    }
    let mass = [1.0, 1e-3, 2e-3];
    let start = Phase::new([[0.0, 0.0], [1.0, 0.0], [0.0, 2.0]], [[0.0, 0.0], [0.0, 1e-3], [-1.4e-3, 0.0]]);
    let [one, other] = [
        end(&Planets { mass }, GaussLegendre6, &start, 0.05, 100),
        end(&Inertial { mass }, GaussLegendre6, &start, 0.05, 100),
    ];
    assert!(apart(&one, &other) <= 16.0 * 100.0 * 2.0 * f64::EPSILON, "{one:?}, {other:?}");
    // None of it is a motion that stands still.
    assert!(apart(&one, &[start.q.flat(), start.p.flat()].concat()) > 0.1);
}

#[test]
fn h_in_one_piece_is_integrated_and_certified() {
    certify(&DoublePendulum, ImplicitMidpoint, HUNG, 0.02).expect("order, symmetry, symplecticity, energy, field");
    certify(&DoublePendulum, GaussLegendre4, HUNG, 0.05).expect("the same");
    for (order, found) in [
        (4.0, observed_order(&DoublePendulum, GaussLegendre4, HUNG, 0.1)),
        (6.0, observed_order(&DoublePendulum, GaussLegendre6, HUNG, 0.2)),
    ] {
        let slope = found.expect("an order").slope;
        assert!((slope - order).abs() < 0.3, "{slope}, not {order}");
    }
    // Quadratic in nothing, so that the energy is conserved to the order and no further: until the step is short enough.
    let mut run = DoublePendulum.run_with(GaussLegendre6, HUNG, 0.01).expect("a start");
    let energy = run.energy();
    run.advance(20_000).expect("an end");
    // 20,000 roundings of ε of numbers up to 4 are a walk, not a sum: 4 √20000 ε = 1.3e-13.
    assert!((run.energy() - energy).abs() < 1.3e-13, "{:e}", run.energy() - energy);
    let back = reversibility(&DoublePendulum, GaussLegendre4, HUNG, 0.05, 500).expect("a distance");
    assert!(back < 1e-10, "{back:e}");
    let defect = symplectic_defect(&DoublePendulum, GaussLegendre4, HUNG, 0.2).expect("a defect");
    assert!(defect < 1e-13, "{defect:e}");
}

#[test]
fn members_have_the_bits_of_their_runs() {
    let starts: Vec<_> = (0..9).map(|k| Phase::new([0.3 * f64::from(k), -0.5], [0.2, 0.3])).collect();
    let members = starts.iter().map(|start| (DoublePendulum, *start));
    let mut ensemble = Ensemble::new(GaussLegendre4, members, 0.05).expect("starts");
    ensemble.advance(50).expect("an end");
    for (member, start) in starts.iter().enumerate() {
        let mut run = DoublePendulum.run(*start, 0.05).expect("a start");
        run.advance(50).expect("an end");
        assert_eq!(ensemble.state(member), Some(run.state()), "{member}");
    }
}

/// A run has its stages in vector lanes, and members of an ensemble have these themselves.
fn stages_have_the_bits_of_members<H, X>(system: &H, method: X, starts: &[Phase<[f64; 2]>], h: f64)
where
    H: Hamiltonian<Coords = [f64; 2]> + Clone + Send + Sync + 'static,
    X: Method<H> + InLanes<H>,
{
    let members = starts.iter().map(|start| (system.clone(), *start));
    let mut ensemble = Ensemble::new(method, members, h).expect("starts");
    ensemble.advance(40).expect("an end");
    for (member, start) in starts.iter().enumerate() {
        let mut run = system.run_with::<f64, X>(method, *start, h).expect("a start");
        run.advance(40).expect("an end");
        assert_eq!(ensemble.state(member), Some(run.state()), "{member} by {}", method.facts().name);
    }
}

#[test]
fn stages_in_lanes_have_the_bits_of_members() {
    let hung: Vec<_> = (0..9).map(|k| Phase::new([0.3 * f64::from(k), -0.5], [0.2, 0.3])).collect();
    let bound: Vec<_> = (0..9).map(|k| Phase::new([0.1, 0.02 * f64::from(k)], [0.3, -0.1])).collect();
    stages_have_the_bits_of_members(&DoublePendulum, GaussLegendre6, &hung, 0.1);
    stages_have_the_bits_of_members(&DoublePendulum, GaussLegendre::<5>, &hung, 0.15);
    stages_have_the_bits_of_members(&DoublePendulum, GaussLegendre::<8>, &hung, 0.25);
    stages_have_the_bits_of_members(&Separate, GaussLegendre::<8>, &bound, 0.5);
    stages_have_the_bits_of_members(&InParts, GaussLegendre::<4>, &bound, 0.3);
}

#[test]
fn each_stage_adds_two_orders() {
    // A method of the same family, whose coefficients a unit test compares with their definition.
    let start = Phase { q: [0.6, -0.3], p: [0.1, 0.2] };
    let reference = end(&DoublePendulum, GaussLegendre::<8>, &start, 0.05, 80);
    macro_rules! slopes {
        ($($stages:literal with $steps:literal),*) => {$({
            let method = GaussLegendre::<$stages>;
            let errors = [1_u32, 2].map(|times| {
                let steps = $steps * times;
                apart(&end(&DoublePendulum, method, &start, 4.0 / f64::from(steps), steps.into()), &reference)
            });
            // The next order is two higher.
            let (slope, order) = ((errors[0] / errors[1]).log2(), f64::from(2 * $stages));
            assert!((slope - order).abs() < 1.0, "{} stages: slope {slope}, errors {errors:?}", $stages);
            // Far above the rounding of the reference.
            assert!(errors[1] > 1e-13, "{} stages: errors {errors:?}", $stages);
        })*};
    }
    slopes!(1 with 80, 2 with 40, 3 with 20, 4 with 10, 5 with 10, 6 with 10, 7 with 10);
}

/// Energies of steps that are symplectic to the bit, and whose iteration no tolerance ends, do not drift: their error is a random
/// walk.
#[test]
fn rounding_errors_of_the_energy_are_a_walk() {
    let mut run = DoublePendulum.run_with(GaussLegendre::<8>, HUNG, 0.1).expect("a start");
    let energy = run.energy();
    let mut largest = 0.0_f64;
    for _ in 0..20 {
        run.advance(1_000).expect("an end");
        largest = largest.max((run.energy() - energy).abs());
    }
    // 20,000 roundings of numbers of about 2, half of ε each at most: √20000 ε 2 / √3 = 3.6e-14, and three times this.
    assert!(largest < 1.1e-13, "{largest:e}");
}

#[test]
fn portions_checkpoints_and_compensation_work_as_always() {
    let mut whole = DoublePendulum.run(HUNG, 0.05).expect("a start");
    let mut parts = whole.clone();
    whole.advance(2_000).expect("an end");
    parts.advance(7).expect("an end");
    parts = Run::resume(&DoublePendulum, &parts.checkpoint()).expect("it was just made");
    parts.advance(1_993).expect("an end");
    assert_eq!(whole.state(), parts.state());

    // The state of a run that rounds less is nearer to that of half the steps, in which the order does not show.
    let compensated = |h, steps| {
        let start: Phase<[Compensated<f64>; 2]> = Phase::compensated(HUNG.q, HUNG.p);
        let mut run = DoublePendulum.run_with(GaussLegendre6, start, h).expect("a start");
        run.advance(steps).expect("an end");
        run.state().q[0].value
    };
    let error = (compensated(0.005, 2_000) - compensated(0.0025, 4_000)).abs();
    assert!(error < 1e-13, "{error:e}");
}

#[test]
fn long_steps_take_newtons_iteration_or_are_a_typed_error() {
    /// A well whose wall is a million times as steep as its floor, with a term that mixes.
    struct Stiff;

    #[hamiltonian(split = none)]
    impl Stiff {
        fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
            0.5 * (px * px + py * py + x * x + 1e6 * y * y) + 0.1 * x * py
        }
    }
    let start = Phase::new([1.0, 1e-6], [0.0, 0.0]);
    // The default is the midpoint, which conserves quadratic energies, whatever the step.
    let mut run = Stiff.run(start, 0.1).expect("a start");
    let energy = run.energy();
    run.advance(10_000).expect("an end");
    assert!((run.energy() - energy).abs() < 1e-9, "{:e}", run.energy() - energy);

    let mut run = DoublePendulum.run_with(GaussLegendre6, HUNG, 1e6).expect("a start");
    let error = run.advance(10).expect_err("no end");
    assert!(
        matches!(error, Error::NotSolved { reason: Unsolved::Newton { h: 1e6, contraction, .. }, .. } if contraction > 1e4),
        "{error:?}"
    );
    assert_eq!(run.state(), HUNG);
}

#[test]
fn a_member_without_a_step_leaves_the_others_alone() {
    // The second pendulum turns 1e6 times in a step.
    let wild = Phase::new([1.0, -0.5], [1e8, 3e8]);
    let members = [HUNG, wild, HUNG].map(|start| (DoublePendulum, start));
    let mut swarm = Ensemble::new(GaussLegendre6, members, 0.1).expect("starts");
    let error = swarm.advance(50).expect_err("no end of one of them");
    assert!(matches!(error, Error::Lost(_)), "{error:?}");
    let mut run = DoublePendulum.run_with(GaussLegendre6, HUNG, 0.1).expect("a start");
    run.advance(50).expect("an end");
    assert_eq!([0, 1, 2].map(|member| swarm.steps_of(member)), [Some(50), Some(0), Some(50)]);
    assert_eq!([0, 1, 2].map(|member| swarm.state(member)), [Some(run.state()), Some(wild), Some(run.state())]);
}

#[test]
fn the_time_is_read_where_stages_are() {
    struct Driven;

    #[hamiltonian(split = none)]
    impl Driven {
        fn hamiltonian(&self, [q]: [f64; 1], [p]: [f64; 1], t: f64) -> f64 {
            0.5 * p * p * (1.0 + 0.2 * t.cos()) + 0.5 * q * q + 0.3 * q * p * t.sin()
        }
    }
    let error = |steps: u32| {
        let of =
            |steps: u32| end(&Driven, GaussLegendre4, &Phase::new([1.0], [0.0]), 2.0 / f64::from(steps), steps.into());
        apart(&of(steps), &of(2 * steps))
    };
    let order = (error(10) / error(40)).log2() / 2.0;
    assert!((order - 4.0).abs() < 0.2, "{order}");
}

/// A stiff spring along a parabola. In long steps the first iteration overflows in one coordinate before the others do.
struct Curved;

#[hamiltonian]
impl Curved {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * 1e4 * (y - x * x).powi(2) - x.cos()
    }
}

/// What is no number in one coordinate was taken for settled where the next one was a number.
#[test]
fn an_iteration_that_overflows_is_left_to_newton() {
    for (h, steps) in [(0.05, 240), (0.2, 60)] {
        let mut run = Curved.run_with(ImplicitMidpoint, Phase::new([1.0, 1.0], [0.0, 0.0]), h).expect("a run");
        let energy = run.energy();
        run.advance(steps).expect("Newton's iteration has an end");
        assert!((run.energy() - energy).abs() < 2e-3, "{h}: {:e}", run.energy() - energy);
    }
}
