//! The parts of `H` that `split` names: each is a separate function, checked for a known exact flow.

use crate::model::{
    Called, Parameter, Reader,
    code::shape::{Shape, WholeSignature, lone_part, signature, usual_name, whole_signature},
    parameters::{factors::factors, parameter_text::Texts},
    system::{own_flow::own_flow, sorted_parts::sorts_two_functions},
};
use crate::{
    errors::Errors,
    graph::{
        Element, NodeId, ParameterId, Part,
        exact::{Exact, Obstacle},
        kepler::Stray,
        shift::Unshifted,
    },
    spelling::nearest,
    syntax::Input,
};
use proc_macro2::{Ident, TokenStream};
use std::collections::HashSet;
use syn::ImplItemFn;

/// A part of H with an exact flow.
pub(crate) struct ExactPart {
    /// The functions whose sum it is.
    pub(crate) functions: Vec<PartFunction>,
    pub(crate) energy: NodeId,
    pub(crate) form: Exact,
    /// The method of the user that is its flow, where there is one.
    pub(crate) own: Option<Ident>,
}

/// A function that `split` names.
pub(crate) struct PartFunction {
    pub(crate) name: Ident,
    pub(crate) energy: NodeId,
    /// What it is called with, where `self`, references `q` and `p` to the coordinates, and `time` are at hand.
    pub(crate) arguments: Vec<TokenStream>,
}

impl ExactPart {
    /// The names of its functions, as a sum.
    pub(crate) fn name(&self) -> String {
        let names: Vec<_> = self.functions.iter().map(|function| function.name.to_string()).collect();
        names.join(" + ")
    }
}

/// The function of a part as it was read.
pub(crate) struct Read {
    pub(crate) energy: NodeId,
    pub(crate) shape: Shape,
    pub(crate) arguments: Vec<TokenStream>,
}

/// The factors of a parameter as text, with their exponents.
pub(crate) fn factors_of(parameters: &[Parameter], id: ParameterId) -> Vec<(String, i32)> {
    let factors = factors(parameters[id.0 as usize].text.clone());
    factors.into_iter().map(|(text, exponent)| (text.to_string(), exponent)).collect()
}

impl<'i> Reader<'i> {
    /// The parts in the order of their letters, or notes of what is wrong with them.
    pub(crate) fn named_parts(&mut self) -> Option<(Vec<ExactPart>, Shape, Called)> {
        let input = self.input;
        let mut names = HashSet::new();
        let mut parts = Vec::new();
        let mut shape: Option<Shape> = None;
        if let Some(first) = sorts_two_functions(input) {
            let message = "`split = quadratic + rest` requires H in one function\nhelp: write `fn hamiltonian(&self, \
                           q: [f64; N], p: [f64; N]) -> f64` in place of `kinetic` and `potential`";
            self.errors.at(first, message);
            return None;
        }
        for name in &input.split {
            if !names.insert(name.to_string()) {
                self.errors.at(name, format!("the part `{name}` is named twice"));
                continue;
            }
            let Some(function) = input.function(&name.to_string()) else {
                self.lacks(name);
                continue;
            };
            let Some(read) = self.part(function) else { continue };
            match &shape {
                None => shape = Some(read.shape.clone()),
                Some(first) if first.text() != read.shape.text() => {
                    let (first, here) = (first.text(), read.shape.text());
                    let message = format!(
                        "the coordinates are `{first}` in the first part, but `{here}` here\nhelp: write the same \
                         type in all parts"
                    );
                    self.errors.at(&function.sig.inputs, message);
                    continue;
                }
                Some(_) => {}
            }
            let part = self.judged(&function.sig.ident, read);
            parts.extend(part);
        }
        (parts.len() == input.split.len()).then_some((parts, shape?, Called::Parts))
    }

    /// The energy of the first part, and that of all others together.
    pub(crate) fn first_and_others(&mut self, parts: &[ExactPart]) -> [NodeId; 2] {
        let zero = self.graph.constant(0.0);
        let (first, others) = match parts {
            [first, others @ ..] => (first.energy, others),
            [] => (zero, parts),
        };
        [first, others.iter().fold(zero, |sum, part| self.graph.add(sum, part.energy))]
    }

