//! Where time transformations end: each flow of each step checks its domain, so that no outcome depends on the calls.

use integrator_core::prelude::*;

/// A pendulum with a constant: `V < 0` near the bottom alone, and the potential energy is a sum.
#[derive(Clone, Copy, Debug)]
struct Pendulum {
    constant: f64,
}

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos() - self.constant
    }
    fn rate(&self, q: [f64; 1]) -> f64 {
        q[0].cos() + self.constant
    }
}

/// A pendulum whose potential energy is one product.
#[derive(Clone, Copy, Debug)]
struct Product {
    weight: f64,
}

#[hamiltonian]
impl Product {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.weight * q[0].cos()
    }
    fn rate(&self, q: [f64; 1]) -> f64 {
        self.weight * q[0].cos()
    }
}

/// Three bodies on a line whose potential energy is collected with its gradient.
#[derive(Clone, Copy, Debug)]
struct Chain {
    constant: f64,
}

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        let mut sum = -self.constant;
        for i in 0..2 {
            sum -= (q[i + 1] - q[i]).cos();
        }
        sum
    }
    fn rate(&self, q: [f64; 3]) -> f64 {
        (q[1] - q[0]).cos() + self.constant
    }
}

/// A comet with an orbit of any kind, whose potential energy keeps its sign.
#[derive(Clone, Copy, Debug)]
struct Comet {
    pull: f64,
}

#[hamiltonian]
impl Comet {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -self.pull / q[0].hypot(q[1])
    }
    fn rate(&self, q: [f64; 2]) -> f64 {
        1.0 / q[0].hypot(q[1]) - 0.5
    }
}

/// The outcome of steps of a run: an error, and where the run stands.
macro_rules! outcome {
    ($run:ident, $portions:expr) => {{
        let mut run = $run.clone();
        let result = $portions.into_iter().try_for_each(|portion: u64| run.advance(portion));
        (result, run.steps(), run.time(), run.state())
    }};
}

/// Takes the steps of random systems in one call, one by one, and in random portions: each ends at the same step, in the same
/// state and with the same error. Returns how many stop at a step.
macro_rules! stopped {
    ($method:expr, $random:ident, $cases:expr, $member:expr) => {{
        let mut stopped = 0;
        for _ in 0..$cases {
            let (system, start) = $member(&mut $random);
            let h = 10_f64.powf(-2.5 * $random.f64()) * if $random.bool() { 1.0 } else { -1.0 };
            let steps = $random.u64(1..200);
            let run = system.run_with::<f64, _>($method, start, h).expect("a start");
            let whole = outcome!(run, [steps]);
            let (mut portions, mut left) = (Vec::new(), steps);
            while left > 0 {
                portions.push($random.u64(1..=left));
                left -= portions.last().expect("a portion");
            }
            assert_eq!(outcome!(run, (0..steps).map(|_| 1)), whole, "one by one");
            assert_eq!(outcome!(run, portions.iter().copied()), whole, "in portions {portions:?}");
            stopped += u32::from(whole.0.is_err());
        }
        stopped
    }};
}

fn start<const N: usize>(random: &mut fastrand::Rng) -> Phase<[f64; N]> {
    let mut number = |scale: f64| scale * (2.0 * random.f64() - 1.0);
    Phase::new([(); N].map(|()| number(1.2)), [(); N].map(|()| number(2.0)))
}

fn pendulum(random: &mut fastrand::Rng) -> (Pendulum, Phase<[f64; 1]>) {
    (Pendulum { constant: 0.9 * random.f64() }, start(random))
}

fn product(random: &mut fastrand::Rng) -> (Product, Phase<[f64; 1]>) {
    (Product { weight: 0.1 + random.f64() }, start(random))
}

fn chain(random: &mut fastrand::Rng) -> (Chain, Phase<[f64; 3]>) {
    (Chain { constant: 0.9 * random.f64() }, start(random))
}

fn comet(random: &mut fastrand::Rng) -> (Comet, Phase<[f64; 2]>) {
    (Comet { pull: random.f64() - 0.1 }, start(random))
}

