//! Readable formulas: the equations of motion in the documentation of the generated code.

mod formula;
mod naming;

use crate::{
    differentiate::{Contribution, fold_branches},
    graph::{
        Comparison, Element, Fold, Node, NodeId, ParameterId, Part, Scope,
        index::{Index, IndexId, LoopId, LoopSet},
    },
    model::{Called, ExactPart, Model, PartFunction, Split},
    program::is_direct,
};
use formula::{Formula, Kind, Tie};
use naming::{LINE, Name};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use std::collections::HashMap;
use syn::{BinOp, Expr, ExprUnary, Lit, UnOp};

/// The equations of motion, one line each.
pub(crate) fn equations(model: &mut Model, kinetic: &[Contribution], potential: &[Contribution]) -> Vec<String> {
    let [kinetic, potential] = [kinetic, potential].map(|gradient| fold_branches(&mut model.graph, gradient));
    let (drift, kick) = (is_direct(&model.graph.loops, &kinetic), is_direct(&model.graph.loops, &potential));
    let all = kinetic.iter().chain(&potential);
    let shown: Vec<_> = all.flat_map(|term| std::iter::once(term.value).chain(term.conditions())).collect();
    let formulas = Formulas::with_names(model, &shown);
    let motion = formulas.motion(&kinetic, false, drift).into_iter().chain(formulas.motion(&potential, true, kick));
    motion.chain(formulas.definitions()).collect()
}

/// `T = ...` and `V = ...`, where the user wrote all of `H` in one function, or `name = ...` for parts with names; of a
/// long formula, that it is long.
pub(crate) fn parts(model: &Model) -> Vec<String> {
    let parts = match model.called {
        Some(Called::Parts | Called::Whole(_)) => energies(model),
        _ => Vec::new(),
    };
    let pair = matches!(model.split, Split::Pair).then(|| match &model.parts[..] {
        [first, others @ ..] => {
            let others: Vec<_> = others.iter().map(ExactPart::name).collect();
            format!("H = {} + ({})", first.name(), others.join(" + "))
        }
        [] => String::new(),
    });
    let nested = matches!(model.split, Split::Nested).then(|| nested(model));
    let pair = pair.or(nested);
    pair.into_iter()
        .chain(parts.into_iter().map(|(name, energy)| format!("{name} = {}", formula(model, energy))))
        .collect()
}

/// A formula, or how long it is.
pub(crate) fn formula(model: &Model, id: NodeId) -> String {
    let formulas = Formulas::of(model);
    formulas.short(id).unwrap_or_else(|| format!("a formula of {} operations", formulas.size(id)))
}

