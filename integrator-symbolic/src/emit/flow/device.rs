//! Flows as device code: a C++ struct that is compiled together with the runtime's stepper for devices.
//!
//! In: a model. Out: the code and the preparation of its constants, or the reason why there is none. Always true:
//! device code is bitwise identical to the Rust flows on a machine with fused multiply-add, since both are printed from
//! the same programs.

mod bodies;
pub(crate) mod exported;
mod line;
mod nested;
mod parts;

use super::constants::extents;
use crate::{
    differentiate::{Contribution, gradient, hessian_product},
    emit::printer::{
        block::Emitter,
        cuda::{Lines, Read, Reads, Within, evaluate},
    },
    graph::Part,
    model::{Length, Model, Split},
    pattern::{
        Pattern, lowered,
        stores::{Pass, passes, stores},
    },
    program::{Sink, is_protected},
    syntax::{DeviceFunctions, names::Names},
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;
use std::fmt::Write;

/// The most coordinates of a state, positions and momenta together: a device keeps them in registers.
const MOST_COORDINATES: u64 = 64;

/// The most elements of a list that is read in a loop whose end is a field or a constant: the device has room for this
/// number, and the runtime rejects members with more.
const LONGEST_LIST: u64 = 16;

/// The flows of a system as text for devices.
pub(crate) struct DeviceText {
    text: String,
    /// How many numbers the constants are.
    constants: u64,
    /// What adds these to a list, in their order.
    pushes: TokenStream,
    /// How many levels of inner steps there are.
    levels: usize,
}

impl DeviceText {
    /// The text, or what keeps a system from having one.
    pub(crate) fn of(
        emitter: &mut Emitter<'_>,
        gradients: [&[Contribution]; 2],
        pattern: &Pattern,
        functions: DeviceFunctions,
    ) -> Result<Self, String> {
        let mut reads = Reads::of(functions);
        let Flows { text, shape, bends } = Flows::of(emitter, &mut reads, gradients, pattern)?;
        Self::with(emitter, &shape, reads, &text, bends)
    }

    /// The struct around the flows.
    fn with(emitter: &mut Emitter<'_>, shape: &Shape, reads: Reads, flows: &str, bends: bool) -> Result<Self, String> {
        let (mut fields, mut loads, mut constants, mut pushes) = (String::new(), String::new(), 0, TokenStream::new());
        for (read, name, _) in reads.found {
            let lengths = match read {
                Read::Path(parameter) => {
                    let text = emitter.model.text(parameter);
                    pushes.extend(quote!(numbers.push(#text);));
                    Vec::new()
                }
                Read::IntegerPath(parameter) => {
                    let text = emitter.model.text(parameter);
                    pushes.extend(quote!(numbers.push(#text as f64);));
                    Vec::new()
                }
                Read::Field(content) => {
                    let runtime = &emitter.names.runtime;
                    let extents = extents(emitter.model, emitter.names, content);
                    let lengths: Vec<_> = extents.iter().map(|extent| extent.unwrap_or(LONGEST_LIST)).collect();
                    pushes.extend(match extents.contains(&None) {
                        true => {
                            let lengths = lengths.iter().map(|length| Literal::u64_unsuffixed(*length));
                            quote!(#runtime::push_lists(&parameters.#name, &[#(#lengths),*], numbers);)
                        }
                        false => quote!(#runtime::push_constants(&parameters.#name, numbers);),
                    });
                    lengths
                }
            };
            let name = read.name(&name);
            let brackets: String = lengths.iter().map(|length| format!("[{length}]")).collect();
            let kind = if read.is_integer() { "long long" } else { "R" };
            let _ = writeln!(fields, "{kind} {name}{brackets};");
            loads += &load(kind, &name, &lengths, constants);
            constants += lengths.iter().product::<u64>();
        }
        let (count, brackets, at) = (shape.count(), shape.brackets(), shape.at("i"));
        let (levels, paired) = (emitter.model.nests.len(), matches!(emitter.model.split, Split::Pair));
        let parts = if levels == 0 { emitter.model.flows() } else { 2 };
        if levels > 0 {
            let (field, line) = nested::STAGES;
            fields += field;
            loads += line;
        }
        let mut text = format!(
            "struct System {{\n\
             static constexpr int COORDINATES = {count};\n\
             static constexpr int CONSTANTS = {constants};\n\
             static constexpr int PARTS = {parts};\n\
             static constexpr bool PAIRED = {paired};\n\
             static constexpr bool BENDS = {bends};\n\
             \n\
             template <class R> struct Parameters {{\n\
             {fields}\
             template <class Source> DEVICE explicit Parameters(const Source& number) {{\n{loads}}}\n\
             }};\n\
             \n\
             template <class R, class K> struct Motion {{\n\
             K q{brackets};\n\
             K p{brackets};\n\
             Parameters<R> parameters;\n\
             DEVICE explicit Motion(const Parameters<R>& parameters) : parameters(parameters) {{}}\n\
             DEVICE K& position(int i) {{ return q{at}; }}\n\
             DEVICE K& momentum(int i) {{ return p{at}; }}\n\
             }};\n\
             {flows}}};\n"
        );
        if constants == 0 {
            text = text.replace("const Source& number", "const Source&");
        }
        Ok(Self { text: indented(&text), constants, pushes, levels })
    }

    /// The items of the runtime's `DeviceText`.
    pub(crate) fn items(&self, names: &Names) -> TokenStream {
        let Self { text, constants, pushes, levels } = self;
        let (runtime, constants) = (&names.runtime, Literal::u64_unsuffixed(*constants));
        let (parameters, numbers) = match pushes.is_empty() {
            true => (quote!(_parameters), quote!(_numbers)),
            false => (quote!(parameters), quote!(numbers)),
        };
        let push_inner_stages = nested::push_stages(*levels, names);
        quote! {
            const TEXT: &'static str = #text;
            const CONSTANTS: usize = #constants;

            fn push_constants(#parameters: &Self::Parameters<f64>, #numbers: &mut #runtime::Vec<f64>) { #pushes }
            #push_inner_stages
        }
    }
}

/// The functions of a system.
struct Flows {
    text: String,
    shape: Shape,
    /// Whether one of them multiplies by the Hessian of `V`.
    bends: bool,
}

impl Flows {
    fn of(
        emitter: &mut Emitter<'_>,
        reads: &mut Reads,
        gradients: [&[Contribution]; 2],
        pattern: &Pattern,
    ) -> Result<Self, String> {
        let shape = Shape::of(emitter.model)?;
        parts::check(emitter.model)?;
        let mut text = match emitter.model.split {
            Split::Nested => nested::flows(emitter, reads, &shape)?,
            _ if emitter.model.is_separable() => {
                separable(emitter, reads, &shape, gradients, pattern)? + &parts::middle(2)
            }
            _ => parts::flows(emitter, reads, &shape, 0)?,
        };
        let bends = emitter.model.quadratic && emitter.model.is_separable();
        if bends {
            text += &hessian(emitter, reads, &shape)?;
        }
        Ok(Self { text, shape, bends })
    }
}

/// The lengths of the coordinates.
struct Shape {
    length: u64,
    dimension: Option<u64>,
}

impl Shape {
    fn of(model: &Model) -> Result<Self, String> {
        let length = |length: &Length| match length {
            Length::Literal(length) => Ok(*length),
            Length::Constant(_) => {
                Err("`gpu` does not support a named constant as the number of coordinates\nhelp: write the number as \
                     a literal"
                    .to_owned())
            }
            Length::OfStart => {
                Err("`gpu` does not support slices of coordinates\nhelp: write an array such as `[f64; 4]`\nnote: a \
                     device keeps the state in registers, so the number of coordinates has to be a literal"
                    .to_owned())
            }
        };
        if model.shape.is_volume() {
            return Err("`gpu` does not support lattices in three dimensions\nhelp: leave out `gpu`".to_owned());
        }
        let shape =
            Self { length: length(&model.shape.length)?, dimension: model.shape.dimension().map(length).transpose()? };
        match 2 * shape.count() {
            numbers if numbers > MOST_COORDINATES => Err(format!(
                "the state has {numbers} numbers, and `gpu` supports at most {MOST_COORDINATES}\nnote: a device keeps \
                 the state of a member in registers"
            )),
            _ => Ok(shape),
        }
    }

    fn count(&self) -> u64 {
        self.length.saturating_mul(self.dimension.unwrap_or(1))
    }

    fn brackets(&self) -> String {
        let dimension = self.dimension.map(|dimension| format!("[{dimension}]"));
        format!("[{}]{}", self.length, dimension.unwrap_or_default())
    }

    /// The indices of a coordinate by its number.
    fn at(&self, number: &str) -> String {
        match self.dimension {
            None => format!("[{number}]"),
            Some(dimension) => format!("[{number} / {dimension}][{number} % {dimension}]"),
        }
    }

    /// A line for each coordinate of a half.
    fn for_each(&self, line: impl Fn(&str) -> String) -> String {
        match self.dimension {
            None => format!("for (int i = 0; i < {}; ++i) {{\n{}}}\n", self.length, line("[i]")),
            Some(dimension) => format!(
                "for (int i = 0; i < {}; ++i) {{\nfor (int d = 0; d < {dimension}; ++d) {{\n{}}}\n}}\n",
                self.length,
                line("[i][d]")
            ),
        }
    }
}

/// The flows of `T` and of `V`.
fn separable(
    emitter: &mut Emitter<'_>,
    reads: &mut Reads,
    shape: &Shape,
    [kinetic, potential]: [&[Contribution]; 2],
    pattern: &Pattern,
) -> Result<String, String> {
    let stencils = match pattern {
        Pattern::AllPairs(pairs) => return bodies::flows(emitter, reads, shape, pairs),
        Pattern::Sites(stencils) => stencils,
    };
    let flows = [("drift", kinetic, Part::Momentum), ("kick", potential, Part::Position)];
    let written = flows.into_iter().zip(stencils).map(|((name, gradient, part), stencil)| {
        let apart = gradient.iter().any(|contribution| is_protected(&mut emitter.model.graph, contribution));
        match stencil.as_ref().filter(|stencil| !apart && stencil.flat.is_none()) {
            Some(stencil) => {
                let stencil = lowered(emitter.model, stencil);
                line::flow(emitter, reads, shape, name, &stencil, part)
            }
            None => flow(emitter, reads, shape, name, gradient, part),
        }
    });
    written.collect()
}

/// The function of a flow.
fn flow(
    emitter: &mut Emitter<'_>,
    reads: &mut Reads,
    shape: &Shape,
    name: &str,
    gradient: &[Contribution],
    part: Part,
) -> Result<String, String> {
    let duration = if part == Part::Momentum { "duration" } else { "-duration" };
    let (lines, reads_time) = lines_along(emitter, reads, shape, gradient, part)?;
    let step = if lines.is_empty() { String::new() } else { step(duration) };
    Ok(function(name, "K", "double duration, ", &step, &lines, reads_time))
}

/// The line that gives the step a value.
fn step(value: &str) -> String {
    format!("const R step = R({value});\n")
}

/// The lines that move coordinates along a gradient by `step`, and whether they read the time.
fn lines_along(
    emitter: &mut Emitter<'_>,
    reads: &mut Reads,
    shape: &Shape,
    gradient: &[Contribution],
    part: Part,
) -> Result<(String, bool), String> {
    let (mut lines, mut reads_time) = (String::new(), false);
    for Pass { stores, moved } in passes(emitter.model, gradient, part) {
        let Lines { text: pass, program, .. } = evaluate(emitter, reads, Within::default(), &stores)?;
        reads_time |= program.reads_time;
        lines += &match moved {
            None => pass,
            Some(moved) => {
                let moved = if moved == Part::Position { "q" } else { "p" };
                let apply = shape.for_each(|at| format!("motion.{moved}{at}.fma(step, gradient{at});\n"));
                format!("{{\nR gradient{} = {{}};\n{pass}{apply}}}\n", shape.brackets())
            }
        };
    }
    Ok((lines, reads_time))
}

/// The function that makes the Hessian of `V` times the momenta of these.
fn hessian(emitter: &mut Emitter<'_>, reads: &mut Reads, shape: &Shape) -> Result<String, String> {
    let model = &mut *emitter.model;
    let potential = gradient(&mut model.graph, model.potential, Part::Position);
    let product = hessian_product(&mut model.graph, &potential, Part::Position);
    let stores = stores(model, &product, Sink::Collect);
    let Lines { text: lines, program, .. } = evaluate(emitter, reads, Within::default(), &stores)?;
    let apply = shape.for_each(|at| format!("motion.p{at} = Plain<R>{{gradient{at}}};\n"));
    let lines = format!("R gradient{} = {{}};\n{lines}{apply}", shape.brackets());
    Ok(function("hessian", "Plain<R>", "", "", &lines, program.reads_time))
}

/// A function of a motion whose coordinates are kept as `slot`.
fn function(name: &str, slot: &str, duration: &str, step: &str, lines: &str, reads_time: bool) -> String {
    let slots = if slot == "K" { ", class K" } else { "" };
    let time = if reads_time { "const R time = R(at);\n" } else { "" };
    format!(
        "\ntemplate <class R{slots}> DEVICE static void {name}(Motion<R, {slot}>& motion, {duration}double at) \
         {{\n{step}{time}{lines}}}\n"
    )
}

/// The lines that load a constant, or a table of them, from the place where it begins.
fn load(kind: &str, name: &str, lengths: &[u64], first: u64) -> String {
    let index = |level: usize| format!("i{level}");
    let place = lengths.iter().enumerate().fold(String::new(), |place, (level, length)| match place.is_empty() {
        true => index(level),
        false => format!("({place}) * {length} + {}", index(level)),
    });
    let at: String = (0..lengths.len()).map(|level| format!("[{}]", index(level))).collect();
    let place = if place.is_empty() { first.to_string() } else { format!("{first} + {place}") };
    let number = if kind == "R" { format!("R(number({place}))") } else { format!("({kind})number({place})") };
    let line = format!("{name}{at} = {number};\n");
    lengths.iter().enumerate().rev().fold(line, |line, (level, length)| {
        let index = index(level);
        format!("for (int {index} = 0; {index} < {length}; ++{index}) {{\n{line}}}\n")
    })
}

/// The text with its blocks indented.
fn indented(text: &str) -> String {
    let (mut indented, mut depth) = (String::new(), 0_usize);
    for line in text.lines() {
        depth -= usize::from(line.starts_with('}')).min(depth);
        if !line.is_empty() {
            indented += &"    ".repeat(depth);
        }
        indented += line;
        indented.push('\n');
        depth += usize::from(line.ends_with('{'));
    }
    indented
}
