//! Device code for bodies with pair interactions: the motion of a body, and the force of one body on another. The loops
//! over pairs belong to the runtime on the device and have the same order as those on processors.

use super::{Shape, function};
use crate::{
    emit::printer::{
        block::Emitter,
        cuda::{Lines, Reads, Within, evaluate},
    },
    pattern::{
        all_pairs::{AllPairs, ROW},
        bodies::OfBodies,
    },
};

/// The flows of `T` and of `V`, and what these require of the system.
pub(super) fn flows(
    emitter: &mut Emitter<'_>,
    reads: &mut Reads,
    shape: &Shape,
    pairs: &AllPairs,
) -> Result<String, String> {
    if shape.length > ROW {
        return Err(format!(
            "`gpu` supports pair sums over at most {ROW} bodies, and this one has {}\nhelp: write out the pairs, or \
             leave out `gpu`\nnote: more bodies are summed in an order that devices do not reproduce",
            shape.length
        ));
    }
    let AllPairs { drift, force, alone, central, reciprocal, .. } = pairs;
    let mut written = |of: &OfBodies| {
        let within = Within { loops: &of.of, tables: pairs.constants.tables(of), stencil: None };
        evaluate(emitter, reads, within, &of.stores)
    };
    let drift = drift.as_ref().ok_or("`gpu` requires a kinetic energy of bodies")?;
    let Lines { text, program, indices } = written(drift)?;
    let (body, count) = (&indices[0], shape.length);
    let lines =
        format!("const R step = R(duration);\nfor (long long {body} = 0; {body} < {count}; ++{body}) {{\n{text}}}\n");
    let drift = function("drift", "K", "double duration, ", "", &lines, program.reads_time);

    let (name, result, gradient) = match central {
        true => ("pull", "R", String::new()),
        false => ("force", "void", shape.of_body()),
    };
    let force = of_bodies(name, result, &gradient, &written(force)?);
    let alone = match alone {
        None => String::new(),
        Some(alone) => of_bodies("force_alone", "void", &shape.of_body(), &written(alone)?),
    };
    let has_alone = !alone.is_empty();
    let kick =
        function("kick", "K", "double duration, ", "", "Pairs<System, R, K>::kick(motion, duration, at);\n", false);
    Ok(format!(
        "\nstatic constexpr int BODIES = {count};\n\
         static constexpr bool CENTRAL = {central};\n\
         static constexpr bool RECIPROCAL = {reciprocal};\n\
         static constexpr bool ALONE = {has_alone};\n\
         {drift}{force}{alone}{kick}"
    ))
}

/// A function of the bodies with the indices of the loops around its lines.
fn of_bodies(name: &str, result: &str, gradient: &str, Lines { text, program, indices }: &Lines) -> String {
    let time = if program.reads_time { "const R time = R(at);\n" } else { "" };
    let bodies: String = indices.iter().map(|index| format!("int {index}, ")).collect();
    format!(
        "\ntemplate <class R, class K> DEVICE static {result} {name}(Motion<R, K>& motion, {bodies}double at{gradient}) \
         {{\n{time}{text}}}\n"
    )
}

impl Shape {
    /// The argument that is the gradient by the coordinates of a body.
    fn of_body(&self) -> String {
        format!(", R (&gradient)[{}]", self.dimension.unwrap_or(1))
    }
}
