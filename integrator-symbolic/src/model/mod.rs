//! The meaning of the user's functions.
//!
//! In: the annotated impl. Out: a [`Model`], or errors for every mistake. Always true: the energies are nodes of one
//! arena, helper methods are inlined, loops are sums, names are resolved; later phases only receive valid data.
//!
//! The functions are interpreted on symbols: a variable contains a [`Value`], and an assignment replaces it.

mod code;
mod control;
mod expressions;
mod loops;
pub(crate) mod parameters;
mod system;
pub(crate) mod values;

use crate::{
    errors::Errors,
    graph::{
        Graph, Node, NodeId, ParameterId, Part,
        exact::Exact,
        index::{Index, IndexId, LoopId, LoopSet},
    },
    syntax::{Functions, Input, Nest},
};
pub(crate) use code::sensitive_lists::without_lists;
pub(crate) use code::shape::{Length, Shape};
use code::shape::{Signature, WholeSignature, mismatch, signature, whole_signature};
use code::sign::is_never_negative;
use control::arm::Arm;
pub(crate) use expressions::elementary::known_functions;
pub(crate) use parameters::entries::Entries;
pub(crate) use parameters::parameter_text::{COUNT, Texts};
pub(crate) use parameters::prepared::{is_constant, is_field, is_leaf};
use parameters::running_index::with_indices;
pub(crate) use parameters::text::operand;
use parameters::text::standing_alone;
pub(crate) use parameters::text::with_own_self;
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};
use std::collections::HashMap;
use syn::{BinOp, Expr, ExprBinary, ImplItemFn, ItemUse, Pat, ReturnType, Stmt, spanned::Spanned};
pub(crate) use system::external::{Method, strip};
pub(crate) use system::friction::Rates;
pub(crate) use system::invariant::Invariant;
use system::parts::part_shape;
pub(crate) use system::parts::{ExactPart, PartFunction, factors_of};
use system::sorted_parts::sorted;
use values::guard::Condition;
use values::value::{Opaque, Value, View};

/// An expression of parameters that is evaluated once per run.
pub(crate) struct Parameter {
    /// The user's own expression.
    /// The indices of loops are those of `running_index`, here and below.
    pub(crate) own: TokenStream,
    /// The same, evaluated where the functions evaluate it.
    pub(crate) text: TokenStream,
    /// The code of all its values at once, where that is not an expression of each.
    pub(crate) whole: Option<Whole>,
}

/// The code of all values of a parameter.
#[derive(Clone)]
pub(crate) struct Whole {
    pub(crate) code: TokenStream,
    /// The type of the runtime that it creates for pairs of bodies; `None` of a list of numbers.
    pub(crate) table: Option<&'static str>,
}

impl Parameter {
    /// Its text, with the indices of loops as they are called.
    pub(crate) fn named_text(&self, running: &HashMap<LoopId, Ident>) -> TokenStream {
        with_indices(&self.text, &|by| running.get(&by).cloned().map(Into::into))
    }

    /// The code of all its values at once, if there is any.
    pub(crate) fn named_whole(&self, running: &HashMap<LoopId, Ident>) -> Option<Whole> {
        let Whole { code, table } = self.whole.as_ref()?;
        let code = with_indices(code, &|by| running.get(&by).cloned().map(Into::into));
        Some(Whole { code, table: *table })
    }
}

