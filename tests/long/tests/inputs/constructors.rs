//! Every public constructor rejects all bad input, with the same reason.

use integrator_core::{
    CheckpointError, NotFinite,
    check::{
        CertifyError, CheckError, certify, energy_drift, global_error, gradient_error, observed_order, reversibility,
        shadow, stability, symplectic_defect, symplectic_defect_after,
    },
    prelude::*,
    taylor::Taylor,
};

/// A chain with the length of its initial state, with individual masses. The energy of its end is undefined beyond 30,
/// but all forces are finite.
#[derive(Clone)]
struct Chain {
    mass: Vec<f64>,
    stiffness: f64,
    cutoff: f64,
}

#[hamiltonian(taylor)]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        let mut sum = 0.0;
        for i in 0..p.len() {
            sum += p[i] * p[i] / (2.0 * self.mass[i]);
        }
        sum
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut sum = 0.0 * (30.0 - q[0]).ln();
        for i in 1..q.len() {
            let stretch = q[i] - q[i - 1];
            if stretch < self.cutoff {
                sum += self.stiffness * stretch.powi(2);
            }
        }
        sum
    }
}

/// All inputs of a run.
#[derive(Clone)]
struct Input {
    chain: Chain,
    q: Vec<f64>,
    p: Vec<f64>,
    h: f64,
    grid: f64,
}

fn good() -> Input {
    let chain = Chain { mass: vec![1.0, 2.0, 3.0], stiffness: 1.0, cutoff: f64::INFINITY };
    Input { chain, q: vec![0.0, 1.5, 2.0], p: vec![0.0, 0.3, 0.1], h: 0.01, grid: 1.0 / (1_u64 << 40) as f64 }
}

/// Returns the reason of an error as text, because NaN in an error is not equal to itself.
trait Reason {
    fn reason(&self) -> String;
}

impl Reason for Error {
    fn reason(&self) -> String {
        match self {
            // Every member has its own step, so the first member is reported.
            Error::Member { member: 0, error } if matches!(**error, Error::Step { .. }) => error.reason(),
            Error::Member { member: 1, error } => error.reason(),
            other => format!("{other:?}"),
        }
    }
}

impl Reason for CheckError {
    fn reason(&self) -> String {
        match self {
            CheckError::Run(error) => error.reason(),
            other => format!("{other:?}"),
        }
    }
}

impl Reason for CertifyError {
    fn reason(&self) -> String {
        match self {
            CertifyError::Run(error) => error.reason(),
            other => format!("{other:?}"),
        }
    }
}

impl Reason for CheckpointError {
    fn reason(&self) -> String {
        match self {
            CheckpointError::Run(error) => error.reason(),
            other => format!("{other:?}"),
        }
    }
}

/// The inputs that an entry point takes: step, initial state and parameters, the latter two, or parameters alone.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Asks {
    Parameters,
    Start,
    Step,
}

/// Result of an input at one of the public constructors.
struct EntryPoint {
    name: &'static str,
    asks: Asks,
    outcome: Result<(), String>,
}

fn outcome<T, E: Reason>(result: Result<T, E>) -> Result<(), String> {
    result.map(drop).map_err(|error| error.reason())
}

/// Tests an input at every public constructor, with one scalar type.
macro_rules! entry_points {
    ($input:expr, $start:expr, $composition:ident) => {{
        let input: &Input = $input;
        let start = $start;
        let (chain, h) = (&input.chain, input.h);
        let from = || start(input);
        // The bad member is the second one, so the error has to name it.
        let members = || [(good().chain, start(&good())), (chain.clone(), from())];
        let saved = good().chain.run(start(&good()), 0.01).expect("good").checkpoint();
        let saved_with = good().chain.run_with($composition, start(&good()), 0.01).expect("good").checkpoint();
        // A bad interval is reported before the first step, a bad run when it is created.
        let sampled = chain.run(from(), h).and_then(|run| run.samples(1).next().unwrap_or(Err(Error::SampleInterval)));
        let resumed = same(&from(), Run::resume(chain, &saved));
        let resumed_with = same(&from(), Run::resume_with(chain, $composition, &saved_with));
        [
            ("run", Asks::Step, outcome(chain.run(from(), h))),
            ("run_with", Asks::Step, outcome(chain.run_with($composition, from(), h))),
            ("samples", Asks::Step, outcome(sampled)),
            ("Ensemble::new", Asks::Step, outcome(Ensemble::new($composition, members(), h))),
            ("resume", Asks::Parameters, outcome(resumed)),
            ("resume_with", Asks::Parameters, outcome(resumed_with)),
        ]
        .map(|(name, asks, outcome)| EntryPoint { name, asks, outcome })
        .into()
    }};
}

/// Tests an input at every check.
fn checks(input: &Input) -> Vec<EntryPoint> {
    let (chain, h) = (&input.chain, input.h);
    [
        ("certify", Asks::Step, outcome(certify(chain, Verlet, plain(input), h))),
        ("observed_order", Asks::Step, outcome(observed_order(chain, Verlet, plain(input), h))),
        ("symplectic_defect", Asks::Step, outcome(symplectic_defect(chain, Verlet, plain(input), h))),
        ("symplectic_defect_after", Asks::Step, outcome(symplectic_defect_after(chain, Verlet, plain(input), h, 2))),
        ("reversibility", Asks::Step, outcome(reversibility(chain, Verlet, plain(input), h, 2))),
        ("energy_drift", Asks::Step, outcome(energy_drift(chain, Verlet, plain(input), h, 100))),
        ("global_error", Asks::Step, outcome(global_error(chain, Verlet, plain(input), h, 100))),
        ("gradient_error", Asks::Start, outcome(gradient_error(chain, plain(input), 0.0))),
        ("stability", Asks::Step, outcome(stability(chain, Verlet, plain(input), h))),
        ("shadow", Asks::Step, outcome(shadow(chain, Verlet, plain(input), h))),
    ]
    .map(|(name, asks, outcome)| EntryPoint { name, asks, outcome })
    .into()
}