    /// Says that the impl has no function for a part.
    fn lacks(&mut self, name: &Ident) {
        let near = is_it(self.input, &name.to_string());
        let message =
            format!("the impl lacks `fn {name}(&self, q: [f64; N], p: [f64; N]) -> f64`, which `split` names{near}");
        self.errors.at(name, message);
    }

    /// The energy of a part, a function of positions, of momenta, or of both.
    fn part(&mut self, function: &'i ImplItemFn) -> Option<Read> {
        match lone_part(function, self.errors)? {
            Some(part) => {
                let signature = signature(function, part, self.errors)?;
                let energy = self.energy(part, function, &signature)?;
                Some(Read { energy, shape: signature.shape, arguments: signature.arguments })
            }
            None => {
                let signature = whole_signature(function, self.errors)?;
                self.may_mix = true;
                self.addends.clear();
                let energy = self.whole_energy(function, &signature);
                self.may_mix = false;
                let WholeSignature { shape, arguments, .. } = signature;
                Some(Read { energy: energy?, shape, arguments })
            }
        }
    }

    /// A part whose exact flow is known, or a note of what stands in the way.
    pub(crate) fn judged(&mut self, name: &Ident, read: Read) -> Option<ExactPart> {
        let Read { energy, shape, arguments } = read;
        if ![Part::Position, Part::Momentum].iter().any(|part| self.graph.reads(energy, *part)) {
            let message = format!("the part `{name}` depends on neither q nor p\nhelp: leave it out");
            self.errors.at(name, message);
            return None;
        }
        let own = match own_flow(self.input, name) {
            Some(method) => Some(self.admitted_flow(method, &shape, energy)?),
            None => None,
        };
        let judged = match own {
            Some(_) => Ok(Exact::Own),
            None => {
                let extents = self.lengths(&shape);
                let parameters = &self.parameters;
                let factors_of = |id: ParameterId| factors_of(parameters, id);
                match self.graph.exact(energy, &extents, &factors_of) {
                    Err(obstacles) if obstacles.last() == Some(&Obstacle::ProductOfSums) => {
                        let mut texts = Texts::new(&mut self.parameters, &mut self.running, &self.input.root);
                        self.graph.with_own_loops(energy, &mut texts).map(Exact::Quadratic).ok_or(obstacles)
                    }
                    judged => judged,
                }
            }
        };
        match judged {
            Ok(form) => {
                let functions = vec![PartFunction { name: name.clone(), energy, arguments }];
                Some(ExactPart { functions, energy, form, own })
            }
            Err(obstacles) => {
                self.has_no_flow(name, energy, &obstacles);
                None
            }
        }
    }
}

