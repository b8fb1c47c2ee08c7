//! What a system can be integrated by: one row of functions for each method, which do not name its type.

use crate::{
    arrays::Numbers,
    ensemble::AnyEnsemble,
    errors::{Fault, input_error},
    run::AnyRun,
    system::{AnySystem, Exported},
};
use integrator_core::{
    Composition, Coords, Dissipation, Ensemble, InLanes, Phase, RecurrencesVisitor, Visitor,
    chaos::{self, End, Indicator, Mapped, Spectrum},
    check::certify,
    taylor::{Recurrences, Taylor},
};
use pyo3::PyResult;

/// The compositions of a module that lists none, if they can integrate its system.
const USUAL: [&str; 10] = [
    "Verlet",
    "Yoshida4",
    "BlanesMoan4",
    "BlanesMoan6",
    "BlanesMoanSrkn11",
    "BlanesMoanSrkn14",
    "KahanLi8",
    "BlanesCasasMurua8",
    "Abah1064",
    "WisdomHolmanTouma17",
];

/// The tolerance of the Taylor method.
const TOLERANCE: f64 = 1e-16;

/// The precision of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scalar {
    F64,
    /// Doubles that carry the rounding errors of their updates.
    Compensated,
}

/// The names of scalars, as Python writes them.
pub(crate) const SCALARS: [(&str, Scalar); 2] = [("f64", Scalar::F64), ("compensated", Scalar::Compensated)];

/// Positions and momenta of one state, or of one for each member; the step, the initial time and the seed of random numbers.
pub(crate) struct Start {
    pub(crate) state: [Numbers; 2],
    pub(crate) scalar: Scalar,
    pub(crate) h: f64,
    pub(crate) time: f64,
    pub(crate) seed: u64,
}

type Start1<T> = Box<dyn Fn(&AnySystem, Start) -> Result<T, Fault> + Send + Sync>;
type StartAll<T> = Box<dyn Fn(&[AnySystem], Start) -> Result<T, Fault> + Send + Sync>;
pub(crate) type Exponents = Box<dyn Fn(&AnySystem, Start, u64) -> Result<Spectrum, Fault> + Send + Sync>;
pub(crate) type Map =
    Box<dyn Fn(&AnySystem, Start, u64, Indicator, &(dyn Fn() -> bool + Sync)) -> Result<Vec<f64>, Fault> + Send + Sync>;

/// The value of a function of the end of a run, and its derivatives with respect to the start and to parameters.
pub(crate) struct Derivatives {
    pub(crate) value: f64,
    pub(crate) by_start: [Vec<f64>; 2],
    pub(crate) by_parameters: Vec<f64>,
}

/// A function of the positions and momenta at the end: its value and its derivatives.
pub(crate) type Loss<'l> = &'l mut (dyn FnMut(&[f64], &[f64]) -> (f64, [Vec<f64>; 2]) + Send);

