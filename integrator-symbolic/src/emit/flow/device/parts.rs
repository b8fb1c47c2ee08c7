//! Device code for parts of H with names: a function for the flow of each.

use super::{
    super::{sheared, shifted::gradient_of_shifts},
    Shape, flow, function, lines_along, step,
};
use crate::{
    differentiate::{Contribution, gradient},
    emit::printer::{block::Emitter, cuda::Reads},
    graph::{Part, exact::Exact, shift::Shifted},
    model::{Model, Split},
};

/// Parts that are no sums of shears are solved by the runtime, in Rust.
pub(super) fn check(model: &Model) -> Result<(), String> {
    let refused = |what: &str| {
        Err(format!(
            "`gpu` does not support {what}\nnote: devices integrate drifts, kicks, shears and canonical shifts"
        ))
    };
    match model.split {
        Split::Copies(_) => return refused("`split = symmetric`, which evolves two copies of the state"),
        Split::Whole => return refused("H in one piece, `split = none`"),
        Split::Jacobi(_) => return refused("Jacobi coordinates"),
        Split::Energies | Split::Parts | Split::Pair | Split::Nested => {}
    }
    for part in &model.parts {
        match part.form {
            Exact::OfMomenta | Exact::OfPositions | Exact::Shear | Exact::Shifted(_) => {}
            Exact::Own => return refused(&format!("`{}`, whose flow is hand-written", part.name())),
            Exact::Quadratic(_) => {
                return refused(&format!("`{}`, a quadratic form whose flow is a matrix", part.name()));
            }
            Exact::Kepler(_) => {
                return refused(&format!("`{}`, a Kepler motion whose flow solves Kepler's equation", part.name()));
            }
        }
    }
    Ok(())
}

/// The flows of parts with names, from one on.
pub(super) fn flows(
    emitter: &mut Emitter<'_>,
    reads: &mut Reads,
    shape: &Shape,
    first: usize,
) -> Result<String, String> {
    let count = emitter.model.flows() - first;
    let of = |number: usize| {
        let name = match number {
            0 => "drift".to_owned(),
            last if last + 1 == count => "kick".to_owned(),
            number => format!("middle_{number}"),
        };
        flow_of(emitter, reads, shape, first + number, &name)
    };
    let flows: String = (0..count).map(of).collect::<Result<_, String>>()?;
    Ok(flows + &middle(count))
}

/// The flow of one of them as a function of this name.
pub(super) fn flow_of(
    emitter: &mut Emitter<'_>,
    reads: &mut Reads,
    shape: &Shape,
    part: usize,
    name: &str,
) -> Result<String, String> {
    if let Exact::Shifted(shifted) = &emitter.model.parts[part].form {
        let shifted = shifted.clone();
        return shifted_flow(emitter, reads, shape, name, &shifted);
    }
    let (gradient, by) = part_gradient(emitter.model, part);
    flow(emitter, reads, shape, name, &gradient, by)
}

/// The flow of a part that is a shear between two shifts.
fn shifted_flow(
    emitter: &mut Emitter<'_>,
    reads: &mut Reads,
    shape: &Shape,
    name: &str,
    shifted: &Shifted,
) -> Result<String, String> {
    let graph = &mut emitter.model.graph;
    let (shift, shear) = (gradient_of_shifts(graph, shifted), sheared(graph, shifted.shear));
    let (mut lines, mut reads_time) = (String::new(), false);
    for (duration, gradient, by) in
        [("-1.0", &shift, Part::Position), ("duration", &shear, Part::Momentum), ("1.0", &shift, Part::Position)]
    {
        let (block, is_read) = lines_along(emitter, reads, shape, gradient, by)?;
        lines += &format!("{{\n{}{block}}}\n", step(duration));
        reads_time |= is_read;
    }
    Ok(function(name, "K", "double duration, ", "", &lines, reads_time))
}

/// The gradient whose flow a part is, and what it is taken by.
fn part_gradient(model: &mut Model, part: usize) -> (Vec<Contribution>, Part) {
    let energy = model.parts[part].energy;
    let graph = &mut model.graph;
    match model.parts[part].form {
        Exact::OfMomenta => (gradient(graph, energy, Part::Momentum), Part::Momentum),
        Exact::OfPositions => (gradient(graph, energy, Part::Position), Part::Position),
        _ => (sheared(graph, energy), Part::Momentum),
    }
}

/// The flows between the first and the last, in their order or backwards.
pub(super) fn middle(count: usize) -> String {
    let call = |part: usize| format!("middle_{part}(motion, duration, at);\n");
    let between = 1..count.saturating_sub(1);
    let (forwards, backwards): (String, String) =
        (between.clone().map(call).collect(), between.rev().map(call).collect());
    let lines = match count {
        ..=2 => String::new(),
        3 => forwards,
        _ => format!("if (backwards) {{\n{backwards}}} else {{\n{forwards}}}\n"),
    };
    format!(
        "\ntemplate <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool \
         backwards) {{\n{lines}}}\n"
    )
}