/// A Hamiltonian that is known to make sense.
pub(crate) struct Model {
    pub(crate) graph: Graph,
    /// `T`, or the first part of H.
    pub(crate) kinetic: NodeId,
    /// `V`, or all other parts together.
    pub(crate) potential: NodeId,
    /// The pace that the user gives, a function of the positions, and the arguments of its function.
    pub(crate) rate: Option<(NodeId, Vec<TokenStream>)>,
    /// Friction, where there is any.
    pub(crate) friction: Option<Rates>,
    /// What the user says is conserved.
    pub(crate) invariants: Vec<Invariant>,
    /// The parts that `split` names, in the order of their letters; none where H is `T + V`.
    pub(crate) parts: Vec<ExactPart>,
    pub(crate) split: Split,
    /// The parts that take inner steps, the outermost first.
    pub(crate) nests: Vec<Nest>,
    pub(crate) shape: Shape,
    /// How many numbers, points or planes the coordinates are, and how many components a point or a plane has.
    pub(crate) lengths: Vec<IndexId>,
    /// What the indices of a coordinate run over, as the user writes them.
    pub(crate) extents: Vec<IndexId>,
    /// The parameters, by their ids.
    pub(crate) parameters: Vec<Parameter>,
    /// What the index of each loop is called.
    pub(crate) running: HashMap<LoopId, Ident>,
    /// The tables that parameters read, as items.
    pub(crate) tables: Vec<TokenStream>,
    /// The runtime crate.
    pub(crate) root: syn::Path,
    /// The user's methods that are called as they are, by their ids.
    pub(crate) externals: Vec<Method>,
    /// The parameters that derivatives are taken by, in the order of the annotation.
    pub(crate) sensitive: Vec<ParameterId>,
    /// Where values stand that are added up, as far as messages request it.
    places: HashMap<NodeId, TokenStream>,
    /// Whether `T = ½ pᵀ M⁻¹ p` with a constant `M`, or what the first part has of `p` beside linear terms.
    pub(crate) quadratic: bool,
    /// Whether no function reads the time.
    pub(crate) autonomous: bool,
    /// How near the elementary functions of the flows have to be.
    pub(crate) functions: Functions,
    /// How the user's functions are called; nothing where one of them is missing or a mistake.
    pub(crate) called: Option<Called>,
}

/// The flows that a composition composes.
#[derive(Clone, Copy)]
pub(crate) enum Split {
    /// Those of `T` and `V`.
    Energies,
    /// Those of the Kepler motions and of the interaction, in Jacobi coordinates.
    Jacobi(Jacobi),
    /// Those of the parts that have names.
    Parts,
    /// Those of the first part and of a symmetric pair, which all others are.
    Pair,
    /// Those of the first part and of all others, which take inner steps.
    Nested,
    /// Those of two copies of the state, each of which moves by the H of the other, and of their coupling.
    Copies(NodeId),
    /// None: H stays in one piece.
    Whole,
}

/// What Jacobi coordinates of bodies are made with: numbers of each body, as nodes inside the loop over all bodies.
#[derive(Clone, Copy)]
pub(crate) struct Jacobi {
    /// The loop over all bodies.
    pub(crate) bodies: LoopId,
    /// The number of the body that leads.
    pub(crate) leading: ParameterId,
    /// The mass by the list of masses.
    pub(crate) mass: NodeId,
    /// What `kinetic` multiplies the momentum by, for the velocity.
    pub(crate) inverse_mass: NodeId,
    /// The strength of the attraction to all bodies before it, and to the one that leads.
    pub(crate) attraction: NodeId,
}

/// The arguments of the user's functions, where `self`, references `q` and `p` to the coordinates, and `time` are at hand.
pub(crate) enum Called {
    /// Those of `kinetic` and of `potential`.
    Separate([Vec<TokenStream>; 2]),
    /// Those of `hamiltonian`.
    Whole(Vec<TokenStream>),
    /// Those of the functions that `split` names, which stand with the parts.
    Parts,
}

impl Model {
    /// The text of a parameter, with the indices of loops as they are called.
    pub(crate) fn text(&self, id: ParameterId) -> TokenStream {
        self.parameters[id.0 as usize].named_text(&self.running)
    }

    /// The user's own text of a parameter, with the indices of loops as they are called.
    pub(crate) fn own_text(&self, id: ParameterId) -> TokenStream {
        with_indices(&self.parameters[id.0 as usize].own, &|by| self.running.get(&by).cloned().map(Into::into))
    }

    /// Where a value stands that is added up, as far as that is known.
    pub(crate) fn place_of(&self, id: NodeId) -> Option<&TokenStream> {
        let of_parameter = || match self.graph.node(id) {
            Node::Parameter(parameter) => Some(&self.parameters[parameter.0 as usize].own),
            _ => None,
        };
        self.places.get(&id).or_else(of_parameter)
    }

    /// The energy of all parts.
    pub(crate) fn energy(&mut self) -> NodeId {
        self.graph.add(self.kinetic, self.potential)
    }

    /// Replaces the energies of the first part and of all others together by equal ones.
    pub(crate) fn set_energies(&mut self, energies: [NodeId; 2]) {
        [self.kinetic, self.potential] = energies;
        if let [first, second] = &mut self.parts[..] {
            [first.energy, second.energy] = energies;
        }
    }