/// Tests an input at the constructors with Taylor's method.
fn taylor(input: &Input) -> Vec<EntryPoint> {
    let (chain, h, method) = (&input.chain, input.h, Taylor::tolerance(1e-12));
    let members = [(good().chain, plain(&good())), (chain.clone(), plain(input))];
    [
        ("run_with", Asks::Step, outcome(chain.run_with(method, plain(input), h))),
        ("Ensemble::new", Asks::Step, outcome(Ensemble::new(method, members, h))),
    ]
    .map(|(name, asks, outcome)| EntryPoint { name, asks, outcome })
    .into()
}

/// Returns the run, with the coordinate type of the first argument.
fn same<C: integrator_core::Coords>(
    _: &Phase<C>,
    run: Result<Run<C>, CheckpointError>,
) -> Result<Run<C>, CheckpointError> {
    run
}

fn plain(input: &Input) -> Phase<Vec<f64>> {
    Phase::new(input.q.clone(), input.p.clone())
}

fn single(input: &Input) -> Phase<Vec<f32>> {
    let narrow = |numbers: &[f64]| numbers.iter().map(|number| *number as f32).collect();
    Phase::new(narrow(&input.q), narrow(&input.p))
}

fn compensated(input: &Input) -> Phase<Vec<Compensated<f64>>> {
    Phase::compensated(input.q.clone(), input.p.clone())
}

fn reversible(input: &Input) -> Phase<Vec<Fixed<f64>>> {
    Phase::reversible(input.q.clone(), input.p.clone(), input.grid)
}

/// Tests all constructors, by scalar type. Only `f64` uses another composition than `Verlet`, so that little is compiled
/// for the other types. `choose` has its own tests: it begins like the checks, but is compiled for every composition.
fn all(input: &Input) -> [(&'static str, Vec<EntryPoint>); 6] {
    [
        ("f64", entry_points!(input, plain, Chin4A)),
        ("f32", entry_points!(input, single, Verlet)),
        ("compensated", entry_points!(input, compensated, Verlet)),
        ("reversible", entry_points!(input, reversible, Verlet)),
        ("checks", checks(input)),
        ("Taylor's method", taylor(input)),
    ]
}

/// Makes a good input bad.
type Spoil = fn(&mut Input);

#[test]
fn every_constructor_names_the_same_reason() {
    // Required text in the error; of several bad parameters, any may be reported.
    let parameter = |formula, indices: &[(&'static str, usize)], value| {
        (Asks::Parameters, format!("{:?}", NotFinite { formula, indices: indices.to_vec(), value }))
    };
    let start = |coordinate, index, value| (Asks::Start, Error::Start { coordinate, index, value }.reason());
    let step = |h| (Asks::Step, Error::Step { h }.reason());
    let length = |positions, momenta| (Asks::Start, Error::Length { positions, momenta }.reason());
    let energy = (Asks::Start, Error::Energy { function: "potential", value: f64::NAN, time: 0.0 }.reason());
    let rows: [((Asks, String), Spoil); 17] = [
        (step(0.0), |input| input.h = 0.0),
        (step(-0.0), |input| input.h = -0.0),
        (step(f64::NAN), |input| input.h = f64::NAN),
        (step(f64::INFINITY), |input| input.h = f64::INFINITY),
        (step(f64::NEG_INFINITY), |input| input.h = f64::NEG_INFINITY),
        (start("q", 1, f64::NAN), |input| input.q[1] = f64::NAN),
        (start("q", 0, f64::INFINITY), |input| input.q[0] = f64::INFINITY),
        (start("p", 2, f64::NEG_INFINITY), |input| input.p[2] = f64::NEG_INFINITY),
        (energy, |input| input.q[0] = 40.0),
        (length(3, 2), |input| input.p.truncate(2)),
        (length(2, 3), |input| input.q.truncate(2)),
        (length(3, 0), |input| input.p.clear()),
        (parameter("1 / mass[i]", &[("i", 2)], f64::INFINITY), |input| input.chain.mass[2] = 0.0),
        // This holds at rest as well: the velocity would be 0/0.
        (parameter("1 / mass[i]", &[("i", 0)], f64::NEG_INFINITY), |input| input.chain.mass[0] = -0.0),
        (parameter("1 / mass[i]", &[("i", 1)], f64::NAN), |input| input.chain.mass[1] = f64::NAN),
        (parameter("stiffness", &[], f64::INFINITY), |input| input.chain.stiffness = f64::INFINITY),
        (parameter("stiffness", &[], f64::NAN), |input| input.chain.stiffness = f64::NAN),
    ];
    for ((kind, reason), spoil) in rows {
        let mut input = good();
        spoil(&mut input);
        for (leaf, entry_points) in all(&input) {
            for entry_point in entry_points.iter().filter(|entry_point| entry_point.asks >= kind) {
                let refused = entry_point.outcome.as_ref().is_err_and(|said| said.contains(&reason));
                assert!(
                    refused,
                    "{} of {leaf}: {:?} where {reason} is the reason",
                    entry_point.name, entry_point.outcome
                );
            }
        }
    }
}

#[test]
fn good_input_passes_them_all() {
    let input = good();
    for entry_point in all(&input).iter().flat_map(|(_, entry_points)| entry_points) {
        assert_eq!(entry_point.outcome, Ok(()), "{}", entry_point.name);
    }
}
