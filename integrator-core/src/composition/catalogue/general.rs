//! Orders 3 to 6 for every `T(p)`, optimised as sequences of drifts and kicks.

#[cfg(doc)]
use super::Verlet;
use integrator_macros::composition;

composition! {
    /// Ruth's step of order 3, with rational coefficients.
    ///
    /// Of historical interest, and an example of a step that is not time-reversible.
    pub struct Ruth3: order 3,
        citation "Ruth 1983, IEEE Trans. Nucl. Sci. 30, 2669"
    = V(7/24) T(2/3) V(3/4) T(-2/3) V(-1/24) T(1);

    /// The step of order 3 with the smallest error for three kicks.
    ///
    /// The best of order 3, stable far beyond [`Verlet`]; not time-reversible.
    #[doc(alias("McAte3"))]
    pub struct McLachlanAtela3: order 3,
        citation "McLachlan and Atela 1992, Nonlinearity 5, 541"
    = V(0.268330095781759924956955229925499140) T(0.919661523017399857050897638153382802)
        V(-0.187991618799159782007852868078881917) T(-0.187991618799159782007852868078881941)
        V(_) T(_);

    /// McLachlan's step of order 4 with five kicks, in closed form.
    ///
    /// The best of order 4 for every `T` at tolerances around 1e-3.
    #[doc(alias("S5", "McLachlan S m=5"))]
    pub struct McLachlan4: order 4, symmetric,
        citation "McLachlan 1995, SIAM J. Sci. Comput. 16, 151"
    = symmetric(
        V((14 - sqrt(19))/108) T(2/5)
        V((20 - 7*sqrt(19))/108) T(-1/10)
        V(_) T(_)
    );

    /// McLachlan's step of order 4 with four kicks, in closed form.
    ///
    /// One evaluation less than [`McLachlan4`]; better only where phase errors happen to cancel.
    #[doc(alias("S4", "McLachlan S m=4"))]
    pub struct McLachlan4S4: order 4, symmetric,
        citation "McLachlan 1995, SIAM J. Sci. Comput. 16, 151"
    = symmetric(
        V((642 + sqrt(471))/3924) T(6/11)
        V(121*(12 - sqrt(471))/3924) T(_) V(_)
    );

    /// Position-extended Forest–Ruth: four kicks.
    ///
    /// Widely used in molecular dynamics. [`Omelyan4`] is more accurate with one more evaluation.
    #[doc(alias("PEFRL", "position extended Forest-Ruth-like"))]
    pub struct Pefrl: order 4, symmetric,
        citation "Omelyan, Mryglod and Folk 2002, Comput. Phys. Commun. 146, 188"
    = symmetric(
        T(0.178617895844809068060904246197590706) V(0.712341831062605425480342912785941851)
        T(-0.0662645826698184883166709400757029859) V(_)
        T(_)
    );

    /// Velocity-extended Forest–Ruth: [`Pefrl`]'s companion that begins with a kick.
    #[doc(alias("VEFRL", "velocity extended Forest-Ruth-like"))]
    pub struct Vefrl: order 4, symmetric,
        citation "Omelyan, Mryglod and Folk 2002, Comput. Phys. Commun. 146, 188"
    = symmetric(
        V(0.164498651557575972259207449455094802) T(0.520943339103989879730756321624239195)
        V(1.23569265113891702205398751913379771) T(_)
        V(_)
    );

    /// Five kicks with the smallest error of order 4 for that many, beginning with a kick.
    ///
    /// The best of order 4 for the energy on every `T`.
    #[doc(alias("OMF4", "4MN5FV"))]
    pub struct Omelyan4: order 4, symmetric,
        citation "Omelyan, Mryglod and Folk 2003, Comput. Phys. Commun. 151, 272"
    = symmetric(
        V(0.0839831526287669393052899860437070735) T(0.253978510841059475836036519322644915)
        V(0.682236533571909094997844150584287244) T(-0.0323028676526996731898102783632055740)
        V(_) T(_)
    );

    /// [`Omelyan4`]'s companion that begins with a drift.
    #[doc(alias("4MN5FP"))]
    pub struct PositionOmelyan4: order 4, symmetric,
        citation "Omelyan, Mryglod and Folk 2003, Comput. Phys. Commun. 151, 272"
    = symmetric(
        T(0.275008121233241918137930574334784112) V(-0.0844296195070715117777321292392824362)
        T(-0.134795009910679205362037911535085813) V(0.354900057157426010568379021000493958)
        T(_) V(_)
    );

    /// Six kicks with the smallest error of order 4 for every `T`.
    ///
    /// The one to choose of order 4 where `T` is not quadratic.
    #[doc(alias("BM4", "S6", "BlanesMoan2002S6"))]
    pub struct BlanesMoan4: order 4, symmetric,
        citation "Blanes and Moan 2002, J. Comput. Appl. Math. 142, 313"
    = symmetric(
        V(0.0792036964311956741976496237630977485) T(0.209515106613362052972449986093565479)
        V(0.353172906049774036818665557303204203) T(-0.143851773179818037964096299232667872)
        V(-0.0420650803577195292151715808766370620) T(_)
        V(_)
    );

    /// Ten kicks, order 6 for every `T`.
    ///
    /// The one to choose for every `T` between tolerances of 1e-3 and 1e-8.
    #[doc(alias("BM6", "S10", "BlanesMoan2002S10"))]
    pub struct BlanesMoan6: order 6, symmetric,
        citation "Blanes and Moan 2002, J. Comput. Appl. Math. 142, 313"
    = symmetric(
        V(0.0502627644003927227646350170890431145) T(0.148816447901043280457338250393514676)
        V(0.413514300428343477454136714832912846) T(-0.132385865767783756149346965946034103)
        V(0.0450798897943981114898610845310218159) T(0.0673076046921843992407714858521469515)
        V(-0.188054853819568618490425283066760972) T(0.432666402578173711633583314086173416)
        V(0.541960678450780012366892191783226417) T(_)
        V(_)
    );

    /// Nine kicks, order 6 for every `T`.
    ///
    /// Slightly less accurate than [`BlanesMoan6`], with one evaluation less per step.
    pub struct Teloy6A: order 6, symmetric,
        citation "E. Teloy, in Schlier and Seiter 2000, Comput. Phys. Commun. 130, 176"
    = symmetric(
        T(0.0951762545417740526774611433551934199) V(0.666296893997707801342074989071680682)
        T(-0.127950285523686779412191916214294115) V(0.0246189009521050871307843030871306174)
        T(0.105972953453251131437935876087169983) V(-0.410725533617951132319928739181990247)
        T(0.448222276600827484168516341865612011) V(0.657729262050913177689351300093390421)
        T(_) V(_)
    );
}
