//! Why a sum does not have a faster layout, and what to write instead.
//!
//! The modules that recognise layouts return these reasons; messages and reports print them. Always true: a reason is a fact
//! about the formula, never a guess.

/// The first obstacle that a recogniser found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Reason {
    /// No single fact is known.
    Unrecognised,
    Method,
    // Sums over pairs.
    NoPairs,
    PairCounts,
    PairWithItself,
    PairReads,
    PairOrder,
    PairsAndOthers,
    Densities,
    // Sums over a body and two others.
    NoTriplets,
    TripletSum,
    TripletWithItself,
    TripletReads,
    TripletPlaces,
    TripletCutoff,
    Kinetic,
    OneBody,
    BodyShape,
    ManyBodies,
    FewBodies,
    InPart,
    // Cutoffs of pairs, the most specific one last.
    NoCutoff,
    FewBodiesForLists,
    ListsInJacobi,
    CutoffOfTerm,
    CutoffReads,
    CutoffAxes,
    CutoffMoves,
    CutoffOfPair,
    CutoffBoxes,
    // Sites of lattices.
    OneIndex,
    TwoIndices,
    ThreeIndices,
    FewSites,
    NoSites,
    SiteRange,
    SiteIndex,
    SiteFar,
    SiteCondition,
    SiteScope,
    SiteSum,
    // Loops and lists.
    NoLoop,
    NoList,
    FewCoordinates,
    FewIterations,
    FewTerms,
    LoopIndex,
    LoopBody,
    LoopCondition,
    LongLoop,
    LoopTargets,
    TermIndex,
    TermTarget,
    TermLoop,
    LongTerm,
}

/// What to write for bodies whose number the type determines.
const SLICE: &str = "a slice such as `q: &[[f64; 3]]`";

