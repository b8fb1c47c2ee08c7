//! The layouts of flows: their names, which layout each flow of a Hamiltonian has, and why a faster one does not apply.
//!
//! In: a model, its gradients and their pattern. Out: a [`Form`] for each flow, found before emission; with [`lost`], also the
//! reasons. Always true: emission takes the same form, because both read the same pattern and the same program.

pub(crate) mod lost;

use crate::{
    differentiate::Contribution,
    graph::{
        Graph, NodeId, Part,
        index::{IndexId, LoopId},
    },
    model::{Model, Parameter, is_field, is_leaf},
    pattern::{
        Pattern,
        all_pairs::{AllPairs, LISTED_FROM, ROW},
        stores::passes,
    },
    program::{
        Constraints, Item, Program, Store,
        lanes::{LaneContext, LoopInLanes},
        lists::ListSum,
        schedule_with,
    },
    reason::Reason,
    stencil::Lattice,
};
use std::{collections::BTreeSet, fmt};

/// The layout in which a flow processes its coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Form {
    /// Scalar lines and loops, as the formulas are written.
    #[default]
    Plain,
    /// Innermost loops over coordinates or data, such as sums over a row of a matrix; several iterations in SIMD lanes.
    Lanes,
    /// Terms of lists that name the coordinates, such as bonds; several terms in SIMD lanes.
    Terms,
    /// A line of sites with neighbour interactions: a sum over neighbours, in vectors.
    Line,
    /// Rows of a plane of sites with neighbour interactions.
    Plane,
    /// Planes of a volume of sites, along the rows of each.
    Volume,
    /// Bodies in the lanes of one vector: a sum over pairs, by rotations of the vector.
    Row,
    /// Bodies in rows of eight: a sum over pairs, in tiles.
    Pairs,
    /// As [`Form::Pairs`] for few bodies; for many bodies, by neighbour lists within a cutoff.
    Lists,
    /// As [`Form::Lists`], with the nearest images in a periodic box.
    ListsInBox,
    /// As [`Form::Lists`], with sums over a body and two others within the cutoff; eight triplets in SIMD lanes.
    Triplets,
    /// As [`Form::Triplets`], where pairs have no cutoff or another box: the bodies of a triplet are found among all pairs.
    TripletsOfPairs,
}

/// What is known of a form.
struct Row {
    /// The word that the annotation and the runtime name it by.
    name: &'static str,
    text: &'static str,
    /// What the cost of a flow is proportional to.
    cost: &'static str,
}

impl Form {
    /// All of them that have a word of their own, in the order of the guide.
    const NAMED: [Self; 10] = [
        Self::Plain,
        Self::Lanes,
        Self::Terms,
        Self::Line,
        Self::Plane,
        Self::Volume,
        Self::Row,
        Self::Pairs,
        Self::Lists,
        Self::Triplets,
    ];

    fn row(self) -> Row {
        let row = |name, text, cost| Row { name, text, cost };
        match self {
            Self::Plain => row("plain", "plain code", "the iterations of the loops"),
            Self::Lanes => {
                row("lanes", "innermost loops in SIMD lanes, the rest plain code", "the iterations of the loops")
            }
            Self::Terms => row(
                "terms",
                "terms of lists in SIMD lanes, the rest plain code",
                "the terms and iterations of the loops",
            ),
            Self::Line => row("line", "neighbour sums along a line of sites, in SIMD lanes", "the sites"),
            Self::Plane => row("plane", "neighbour sums along the rows of a plane, in SIMD lanes", "the sites"),
            Self::Volume => {
                row("volume", "neighbour sums along the rows of stacked planes, in SIMD lanes", "the sites")
            }
            Self::Row => row("row", "pair sums by rotations of one row of bodies", "all pairs"),
            Self::Pairs => row("pairs", "pair sums in tiles of eight bodies by eight", "all pairs"),
            Self::Lists => row("lists", "sums over neighbour lists within the cutoff", "the pairs within the cutoff"),
            Self::ListsInBox => row(
                "lists",
                "sums over neighbour lists within the cutoff, in a periodic box",
                "the pairs within the cutoff",
            ),
            Self::Triplets => row(
                "triplets",
                "sums over neighbour lists within the cutoff; triplets of neighbours, eight in SIMD lanes",
                "the pairs and triplets within the cutoff",
            ),
            Self::TripletsOfPairs => row(
                "triplets",
                "pair sums in tiles of eight bodies by eight; triplets within the cutoff, eight in SIMD lanes",
                "all pairs and the triplets within the cutoff",
            ),
        }
    }

