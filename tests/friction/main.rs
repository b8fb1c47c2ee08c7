//! Friction and noise: damped motion against closed forms, equilibria against theirs, and the same bits wherever a path is computed.

mod heat;
#[path = "../support/instruction_sets.rs"]
mod instruction_sets;
mod lattices;

use integrator_core::{
    FrictionScheme, InLanes, Memoryless, Method,
    check::{Equilibrium, oscillator_equilibrium},
    prelude::*,
};

/// A damped oscillator of angular frequency 1.
struct Oscillator {
    gamma: f64,
}

#[hamiltonian(split = kinetic + potential + friction)]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        self.gamma
    }
}

impl Oscillator {
    /// The position that begins at 1 with the momentum 1.
    fn position(&self, t: f64) -> f64 {
        let frequency = (1.0 - self.gamma * self.gamma / 4.0).sqrt();
        let (sine, cosine) = (frequency * t).sin_cos();
        (-self.gamma * t / 2.0).exp() * (cosine + (1.0 + self.gamma / 2.0) / frequency * sine)
    }
}

/// A pendulum in a bath.
struct Pendulum {
    mass: f64,
    gamma: f64,
    kt: f64,
}

#[hamiltonian(split = kinetic + potential + friction)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / (2.0 * self.mass)
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        self.gamma
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        self.kt
    }
}

const BATH: Pendulum = Pendulum { mass: 2.0, gamma: 0.5, kt: 0.3 };

/// An oscillator in a bath of temperature 1.
struct Warm;

#[hamiltonian(split = kinetic + potential + friction)]
impl Warm {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        1.0
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        1.0
    }
}

composition! {
    /// Three steps of the default, one of them backwards.
    pub struct Fourth: order 4, symmetric = triple_jump(V(1/2) T(1/2) O(1) T(1/2) V(1/2));
    /// Friction in two places.
    pub struct Twice: order 1 = O(1/3) T(1/2) V(1) T(1/2) O(2/3);
}

/// The slope of the error at time 4 over two halvings of the step.
fn slope<X: FrictionScheme + Method<Oscillator>>(method: X) -> f64 {
    let system = Oscillator { gamma: 0.3 };
    let errors = [256_u32, 1024].map(|steps| {
        let start = Phase::new([1.0], [1.0]);
        let mut run = system.run_with(method, start, 4.0 / f64::from(steps)).expect("a run");
        run.advance(u64::from(steps)).expect("steps");
        (run.state().q[0] - system.position(4.0)).abs()
    });
    (errors[0] / errors[1]).log2() / 2.0
}

#[test]
fn damped_motion_has_the_order_that_is_proved() {
    for (slope, order) in [
        (slope(Baoab), Baoab::ORDER),
        (slope(Aboba), Aboba::ORDER),
        (slope(Obabo), Obabo::ORDER),
        (slope(Baoa), Baoa::ORDER),
        (slope(Fourth), Fourth::ORDER),
        // Friction of unlike halves around a symmetric step.
        (slope(Twice), Twice::ORDER),
    ] {
        assert!((slope - f64::from(order)).abs() < 0.1, "{slope} for {order}");
    }
}

#[test]
fn areas_contract_by_the_rate() {
    let vectors = [Phase::new([1.0], [0.0]), Phase::new([0.0], [1.0])];
    let mut run = BATH.tangent(Baoab, Phase::new([1.0], [0.5]), vectors, 0.1).expect("a run").with_seed(3);
    run.advance(100).expect("steps");
    let [a, b] = &run.vectors()[..] else { panic!("two vectors") };
    let area = a.q[0] * b.p[0] - a.p[0] * b.q[0];
    // A hundred products of numbers of at most ten, each rounded a few times.
    assert!((area / (-BATH.gamma * 10.0_f64).exp() - 1.0).abs() < 1e-11, "{area}");
}