    /// Replaces what the flows follow from by the same with choices by time made in the middle of the step.
    pub(crate) fn choose_in_the_middle(&mut self) {
        let Self { graph, kinetic, potential, parts, .. } = self;
        let mut values: Vec<&mut NodeId> = vec![kinetic, potential];
        for ExactPart { energy, form, .. } in parts {
            values.push(energy);
            if let Exact::Shifted(shifted) = form {
                values.extend(shifted.values());
            }
        }
        let energies: Vec<NodeId> = values.iter().map(|value| **value).collect();
        let chosen = graph.with_choices_in_the_middle(&energies);
        values.into_iter().zip(chosen).for_each(|(value, chosen)| *value = chosen);
    }

    /// Whether the brackets vanish that Nyström compositions leave out: the last of two parts is a function of q alone, and
    /// the first at most quadratic in p with a constant mass matrix.
    fn has_constant_mass(&self) -> bool {
        match &self.parts[..] {
            [] if !self.is_mixed() => {}
            [_, ExactPart { form: Exact::OfPositions, .. }] => {}
            _ => return false,
        }
        self.graph.has_constant_mass(self.kinetic) && !self.graph.reads_time(self.kinetic)
    }

    /// How many parts a composition composes.
    pub(crate) fn flows(&self) -> usize {
        match self.split {
            Split::Whole => 0,
            Split::Copies(_) => 3,
            _ => self.parts.len().max(2),
        }
    }

    /// Whether one function of positions and momenta moves the state.
    pub(crate) fn is_mixed(&self) -> bool {
        matches!(self.split, Split::Copies(_) | Split::Whole)
    }

    /// What Jacobi coordinates are made with, where the motion is in these.
    pub(crate) fn jacobi(&self) -> Option<Jacobi> {
        match self.split {
            Split::Jacobi(jacobi) => Some(jacobi),
            _ => None,
        }
    }

    /// Whether H is `T(p) + V(q)`, in this order and whatever the two are called.
    pub(crate) fn is_separable(&self) -> bool {
        !self.is_mixed()
            && matches!(
                &self.parts[..],
                [] | [ExactPart { form: Exact::OfMomenta, .. }, ExactPart { form: Exact::OfPositions, .. }]
            )
    }
}

/// Reads the functions of `input`, or notes what is wrong with them.
pub(crate) fn model(input: &Input, errors: &mut Errors) -> Option<Model> {
    let is_separate = input.function("kinetic").is_some() && input.function("potential").is_some();
    let whole = input.function("hamiltonian").filter(|_| !is_separate);
    let mut reader = Reader::new(input, errors);
    reader.check_flows();
    let (energies, split, parts, shape, called) = if let Some(stated) = &input.coupling {
        let (energies, coupling, shape, called) = reader.doubled(stated, whole)?;
        (energies, Split::Copies(coupling), Vec::new(), shape, called)
    } else if let Some(at) = input.unsplit {
        let (energies, shape, called) = reader.unsplit(at, whole)?;
        (energies, Split::Whole, Vec::new(), shape, called)
    } else if !input.split.is_empty() && input.coordinates.is_none() {
        let (parts, shape, called) = match sorted(input) {
            Some(function) => reader.sorted_parts(function)?,
            None => reader.named_parts()?,
        };
        let parts = reader.commuting_by_nest(parts);
        let split = match &input.nests[..] {
            [] if input.paired.is_some() && parts.len() > 2 => Split::Pair,
            [] => Split::Parts,
            _ => Split::Nested,
        };
        (reader.first_and_others(&parts), split, parts, shape, called)
    } else {
        let (energies, shape, called) = match whole {
            Some(function) => reader.whole(function)?,
            None => reader.separate()?,
        };
        (energies, Split::Energies, Vec::new(), shape, called)
    };
    let lengths = reader.lengths(&shape);
    let extents = shape.extents().map(|length| reader.length(length)).collect();
    let noted = reader.errors.count();
    let rate = reader.rate(&shape);
    let friction = input.friction.as_ref().and_then(|friction| reader.rates(friction, &shape));
    let mut used: Vec<&str> = match &called {
        Called::Separate(_) => vec!["kinetic", "potential"],
        Called::Whole(_) => vec!["hamiltonian"],
        Called::Parts => Vec::new(),
    };
    let named: Vec<String> = input.split.iter().map(ToString::to_string).collect();
    if let Called::Parts = called {
        used.extend(named.iter().map(String::as_str));
    }
    used.extend((rate.is_some() || reader.errors.count() > noted).then_some("rate"));
    reader.check_passed_over(&used);
    let sensitive = reader.sensitive_parameters();
    let invariants = reader.invariants(&shape);
    let Reader { mut graph, parameters, running, externals, addends, .. } = reader;
    let energies = graph.balance_choices(energies);
    let [kinetic, potential] = energies;
    let autonomous = !graph.reads_time(kinetic) && !graph.reads_time(potential);
    let mut model = Model {
        graph,
        kinetic,
        potential,
        rate,
        friction,
        invariants,
        parts,
        split,
        nests: input.nests.clone(),
        shape,
        lengths,
        extents,
        parameters,
        running,
        tables: Vec::new(),
        root: input.root.clone(),
        externals,
        sensitive,
        places: addends,
        quadratic: false,
        autonomous,
        functions: input.functions,
        called: Some(called),
    };
    model.set_energies(energies);
    model.quadratic = model.has_constant_mass();
    Some(model)
}