    /// Returns the name in one word, as `layout = ...` and `Run::layout` use it.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// The form that a word names.
    pub(crate) fn named(word: &str) -> Option<Self> {
        Self::NAMED.into_iter().find(|form| form.name() == word)
    }

    /// The words of all forms.
    pub(crate) fn names() -> Vec<String> {
        Self::NAMED.map(|form| form.name().to_owned()).into()
    }

    /// Returns what the time of a kick in this layout is proportional to, in words.
    pub fn cost(self) -> &'static str {
        self.row().cost
    }

    /// Whether a flow is a sum over pairs of bodies.
    pub(crate) fn is_of_pairs(self) -> bool {
        matches!(
            self,
            Self::Row | Self::Pairs | Self::Lists | Self::ListsInBox | Self::Triplets | Self::TripletsOfPairs
        )
    }

    /// The forms of the drift and of the kick of bodies; `listed` if neighbours are, and whether that is in a box.
    pub(crate) fn of_bodies(listed: Option<bool>, is_row: bool, has_triplets: bool) -> [Self; 2] {
        match listed {
            Some(_) if has_triplets => [Self::Pairs, Self::Triplets],
            None if has_triplets => [Self::Pairs, Self::TripletsOfPairs],
            Some(true) => [Self::Pairs, Self::ListsInBox],
            Some(false) => [Self::Pairs, Self::Lists],
            None if is_row => [Self::Row; 2],
            None => [Self::Pairs; 2],
        }
    }
}

impl From<Lattice> for Form {
    fn from(lattice: Lattice) -> Self {
        match lattice {
            Lattice::Line => Self::Line,
            Lattice::Plane => Self::Plane,
            Lattice::Volume => Self::Volume,
        }
    }
}

impl fmt::Display for Form {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if matches!(self, Self::Lists | Self::ListsInBox | Self::Triplets) {
            write!(formatter, "{}; from {LISTED_FROM} bodies on, ", Self::Pairs)?;
        }
        formatter.write_str(self.row().text)
    }
}

/// What decides which loops of a program are in lanes.
pub(crate) fn lane_context<'m>(
    model: &'m Model,
    program: &'m Program,
    is_kept: &'m dyn Fn(NodeId) -> bool,
) -> LaneContext<'m> {
    let (graph, lengths, named, compared) = (&model.graph, &model.lengths[..], &program.named, &program.compared);
    LaneContext { graph, lengths, named, compared, is_kept }
}

/// Whether a program has loops in lanes, and whether one of these gains from the widest vectors.
pub(crate) fn has_lanes(model: &Model, program: &Program) -> [bool; 2] {
    let loops = loops_in_lanes(model, program, |lanes| lanes.is_wide);
    [!loops.is_empty(), loops.contains(&true)]
}

/// What is asked of each of the loops in lanes of a program.
pub(crate) fn loops_in_lanes<T>(model: &Model, program: &Program, of: impl Fn(&LoopInLanes<'_>) -> T) -> Vec<T> {
    let is_kept = |id| is_field(&model.graph, &model.parameters, id);
    lane_context(model, program, &is_kept).all(program).iter().map(of).collect()
}

/// The sum over a list that a loop of a program is, if its terms share vectors.
pub(crate) fn list_sum<'p>(
    graph: &Graph,
    lengths: &[IndexId],
    parameters: &[Parameter],
    named: &BTreeSet<NodeId>,
    by: LoopId,
    body: &'p [Item],
) -> Result<ListSum<'p>, Reason> {
    ListSum::of(graph, lengths.get(1).copied(), named, by, body, |id| is_field(graph, parameters, id))
}

