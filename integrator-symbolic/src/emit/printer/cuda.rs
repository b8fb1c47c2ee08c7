//! C++ code for values, indices, conditions and lines of a program, compiled by CUDA for devices.
//!
//! The Rust code is printed from the same program, and both use the same operations: a product inside of a sum is a
//! fused multiply-add in both. Constructs without a device equivalent are recorded, and no device code is generated for
//! them.

mod functions;
mod identifier;
mod partial_sums;
mod reads;
mod sites;

use super::{
    block::Emitter,
    expression::Printer,
    fields::{Content, Fields},
    frame::Frame,
};
use crate::{
    graph::{
        Comparison, Element, Node, NodeId, ParameterId, Part,
        function::{Function, HUGE, LEAST},
        index::{Index, IndexId, LoopId, LoopSet},
    },
    model::{Length, is_constant, is_field},
    program::{Item, Program, Sink, Store, lists::is_over_list, root_cubed, schedule},
    stencil::Stencil,
    syntax::Functions,
};
pub(crate) use functions::device_functions;
use identifier::identifier;
pub(crate) use identifier::identifier_of;
use partial_sums::{PartialSums, partial_sums};
use proc_macro2::Ident;
pub(crate) use reads::{Read, Reads};
use std::collections::{BTreeSet, HashMap};

/// What lines are within: loops that the caller runs, and tables that stand in for what is read of a body with one of their indices.
#[derive(Default)]
pub(crate) struct Within<'w> {
    pub(crate) loops: &'w [LoopId],
    pub(crate) tables: HashMap<NodeId, NodeId>,
    /// The line of sites of which the loop runs over one after the other.
    pub(crate) stencil: Option<&'w Stencil>,
}

/// Lines, with the program that they are printed from and the names of the indices of the loops around them.
pub(crate) struct Lines {
    pub(crate) text: String,
    pub(crate) program: Program,
    pub(crate) indices: Vec<String>,
}

/// The lines that evaluate values and store them; or why there are none.
pub(crate) fn evaluate(
    emitter: &mut Emitter<'_>,
    reads: &mut Reads,
    Within { loops, tables, stencil }: Within<'_>,
    stores: &[Store],
) -> Result<Lines, String> {
    let Emitter { model, names, fields } = emitter;
    let frame = Frame::Motion;
    let program = schedule(&model.graph, stores, |_, id| frame.is_leaf(model, id)).within(loops);
    let printer = Printer::new(model, names, &program, &frame);
    let length = match model.shape.length {
        Length::Literal(length) => length,
        Length::Constant(_) | Length::OfStart => 0,
    };
    let is_of_body = !loops.is_empty();
    let is_alone = loops.is_empty() && stencil.is_none();
    let partial = if is_alone { partial_sums(model, &program) } else { BTreeSet::new() };
    let mut cuda = Cuda {
        printer,
        fields,
        reads,
        tables,
        stencil,
        is_of_body,
        length,
        conditions: 0,
        is_rounded: false,
        partial,
        loops: Vec::new(),
        obstacle: None,
    };
    let indices = loops.iter().map(|by| cuda.open(*by)).collect();
    let text = cuda.items(&program.items);
    match cuda.obstacle {
        None => Ok(Lines { text, program, indices }),
        Some(obstacle) => Err(obstacle),
    }
}

/// How tightly an expression holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

/// A printed expression.
struct Printed(Binding, String);

impl Printed {
    fn atom(text: impl Into<String>) -> Self {
        Self(Binding::Atom, text.into())
    }

    /// In parentheses, unless it holds together at least as tightly as `needed`.
    fn at_least(self, needed: Binding) -> String {
        if self.0 >= needed { self.1 } else { format!("({})", self.1) }
    }
}

/// The printer of one program.
struct Cuda<'m, 'r> {
    printer: Printer<'m>,
    fields: &'r mut Fields,
    reads: &'r mut Reads,
    /// The tables that stand in for what is read of a body.
    tables: HashMap<NodeId, NodeId>,
    /// The line whose sites the lines are about.
    stencil: Option<&'m Stencil>,
    /// Whether a gradient is that of one body.
    is_of_body: bool,
    length: u64,
    /// How many conditions are around the present line.
    conditions: usize,
    /// Whether values are rounded before they are added to a gradient.
    is_rounded: bool,
    /// The sums that are added in the order of lanes.
    partial: BTreeSet<NodeId>,
    /// The loops around it, with the names of their indices.
    loops: Vec<(LoopId, String)>,
    obstacle: Option<String>,
}