/// The model of a Hamiltonian that is zero, of the same shape as that of `input`: its stepper stands where mistakes keep
/// the true one from being written, so that whatever uses the system is not reported as well.
pub(crate) fn stub(input: &Input) -> Option<Model> {
    // What is wrong with the signatures was noted when they were read for the first time.
    let mut noted = Errors::default();
    let shape = [(Part::Position, "potential"), (Part::Momentum, "kinetic")]
        .into_iter()
        .find_map(|(part, name)| Some(signature(input.function(name)?, part, &mut noted)?.shape))
        .or_else(|| Some(whole_signature(input.function("hamiltonian")?, &mut noted)?.shape))
        .or_else(|| input.split.iter().find_map(|name| part_shape(input.function(&name.to_string())?)))?;
    let mut graph = Graph::default();
    let zero = graph.constant(0.0);
    let lengths = vec![graph.loops.intern(Index::Length)];
    let extents = lengths.clone();
    Some(Model {
        graph,
        kinetic: zero,
        potential: zero,
        rate: None,
        friction: None,
        invariants: Vec::new(),
        parts: Vec::new(),
        split: Split::Energies,
        nests: Vec::new(),
        shape,
        lengths,
        extents,
        parameters: Vec::new(),
        running: HashMap::new(),
        tables: Vec::new(),
        root: input.root.clone(),
        externals: Vec::new(),
        sensitive: Vec::new(),
        places: HashMap::new(),
        quadratic: true,
        autonomous: true,
        functions: input.functions,
        called: None,
    })
}

/// The model of an impl without mistakes.
#[cfg(test)]
pub(crate) fn of_text(item: &str) -> Model {
    of_annotated_text("", item)
}

/// The same with arguments of the annotation.
#[cfg(test)]
pub(crate) fn of_annotated_text(arguments: &str, item: &str) -> Model {
    with_input(arguments, item).1
}

/// The same, and what was typed.
#[cfg(test)]
pub(crate) fn with_input(arguments: &str, item: &str) -> (Input, Model) {
    let mut errors = Errors::default();
    let input = crate::syntax::input(arguments.parse().expect("tokens"), item.parse().expect("tokens"), &mut errors);
    let both = input.and_then(|input| model(&input, &mut errors).map(|model| (input, model)));
    match (both, errors.combined()) {
        (Some(both), None) => both,
        (_, error) => panic!("{item}: {error:?}"),
    }
}

/// What to say of a Hamiltonian that is no sum of `T(p)` and `V(q)`.
const NOT_SEPARABLE: &str = "this term mixes q and p, so H is not separable into T(p) + V(q)\nhelp: split H into \
                             parts with exact flows, `split = a + b`, which `integrator-cli show` prints for `split = \
                             none`\nhelp: or keep it in one piece for implicit methods, `split = none`\nhelp: or couple \
                             two copies of the state, `split = symmetric(omega = 20.0)`\nhelp: or change to \
                             coordinates in which T depends on p only";

/// A variable.
pub(crate) struct Binding {
    value: Value,
    /// Whether it was declared with `mut`.
    mutable: bool,
    /// How many loops are around its declaration.
    depth: usize,
}

/// A place in the list of variables.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct BindingId(usize);

/// A variable, or an element of an array that is one.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Target {
    id: BindingId,
    at: Vec<usize>,
}

/// A loop that is being read, with what its body adds to variables from outside.
pub(crate) struct Frame {
    by: LoopId,
    sums: Vec<(Target, NodeId)>,
}

