//! Comparison of the claims of a declaration with its proof.
//!
//! In: a sequence with its scheme. Out: the scheme as declared. The declared order also determines the class: an order
//! that is valid only for `T` quadratic in `p` declares a composition for those systems only.

use super::{
    lower::{Known, lower},
    near_integrable,
    prove::{Class, Proof, Scheme, Verdict},
    stages::{Letter, Letters},
    syntax::Declaration,
};
use crate::errors::Errors;

/// The scheme of a declaration, if all it claims is true.
pub(super) fn check(declaration: &Declaration, known: &Known, errors: &mut Errors) -> Option<Scheme> {
    let mut scheme = lower(declaration.sequence.as_ref()?, known, errors)?;
    let found = errors.count();
    if let Some(claim) = &declaration.claims.order {
        let orders: Option<Vec<u32>> = claim.literals.iter().map(|literal| literal.base10_parse().ok()).collect();
        let claimed = match orders.as_deref() {
            None => Err(NO_ORDER.to_owned()),
            Some([plain]) => order(&mut scheme, *plain),
            Some(orders) => generalised(&mut scheme, orders),
        };
        if let Err(message) = claimed {
            errors.push(syn::Error::new_spanned(&claim.tokens, message));
        }
    }
    if let Some(claim) = &declaration.claims.symmetric
        && !scheme.proof.symmetric
    {
        let message = "declared symmetric, but the sequence is not a palindrome";
        errors.push(syn::Error::new(claim.span(), message));
    }
    (errors.count() == found).then_some(scheme)
}

const NO_ORDER: &str = "an order has to be an integer of at least 1";

/// Chooses the class in which the claimed order holds; the error says why there is none.
pub(super) fn order(scheme: &mut Scheme, order: u32) -> Result<(), String> {
    match order {
        0 => return Err(NO_ORDER.to_owned()),
        _ if scheme.order >= order => {}
        _ if scheme.proof.quadratic.order >= order => {
            scheme.class = Class::QuadraticKinetic;
            scheme.order = scheme.proof.quadratic.order;
        }
        _ => return Err(overclaimed(order, &scheme.proof, scheme.letters)),
    }
    Ok(())
}

/// Holds generalised orders against the words with one letter of the second part, with two, and so on. The last order is
/// that for words with any number of them: the plain one.
fn generalised(scheme: &mut Scheme, orders: &[u32]) -> Result<(), String> {
    if scheme.stages.has_friction() {
        return Err("generalised orders do not support friction `O`\nhelp: claim one order, `order 2`".to_owned());
    }
    if orders.windows(2).any(|pair| pair[0] < pair[1]) {
        return Err(
            "generalised orders have to decrease\nhelp: write, for example, `order (8, 4)`\nnote: the numbers \
                    are the orders in increasing powers of the small part"
                .to_owned(),
        );
    }
    if let Some(last) = orders.last() {
        order(scheme, *last)?;
    }
    let proved = near_integrable::orders(scheme);
    for (number, (claimed, found)) in orders.iter().zip(&proved).enumerate() {
        if found.order < *claimed {
            let (second, order) = (scheme.letters.name(Letter::V), found.order);
            let words = match number {
                0 => format!("with one {second}"),
                more => format!("with {} {second}", more + 1),
            };
            return Err(match &found.violation {
                Some(violation) => format!(
                    "declared order {claimed} for words {words}, but the proof finds order {order}\nnote: {}",
                    violation.text(scheme.letters)
                ),
                None => format!("declared order {claimed} for words {words}, but no order above {order} is proved"),
            });
        }
    }
    scheme.generalised = orders.to_vec();
    Ok(())
}

fn overclaimed(declared: u32, proof: &Proof, letters: Letters) -> String {
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
    format!("declared order {declared}, but the proof finds order {order}{class}\nnote: {}", violation.text(letters))
}
