//! Rust tokens for a composition: its type, the facts about it and its table of stages.
//!
//! Coefficients leave their 106 bits here, after all sums. Generated code names `::core` and the runtime crate's
//! private door, nothing else. A declaration that was refused becomes a stub, so that its users still type-check.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use syn::{Path, Visibility, parse_quote};

use super::{
    claims::{Class, Scheme},
    double::Double,
    stages::{Element, Letter, Stages},
    syntax::Declaration,
};

/// The path of the runtime crate where the user does not rename it.
pub(super) fn default_root() -> Path {
    parse_quote!(::integrator_core)
}

/// A declared composition.
pub(super) fn declaration(declaration: &Declaration, name: &str, scheme: Option<&Scheme>, root: &Path) -> TokenStream {
    let Declaration { attributes, visibility, name: ident, .. } = declaration;
    let summary = scheme.map(|scheme| summary(scheme, !attributes.is_empty()));
    let implementation = implementation(ident, name, scheme, root);
    let definition = definition(visibility, ident);
    quote! {
        #(#attributes)*
        #summary
        #definition

        #implementation
    }
}

/// The unit struct, without its documentation.
pub(super) fn definition(visibility: &Visibility, ident: &Ident) -> TokenStream {
    quote! {
        #[derive(
            ::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::default::Default,
            ::core::cmp::PartialEq, ::core::cmp::Eq, ::core::hash::Hash,
        )]
        #visibility struct #ident;
    }
}

/// The two implementations that make a unit struct a composition; stubs without a scheme.
pub(super) fn implementation(ident: &Ident, name: &str, scheme: Option<&Scheme>, root: &Path) -> TokenStream {
    let (order, symmetric, class) =
        scheme.map_or((0, false, Class::General), |scheme| (scheme.order, scheme.proof.symmetric, scheme.class));
    let table = scheme.map_or_else(Table::stub, |scheme| Table::of(&scheme.stages));
    let order = Literal::u32_unsuffixed(order);
    let evaluations = Literal::usize_unsuffixed(table.force_evaluations());
    let stages = table.tokens(root);
    let kick = scheme.filter(|scheme| scheme.stages.has_gradients()).map(|_| gradient_kick(root));
    let (bound, class) = match class {
        Class::General => (quote!(Hamiltonian), quote!(General)),
        Class::QuadraticKinetic => (quote!(QuadraticKinetic), quote!(QuadraticKinetic)),
    };
    quote! {
        impl #root::__private::Scheme for #ident {
            const NAME: &'static str = #name;
            const ORDER: u32 = #order;
            const SYMMETRIC: bool = #symmetric;
            const CLASS: #root::__private::Class = #root::__private::Class::#class;
            const FORCE_EVALUATIONS: usize = #evaluations;
            const STAGES: #root::__private::Stages = #stages;
        }

        impl<__System: #root::__private::#bound> #root::__private::Composition<__System> for #ident {
            #kick
        }
    }
}

/// A kick that also goes along the gradient of the squared force, where the stage asks for it.
fn gradient_kick(root: &Path) -> TokenStream {
    quote! {
        #[inline(always)]
        fn kick(
            flows: &mut impl #root::__private::Flows<__System>,
            stage: &#root::__private::Stage,
            h: f64,
            time: f64,
        ) {
            if stage.gradient != 0.0 {
                flows.gradient_kick(h * stage.kick, h * h * h * stage.gradient, time + h * stage.kick_time);
            } else {
                flows.kick(h * stage.kick, time + h * stage.kick_time);
            }
        }
    }
}

