//! Device code for a short line of sites: the computation of each site from its neighbourhood, and the sweep along the
//! line. A site adds its contributions in the same order as the runtime on processors.

use super::{Shape, function};
use crate::{
    emit::printer::{
        block::Emitter,
        cuda::{Lines, Reads, Within, evaluate},
    },
    graph::Part,
    pattern::sites::stores,
    stencil::Stencil,
};

/// The flow along a gradient that is such a stencil.
pub(super) fn flow(
    emitter: &mut Emitter<'_>,
    reads: &mut Reads,
    shape: &Shape,
    name: &str,
    stencil: &Stencil,
    part: Part,
) -> Result<String, String> {
    let [direction] = &stencil.directions[..] else {
        return Err("`gpu` supports lattices along a line, and this one is a plane\nhelp: leave out `gpu`\nnote: the \
                    sites of a plane are summed in an order that devices do not reproduce"
            .to_owned());
    };
    let within = Within { loops: &[direction.place], stencil: Some(stencil), ..Within::default() };
    let Lines { text, program, indices } = evaluate(emitter, reads, within, &stores(stencil))?;
    let (length, onward, site) = (shape.length, stencil.onward().iter().sum::<usize>(), &indices[0]);
    let places = onward + 1;
    let time = if program.reads_time { "const R time = R(at);\n" } else { "" };
    let of_site = format!(
        "\ntemplate <class R, class K> DEVICE static void {name}_of_site(Motion<R, K>& motion, long long {site}, double at, R \
         (&contribution)[{places}]) {{\n{time}{text}}}\n"
    );
    // The contributions of the sites before, the nearest first.
    let carried = if onward == 0 { String::new() } else { format!("R carried[{onward}][{places}] = {{}};\n") };
    let into = match direction.periodic && onward > 0 {
        true => format!(
            "for (int behind = 1; behind <= {onward}; ++behind) {{\n{name}_of_site(motion, {length} - behind, at, carried[behind - 1]);\n}}\n"
        ),
        false => String::new(),
    };
    let arrived: String = (1..places).map(|by| format!("sum = sum + carried[{}][{by}];\n", by - 1)).collect();
    let move_on: String = (0..onward)
        .rev()
        .map(|by| {
            let from = if by == 0 { "own".to_owned() } else { format!("carried[{}]", by - 1) };
            format!("for (int k = 0; k < {places}; ++k) {{\ncarried[{by}][k] = {from}[k];\n}}\n")
        })
        .collect();
    let (moved, sign) = if part == Part::Momentum { ("q", "") } else { ("p", "-") };
    let lines = format!(
        "const R step = R({sign}duration);\n{carried}{into}for (long long site = 0; site < {length}; ++site) {{\n\
         R own[{places}] = {{}};\n\
         {name}_of_site(motion, site, at, own);\n\
         R sum = own[0];\n{arrived}\
         motion.{moved}[site].fma(step, sum);\n{move_on}}}\n"
    );
    Ok(of_site + &function(name, "K", "double duration, ", "", &lines, false))
}
