//! Rust code for statements: lets, loops, branches and stores.

use super::{
    expression::{Dialect, Printer},
    fields::Fields,
    frame::Frame,
    function::Lines,
    lanes::point_of_gradient,
};
use crate::{
    graph::{
        Element, Fold, Graph, Node, NodeId, Part,
        index::{Index, LoopId},
    },
    layout::{has_lanes, lane_context},
    model::{Length, Model, is_field},
    program::{
        Constraints, Item, Program, Sink, Store, lanes::LaneContext, lists::is_over_list, results::Results,
        schedule_with,
    },
    syntax::names::Names,
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// What functions are emitted from: the model, the names of generated items, and the fields that lines read so far.
pub(crate) struct Emitter<'m> {
    pub(crate) model: &'m mut Model,
    pub(crate) names: &'m Names,
    pub(crate) fields: Fields,
}

impl Emitter<'_> {
    /// The lines that evaluate values and store them, but for the loops over `outer`, which the caller runs.
    pub(crate) fn evaluate(&mut self, frame: &Frame<'_>, outer: &[LoopId], stores: &[Store]) -> Lines {
        self.evaluate_with(frame, outer, stores, &Constraints::default())
    }

    /// The same under constraints on the schedule.
    pub(crate) fn evaluate_with(
        &mut self,
        frame: &Frame<'_>,
        outer: &[LoopId],
        stores: &[Store],
        constraints: &Constraints,
    ) -> Lines {
        self.print(frame, outer, stores, constraints, frame.is_of_motion())
    }

    /// The line or lines that evaluate `root`, which is lowered. Their sums have the order of the loops.
    pub(crate) fn value(&mut self, frame: &Frame<'_>, root: NodeId) -> Lines {
        self.returned(frame, root, false)
    }

    /// The same, whose innermost loops may be in lanes; `true` if some are.
    pub(crate) fn value_in_lanes(&mut self, root: NodeId) -> (Lines, bool) {
        let lines = self.returned(&Frame::Motion, root, true);
        let [has_lanes, _] = has_lanes(self.model, &lines.program);
        (lines, has_lanes)
    }

    fn returned(&mut self, frame: &Frame<'_>, root: NodeId, in_lanes: bool) -> Lines {
        let returned = Store { context: Vec::new(), sink: Sink::Return, value: root };
        self.print(frame, &[], &[returned], &Constraints::default(), in_lanes)
    }

    /// The lines, whose innermost loops may be in lanes.
    fn print(
        &mut self,
        frame: &Frame<'_>,
        outer: &[LoopId],
        stores: &[Store],
        constraints: &Constraints,
        in_lanes: bool,
    ) -> Lines {
        let Self { model, names, fields } = self;
        let program = schedule_with(&model.graph, stores, |_, id| frame.is_leaf(model, id), constraints);
        let program = program.hoisted(&model.graph).within(outer);
        let is_kept = |id| is_field(&model.graph, &model.parameters, id);
        let mut block = Block::new(Printer::new(model, names, &program, frame), names);
        block.lanes = in_lanes.then(|| lane_context(model, &program, &is_kept));
        Lines { tokens: block.items(fields, &program.items), program }
    }
}

/// The way in which lines add to a gradient.
pub(super) enum Accumulation {
    /// In the buffer, products in one operation.
    Fused,
    /// In the buffer, what was rounded before.
    Rounded,
    /// In the results of terms that share vectors, which the runtime scatters.
    Lanes(Results),
    /// In the points of the gradient that an iteration in lanes has as arguments: the point and the component of each coordinate.
    Points(BTreeMap<Element, (usize, usize)>),
}

impl Accumulation {
    /// The results of terms that share vectors; empty for other lines.
    pub(super) fn results(self) -> Results {
        match self {
            Self::Lanes(results) => results,
            Self::Fused | Self::Rounded | Self::Points(_) => Results::default(),
        }
    }
}

/// A block being printed.
pub(super) struct Block<'m> {
    pub(super) printer: Printer<'m>,
    pub(super) names: &'m Names,
    pub(super) accumulation: Accumulation,
    /// The conditions around the present line, as masks, outermost first.
    pub(super) masks: Vec<TokenStream>,
    /// The values that the lines have as arguments, if they are those of a vector.
    pub(super) arguments: BTreeSet<NodeId>,
    /// What decides which loops are in lanes; `None` if none is.
    pub(super) lanes: Option<LaneContext<'m>>,
    /// How many conditions were around the beginning of a sum or a choice.
    begun: HashMap<NodeId, usize>,
}

