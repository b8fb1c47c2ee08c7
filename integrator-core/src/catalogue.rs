//! The compositions of this crate, cheapest first in each order.
//!
//! Each is declared by its coefficients and proved by `composition!` when this crate compiles. Coefficients without a
//! closed form are given to 36 digits, and one of them as `_`, so that consistency holds by construction.

use integrator_macros::composition;

composition! {
    /// Symplectic Euler: kick, then drift with the new momentum.
    ///
    /// The simplest symplectic step (de Vogelaere 1956). For teaching and for building blocks: `Verlet` costs the same.
    pub struct Euler: order 1 = V(1) T(1);

    /// The adjoint of [`Euler`]: drift, then kick at the new position.
    pub struct EulerAdjoint: order 1 = T(1) V(1);

    /// Störmer–Verlet, also called leapfrog: drift, kick, drift.
    ///
    /// Verlet 1967, Strang 1968. The largest stable step per force evaluation of all, `h ω < 2`: the one to choose at
    /// loose tolerances and for very long runs of stiff systems.
    pub struct Verlet: order 2, symmetric = T(1/2) V(1) T(1/2);

    /// Velocity Verlet: kick, drift, kick.
    ///
    /// As [`Verlet`] with the parts exchanged. It evaluates the force at the ends of the steps, where output is.
    pub struct VelocityVerlet: order 2, symmetric = V(1/2) T(1) V(1/2);

    /// Ruth's step of order 3.
    ///
    /// Ruth 1983. Of historical interest, and as an example of a step that is not time-reversible.
    pub struct Ruth3: order 3 = V(7/24) T(2/3) V(3/4) T(-2/3) V(-1/24) T(1);

    /// The triple jump of order 4: `Verlet` over `g`, `1 - 2g` and `g` of the step, `g = 1/(2 - cbrt(2))`.
    ///
    /// Forest and Ruth 1990, Suzuki 1990, Yoshida 1990. Well known and cheap per step, but its middle stage goes back
    /// by 1.7 steps: [`Suzuki4`] is more accurate for the same number of force evaluations.
    pub struct Yoshida4: order 4, symmetric = triple_jump(Verlet);

    /// Suzuki's fractal of order 4: `Verlet` over `g`, `g`, `1 - 4g`, `g` and `g`, `g = 1/(4 - cbrt(4))`.
    ///
    /// Suzuki 1990. No stage is longer than 0.66 steps, so it stays accurate where [`Yoshida4`] breaks down.
    pub struct Suzuki4: order 4, symmetric = suzuki(Verlet);

    /// Yoshida's solution A of order 6, seven stages.
    ///
    /// Yoshida 1990. The fewest force evaluations per step at order 6; methods with more stages take longer steps.
    pub struct Yoshida6: order 6, symmetric = symmetric(
        0.784513610477557263819497633866349876,
        0.235573213359358133684793182978534602,
        -1.17767998417887100694641568096431573,
        _;
        Verlet
    );

    /// Kahan and Li's composition of order 8, seventeen stages.
    ///
    /// Kahan and Li 1997 (s17odr8a). Among the best of order 8 for every `T`, best for the energy at tight tolerances.
    pub struct KahanLi8: order 8, symmetric = symmetric(
        0.130202483088890080878817632096700522,
        0.561162981775108384561964407700150567,
        -0.389474962644847286408078598235248389,
        0.158841906555155600896210745707152481,
        -0.395903894133237577336231539347938936,
        0.184539640978315707091832541533375463,
        0.258374387686322047293979109994939472,
        0.295011723609310298870966240218228113,
        _;
        Verlet
    );
}