impl Cuda<'_, '_> {
    /// Notes what keeps a device from knowing this, in whose place nothing is printed.
    fn refuse(&mut self, obstacle: impl Into<String>) -> String {
        self.obstacle.get_or_insert(obstacle.into());
        String::new()
    }

    fn items(&mut self, items: &[Item]) -> String {
        items.iter().map(|item| self.item(item)).collect()
    }

    fn item(&mut self, item: &Item) -> String {
        match item {
            Item::Let(id) => {
                let kind = if self.printer.graph.node(*id).is_condition() { "bool" } else { "R" };
                let (name, value) = (self.name(*id), self.computation(*id).1);
                format!("const {kind} {name} = {value};\n")
            }
            Item::SineCosine { argument, sine, cosine } => {
                let (sine, cosine, argument) = (self.name(*sine), self.name(*cosine), self.expression(*argument).1);
                let function = self.reads.native("sin_cos").unwrap_or_else(|| "sin_cos".to_owned());
                format!("R {sine}, {cosine};\n{function}({argument}, {sine}, {cosine});\n")
            }
            Item::Begin(id) => match self.printer.graph.node(*id) {
                Node::Fold(fold, ..) => {
                    self.refuse(format!("`gpu` does not support a {} over any number of items", fold.noun()))
                }
                // It is begun after its loop.
                _ if self.partial.contains(id) => String::new(),
                _ => format!("R {} = R(0.0);\n", self.name(*id)),
            },
            Item::Loop { by, body } => {
                let range = self.printer.graph.loops.get(*by);
                let (from, to) = (self.index(range.from), self.index(range.to));
                let index = self.open(*by);
                let is_over_list = is_over_list(self.printer.graph, *by, body);
                let around = std::mem::replace(&mut self.is_rounded, is_over_list);
                let partial = self.partial_sums_of(body, &index, [&from, &to]);
                let body = self.items(body);
                self.is_rounded = around;
                self.loops.pop();
                let PartialSums { begin, open, end } = partial;
                format!("{begin}for (long long {index} = {from}; {index} < {to}; ++{index}) {{\n{open}{body}}}\n{end}")
            }
            Item::Branch { condition, holds, body } => {
                let condition = self.expression(*condition).1;
                self.conditions += 1;
                let body = self.items(body);
                self.conditions -= 1;
                let not = if *holds { "" } else { "!" };
                if body.is_empty() { body } else { format!("if ({not}{condition}) {{\n{body}}}\n") }
            }
            Item::Add { sum, value } => {
                let name = self.name(*sum);
                match self.printer.compared.contains(sum) {
                    true => self.accumulate_rounded(&name, *value),
                    false => self.accumulate(&name, *value),
                }
            }
            Item::Choose { choice, value } => format!("{} = {};\n", self.name(*choice), self.expression(*value).1),
            Item::Sink(Sink::Update(element), value) => self.update(*element, *value),
            Item::Sink(Sink::Collect(element), value) => {
                let target = format!("gradient{}", self.of_gradient(*element));
                if self.is_rounded {
                    self.accumulate_rounded(&target, *value)
                } else {
                    self.accumulate(&target, *value)
                }
            }
            Item::Sink(Sink::Assign(element), value) => {
                format!("gradient{} = {};\n", self.of_gradient(*element), self.expression(*value).1)
            }
            Item::Sink(Sink::Return, value) => format!("return {};\n", self.expression(*value).1),
            Item::Sink(Sink::Contribution(number), value) => self.contribution(*number, *value),
            Item::Sink(..) => self.refuse("`gpu` does not support a flow that is not a sum of kicks"),
        }
    }

    /// A coordinate's update. Under a condition it is an addition, as in Rust, where members in lanes add zero.
    fn update(&mut self, element: Element, value: NodeId) -> String {
        let place = self.place(element);
        match self.printer.product(value).filter(|_| self.conditions == 0) {
            Some((negative, a, b)) => {
                format!("{place}.fma({}, {});\n", self.with_sign(negative, a).1, self.expression(b).1)
            }
            None => format!("{place}.add({});\n", self.expression(value).1),
        }
    }