impl<'m> Printer<'m> {
    /// What prints the expressions of a program.
    pub(crate) fn new(model: &'m Model, reserved: &'m Names, program: &'m Program, frame: &'m Frame) -> Self {
        Self {
            graph: &model.graph,
            parameters: &model.parameters,
            lengths: &model.lengths,
            running: &model.running,
            dialect: frame.dialect(),
            names: names(&model.graph, model, &program.named),
            compared: &program.compared,
            scalar: frame.scalar(reserved),
            runtime: &reserved.runtime,
            externals: &model.externals,
            functions: model.functions,
            is_list: matches!(model.shape.length, Length::OfStart),
            counted: Part::Position,
            frame,
        }
    }
}

impl<'m> Block<'m> {
    pub(super) fn new(printer: Printer<'m>, names: &'m Names) -> Self {
        Self {
            printer,
            names,
            accumulation: Accumulation::Fused,
            masks: Vec::new(),
            arguments: BTreeSet::new(),
            lanes: None,
            begun: HashMap::new(),
        }
    }

    pub(super) fn items(&mut self, fields: &mut Fields, items: &[Item]) -> TokenStream {
        let lanes: Vec<_> = items.iter().map(|item| self.loop_in_lanes(items, item)).collect();
        let phases: Vec<_> = items.iter().map(|item| self.phases(items, item)).collect();
        let in_phases = phases.iter().flatten().map(|phases| &phases.middle);
        let in_lanes = lanes.iter().flatten().chain(in_phases);
        let sums: BTreeSet<NodeId> = in_lanes.flat_map(|lanes| lanes.sums.iter().copied()).collect();
        let lines = items.iter().zip(lanes.iter().zip(&phases)).map(|(item, found)| match (item, found) {
            (Item::Begin(id), _) if sums.contains(id) => TokenStream::new(),
            (Item::Loop { by, .. }, (Some(lanes), _)) => self.in_lanes(fields, *by, lanes),
            (Item::Loop { by, .. }, (None, Some(phases))) => self.in_phases(fields, *by, phases),
            _ => self.item(fields, item),
        });
        lines.collect()
    }

