//! Compositions written by hand that claim what they are not.

use integrator_core::{__private::*, Verlet};

/// Writes a composition from its table.
macro_rules! by_hand {
    ($(#[$attribute:meta])* $name:ident, order $order:literal, symmetric = $symmetric:literal, $stages:expr) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Default)]
        pub(crate) struct $name;

        impl Scheme for $name {
            const NAME: &'static str = stringify!($name);
            const ORDER: u32 = $order;
            const SYMMETRIC: bool = $symmetric;
            const CLASS: Class = Class::General;
            const CITATION: &'static str = "";
            const FORCE_EVALUATIONS: usize = Self::STAGES.cycle.len();
            const GRADIENT_EVALUATIONS: usize = 0;
            const STABILITY_LIMIT: f64 = 2.0;
            const LEADING_ERROR: Option<f64> = None;
            const STAGES: Stages = $stages;
        }
        impl<H: Hamiltonian> Composition<H> for $name {}
    };
}

/// A drift, then a kick.
const fn stage(drift: f64, kick: f64, drift_time: f64, kick_time: f64) -> Stage {
    Stage { drift, kick, drift_time, kick_time, ..Stage::NONE }
}

/// `T(1) V(1)`.
const EULER: Stages = Stages {
    lead: Lead::Drift,
    opening: stage(1.0, 1.0, 0.0, 1.0),
    cycle: &[stage(1.0, 1.0, 0.0, 1.0)],
    closing: Stage::NONE,
};

by_hand! {
    /// WRONG: `T(1) V(1)` is of order 1.
    EulerThatClaims2, order 2, symmetric = false, EULER
}

by_hand! {
    /// WRONG: `T(1) V(1)` is not symmetric.
    EulerThatClaimsSymmetry, order 1, symmetric = true, EULER
}

by_hand! {
    /// WRONG: `T(1/4) V(1) T(3/4)`.
    Lopsided, order 1, symmetric = true, Stages {
        lead: Lead::Drift,
        opening: stage(0.25, 1.0, 0.0, 0.25),
        cycle: &[stage(1.0, 1.0, 0.0, 0.25)],
        closing: stage(0.75, 0.0, 1.0, 0.0),
    }
}

by_hand! {
    /// WRONG: `T(1/2) V(1.001) T(1/2)` follows a stronger force: symmetric, symplectic, and of no order at all.
    Strong, order 2, symmetric = true, Stages {
        lead: Lead::Drift,
        opening: stage(0.5, 1.001, 0.0, 0.5),
        cycle: &[stage(1.0, 1.001, 0.0, 0.5)],
        closing: stage(0.5, 0.0, 1.0, 0.0),
    }
}

by_hand! {
    /// WRONG: `T(1/2) V(1) T(1/2)` whose kick reads the time at the end of the step instead of its middle.
    Late, order 2, symmetric = true, Stages {
        lead: Lead::Drift,
        opening: stage(0.5, 1.0, 0.0, 1.0),
        cycle: &[stage(1.0, 1.0, 0.0, 1.0)],
        closing: stage(0.5, 0.0, 1.0, 0.0),
    }
}

by_hand! {
    /// WRONG: half a drift is lost between steps, because the last stage and the next first one were not merged.
    Unmerged, order 2, symmetric = true, Stages {
        lead: Lead::Drift,
        opening: stage(0.5, 1.0, 0.0, 0.5),
        cycle: &[stage(0.5, 1.0, 0.0, 0.5)],
        closing: stage(0.5, 0.0, 1.0, 0.0),
    }
}

/// Writes a composition with the table of Verlet, whose kicks are longer by a power of their length than the table says.
macro_rules! beside_the_table {
    ($(#[$attribute:meta])* $name:ident, $power:literal) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Default)]
        pub(crate) struct $name;

        impl Scheme for $name {
            const NAME: &'static str = stringify!($name);
            const ORDER: u32 = Verlet::ORDER;
            const SYMMETRIC: bool = true;
            const CLASS: Class = Class::General;
            const CITATION: &'static str = "";
            const FORCE_EVALUATIONS: usize = Verlet::FORCE_EVALUATIONS;
            const GRADIENT_EVALUATIONS: usize = 0;
            const STABILITY_LIMIT: f64 = 2.0;
            const LEADING_ERROR: Option<f64> = None;
            const STAGES: Stages = Verlet::STAGES;
        }
        impl<H: Hamiltonian> Composition<H> for $name {
            fn kick(flows: &mut impl Flows<H>, stage: &Stage, h: f64, time: f64) {
                flows.kick(h * stage.kick * (1.0 + h.powi($power)), time + h * stage.kick_time);
            }
        }
    };
}

beside_the_table! {
    /// WRONG: Verlet whose kicks are longer by the square of the step: still symplectic, symmetric and of order 2.
    LongBySquares, 2
}

beside_the_table! {
    /// WRONG: the same by the fourth power.
    LongByFourthPowers, 4
}
