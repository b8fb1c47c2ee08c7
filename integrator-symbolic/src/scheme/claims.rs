//! What a declaration claims, held against what its proof finds.
//!
//! A sequence with its scheme comes in, the scheme as declared goes out. The declared order also chooses the class: one
//! that holds only where `T` is quadratic in `p` declares a composition for those systems alone.

use super::{
    lower::{Known, lower},
    prove::{Class, Proof, Scheme, Verdict},
    syntax::Declaration,
};
use crate::errors::Errors;

/// The scheme of a declaration, if all it claims is true.
pub(super) fn check(declaration: &Declaration, known: &Known, errors: &mut Errors) -> Option<Scheme> {
    let mut scheme = lower(declaration.sequence.as_ref()?, known, errors)?;
    let found = errors.count();
    if let Some(literal) = &declaration.claims.order {
        let claimed = literal.base10_parse().map_err(|_| NO_ORDER.to_owned()).and_then(|n| order(&mut scheme, n));
        if let Err(message) = claimed {
            errors.push(syn::Error::new(literal.span(), message));
        }
    }
    if let Some(claim) = &declaration.claims.symmetric
        && !scheme.proof.symmetric
    {
        let message = "declared symmetric, but the sequence does not read the same backwards";
        errors.push(syn::Error::new(claim.span(), message));
    }
    (errors.count() == found).then_some(scheme)
}

const NO_ORDER: &str = "an order is an integer of at least 1";

/// Chooses the class in which the claimed order holds; the error says why there is none.
pub(super) fn order(scheme: &mut Scheme, order: u32) -> Result<(), String> {
    match order {
        0 => return Err(NO_ORDER.to_owned()),
        _ if scheme.order >= order => {}
        _ if scheme.proof.quadratic.order >= order => {
            scheme.class = Class::QuadraticKinetic;
            scheme.order = scheme.proof.quadratic.order;
        }
        _ => return Err(overclaimed(order, &scheme.proof)),
    }
    Ok(())
}

fn overclaimed(declared: u32, proof: &Proof) -> String {
    let Verdict { order, violation, .. } = proof.quadratic;
    let Some(violation) = violation else {
        return format!("declared order {declared}, but no order above {order} is proved");
    };
    let class = match proof.general {
        Some(general) if general.order < order => {
            format!(" where T is quadratic in p ({} for every T)", general.order)
        }
        _ => String::new(),
    };
    // For the same order, the longer list may hold the larger violation.
    let violation = match proof.general {
        Some(Verdict { order: general, violation: Some(other), .. }) if general == order => other,
        _ => violation,
    };
    format!("declared order {declared}, but the proof finds order {order}{class}: {violation}")
}
