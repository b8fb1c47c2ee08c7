//! The flow of a part that is a shear between two canonical shifts of momenta.

use super::{Flow, sheared};
use crate::{
    differentiate::{Contribution, gradient},
    emit::printer::{block::Emitter, frame::Frame, function::Lines},
    graph::{
        Graph, Part,
        shift::{Shift, Shifted},
    },
    layout::{Form, form_of_loops},
};
use quote::quote;

/// The flow: momenta minus the gradient of the generator, the shear, and momenta plus this gradient where the coordinates are
/// then.
pub(super) fn flow(emitter: &mut Emitter<'_>, shifted: &Shifted) -> Flow {
    let scalar = emitter.names.scalar.clone();
    let (shift, shear) = (gradient_of_shifts(&mut emitter.model.graph, shifted), shifted.shear);
    let shear = sheared(&mut emitter.model.graph, shear);
    let shift = Flow::lines_along(emitter, &shift, Part::Position, &Frame::Motion);
    let Lines { tokens: shear, mut program } = Flow::lines_along(emitter, &shear, Part::Momentum, &Frame::Motion);
    let forms = [&shift.program, &program].map(|program| form_of_loops(emitter.model, program));
    let form = forms.iter().map(|(form, _)| *form).find(|form| *form != Form::Plain).unwrap_or_default();
    let divides = [&shift.program, &program].iter().any(|program| program.divides_by_root_cubed);
    program.reads_time |= shift.program.reads_time;
    let shift = shift.tokens;
    let tokens = quote! {
        {
            let step = #scalar::of(-1.0);
            #shift
        }
        {
            let step = #scalar::of(duration);
            #shear
        }
        let step = #scalar::of(1.0);
        #shift
    };
    Flow {
        body: Lines { tokens, program }.body(&scalar),
        form,
        is_wide: divides || forms.iter().any(|(_, is_wide)| *is_wide),
        is_large: form != Form::Plain,
        ..Flow::default()
    }
}

/// The gradient of the generators. Its component along a kinetic momentum is what is subtracted there, as it is written.
pub(super) fn gradient_of_shifts(graph: &mut Graph, shifted: &Shifted) -> Vec<Contribution> {
    let mut all = Vec::new();
    for Shift { momentum, difference, generator } in &shifted.shifts {
        let element = momentum.partner();
        let of_generator = gradient(graph, *generator, Part::Position);
        let (own, others): (Vec<_>, Vec<_>) = of_generator.into_iter().partition(|part| part.element == element);
        let own = own.into_iter().take(1).map(|part| Contribution { value: *difference, ..part });
        all.extend(own.chain(others));
    }
    all
}
