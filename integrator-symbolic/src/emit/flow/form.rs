//! The layout of the generated flows of a Hamiltonian, for readers.

use super::Flows;
use crate::{
    differentiate::Contribution,
    emit::printer::{block::Emitter, fields::Fields, lanes::has_lanes, lists::has_list_sums},
    model::Model,
    pattern::{Pattern, all_pairs::LISTED_FROM},
    program::Program,
    stencil::Lattice,
    syntax::{Input, names::Names},
};
use std::fmt;

/// The layout in which a flow processes its coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Scalar lines and loops, as the formulas are written.
    Plain,
    /// Terms of lists that name the coordinates, such as bonds; several terms in SIMD lanes.
    Lists,
    /// Innermost loops over coordinates or data, such as sums over a row of a matrix; several iterations in SIMD lanes.
    Loops,
    /// A line of sites with neighbour interactions: a sum over neighbours, in vectors.
    Line,
    /// Rows of a plane of sites with neighbour interactions.
    Plane,
    /// Planes of a volume of sites, along the rows of each.
    Volume,
    /// Bodies in the lanes of one vector: a sum over pairs, by rotations of the vector.
    Row,
    /// Bodies in rows of eight: a sum over pairs, in tiles.
    Tiles,
    /// As [`Form::Tiles`] for few bodies; for many bodies, by neighbour lists within a cutoff.
    Neighbours,
    /// As [`Form::Neighbours`], with the nearest images in a periodic box.
    NeighboursInBox,
}

impl Form {
    /// Returns the name in one word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Lists => "lists",
            Self::Loops => "loops",
            Self::Line => "line",
            Self::Plane => "plane",
            Self::Volume => "volume",
            Self::Row => "row",
            Self::Tiles => "tiles",
            Self::Neighbours => "neighbours",
            Self::NeighboursInBox => "neighbours_in_box",
        }
    }
}

impl fmt::Display for Form {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = match self {
            Self::Plain => "plain code",
            Self::Lists => "terms of lists in SIMD lanes, the rest plain code",
            Self::Loops => "innermost loops in SIMD lanes, the rest plain code",
            Self::Line => "neighbour sums along a line of sites, in SIMD lanes",
            Self::Plane => "neighbour sums along the rows of a plane, in SIMD lanes",
            Self::Volume => "neighbour sums along the rows of stacked planes, in SIMD lanes",
            Self::Row => "pair sums by rotations of one row of bodies",
            Self::Tiles => "pair sums in tiles of eight bodies by eight",
            Self::Neighbours | Self::NeighboursInBox => {
                let in_box = if matches!(self, Self::NeighboursInBox) { ", in a periodic box" } else { "" };
                return write!(
                    formatter,
                    "{}; from {LISTED_FROM} bodies on, sums over neighbour lists within the cutoff{in_box}",
                    Self::Tiles
                );
            }
        };
        formatter.write_str(text)
    }
}

/// The form of a program's loops, if some of them are in lanes, and whether one gains from the widest vectors.
pub(super) fn form_of_loops(model: &Model, program: &Program) -> (Option<Form>, bool) {
    let [has_lanes, is_wide] = has_lanes(model, program);
    match has_list_sums(model, program) {
        true => (Some(Form::Lists), true),
        false => (has_lanes.then_some(Form::Loops), is_wide),
    }
}

/// The forms of the drift and of the kick, and that of the terms of the kick beside sums over pairs.
pub(crate) fn forms(
    input: &Input,
    model: &mut Model,
    kinetic: &[Contribution],
    potential: &[Contribution],
    pattern: &Pattern,
) -> ([Form; 2], Option<Form>) {
    let mut emitter = Emitter { model, names: &Names::new(input), fields: Fields::default() };
    let Flows { drift, kick, many_body, .. } = Flows::of(&mut emitter, kinetic, potential, pattern);
    if let Some(bodies) = many_body {
        let forms = match bodies.listed() {
            Some(true) => [Form::Tiles, Form::NeighboursInBox],
            Some(false) => [Form::Tiles, Form::Neighbours],
            None if bodies.is_row() => [Form::Row; 2],
            None => [Form::Tiles; 2],
        };
        return (forms, bodies.form_of_others());
    }
    let forms = [drift, kick].map(|flow| match flow.sweep {
        None => flow.form_of_loops.unwrap_or(Form::Plain),
        Some(sweep) => match sweep.lattice() {
            Lattice::Line => Form::Line,
            Lattice::Plane => Form::Plane,
            Lattice::Volume => Form::Volume,
        },
    });
    (forms, None)
}
