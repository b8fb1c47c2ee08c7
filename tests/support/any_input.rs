//! Systems, initial states and steps generated from bytes, for the property test and for the fuzz target, which
//! includes this file by its path.
//!
//! Input: bytes, read as choices. Output: a description of the failure, if there is one. Always true: no public
//! function of the library panics, every state that it returns is finite, and a rejected or failed call changes
//! nothing.

use integrator_core::{
    Coords,
    check::{certify, energy_drift, global_error, gradient_error, reversibility, stability, symplectic_defect},
    prelude::*,
};

/// Parameters that are folded into constants, in every place where bad values matter.
#[derive(Clone)]
struct Pendulum {
    mass: f64,
    length: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.mass * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -9.81 * self.mass * self.length * q[0].cos()
    }
}

/// A singularity, and kicks along the gradient of the squared force.
#[derive(Clone)]
struct Kepler {
    strength: f64,
}

#[hamiltonian(compose = Chin4A)]
impl Kepler {
    fn kinetic(&self, p: &[f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: &[f64; 2]) -> f64 {
        -self.strength / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

/// As many sites as the initial state has, possibly none.
#[derive(Clone)]
struct Lattice {
    mass: f64,
    cubic: f64,
}

#[hamiltonian]
impl Lattice {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / (2.0 * self.mass)).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut sum = 0.0;
        for i in 1..q.len() {
            let stretch = q[i] - q[i - 1];
            sum += stretch * stretch / 2.0 + self.cubic * stretch.powi(3);
        }
        sum
    }
}

/// Points with a list of masses and a cutoff, integrated with a processed composition.
#[derive(Clone)]
struct Cluster {
    masses: Vec<f64>,
    cutoff: f64,
}

#[hamiltonian(compose = TakahashiImada4)]
impl Cluster {
    fn kinetic(&self, p: &[[f64; 2]]) -> f64 {
        let mut sum = 0.0;
        for i in 0..p.len() {
            sum += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * self.masses[i]);
        }
        sum
    }
    fn potential(&self, q: &[[f64; 2]]) -> f64 {
        let mut sum = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let r2 = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2);
                if r2 < self.cutoff {
                    sum += r2.powi(-6) - r2.powi(-3);
                }
            }
        }
        sum
    }
}

/// Both parts depend on time, and `T` is not quadratic.
#[derive(Clone)]
struct Driven {
    frequency: f64,
}

#[hamiltonian(compose = Ruth3)]
impl Driven {
    fn kinetic(&self, p: [f64; 1], t: f64) -> f64 {
        (1.0 + p[0] * p[0]).sqrt() / (1.0 + t * t)
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        q[0].cosh() - q[0] * (self.frequency * t).sin()
    }
}

/// Functions with bounded domains.
#[derive(Clone)]
struct Edges {
    power: f64,
}

#[hamiltonian(compose = BlanesMoan4)]
impl Edges {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        p[0].abs().powf(self.power) + p[1].hypot(p[2]) + p[2].exp()
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        q[0].ln() + q[1].asin() + q[2].tan() + q[0].min(q[1]).sqrt() + q[1].atan2(q[2])
    }
}

/// Bytes as choices; after the last byte, every choice is the first one.
struct Choices<'b>(&'b [u8]);

impl Choices<'_> {
    /// Returns a number below `count`.
    fn below(&mut self, count: usize) -> usize {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        usize::from(*first) % count
    }

    /// Returns mostly an ordinary number, sometimes an extreme one, sometimes one with random bits.
    fn number(&mut self) -> f64 {
        const TERRIBLE: [f64; 16] = [
            0.0,
            -0.0,
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::MIN_POSITIVE,
            5e-324,
            -5e-324,
            1e-150,
            1e150,
            -1e150,
            f64::MAX,
            f64::MIN,
            f64::EPSILON,
            9_007_199_254_740_993.0,
            1e-8,
        ];
        match self.below(8) {
            0 => TERRIBLE[self.below(TERRIBLE.len())],
            1 => f64::from_bits((0..8).fold(0, |bits, _| bits << 8 | self.below(256) as u64)),
            _ => (self.below(256) as f64 - 96.0) / 64.0,
        }
    }

    fn numbers<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.number())
    }

    fn step(&mut self) -> f64 {
        if self.below(4) == 0 { self.number() } else { (self.below(64) as f64 - 16.0) / 256.0 }
    }

    /// Returns few steps, slightly more than a block of steps, or more than a run can count.
    fn steps(&mut self) -> u64 {
        match self.below(16) {
            0 => 1024 + self.below(256) as u64,
            1 => u64::MAX - self.below(4) as u64,
            _ => self.below(32) as u64,
        }
    }
}