impl Reader<'_> {
    /// Says that no exact flow is known for a part, at the term that is in the way, if one is.
    fn has_no_flow(&mut self, name: &Ident, energy: NodeId, obstacles: &[Obstacle]) {
        let mut path = self.graph.in_the_way(energy, obstacles);
        let of_shift = obstacles.iter().find_map(|obstacle| match obstacle {
            Obstacle::Shift(unshifted) => Some(unshifted),
            _ => None,
        });
        if let Some(Unshifted::Antiderivative(_, term)) = of_shift {
            path.push(*term);
        }
        let term = path.iter().rev().find_map(|id| self.addends.get(&self.graph.without_sign(*id)));
        let reasons: Vec<String> = obstacles.iter().map(|obstacle| self.reason(obstacle, term.is_some())).collect();
        // Which terms are a part of no function of its own follows from their degree.
        let may_move = self.input.function(&name.to_string()).is_some();
        let advice = match (term, of_shift) {
            _ if self.graph.reads_time(energy) => {
                "move the terms that depend on time to a part of q only, or of p only".to_owned()
            }
            (_, Some(Unshifted::Antiderivative(p, _))) => {
                let [q, p] = [p.partner(), *p].map(|element| self.named(element));
                format!(
                    "use a gauge in which {p} is added to a polynomial in {q}, or to a sine, cosine or exponential of a \
                     linear function of {q}, or keep H in one piece, `split = none`"
                )
            }
            (_, Some(Unshifted::Moved(..))) => "write one part for each kinetic momentum".to_owned(),
            (Some(_), _) if may_move => {
                format!("move this term to another part, or write the flow of `{name}` by hand, `#[flow({name})]`")
            }
            _ => format!("split it into more parts, or write its flow by hand, `#[flow({name})]`"),
        };
        let message = format!("no exact flow is known for `{name}`\nhelp: {advice}\nnote: {}", reasons.join("; "));
        match term {
            Some(term) => self.errors.at(term, message),
            None => self.errors.at(name, message),
        }
    }

    /// What keeps a part from having an exact flow, in words; of an orbit perhaps the term that the message stands at.
    fn reason(&self, obstacle: &Obstacle, is_at_term: bool) -> String {
        match obstacle {
            Obstacle::Conjugates(q, p) => {
                let [q, p] = [q, p].map(|element| self.named(*element));
                format!("it is not a shear, since it depends on {q} and {p}")
            }
            Obstacle::Degree(degree) => {
                format!("it is not a quadratic form in q and p, but a polynomial of degree {degree}")
            }
            Obstacle::Time => "it is a quadratic form in q and p with coefficients that depend on time".to_owned(),
            Obstacle::ProductOfSums => {
                "it is a quadratic form in q and p that multiplies a sum over a loop by itself; write it as one sum \
                 in two loops, over i and j"
                    .to_owned()
            }
            Obstacle::Orbits(stray, _) => {
                let why = match stray {
                    Stray::Term if is_at_term => "this term is neither p² of a body times a number nor k/|q|",
                    Stray::Term => "a term is neither p² of a body times a number nor k/|q|",
                    Stray::Component => "p² or |q| of a body lacks some of its components",
                    Stray::Mass => "the components of a body may have different masses",
                    Stray::Kinetic => "a body with k/|q| has no p²/2m",
                    Stray::Twice => "a body may occur in two of its sums",
                };
                format!("it is not a sum of p²/2m - k/|q| over bodies, since {why}")
            }
            Obstacle::NoPolynomial => "it is not a quadratic form in q and p".to_owned(),
            Obstacle::Shift(Unshifted::Antiderivative(p, _)) => {
                let [q, p] = [p.partner(), *p].map(|element| self.named(element));
                let which = if is_at_term { "this term" } else { "a term of a(q)" };
                format!(
                    "it depends on {p} by {p} - a(q), but no antiderivative of {which} with respect to {q} is known"
                )
            }
            Obstacle::Shift(Unshifted::Moved(p, other)) => {
                let [p, other] = [*p, *other].map(|element| self.named(element));
                format!("it depends on {p} by {p} - a(q), but the canonical shift that removes a(q) also moves {other}")
            }
            Obstacle::Shift(Unshifted::Conjugates(q, p)) => {
                let [q, p] = [*q, *p].map(|element| self.named(element));
                format!("a canonical shift that removes a(q) from a kinetic momentum leaves {q} and {p}")
            }
        }
    }

    /// A coordinate as the user would write it, with `i` for an index that is no number.
    fn named(&self, element: Element) -> String {
        let index = |id| self.graph.loops.literal(id).map_or_else(|| "i".to_owned(), |index| index.to_string());
        let component = element.component.map(|component| format!("[{}]", index(component))).unwrap_or_default();
        format!("{}[{}]{component}", usual_name(element.part), index(element.index))
    }
}

/// The functions of the impl that may have been meant by a name, as the end of a message.
pub(crate) fn is_it(input: &Input, name: &str) -> String {
    let known: Vec<String> = input.functions().map(|function| function.sig.ident.to_string()).collect();
    match &nearest(name, &known)[..] {
        [] => String::new(),
        near => format!("\nhelp: similar names: `{}`", near.join("`, `")),
    }
}

/// The shape of the coordinates of a part's function, if its signature shows it.
pub(crate) fn part_shape(function: &ImplItemFn) -> Option<Shape> {
    // What is wrong with it was noted when it was read for the first time.
    let mut noted = Errors::default();
    match lone_part(function, &mut noted)? {
        Some(part) => Some(signature(function, part, &mut noted)?.shape),
        None => Some(whole_signature(function, &mut noted)?.shape),
    }
}
