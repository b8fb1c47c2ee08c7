//! The one list of the compositions in the catalogue, for visitors and for tests; a test holds it against the sources.

/// Calls a macro with the compositions of the catalogue: those for every `T`, without a processor or with one, those for
/// quadratic `T`, those that keep their orders where the second part is a symmetric pair, and those whose orders count
/// where the second part is small, of both classes. For tests of what follows from the kind of stages, some of each kind.
macro_rules! for_each_composition {
    (general: $each:ident!) => {
        for_each_composition!(unprocessed: $each!);
        for_each_composition!(processed: $each!);
    };
    (unprocessed: $each:ident!) => {
        $each!(Euler EulerAdjoint Verlet VelocityVerlet McLachlanAtela2 McLachlan2 VelocityMcLachlan2);
        $each!(Ruth3 McLachlanAtela3 McLachlan4 McLachlan4S4 Pefrl Vefrl Omelyan4 PositionOmelyan4);
        $each!(BlanesMoan4 BlanesMoan6 Teloy6A Yoshida4 VelocityYoshida4 Suzuki4 McLachlan4Ss5);
        $each!(Yoshida6 KahanLi6 McLachlan6 SofroniouSpaletta6S11 SofroniouSpaletta6S13);
        $each!(SuzukiUmeno8 KahanLi8 McLachlan8 SofroniouSpaletta8 KahanLi10 SofroniouSpaletta10);
        // Proved for every `T`, though at their best where it is quadratic.
        $each!(McLachlan4Sb3a BlanesMoanSrkn6);
    };
    (processed: $each:ident!) => {
        $each!(BlanesCasasMurua6S11 BlanesCasasMurua6S13 BlanesCasasMurua8);
    };
    (pairs: $each:ident!) => {
        $each!(Euler EulerAdjoint Verlet McLachlanAtela2 McLachlan2 Yoshida4 Suzuki4 McLachlan4Ss5);
        $each!(Yoshida6 KahanLi6 McLachlan6 SofroniouSpaletta6S11 SofroniouSpaletta6S13);
        $each!(SuzukiUmeno8 KahanLi8 McLachlan8 SofroniouSpaletta8 KahanLi10 SofroniouSpaletta10);
        $each!(BlanesCasasMurua6S11 BlanesCasasMurua6S13 BlanesCasasMurua8);
        $each!(Saba2 Saba3 Saba4 Abah844 Abah864 Abah1064);
        $each!(WisdomHolmanTouma3 WisdomHolmanTouma5 WisdomHolmanTouma7 WisdomHolmanTouma11 WisdomHolmanTouma17);
    };
    (quadratic: $each:ident!) => {
        $each!(McLachlanAtela4 CalvoSanzSerna4 McLachlanAtela5 Omelyan6 Teloy6B BlanesMoanSrkn11 BlanesMoanSrkn14);
        $each!(BlanesCasasEscorihuela8 Teloy8A Teloy8B Teloy8C);
        // With force gradients.
        $each!(Chin4A Chin4B Chin4C Chin4D Schaefers4 Schaefers6 TakahashiImada4 BlanesCasasRos6);
    };
    // One stage of each part, ends that merge, ends that do not, kicks or drifts first, long steps, processors.
    (general_kinds: $each:ident!) => {
        $each!(Euler EulerAdjoint Verlet VelocityVerlet Ruth3 VelocityYoshida4 KahanLi8 BlanesCasasMurua6S11);
    };
    // Force gradients at the ends, in the middle and everywhere, and processors.
    (quadratic_kinds: $each:ident!) => {
        $each!(BlanesMoanSrkn11 Teloy8A Chin4A Chin4C TakahashiImada4 BlanesCasasEscorihuela8);
    };
    (near_integrable: $each:ident!) => {
        for_each_composition!(near_integrable_general: $each!);
        for_each_composition!(near_integrable_quadratic: $each!);
    };
    (near_integrable_general: $each:ident!) => {
        for_each_composition!(near_integrable_unprocessed: $each!);
        for_each_composition!(near_integrable_processed: $each!);
    };
    (near_integrable_unprocessed: $each:ident!) => {
        $each!(Saba2 Saba3 Saba4 Sbab2 Sbab3 Sbab4 Aba84 Aba104 Aba864 Aba1064 Abah844 Abah864 Abah1064);
    };
    (near_integrable_processed: $each:ident!) => {
        $each!(BlanesCasasRos764);
        $each!(WisdomHolmanTouma3 WisdomHolmanTouma5 WisdomHolmanTouma7 WisdomHolmanTouma11 WisdomHolmanTouma17);
    };
    (near_integrable_quadratic: $each:ident!) => {
        // With force gradients.
        $each!(Sabac2 Sabac3 Sabac4 Sbabc2 Sbabc3 Sbabc4);
    };
}
pub(crate) use for_each_composition;
