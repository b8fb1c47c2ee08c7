//! Compositions for Hamiltonians `A + ε B` with a small second part: planets about a star, oscillators with a small
//! coupling. Drifts are the flow of the large part, which is solved exactly, and kicks that of the small one.
//!
//! With generalised order `(n₁, n₂, …)` the error is `ε h^n₁ + ε² h^n₂ + …`, so that for a small `ε` few kicks bring the
//! accuracy of order `n₁`. On Hamiltonians without a small part they are compositions of their last order like others.
//! `Saba1` would be [`Verlet`], and `Sbab1` would be [`VelocityVerlet`](super::VelocityVerlet).

#[cfg(doc)]
use super::Verlet;
use integrator_macros::composition;

composition! {
    /// SABA2: the two kicks of Gauss-Legendre quadrature.
    pub struct Saba2: order (4, 2), symmetric,
        citation "McLachlan 1995, BIT 35, 258"
    = symmetric(A((1 - 1/sqrt(3))/2) B(1/2) A(_));

    /// SABA3: the three kicks of Gauss-Legendre quadrature.
    pub struct Saba3: order (6, 2), symmetric,
        citation "McLachlan 1995, BIT 35, 258"
    = symmetric(A((1 - sqrt(3/5))/2) B(5/18) A(sqrt(3/5)/2) B(_));

    /// SABA4: the four kicks of Gauss-Legendre quadrature.
    pub struct Saba4: order (8, 2), symmetric,
        citation "McLachlan 1995, BIT 35, 258"
    = symmetric(A((1 - sqrt((3 + 2*sqrt(6/5))/7))/2) B((18 - sqrt(30))/72)
        A((sqrt((3 + 2*sqrt(6/5))/7) - sqrt((3 - 2*sqrt(6/5))/7))/2) B(_) A(_));

    /// SBAB2: the 3 kicks of Gauss-Lobatto quadrature, 2 of them a step.
    pub struct Sbab2: order (4, 2), symmetric,
        citation "Laskar and Robutel 2001, Celestial Mechanics and Dynamical Astronomy 80, 39"
    = symmetric(B(1/6) A(1/2) B(_));

    /// SBAB3: the 4 kicks of Gauss-Lobatto quadrature, 3 of them a step.
    pub struct Sbab3: order (6, 2), symmetric,
        citation "Laskar and Robutel 2001, Celestial Mechanics and Dynamical Astronomy 80, 39"
    = symmetric(B(1/12) A((1 - 1/sqrt(5))/2) B(5/12) A(_));

    /// SBAB4: the 5 kicks of Gauss-Lobatto quadrature, 4 of them a step.
    pub struct Sbab4: order (8, 2), symmetric,
        citation "Laskar and Robutel 2001, Celestial Mechanics and Dynamical Astronomy 80, 39"
    = symmetric(B(1/20) A((1 - sqrt(3/7))/2) B(49/180) A(_) B(_));

    /// SABAC2: [`Saba2`] between two kicks along the gradient of the squared force, which cancel the error of second
    /// order in the small part.
    pub struct Sabac2: order (4, 4), symmetric,
        citation "Laskar and Robutel 2001, Celestial Mechanics and Dynamical Astronomy 80, 39"
    = symmetric(B(0, -(2 - sqrt(3))/48) A((1 - 1/sqrt(3))/2) B(1/2) A(_));

    /// SABAC3: [`Saba3`] between two kicks along the gradient of the squared force, which cancel the error of second
    /// order in the small part.
    pub struct Sabac3: order (6, 4), symmetric,
        citation "Laskar and Robutel 2001, Celestial Mechanics and Dynamical Astronomy 80, 39"
    = symmetric(B(0, -(54 - 13*sqrt(15))/1296) A((1 - sqrt(3/5))/2) B(5/18) A(sqrt(3/5)/2) B(_));

    /// SABAC4: [`Saba4`] between two kicks along the gradient of the squared force, which cancel the error of second
    /// order in the small part.
    pub struct Sabac4: order (8, 4), symmetric,
        citation "Laskar and Robutel 2001, Celestial Mechanics and Dynamical Astronomy 80, 39"
    = symmetric(B(0, -0.0016983875241043006657660788917460719)
        A((1 - sqrt((3 + 2*sqrt(6/5))/7))/2) B((18 - sqrt(30))/72)
        A((sqrt((3 + 2*sqrt(6/5))/7) - sqrt((3 - 2*sqrt(6/5))/7))/2) B(_) A(_));

    /// SBABC2: [`Sbab2`] with the same correction in its outer kicks.
    pub struct Sbabc2: order (4, 4), symmetric,
        citation "Laskar and Robutel 2001, Celestial Mechanics and Dynamical Astronomy 80, 39"
    = symmetric(B(1/6, -1/144) A(1/2) B(_));

    /// SBABC3: [`Sbab3`] with the same correction in its outer kicks.
    pub struct Sbabc3: order (6, 4), symmetric,
        citation "Laskar and Robutel 2001, Celestial Mechanics and Dynamical Astronomy 80, 39"
    = symmetric(B(1/12, -(13 - 5*sqrt(5))/576) A((1 - 1/sqrt(5))/2) B(5/12) A(_));

    /// SBABC4: [`Sbab4`] with the same correction in its outer kicks.
    pub struct Sbabc4: order (8, 4), symmetric,
        citation "Laskar and Robutel 2001, Celestial Mechanics and Dynamical Astronomy 80, 39"
    = symmetric(B(1/20, -0.00182239680007662465114856998272488646) A((1 - sqrt(3/7))/2) B(49/180) A(_) B(_));

    /// Five kicks.
    pub struct Aba84: order (8, 4), symmetric,
        citation "McLachlan 1995, BIT 35, 258"
    = symmetric(
        A(0.0753469602698928884165278036834744644)
        B(0.190225939373676619245230762738453897)
        A(0.517916854688256782300773978496315644)
        B(0.846524070443526257055080544646775834)
        A(_)
        B(_)
    );

    /// ABA(10,4), seven kicks: for a second part of about 1e-4 and below.
    pub struct Aba104: order (10, 4), symmetric,
        citation "Blanes, Casas, Farres, Laskar, Makazaga and Murua 2013, Applied Numerical Mathematics 68, 58"
    = symmetric(
        A(0.0470671006459725061294788763724367856)
        B(0.118881917368197019945350395085388594)
        A(0.184756935417088106924737619370256097)
        B(0.241050460551501565744166786590165111)
        A(0.282706005679836205324361656554145248)
        B(-0.273286666705323806054311398166455946)
        A(_)
        B(_)
    );

    /// ABA(8,6,4), seven kicks.
    pub struct Aba864: order (8, 6, 4), symmetric,
        citation "Blanes, Casas, Farres, Laskar, Makazaga and Murua 2013, Applied Numerical Mathematics 68, 58"
    = symmetric(
        A(0.0711334264982231177779387300061549964)
        B(0.183083687472197221961703757166430291)
        A(0.24115342795664009873648779532628965)
        B(0.310782859898574869507522291054262796)
        A(0.52141176177281478921213607806799423)
        B(-0.0265646185119588006972121379164987593)
        A(_)
        B(_)
    );

    /// ABA(10,6,4), eight kicks: where to begin for planets.
    pub struct Aba1064: order (10, 6, 4), symmetric,
        citation "Blanes, Casas, Farres, Laskar, Makazaga and Murua 2013, Applied Numerical Mathematics 68, 58"
    = symmetric(
        A(0.0380944974224121954569753223086375653)
        B(0.0958588808370752106107715037714588478)
        A(0.14529871611691374929402007266066375)
        B(0.204446153142998780680507783916434478)
        A(0.207627695725541250716205611324988207)
        B(0.217070347978991101714338592430633671)
        A(0.435909703651526159223154862401065184)
        B(_)
        A(_)
    );

    /// ABAH(8,4,4), six kicks, for a second part that is itself split in two by a symmetric step, as in heliocentric
    /// coordinates.
    pub struct Abah844: order (8, 4, 4), symmetric,
        citation "Blanes, Casas, Farres, Laskar, Makazaga and Murua 2013, Applied Numerical Mathematics 68, 58"
    = symmetric(
        A(0.27414026894340187616405654403786371)
        B(0.640885795162512717732249116471601035)
        A(-0.107568438440164230625110529706323653)
        B(-0.85857544895678285658812832463560001)
        A(-0.0480185025906016926911954171508475065)
        B(_)
        A(_)
    );

    /// ABAH(8,6,4), eight kicks, for a second part that is itself split in two by a symmetric step.
    pub struct Abah864: order (8, 6, 4), symmetric,
        citation "Blanes, Casas, Farres, Laskar, Makazaga and Murua 2013, Applied Numerical Mathematics 68, 58"
    = symmetric(
        A(0.0681023565165837208472397668206116457)
        B(0.168443259361895453431038269775691756)
        A(0.251136038722103323307282958045535068)
        B(0.42431771737426772243003516574072318)
        A(-0.0750726495721656251600682176760162005)
        B(-0.585810969468175681230901535540403652)
        A(-0.00954471970174500781148821895721711327)
        B(_)
        A(_)
    );

    /// ABAH(10,6,4), nine kicks, for a second part that is itself split in two by a symmetric step.
    pub struct Abah1064: order (10, 6, 4), symmetric,
        citation "Blanes, Casas, Farres, Laskar, Makazaga and Murua 2013, Applied Numerical Mathematics 68, 58"
    = symmetric(
        A(0.0473190869765338227040437179632080313)
        B(0.119688462458532203531286429748988936)
        A(0.265110523574878515953948003618566192)
        B(0.375295585537937425042012853768771492)
        A(-0.00997652288381124084326746816481187767)
        B(-0.468459341832599378365082040980558954)
        A(-0.0599291997349415512639524798772948445)
        B(0.335139734275589701039309894294957238)
        A(_)
        B(_)
    );

    /// A kernel of three kicks with a processor.
    pub struct BlanesCasasRos764: order (7, 6, 4),
        citation "Blanes, Casas and Ros 2000, Celestial Mechanics and Dynamical Astronomy 77, 17"
    = processed(
        A(-0.33462222987308020924204361295831436)
        B(-1.62181011808680078472908802304184567)
        A(1.0975679907321611857123644821320079)
        B(0.00617094681101423542635507188802659837)
        A(-1.03808874609678068804087025246642142)
        B(0.834849359247258559884356717139371261)
        A(0.623477631792137313208235522750738533)
        B(-0.0511253369989317655404939848616671077)
        A(-1.1027532063031904598389395366824913)
        B(0.563378267069819958688823090723895603)
        A(-0.0141183222088869380687937309277386687)
        B(-0.5);
        symmetric(
            A(0.560087981092461912134893032918557137)
            B(1.51714797072072275612007927509150398)
            A(_)
            B(_)
        )
    );

    /// [`Verlet`] with the corrector of order 3 as its processor.
    pub struct WisdomHolmanTouma3: order (4, 2),
        citation "Wisdom, Holman and Touma 1996, Fields Institute Communications 10, 217; Wisdom 2006, Astronomical Journal 131, 2294"
    = processed(
        A(-0.418330013267037773989086012892593745)
        B(0.0249005960277998674993503579102734372)
        A(0.836660026534075547978172025785187489)
        B(-0.0498011920555997349987007158205468744)
        A(-0.836660026534075547978172025785187489)
        B(0.0249005960277998674993503579102734372)
        A(0.418330013267037773989086012892593745);
        Verlet
    );

    /// [`Verlet`] with the corrector of order 5 as its processor.
    pub struct WisdomHolmanTouma5: order (6, 2),
        citation "Wisdom, Holman and Touma 1996, Fields Institute Communications 10, 217; Wisdom 2006, Astronomical Journal 131, 2294"
    = processed(
        A(-0.836660026534075547978172025785187489)
        B(-0.00830019867593328916645011930342447906)
        A(1.67332005306815109595634405157037498)
        B(0.00830019867593328916645011930342447906)
        A(-1.25499003980111332196725803867778123)
        B(0.0415009933796664458322505965171223953)
        A(0.836660026534075547978172025785187489)
        B(-0.0830019867593328916645011930342447906)
        A(-0.836660026534075547978172025785187489)
        B(0.0415009933796664458322505965171223953)
        A(1.25499003980111332196725803867778123)
        B(0.00830019867593328916645011930342447906)
        A(-1.67332005306815109595634405157037498)
        B(-0.00830019867593328916645011930342447906)
        A(0.836660026534075547978172025785187489);
        Verlet
    );

    /// [`Verlet`] with the corrector of order 7 as its processor.
    pub struct WisdomHolmanTouma7: order (8, 2),
        citation "Wisdom, Holman and Touma 1996, Fields Institute Communications 10, 217; Wisdom 2006, Astronomical Journal 131, 2294"
    = processed(
        A(-1.25499003980111332196725803867778123)
        B(0.00249268114269221057790305939527769645)
        A(2.50998007960222664393451607735556247)
        B(-0.00249268114269221057790305939527769645)
        A(-2.09165006633518886994543006446296872)
        B(-0.0182709232467021314780623568845352648)
        A(1.67332005306815109595634405157037498)
        B(0.0182709232467021314780623568845352648)
        A(-1.25499003980111332196725803867778123)
        B(0.0539643990931274987217658934935108775)
        A(0.836660026534075547978172025785187489)
        B(-0.107928798186254997443531786987021755)
        A(-0.836660026534075547978172025785187489)
        B(0.0539643990931274987217658934935108775)
        A(1.25499003980111332196725803867778123)
        B(0.0182709232467021314780623568845352648)
        A(-1.67332005306815109595634405157037498)
        B(-0.0182709232467021314780623568845352648)
        A(2.09165006633518886994543006446296872)
        B(-0.00249268114269221057790305939527769645)
        A(-2.50998007960222664393451607735556247)
        B(0.00249268114269221057790305939527769645)
        A(1.25499003980111332196725803867778123);
        Verlet
    );

    /// [`Verlet`] with the corrector of order 11 as its processor.
    pub struct WisdomHolmanTouma11: order (12, 2),
        citation "Wisdom, Holman and Touma 1996, Fields Institute Communications 10, 217; Wisdom 2006, Astronomical Journal 131, 2294"
    = processed(
        A(-2.09165006633518886994543006446296872)
        B(0.000203615796478546513016328187746337165)
        A(4.18330013267037773989086012892593745)
        B(-0.000203615796478546513016328187746337165)
        A(-3.7649701194033399659017741160333437)
        B(-0.00234872152922953541883073288510554899)
        A(3.34664010613630219191268810314074996)
        B(0.00234872152922953541883073288510554899)
        A(-2.92831009286926441792360209024815621)
        B(0.0123090785920199463175445647632379099)
        A(2.50998007960222664393451607735556247)
        B(-0.0123090785920199463175445647632379099)
        A(-2.09165006633518886994543006446296872)
        B(-0.0381216136812886505086476132602473721)
        A(1.67332005306815109595634405157037498)
        B(0.0381216136812886505086476132602473721)
        A(-1.25499003980111332196725803867778123)
        B(0.0725933947488427386742531807427449618)
        A(0.836660026534075547978172025785187489)
        B(-0.145186789497685477348506361485489924)
        A(-0.836660026534075547978172025785187489)
        B(0.0725933947488427386742531807427449618)
        A(1.25499003980111332196725803867778123)
        B(0.0381216136812886505086476132602473721)
        A(-1.67332005306815109595634405157037498)
        B(-0.0381216136812886505086476132602473721)
        A(2.09165006633518886994543006446296872)
        B(-0.0123090785920199463175445647632379099)
        A(-2.50998007960222664393451607735556247)
        B(0.0123090785920199463175445647632379099)
        A(2.92831009286926441792360209024815621)
        B(0.00234872152922953541883073288510554899)
        A(-3.34664010613630219191268810314074996)
        B(-0.00234872152922953541883073288510554899)
        A(3.7649701194033399659017741160333437)
        B(-0.000203615796478546513016328187746337165)
        A(-4.18330013267037773989086012892593745)
        B(0.000203615796478546513016328187746337165)
        A(2.09165006633518886994543006446296872);
        Verlet
    );

    /// [`Verlet`] with the corrector of order 17 as its processor: one kick a step, for long runs with few outputs.
    pub struct WisdomHolmanTouma17: order (18, 2),
        citation "Wisdom, Holman and Touma 1996, Fields Institute Communications 10, 217; Wisdom 2006, Astronomical Journal 131, 2294"
    = processed(
        A(-3.34664010613630219191268810314074996)
        B(-0.00000433474154733735801906502234981249449)
        A(6.69328021227260438382537620628149992)
        B(0.00000433474154733735801906502234981249449)
        A(-6.27495019900556660983629019338890617)
        B(0.0000764363552279357383632418469794134751)
        A(5.85662018573852883584720418049631243)
        B(-0.0000764363552279357383632418469794134751)
        A(-5.43829017247149106185811816760371868)
        B(-0.000635999830758176589831668816250785459)
        A(5.01996015920445328786903215471112494)
        B(0.000635999830758176589831668816250785459)
        A(-4.60163014593741551387994614181853119)
        B(0.00331325770693806556554901968334519941)
        A(4.18330013267037773989086012892593745)
        B(-0.00331325770693806556554901968334519941)
        A(-3.7649701194033399659017741160333437)
        B(-0.0120717608223422910624497517269596643)
        A(3.34664010613630219191268810314074996)
        B(0.0120717608223422910624497517269596643)
        A(-2.92831009286926441792360209024815621)
        B(0.0324221988647135802936815230295771308)
        A(2.50998007960222664393451607735556247)
        B(-0.0324221988647135802936815230295771308)
        A(-2.09165006633518886994543006446296872)
        B(-0.065192863576377893658290760803725762)
        A(1.67332005306815109595634405157037498)
        B(0.065192863576377893658290760803725762)
        A(-1.25499003980111332196725803867778123)
        B(0.0930561037714259585915410590675535471)
        A(0.836660026534075547978172025785187489)
        B(-0.186112207542851917183082118135107094)
        A(-0.836660026534075547978172025785187489)
        B(0.0930561037714259585915410590675535471)
        A(1.25499003980111332196725803867778123)
        B(0.065192863576377893658290760803725762)
        A(-1.67332005306815109595634405157037498)
        B(-0.065192863576377893658290760803725762)
        A(2.09165006633518886994543006446296872)
        B(-0.0324221988647135802936815230295771308)
        A(-2.50998007960222664393451607735556247)
        B(0.0324221988647135802936815230295771308)
        A(2.92831009286926441792360209024815621)
        B(0.0120717608223422910624497517269596643)
        A(-3.34664010613630219191268810314074996)
        B(-0.0120717608223422910624497517269596643)
        A(3.7649701194033399659017741160333437)
        B(-0.00331325770693806556554901968334519941)
        A(-4.18330013267037773989086012892593745)
        B(0.00331325770693806556554901968334519941)
        A(4.60163014593741551387994614181853119)
        B(0.000635999830758176589831668816250785459)
        A(-5.01996015920445328786903215471112494)
        B(-0.000635999830758176589831668816250785459)
        A(5.43829017247149106185811816760371868)
        B(-0.0000764363552279357383632418469794134751)
        A(-5.85662018573852883584720418049631243)
        B(0.0000764363552279357383632418469794134751)
        A(6.27495019900556660983629019338890617)
        B(0.00000433474154733735801906502234981249449)
        A(-6.69328021227260438382537620628149992)
        B(-0.00000433474154733735801906502234981249449)
        A(3.34664010613630219191268810314074996);
        Verlet
    );
}