/// The mean squares of q and p over many members, after a time in which they forget their starts.
fn mean_squares<X: InLanes<Warm>>(method: X, h: f64) -> [f64; 2] {
    let members = (0..MEMBERS).map(|_| (Warm, Phase::new([0.0], [0.0])));
    let mut swarm = Ensemble::new(method, members, h).expect("an ensemble").with_seed(5);
    swarm.advance((40.0 / h) as u64).expect("steps");
    let mut sums = [0.0; 2];
    for state in swarm.states() {
        sums[0] += state.q[0] * state.q[0];
        sums[1] += state.p[0] * state.p[0];
    }
    sums.map(|sum| sum / MEMBERS as f64)
}

const MEMBERS: usize = 20_000;

#[test]
fn equilibria_of_an_oscillator_are_those_of_the_step() {
    let h = 1.2;
    // A mean of squares of normal numbers has the relative deviation sqrt(2 / members), here 1 %.
    let is = |found: f64, expected: f64| (found / expected - 1.0).abs() < 5.0 * (2.0 / MEMBERS as f64).sqrt();
    let stretched = 1.0 - h * h / 4.0;
    // The closed forms of Leimkuhler and Matthews, whatever the rate.
    for (expected, equilibrium, [q, p]) in [
        ([1.0, stretched], oscillator_equilibrium::<Baoab>(h, h), mean_squares(Baoab, h)),
        ([1.0, 1.0 / stretched], oscillator_equilibrium::<Aboba>(h, h), mean_squares(Aboba, h)),
        ([1.0 / stretched, 1.0], oscillator_equilibrium::<Obabo>(h, h), mean_squares(Obabo, h)),
        ([1.0, 1.0], oscillator_equilibrium::<Baoa>(h, h), mean_squares(Baoa, h)),
    ] {
        let Some(Equilibrium { positions, momenta, .. }) = equilibrium else { panic!("a stable step") };
        assert!((positions - expected[0]).abs() + (momenta - expected[1]).abs() < 1e-12, "{equilibrium:?}");
        assert!(is(q, positions) && is(p, momenta), "{q} and {p}, not {expected:?}");
    }
    assert!(oscillator_equilibrium::<Baoab>(2.0, h).is_none() && oscillator_equilibrium::<Baoab>(h, 0.0).is_none());
    assert!(!is(mean_squares(Obabo, h)[0], 1.0), "the bias of 56 % is seen");
}

/// The states of a run after some steps, in portions.
fn path<X: Memoryless<Pendulum>>(method: X, seed: u64, portions: &[u64]) -> Phase<[f64; 1]> {
    let mut run = BATH.run_with(method, Phase::new([1.0], [0.0]), 0.1).expect("a run").with_seed(seed);
    portions.iter().for_each(|steps| run.advance(*steps).expect("steps"));
    run.state()
}

#[test]
fn a_path_has_the_same_bits_wherever_it_is_computed() {
    let whole = path(Baoab, 7, &[3_000]);
    assert_eq!(path(Baoab, 7, &[1, 1_023, 1_976]), whole);
    assert_ne!(path(Baoab, 8, &[3_000]), whole);
    let ensemble = |members: usize, threads| {
        let members = (0..members).map(|_| (BATH, Phase::new([1.0], [0.0])));
        Ensemble::new(Baoab, members, 0.1).expect("an ensemble").with_seed(7).with_threads(threads)
    };
    let (mut one, mut many) = (ensemble(3, 1), ensemble(37, 2));
    one.advance(3_000).expect("steps");
    many.advance(1_000).expect("steps");
    let mut alone = many.run_of(20).expect("in progress");
    many.advance(2_000).expect("steps");
    alone.advance(2_000).expect("steps");
    assert_eq!(one.state(0), Some(whole));
    assert_eq!(one.state(2), many.state(2));
    assert_eq!(many.state(20), Some(alone.state()));
    let ends: Vec<f64> = many.states().map(|state| state.q[0]).collect();
    assert!((1..ends.len()).all(|member| ends[member] != ends[member - 1]), "members draw numbers of their own");
}

