//! The measurements of a certificate without types: all that is compiled for a system, a method, a start and a step is
//! under one trait.

use crate::{
    check::{
        CheckError,
        oracle::exact::{Stepper, Steps},
        property::{
            agreement::Stated,
            energies::Energies,
            energy::{EnergyDrift, energy_drift},
            invariants::{Strayed, strayed},
            jumps::{Jump, jump_between},
            reversibility::{RoundTrip, round_trip},
            stability::{Stability, nearness},
            symplecticity::{Defect, defect},
        },
        start::Start,
        statistics::points::{self, plain, run},
    },
    error::Error,
    hamiltonian::Hamiltonian,
    state::{
        flat::{Flat, flat, shaped},
        precision::Precision,
    },
    system::Shaped,
    trajectory::{method::Method, run::Run},
};

/// The number of steps between two states that jumps are looked for between.
const BETWEEN: u64 = 4;

/// The measurements of all checks.
pub(crate) trait Measurable {
    /// The name of the system.
    fn system(&self) -> &'static str;

    /// Returns the method of the system.
    fn stepper(&self) -> &dyn Stepper;

    /// Returns the energies and flows of the system beside the user's own functions.
    fn stated(&self) -> &dyn Stated;

    /// Whether a run may begin at a state.
    fn begin(&self, state: &Flat, time: f64) -> Result<(), Error>;

    /// The defect of one step.
    fn defect(&self) -> Result<Defect, CheckError>;

    /// The round trip in this number of steps of `h` each way.
    fn round_trip(&self, h: f64, steps: u64) -> Result<RoundTrip, CheckError>;

    /// The drift of the energy over `steps` steps of `h`.
    fn energy_drift(&self, h: f64, steps: u64) -> Result<EnergyDrift, CheckError>;

    /// The first jump of an energy in this number of steps of `h`, or in those before the state diverges: an unstable
    /// motion that follows its equations until then is no reason to refuse a certificate.
    fn jump(&self, h: f64, steps: u64) -> Result<Option<Jump>, CheckError>;

    /// The deviation of invariants in this number of steps of `h`.
    fn strayed(&self, h: f64, steps: u64) -> Result<Strayed, CheckError>;

    /// The stability of the steps beside the `limit`.
    fn stability(&self, limit: f64) -> Result<Stability, CheckError>;
}

/// A system, a method, a start and a step.
pub(crate) struct Measured<'s, H: Hamiltonian, X, K: Precision> {
    pub(crate) system: &'s H,
    pub(crate) method: X,
    pub(crate) start: &'s Start<Shaped<H, K>>,
    pub(crate) h: f64,
    pub(crate) energies: Energies<'s, H>,
    pub(crate) steps: Steps<'s, H, X>,
}

impl<H: Hamiltonian, X: Method<H>, K: Precision> Measurable for Measured<'_, H, X, K> {
    fn system(&self) -> &'static str {
        std::any::type_name::<H>()
    }

    fn stepper(&self) -> &dyn Stepper {
        &self.steps
    }

    fn stated(&self) -> &dyn Stated {
        &self.energies
    }

    fn begin(&self, state: &Flat, time: f64) -> Result<(), Error> {
        let start = shaped(self.energies.shape, state).at_time(time);
        points::begin::<H, X, f64>(self.system, self.method, &start, 1.0)?;
        Ok(())
    }

    fn defect(&self) -> Result<Defect, CheckError> {
        let defect = defect::<H, X, K>(self.system, self.method, self.start, self.h, 1)?;
        if defect.size.is_nan() {
            // A step that leaves the numbers says where it does.
            run::<H, X, K>(self.system, self.method, self.start, self.h)?.advance(1)?;
            return Err(CheckError::NotFinite { what: "the derivative of a step by its start" });
        }
        Ok(defect)
    }

    fn round_trip(&self, h: f64, steps: u64) -> Result<RoundTrip, CheckError> {
        round_trip::<H, X, K>(self.system, self.method, self.start, h, steps)
    }

    fn energy_drift(&self, h: f64, steps: u64) -> Result<EnergyDrift, CheckError> {
        energy_drift::<H, X, K>(self.system, self.method, self.start, h, steps)
    }

    fn jump(&self, h: f64, steps: u64) -> Result<Option<Jump>, CheckError> {
        let mut run = run::<H, X, K>(self.system, self.method, self.start, h)?;
        let here = |run: &Run<Shaped<H, K>>| flat(&plain::<H, K>(&run.state()));
        let mut before = here(&run);
        for _ in 0..steps / BETWEEN {
            let time = run.time();
            match run.advance(BETWEEN) {
                Err(Error::Diverged(_)) if run.steps() > 0 => break,
                advanced => advanced?,
            }
            let state = here(&run);
            if let Some(jump) = jump_between(&self.energies, [&before, &state], time) {
                return Ok(Some(jump));
            }
            before = state;
        }
        Ok(None)
    }

    fn strayed(&self, h: f64, steps: u64) -> Result<Strayed, CheckError> {
        if const { H::INVARIANTS.is_empty() } {
            return Ok(Strayed { deviations: Vec::new(), steps: 0, rounding: 0.0 });
        }
        strayed::<H, X, K>(self.system, self.method, self.start, h, steps)
    }

    fn stability(&self, limit: f64) -> Result<Stability, CheckError> {
        nearness::<H, X, K>(self.system, self.method, limit, self.start, self.h)
    }
}
