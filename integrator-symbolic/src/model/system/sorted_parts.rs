//! `split = quadratic + rest`: the terms of one function are sorted into a quadratic form and the remaining terms.

use crate::model::{
    Called, Reader,
    code::shape::{Shape, WholeSignature, whole_signature},
    system::parts::{ExactPart, Read},
};
use crate::syntax::Input;
use syn::ImplItemFn;

/// The names of the parts that terms are sorted into, unless the impl has functions of these names.
const SORTED: [&str; 2] = ["quadratic", "rest"];

/// The function whose terms are sorted, if that is what `split` requests.
pub(crate) fn sorted(input: &Input) -> Option<&ImplItemFn> {
    let [first, second] = &input.split[..] else { return None };
    let is_sorted = |name| (first == name || second == name) && input.function(name).is_none();
    input.function("hamiltonian").filter(|_| SORTED.into_iter().all(is_sorted))
}

/// The first name of such a split, where H is written as two functions.
pub(crate) fn sorts_two_functions(input: &Input) -> Option<&proc_macro2::Ident> {
    let [first, second] = &input.split[..] else { return None };
    let is_sorted = |name| (first == name || second == name) && input.function(name).is_none();
    let is_there = |name| input.function(name).is_some();
    (SORTED.into_iter().all(is_sorted) && ["kinetic", "potential"].into_iter().any(is_there)).then_some(first)
}

impl Reader<'_> {
    /// The terms of joint degree two or less in positions and momenta, and the others, each with a flow that is known.
    pub(crate) fn sorted_parts(&mut self, function: &ImplItemFn) -> Option<(Vec<ExactPart>, Shape, Called)> {
        let signature = whole_signature(function, self.errors)?;
        self.may_mix = true;
        let energy = self.whole_energy(function, &signature);
        self.may_mix = false;
        let WholeSignature { shape, arguments, .. } = signature;
        let energies = self.graph.quadratic_and_rest(energy?);
        let input = self.input;
        let named = || input.split.iter().map(|name| (name, energies[usize::from(name == SORTED[1])]));
        if let Some((name, _)) = named().find(|(_, energy)| !self.graph.reads_coordinates(*energy)) {
            let message = match name == SORTED[1] {
                true => {
                    "`rest` is empty, since every term of `hamiltonian` is a quadratic form in q and p\nnote: the \
                     flow of H is known exactly, without a composition"
                }
                false => {
                    "`quadratic` is empty, since no term of `hamiltonian` is a quadratic form in q and p\nhelp: write \
                     one function for each part"
                }
            };
            self.errors.at(name, message);
            return None;
        }
        let read = |energy| Read { energy, shape: shape.clone(), arguments: arguments.clone() };
        let parts: Vec<_> = named().filter_map(|(name, energy)| self.judged(name, read(energy))).collect();
        (parts.len() == SORTED.len()).then_some((parts, shape, Called::Whole(arguments)))
    }
}
