//! Splittings: systems without type parameters, for the problem of a choice.

use super::{
    Split,
    adaptive::{ByTaylor, by_taylor},
    candidate::{Candidate, candidates_with, in_one_piece},
};
use crate::{
    check::{
        oracle::{
            compensated_steps::CompensatedSteps,
            edges::fewest_steps,
            exact::Motions,
            reference::{Reference, series_reference},
        },
        property::energy::sample,
        start::Start,
        statistics::{
            path::{PARTS, Path, Recorder, Scale},
            points::{begin, flat_start, plain},
        },
    },
    composition::catalogue::SofroniouSpaletta10,
    error::Error,
    hamiltonian::Hamiltonian,
    methods::implicit::GaussLegendre6,
    state::{
        coords::Coords,
        flat::{Flat, flat, shaped},
        phase::Phase,
    },
    trajectory::{
        by_table::{ByTable, Plain},
        method::Method,
    },
};

/// The number of halvings of the time until flows in some two thousand evaluations follow the motion: over all
/// of it, these are as many as a run has at most.
const HALVINGS: i32 = 15;

/// A splitting of a Hamiltonian: any system whose coordinates have this type.
pub trait Splitting<C: Coords> {
    /// The system behind the interface that a choice measures.
    #[doc(hidden)]
    fn measured(&self) -> Erased<'_, C>;
}

impl<H: Hamiltonian, C: Coords> Splitting<C> for H
where
    H::Coords: Coords<With<C::Leaf> = C>,
{
    fn measured(&self) -> Erased<'_, C> {
        Erased(self)
    }
}

/// A system without its type parameter.
pub struct Erased<'s, C>(pub(super) &'s dyn Measured<C>);

/// The kinetic energy of a state at a time, or what is taken for it, and the energy.
pub(super) type Energies<'s, C> = Box<dyn Fn(&Phase<C>, f64) -> [f64; 2] + 's>;

/// The interface through which a choice measures a system.
pub(super) trait Measured<C: Coords> {
    /// Returns the name of the splitting.
    fn name(&self) -> Split;

    /// The system under each composition that it admits.
    ///
    /// # Errors
    /// Why none is worth trying from this start.
    fn candidates(&self, start: &Start<C>, span: f64) -> Result<Vec<Candidate<'_, C>>, &'static str>;

    /// The system by Taylor's method, where its recurrences were written; those of a system in steps of another time are
    /// ranked with the system.
    fn by_taylor(&self) -> Option<ByTaylor<'_, C>> {
        None
    }

    /// Whether a run may begin at a start.
    fn begin(&self, start: &Start<C>, h: f64) -> Result<(), Error>;

    /// Whether the Hamiltonian does not read the time.
    fn autonomous(&self) -> bool;

    /// Whether the clock decides on pieces of the Hamiltonian.
    fn piecewise_in_time(&self) -> bool;

    /// The fewest steps that end where pieces do, of points along the motion; else the time of an edge.
    fn fewest_steps(&self, start: &Start<C>, points: &[Flat], span: f64) -> Result<u64, f64>;

    /// The motion in this number of steps of order 10, or of order 6 where H stays in one piece, with a compensated
    /// state, recorded after every step. It has no ends if the run diverges.
    fn path(&self, start: &Start<C>, span: f64, steps: u64) -> (Path, Scale);

    /// The motion by a Taylor series, where there is one.
    fn series(&self, start: &Start<C>, span: f64) -> Option<Reference>;

    /// The energies of states of this length.
    fn energies(&self, length: usize) -> Energies<'_, C>;
}