/// The state of reading.
pub(crate) struct Reader<'i> {
    input: &'i Input,
    errors: &'i mut Errors,
    graph: Graph,
    parameters: Vec<Parameter>,
    parameter_ids: HashMap<String, ParameterId>,
    /// Integers of the system and literals with the text that joins them, whose type may be another than that of an index.
    own_integers: HashMap<IndexId, Opaque>,
    /// Expressions of the types that integers of ranges have.
    types: Vec<Opaque>,
    /// Whether the items of the sequence that is read next are indices.
    items_are_indices: bool,
    running: HashMap<LoopId, Ident>,
    externals: Vec<Method>,
    /// The parameters that derivatives are taken by, by their names, as far as they were read.
    sensitive: HashMap<String, ParameterId>,
    bindings: Vec<Binding>,
    /// What variables are declared with, where that is a literal or an array.
    declared_as: HashMap<BindingId, Expr>,
    /// Names in scope, innermost last. A helper method sees its own scopes alone.
    scopes: Vec<HashMap<String, BindingId>>,
    frames: Vec<Frame>,
    shape: Option<Shape>,
    /// The conditions around what is being read, outermost first.
    conditions: Vec<Condition>,
    /// The arms of a `match` that are being read, innermost last.
    arms: Vec<Arm>,
    /// The helper methods being inlined, to find recursion.
    inlining: Vec<String>,
    /// The part that the function may not read, where its signature has it all the same.
    foreign: Option<Part>,
    /// What the functions import, for the expressions that are moved out of them.
    uses: Vec<ItemUse>,
    /// How many expressions were read.
    readings: u32,
    /// How many expressions are being read, one inside of another.
    nested: usize,
    /// Whether a product that mixes positions and momenta was noted.
    misplaced: bool,
    /// Whether products may mix positions and momenta.
    may_mix: bool,
    /// What is added up or subtracted in functions whose products may, and for Jacobi coordinates: values without their sign, and where they stand.
    addends: HashMap<NodeId, TokenStream>,
    /// Reads of the wrong part, with what to say of them if no product mixes both.
    foreign_reads: Vec<(TokenStream, String)>,
}

impl<'i> Reader<'i> {
    fn new(input: &'i Input, errors: &'i mut Errors) -> Self {
        Self {
            input,
            errors,
            graph: Graph::default(),
            parameters: Vec::new(),
            parameter_ids: HashMap::new(),
            own_integers: HashMap::new(),
            types: Vec::new(),
            items_are_indices: false,
            running: HashMap::new(),
            externals: Vec::new(),
            sensitive: HashMap::new(),
            bindings: Vec::new(),
            declared_as: HashMap::new(),
            scopes: Vec::new(),
            frames: Vec::new(),
            shape: None,
            conditions: Vec::new(),
            arms: Vec::new(),
            inlining: Vec::new(),
            foreign: None,
            uses: Vec::new(),
            readings: 0,
            nested: 0,
            misplaced: false,
            may_mix: false,
            addends: HashMap::new(),
            foreign_reads: Vec::new(),
        }
    }

    /// `T` and `V` by `kinetic` and `potential`.
    fn separate(&mut self) -> Option<([NodeId; 2], Shape, Called)> {
        let (input, errors) = (self.input, &mut *self.errors);
        let functions = [(Part::Momentum, "kinetic"), (Part::Position, "potential")].map(|(part, name)| {
            let function = input.function(name);
            if function.is_none() {
                let letter = code::shape::usual_name(part);
                let near = system::parts::is_it(input, name);
                let message = format!(
                    "the impl lacks `fn {name}(&self, {letter}: [f64; N]) -> f64`, one of the two parts of H{near}"
                );
                errors.at(&input.item.self_ty, message);
            }
            function.and_then(|function| Some((part, function, signature(function, part, errors)?)))
        });
        if let [Some((_, _, kinetic)), Some((_, potential_function, potential))] = &functions
            && let Some(message) = mismatch((&potential.shape, " here"), (&kinetic.shape, " in `kinetic`"))
        {
            errors.at(&potential_function.sig.inputs, message);
        }
        let energies = functions.map(|function| {
            let (part, function, signature) = function?;
            let energy = self.energy(part, function, &signature);
            Some((energy?, signature))
        });
        let [Some((kinetic, of_kinetic)), Some((potential, of_potential))] = energies else { return None };
        let called = Called::Separate([of_kinetic.arguments, of_potential.arguments]);
        Some(([kinetic, potential], of_kinetic.shape, called))
    }

