//! Candidates: compositions without type parameters, for the search.

use crate::{
    check::{start::Start, statistics::points::run},
    composition::{Class, Composition, Processor, Rows, Stage, Stages, flow_counts::PartFlows, visitor::Visitor},
    error::Error,
    hamiltonian::Hamiltonian,
    methods::implicit::{GaussLegendre, GaussLegendre4, GaussLegendre6, ImplicitMidpoint},
    state::{coords::Coords, precision::Precision},
    system::{QuadraticKinetic, Shaped},
    trajectory::{
        by_table::{ByTable, Kicks, Plain, WithGradients},
        method::{Described, Facts, Method, with_inner_steps},
        run::Run,
    },
};

/// Begins a run of a system, whatever its composition.
type Begin<'s, C> = Box<dyn Fn(&Start<C>, f64) -> Result<Run<C>, Error> + 's>;

/// A system with a composition of the catalogue, without type parameters for either.
///
/// All candidates of a system share one loop over stages, so they compile as fast as a single composition.
///
/// ```
/// use integrator_core::{check::candidates, prelude::*};
///
/// struct Oscillator;
///
/// #[hamiltonian]
/// impl Oscillator {
///     fn kinetic(&self, p: [f64; 1]) -> f64 {
///         0.5 * p[0] * p[0]
///     }
///     fn potential(&self, q: [f64; 1]) -> f64 {
///         0.5 * q[0] * q[0]
///     }
/// }
///
/// let start = Phase::new([1.0], [0.0]);
/// for candidate in candidates(&Oscillator) {
///     let mut run = candidate.run(start, 0.01)?;
///     run.advance(100)?;
///     println!("{:<24} {:+.1e}", candidate.facts().name, run.state().q[0] - 1.0_f64.cos());
/// }
/// # Ok::<(), Error>(())
/// ```
pub struct Candidate<'s, C: Coords> {
    pub(super) facts: Facts,
    pub(super) class: Class,
    /// Evaluations of each step, gradients counted as one more; an assumption where runs count them.
    pub(super) each: u64,
    /// Whether runs count their evaluations, since steps differ in these.
    pub(super) counts: bool,
    /// Evaluations of the processor and its inverse.
    pub(super) once: u64,
    /// The fictitious time per unit of physical time, for methods with a fictitious time; otherwise none.
    pub(super) pace: Option<f64>,
    begin: Begin<'s, C>,
}

impl<C: Coords> Candidate<'_, C> {
    /// Returns the properties of the composition.
    pub fn facts(&self) -> Facts {
        self.facts
    }

    /// Starts a run of the system, bitwise identical to [`Hamiltonian::run_with`] with this composition.
    ///
    /// # Errors
    /// The errors of [`Hamiltonian::run`]; the time is not finite.
    pub fn run(&self, start: impl Into<Start<C>>, h: f64) -> Result<Run<C>, Error> {
        (self.begin)(&start.into(), h)
    }

    /// Starts a run from a start that is used again.
    pub(super) fn begin(&self, start: &Start<C>, h: f64) -> Result<Run<C>, Error> {
        (self.begin)(start, h)
    }

    /// The length of a step in the time of the steps themselves, from that in physical time.
    pub(super) fn step(&self, h: f64) -> f64 {
        self.pace.map_or(h, |pace| h * pace)
    }

    /// The work of a run, or about that.
    pub(super) fn evaluations(&self, steps: u64) -> u64 {
        steps * self.each + self.once
    }
}

impl<'s, C: Coords> Candidate<'s, C> {
    /// A system under a method with a fictitious time over a composition, whose step is that of physical time at this
    /// pace.
    pub(super) fn paced<H, X, M>(system: &'s H, composition: X, method: M, pace: f64) -> Self
    where
        H: Hamiltonian,
        X: Composition<H>,
        M: Method<H>,
        H::Coords: Coords<With<C::Leaf> = C>,
    {
        Self {
            facts: composition.facts(),
            class: X::CLASS,
            each: X::FORCE_EVALUATIONS as u64,
            counts: false,
            once: 0,
            pace: Some(pace),
            begin: Box::new(move |start, h| run::<H, M, C::Leaf>(system, method, start, h * pace)),
        }
    }
}

/// Returns a system with each composition of the catalogue that can integrate it, for states in `f64`.
pub fn candidates<H: Hamiltonian>(system: &H) -> Vec<Candidate<'_, H::Coords>> {
    candidates_with::<H, f64>(system)
}

/// Returns a system with each composition of the catalogue that can integrate it, for states of another precision.
///
/// An example is `candidates_with::<_, f32>(&system)`.
pub fn candidates_with<H: Hamiltonian, K: Precision>(system: &H) -> Vec<Candidate<'_, Shaped<H, K>>> {
    candidates_with_inner_steps::<H, K>(system, None)
}

