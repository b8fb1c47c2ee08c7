//! A readable summary of the proof of a composition.
//!
//! In: declarations or a sequence, as tokens. Out: their proved properties.

use proc_macro2::TokenStream;
use syn::{
    LitStr,
    ext::IdentExt,
    parse::{ParseStream, Parser},
};

use super::{
    claims,
    facts::Facts,
    lower::{Known, lower},
    near_integrable,
    prove::{Class, Scheme},
    stages::{Letters, Stages},
    syntax,
};
use crate::errors::Errors;

/// The proved properties of a composition.
#[derive(Clone, Debug, PartialEq)]
pub struct Proved {
    /// The declared name; empty for a sequence without one.
    pub name: String,
    /// The declared citation; may be empty.
    pub citation: String,
    /// The proved order for the class of Hamiltonians of the composition.
    pub order: u32,
    /// The proved order for every `T(p)`; `None` if there are gradient kicks, which need a quadratic `T`.
    pub general_order: Option<u32>,
    /// The proved order for `T` quadratic in `p` with constant masses.
    pub quadratic_order: u32,
    /// The proved generalised orders `(n₁, n₂, …)` for a second part of small size `ε`.
    ///
    /// Errors are of the sizes `ε h^n₁`, `ε² h^n₂` and so on; the last one is `order`.
    pub generalised_orders: Vec<u32>,
    /// The proved orders if each flow of the second part is approximated by the same number of steps of a symmetric inner
    /// composition of order 2, 4, 6 or 8; `None` if the composition is only for Hamiltonians with a quadratic `T`, where
    /// the second part has an exact flow.
    pub orders_over_inner: Option<[u32; 4]>,
    /// Whether the composition is only for Hamiltonians with a quadratic `T`.
    pub quadratic_kinetic: bool,
    /// Whether the step is its own adjoint, so that a step by `-h` inverts a step by `h`.
    pub symmetric: bool,
    /// The stages of one step, or of the kernel if there is a processor.
    pub stages: Vec<ProvedStage>,
    /// The stages of the processor, applied before the first step and inverted before output; usually empty.
    pub processor: Vec<ProvedStage>,
    /// Kicks per step in the middle of a run. This and all that follows is without friction.
    pub force_evaluations: usize,
    /// The number of these kicks with a force gradient.
    pub gradient_evaluations: usize,
    /// The smallest `h ω > 0` beyond which the harmonic oscillator is unstable.
    pub stability_limit: f64,
    /// The norm of the leading error terms, if they are known and finite.
    pub leading_error: Option<f64>,
    /// The leading error terms: brackets of `T` and `V` of degree `order + 1`, with their factors.
    pub error_terms: Vec<(String, f64)>,
    /// The violated condition of degree `order + 1` with the largest residual; `None` for the highest order that is
    /// proved.
    pub violation: Option<ProvedViolation>,
    /// The table over which a run loops.
    pub table: ProvedTable,
}

/// The table of a composition: lists of stages, one drift and one kick each, in the order in which a run applies them.
///
/// A row has the fractions of the step of its drift, its kick and the gradient of its kick, the times at which drift and kick
/// begin, and the durations of the parts between and after them.
#[derive(Clone, Debug, PartialEq)]
pub struct ProvedTable {
    /// Whether a kick comes first in every row.
    pub leads_with_kick: bool,
    /// The first row of the first step.
    pub opening: [f64; 7],
    /// The row that completes a step.
    pub closing: [f64; 7],
    /// One step in the middle of a run.
    pub cycle: Vec<[f64; 7]>,
    /// The processor, and whether a kick comes first in its rows.
    pub before: (bool, Vec<[f64; 7]>),
    /// The inverse of the processor.
    pub after: (bool, Vec<[f64; 7]>),
}