    /// `target += value`, fused where the value is a product.
    fn accumulate(&mut self, target: &str, value: NodeId) -> String {
        if let Some((negative, a, b)) = self.printer.product(value) {
            let (a, b) = (self.with_sign(negative, a).1, self.expression(b).1);
            return format!("{target} = fma({a}, {b}, {target});\n");
        }
        self.accumulate_rounded(target, value)
    }

    /// The same, where the value is rounded first.
    fn accumulate_rounded(&mut self, target: &str, value: NodeId) -> String {
        match self.printer.graph.node(value) {
            Node::Neg(inner) if !self.printer.names.contains_key(&value) => {
                format!("{target} -= {};\n", self.expression(inner).1)
            }
            _ => format!("{target} += {};\n", self.expression(value).1),
        }
    }

    fn name(&self, id: NodeId) -> String {
        self.printer.names.get(&id).map(identifier).unwrap_or_default()
    }

    fn running(&self, by: LoopId) -> String {
        self.loops.iter().find(|(open, _)| *open == by).map(|(_, index)| index.clone()).unwrap_or_default()
    }

    /// Goes into a loop, and returns the name of its index. In C++ a name means the new index in its own bounds already, so that
    /// one of a loop around it gives way to a name that no user's becomes.
    fn open(&mut self, by: LoopId) -> String {
        let index = self.printer.running.get(&by).map(identifier).unwrap_or_default();
        let is_taken = self.loops.iter().any(|(_, taken)| *taken == index);
        let index = if is_taken { format!("i{}", self.loops.len()) } else { index };
        self.loops.push((by, index.clone()));
        index
    }

    /// An expression, by its name if it has one.
    fn expression(&mut self, id: NodeId) -> Printed {
        if self.printer.names.contains_key(&id) { Printed::atom(self.name(id)) } else { self.computation(id) }
    }

    /// An expression as it is computed, whatever its name.
    fn computation(&mut self, id: NodeId) -> Printed {
        let graph = self.printer.graph;
        let of_site =
            self.stencil.is_some() && matches!(graph.node(id), Node::FromIndex(_)) && !graph.loops_of(id).is_empty();
        if of_site || is_field(graph, self.printer.parameters, id) {
            let table = self.tables.get(&id).copied().unwrap_or(id);
            let name = self.fields.number(graph, self.printer.parameters, table);
            return Printed::atom(self.read(Read::Field(Content::Number(table)), name, graph.loops_of(id)));
        }
        match graph.node(id) {
            Node::Constant(bits) => Printed::atom(constant(f64::from_bits(bits))),
            Node::Parameter(parameter) => {
                // What is no path of a constant is a field.
                debug_assert!(is_constant(&self.printer.parameters[parameter.0 as usize].text));
                let name = quote::format_ident!("path_{}", parameter.0);
                Printed::atom(self.read(Read::Path(parameter), name, LoopSet::EMPTY))
            }
            Node::Coordinate(element) => Printed::atom(match self.stencil {
                Some(stencil) => self.neighbour(stencil, element),
                None => format!("{}.value()", self.place(element)),
            }),
            Node::Time => Printed::atom("time"),
            Node::Middle => Printed::atom(self.refuse("`gpu` does not support formulas that change at certain times")),
            Node::Step => Printed::atom("step"),
            Node::FromIndex(index) => Printed::atom(format!("R(double({}))", self.index(index))),
            Node::Neg(a) => Printed(Binding::Sign, format!("-{}", self.expression(a).at_least(Binding::Atom))),
            Node::Add(a, b) => self.addition(id, a, b),
            Node::Mul(a, b) => self.operation("*", a, b),
            Node::Div(a, b) => match root_cubed(graph, b, |id| self.printer.names.contains_key(&id)) {
                Some(base) if !self.printer.compared.contains(&id) => self.call("div_pow_3_2", &[a, base]),
                _ => self.operation("/", a, b),
            },
            Node::Power(a, 1) => self.call("sqrt", &[a]),
            // Lowering leaves no other power; this prints one all the same.
            Node::Power(a, halves) => {
                let (a, exponent) = (self.expression(a).1, constant(f64::from(halves) / 2.0));
                let function = self.reads.native("powf").unwrap_or_else(|| "powf".to_owned());
                Printed::atom(format!("{function}({a}, {exponent})"))
            }
            Node::Entry(..) => Printed::atom(self.refuse("`gpu` does not support parameters of two bodies")),
            Node::Unary(function, a) => self.function(function, &[a]),
            Node::Binary(function, a, b) => self.function(function, &[a, b]),
            Node::External(id, _) => {
                let name = self.printer.externals[id.0 as usize].name.to_string();
                Printed::atom(self.refuse(format!(
                    "`gpu` does not support `{name}`, which has a stated \
                                                   derivative\nnote: a device cannot call Rust functions"
                )))
            }
            // Of two prepared numbers; the blocks inside of all other choices, and of sums, compute them.
            Node::Select(condition, a, b) => {
                let [condition, a, b] = [condition, a, b].map(|id| self.expression(id).1);
                Printed::atom(format!("({condition} ? {a} : {b})"))
            }
            Node::Sum(_, body) | Node::Fold(_, _, body) => self.expression(body),
            condition => Printed::atom(self.condition(condition)),
        }
    }