/// The same with a number of inner steps, or with that of the annotation.
pub(super) fn candidates_with_inner_steps<H: Hamiltonian, K: Precision>(
    system: &H,
    inner_steps: Option<u32>,
) -> Vec<Candidate<'_, Shaped<H, K>>> {
    let mut candidates = Candidates::<H, K> { system, inner_steps, with_gradients: None, found: Vec::new() };
    H::visit_compositions(&mut candidates);
    candidates.found
}

/// The iterations of an implicit step that are assumed before any is taken.
const ITERATIONS: u64 = 8;

/// A system whose H stays in one piece under each implicit method.
pub(super) fn in_one_piece<H: Hamiltonian, K: Precision>(system: &H) -> Vec<Candidate<'_, Shaped<H, K>>> {
    let stages = |candidate, stages: u64| Candidate { each: stages * ITERATIONS, ..candidate };
    vec![
        stages(by_method::<H, K, _>(system, ImplicitMidpoint, Class::General), 1),
        stages(by_method::<H, K, _>(system, GaussLegendre4, Class::General), 2),
        stages(by_method::<H, K, _>(system, GaussLegendre6, Class::General), 3),
        stages(by_method::<H, K, _>(system, GaussLegendre::<4>, Class::General), 4),
        stages(by_method::<H, K, _>(system, GaussLegendre::<8>, Class::General), 8),
    ]
}

/// Collects what it visits.
struct Candidates<'s, H: Hamiltonian, K: Precision> {
    system: &'s H,
    inner_steps: Option<u32>,
    /// Makes the runs of compositions with force gradients, where the system admits them.
    #[expect(clippy::type_complexity, reason = "named once")]
    with_gradients: Option<fn(&'s H, ByTable<WithGradients>) -> Begin<'s, Shaped<H, K>>>,
    found: Vec<Candidate<'s, Shaped<H, K>>>,
}

/// A composition as data, so that what is made of it is compiled once for a system.
struct Entry {
    facts: Facts,
    class: Class,
    stages: Stages,
    processor: Processor,
    evaluations: usize,
    gradients: usize,
}

impl<H: Hamiltonian, K: Precision> Candidates<'_, H, K> {
    fn add(&mut self, entry: Entry) {
        let Entry { facts, class, stages, processor, evaluations: each, gradients } = entry;
        let begin = match self.with_gradients {
            Some(begin) if gradients > 0 => begin(self.system, ByTable::new(facts, stages, processor, None)),
            _ => begin::<H, K, Plain>(self.system, ByTable::new(facts, stages, processor, self.inner_steps)),
        };
        self.found.push(Candidate {
            facts,
            class,
            each: (each + gradients) as u64,
            counts: false,
            pace: None,
            once: evaluations(&processor.before) + evaluations(&processor.after),
            begin,
        });
    }
}

impl<H: Hamiltonian, K: Precision> Visitor<H> for Candidates<'_, H, K> {
    fn visit<X: Composition<H>>(&mut self, composition: X) {
        let (stages, processor) = (X::STAGES, X::PROCESSOR);
        let (mut facts, mut evaluations) = (composition.facts(), X::FORCE_EVALUATIONS);
        if const { !H::NESTED.is_empty() } {
            facts = with_inner_steps::<H, X>(facts, self.inner_steps);
            evaluations = PartFlows::of::<H, X>(self.inner_steps).of_last_part() as usize;
        }
        self.add(Entry { facts, class: X::CLASS, stages, processor, evaluations, gradients: X::GRADIENT_EVALUATIONS });
    }

    fn admit_gradients(&mut self)
    where
        H: QuadraticKinetic,
    {
        self.with_gradients = Some(begin::<H, K, WithGradients>);
    }
}

fn begin<H: Hamiltonian, K: Precision, G: Kicks<H>>(system: &H, method: ByTable<G>) -> Begin<'_, Shaped<H, K>> {
    Box::new(move |start, h| run::<H, ByTable<G>, K>(system, method, start, h))
}

/// A system under a method whose runs count their evaluations.
pub(super) fn by_method<H: Hamiltonian, K: Precision, X: Method<H>>(
    system: &H,
    method: X,
    class: Class,
) -> Candidate<'_, Shaped<H, K>> {
    let begin = Box::new(move |start: &Start<_>, h| run::<H, X, K>(system, method, start, h));
    Candidate { facts: method.claims(), class, each: 0, counts: true, once: 0, pace: None, begin }
}

/// The evaluations of some stages.
fn evaluations(rows: &Rows) -> u64 {
    rows.rows.iter().map(Stage::forces).sum()
}
