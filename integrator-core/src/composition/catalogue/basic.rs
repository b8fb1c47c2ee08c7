//! Orders 1 and 2: the steps from which others are built.

use integrator_macros::composition;

composition! {
    /// Symplectic Euler: kick, then drift with the new momentum.
    ///
    /// The simplest symplectic step, for teaching and as a building block: [`Verlet`] costs the same.
    #[doc(alias("symplectic Euler", "semi-implicit Euler"))]
    pub struct Euler: order 1,
        citation "de Vogelaere 1956, University of Notre Dame report 4"
    = V(1) T(1);

    /// The adjoint of [`Euler`]: drift, then kick at the new position.
    #[doc(alias("Lie-Trotter"))]
    pub struct EulerAdjoint: order 1,
        citation "de Vogelaere 1956, University of Notre Dame report 4"
    = T(1) V(1);

    /// Störmer–Verlet: drift, kick, drift.
    ///
    /// No other composition takes longer steps per force evaluation: the one to choose at loose tolerances.
    #[doc(alias("leapfrog", "position Verlet", "VerletLeapfrog", "Strang"))]
    pub struct Verlet: order 2, symmetric,
        citation "Strang 1968, SIAM J. Numer. Anal. 5, 506"
    = T(1/2) V(1) T(1/2);

    /// Velocity Verlet: kick, drift, kick.
    ///
    /// [`Verlet`] with the parts exchanged.
    #[doc(alias("leapfrog", "PseudoVerletLeapfrog"))]
    pub struct VelocityVerlet: order 2, symmetric,
        citation "Verlet 1967, Phys. Rev. 159, 98"
    = V(1/2) T(1) V(1/2);

    /// The step of order 2 with the smallest error for two kicks that are not symmetric.
    #[doc(alias("McAte2"))]
    pub struct McLachlanAtela2: order 2,
        citation "McLachlan and Atela 1992, Nonlinearity 5, 541"
    = V(1 - 1/sqrt(2)) T(1/sqrt(2)) V(1/sqrt(2)) T(_);

    /// Two kicks, with the smallest error of order 2.
    ///
    /// The best of order 2: a tenth of the error of [`Verlet`] for twice the work. Its free coefficient is the one with
    /// the least norm of the leading error.
    #[doc(alias("minimum norm", "2MN", "OMF2"))]
    pub struct McLachlan2: order 2, symmetric,
        citation "McLachlan 1995, SIAM J. Sci. Comput. 16, 151"
    = symmetric(
        T(1/2 - cbrt(2*sqrt(326) + 36)/12 + 1/(6*cbrt(2*sqrt(326) + 36)))
        V(1/2) T(_)
    );

    /// [`McLachlan2`] with the parts exchanged: the form for systems with a cheap drift.
    #[doc(alias("2MN velocity"))]
    pub struct VelocityMcLachlan2: order 2, symmetric,
        citation "McLachlan 1995, SIAM J. Sci. Comput. 16, 151"
    = symmetric(
        V(1/2 - cbrt(2*sqrt(326) + 36)/12 + 1/(6*cbrt(2*sqrt(326) + 36)))
        T(1/2) V(_)
    );
}