/// Tests an initial state in `f64` or in the other scalar type of the system. Differences between scalar types do not
/// depend on the system: each scalar type is used by two systems, and by one of them in ensembles with other members.
macro_rules! with_leaves {
    ($choices:expr, $system:expr, $q:expr, $p:expr, $other:ident $(, $swarm:ident)?) => {{
        let (system, q, p) = ($system, $q, $p);
        let choices = $choices;
        checked(choices, &system, Phase::new(q.clone(), p.clone()));
        let h = choices.step();
        if choices.below(2) == 0 {
            alone(choices, &system, Phase::new(q, p), h)
        } else {
            let start = $other!(choices, q, p);
            $($swarm!(choices, system, start, h);)?
            alone(choices, &system, start, h)
        }
    }};
}

/// Tests an ensemble of equal members.
macro_rules! together {
    ($choices:expr, $system:expr, $start:expr, $h:expr) => {{
        let members: Vec<_> = (0..$choices.below(10)).map(|_| ($system.clone(), $start.clone())).collect();
        let ensemble = Ensemble::new(Verlet, members, $h).map(|swarm| swarm.with_threads($choices.below(3)));
        together($choices, ensemble)?;
    }};
}

macro_rules! single {
    ($choices:expr, $q:expr, $p:expr) => {
        Phase { q: $q.map(|x| x as f32), p: $p.map(|x| x as f32) }
    };
}

macro_rules! compensated {
    ($choices:expr, $q:expr, $p:expr) => {
        Phase::compensated($q, $p)
    };
}

macro_rules! reversible {
    ($choices:expr, $q:expr, $p:expr) => {{
        let grid = if $choices.below(4) == 0 { $choices.number() } else { 1.0 / (1_u64 << 40) as f64 };
        Phase::reversible($q, $p, grid)
    }};
}

/// Tests the input that the bytes describe, and returns the failure if there is one.
pub(crate) fn outcome(bytes: &[u8]) -> Result<(), String> {
    let choices = &mut Choices(bytes);
    match choices.below(6) {
        0 => {
            let [mass, length] = choices.numbers();
            let [q, p] = choices.numbers().map(|x| [x]);
            with_leaves!(choices, Pendulum { mass, length }, q, p, single, together)
        }
        1 => {
            let strength = choices.number();
            let (q, p) = (choices.numbers::<2>(), choices.numbers::<2>());
            with_leaves!(choices, Kepler { strength }, q, p, reversible, together)
        }
        2 => {
            let [mass, cubic] = choices.numbers();
            let (q, p) = lists(choices, |choices| choices.number());
            with_leaves!(choices, Lattice { mass, cubic }, q, p, compensated, together)
        }
        3 => {
            let cutoff = choices.number();
            let (q, p) = lists(choices, |choices| choices.numbers::<2>());
            let masses = (0..q.len()).map(|_| choices.number()).collect();
            with_leaves!(choices, Cluster { masses, cutoff }, q, p, compensated)
        }
        4 => {
            let frequency = choices.number();
            let [q, p] = choices.numbers().map(|x| [x]);
            with_leaves!(choices, Driven { frequency }, q, p, single)
        }
        _ => {
            let power = choices.number();
            let (q, p) = (choices.numbers::<3>(), choices.numbers::<3>());
            with_leaves!(choices, Edges { power }, q, p, reversible)
        }
    }
}

/// Returns positions and momenta with a size known at run time; the two sizes sometimes differ.
fn lists<T>(choices: &mut Choices<'_>, element: impl Fn(&mut Choices<'_>) -> T) -> (Vec<T>, Vec<T>) {
    let positions = choices.below(6);
    let momenta = if choices.below(8) == 0 { choices.below(6) } else { positions };
    ((0..positions).map(|_| element(choices)).collect(), (0..momenta).map(|_| element(choices)).collect())
}

