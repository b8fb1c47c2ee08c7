//! The size of the generated code: rustc takes minutes for a function of many thousands of operations.

use crate::{
    differentiate::gradient,
    errors::Errors,
    graph::{NodeId, Part},
    limits::COMPILED,
    model::{Called, Model},
    syntax::Input,
};

/// How many times as many operations a function and its gradient have together as the function, at most.
const WITH_GRADIENT: usize = 5;

/// Rejects functions that rustc would take minutes to compile, at the name of the largest one.
pub(super) fn check_size(input: &Input, model: &mut Model, errors: &mut Errors) {
    let energies = [model.kinetic, model.potential];
    let mut operations = model.graph.operations(energies);
    if operations * WITH_GRADIENT <= COMPILED {
        return;
    }
    // A gradient of what is too large by itself would take seconds.
    if operations <= COMPILED {
        let whole = model.graph.add(model.kinetic, model.potential);
        let gradients = [Part::Momentum, Part::Position].map(|part| gradient(&mut model.graph, whole, part));
        let slopes = gradients.iter().flatten().map(|contribution| contribution.value);
        operations = model.graph.operations(slopes.chain(energies));
    }
    if operations <= COMPILED {
        return;
    }
    let named = |name: &str, energy: NodeId| Some((&input.function(name)?.sig.ident, energy));
    let functions: Vec<_> = match &model.called {
        Some(Called::Parts) => {
            let functions = model.parts.iter().flat_map(|part| &part.functions);
            functions.map(|function| (&function.name, function.energy)).collect()
        }
        _ => [("kinetic", model.kinetic), ("potential", model.potential), ("hamiltonian", model.potential)]
            .into_iter()
            .filter_map(|(name, energy)| named(name, energy))
            .collect(),
    };
    let Some((name, _)) = functions.iter().max_by_key(|(_, energy)| model.graph.operations([*energy])) else { return };
    let message = format!(
        "H and its derivatives have more than {COMPILED} operations, here about {operations}, which take rustc minutes\n\
         help: write terms that differ in numbers as a loop over tables, `for k in 0..N {{ sum += C[k] * (W[k] * \
         q[0]).sin(); }}`\nhelp: state the derivative of a helper method that is called in many places, \
         `#[derivative(slope)]`, so that it is called and not written out\nnote: a helper method counts as often as it is \
         called with other arguments"
    );
    errors.at(name, message);
}