/// A stage of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProvedStage {
    /// The flow as written in the sequence: `'T'` or `'A'` for a drift, `'V'` or `'B'` for a kick, `'O'` for friction.
    pub letter: char,
    /// The duration as a fraction of the step.
    pub coefficient: f64,
    /// `c` of the kick with `b V + c h² |∇V|²`; zero in plain kicks and in drifts.
    pub gradient: f64,
}

/// A violated order condition.
#[derive(Clone, Debug, PartialEq)]
pub struct ProvedViolation {
    /// The word of the condition in the letters of the sequence.
    pub word: String,
    /// The difference between the coefficients of the step and of the exact flow for this word.
    pub residual: f64,
}

/// What is proved of the compositions that a `composition!` block declares; what is wrong with it is noted.
pub(crate) fn declared(declarations: TokenStream, errors: &mut Errors) -> Vec<Proved> {
    let mut known = Known::bases();
    let mut found = Vec::new();
    for declaration in &syntax::block(declarations, errors).declarations {
        let name = declaration.name.unraw().to_string();
        let scheme = claims::check(declaration, &known, errors);
        let citation = declaration.claims.citation.as_ref().map(LitStr::value).unwrap_or_default();
        found.extend(scheme.as_ref().map(|scheme| Proved::of(scheme, &name, &citation)));
        known.declare(name, scheme);
    }
    found
}

/// What is proved of a sequence, compared with an order where one is claimed; what is wrong with it is noted.
pub(crate) fn sequence(tokens: TokenStream, order: Option<u32>, errors: &mut Errors) -> Option<Proved> {
    let parser = |input: ParseStream<'_>| {
        let sequence = syntax::sequence(input, &tokens, errors);
        if !input.is_empty() && errors.is_empty() {
            errors.push(input.error("unexpected input after the end of the sequence"));
        }
        input.parse::<TokenStream>()?;
        Ok(sequence)
    };
    let sequence = parser.parse2(tokens.clone());
    let sequence = errors.keep(sequence).flatten().filter(|_| errors.is_empty())?;
    let mut scheme = lower(&sequence, &Known::bases(), errors)?;
    if let Some(Err(message)) = order.map(|order| claims::order(&mut scheme, order)) {
        errors.at(&sequence.tokens, message);
        return None;
    }
    Some(Proved::of(&scheme, "", ""))
}

impl Proved {
    fn of(scheme: &Scheme, name: &str, citation: &str) -> Self {
        let conservative = scheme.without_friction();
        let facts = Facts::of(&conservative);
        let violation = scheme.verdict().violation.map(|violation| ProvedViolation {
            word: violation.word.spelled(scheme.letters),
            residual: violation.residual,
        });
        Self {
            name: name.to_owned(),
            citation: citation.to_owned(),
            order: scheme.order,
            general_order: scheme.proof.general.map(|general| general.order),
            quadratic_order: scheme.proof.quadratic.order,
            generalised_orders: near_integrable::orders(&conservative).iter().map(|found| found.order).collect(),
            orders_over_inner: (scheme.class == Class::General).then_some(facts.over_inner.orders),
            quadratic_kinetic: scheme.class == Class::QuadraticKinetic,
            symmetric: scheme.proof.symmetric,
            stages: shown(&scheme.stages, scheme.letters),
            processor: shown(&scheme.processor, scheme.letters),
            force_evaluations: facts.table.force_evaluations(),
            gradient_evaluations: facts.table.gradient_evaluations(),
            stability_limit: facts.stability_limit,
            leading_error: facts.leading_error,
            error_terms: scheme
                .error_terms()
                .iter()
                .map(|(word, factor)| (word.bracket(scheme.letters), *factor))
                .collect(),
            violation,
            table: facts.table.proved(),
        }
    }
}

fn shown(stages: &Stages, letters: Letters) -> Vec<ProvedStage> {
    let stage = |element: &super::stages::Element| ProvedStage {
        letter: letters.name(element.letter),
        coefficient: element.coefficient.value.value(),
        gradient: element.gradient.value.value(),
    };
    stages.elements().iter().map(stage).collect()
}