type ByStart = Box<dyn Fn(&AnySystem, Start, u64, Loss<'_>) -> Result<Derivatives, Fault> + Send + Sync>;

/// What one method can do with a system.
pub struct Row {
    pub(crate) name: &'static str,
    pub(crate) run: Start1<Box<dyn AnyRun>>,
    /// Starts an ensemble of one system, or of one for each member.
    pub(crate) ensemble: StartAll<Box<dyn AnyEnsemble>>,
    pub(crate) certify: Start1<String>,
}

/// What deviation vectors compute, by the composition of the annotation: for each composition it would take seconds to
/// compile.
pub(crate) struct Tangents {
    pub(crate) gradient: ByStart,
    pub(crate) spectrum: Exponents,
    pub(crate) map: Map,
}

impl Tangents {
    pub(crate) fn of<H: Exported>() -> Self {
        Self {
            gradient: Box::new(|system, from, steps, loss| {
                let (start, method) = (phase::<H::Coords>(&from)?, H::Compose::default());
                let mut at_end = |end: &Phase<H::Coords>| {
                    let (value, [q, p]) = loss(end.q.flat(), end.p.flat());
                    let mut cotangent = end.clone();
                    for (half, numbers) in [(&mut cotangent.q, q), (&mut cotangent.p, p)] {
                        half.flat_mut().iter_mut().zip(numbers).for_each(|(to, number)| *to = number);
                    }
                    (value, cotangent)
                };
                let found = of::<H>(system)?.gradient(method, start, from.h, steps, &mut at_end)?;
                let by_start = [found.start.q.flat().to_vec(), found.start.p.flat().to_vec()];
                Ok(Derivatives { value: found.value, by_start, by_parameters: found.parameters })
            }),
            spectrum: Box::new(|system, from, steps| {
                let start = phase::<H::Coords>(&from)?;
                Ok(chaos::lyapunov_spectrum(of::<H>(system)?, H::Compose::default(), start, from.h, steps)?)
            }),
            map: Box::new(|system, from, steps, indicator, goes_on| {
                let (system, starts) = (of::<H>(system)?, phases::<H::Coords>(&from)?);
                let (method, stays) = (H::Compose::default(), |_: &_| goes_on());
                let found = chaos::map_while(system, method, starts, from.h, steps, indicator, stays)?;
                found.into_iter().enumerate().map(of_orbit).collect()
            }),
        }
    }
}

impl Row {
    /// Returns the row of a method with its parameters.
    #[must_use]
    pub fn of<H: Exported, X: InLanes<H>>(method: X) -> Self {
        Self {
            name: method.facts().name,
            run: Box::new(move |system, from| {
                let (system, start) = (of::<H>(system)?, phase::<H::Coords>(&from)?);
                let Start { h, time, seed, .. } = from;
                Ok(match from.scalar {
                    Scalar::F64 => Box::new(system.run_with(method, start, h)?.at_time(time).with_seed(seed)),
                    Scalar::Compensated => {
                        let start = Phase::compensated(start.q, start.p);
                        Box::new(system.run_with(method, start, h)?.at_time(time).with_seed(seed))
                    }
                })
            }),
            ensemble: Box::new(move |systems, from| {
                let mut members = Vec::with_capacity(from.state[0].rows);
                for (system, start) in systems.iter().cycle().zip(phases::<H::Coords>(&from)?) {
                    members.push((of::<H>(system)?.clone(), start));
                }
                Ok(Box::new(Ensemble::new(method, members, from.h)?.at_time(from.time).with_seed(from.seed)))
            }),
            certify: Box::new(move |system, from| {
                let start = phase::<H::Coords>(&from)?.at_time(from.time);
                Ok(certify(of::<H>(system)?, method, start, from.h)?.to_string())
            }),
        }
    }

    /// Returns the rows of a system: that of its annotation, the given ones or the usual ones, and that of the Taylor method
    /// if the system has recurrences.
    #[must_use]
    pub fn all<H: Exported>(given: Option<Vec<Self>>) -> Vec<Self> {
        let mut rows = Rows(vec![Self::of::<H, _>(H::Compose::default())]);
        match given {
            Some(given) => rows.0.extend(given),
            // Without the letter `O`, compositions do not apply friction.
            None if !matches!(H::DISSIPATION, Dissipation::None) => {}
            None => H::visit_compositions(&mut rows),
        }
        H::visit_recurrences(&mut rows);
        let mut names = Vec::new();
        rows.0.retain(|row| {
            !names.contains(&row.name) && {
                names.push(row.name);
                true
            }
        });
        rows.0
    }
}

/// The rows so far.
struct Rows(Vec<Row>);

impl<H: Exported> Visitor<H> for Rows {
    fn visit<X: Composition<H>>(&mut self, composition: X) {
        // A constant, so that nothing is compiled for the other compositions.
        if const { is_usual(X::NAME) } {
            self.0.push(Row::of::<H, _>(composition));
        }
    }
}

impl<H: Exported> RecurrencesVisitor<H> for Rows {
    fn visit(&mut self)
    where
        H: Recurrences,
    {
        self.0.push(Row::of::<H, _>(Taylor::tolerance(TOLERANCE)));
    }
}

const fn is_usual(name: &str) -> bool {
    let (mut row, name) = (0, name.as_bytes());
    while row < USUAL.len() {
        let (usual, mut at) = (USUAL[row].as_bytes(), 0);
        while at < name.len() && at < usual.len() && name[at] == usual[at] {
            at += 1;
        }
        if at == name.len() && at == usual.len() {
            return true;
        }
        row += 1;
    }
    false
}

/// The system itself.
pub(crate) fn of<H: Exported>(system: &AnySystem) -> PyResult<&H> {
    system.downcast_ref().ok_or_else(|| input_error("a system of another class".to_owned()))
}

fn phases<C: Coords<Leaf = f64>>(Start { state: [q, p], .. }: &Start) -> PyResult<Vec<Phase<C>>> {
    let of_row = |numbers: &Numbers, row: usize| {
        let width = numbers.flat.len().checked_div(numbers.rows).unwrap_or_default();
        C::from_flat(numbers.flat[row * width..(row + 1) * width].to_vec())
    };
    let phases = (0..q.rows).map(|row| Some(Phase::new(of_row(q, row)?, of_row(p, row)?)));
    phases.collect::<Option<_>>().ok_or_else(|| input_error("q and p have another shape than the system".to_owned()))
}

fn phase<C: Coords<Leaf = f64>>(start: &Start) -> PyResult<Phase<C>> {
    phases(start)?.pop().ok_or_else(|| input_error("there is no initial state".to_owned()))
}

/// The indicator of an orbit of a map.
fn of_orbit((row, Mapped { value, end, .. }): (usize, Mapped)) -> Result<f64, Fault> {
    match end {
        End::Refused(error) => Err(input_error(format!("row {row}: {error}")).into()),
        End::NoEnergy => Ok(f64::NAN),
        _ => Ok(value),
    }
}