/// Whether a program has a sum over a list whose terms share vectors.
fn has_list_sums(model: &Model, program: &Program) -> bool {
    fn any(model: &Model, program: &Program, items: &[Item]) -> bool {
        items.iter().any(|item| match item {
            Item::Loop { by, body } => {
                list_sum(&model.graph, &model.lengths, &model.parameters, &program.named, *by, body).is_ok()
                    || any(model, program, body)
            }
            _ => false,
        })
    }
    any(model, program, &program.items)
}

/// The form of a program, and whether loops in lanes gain from the widest vectors.
pub(crate) fn form_of_loops(model: &Model, program: &Program) -> (Form, bool) {
    match (has_list_sums(model, program), has_lanes(model, program)) {
        (true, _) => (Form::Terms, true),
        (false, [true, is_wide]) => (Form::Lanes, is_wide),
        (false, [false, is_wide]) => (Form::Plain, is_wide),
    }
}

/// The forms of the drift and of the kick, and that of the terms of the kick beside sums over pairs.
pub(crate) fn forms(
    model: &mut Model,
    gradients: [&[Contribution]; 2],
    pattern: &Pattern,
) -> ([Form; 2], Option<Form>) {
    match pattern {
        Pattern::AllPairs(pairs) => {
            let others = pairs.others.as_ref().filter(|others| !others.gradient.is_empty());
            let others = others.map(|others| form_of_loops(model, &scheduled(model, &others.gradient)).0);
            (forms_of_bodies(model, pairs), others)
        }
        Pattern::Sites(stencils) => {
            let mut form = |part: usize, by| match &stencils[part] {
                Some(stencil) => stencil.lattice().into(),
                None => form_along(model, gradients[part], by),
            };
            ([form(0, Part::Momentum), form(1, Part::Position)], None)
        }
    }
}

fn forms_of_bodies(model: &Model, pairs: &AllPairs) -> [Form; 2] {
    let is_row = model.shape.length.literal().is_some_and(|length| length <= ROW);
    Form::of_bodies(pairs.listed.as_ref().ok().map(|listed| listed.sides.is_some()), is_row, pairs.triplets.is_some())
}

/// The form of the flow along a gradient that is computed as written.
pub(crate) fn form_along(model: &mut Model, gradient: &[Contribution], part: Part) -> Form {
    program_along(model, gradient, part).map_or(Form::Plain, |program| form_of_loops(model, &program).0)
}

/// The lines of this flow, those of the first of its passes.
fn program_along(model: &mut Model, gradient: &[Contribution], part: Part) -> Option<Program> {
    let first = passes(model, gradient, part).into_iter().next()?;
    Some(scheduled(model, &first.stores))
}

/// The lines as they are scheduled. A branch in front of a loop changes no form: a loop that consists of branches is none in lanes.
fn scheduled(model: &Model, stores: &[Store]) -> Program {
    let leaf = |graph: &Graph, id| is_leaf(graph, &model.parameters, id);
    schedule_with(&model.graph, stores, leaf, &Constraints::default())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_that_of_one_form() {
        for form in Form::NAMED {
            assert_eq!(Form::named(form.name()), Some(form));
        }
        assert_eq!(Form::named("neighbours"), None);
        // A box changes no name.
        assert_eq!(Form::ListsInBox.name(), Form::Lists.name());
    }

    /// Texts that name numbers of other modules.
    #[test]
    fn reasons_have_the_numbers_of_the_code() {
        let lists = Reason::FewBodiesForLists.texts()[0];
        assert!(lists.contains(&format!("fewer than {LISTED_FROM} bodies")), "{lists}");
        for reason in [Reason::ManyBodies, Reason::FewBodies] {
            assert!(reason.texts()[0].contains(&format!("at most {ROW} bodies")), "{reason:?}");
        }
    }
}
