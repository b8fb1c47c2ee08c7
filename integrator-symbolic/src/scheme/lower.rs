//! Lowering of the source to a flat list of stages: names are resolved, combinators applied, coefficients evaluated.
//!
//! Every error about the content of a sequence arises here. Always true: the drifts of the result sum to one step, and
//! so do its kicks.

use quote::ToTokens;
use syn::{Expr, Ident};

use super::{
    coefficient::{Coefficient, evaluate},
    friction,
    prove::{SUSPICIOUS, Scheme, Verdict, Violation},
    stages::{Element, Letter, Letters, Stages},
    syntax::{COMBINATORS, Combined, Item, Sequence},
};
use crate::{errors::Errors, other_names::named_otherwise};

/// The number of stages from which a sequence is taken for a mistake.
const MOST_STAGES: usize = 1000;

/// The compositions that a sequence may name; a name without a scheme was reported before.
pub(super) struct Known(Vec<(String, Option<Scheme>)>);

impl Known {
    /// The four bases that every block knows.
    pub(super) fn bases() -> Self {
        use Letter::{T, V};
        let half = Coefficient::ONE / Coefficient::integer(2);
        let one = Coefficient::ONE;
        let base = |name: &str, sequence: &[(Letter, Coefficient)]| {
            let mut stages = Stages::default();
            for (letter, coefficient) in sequence.iter().copied() {
                stages.push(Element { letter, coefficient, gradient: Coefficient::ZERO });
            }
            (name.to_owned(), Some(Scheme::inferred(stages, Stages::default())))
        };
        Self(vec![
            base("Euler", &[(V, one), (T, one)]),
            base("EulerAdjoint", &[(T, one), (V, one)]),
            base("Verlet", &[(T, half), (V, one), (T, half)]),
            base("VelocityVerlet", &[(V, half), (T, one), (V, half)]),
        ])
    }

    /// Adds a name. It hides an earlier one, so that a block may declare the bases themselves.
    pub(super) fn declare(&mut self, name: String, scheme: Option<Scheme>) {
        self.0.retain(|(known, _)| *known != name);
        self.0.push((name, scheme));
    }

    fn look_up(&self, name: &Ident, errors: &mut Errors) -> Option<&Scheme> {
        if let Some((_, scheme)) = self.0.iter().find(|(known, _)| name == known) {
            return scheme.as_ref();
        }
        if let Some([message, help]) = named_otherwise(&name.to_string()) {
            errors.push(syn::Error::new(name.span(), format!("{message}\nhelp: {help}")));
            return None;
        }
        let names: Vec<String> = self.0.iter().map(|(known, _)| format!("`{known}`")).collect();
        let names = names.join(", ");
        let message = format!(
            "unknown composition `{name}`\nnote: known compositions are {names}; the combinators are \
                     {COMBINATORS}"
        );
        errors.push(syn::Error::new(name.span(), message));
        None
    }
}

/// The scheme of a sequence that makes one whole step.
pub(super) fn lower(sequence: &Sequence, known: &Known, errors: &mut Errors) -> Option<Scheme> {
    if let [Item::Name(name)] = sequence.items.as_slice() {
        return known.look_up(name, errors).cloned();
    }
    if let [Item::Combined(Combined::Processed(pre, kernel))] = sequence.items.as_slice() {
        let pre = parts(pre, known, errors).map(|parts| joined(&parts));
        let kernel = parts(kernel, known, errors).map(|parts| joined(&parts));
        return proved(kernel?, pre?, sequence, errors);
    }
    let stages = joined(&parts(sequence, known, errors)?);
    proved(stages, Stages::default(), sequence, errors)
}

/// The scheme of a kernel with its processor, if it is one step long.
fn proved(kernel: Stages, processor: Stages, sequence: &Sequence, errors: &mut Errors) -> Option<Scheme> {
    let count = kernel.elements().len() + 2 * processor.elements().len();
    let message = if count > MOST_STAGES {
        format!("the sequence has {count} stages, and at most {MOST_STAGES} are supported")
    } else if let Some(message) = friction::refusal(&kernel, &processor) {
        message
    } else {
        let scheme = Scheme { letters: sequence.letters(), ..Scheme::inferred(kernel, processor) };
        match scheme.proof.quadratic {
            Verdict { order: 0, violation: Some(violation), .. } => inconsistent(violation, scheme.letters),
            _ => return Some(scheme),
        }
    };
    errors.push(syn::Error::new_spanned(&sequence.tokens, message));
    None
}