#[test]
fn a_resumed_run_goes_on_with_its_numbers() {
    let mut run = BATH.run(Phase::new([1.0], [0.0]), 0.1).expect("a run").with_seed(9);
    run.advance(500).expect("steps");
    run.map_state(|state| state.q[0] += 1.0).expect("another state");
    run.advance(17).expect("steps");
    let mut resumed: Run<[f64; 1]> = Run::resume(&BATH, &run.checkpoint()).expect("a run");
    run.advance(500).expect("steps");
    resumed.advance(500).expect("steps");
    assert_eq!(resumed.state(), run.state());

    let members = || (0..20).map(|_| BATH);
    let starts = members().map(|system| (system, Phase::new([1.0], [0.0])));
    let mut swarm = Ensemble::new(Baoab, starts, 0.1).expect("an ensemble").with_seed(9);
    swarm.advance(500).expect("steps");
    let mut resumed: Ensemble<[f64; 1]> = Ensemble::resume(Baoab, members(), &swarm.checkpoint()).expect("an ensemble");
    swarm.advance(500).expect("steps");
    resumed.advance(500).expect("steps");
    assert!(resumed.states().eq(swarm.states()));
}

/// Bodies of different masses in baths of different temperatures, which attract each other in pairs.
struct Bodies;

/// The mass of a body.
fn mass(body: usize) -> f64 {
    1.0 + body as f64 / 8.0
}

/// The temperature of a body.
fn temperature(body: usize) -> f64 {
    1.0 + (body % 3) as f64
}

#[hamiltonian(compose = Obabo, split = kinetic + potential + friction)]
impl Bodies {
    fn mass(&self, i: usize) -> f64 {
        mass(i)
    }
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1] + p[i][2] * p[i][2]) / (2.0 * self.mass(i));
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let d = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                energy += 0.01 * (1.0 + d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
            }
        }
        energy
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        400.0
    }
    #[temperature]
    fn temperature(&self, i: usize) -> f64 {
        temperature(i)
    }
}

/// A chain, whose first and last sites are in baths.
struct Chain {
    length: usize,
}

#[hamiltonian(compose = Obabo, split = kinetic + potential + friction)]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() - 1 {
            let stretch = q[i + 1] - q[i];
            energy += stretch * stretch / 2.0 + stretch.powi(4) / 4.0;
        }
        energy
    }
    #[friction]
    fn friction(&self, i: usize) -> f64 {
        if i == 0 || i + 1 == self.length { 400.0 } else { 0.0 }
    }
    #[temperature]
    fn temperature(&self, i: usize) -> f64 {
        if i == 0 { 2.0 } else { 1.0 }
    }
}

/// The momenta at the ends of many steps, each divided by its deviation in equilibrium.
fn normalised<C: integrator_core::Coords<Leaf = f64>>(run: Run<C>, deviation: impl Fn(usize) -> f64) -> Vec<Vec<f64>> {
    let states = run.samples(1).take(STEPS).map(|sample| sample.expect("a state").state);
    states.map(|state| state.p.flat().iter().enumerate().map(|(k, p)| p / deviation(k)).collect()).collect()
}

const STEPS: usize = 4_000;

/// Whether columns are independent normal numbers: friction of rate 400 leaves exp(-20) of a momentum after half a step of 0.1.
fn are_independent(rows: &[Vec<f64>], columns: &[usize]) -> bool {
    let count = rows.len() as f64;
    let mean = |of: &dyn Fn(&[f64]) -> f64| rows.iter().map(|row| of(row)).sum::<f64>() / count;
    let mut all = true;
    for (number, a) in columns.iter().enumerate() {
        all &= (mean(&|row| row[*a] * row[*a]) - 1.0).abs() < 6.0 * (2.0 / count).sqrt();
        all &= mean(&|row| row[*a]).abs() < 6.0 / count.sqrt();
        all &= columns[..number].iter().all(|b| mean(&|row| row[*a] * row[*b]).abs() < 6.0 / count.sqrt());
        let lagged = rows.windows(2).map(|pair| pair[0][*a] * pair[1][*a]).sum::<f64>() / count;
        all &= lagged.abs() < 6.0 / count.sqrt();
    }
    all
}