/// What a splitting takes over from the system in one of its fields.
macro_rules! of_system {
    ($system:tt) => {
        fn begin(&self, start: &Start<C>, h: f64) -> Result<(), Error> {
            Measured::<C>::begin(self.$system, start, h)
        }
        fn autonomous(&self) -> bool {
            Measured::<C>::autonomous(self.$system)
        }
        fn piecewise_in_time(&self) -> bool {
            Measured::<C>::piecewise_in_time(self.$system)
        }
        fn fewest_steps(&self, start: &Start<C>, points: &[Flat], span: f64) -> Result<u64, f64> {
            Measured::<C>::fewest_steps(self.$system, start, points, span)
        }
        fn path(&self, start: &Start<C>, span: f64, steps: u64) -> (Path, Scale) {
            Measured::<C>::path(self.$system, start, span, steps)
        }
        fn series(&self, start: &Start<C>, span: f64) -> Option<Reference> {
            Measured::<C>::series(self.$system, start, span)
        }
        fn energies(&self, length: usize) -> Energies<'_, C> {
            Measured::<C>::energies(self.$system, length)
        }
    };
}
pub(super) use of_system;

impl<H: Hamiltonian, C: Coords> Measured<C> for H
where
    H::Coords: Coords<With<C::Leaf> = C>,
{
    fn name(&self) -> Split {
        let name = std::any::type_name::<H>();
        let path = &name[..name.find('<').unwrap_or(name.len())];
        let begin = path.rfind("::").map_or(0, |colons| colons + 2);
        Split { system: &path[begin..], parts: H::PARTS, inner_steps: None }
    }

    fn candidates(&self, _: &Start<C>, _: f64) -> Result<Vec<Candidate<'_, C>>, &'static str> {
        Ok(if const { H::PARTS.is_empty() } {
            in_one_piece::<H, C::Leaf>(self)
        } else {
            candidates_with::<H, C::Leaf>(self)
        })
    }

    fn by_taylor(&self) -> Option<ByTaylor<'_, C>> {
        by_taylor::<H, C::Leaf>(self)
    }

    fn begin(&self, start: &Start<C>, h: f64) -> Result<(), Error> {
        begin::<H, _, C::Leaf>(self, H::Compose::default(), start, h).map(|_| ())
    }

    fn autonomous(&self) -> bool {
        H::AUTONOMOUS
    }

    fn piecewise_in_time(&self) -> bool {
        H::PIECEWISE_IN_TIME
    }

    fn fewest_steps(&self, start: &Start<C>, points: &[Flat], span: f64) -> Result<u64, f64> {
        let shape = plain::<H, C::Leaf>(&start.phase);
        let points: Vec<_> = points.iter().map(|point| shaped(&shape, point)).collect();
        fewest_steps(self, &points, start.time, span)
    }

    fn path(&self, start: &Start<C>, span: f64, steps: u64) -> (Path, Scale) {
        if const { H::PARTS.is_empty() } {
            path(self, GaussLegendre6, start, span, steps)
        } else {
            path(self, ByTable::<Plain>::of(SofroniouSpaletta10), start, span, steps)
        }
    }

    fn series(&self, start: &Start<C>, span: f64) -> Option<Reference> {
        let start = plain::<H, C::Leaf>(&start.phase).at_time(start.time);
        series_reference(&Motions { system: self, shape: &start.phase }, &flat_start(&start), span, HALVINGS)
    }

    fn energies(&self, length: usize) -> Energies<'_, C> {
        let parameters = self.parameters(length);
        Box::new(move |state, time| {
            let found = sample::<H, C::Leaf>(&parameters, state, time);
            [found.kinetic, found.energy]
        })
    }
}

/// The motion by compensated steps of a method.
fn path<H: Hamiltonian, C: Coords, X: Method<H>>(
    system: &H,
    method: X,
    start: &Start<C>,
    span: f64,
    steps: u64,
) -> (Path, Scale)
where
    H::Coords: Coords<With<C::Leaf> = C>,
{
    let start = plain::<H, C::Leaf>(&start.phase).at_time(start.time);
    let begin = flat(&start.phase);
    let recorded = || -> Result<_, Error> {
        let mut recorder = Recorder::new(begin.clone(), steps / PARTS);
        let mut run = CompensatedSteps::new(system, method, start, span / steps as f64)?;
        for _ in 0..steps {
            recorder.record(run.advance(1)?);
        }
        Ok(recorder.finish())
    };
    recorded().unwrap_or_else(|_| Recorder::new(begin.clone(), 1).finish())
}
