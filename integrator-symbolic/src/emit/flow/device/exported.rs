//! Device code for programs in other languages: the flows, the energy, and how constants are prepared from the user's fields.
//!
//! In: a model. Out: the functions as they are compiled for devices, with the energy beside them, and the expression of each
//! constant that they read; or the reason why there is no code.

use super::{Flows, function, indented};
use crate::{
    differentiate::Contribution,
    emit::{
        flow::constants::{level_texts, value_text},
        printer::{
            block::Emitter,
            cuda::{Lines, Read, Reads, Within, evaluate},
            fields::Content,
        },
    },
    graph::NodeId,
    model::Split,
    pattern::{Pattern, stores::lower_roots},
    program::{Sink, Store},
    prose::Formulas,
    syntax::DeviceFunctions,
};
use proc_macro2::TokenStream;
use quote::quote;

/// The code of a system for programs in other languages.
#[derive(Clone, Debug)]
pub struct Exported {
    /// The annotated type, as written.
    pub system: String,
    /// The composition in the annotation, as written.
    pub compose: String,
    /// The equations of motion.
    pub equations: Vec<String>,
    /// The functions in the C++ of device code: `drift`, `kick`, `middle`, `energy_of`, and `hessian` if `T` is quadratic.
    pub text: String,
    /// The number of positions, or of points.
    pub length: u64,
    /// The number of components of a point.
    pub dimension: Option<u64>,
    /// The number of flows in a step.
    pub parts: usize,
    /// Whether the last two of three parts are one part of a composition.
    pub paired: bool,
    /// Whether `T = ½ pᵀ M⁻¹ p` with a constant `M`, so that `hessian` exists.
    pub quadratic_kinetic: bool,
    /// What the functions read beside the state.
    pub constants: Vec<ExportedConstant>,
}

/// A prepared constant, or a table of them.
#[derive(Clone, Debug)]
pub struct ExportedConstant {
    /// The name in the code.
    pub name: String,
    /// Whether it is an integer.
    pub is_integer: bool,
    /// The formula, for people.
    pub formula: String,
    /// The loops of a table: the name of each index, the number of its elements, and the condition under which an element is
    /// read at all.
    pub levels: Vec<(String, u64, Option<TokenStream>)>,
    /// The Rust expression of the value, or of an element.
    pub value: TokenStream,
}

/// The code, or what keeps a system from having any.
pub(crate) fn exported(
    emitter: &mut Emitter<'_>,
    gradients: [&[Contribution]; 2],
    energy: NodeId,
    pattern: &Pattern,
) -> Result<Exported, String> {
    if matches!(emitter.model.split, Split::Nested) {
        return Err("`export` does not support parts that take inner steps\nhelp: write the parts without parentheses"
            .to_owned());
    }
    let mut reads = Reads::of(DeviceFunctions::Own);
    let Flows { mut text, shape, bends } =
        Flows::of(emitter, &mut reads, gradients, pattern).map_err(|obstacle| reworded(&obstacle))?;
    let energy = lower_roots(emitter.model, &[energy])[0];
    let returned = Store { context: Vec::new(), sink: Sink::Return, value: energy };
    let Lines { text: lines, program, .. } =
        evaluate(emitter, &mut reads, Within::default(), &[returned]).map_err(|obstacle| reworded(&obstacle))?;
    text += &function("energy_of", "K", "", "", &lines, program.reads_time).replacen("static void", "static R", 1);
    let constants = reads.found.into_iter().map(|(read, name, _)| constant(emitter, read, read.name(&name)));
    Ok(Exported {
        constants: constants.collect::<Result<_, _>>()?,
        system: String::new(),
        compose: String::new(),
        equations: Vec::new(),
        text: indented(&text),
        length: shape.length,
        dimension: shape.dimension,
        parts: emitter.model.flows(),
        paired: matches!(emitter.model.split, Split::Pair),
        quadratic_kinetic: bends,
    })
}

/// An obstacle of device code, without advice about devices.
fn reworded(obstacle: &str) -> String {
    let advice =
        ["\nhelp: leave out `gpu`", ", or leave out `gpu`", ", or the device's own, `gpu(functions = native)`"];
    let plain = advice.iter().fold(obstacle.to_owned(), |text, advice| text.replace(advice, ""));
    let is_kept = |line: &&str| !line.starts_with("note: a device") && !line.starts_with("note: the device");
    let lines: Vec<&str> = plain.lines().filter(is_kept).collect();
    let plain = lines.join("\n").replace("`gpu`", "`export`");
    plain.replace("devices integrate", "`export` supports").replace("devices do not", "`export` does not")
}

fn constant(emitter: &mut Emitter<'_>, read: Read, name: String) -> Result<ExportedConstant, String> {
    let (value, content) = match read {
        Read::Path(parameter) | Read::IntegerPath(parameter) => (emitter.model.text(parameter), None),
        Read::Field(content) => {
            let value = value_text(emitter, content).ok_or_else(|| format!("`export` does not support `{name}`, which is a list made by a method\nhelp: keep an array in a field"))?;
            (value, Some(content))
        }
    };
    let mut levels = Vec::new();
    for (index, length, inside) in content.map(|content| level_texts(emitter, content)).into_iter().flatten() {
        let length = length.ok_or_else(|| {
            format!(
                "`export` does not support `{name}`, a table whose length is known at run time\nhelp: write a number as the end of its loop"
            )
        })?;
        levels.push((index.to_string(), length, inside));
    }
    let formula = content.and_then(Content::node).and_then(|node| Formulas::of(emitter.model).short(node));
    let formula = formula.unwrap_or_else(|| value.to_string().replace("self . ", "").replace(' ', ""));
    let is_flag = matches!(read, Read::Field(Content::Flag(_)));
    let (value, formula) = if is_flag {
        (quote!(if #value { 1.0 } else { 0.0 }), format!("1 if {formula}, else 0"))
    } else {
        (value, formula)
    };
    Ok(ExportedConstant { formula, name, is_integer: read.is_integer(), levels, value })
}