fn inconsistent(Violation { word, residual }: Violation, letters: Letters) -> String {
    let word = word.spelled(letters);
    if residual.abs() < SUSPICIOUS {
        return format!(
            "the coefficients of `{word}` sum to 1 only up to {residual:.1e}\nnote: so small a residual \
                        suggests wrong or missing digits"
        );
    }
    // Twelve digits say what is wrong without the rounding of 1 - 0.8.
    friction::not_one(&word, 1.0 + residual)
}

/// An item with its coefficients known, except where `_` requests what the others leave.
#[derive(Clone)]
enum Part {
    Stage { letter: Letter, coefficient: Option<Coefficient>, gradient: Coefficient },
    Step(Stages),
}

impl Part {
    fn reversed(&self) -> Self {
        match self {
            Self::Stage { .. } => self.clone(),
            Self::Step(stages) => Self::Step(stages.reversed()),
        }
    }
}

fn parts(sequence: &Sequence, known: &Known, errors: &mut Errors) -> Option<Vec<Part>> {
    let mut parts = Vec::new();
    let mut rest_is_taken = [false; 3];
    for item in &sequence.items {
        let part = match item {
            Item::Stage { letter, coefficient, gradient } => {
                let coefficient = share(coefficient, &mut rest_is_taken[*letter as usize], errors);
                let gradient = gradient.as_ref().map_or(Some(Coefficient::ZERO), |c| errors.keep(evaluate(c)));
                coefficient.zip(gradient).map(|(coefficient, gradient)| Part::Stage {
                    letter: *letter,
                    coefficient,
                    gradient,
                })
            }
            Item::Name(name) => {
                let scheme = known.look_up(name, errors);
                scheme.and_then(|scheme| unprocessed(scheme.clone(), name, errors)).map(Part::Step)
            }
            Item::Combined(combined) => combine(combined, known, errors).map(Part::Step),
        };
        parts.extend(part);
    }
    (parts.len() == sequence.items.len()).then_some(parts)
}

/// `Some(None)` stands for `_`.
fn share(expression: &Expr, rest_is_taken: &mut bool, errors: &mut Errors) -> Option<Option<Coefficient>> {
    if !matches!(expression, Expr::Infer(_)) {
        return errors.keep(evaluate(expression)).map(Some);
    }
    if *rest_is_taken {
        let message = "`_` may occur only once\nnote: it is what the other coefficients leave of the step";
        errors.push(syn::Error::new_spanned(expression, message));
        return None;
    }
    *rest_is_taken = true;
    Some(None)
}

/// The stages of all parts, with `_` such that the stages of each letter sum to one step.
fn joined(parts: &[Part]) -> Stages {
    let rest = |of: Letter| {
        let (mut rest, mut shares) = (Coefficient::ONE, 0);
        for part in parts {
            match part {
                Part::Stage { letter, coefficient, .. } if *letter == of => match coefficient {
                    Some(coefficient) => rest = rest - *coefficient,
                    None => shares += 1,
                },
                Part::Stage { .. } => {}
                Part::Step(stages) => rest = rest - stages.sum(of),
            }
        }
        rest / Coefficient::integer(shares.max(1))
    };
    let mut stages = Stages::default();
    for part in parts {
        match part {
            Part::Stage { letter, coefficient, gradient } => {
                let coefficient = coefficient.unwrap_or_else(|| rest(*letter));
                stages.push(Element { letter: *letter, coefficient, gradient: *gradient });
            }
            Part::Step(step) => stages.append(step, Coefficient::ONE),
        }
    }
    stages
}