    /// `T` and `V` whose sum `hamiltonian` is; notes what of it depends on positions and momenta together.
    fn whole(&mut self, function: &ImplItemFn) -> Option<([NodeId; 2], Shape, Called)> {
        let signature = whole_signature(function, self.errors)?;
        let energy = self.whole_energy(function, &signature)?;
        let energies = self.graph.separated(energy);
        if energies.is_none() {
            self.errors.at(&function.sig.ident, NOT_SEPARABLE);
        }
        Some((energies?, signature.shape, Called::Whole(signature.arguments)))
    }

    /// The pace by `rate`, if that is a function of all positions; a helper of this name with other arguments is none.
    fn rate(&mut self, shape: &Shape) -> Option<(NodeId, Vec<TokenStream>)> {
        let function = self.input.function("rate")?;
        let signature = signature(function, Part::Position, &mut Errors::default())?;
        if mismatch((&signature.shape, ""), (shape, "")).is_some() || signature.foreign.is_some() {
            return None;
        }
        if let Some(time) = signature.time {
            self.errors.at(
                time,
                "`rate` does not depend on time\nhelp: remove this argument\nnote: time transformation integrates the \
                 time along with the motion",
            );
            return None;
        }
        Some((self.energy(Part::Position, function, &signature)?, signature.arguments))
    }

    /// The energy that a function of positions and momenta gives.
    fn whole_energy(&mut self, function: &ImplItemFn, signature: &WholeSignature<'_>) -> Option<NodeId> {
        let value = self.whole_value(function, signature)?;
        self.as_energy(value, function)
    }

    /// What a function of positions and momenta ends in.
    fn whole_value(&mut self, function: &ImplItemFn, signature: &WholeSignature<'_>) -> Option<Value> {
        let WholeSignature { coordinates: [q, p], shape, time, .. } = signature;
        self.foreign = None;
        self.shape = Some(shape.clone());
        self.length(&shape.length);
        self.scopes.push(HashMap::new());
        self.bind(q, Value::View(View { part: Part::Position, at: Vec::new() }));
        self.bind(p, Value::View(View { part: Part::Momentum, at: Vec::new() }));
        self.bind_time(*time);
        let value = self.returned(&function.block);
        self.scopes.pop();
        value
    }

    /// Binds the explicit time, where there is one.
    fn bind_time(&mut self, time: Option<&Pat>) {
        if let Some(time) = time {
            let node = self.graph.time();
            self.bind(time, Value::Real(node));
        }
    }

    /// The energy that a function gives.
    fn energy(&mut self, part: Part, function: &ImplItemFn, signature: &Signature<'_>) -> Option<NodeId> {
        self.shape = Some(signature.shape.clone());
        self.length(&signature.shape.length);
        self.scopes.push(HashMap::new());
        self.bind(signature.own, Value::View(View { part, at: Vec::new() }));
        self.bind_time(signature.time);
        self.misplaced = false;
        self.foreign = None;
        if let Some(foreign) = signature.foreign {
            let wrong = part.other();
            self.foreign = Some(wrong);
            self.bind(&foreign.pat, Value::View(View { part: wrong, at: Vec::new() }));
        }
        let value = self.returned(&function.block);
        self.scopes.pop();
        if let Some(foreign) = signature.foreign {
            self.note_foreign(foreign, part, &function.sig.ident);
            return None;
        }
        self.as_energy(value?, function)
    }

    /// The number that a function ends in.
    fn as_energy(&mut self, value: Value, function: &ImplItemFn) -> Option<NodeId> {
        if let Some(energy) = self.real(&value) {
            return Some(energy);
        }
        // A missing return type was reported when the signature was read.
        if matches!(function.sig.output, ReturnType::Default) {
            return None;
        }
        let last = function.block.stmts.last();
        if let (Value::Integer(_), Some(Stmt::Expr(end, None))) = (&value, last) {
            return self.number(&value, end);
        }
        let place = last.map_or_else(|| function.block.span(), Spanned::span);
        let message = format!("`{}` has to return an energy, but ends in {}", function.sig.ident, value.describe());
        self.errors.at_span(place, message);
        None
    }

