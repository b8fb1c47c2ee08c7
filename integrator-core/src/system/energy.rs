//! The energy of any state of a system and what else is conserved, computed without its run.

use crate::{
    error::Error,
    scalar::{
        fma::{Avx512, Fma},
        instruction_set::InstructionSet,
        real::{Kernel, Real},
    },
    state::{coords::Coords, phase::Phase, precision::Precision},
    system::{
        Shaped, System,
        motion::{Found, Motion},
    },
};
use alloc::sync::Arc;

/// Kinetic, potential and total energy; the total is rounded once where energies are computed in double-double. Where
/// parts of H have names, the energy of the first one takes the place of the kinetic energy, and that of all others
/// together the place of the potential one.
#[derive(Clone, Copy)]
pub(crate) struct Parts {
    pub(crate) kinetic: f64,
    pub(crate) potential: f64,
    pub(crate) total: f64,
    /// The names of the parts of H.
    names: &'static [&'static str],
}

/// The names of the first part of H and of what all others make together, as the user knows them.
pub(crate) fn part_names(parts: &'static [&'static str]) -> [&'static str; 2] {
    match *parts {
        [] => ["hamiltonian"; 2],
        [first] => [first; 2],
        [first, second] => [first, second],
        [first, ..] => [first, "the sum of all other parts"],
    }
}

impl Parts {
    /// Whether a motion may start with these.
    ///
    /// # Errors
    /// [`Error::Energy`] naming the function that is not finite: forces may be finite there all the same, as those of
    /// `q - ln q` are at `q = -1`.
    pub(crate) fn admissible(self, time: f64) -> Result<(), Error> {
        let [first, second] = part_names(self.names);
        let parts = [(first, self.kinetic), (second, self.potential)];
        match parts.into_iter().find(|(_, value)| !value.is_finite()) {
            Some((function, value)) => Err(Error::Energy { function, value, time }),
            None => Ok(()),
        }
    }
}

/// The energy function of a system and its invariants, which do not borrow a run.
pub(crate) trait Energies<C: Coords>: Send + Sync {
    /// The energies of a state near one of which a motion has found something out.
    fn parts(&self, state: &Phase<C>, time: f64, found: Option<&Found>) -> Parts;

    /// The names of the invariants.
    fn invariants(&self) -> &'static [&'static str];

    /// The invariant of this number.
    fn invariant(&self, number: usize, state: &Phase<C>) -> f64;

    fn energy(&self, state: &Phase<C>, time: f64) -> f64 {
        self.parts(state, time, None).total
    }

    /// The invariant of this name.
    ///
    /// # Errors
    /// [`Error::NoInvariant`]
    fn invariant_named(&self, name: &str, state: &Phase<C>) -> Result<f64, Error> {
        Ok(self.invariant(number_of(name, self.invariants())?, state))
    }
}

/// The number of the invariant of a name.
///
/// # Errors
/// [`Error::NoInvariant`]
fn number_of(name: &str, known: &'static [&'static str]) -> Result<usize, Error> {
    known.iter().position(|known| *known == name).ok_or_else(|| Error::NoInvariant { name: name.into(), known })
}

/// The energy function of a system with its prepared constants.
struct EnergyFunction<P, C> {
    parameters: Arc<P>,
    energy: EnergyOf<P, C>,
    invariants: InvariantsOf<P, C>,
}

/// The energy function of a system.
pub(crate) fn energies<H: System, K: Precision>(
    parameters: Arc<H::Parameters<f64>>,
) -> Arc<dyn Energies<Shaped<H, K>>> {
    let invariants = InvariantsOf::of::<H, K>();
    Arc::new(EnergyFunction { parameters, energy: energy::<H, K>, invariants })
}

/// The invariants of a system, compiled for one system and leaf.
pub(crate) struct InvariantsOf<P, C> {
    pub(crate) names: &'static [&'static str],
    pub(crate) value: fn(&P, &Phase<C>, usize) -> f64,
}

impl<P, C> InvariantsOf<P, C> {
    pub(crate) fn of<H, K>() -> Self
    where
        H: System<Parameters<f64> = P>,
        K: Precision,
        H::Coords: Coords<With<K> = C>,
    {
        Self { names: H::INVARIANTS, value: invariant::<H, K> }
    }
}

impl<P: Send + Sync, C: Coords> Energies<C> for EnergyFunction<P, C> {
    fn parts(&self, state: &Phase<C>, time: f64, found: Option<&Found>) -> Parts {
        (self.energy)(&self.parameters, state, time, found)
    }

