//! Hand-written flows: `#[flow(part)]` on a method of the impl.

use crate::model::{
    Reader,
    code::{
        attributes::flow_attribute,
        shape::{Shape, is_f64},
    },
};
use crate::{graph::NodeId, syntax::Input};
use proc_macro2::Ident;
use syn::{FnArg, ImplItemFn, ReceiverKind, ReturnType, Safety, Type};

/// The method that is the flow of a part.
pub(crate) fn own_flow<'i>(input: &'i Input, part: &Ident) -> Option<&'i ImplItemFn> {
    input.functions().find(|method| part_of(method).is_some_and(|named| named == *part))
}

/// The part whose flow a method is.
fn part_of(method: &ImplItemFn) -> Option<Ident> {
    flow_attribute(method)?.parse_args().ok()
}

impl Reader<'_> {
    /// Notes flows of what is no part.
    pub(crate) fn check_flows(&mut self) {
        let input = self.input;
        for method in input.functions() {
            let Some(attribute) = flow_attribute(method) else { continue };
            let Some(part) = part_of(method) else {
                self.errors.at(
                    attribute,
                    "`#[flow]` lacks the name of a part of H\nhelp: write, for example, `#[flow(kepler)]`",
                );
                continue;
            };
            if !input.split.contains(&part) {
                let parts: Vec<String> = input.split.iter().map(|part| format!("`{part}`")).collect();
                let named = match &parts[..] {
                    [] => "help: name the parts, `split = a + b`".to_owned(),
                    parts => format!("note: `split` names {}", parts.join(", ")),
                };
                let message = format!("`{part}` is not a part of H\n{named}");
                self.errors.at(&part, message);
            }
        }
    }

    /// The name of a flow whose signature fits, or a note of what is wrong with it.
    pub(crate) fn admitted_flow(&mut self, method: &ImplItemFn, shape: &Shape, energy: NodeId) -> Option<Ident> {
        let name = &method.sig.ident;
        if self.graph.reads_time(energy) {
            let message = "a hand-written flow does not support a part that depends on time\nhelp: make the time a coordinate \
                 with a conjugate momentum";
            self.errors.at(name, message);
            return None;
        }
        if !fits(method) {
            let kind = in_place(shape);
            let message = format!(
                "a flow has to take positions and momenta by `&mut`, and a duration\nhelp: write `fn {name}(&self, q: \
                 &mut {kind}, p: &mut {kind}, duration: f64)`"
            );
            self.errors.at(&method.sig, message);
            return None;
        }
        Some(name.clone())
    }
}

/// The coordinates as a flow takes them.
fn in_place(shape: &Shape) -> String {
    shape.text().trim_start_matches('&').to_owned()
}

/// Whether a method takes `&self`, two mutable references and a number, and returns nothing.
fn fits(method: &ImplItemFn) -> bool {
    let signature = &method.sig;
    let is_plain = signature.asyncness.is_none()
        && !matches!(signature.safety, Safety::Unsafe(_))
        && matches!(signature.output, ReturnType::Default);
    let mut inputs = signature.inputs.iter();
    let looks = matches!(inputs.next(), Some(FnArg::Receiver(receiver)) if matches!(receiver.kind, ReceiverKind::Reference(_, _, None)));
    let moved = |argument: Option<&FnArg>| match argument {
        Some(FnArg::Typed(argument)) => {
            matches!(&*argument.ty, Type::Reference(reference) if reference.mutability.is_some())
        }
        _ => false,
    };
    let (q, p) = (moved(inputs.next()), moved(inputs.next()));
    let duration = matches!(inputs.next(), Some(FnArg::Typed(argument)) if is_f64(&argument.ty));
    is_plain && looks && q && p && duration && inputs.next().is_none()
}