fn combine(combined: &Combined, known: &Known, errors: &mut Errors) -> Option<Stages> {
    match combined {
        Combined::TripleJump(base) => {
            let (base, order) = symmetric_base("triple_jump", base, known, errors)?;
            let (two, root) = (Coefficient::integer(2), Coefficient::integer(2).root(order + 1));
            let outer = Coefficient::ONE / (two - root);
            Some(weighted(&[outer, Coefficient::ONE - outer - outer, outer], &base))
        }
        Combined::Suzuki(base) => {
            let (base, order) = symmetric_base("suzuki", base, known, errors)?;
            let (four, root) = (Coefficient::integer(4), Coefficient::integer(4).root(order + 1));
            let outer = Coefficient::ONE / (four - root);
            Some(weighted(&[outer, outer, Coefficient::ONE - four * outer, outer, outer], &base))
        }
        Combined::Adjoint(step) => base(step, known, errors).map(|stages| stages.reversed()),
        Combined::Mirrored(half) => {
            let mut parts = parts(half, known, errors)?;
            let mirrored: Vec<Part> = parts.iter().rev().skip(1).map(Part::reversed).collect();
            parts.extend(mirrored);
            Some(joined(&parts))
        }
        Combined::Palindrome(half, base) => {
            let base = self::base(base, known, errors);
            let mut weights = shares(half, errors)?;
            let mirrored: Vec<_> = weights.iter().rev().skip(1).copied().collect();
            weights.extend(mirrored);
            Some(weighted(&completed(&weights), &base?))
        }
        Combined::Weighted(weights, base) => {
            let base = self::base(base, known, errors);
            let weights = shares(weights, errors)?;
            Some(weighted(&completed(&weights), &base?))
        }
        Combined::Equal(steps) => {
            let weight = Coefficient::ONE / Coefficient::integer(steps.len() as u32);
            let steps: Vec<_> = steps.iter().map(|step| base(step, known, errors)).collect();
            let mut stages = Stages::default();
            for step in steps.into_iter().collect::<Option<Vec<_>>>()? {
                stages.append(&step, weight);
            }
            Some(stages)
        }
        Combined::Processed(pre, _) => {
            let message = "`processed(..)` cannot be part of another composition";
            errors.push(syn::Error::new_spanned(&pre.tokens, message));
            None
        }
    }
}

/// The stages of a whole step that a combinator acts on.
fn base(step: &Sequence, known: &Known, errors: &mut Errors) -> Option<Stages> {
    let scheme = lower(step, known, errors)?;
    unprocessed(scheme, &step.tokens, errors)
}

fn unprocessed(scheme: Scheme, tokens: &impl ToTokens, errors: &mut Errors) -> Option<Stages> {
    if scheme.processor.elements().is_empty() {
        return Some(scheme.stages);
    }
    let message = "a processed composition cannot be a part of another one";
    errors.push(syn::Error::new_spanned(tokens, message));
    None
}

/// A base that a combinator raises by two orders.
fn symmetric_base(name: &str, base: &Sequence, known: &Known, errors: &mut Errors) -> Option<(Stages, u32)> {
    let scheme = lower(base, known, errors)?;
    if scheme.proof.symmetric {
        let order = scheme.order;
        return unprocessed(scheme, &base.tokens, errors).map(|stages| (stages, order));
    }
    let message = format!("`{name}` requires a symmetric composition, and this one is not symmetric");
    errors.push(syn::Error::new_spanned(&base.tokens, message));
    None
}

fn shares(weights: &[Expr], errors: &mut Errors) -> Option<Vec<Option<Coefficient>>> {
    let mut rest_is_taken = false;
    let shares: Vec<_> = weights.iter().map(|weight| share(weight, &mut rest_is_taken, errors)).collect();
    shares.into_iter().collect()
}

/// The weights, with `_` such that they sum to 1.
fn completed(weights: &[Option<Coefficient>]) -> Vec<Coefficient> {
    let open = weights.iter().filter(|weight| weight.is_none()).count();
    let given = weights.iter().flatten().fold(Coefficient::ONE, |rest, weight| rest - *weight);
    let rest = given / Coefficient::integer(open.max(1) as u32);
    weights.iter().map(|weight| weight.unwrap_or(rest)).collect()
}

fn weighted(weights: &[Coefficient], base: &Stages) -> Stages {
    let mut stages = Stages::default();
    for weight in weights {
        stages.append(base, *weight);
    }
    stages
}