/// H as the sum of its parts, with the inner steps that some take: `H = slow + 8 * Verlet(bonds + kinetic)`.
fn nested(model: &Model) -> String {
    let (mut text, mut first) = ("H = ".to_owned(), 0);
    let names = |parts: &[ExactPart]| parts.iter().map(ExactPart::name).collect::<Vec<_>>().join(" + ");
    for nest in &model.nests {
        let compose = nest
            .compose
            .as_ref()
            .map_or_else(|| "Verlet".to_owned(), |path| quote!(#path).to_string().replace(' ', ""));
        text += &format!("{} + {} * {compose}(", names(&model.parts[first..nest.first]), nest.steps);
        first = nest.first;
    }
    text + &names(&model.parts[first..]) + &")".repeat(model.nests.len())
}

/// The energies with their names: `T` and `V`, those of the parts that `split` names, or `H` where it is in one piece.
fn energies(model: &Model) -> Vec<(String, NodeId)> {
    match model.called {
        Some(Called::Whole(_)) if model.is_mixed() => vec![("H".to_owned(), model.kinetic)],
        Some(Called::Parts | Called::Whole(_)) if !model.parts.is_empty() => {
            functions(model).map(|part| (part.name.to_string(), part.energy)).collect()
        }
        _ => vec![("T".to_owned(), model.kinetic), ("V".to_owned(), model.potential)],
    }
}

/// How many bytes of formulas the generated code states.
const STATED: usize = 1_024;

/// The energies and the equations of motion as a constant for programs, unless these are too long to be read.
pub(crate) fn stated(model: &Model, equations: &[String]) -> Option<TokenStream> {
    let formulas = Formulas::of(model);
    let energies = energies(model).into_iter();
    let energies = energies.filter_map(|(name, energy)| Some(format!("{name} = {}", formulas.short(energy)?)));
    let lines: Vec<String> = energies.chain(equations.iter().cloned()).collect();
    let length: usize = lines.iter().map(String::len).sum();
    (length <= STATED).then(|| quote!(const EQUATIONS: &'static [&'static str] = &[#(#lines),*];))
}

/// Loops as `i in 0..n`.
pub(crate) fn ranges(model: &Model, loops: LoopSet) -> Vec<String> {
    loops.iter().map(|by| Formulas::of(model).range(by)).collect()
}

/// What a condition says about indices and parameters that are no numbers, if it says something: the rest of it may hold
/// or not.
pub(crate) fn condition_of_indices(model: &Model, condition: NodeId, holds: bool) -> Option<String> {
    Formulas::of(model).of_indices(condition, holds).map(|(text, _)| text)
}

/// The equations of motion as the documentation of the implementation.
pub(crate) fn motion_documentation(model: &Model, equations: &[String]) -> TokenStream {
    let lines: Vec<String> = equations.iter().map(|line| format!(" {line}")).collect();
    let class = match model.split {
        Split::Copies(_) => " Two copies of the state are coupled, each of which moves by what H says of the other.",
        Split::Whole => " H is in one piece, for methods that take the whole of its field.",
        Split::Pair => {
            " Each part has an exact flow. Those behind the first are one part of a composition, a symmetric pair."
        }
        Split::Nested => {
            " Each part has an exact flow. Those in parentheses are one part of a composition, which takes inner steps."
        }
        _ if !model.is_separable() => " Each part has an exact flow.",
        _ if model.quadratic => " `T` is quadratic in the momenta, with a constant mass matrix.",
        _ => " `T` is not quadratic in the momenta with a constant mass matrix.",
    };
    let functions = match model.called {
        Some(Called::Whole(_)) => "`hamiltonian`".to_owned(),
        Some(Called::Parts) => listed(&functions(model).map(|part| format!("`{}`", part.name)).collect::<Vec<_>>()),
        _ => "`kinetic` and `potential`".to_owned(),
    };
    let functions = format!(" The equations of motion, derived from {functions}:");
    quote! {
        #[doc = #functions]
        ///
        /// ```text
        #(#[doc = #lines])*
        /// ```
        ///
        #[doc = #class]
    }
}

/// The functions that `split` names.
fn functions(model: &Model) -> impl Iterator<Item = &PartFunction> {
    model.parts.iter().flat_map(|part| &part.functions)
}

/// Words as a list: `a, b and c`.
fn listed(words: &[String]) -> String {
    match words {
        [others @ .., last] if !others.is_empty() => format!("{} and {last}", others.join(", ")),
        _ => words.concat(),
    }
}

/// How many operations a formula has that stands in a message.
const LONG: u64 = 400;

/// Writes formulas over the nodes of a model.
pub(crate) struct Formulas<'m> {
    pub(crate) model: &'m Model,
    /// What has a name of its own.
    pub(crate) names: HashMap<NodeId, Name>,
}

impl<'m> Formulas<'m> {
    pub(crate) fn of(model: &'m Model) -> Self {
        Self { model, names: HashMap::new() }
    }
}

impl Formulas<'_> {
    /// `dq[i]/dt = ...` for every component of a gradient, `+= ...` for its terms where it has several; `force` for
    /// minus the gradient.
    pub(crate) fn motion(&self, gradient: &[Contribution], force: bool, whole: bool) -> Vec<String> {
        let line = |contribution: &Contribution| {
            let Contribution { element, value, .. } = contribution;
            let left = self.left(*element);
            let places: Vec<String> = contribution.loops().map(|by| self.range(by)).collect();
            let right = if force { self.negative(*value) } else { self.read(*value) }.text();
            let sign = if whole { "=" } else { "+=" };
            let places = if places.is_empty() { String::new() } else { format!("   for {}", places.join(", ")) };
            format!("{left} {sign} {right}{places}{}", self.only_if(contribution))
        };
        gradient.iter().map(line).collect()
    }

    /// `, if ...`: the conditions under which a term is there, where a loop lies inside of them.
    fn only_if(&self, contribution: &Contribution) -> String {
        let conditions = contribution.context.iter().filter_map(|around| match *around {
            // That an item after the end of a list adds nothing goes without saying.
            Scope::Branch(condition, holds) if !(holds && self.ends_a_list(condition)) => {
                Some(self.condition(condition, holds))
            }
            _ => None,
        });
        match &conditions.collect::<Vec<_>>()[..] {
            [] => String::new(),
            conditions => format!(", if {}", conditions.join(" and ")),
        }
    }

    /// A formula, if it is short enough for one line.
    pub(crate) fn short(&self, id: NodeId) -> Option<String> {
        (self.size(id) <= LONG).then(|| self.read(id).text())
    }

    /// How many operations a formula shows, shared ones as often as they occur.
    fn size(&self, id: NodeId) -> u64 {
        let mut sizes: HashMap<NodeId, u64> = HashMap::new();
        for part in self.model.graph.reachable([id]) {
            let children = self.model.graph.node(part).children().map(|child| sizes[&child]);
            let size = children.fold(1, u64::saturating_add);
            sizes.insert(part, size);
        }
        sizes[&id]
    }

    /// The left side of the equation that a component of a gradient belongs to.
    fn left(&self, element: Element) -> String {
        format!("d{}/dt", self.coordinate(element.partner()))
    }

    fn sigma(&self, by: LoopId) -> String {
        format!("Σ_{{{}}}", self.range(by))
    }

    /// A loop as `i in 0..n`.
    pub(crate) fn range(&self, by: LoopId) -> String {
        let range = self.model.graph.loops.get(by);
        let name = self.model.running.get(&by).map_or_else(String::new, ToString::to_string);
        format!("{name} in {}..{}", self.index(range.from), self.index(range.to))
    }

    fn coordinate(&self, element: Element) -> String {
        let letter = match element.part {
            Part::Position => "q",
            Part::Momentum => "p",
        };
        let indices = self.model.graph.loops.of_coordinate(element).map(|index| format!("[{}]", self.index(index)));
        format!("{letter}{}", indices.collect::<String>())
    }

    fn index(&self, id: IndexId) -> String {
        let inner = |id| match self.model.graph.loops.index(id) {
            Index::Literal(_) | Index::Running(_) | Index::Length | Index::Parameter(_) => self.index(id),
            _ => format!("({})", self.index(id)),
        };
        let binary = |a, sign, b| format!("{} {sign} {}", inner(a), inner(b));
        match self.model.graph.loops.index(id) {
            Index::Literal(value) => value.to_string(),
            Index::Length => self.length(),
            Index::Running(by) => self.model.running.get(&by).map_or_else(String::new, ToString::to_string),
            Index::Parameter(parameter) => self.text(parameter),
            Index::Add(a, b) => binary(a, '+', b),
            Index::Sub(a, b) => binary(a, '-', b),
            Index::Mul(a, b) => binary(a, '*', b),
            Index::Div(a, b) => binary(a, '/', b),
            Index::Rem(a, b) => binary(a, '%', b),
            Index::Monus(a, b) | Index::Minus(a, b) => binary(a, '-', b),
            Index::Typed(_, a) => self.index(a),
            Index::Wrapped(kind, a) => format!("{} as {}", inner(a), kind.name),
            Index::Min(a, b) => format!("min({}, {})", self.index(a), self.index(b)),
            // Coordinates alone have such an index, and they show its parts.
            Index::InPlane(row, site) => format!("({}, {})", self.index(row), self.index(site)),
        }
    }

    /// The number of coordinates or points: `n`, unless that is the name of a parameter or of the index of a loop.
    fn length(&self) -> String {
        let Model { parameters, running, .. } = self.model;
        let texts = (0..parameters.len()).map(|number| self.text(ParameterId(number as u32)));
        let is_word =
            |text: String| text.split(|next: char| !next.is_alphanumeric() && next != '_').any(|word| word == "n");
        let is_taken = running.values().any(|name| name == "n") || texts.into_iter().any(is_word);
        (if is_taken { "q.len()" } else { "n" }).to_owned()
    }

    /// A node as a formula.
    pub(crate) fn read(&self, id: NodeId) -> Formula {
        match self.names.get(&id) {
            Some(Name { text, halves: 2 }) => Formula::atom(Kind::Function, text.clone()),
            Some(Name { text, halves }) => Formula::atom(Kind::Size, text.clone()).power(*halves),
            None => self.computed(id),
        }
    }

    /// A node as a formula of what it is computed from, whatever its name.
    pub(crate) fn computed(&self, id: NodeId) -> Formula {
        let graph = &self.model.graph;
        match graph.node(id) {
            Node::Constant(_) if graph.is_huge(id) => Formula::atom(Kind::Size, "2^896".to_owned()),
            Node::Constant(bits) => Formula::number(f64::from_bits(bits)),
            Node::Parameter(parameter) => written(&self.model.own_text(parameter)),
            Node::Entry(table, ..) => self.read(table),
            Node::Coordinate(element) => Formula::atom(Kind::Coordinate, self.coordinate(element)),
            Node::Time | Node::Middle => Formula::atom(Kind::Coordinate, "t".to_owned()),
            Node::Step => Formula::atom(Kind::Coordinate, "h".to_owned()),
            Node::FromIndex(index) => match graph.loops.literal(index) {
                Some(number) => Formula::number(number as f64),
                None => opaque(self.index(index)),
            },
            Node::Neg(a) => self.read(a).neg(),
            Node::Add(a, b) => self.read(a).add(self.read(b)),
            Node::Mul(a, b) => self.read(a).mul(self.read(b)),
            Node::Div(a, b) => self.read(a).mul(self.read(b).power(-2)),
            Node::Power(a, halves) => self.read(a).power(halves),
            Node::Unary(row, a) => called(row.name(), &[self.read(a)]),
            Node::Binary(row, a, b) => called(row.name(), &[self.read(a), self.read(b)]),
            Node::External(id, arguments) => {
                let arguments: Vec<String> = arguments.iter().map(|argument| self.read(argument).text()).collect();
                Formula::atom(Kind::Function, self.model.externals[id.0 as usize].written(&arguments.join(", ")))
            }
            // That an item after the end of a list adds nothing goes without saying.
            Node::Select(condition, a, b) if self.ends_a_list(condition) && graph.as_constant(b) == Some(0.0) => {
                self.read(a)
            }
            Node::Select(..) => self.cases(id, Self::read),
            Node::Sum(by, body) => self.total(by, &self.read(body)),
            Node::Fold(fold, by, body) => {
                let sign = match fold {
                    Fold::Product => "Π",
                    Fold::Largest => "max",
                };
                let text = format!("{sign}_{{{}}} {}", self.range(by), self.read(body).text_of(Tie::Product));
                Formula::atom(Kind::Total, text)
            }
            _ => opaque(self.condition(id, true)),
        }
    }

    /// Minus a node, with the sign inside of sums and cases.
    fn negative(&self, id: NodeId) -> Formula {
        match self.model.graph.node(id) {
            _ if self.names.contains_key(&id) => self.read(id).neg(),
            Node::Add(a, b) => self.negative(a).add(self.negative(b)),
            Node::Select(condition, ..) if !self.ends_a_list(condition) => self.cases(id, Self::negative),
            Node::Sum(by, body) => {
                let inside = self.negative(body);
                match inside.text().starts_with('-') {
                    true => self.read(id).neg(),
                    false => self.total(by, &inside),
                }
            }
            _ => self.read(id).neg(),
        }
    }

    fn total(&self, by: LoopId, body: &Formula) -> Formula {
        Formula::atom(Kind::Total, format!("{} {}", self.sigma(by), body.text_of(Tie::Product)))
    }

    /// `{a if c, b if d, else e}`
    fn cases(&self, id: NodeId, read: impl Fn(&Self, NodeId) -> Formula) -> Formula {
        let mut text = String::new();
        let mut last = id;
        while let Node::Select(condition, value, otherwise) = self.model.graph.node(last)
            && (last == id || !self.names.contains_key(&last))
        {
            text += &format!("{} if {}, ", read(self, value).text(), self.condition(condition, true));
            last = otherwise;
        }
        Formula::atom(Kind::Function, format!("{{{text}else {}}}", read(self, last).text()))
    }

    /// A condition, or that it does not hold.
    fn condition(&self, id: NodeId, holds: bool) -> String {
        let graph = &self.model.graph;
        let joined = |a, b, word: &str| {
            let [a, b] = [a, b].map(|part| match graph.node(part) {
                Node::And(..) | Node::Or(..) => format!("({})", self.condition(part, holds)),
                _ => self.condition(part, holds),
            });
            format!("{a} {word} {b}")
        };
        match (graph.node(id), holds) {
            (Node::Compare(comparison, a, b), _) => {
                let moves = |id| graph.reads(id, Part::Position) || graph.reads(id, Part::Momentum);
                // What moves stands on the left.
                let turned = !moves(a) && (moves(b) || graph.is_prepared(a) && !graph.is_prepared(b));
                let (left, right) = if turned { (b, a) } else { (a, b) };
                format!("{} {} {}", self.read(left).text(), sign(comparison, turned, holds), self.read(right).text())
            }
            (Node::CompareIndex(comparison, a, b), _) => {
                format!("{} {} {}", self.index(a), sign(comparison, false, holds), self.index(b))
            }
            (Node::Flag(parameter), true) => self.text(parameter),
            (Node::Flag(parameter), false) => format!("not {}", self.text(parameter)),
            (Node::Not(inner), _) => self.condition(inner, !holds),
            (Node::And(a, b), true) | (Node::Or(a, b), false) => joined(a, b, "and"),
            (Node::Or(a, b), true) | (Node::And(a, b), false) => joined(a, b, "or"),
            _ => self.read(id).text(),
        }
    }

    /// The part of a condition that compares no numbers, or that it does not hold; `true` for the word between parts of it.
    fn of_indices(&self, id: NodeId, holds: bool) -> Option<(String, bool)> {
        let graph = &self.model.graph;
        let (a, b, is_and) = match graph.node(id) {
            Node::Compare(..) => return None,
            Node::Not(inner) => return self.of_indices(inner, !holds),
            Node::And(a, b) => (a, b, holds),
            Node::Or(a, b) => (a, b, !holds),
            _ => return Some((self.condition(id, holds), false)),
        };
        let parts = [self.of_indices(a, holds), self.of_indices(b, holds)];
        match parts {
            [Some(a), Some(b)] => {
                let [a, b] = [a, b].map(|(text, is_joined)| if is_joined { format!("({text})") } else { text });
                Some((format!("{a} {} {b}", if is_and { "and" } else { "or" }), true))
            }
            [Some(one), None] | [None, Some(one)] if is_and => Some(one),
            _ => None,
        }
    }

    /// A parameter as the user wrote it, without the spaces of tokens and without `self`.
    fn text(&self, parameter: ParameterId) -> String {
        readable(&self.model.own_text(parameter))
    }

    /// Whether a condition is that an index is not after the end of a list.
    fn ends_a_list(&self, condition: NodeId) -> bool {
        let graph = &self.model.graph;
        matches!(graph.node(condition), Node::CompareIndex(Comparison::Less, _, end) if graph.loops.mentions_lists(end))
    }

    /// The summands of a node that are not polynomials of degree two at most in the momenta.
    pub(crate) fn not_quadratic(&self, id: NodeId) -> String {
        match self.model.graph.node(id) {
            Node::Add(a, b) => {
                let offends = |id| self.model.graph.degree(id, &[Part::Momentum]).is_none_or(|degree| degree > 2);
                self.not_quadratic(if offends(a) { a } else { b })
            }
            _ => self.short(id).unwrap_or_else(|| "a long one".to_owned()),
        }
    }
}

/// How a comparison is written, from right to left where it is `turned`.
fn sign(comparison: Comparison, turned: bool, holds: bool) -> &'static str {
    match (comparison, turned == holds) {
        (Comparison::Equal, _) => ["!=", "=="][usize::from(holds)],
        (Comparison::Less, false) => ["<=", "<"][usize::from(holds)],
        (Comparison::Less, true) => [">=", ">"][usize::from(holds)],
        (Comparison::LessOrEqual, false) => ["<", "<="][usize::from(holds)],
        (Comparison::LessOrEqual, true) => [">", ">="][usize::from(holds)],
    }
}

/// A function of the table, as it is written.
fn called(name: &str, arguments: &[Formula]) -> Formula {
    let texts: Vec<String> = arguments.iter().map(Formula::text).collect();
    let text = match (name, arguments) {
        ("abs", [a]) => format!("|{}|", a.text()),
        ("remainder", [a, b]) => return opaque(format!("{} % {}", a.text_of(Tie::Product), b.text_of(Tie::Atom))),
        ("powf", [a, b]) => format!("{}^{}", a.text_of(Tie::Atom), b.text_of(Tie::Atom)),
        _ => format!("{name}({})", texts.join(", ")),
    };
    Formula::atom(Kind::Function, text)
}

/// A text that may need parentheses.
fn opaque(text: String) -> Formula {
    let whole = text.chars().all(|letter| letter.is_alphanumeric() || "_.:[]()".contains(letter));
    Formula::atom(if whole { Kind::Parameter } else { Kind::Group }, text)
}

/// An expression of parameters as a formula.
fn written(text: &TokenStream) -> Formula {
    syn::parse2(text.clone()).map_or_else(|_| opaque(readable(text)), |expression| of_expression(&expression))
}

fn of_expression(expression: &Expr) -> Formula {
    let other = || opaque(readable(&expression.to_token_stream()));
    match expression {
        Expr::Paren(inner) => of_expression(&inner.expr),
        Expr::Unary(ExprUnary { op: UnOp::Neg(_), expr, .. }) => of_expression(expr).neg(),
        Expr::Unary(ExprUnary { op: UnOp::Deref(_), expr, .. }) => of_expression(expr),
        Expr::Path(path) if path.path.segments.len() > 1 && path.qself.is_none() => {
            let last = path.path.segments.last().map(|segment| segment.ident.to_string());
            last.filter(|name| name.chars().all(|letter| !letter.is_lowercase())).map_or_else(other, opaque)
        }
        Expr::Cast(cast) if cast.ty.to_token_stream().to_string() == "f64" => of_expression(&cast.expr),
        Expr::Lit(literal) => {
            let number = match &literal.lit {
                Lit::Float(number) => number.base10_parse().ok(),
                Lit::Int(number) => number.base10_parse().ok(),
                _ => None,
            };
            number.map_or_else(other, Formula::number)
        }
        Expr::Binary(binary) => {
            let (a, b) = (of_expression(&binary.left), of_expression(&binary.right));
            match binary.op {
                BinOp::Add(_) => a.add(b),
                BinOp::Sub(_) => a.add(b.neg()),
                BinOp::Mul(_) => a.mul(b),
                BinOp::Div(_) if !b.is_zero() => a.mul(b.power(-2)),
                _ => other(),
            }
        }
        Expr::MethodCall(call) => {
            let name = call.method.to_string();
            let arguments: Vec<Formula> = [&*call.receiver].into_iter().chain(&call.args).map(of_expression).collect();
            match (name.as_str(), &arguments[..]) {
                ("sqrt", [base]) => base.clone().power(1),
                ("recip", [base]) => base.clone().power(-2),
                ("powi", [base, exponent]) => match exponent.as_number() {
                    Some(exponent) => base.clone().power(2 * exponent as i32),
                    None => called(&name, &arguments),
                },
                _ if crate::model::known_functions().any(|known| known == name) => called(&name, &arguments),
                _ => other(),
            }
        }
        _ => other(),
    }
}

/// Tokens with the spaces that a person would leave, and without `self.`.
fn readable(text: &TokenStream) -> String {
    let mut text = text.to_string().replace("self .", "").replace("self.", "");
    for (spaced, tight) in
        [(" . ", "."), (" :: ", "::"), (" [", "["), ("[ ", "["), ("( ", "("), (" )", ")"), (" ,", ",")]
    {
        text = text.replace(spaced, tight);
    }
    let mut tight = String::new();
    for word in text.split_whitespace() {
        // A call has no space in front of its arguments, and a sign none after it; an operator has both.
        let call = word.starts_with('(') && tight.ends_with(|last: char| last.is_alphanumeric() || last == '_');
        let sign = tight == "-" || ["(-", "[-", ", -", "+ -", "* -"].iter().any(|end| tight.ends_with(end));
        if !(tight.is_empty() || call || sign) {
            tight.push(' ');
        }
        tight.push_str(word);
    }
    tight
}

/// The doc comment of a prepared constant: its formula.
pub(crate) fn documentation(model: &Model, id: Option<NodeId>) -> TokenStream {
    let Some(id) = id else { return TokenStream::new() };
    let formulas = Formulas::of(model);
    let formulas = if formulas.size(id) > LINE { Formulas::with_names(model, &[id]) } else { formulas };
    let first = format!("`{}`", formulas.read(id).text());
    let lines = std::iter::once(first).chain(formulas.definitions()).map(|line| format!(" {line}"));
    quote!(#(#[doc = #lines])*)
}
