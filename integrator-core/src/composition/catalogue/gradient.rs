//! Force gradients, for `T` quadratic in `p`: kicks along the gradient of `|∇V|²`, exact and symplectic.

#[cfg(doc)]
use super::Verlet;
use integrator_macros::composition;

composition! {
    /// Two kicks, all stages forward.
    ///
    /// The best without a processor for gravity; forward steps suit problems that forbid negative ones.
    #[doc(alias("Suzuki-Chin"))]
    pub struct Chin4A: order 4, symmetric,
        citation "Chin 1997, Phys. Lett. A 226, 344"
    = symmetric(V(1/6) T(1/2) V(2/3, -1/72));

    /// Two kicks, both with a gradient, all stages forward.
    pub struct Chin4B: order 4, symmetric,
        citation "Chin 1997, Phys. Lett. A 226, 344"
    = symmetric(
        T((1 - 1/sqrt(3))/2) V(1/2, -(2 - sqrt(3))/48) T(_)
    );

    /// Three kicks, one with a gradient, all stages forward.
    pub struct Chin4C: order 4, symmetric,
        citation "Chin 1997, Phys. Lett. A 226, 344"
    = symmetric(T(1/6) V(3/8) T(1/3) V(1/4, -1/192));

    /// Three kicks, of which those at the ends of a step have gradients; all stages forward.
    pub struct Chin4D: order 4, symmetric,
        citation "Chin and Chen 2002, J. Chem. Phys. 117, 1409"
    = symmetric(V(1/8, -1/384) T(1/3) V(3/8) T(_));

    /// Five kicks, two with a gradient: the smallest error of order 4 among force gradients.
    #[doc(alias("ABADABADABA"))]
    pub struct Schaefers4: order 4, symmetric,
        citation "Schäfers, Finkenrath, Günther and Knechtli 2024, arXiv:2403.10370"
    = symmetric(
        T(0.0627026440982102483890487664979019794) V(0.149293739165426838593439170244414563)
        T(0.193174566017779984450281720717341099)
        V(0.220105234408407104984076492536398811, -0.000966194415593917910081224331746757115)
        T(_) V(_)
    );

    /// Five kicks, all with a gradient, order 6.
    #[doc(alias("ADADADADADA"))]
    pub struct Schaefers6: order 6, symmetric,
        citation "Schäfers, Finkenrath, Günther and Knechtli 2024, arXiv:2403.10370"
    = symmetric(
        T(0.109534125980058396078943006142943462)
        V(0.268835839917652703660249892842961220, -0.000806354602850071224327324444994368117)
        T(0.426279051773841240889970350913515613)
        V(0.529390037396794243340386060403887517, -0.00766260151736356133883800459778863576)
        T(_) V(_, 0.0116272061423963872647616792889079618)
    );

    /// [`Verlet`] with a gradient in its kick, processed to order 4.
    ///
    /// The cheapest step of order 4, for the energy at loose tolerances.
    #[doc(alias("Rowlands", "PMLF4"))]
    pub struct TakahashiImada4: order 4,
        citation "Takahashi and Imada 1984, J. Phys. Soc. Jpn. 53, 3765"
    = processed(
        V(0.185935399684605464415966643791607204) T(0.874930615595543534033796586897314284)
        V(0.0731969797858114490791129837957051183) T(-0.237106680151021920477108226727481495)
        V(-0.157662426929808107551937572778690459) T(-0.536353982903912807613546305361210926);
        symmetric(
            T(_) V(_, -0.0416666666666666666666666666666666667)
        )
    );

    /// Three kicks, one with a gradient, processed to order 6.
    ///
    /// The best of all for quadratic `T` between tolerances of 1e-5 and 1e-9, where output is rare.
    #[doc(alias("PMLF6"))]
    pub struct BlanesCasasRos6: order 6,
        citation "Blanes, Casas and Ros 1999, SIAM J. Sci. Comput. 21, 711"
    = processed(
        T(0.0794328824245542855005086837736158473)
        V(1.35994244874552626649765038641786734, 0.0348412280749949846350754150245172094)
        T(0.0297482916946766139720169746659345225)
        V(-0.650597374753513338200629839802877837, -0.0316756720975253042384882733096841007)
        T(-0.705707496481589535234119335892321435)
        V(-0.0335428145983383718278483810596915411, 0.00566105467771189267407803232619959766)
        T(0.319042345126083905282135797450370653)
        V(-0.0401299152751149894566736425603892698, -0.00426222226902366378393575777018544211)
        T(-0.286914733429964655661147532420025696) V(0.0445797298099032194972792363689292049, -0.005)
        T(0.564398710666239512203482932510935130) V(-0.680252073928462660446900239275328872, 0.005);
        symmetric(
            T(-0.0682610383918630127145317447853268053) V(0.262112935251702805434372890089156319)
            T(_) V(_, -0.0164011128160783278247123891080082777)
        )
    );
}
