//! Attributes of methods that belong to the language of H.

use syn::{Attribute, ImplItemFn};

/// The attribute of a method with a stated derivative.
pub(crate) const DERIVATIVE: &str = "derivative";
/// The attribute of a hand-written flow.
pub(crate) const FLOW: &str = "flow";
/// The attribute of a conserved quantity.
pub(crate) const INVARIANT: &str = "invariant";

/// The attribute that makes a method an external one.
pub(crate) fn attribute(method: &ImplItemFn) -> Option<&Attribute> {
    method.attrs.iter().find(|attribute| attribute.path().is_ident(DERIVATIVE))
}

/// The attribute that makes a method the flow of a part.
pub(crate) fn flow_attribute(method: &ImplItemFn) -> Option<&Attribute> {
    method.attrs.iter().find(|attribute| attribute.path().is_ident(FLOW))
}

/// The attributes that say that a function is conserved; one is right.
pub(crate) fn invariant_attributes(method: &ImplItemFn) -> impl Iterator<Item = &Attribute> {
    method.attrs.iter().filter(|attribute| attribute.path().is_ident(INVARIANT))
}