    pub(super) fn item(&mut self, fields: &mut Fields, item: &Item) -> TokenStream {
        let printer = &self.printer;
        match item {
            Item::Let(id) if self.arguments.contains(id) => TokenStream::new(),
            Item::Let(id) => {
                let (name, value) = (&printer.names[id], printer.computation(fields, *id).tokens);
                quote!(let #name = #value;)
            }
            Item::SineCosine { argument, sine, cosine } => {
                let (sine, cosine) = (&printer.names[sine], &printer.names[cosine]);
                let argument = printer.receiver(fields, *argument);
                quote!(let (#sine, #cosine) = #argument.sin_cos();)
            }
            Item::Begin(id) => {
                self.begun.insert(*id, self.masks.len());
                let beginning = match printer.graph.node(*id) {
                    Node::Fold(fold, ..) => printer.number(fold.beginning()),
                    _ => self.zero(),
                };
                let name = &printer.names[id];
                quote!(let mut #name = #beginning;)
            }
            Item::Loop { by, body } => {
                if let Some(sum) = self.list_sum(fields, *by, body) {
                    return sum;
                }
                let around = std::mem::replace(&mut self.accumulation, Accumulation::Fused);
                if is_over_list(self.printer.graph, *by, body) {
                    self.accumulation = Accumulation::Rounded;
                }
                let body = self.items(fields, body);
                self.accumulation = around;
                self.printer.loop_over(fields, *by, &body)
            }
            Item::Branch { condition, holds, body } => self.branch(fields, *condition, *holds, body),
            Item::Add { sum, value } => {
                let name = printer.names[sum].to_token_stream();
                let depth = self.begun.get(sum).copied().unwrap_or_default();
                match printer.graph.node(*sum) {
                    Node::Fold(fold, ..) => self.join(fields, fold, &name, *value, depth),
                    _ if printer.compared.contains(sum) => self.accumulate_rounded(fields, name, *value, depth),
                    _ => self.accumulate(fields, name, *value, depth),
                }
            }
            Item::Choose { choice, value } => {
                let (name, value) = (&printer.names[choice], printer.expression(fields, *value).tokens);
                let chosen = self.mask(self.begun.get(choice).copied().unwrap_or_default(), &value, &quote!(#name));
                quote!(#name = #chosen;)
            }
            Item::Sink(Sink::Contribution(contribution), value) => {
                let value = printer.expression(fields, *value).tokens;
                printer.contribution(fields, *contribution, value)
            }
            Item::Sink(Sink::Slope(number), value) => {
                let number = Literal::usize_unsuffixed(*number);
                let value = printer.expression(fields, *value).tokens;
                quote!(slopes[#number] = step.scale_add(#value, slopes[#number]);)
            }
            Item::Sink(Sink::Return, value) => printer.expression(fields, *value).tokens,
            Item::Sink(Sink::Watch(watched), value) => printer.shown(fields, *watched, *value),
            Item::Sink(Sink::Update(element), value) => self.update(fields, *element, *value),
            Item::Sink(Sink::Collect(element), value) => {
                if let Accumulation::Lanes(results) = &mut self.accumulation {
                    let number = results.push(printer.graph, *value, self.masks.is_empty());
                    return number.map(|number| self.result(fields, number, *value)).unwrap_or_default();
                }
                let (at, value) = (printer.at(fields, *element), *value);
                match &self.accumulation {
                    Accumulation::Points(targets) => {
                        let (point, component) = targets.get(element).copied().unwrap_or_default();
                        let (point, component) = (point_of_gradient(point), Literal::usize_unsuffixed(component));
                        self.accumulate(fields, quote!(#point[#component]), value, 0)
                    }
                    Accumulation::Rounded => self.accumulate_rounded(fields, quote!(gradient #at), value, 0),
                    _ => self.accumulate(fields, quote!(gradient #at), value, 0),
                }
            }
            Item::Sink(Sink::FirstDerivative(element), value) => {
                let (part, at) = (printer.part(*element), printer.listed(fields, *element));
                let value = printer.expression(fields, *value).tokens;
                quote!(form.#part(#at, #value);)
            }
            Item::Sink(Sink::SecondDerivative(first, second), value) => {
                let parts = format_ident!("{}{}", printer.part(*first), printer.part(*second));
                let [first, second] = [first, second].map(|element| printer.listed(fields, *element));
                let value = printer.expression(fields, *value).tokens;
                quote!(form.#parts(#first, #second, #value);)
            }
            Item::Sink(Sink::Assign(element), value) => {
                let (at, value) = (printer.at(fields, *element), printer.expression(fields, *value).tokens);
                quote!(gradient #at = #value;)
            }
        }
    }

    /// A value of a term, zero in the lanes in which a condition around it does not hold.
    fn result(&self, fields: &mut Fields, number: usize, value: NodeId) -> TokenStream {
        let value = self.printer.expression(fields, self.printer.graph.without_sign(value)).tokens;
        let (number, value) = (Literal::usize_unsuffixed(number), self.mask(0, &value, &self.zero()));
        quote!(values[#number] = #value;)
    }

    fn zero(&self) -> TokenStream {
        match self.printer.dialect {
            Dialect::Generic => self.printer.lift(quote!(0.0)),
            Dialect::Single => quote!(0.0_f64),
        }
    }

    /// A block that is skipped where no lane needs it.
    fn branch(&mut self, fields: &mut Fields, condition: NodeId, holds: bool, body: &[Item]) -> TokenStream {
        let mask = self.printer.expression(fields, condition).tokens;
        let generic = self.printer.dialect == Dialect::Generic;
        let mask = match (holds, generic) {
            (true, _) => mask,
            (false, true) => quote!(#mask.not()),
            (false, false) => quote!(!#mask),
        };
        self.masks.push(mask.clone());
        let body = self.items(fields, body);
        self.masks.pop();
        match (body.is_empty(), generic) {
            (true, _) => TokenStream::new(),
            (false, true) => quote!(if #mask.any() { #body }),
            (false, false) => quote!(if #mask { #body }),
        }
    }

    /// `value` in the lanes in which all conditions beyond the first `depth` hold, `other` elsewhere.
    fn mask(&self, depth: usize, value: &TokenStream, other: &TokenStream) -> TokenStream {
        let mut masks = self.masks[depth..].iter();
        match (masks.next(), self.printer.dialect) {
            (Some(first), Dialect::Generic) => {
                let scalar = self.printer.scalar;
                quote!(#scalar::select(#first #(.and(#masks))*, #value, #other))
            }
            _ => value.clone(),
        }
    }

    /// A coordinate's update. Under a condition it is an addition, so that lanes that do not take part add zero.
    fn update(&self, fields: &mut Fields, element: Element, value: NodeId) -> TokenStream {
        let printer = &self.printer;
        let place = match printer.frame {
            Frame::Apart => {
                let (part, at) = (printer.part(element), printer.at(fields, element));
                quote!(moved.#part #at)
            }
            // There are as many momenta as positions, and a list is not counted while an element of it is being changed.
            _ if printer.is_list && element.part == Part::Position => {
                Printer { names: HashMap::new(), counted: Part::Momentum, ..*printer }.place(fields, element)
            }
            _ => printer.place(fields, element),
        };
        // A list cannot be read while an element of it is being changed.
        let reads_own = printer.is_list && printer.graph.reads(value, element.part);
        match printer.product(value) {
            Some((negative, a, b)) if self.masks.is_empty() => {
                let constant = printer.constant_factor(a, b);
                let method = if constant.is_some() { quote!(scale_add) } else { quote!(fma) };
                let (a, b) = constant.unwrap_or((a, b));
                let (a, b) = (printer.outer_factor(fields, negative, a), printer.expression(fields, b).tokens);
                match reads_own {
                    true => quote!(let (factor, value) = (#a, #b); #place.#method(factor, value);),
                    false => quote!(#place.#method(#a, #b);),
                }
            }
            _ => {
                let value = self.mask(0, &printer.expression(fields, value).tokens, &self.zero());
                match reads_own {
                    true => quote!(let value = #value; #place.add(value);),
                    false => quote!(#place.add(#value);),
                }
            }
        }
    }

    /// `target *= value`, or `target = target.max(value)`, in the lanes in which all conditions beyond `depth` hold.
    fn join(&self, fields: &mut Fields, fold: Fold, target: &TokenStream, value: NodeId, depth: usize) -> TokenStream {
        let value = self.printer.expression(fields, value);
        let joined = match fold {
            Fold::Product => {
                let value = value.term();
                quote!(#target * #value)
            }
            Fold::Largest => {
                let value = value.tokens;
                quote!(#target.max(#value))
            }
        };
        let joined = self.mask(depth, &joined, target);
        quote!(#target = #joined;)
    }

    /// `target += value`, fused where the value is a product, in the lanes in which all conditions beyond `depth` hold.
    fn accumulate(&self, fields: &mut Fields, target: TokenStream, value: NodeId, depth: usize) -> TokenStream {
        let printer = &self.printer;
        if printer.dialect == Dialect::Generic
            && let Some(product) = printer.product(value)
        {
            let sum = printer.fused(fields, product, &target);
            let sum = self.mask(depth, &sum, &target);
            return quote!(#target = #sum;);
        }
        self.accumulate_rounded(fields, target, value, depth)
    }

    /// The same, where the value is rounded first.
    fn accumulate_rounded(&self, fields: &mut Fields, target: TokenStream, value: NodeId, depth: usize) -> TokenStream {
        let printer = &self.printer;
        let is_masked = self.masks.len() > depth && printer.dialect == Dialect::Generic;
        let (sign, value) = match printer.graph.node(value) {
            Node::Neg(inner) if !printer.names.contains_key(&value) => (quote!(-), inner),
            _ => (quote!(+), value),
        };
        let value = printer.expression(fields, value);
        if is_masked {
            let value = value.term();
            let sum = self.mask(depth, &quote!(#target #sign #value), &target);
            return quote!(#target = #sum;);
        }
        let value = value.tokens;
        let operator = if sign.to_string() == "-" { quote!(-=) } else { quote!(+=) };
        quote!(#target #operator #value;)
    }
}

/// Names that say what a value is: coordinates by theirs, sums and shared subexpressions by number.
fn names(graph: &Graph, model: &Model, named: &BTreeSet<NodeId>) -> HashMap<NodeId, Ident> {
    let mut names = HashMap::new();
    let mut counts: HashMap<&str, u32> = HashMap::new();
    for id in named {
        let kind = match graph.node(*id) {
            Node::Sum(..) => "sum",
            Node::Fold(fold, ..) => fold.name(),
            Node::Select(..) => "choice",
            node if node.is_condition() => "condition",
            _ => "shared",
        };
        let coordinate = match graph.node(*id) {
            Node::Coordinate(element) => coordinate_name(graph, model, element),
            _ => None,
        };
        let name = coordinate.unwrap_or_else(|| {
            let count = counts.entry(kind).or_default();
            *count += 1;
            format!("{kind}_{}", *count - 1)
        });
        names.insert(*id, format_ident!("{name}"));
    }
    names
}

/// `q0`, `p_i_1`: where the indices are numbers or running.
fn coordinate_name(graph: &Graph, model: &Model, element: Element) -> Option<String> {
    let index = |id| match graph.loops.index(id) {
        Index::Literal(value) => Some(value.to_string()),
        Index::Running(by) => model.running.get(&by).map(ToString::to_string),
        _ => None,
    };
    let letter = match element.part {
        Part::Position => "q",
        Part::Momentum => "p",
    };
    let indices = graph.loops.of_coordinate(element).map(index).collect::<Option<Vec<_>>>()?.join("_");
    let separator = if indices.starts_with(|first: char| first.is_ascii_digit()) { "" } else { "_" };
    Some(format!("{letter}{separator}{indices}"))
}
