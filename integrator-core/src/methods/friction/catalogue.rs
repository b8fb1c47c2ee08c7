//! Compositions with friction: splittings of Langevin dynamics.

use integrator_macros::composition;

composition! {
    /// Kick, drift, friction, drift, kick: the default for systems with friction.
    ///
    /// For a harmonic oscillator the positions in equilibrium have no error at any stable step. For other potentials their error
    /// is of order two, and of order four where the friction is strong.
    #[doc(alias("Langevin", "BAOAB", "VRORV"))]
    pub struct Baoab: order 2, symmetric,
        citation "Leimkuhler and Matthews 2013, Appl. Math. Res. Express 2013, 34"
    = V(1/2) T(1/2) O(1) T(1/2) V(1/2);

    /// Drift, kick, friction, kick, drift.
    #[doc(alias("ABOBA", "RVOVR"))]
    pub struct Aboba: order 2, symmetric,
        citation "Leimkuhler and Matthews 2013, Appl. Math. Res. Express 2013, 34"
    = T(1/2) V(1/2) O(1) V(1/2) T(1/2);

    /// Friction, a step of velocity Verlet, friction.
    ///
    /// Its error is in the positions rather than in the momenta.
    #[doc(alias("OBABO", "OVRVO", "Bussi-Parrinello"))]
    pub struct Obabo: order 2, symmetric,
        citation "Bussi and Parrinello 2007, Phys. Rev. E 75, 056707"
    = O(1/2) V(1/2) T(1) V(1/2) O(1/2);

    /// Kick, drift, friction, drift: friction in the middle of the drift.
    ///
    /// The states are those of [`Baoab`] half a kick earlier, so that the positions have the same distribution. Momenta are
    /// half a kick away from the positions, hence the order 1. The step of `LangevinMiddleIntegrator` in `OpenMM` and of `sd` in
    /// GROMACS.
    #[doc(alias("BAOA", "LFMiddle", "GSD"))]
    pub struct Baoa: order 1,
        citation "Zhang, Liu, Yan, Tuckerman and Liu 2019, J. Phys. Chem. A 123, 6056"
    = V(1) T(1/2) O(1) T(1/2);
}
