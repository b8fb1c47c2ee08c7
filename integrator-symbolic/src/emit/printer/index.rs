//! Rust code for integer expressions: indices of coordinates and bounds of loops.

use super::{
    expression::{Dialect, Printer},
    fields::Fields,
    frame::Frame,
};
use crate::stencil::{Lattice, Stencil};
use crate::{
    graph::{
        Element, Part,
        index::{Index, IndexId, LoopId},
    },
    model::{
        Length, Shape, is_constant,
        parameters::text::operand,
        values::integer::{operation, receiver, signed_operation},
    },
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

impl Printer<'_> {
    /// The name of a coordinate's part.
    pub(crate) fn part(&self, element: Element) -> Ident {
        part_name(element.part)
    }

    /// Where a coordinate is in the row of an order: components one after the other, each of all points.
    pub(crate) fn in_row(&self, fields: &mut Fields, element: Element) -> TokenStream {
        if let Frame::Series { interleaved: Some(indices) } = self.frame {
            return match indices.name(element) {
                Some(name) => name.to_token_stream(),
                None => self.interleaved_index(fields, element.index, element.component),
            };
        }
        let index = self.index(fields, element.index);
        let Some(component) = element.component else { return index };
        match self.graph.loops.literal(component) {
            Some(0) => index,
            Some(1) => quote!(stride + #index),
            _ => {
                let component = self.inner_index(fields, component);
                quote!(#component * stride + #index)
            }
        }
    }

    /// The same for a coordinate that may be read after a condition alone: one that is not there is the nearest that is.
    pub(crate) fn near_in_row(&self, fields: &mut Fields, element: Element) -> TokenStream {
        let is_apart = |id| matches!(self.graph.loops.index(id), Index::Add(..) | Index::Sub(..) | Index::Minus(..));
        if !self.graph.loops.of_coordinate(element).any(is_apart) {
            return self.in_row(fields, element);
        }
        let index = self.signed_index(fields, element.index);
        let component = element.component.map_or(quote!(0), |component| self.signed_index(fields, component));
        quote!(layout.near(#index, #component))
    }

    /// The same where points are distributed over vectors cyclically.
    pub(crate) fn interleaved_index(
        &self,
        fields: &mut Fields,
        index: IndexId,
        component: Option<IndexId>,
    ) -> TokenStream {
        let index = self.index(fields, index);
        let component = component.map_or(quote!(0), |component| self.index(fields, component));
        quote!(layout.index(#index, #component))
    }

    /// The indices of a coordinate; of a body that is an argument, those after the body's.
    pub(crate) fn at(&self, fields: &mut Fields, element: Element) -> TokenStream {
        match (self.frame, element.component) {
            (Frame::Bodies(_), None) => quote!([0]),
            (Frame::Bodies(_), Some(component)) => {
                let component = self.index(fields, component);
                quote!([#component])
            }
            (
                Frame::System
                | Frame::Constants
                | Frame::Motion
                | Frame::OwnTime
                | Frame::Apart
                | Frame::Sites(_)
                | Frame::Series { .. }
                | Frame::Edges,
                _,
            ) => {
                let indices = self.graph.loops.of_coordinate(element).map(|index| self.index(fields, index));
                quote!(#([#indices])*)
            }
        }
    }

    /// The indices of a coordinate as a list.
    pub(crate) fn listed(&self, fields: &mut Fields, element: Element) -> TokenStream {
        let index = self.index(fields, element.index);
        let component = element.component.map(|component| self.index(fields, component)).into_iter();
        quote!([#index #(, #component)*])
    }

    /// An integer expression.
    pub(crate) fn index(&self, fields: &mut Fields, id: IndexId) -> TokenStream {
        let known = self.graph.loops.index(id);
        if self.graph.loops.is_signed(id) {
            let signed = self.signed_index(fields, id);
            return quote!((#signed) as usize);
        }
        match known {
            Index::Typed(_, a) => return self.index(fields, a),
            Index::Wrapped(_, a) => {
                let signed = self.signed_index(fields, a);
                let wrapped = operation(known, quote!((#signed)), TokenStream::new());
                return quote!(#wrapped as usize);
            }
            _ => {}
        }
        if let Frame::Sites(Stencil { flat: Some([rows, width]), .. }) = self.frame {
            match known {
                _ if id == *rows => return quote!(window.rows()),
                _ if id == *width => return quote!(window.length()),
                Index::Length => return quote!((window.rows() * window.length())),
                _ => {}
            }
        }
        if let Index::InPlane(row, site) = known {
            let sites = self.graph.loops.sites_of_row().map(|sites| self.inner_index(fields, sites));
            let [row, site] = [row, site].map(|id| self.inner_index(fields, id));
            return quote!(#row * #sites + #site);
        }
        if let Some(both) = known.operands() {
            let [a, b] = both.map(|id| self.inner_index(fields, id));
            return operation(known, receiver(&self.graph.loops, known, both[0], a), b);
        }
        match known {
            Index::Literal(value) => Literal::u64_unsuffixed(value).to_token_stream(),
            Index::Running(by) => self.running.get(&by).to_token_stream(),
            Index::Length => match self.frame {
                Frame::Sites(lattice) => match lattice.lattice() {
                    Lattice::Line => quote!(window.length()),
                    Lattice::Plane => quote!(window.rows()),
                    Lattice::Volume => quote!(window.planes()),
                },
                Frame::Constants | Frame::Series { .. } | Frame::Edges => quote!(length),
                _ if self.dialect == Dialect::Generic => {
                    let counted = part_name(self.counted);
                    quote!(motion.#counted.len())
                }
                _ => quote!(length),
            },
            Index::Parameter(parameter) => {
                let known = &self.parameters[parameter.0 as usize];
                // Prepared constants know no path of the user's impl.
                let is_near = is_constant(&known.text) && !matches!(self.frame, Frame::Constants);
                if self.dialect == Dialect::Single || is_near {
                    return operand(known.named_text(self.running));
                }
                let name = fields.integer(self.parameters, parameter);
                self.prepared(name, self.graph.loops.of_parameter(parameter))
            }
            _ => TokenStream::new(),
        }
    }

    /// An integer expression that becomes a number: below zero where it may be.
    pub(crate) fn number_index(&self, fields: &mut Fields, id: IndexId) -> TokenStream {
        if self.graph.loops.is_signed(id) {
            let signed = self.signed_index(fields, id);
            return quote!((#signed));
        }
        self.inner_index(fields, id)
    }

    /// An integer expression as one that may be below zero, of 64 bits.
    pub(crate) fn signed_index(&self, fields: &mut Fields, id: IndexId) -> TokenStream {
        let known = self.graph.loops.index(id);
        if let Index::Literal(value) = known {
            return Literal::u64_unsuffixed(value).to_token_stream();
        }
        if let Index::InPlane(row, site) = known {
            let sites = self.graph.loops.sites_of_row().map(|sites| self.signed_index(fields, sites));
            let [row, site] = [row, site].map(|id| self.signed_index(fields, id));
            return quote!((#row) * (#sites) + (#site));
        }
        match known.operands() {
            Some([parameter, _]) if self.graph.loops.is_wrapped(id) => {
                let parameter = operand(self.index(fields, parameter));
                quote!((#parameter as isize as i64))
            }
            Some(both) => {
                let [a, b] = both.map(|id| {
                    let signed = self.signed_index(fields, id);
                    operand(signed)
                });
                signed_operation(known, a, b)
            }
            None => {
                let natural = operand(self.index(fields, id));
                quote!((#natural as i64))
            }
        }
    }

    /// Lines within a loop.
    pub(crate) fn loop_over(&self, fields: &mut Fields, by: LoopId, lines: &TokenStream) -> TokenStream {
        let (range, index) = (self.graph.loops.get(by), self.running.get(&by));
        let (from, to) = (self.index(fields, range.from), self.index(fields, range.to));
        quote!(for #index in #from..#to { #lines })
    }

    /// An integer expression inside another one.
    pub(crate) fn inner_index(&self, fields: &mut Fields, id: IndexId) -> TokenStream {
        let index = self.index(fields, id);
        match self.graph.loops.index(id) {
            Index::Literal(_) | Index::Running(_) | Index::Length | Index::Parameter(_) => index,
            _ => quote!((#index)),
        }
    }
}

/// The name of a part of the coordinates.
pub(super) fn part_name(part: Part) -> Ident {
    match part {
        Part::Position => format_ident!("q"),
        Part::Momentum => format_ident!("p"),
    }
}

impl Shape {
    /// The type, or the value, of what the coordinates are a list of, where that of a number is `number`.
    pub(crate) fn element(&self, number: TokenStream) -> TokenStream {
        let array = |element, length: &Length| {
            let length = length.tokens();
            quote!([#element; #length])
        };
        self.inner.iter().rev().fold(number, array)
    }
}

impl Length {
    /// The length as Rust.
    pub(crate) fn tokens(&self) -> TokenStream {
        match self {
            Length::Literal(length) => Literal::u64_unsuffixed(*length).to_token_stream(),
            Length::Constant(expression) => operand(expression.to_token_stream()),
            Length::OfStart => quote!(motion.q.len()),
        }
    }
}