    fn operation(&mut self, sign: &str, a: NodeId, b: NodeId) -> Printed {
        let (a, b) = (self.expression(a).at_least(Binding::Product), self.expression(b).at_least(Binding::Sign));
        Printed(Binding::Product, format!("{a} {sign} {b}"))
    }

    fn call(&mut self, name: &str, arguments: &[NodeId]) -> Printed {
        let arguments: Vec<_> = arguments.iter().map(|argument| self.expression(*argument).1).collect();
        Printed::atom(format!("{name}({})", arguments.join(", ")))
    }

    /// An elementary function that a device computes to the same bits, or its own where that is requested.
    fn function(&mut self, function: Function, arguments: &[NodeId]) -> Printed {
        let row = function.row();
        if let Some(name) = self.reads.native(row.name) {
            return self.call(&name, arguments);
        }
        if device_functions().all(|known| known != row.name) {
            let name = row.name;
            let obstacle = format!(
                "`gpu` has no kernel for `{name}`, which H or one of its derivatives calls\nhelp: use other \
                 functions, such as `exp` and `ln`, or the device's own, `gpu(functions = native)`\nnote: the \
                 device's own functions are not bitwise identical to those of the processor"
            );
            return Printed::atom(self.refuse(obstacle));
        }
        let name = match self.printer.functions {
            Functions::Fast => row.fast.unwrap_or(row.name),
            Functions::Precise => row.name,
        };
        self.call(name, arguments)
    }

    /// `sum`, which is `a + b`, where a product among the two is fused with the addition.
    fn addition(&mut self, sum: NodeId, a: NodeId, b: NodeId) -> Printed {
        let is_compared = self.printer.compared.contains(&sum);
        for (product, other) in [(b, a), (a, b)] {
            if !is_compared && let Some((negative, x, y)) = self.printer.product(product) {
                let factor = self.with_sign(negative, x).1;
                let (y, other) = (self.expression(y).1, self.expression(other).1);
                return Printed::atom(format!("fma({factor}, {y}, {other})"));
            }
        }
        let left = self.expression(a).1;
        let (sign, right) = match self.printer.graph.node(b) {
            Node::Neg(subtracted) if !self.printer.names.contains_key(&b) => ("-", subtracted),
            _ => ("+", b),
        };
        Printed(Binding::Sum, format!("{left} {sign} {}", self.expression(right).at_least(Binding::Product)))
    }

    /// A factor, perhaps under a change of sign.
    fn with_sign(&mut self, negative: bool, x: NodeId) -> Printed {
        match self.printer.graph.as_constant(x) {
            Some(number) if negative => Printed::atom(constant(-number)),
            None if negative => Printed(Binding::Sign, format!("-{}", self.expression(x).at_least(Binding::Atom))),
            _ => self.expression(x),
        }
    }

