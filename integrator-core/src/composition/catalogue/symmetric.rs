//! Orders 4 to 10 for every `T(p)`, composed of steps of `Verlet`.

#[cfg(doc)]
use super::{BlanesMoan4, BlanesMoan6, Omelyan4, VelocityVerlet, Verlet};
use integrator_macros::composition;

composition! {
    /// The triple jump: [`Verlet`] over `g`, `1 - 2g` and `g` of the step, `g = 1/(2 - cbrt(2))`.
    ///
    /// Well known and cheap per step, but its middle stage goes back by 1.7 steps: [`Suzuki4`], [`BlanesMoan4`] and
    /// [`Omelyan4`] are far more accurate for the same work.
    #[doc(alias("Forest-Ruth", "Candy-Rozmus", "CandyRoz4", "ForestRuth", "triple jump", "Neri"))]
    pub struct Yoshida4: order 4, symmetric,
        citation "Forest and Ruth 1990, Physica D 43, 105; Yoshida 1990, Phys. Lett. A 150, 262"
    = triple_jump(Verlet);

    /// The triple jump of [`VelocityVerlet`]: [`Yoshida4`] with the parts exchanged.
    #[doc(alias("Candy-Rozmus"))]
    pub struct VelocityYoshida4: order 4, symmetric,
        citation "Forest and Ruth 1990, Physica D 43, 105; Yoshida 1990, Phys. Lett. A 150, 262"
    = triple_jump(VelocityVerlet);

    /// Suzuki's fractal: [`Verlet`] over `g`, `g`, `1 - 4g`, `g` and `g`, `g = 1/(4 - cbrt(4))`.
    ///
    /// No stage is longer than 0.66 steps, so it stays accurate where [`Yoshida4`] breaks down.
    #[doc(alias("SuzukiFractal"))]
    pub struct Suzuki4: order 4, symmetric,
        citation "Suzuki 1990, Phys. Lett. A 146, 319"
    = suzuki(Verlet);

    /// Five steps of [`Verlet`] with half the error of [`Suzuki4`].
    #[doc(alias("SS5"))]
    pub struct McLachlan4Ss5: order 4, symmetric,
        citation "McLachlan 1995, SIAM J. Sci. Comput. 16, 151"
    = symmetric(
        0.28,
        0.625466428467670045012338905492649013,
        _;
        Verlet
    );

    /// Yoshida's solution A: seven steps of [`Verlet`], the fewest that reach order 6.
    ///
    /// Methods with more stages take longer steps: [`BlanesMoan6`] needs half the work.
    #[doc(alias("Yoshida 6A", "SS7"))]
    pub struct Yoshida6: order 6, symmetric,
        citation "Yoshida 1990, Phys. Lett. A 150, 262"
    = symmetric(
        0.784513610477557263819497633866349876,
        0.235573213359358133684793182978534602,
        -1.17767998417887100694641568096431573,
        _;
        Verlet
    );

    /// Nine steps of [`Verlet`], order 6.
    #[doc(alias("s9odr6a", "KL6"))]
    pub struct KahanLi6: order 6, symmetric,
        citation "Kahan and Li 1997, Math. Comp. 66, 1089"
    = symmetric(
        0.392161444007314139279250557422671404,
        0.332599136789359438599748637500049647,
        -0.706246172557639359809964819549256459,
        0.0822135962935508002314904481020563311,
        _;
        Verlet
    );

    /// Nine steps of [`Verlet`], order 6, with a smaller error than [`KahanLi6`].
    #[doc(alias("SS9"))]
    pub struct McLachlan6: order 6, symmetric,
        citation "McLachlan 1995, SIAM J. Sci. Comput. 16, 151"
    = symmetric(
        0.1867,
        0.555497023712478399156913543628391201,
        0.129466948913475358056045209210204781,
        -0.843265623387734608549142781384814990,
        _;
        Verlet
    );

    /// Eleven steps of [`Verlet`], order 6.
    #[doc(alias("SS11"))]
    pub struct SofroniouSpaletta6S11: order 6, symmetric,
        citation "Sofroniou and Spaletta 2005, Optim. Methods Softw. 20, 597"
    = symmetric(
        0.213755839458782545555180669648569323,
        0.183293814074257139113859744252169946,
        0.176928194730989437948988117099290068,
        -0.443290826811702158496228296262583998,
        0.117285604328659353854035856691361047,
        _;
        Verlet
    );

    /// Thirteen steps of [`Verlet`], order 6: the best of order 6 that is composed of any symmetric base.
    #[doc(alias("SS13"))]
    pub struct SofroniouSpaletta6S13: order 6, symmetric,
        citation "Sofroniou and Spaletta 2005, Optim. Methods Softw. 20, 597"
    = symmetric(
        0.138619308540516952458080130426253538,
        0.133465628510747604070468588322092560,
        0.130705310114492251905427557850152043,
        0.129618937569070347725053665370911842,
        -0.350003248939208965161708309113225606,
        0.118055306530023871702734389540489755,
        _;
        Verlet
    );

    /// Fifteen steps of [`Verlet`], the fewest that reach order 8.
    #[doc(alias("McAte8", "SS15", "McLachlan1995SS15"))]
    pub struct SuzukiUmeno8: order 8, symmetric,
        citation "Suzuki and Umeno 1993, Springer Proc. Phys. 76, 74; McLachlan 1995, SIAM J. Sci. Comput. 16, 151"
    = symmetric(
        0.741670364350612953448227801783806316,
        -0.409100825800031593997300095893563417,
        0.190754710296238379953876256450371663,
        -0.573862471116082266656387726635535742,
        0.299064181303655923844463540688602988,
        0.334624918245298183784957979882182289,
        0.315293092396766596632056663811002431,
        _;
        Verlet
    );

    /// Seventeen steps of [`Verlet`], order 8.
    ///
    /// The best of order 8 for the energy on every `T`.
    #[doc(alias("s17odr8a", "KL8"))]
    pub struct KahanLi8: order 8, symmetric,
        citation "Kahan and Li 1997, Math. Comp. 66, 1089"
    = symmetric(
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

    /// Seventeen steps of [`Verlet`], order 8.
    ///
    /// As good as [`KahanLi8`]; better on eccentric orbits.
    #[doc(alias("SS17"))]
    pub struct McLachlan8: order 8, symmetric,
        citation "McLachlan 1995, SIAM J. Sci. Comput. 16, 151"
    = symmetric(
        0.128865979381443298969072164948453608,
        0.581514087105250962430242278203813691,
        -0.410175371469850137532406150089048660,
        0.185146935716587732653271949863489457,
        -0.409552343420851419339845173688909270,
        0.144405941080012041060075187156927749,
        0.278335500393679651309107062812417229,
        0.314956683916294857890281311972950882,
        _;
        Verlet
    );

    /// Twenty-one steps of [`Verlet`], order 8.
    ///
    /// The best of order 8 for trajectories on every `T`.
    #[doc(alias("SS21"))]
    pub struct SofroniouSpaletta8: order 8, symmetric,
        citation "Sofroniou and Spaletta 2005, Optim. Methods Softw. 20, 597"
    = symmetric(
        0.106477289845500318239319678548958515,
        0.108374086458357263974334105915459221,
        0.353378210526543424195345413240799340,
        -0.233414140231650821987802811283194796,
        -0.244452667915288412694621714132164173,
        0.113178484357556333147009525155989751,
        0.118929056250003500626929722839508474,
        0.126039123218259881403056702683646233,
        0.125817187361760418043923916415866222,
        0.116991350192176421807228814335329067,
        _;
        Verlet
    );

    /// Thirty-three steps of [`Verlet`], order 10.
    #[doc(alias("KL10"))]
    pub struct KahanLi10: order 10, symmetric,
        citation "Kahan and Li 1997, Math. Comp. 66, 1089"
    = symmetric(
        0.0904061936860727849216115009321603218,
        0.535918159530301202137849834402254495,
        0.351232575474939781875177357509412017,
        -0.311168020978158354260865436152122757,
        -0.525563141942635104310655492066121201,
        0.144479094102252476473456950882433335,
        0.0298358860974823581806408310014178787,
        0.177861799237398051335922384389565260,
        0.0982690693934163765253237718721641236,
        0.461799862104118608732421262875323617,
        -0.333778455998818513145318196284593283,
        0.0709568483652479362103115206193587611,
        0.236669600701268687719098193794445809,
        -0.497259779506609854450283876883036845,
        -0.303996166172372573465463557245579569,
        0.0524695718810006957452161236802525825,
        _;
        Verlet
    );

    /// Thirty-five steps of [`Verlet`], order 10.
    ///
    /// The one to choose for every `T` at tolerances of 1e-10 and below.
    #[doc(alias("SofSpa10", "SS35"))]
    pub struct SofroniouSpaletta10: order 10, symmetric,
        citation "Sofroniou and Spaletta 2005, Optim. Methods Softw. 20, 597"
    = symmetric(
        0.0787957225216864192639076793376842482,
        0.313096103415108527764812471926472697,
        0.0279183832350780661095202732752988231,
        -0.229592841593907094151213396796549876,
        0.130962061077164863174656859279605413,
        -0.269733405654510714344609732224111497,
        0.0749733431558914356661371056414104123,
        0.111993423999810204889575080736402059,
        0.366133449546226751193148123531499082,
        -0.399105630136035897878629810583404730,
        0.103087398527471077315802770013724479,
        0.411430873955890237820704118976078351,
        -0.00486636058313526176219565930997706302,
        -0.392033353708639906448081936426104270,
        0.0519425029624496470371829040159757277,
        0.0506650907599244963358743441568658942,
        0.0496743706397298790545688002794611763,
        _;
        Verlet
    );
}