/// Checks that all numbers of a state are finite, from its debug output, which all shapes and scalar types have.
fn finite<C: Coords>(state: &Phase<C>) -> Result<(), String> {
    let text = format!("{state:?}");
    let wrong = ["NaN", "inf"].iter().any(|word| text.contains(word));
    if wrong { Err(format!("a state that is not finite: {text}")) } else { Ok(()) }
}

/// Tests one run with a random sequence of calls.
fn alone<H, C>(choices: &mut Choices<'_>, system: &H, start: Phase<C>, h: f64) -> Result<(), String>
where
    H: Hamiltonian,
    H::Coords: Coords<With<C::Leaf> = C>,
    C: Coords,
{
    let Ok(mut run) = system.run::<C::Leaf>(start, h) else { return Ok(()) };
    if choices.below(4) == 0 {
        run = run.at_time(choices.number());
    }
    for _ in 0..choices.below(8) {
        let (before, steps) = (run.state(), run.steps());
        match choices.below(7) {
            0 => {
                let samples: Vec<_> = run.clone().samples(choices.steps()).take(3).collect();
                for sample in samples.iter().flatten() {
                    finite(&sample.state)?;
                    let _ = sample.energy();
                }
            }
            1 => {
                let mut bytes = run.checkpoint();
                let resumed: Run<C> = Run::resume(system, &bytes).map_err(|error| format!("not resumed: {error}"))?;
                if (resumed.state(), resumed.steps()) != (before.clone(), steps) {
                    return Err(format!("resumed {resumed:?} from {run:?}"));
                }
                let at = choices.below(256) % bytes.len();
                bytes[at] ^= 1 << choices.below(8);
                if Run::<C>::resume(system, &bytes).is_ok() {
                    return Err(format!("resumed from a checkpoint with a wrong byte {at}"));
                }
            }
            2 => {
                let within = choices.below(64) as u64;
                // The function returns arbitrary values: noise, zeros, and values that are not finite.
                let crossings = run.clone().crossings(within, Direction::Either, |_, _| choices.number());
                for crossing in crossings.take(3).flatten() {
                    finite(&crossing.state)?;
                    let _ = crossing.energy();
                }
            }
            _ => {
                let asked = choices.steps();
                match run.advance(asked) {
                    Ok(()) if run.steps() == steps + asked => {}
                    Err(Error::Diverged(divergence)) if run.steps() + 1 == divergence.step => {}
                    Err(_) if (run.state(), run.steps()) == (before, steps) => {}
                    outcome => return Err(format!("{outcome:?} after {asked} steps of {run:?}")),
                }
            }
        }
        finite(&run.state())?;
        let _ = (run.energy(), run.time(), format!("{run:?}"));
    }
    Ok(())
}

/// Runs one of the checks; its result may be anything here.
fn checked<H: Hamiltonian>(choices: &mut Choices<'_>, system: &H, start: Phase<H::Coords>) {
    let h = choices.step();
    match choices.below(64) {
        1 if choices.below(4) == 0 => {
            let _ = certify::<H, Verlet, f64>(system, Verlet, start, h).map(|certificate| certificate.to_string());
        }
        22 if choices.below(4) == 0 => {
            let _ = global_error::<H, Verlet, f64>(system, Verlet, start, h, choices.below(40) as u64);
        }
        2..6 => {
            let _ = symplectic_defect::<H, Verlet, f64>(system, Verlet, start, h);
        }
        6..10 => {
            let _ = reversibility::<H, Verlet, f64>(system, Verlet, start, h, choices.below(40) as u64);
        }
        10..14 => {
            let _ = energy_drift::<H, Verlet, f64>(system, Verlet, start, h, choices.below(40) as u64);
        }
        14..18 => {
            let _ = gradient_error::<H, f64>(system, start, choices.number());
        }
        18..22 => {
            let _ = stability::<H, Verlet, f64>(system, Verlet, &start, h).map(|stability| stability.to_string());
        }
        _ => {}
    }
}

/// Tests an ensemble, if it could be created.
fn together<C: Coords>(choices: &mut Choices<'_>, ensemble: Result<Ensemble<C>, Error>) -> Result<(), String> {
    let Ok(mut ensemble) = ensemble else { return Ok(()) };
    for _ in 0..choices.below(3) {
        let outcome = ensemble.advance(choices.steps());
        let _ = outcome.map_err(|error| error.to_string());
    }
    for member in 0..=ensemble.len() {
        let _ = ensemble.energy(member);
    }
    ensemble.states().try_for_each(|state| finite(&state))
}
