//! Bodies in Jacobi coordinates: the code of the map and of the Kepler parts.

use crate::{
    emit::printer::{block::Emitter, function::Body},
    judge::coordinates::masses,
    model::Jacobi,
    syntax::{Coordinates, names::Names},
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The layout of the motion, around that of bodies in inertial coordinates.
pub(crate) fn motion(bodies: &TokenStream, dimension: &Literal, names: &Names) -> TokenStream {
    let runtime = &names.runtime;
    quote!(#runtime::Jacobi<#bodies, #dimension>)
}

/// The flow of the Kepler parts.
pub(crate) fn drift() -> Body {
    Body::new(quote!(motion.drift(duration);))
}

/// The flow of the interaction by that of `V`.
pub(crate) fn kick(kick: &TokenStream) -> Body {
    Body::new(quote! {
        let jacobi = motion;
        jacobi.open_kick();
        let motion = &mut jacobi.inertial;
        #kick
        jacobi.close_kick(duration);
    })
}

/// The velocities where the momenta are a force.
pub(crate) fn velocity() -> TokenStream {
    quote! {
        bent = force;
        bent.divide_by_masses();
    }
}

/// The product with the interaction's Hessian by that with the Hessian of `V`.
pub(crate) fn hessian(product: &TokenStream) -> TokenStream {
    quote! {
        let jacobi = motion;
        jacobi.open_hessian();
        let motion = &mut jacobi.inertial;
        #product
        jacobi.close_hessian();
    }
}

/// The energy of a part by that of `T` or of `V`, whose name this is.
pub(crate) fn energy(name: &str, energy: &TokenStream) -> TokenStream {
    let sign = if name == "kinetic" { quote!(-) } else { quote!(+) };
    quote! {
        let jacobi = motion;
        let motion = &jacobi.to_inertial().plain::<Self::Coords>();
        let energy = { #energy };
        energy #sign jacobi.attraction()
    }
}

/// A function of positions and momenta, which are those of the user there.
pub(crate) fn in_own_coordinates(value: &TokenStream) -> TokenStream {
    quote! {
        let motion = &motion.to_inertial().plain::<Self::Coords>();
        #value
    }
}

/// What the runtime requires of the prepared constants.
pub(crate) fn constants(jacobi: Jacobi, emitter: &mut Emitter<'_>) -> TokenStream {
    let Emitter { model, fields, .. } = emitter;
    let index = model.running.get(&jacobi.bodies);
    let [mass, inverse_mass, attraction] = [jacobi.mass, jacobi.inverse_mass, jacobi.attraction].map(|id| {
        let field = fields.number(&model.graph, &model.parameters, id);
        // What is the same for all bodies is no table.
        if model.graph.loops_of(id).is_empty() { quote!(self.#field) } else { quote!(self.#field[#index]) }
    });
    let leading = fields.integer(&model.parameters, jacobi.leading);
    quote! {
        #[inline]
        fn leading_body(&self) -> usize { self.#leading }
        #[inline]
        fn mass_and_attraction(&self, #index: usize) -> [f64; 2] { [#mass, #attraction] }
        #[inline]
        fn inverse_mass(&self, #index: usize) -> f64 { #inverse_mass }
    }
}

/// The function that checks whether a run may begin.
pub(crate) fn admissible(coordinates: &Coordinates, names: &Names) -> TokenStream {
    let (Names { runtime, .. }, masses) = (names, masses(coordinates));
    quote! {
        fn admissible(&self, length: usize) -> ::core::result::Result<(), #runtime::Error> {
            #runtime::are_masses(&(#masses)[..], length)?;
            #runtime::are_masses_of_kinetic(&self.parameters(length), length)
        }
    }
}