/// The proved facts, as the last paragraph of the documentation.
fn summary(scheme: &Scheme, follows_text: bool) -> TokenStream {
    let Scheme { proof, class, order, .. } = scheme;
    let orders = match (class, proof.general) {
        (Class::General, _) if proof.quadratic.order > *order => {
            format!("Order {order} for every `T`, {} where `T` is quadratic in `p` (proved)", proof.quadratic.order)
        }
        (Class::QuadraticKinetic, Some(general)) => {
            format!("Order {order} where `T` is quadratic in `p` (proved; {} for every other `T`)", general.order)
        }
        (Class::QuadraticKinetic, None) => format!("Order {order} for `T` quadratic in `p` (proved)"),
        (Class::General, _) => format!("Order {order} for every `T` (proved)"),
    };
    let symmetric = if proof.symmetric { "symmetric" } else { "not symmetric" };
    let evaluations = match Table::of(&scheme.stages).force_evaluations() {
        1 => "1 force evaluation".to_owned(),
        many => format!("{many} force evaluations"),
    };
    let facts = format!(" {orders}, {symmetric}, {evaluations} a step.");
    let gap = follows_text.then(|| quote!(#[doc = ""]));
    quote!(#gap #[doc = #facts])
}

/// The rows of a run's loop, merged across step boundaries.
struct Table {
    lead: Letter,
    opening: Row,
    cycle: Vec<Row>,
    closing: Row,
}

/// One drift and one kick, and the fractions of the step at which they read the time.
#[derive(Clone, Copy, PartialEq)]
struct Row {
    drift: Double,
    kick: Double,
    gradient: Double,
    drift_time: Double,
    kick_time: Double,
}

impl Row {
    const NONE: Self = Self {
        drift: Double::ZERO,
        kick: Double::ZERO,
        gradient: Double::ZERO,
        drift_time: Double::ZERO,
        kick_time: Double::ZERO,
    };

    fn set(&mut self, element: &Element, time: Double) {
        match element.letter {
            Letter::T => {
                self.drift = element.coefficient.value;
                self.drift_time = time;
            }
            Letter::V => {
                self.kick = element.coefficient.value;
                self.gradient = element.gradient.value;
                self.kick_time = time;
            }
        }
    }

    fn tokens(&self, root: &Path) -> TokenStream {
        if *self == Self::NONE {
            return quote!(#root::__private::Stage::NONE);
        }
        let [drift, kick, gradient, drift_time, kick_time] =
            [self.drift, self.kick, self.gradient, self.drift_time, self.kick_time].map(number);
        quote! {
            #root::__private::Stage {
                drift: #drift,
                kick: #kick,
                gradient: #gradient,
                drift_time: #drift_time,
                kick_time: #kick_time,
            }
        }
    }
}

impl Table {
    fn stub() -> Self {
        Self { lead: Letter::T, opening: Row::NONE, cycle: vec![Row::NONE], closing: Row::NONE }
    }

    /// The rows of merged stages: each takes the leading letter and the other one behind it. If the sequence ends with
    /// the letter it begins with, that last stage closes a step, and between two steps it is one with the first.
    fn of(stages: &Stages) -> Self {
        let Some(first) = stages.elements().first() else { return Self::stub() };
        let mut table = Self { lead: first.letter, opening: Row::NONE, cycle: Vec::new(), closing: Row::NONE };
        // How far the drifts and the kicks have come. `T` reads the time that the kicks have reached, and conversely.
        let (mut drifted, mut kicked) = (Double::ZERO, Double::ZERO);
        for pair in stages.elements().chunks(2) {
            let mut row = Row::NONE;
            for element in pair {
                match element.letter {
                    Letter::T => {
                        row.set(element, kicked);
                        drifted = drifted + element.coefficient.value;
                    }
                    Letter::V => {
                        row.set(element, drifted);
                        kicked = kicked + element.coefficient.value;
                    }
                }
            }
            table.cycle.push(row);
        }
        table.opening = table.cycle[0];
        if stages.elements().len() % 2 == 1
            && let Some(last) = stages.elements().last()
            && table.cycle.len() > 1
        {
            table.cycle.pop();
            table.closing.set(last, Double::ONE);
            let row = &mut table.cycle[0];
            row.drift = row.drift + table.closing.drift;
            row.kick = row.kick + table.closing.kick;
            row.gradient = row.gradient + table.closing.gradient;
        }
        table
    }

    fn force_evaluations(&self) -> usize {
        let kicks = |row: &&Row| row.kick != Double::ZERO || row.gradient != Double::ZERO;
        self.cycle.iter().filter(kicks).count()
    }

    fn tokens(&self, root: &Path) -> TokenStream {
        let lead = match self.lead {
            Letter::T => quote!(Drift),
            Letter::V => quote!(Kick),
        };
        let opening = self.opening.tokens(root);
        let cycle = self.cycle.iter().map(|row| row.tokens(root));
        let closing = self.closing.tokens(root);
        quote! {
            #root::__private::Stages {
                lead: #root::__private::Lead::#lead,
                opening: #opening,
                cycle: &[#(#cycle),*],
                closing: #closing,
            }
        }
    }
}

/// The nearest `f64`. A minus sign is a token of its own, as the parser has it.
fn number(value: Double) -> TokenStream {
    let value = value.value();
    // Zero has no sign here.
    let sign = (value < 0.0).then(|| quote!(-));
    let magnitude = Literal::f64_unsuffixed(value.abs());
    quote!(#sign #magnitude)
}