    fn invariants(&self) -> &'static [&'static str] {
        self.invariants.names
    }

    fn invariant(&self, number: usize, state: &Phase<C>) -> f64 {
        (self.invariants.value)(&self.parameters, state, number)
    }
}

/// The energy of a state at a time, compiled for one system and leaf.
pub(crate) type EnergyOf<P, C> = fn(&P, &Phase<C>, f64, Option<&Found>) -> Parts;

/// The energy of a state, computed in the scalar of its leaf.
pub(crate) fn energy<H: System, K: Precision>(
    parameters: &H::Parameters<f64>,
    state: &Phase<Shaped<H, K>>,
    time: f64,
    found: Option<&Found>,
) -> Parts {
    if const { H::ENERGIES_IN_LANES } {
        match InstructionSet::chosen() {
            InstructionSet::Avx512 if H::WIDE => {
                return energy_in::<H, K, K::EnergyIn<Avx512>>(parameters, state, time, found);
            }
            InstructionSet::Avx512 | InstructionSet::Fused => {
                return energy_in::<H, K, K::EnergyIn<Fma>>(parameters, state, time, found);
            }
            InstructionSet::Baseline => {}
        }
    }
    energy_in::<H, K, K::Energy>(parameters, state, time, found)
}

/// The energy of a state, computed in this scalar.
fn energy_in<H: System, K: Precision, R: Real>(
    parameters: &H::Parameters<f64>,
    state: &Phase<Shaped<H, K>>,
    time: f64,
    found: Option<&Found>,
) -> Parts {
    let mut motion = in_scalar::<H, K, R>(parameters, state);
    if let Some(found) = found {
        motion.use_found(found);
    }
    R::enter(Energy::<H, R, f64> { motion: &motion, time })
}

/// Computes the energy of a motion at a time.
pub(crate) type EnergyOfMotion<M> = fn(&M, f64) -> Parts;

/// Returns the function that computes the energy of a run from its motion, if energies in lanes have the scalar of the motion.
pub(crate) const fn of_motion<H: System, R: Real, K: Precision>() -> Option<EnergyOfMotion<H::Motion<R, K>>> {
    if H::ENERGIES_IN_LANES && R::LANES == 1 && K::PLAIN {
        Some(|motion, time| R::enter(Energy::<H, R, K> { motion, time }))
    } else {
        None
    }
}

/// An invariant of a state, computed in the scalar of its leaf.
fn invariant<H: System, K: Precision>(
    parameters: &H::Parameters<f64>,
    state: &Phase<Shaped<H, K>>,
    number: usize,
) -> f64 {
    if const { H::INVARIANTS.is_empty() } {
        return f64::NAN;
    }
    H::invariant::<K::Energy, f64>(&in_scalar::<H, K, K::Energy>(parameters, state), number).lane(0)
}

/// The first or the second part of all coordinates.
fn numbers<C: Coords>(state: &Phase<C>, part: usize) -> Phase<C::With<f64>> {
    let number = |leaf: C::Leaf| leaf.parts()[part];
    Phase { q: state.q.map(number), p: state.p.map(number) }
}

/// A motion at a state, in a scalar that energies of its leaf are computed in.
fn in_scalar<H: System, K: Precision, R: Real>(
    parameters: &H::Parameters<f64>,
    state: &Phase<Shaped<H, K>>,
) -> H::Motion<R, f64> {
    let value = numbers(state, 0);
    let carried = if R::LANES > 1 { Some(numbers(state, 1)) } else { None };
    let states = [&value, carried.as_ref().unwrap_or(&value)];
    H::Motion::<R, f64>::load(&[parameters; 2], &states)
}

struct Energy<'m, H: System, R: Real, K: Precision> {
    motion: &'m H::Motion<R, K>,
    time: f64,
}

impl<H: System, R: Real, K: Precision> Kernel for Energy<'_, H, R, K> {
    type Out = Parts;
    const APART: bool = H::ENERGIES_IN_LANES;

    #[inline(always)]
    fn call(self) -> Parts {
        let kinetic = H::kinetic::<R, K>(self.motion, self.time);
        let potential = H::potential::<R, K>(self.motion, self.time);
        let total = (kinetic + potential).lane(0);
        Parts { kinetic: kinetic.lane(0), potential: potential.lane(0), total, names: H::PARTS }
    }
}