    /// Says what is wrong with coordinates that a function may not have: a product that mixes both parts was noted
    /// already; else each read, or, if nothing reads them, the argument.
    fn note_foreign(&mut self, foreign: &syn::PatType, part: Part, name: &Ident) {
        let reads = std::mem::take(&mut self.foreign_reads);
        if self.misplaced {
            return;
        }
        if reads.is_empty() {
            let letter = code::shape::usual_name(part);
            let message = format!(
                "`{name}` takes only `{letter}` as coordinates, since H = T(p) + V(q)\nhelp: remove this argument"
            );
            self.errors.at(foreign, message);
        }
        for (place, message) in reads {
            self.errors.at(place, message);
        }
    }

    fn lookup(&self, name: &str) -> Option<BindingId> {
        self.scopes.iter().rev().find_map(|scope| scope.get(name)).copied()
    }

    fn declare(&mut self, name: String, value: Value) {
        let id = BindingId(self.bindings.len());
        self.bindings.push(Binding { value, mutable: false, depth: self.frames.len() });
        if let Some(scope) = self.scopes.last_mut() {
            scope.insert(name, id);
        }
    }

    /// A variable of its own with the value that another one has now.
    fn copied(&mut self, id: BindingId) -> BindingId {
        let Binding { value, depth, .. } = &self.bindings[id.0];
        let copy = Binding { value: value.clone(), mutable: false, depth: *depth };
        self.bindings.push(copy);
        BindingId(self.bindings.len() - 1)
    }

    /// The id of a parameter with this text, new or known; `kind` distinguishes texts that are read differently.
    fn parameter(&mut self, text: TokenStream, kind: &str, loops: LoopSet) -> ParameterId {
        self.parameter_shown(text.clone(), text, kind, loops)
    }

    /// The same, with another text where it is shown to people.
    fn parameter_shown(&mut self, text: TokenStream, shown: TokenStream, kind: &str, loops: LoopSet) -> ParameterId {
        let otherwise = match kind {
            "condition" => quote!(false),
            "integer" => quote!(0),
            _ => quote!(0.0),
        };
        let own = text;
        self.check_sensitive(&own);
        let (shown, _) = self.in_arms(shown, loops, &otherwise);
        let (text, loops) = self.in_arms(self.by_value(own.clone(), kind), loops, &otherwise);
        let (text, may_be_missing) = self.guarded_text(text, kind, loops, &otherwise);
        let text = standing_alone(text, &self.uses);
        let key = format!("{kind} {loops:?} {text}");
        if let Some(id) = self.parameter_ids.get(&key) {
            return *id;
        }
        let id = ParameterId(self.parameters.len() as u32);
        self.parameters.push(Parameter { own: shown, text, whole: None });
        self.parameter_ids.insert(key, id);
        self.graph.loops.declare_parameter(id, loops);
        if may_be_missing {
            self.graph.declare_maybe_missing(id);
        }
        // What takes its place where it is not evaluated is zero.
        if matches!(kind, "number" | "operand") && syn::parse2(own).is_ok_and(|own| is_never_negative(&own)) {
            self.graph.declare_never_negative(id);
        }
        id
    }

    /// How many numbers, points or planes there are, and how many components each of them has.
    fn lengths(&mut self, shape: &Shape) -> Vec<IndexId> {
        let components = shape.inner.iter().map(|length| self.length(length)).collect::<Vec<_>>();
        let loops = &mut self.graph.loops;
        let components = components.into_iter().reduce(|rows, sites| loops.intern(Index::Mul(rows, sites)));
        std::iter::once(self.length(&shape.length)).chain(components).collect()
    }

    /// A length of the coordinates as an integer.
    fn length(&mut self, length: &Length) -> IndexId {
        let length = self.integer_of_length(length);
        self.graph.loops.declare_extent(length);
        length
    }

    /// The same integer as that of a function with the same sum of constants.
    fn integer_of_length(&mut self, length: &Length) -> IndexId {
        let index = match length {
            Length::Literal(length) => Index::Literal(*length),
            Length::Constant(expression) => match &**expression {
                Expr::Binary(ExprBinary { left, op: BinOp::Add(_), right, .. }) => {
                    let [left, right] = [left, right].map(|part| self.integer_of_length(&Length::of(part)));
                    Index::Add(left, right)
                }
                _ => Index::Parameter(self.parameter(expression.to_token_stream(), "integer", LoopSet::EMPTY)),
            },
            Length::OfStart => Index::Length,
        };
        self.graph.loops.intern(index)
    }
}