#[test]
fn every_momentum_has_noise_of_its_own_in_every_layout() {
    for bodies in [2_usize, 3, 8, 9, 20] {
        let place = |i: usize| [i as f64, (i * i % 7) as f64, (i % 3) as f64];
        let start = Phase::new((0..bodies).map(place).collect(), vec![[0.0; 3]; bodies]);
        let run = Bodies.run(start, 0.1).expect("a run").with_seed(bodies as u64);
        let columns: Vec<_> = (0..3 * bodies).collect();
        let rows = normalised(run, |k| (mass(k / 3) * temperature(k / 3)).sqrt());
        assert!(are_independent(&rows, &columns), "{bodies} bodies");
        let rows =
            normalised(Bodies.run(Phase::new(vec![[0.0; 3]; 2], vec![[0.0; 3]; 2]), 0.1).expect("a run"), |_| 1.0);
        assert!(!are_independent(&rows, &[0, 3]), "temperatures and masses count");
    }
    for length in [2_usize, 5, 40, 300] {
        let start = Phase::new(vec![0.0; length], vec![0.0; length]);
        let run = Chain { length }.run(start, 0.1).expect("a run");
        let rows = normalised(run, |k| if k == 0 { 2.0_f64.sqrt() } else { 1.0 });
        assert!(are_independent(&rows, &[0, length - 1]), "{length} sites");
    }
}

/// A body without forces, whose friction grows with time.
struct Braked;

#[hamiltonian(split = kinetic + potential + friction)]
impl Braked {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        1e-30 * (q[0] + q[1])
    }
    #[friction]
    fn friction(&self, i: usize, t: f64) -> f64 {
        (1.0 + i as f64) * t
    }
}

#[test]
fn a_rate_reads_the_index_and_the_time() {
    let mut run = Braked.run(Phase::new([0.0; 2], [1.0; 2]), 0.01).expect("a run").at_time(1.0);
    run.advance(100).expect("steps");
    // The mean of a linear rate over a step is that of its middle.
    for (p, rate) in run.state().p.into_iter().zip([1.5_f64, 3.0]) {
        assert!((p / (-rate).exp() - 1.0).abs() < 1e-12, "{p}");
    }
}

#[test]
fn crossings_lie_within_the_noisy_steps() {
    let run = BATH.run(Phase::new([1.0], [0.0]), 0.2).expect("a run");
    let passages: Vec<_> = run.crossings(2_000, Direction::Either, |state, _| state.q[0]).collect();
    assert!(passages.len() > 50);
    for passage in passages {
        let passage = passage.expect("a passage");
        assert!(passage.state.q[0].abs() < 1e-9 && passage.time.is_finite(), "{passage:?}");
    }
}

#[test]
fn what_cannot_be_integrated_is_refused() {
    let start = || Phase::new([1.0], [0.0]);
    let text = |outcome: Result<Run<[f64; 1]>, Error>| outcome.err().map(|error| error.to_string()).unwrap_or_default();
    let is_refused = |text: String, part: &str| assert!(text.contains(part), "{text}");
    is_refused(text(BATH.run_with(Verlet, start(), 0.1)), "Verlet does not apply the friction");
    is_refused(text(BATH.run_with(Logarithmic(Verlet), start(), 0.1)), "does not apply the friction");
    is_refused(text(BATH.run_with(ImplicitMidpoint, start(), 0.1)), "does not apply the friction");
    is_refused(text(BATH.run(start(), -0.1)), "negative duration");
    is_refused(text(BATH.run_with(Fourth, start(), 0.1)), "negative duration");
    is_refused(text(Pendulum { gamma: -1.0, ..BATH }.run(start(), 0.1)), "`friction(0)` is -1");
    is_refused(text(Pendulum { kt: f64::NAN, ..BATH }.run(start(), 0.1)), "`temperature(0)` is NaN");
    is_refused(text(Pendulum { mass: -1.0, ..BATH }.run(start(), 0.1)), "positive mass");
    let on_grid = BATH.run(Phase::reversible([1.0], [0.0], 2.0_f64.powi(-40)), 0.1);
    assert!(on_grid.is_err_and(|error| error.to_string().contains("does not support friction")));
    let gradient = BATH.gradient(Baoab, start(), 0.1, 10, |end| (end.q[0], Phase::new([1.0], [0.0])));
    assert!(gradient.is_err());
    assert!(Oscillator { gamma: 0.1 }.run(start(), -0.1).is_ok(), "without noise, steps may go back");
}