impl Reason {
    /// The reason, and what to write instead; empty if nothing gains from it.
    pub(crate) fn texts(self) -> [&'static str; 2] {
        match self {
            Self::Unrecognised => ["the macro does not recognise this sum", ""],
            Self::Method => [
                "a term calls a method with a stated derivative",
                "the method in the language of H, without a stated derivative",
            ],
            Self::NoPairs => [
                "no addend of V is a sum over the pairs of bodies in two nested loops",
                "`for i in 0..q.len() { for j in 0..i { .. } }`",
            ],
            Self::PairCounts => [
                "the sums over pairs have loops with different ranges, and there are fewer than 33 bodies",
                "the same loops for all pairs, such as `for i in 0..q.len() { for j in 0..i { .. } }`",
            ],
            Self::PairWithItself => {
                ["the loops over `i` and `j` include the pair of a body with itself", "`for j in 0..i`, or `if i != j`"]
            }
            Self::PairReads => [
                "the energy of a pair reads other bodies, or a parameter or condition of both bodies at once",
                "a list for each body such as `self.mass[i]`, or a table by type such as \
                 `self.table[self.kind[i]][self.kind[j]]`",
            ],
            Self::PairOrder => [
                "the macro cannot prove that exchanging the two bodies of a pair keeps its energy",
                "an energy of the distance and of parameters of one body each",
            ],
            Self::Densities => [
                "a body has more sums over its partners than coordinates, or these sums have loops with different ranges",
                "sums in loops of the same form, such as `for j in 0..q.len() { if j != i { .. } }`",
            ],
            Self::NoTriplets => [
                "V has no sum over a body and two others",
                "`for i in 0..q.len() { for j in 0..q.len() { for k in j + 1..q.len() { .. } } }`",
            ],
            Self::TripletSum => [
                "a sum over two others of a body is inside of a function, or has more than eight conditions around it",
                "the term of three bodies in the innermost of three loops",
            ],
            Self::TripletWithItself => [
                "the loops over a body and two others include terms in which two of the three are the same body",
                "`if j != i` and `for k in j + 1..q.len() { if k != i { .. } }`",
            ],
            Self::TripletReads => [
                "the energy of three bodies reads others, or a parameter or condition of all three at once",
                "a list for each body such as `self.mass[i]`, or a table by two types such as \
                 `self.table[self.kind[i]][self.kind[j]]`",
            ],
            Self::TripletPlaces => [
                "the energy of three bodies depends on more than the displacements between them",
                "a term of each body in a sum of its own",
            ],
            Self::TripletCutoff => [
                "no condition makes the energy of three bodies zero unless both others are within a cutoff of the first",
                "the energy inside of `if square_ij < self.cutoff.powi(2) { .. }` and \
                 `if square_ik < self.cutoff.powi(2) { .. }`",
            ],
            Self::PairsAndOthers => ["V has terms beside the pairs, and there are fewer than 33 bodies", SLICE],
            Self::Kinetic => [
                "T is not a sum of one term for each body",
                "`p.iter().map(|p| (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 2.0).sum()`",
            ],
            Self::OneBody => ["there is only one body", ""],
            Self::BodyShape => {
                ["`q` has three indices, or the number of coordinates of a body is not a literal", SLICE]
            }
            Self::ManyBodies => ["a row has at most 8 bodies, and their number is in the type of `q`", ""],
            Self::FewBodies => ["at most 8 bodies are one row", ""],
            Self::InPart => [
                "a part that `split` names is summed as written if there are fewer than 33 numbers in `q`",
                "`kinetic` and `potential` without `split`",
            ],
            Self::NoCutoff => [
                "no condition on the distance of two bodies makes the energy of a pair zero",
                "the energy of a pair inside of `if square < self.cutoff.powi(2) { .. }`",
            ],
            Self::FewBodiesForLists => ["there are fewer than 384 bodies, by the type of `q`", SLICE],
            Self::ListsInJacobi => ["Jacobi coordinates have no neighbour lists", "no `coordinates`"],
            Self::CutoffOfTerm => [
                "a term of a pair is outside of the condition on the distance",
                "all terms of a pair inside of `if square < self.cutoff.powi(2) { .. }`",
            ],
            Self::CutoffReads => [
                "a condition of a pair compares more than the distance of its bodies",
                "`square < self.cutoff.powi(2)`, where `square` is the squared distance",
            ],
            Self::CutoffAxes => [
                "the condition of a pair does not compare all coordinates of the displacement",
                "the sum of squares over all coordinates",
            ],
            Self::CutoffMoves => [
                "the distance is compared with a number that changes during a run",
                "a cutoff that depends on parameters only",
            ],
            Self::CutoffOfPair => [
                "the macro finds no greatest value of the cutoff over all pairs",
                "a cutoff by sums, products, powers, `max` and `min` of parameters of each body",
            ],
            Self::CutoffBoxes => ["the terms of a pair have cutoffs in different boxes", "all distances in one box"],
            Self::OneIndex => ["`q` has one index, as the sites of a line", "`q: &[[f64; 64]]` for a plane"],
            Self::TwoIndices => [
                "`q` has two indices, as the sites of a plane",
                "`q: &[f64]` for a line, or `q: &[[[f64; 64]; 64]]` for a volume",
            ],
            Self::ThreeIndices => [
                "`q` has three indices, as the sites of a volume",
                "`q: &[f64]` for a line, or `q: &[[f64; 64]]` for a plane",
            ],
            Self::FewSites => ["a row has fewer than 8 sites", ""],
            Self::NoSites => ["V has no loop over all sites", "`for i in 0..q.len() { .. }`"],
            Self::SiteRange => [
                "a loop over sites does not begin and end at fixed distances from the ends of `q`",
                "a range such as `0..q.len() - 1`",
            ],
            Self::SiteIndex => [
                "a coordinate is read at another index than that of the loop plus or minus a number",
                "`q[i + 1]`, or `q[(i + 1) % q.len()]` on a ring",
            ],
            Self::SiteFar => ["a site acts on another one that is more than 2 sites, 1 row or 1 plane away", ""],
            Self::SiteCondition => [
                "a condition on the index of a site does not select a range of sites",
                "a condition such as `i + 1 < q.len()`, or a factor from a list such as `self.weight[i]`",
            ],
            Self::SiteScope => ["a term is in another loop or branch than the loops over sites", ""],
            Self::SiteSum => ["a site reads a sum over other coordinates", ""],
            Self::NoLoop => ["V has no innermost loop over coordinates or data", "`for i in 0..q.len() { .. }`"],
            Self::NoList => ["V has no loop over a list that names coordinates", "`for &(i, j) in &self.bonds { .. }`"],
            Self::FewCoordinates => {
                ["there are fewer than 65 coordinates, or their number is not a literal", "a slice such as `q: &[f64]`"]
            }
            Self::FewIterations => ["the loop has fewer than 16 iterations", ""],
            Self::FewTerms => ["the list has fewer than 8 terms", ""],
            Self::LoopIndex => {
                ["a coordinate is read at another index than that of the loop plus or minus a number", ""]
            }
            Self::LoopBody => ["iterations depend on each other, or a branch reads coordinates of its own", ""],
            Self::LoopCondition => [
                "a condition that is constant during a run decides which iterations add something",
                "a shorter range, or a factor from a list such as `self.weight[i]`",
            ],
            Self::LongLoop => ["an iteration reads more than 16 points, or adds to more than 16 sums", ""],
            Self::LoopTargets => ["an iteration adds to the gradient of two coordinates", ""],
            Self::TermTarget => ["a term adds to a coordinate that the list of the innermost loop does not name", ""],
            Self::TermIndex => [
                "a term reads a coordinate at an index that is not in the list, such as `q[a + 1]`",
                "a list that contains every index",
            ],
            Self::TermLoop => ["a term has an inner loop that is not written out", "at most four iterations"],
            Self::LongTerm => ["a term reads or adds to more than 48 coordinates", ""],
        }
    }
}