    fn condition(&mut self, condition: Node) -> String {
        match condition {
            Node::Compare(comparison, a, b) => {
                let (a, b) = (self.expression(a).1, self.expression(b).1);
                format!("({a} {} {b})", sign(comparison))
            }
            Node::CompareIndex(comparison, a, b) => {
                let (a, b) = (self.index(a), self.index(b));
                format!("({a} {} {b})", sign(comparison))
            }
            Node::Flag(parameter) => {
                let name = self.fields.flag(self.printer.parameters, parameter);
                let loops = self.printer.graph.loops.of_parameter(parameter);
                format!("(R(0.0) < {})", self.read(Read::Field(Content::Flag(parameter)), name, loops))
            }
            Node::And(a, b) => format!("({} && {})", self.expression(a).1, self.expression(b).1),
            Node::Or(a, b) => format!("({} || {})", self.expression(a).1, self.expression(b).1),
            Node::Not(a) => format!("!({})", self.expression(a).1),
            _ => self.refuse("`gpu` does not support this condition"),
        }
    }

    /// A prepared constant for the present iterations of its loops.
    fn read(&mut self, read: Read, name: Ident, loops: LoopSet) -> String {
        let text = match self.stencil.and_then(|stencil| self.of_sites(stencil, loops)) {
            Some(site) => format!("element_of(motion.parameters.{}, {site})", read.name(&name)),
            None => {
                let at: String = loops.iter().map(|by| format!("[{}]", self.running(by))).collect();
                format!("motion.parameters.{}{at}", read.name(&name))
            }
        };
        self.reads.note(read, name, loops);
        text
    }

    /// An integer that is a field, or a constant that is named by a path.
    fn integer(&mut self, parameter: ParameterId) -> String {
        let parameters = self.printer.parameters;
        if is_constant(&parameters[parameter.0 as usize].text) {
            let name = quote::format_ident!("path_{}", parameter.0);
            return self.read(Read::IntegerPath(parameter), name, LoopSet::EMPTY);
        }
        let (name, loops) =
            (self.fields.integer(parameters, parameter), self.printer.graph.loops.of_parameter(parameter));
        self.read(Read::Field(Content::Integer(parameter)), name, loops)
    }

    /// A coordinate's place: `motion.q[0]`, `motion.p[i][1]`.
    fn place(&mut self, element: Element) -> String {
        let part = if element.part == Part::Position { "q" } else { "p" };
        format!("motion.{part}{}", self.at(element))
    }

    /// The indices of a coordinate.
    fn at(&mut self, element: Element) -> String {
        let index = self.index(element.index);
        let component = element.component.map(|component| format!("[{}]", self.index(component)));
        format!("[{index}]{}", component.unwrap_or_default())
    }

    /// The indices of a component of the gradient.
    fn of_gradient(&mut self, element: Element) -> String {
        match element.component {
            _ if !self.is_of_body => self.at(element),
            None => "[0]".to_owned(),
            Some(component) => format!("[{}]", self.index(component)),
        }
    }

    /// An integer expression, of 64 bits with a sign.
    fn index(&mut self, id: IndexId) -> String {
        let known = self.printer.graph.loops.index(id);
        match known {
            Index::Literal(value) => return value.to_string(),
            Index::Running(by) => return self.running(by),
            Index::Length => return self.length.to_string(),
            Index::Parameter(parameter) => return self.integer(parameter),
            Index::Wrapped(..) => return self.refuse("`gpu` does not support integers that wrap"),
            Index::Typed(_, a) => return self.index(a),
            _ => {}
        }
        let [a, b] = known.operands().unwrap_or([id, id]).map(|id| self.index(id));
        match known {
            Index::Add(..) => format!("({a} + {b})"),
            Index::Sub(..) | Index::Minus(..) => format!("({a} - {b})"),
            Index::Mul(..) => format!("({a} * {b})"),
            Index::Div(..) => format!("({a} / {b})"),
            Index::Rem(..) => format!("({a} % {b})"),
            Index::Monus(..) => format!("({a} < {b} ? 0 : {a} - {b})"),
            _ => format!("({a} < {b} ? {a} : {b})"),
        }
    }
}

fn constant(value: f64) -> String {
    match value {
        _ if value.is_nan() => "not_a_number<R>()".to_owned(),
        LEAST => "least<R>()".to_owned(),
        HUGE => "huge<R>()".to_owned(),
        f64::INFINITY => "infinity<R>()".to_owned(),
        f64::NEG_INFINITY => "(-infinity<R>())".to_owned(),
        _ => format!("R({value:?})"),
    }
}

fn sign(comparison: Comparison) -> &'static str {
    match comparison {
        Comparison::Less => "<",
        Comparison::LessOrEqual => "<=",
        Comparison::Equal => "==",
    }
}