#[test]
fn portions_do_not_change_where_a_run_ends() {
    let mut random = fastrand::Rng::with_seed(44);
    let stopped = [
        stopped!(Logarithmic(Verlet), random, 300, pendulum),
        stopped!(Logarithmic(VelocityVerlet), random, 300, pendulum),
        stopped!(Logarithmic(KahanLi8), random, 300, pendulum),
        stopped!(Logarithmic(Euler), random, 300, pendulum),
        stopped!(Power(0.5, Yoshida4), random, 300, pendulum),
        stopped!(Power(-0.5, Verlet), random, 300, pendulum),
        stopped!(Power(2.0, Euler), random, 300, pendulum),
        stopped!(Paced(Yoshida4), random, 300, pendulum),
        stopped!(Logarithmic(Verlet), random, 300, product),
        stopped!(Logarithmic(Yoshida4), random, 300, chain),
        stopped!(Paced(Verlet), random, 300, chain),
        stopped!(Logarithmic(Verlet), random, 300, comet),
        stopped!(Paced(Verlet), random, 300, comet),
    ];
    // The test says nothing where no run meets the edge of the domain.
    assert!(stopped.iter().all(|stopped| (10..290).contains(stopped)), "{stopped:?}");
}

#[test]
fn members_and_tangents_end_where_their_runs_do() {
    let mut random = fastrand::Rng::with_seed(45);
    macro_rules! same_ends {
        ($method:expr) => {{
            let members: Vec<_> = (0..40).map(|_| pendulum(&mut random)).collect();
            let mut swarm = Ensemble::new($method, members.clone(), 0.05).expect("members");
            let lost = swarm.advance(150);
            assert!(matches!(lost, Err(Error::Lost(_))), "{lost:?}");
            for (member, (system, start)) in members.iter().enumerate() {
                let mut run = system.run_with($method, *start, 0.05).expect("a start");
                let result = run.advance(150);
                assert_eq!(swarm.state(member), Some(run.state()), "member {member}");
                assert_eq!(swarm.time_of(member), Some(run.time()), "member {member}");
                let mut tangent = system.tangent($method, *start, [Phase::new([1.0], [0.0])], 0.05).expect("a start");
                assert_eq!(tangent.advance(150).is_err(), result.is_err(), "member {member}");
                assert_eq!(tangent.steps(), run.steps(), "member {member}");
            }
        }};
    }
    same_ends!(Logarithmic(Yoshida4));
    same_ends!(Power(0.5, Yoshida4));
    same_ends!(Paced(Yoshida4));
}

#[test]
fn no_step_is_kept_that_leapt_over_the_edge_of_the_domain() {
    let mut random = fastrand::Rng::with_seed(46);
    let mut longest = 0;
    for _ in 0..2_000 {
        let (system, start) = pendulum(&mut random);
        let h = 10_f64.powf(-2.5 * random.f64());
        let mut run = system.run_with(Logarithmic(Verlet), start, h).expect("a start");
        // T + B at the end of a step, after its only kick. It is -V but for the errors of the steps.
        let energy = system.kinetic(start.p) + system.potential(start.q);
        let mut before = system.kinetic(start.p) - energy;
        while run.steps() < 200 && run.advance(1).is_ok() {
            let after = system.kinetic(run.state().p) - energy;
            // The kick between them checked one of both to be within a factor of ten of its own -V, which is 1 + c at most; the
            // factor covers roundings.
            let largest = 10.0 * (1.0 + system.constant) * (1.0 + 1e-12);
            assert!(before.min(after) <= largest, "{system:?} from {start:?} by {h}: {before} and {after}");
            assert!(after > 0.0, "{system:?} from {start:?} by {h}: T + B is {after} after step {}", run.steps());
            before = after;
        }
        longest = run.steps().max(longest);
    }
    assert_eq!(longest, 200);
}

#[test]
fn the_error_names_the_number_that_left_the_domain() {
    // The second step begins where V is negative and kicks where V is positive.
    let (system, start) =
        (Pendulum { constant: 0.1020920336104273 }, Phase::new([0.23650685747040023], [1.4038137466724463]));
    let mut run = system.run_with(Logarithmic(Verlet), start, 0.6522923186860412).expect("a start");
    let error = run.advance(33).expect_err("V > 0 at a kick").to_string();
    assert!(error.contains("requires V < 0") && error.contains("step 2"), "{error}");
    assert_eq!(run.steps(), 1);
    // A drift that begins near the edge leaps over it, to where V is negative again.
    let (system, start) =
        (Pendulum { constant: 0.44238170023011214 }, Phase::new([-0.9465676809205286], [1.6936771430866084]));
    let mut run = system.run_with(Logarithmic(Verlet), start, -0.005449738560736725).expect("a start");
    let error = run.advance(160).expect_err("a leap over the edge").to_string();
    assert!(error.contains("the step is too long for a time transformation"), "{error}");
    let before = system.kinetic(start.p) + system.potential(start.q);
    assert!((run.energy() - before).abs() < 0.1, "{} and {before}", run.energy());
}
