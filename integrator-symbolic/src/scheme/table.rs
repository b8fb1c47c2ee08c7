//! The stages of a step in the form over which a run loops: rows of one drift and one kick, merged across steps.
//!
//! In: a [`Scheme`]. Out: the literals of its tables. Coefficients are rounded from 106 bits here, after all sums.
//! Always true: a row uses the time that the other letter has reached, counted from the beginning of the step. A
//! processor that advances by a tenth of a step hence shifts the times of its kernel by that much.
//!
//! The middle part between the letters `k` and `k + 1` of a step is `x_k` minus the middle part before `k`. Nothing
//! remains after the last letter: the alternating sum of all coefficients is the sum of drifts minus the sum of kicks,
//! and [`lower`](super::lower) proved both to be equal.

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::Path;

use super::{
    double::Double,
    prove::Scheme,
    proved::ProvedTable,
    stages::{Element, Letter},
};

/// The tables of a composition.
pub(super) struct Table {
    /// The processor, which a run goes through once.
    before: Rows,
    /// A whole step: the last row closes it, if the step ends with the letter it begins with.
    step: Rows,
    /// The inverse of the processor.
    after: Rows,
}

impl Table {
    pub(super) fn of(scheme: &Scheme) -> Self {
        let mut clock = Clock { drifts: Double::ZERO, kicks: Double::ZERO };
        Self {
            before: Rows::of(scheme.processor.elements(), &mut clock),
            step: Rows::of_whole_step(scheme, &mut clock),
            after: Rows::of(scheme.processor.inverse().elements(), &mut clock),
        }
    }

    /// For a declaration with errors.
    pub(super) fn stub() -> Self {
        let rows = |rows| Rows { lead: Letter::T, rows };
        Self { before: rows(Vec::new()), step: rows(vec![Row::NONE]), after: rows(Vec::new()) }
    }

    /// The rows of one step in the middle of a run, and the row that closes a step.
    ///
    /// If the step ends with the letter it begins with, its last stage is one with the first of the next step.
    fn cycle(&self) -> (Vec<Row>, Row) {
        let mut cycle = self.step.rows.clone();
        match cycle.last().copied() {
            Some(closing) if closing.is_half() && cycle.len() > 1 => {
                cycle.pop();
                cycle[0].drift = cycle[0].drift + closing.drift;
                cycle[0].kick = cycle[0].kick + closing.kick;
                cycle[0].gradient = cycle[0].gradient + closing.gradient;
                (cycle, closing)
            }
            _ => (cycle, Row::NONE),
        }
    }

    /// How many kicks a step has in the middle of a run.
    pub(super) fn force_evaluations(&self) -> usize {
        self.cycle().0.iter().filter(|row| row.kick != Double::ZERO || row.gradient != Double::ZERO).count()
    }

    /// How many of them also go along the gradient of the squared force.
    pub(super) fn gradient_evaluations(&self) -> usize {
        self.cycle().0.iter().filter(|row| row.gradient != Double::ZERO).count()
    }

    /// The literal of `Stages`.
    pub(super) fn stages(&self, root: &Path) -> TokenStream {
        let (cycle, closing) = self.cycle();
        let lead = self.step.lead(root);
        let opening = self.step.rows.first().copied().unwrap_or(Row::NONE).literal(root);
        let cycle = cycle.iter().map(|row| row.literal(root));
        let closing = closing.literal(root);
        quote! {
            #root::__private::Stages {
                lead: #lead,
                opening: #opening,
                cycle: &[#(#cycle),*],
                closing: #closing,
            }
        }
    }

    /// The same as numbers.
    pub(super) fn proved(&self) -> ProvedTable {
        let (cycle, closing) = self.cycle();
        let rows = |rows: &Rows| (rows.lead == Letter::V, rows.rows.iter().map(Row::numbers).collect());
        ProvedTable {
            leads_with_kick: self.step.lead == Letter::V,
            opening: self.step.rows.first().map_or([0.0; 7], Row::numbers),
            closing: closing.numbers(),
            cycle: cycle.iter().map(Row::numbers).collect(),
            before: rows(&self.before),
            after: rows(&self.after),
        }
    }

    /// The literal of `Processor`, if there is one.
    pub(super) fn processor(&self, root: &Path) -> Option<TokenStream> {
        if self.before.rows.is_empty() {
            return None;
        }
        let [before, after] = [&self.before, &self.after].map(|rows| rows.literal(root));
        Some(quote!(#root::__private::Processor { before: #before, after: #after }))
    }
}

/// How far the drifts and the kicks have come since the beginning of the step.
struct Clock {
    drifts: Double,
    kicks: Double,
}

/// Stages in order, two by two; the last row may have one part only.
struct Rows {
    lead: Letter,
    rows: Vec<Row>,
}

impl Rows {
    fn of(elements: &[Element], clock: &mut Clock) -> Self {
        let lead = elements.first().map_or(Letter::T, |first| first.letter);
        let row = |pair: &[Element]| {
            let mut row = Row::NONE;
            for element in pair {
                row.set(element, clock);
            }
            row
        };
        Self { lead, rows: elements.chunks(2).map(row).collect() }
    }

    /// The same, with what lies between the letters where a system has more than two parts.
    fn of_whole_step(scheme: &Scheme, clock: &mut Clock) -> Self {
        let mut rows = Self::of(scheme.stages.elements(), clock);
        for (number, gamma) in between(scheme).into_iter().enumerate() {
            rows.rows[number / 2].middle[number % 2] = gamma;
        }
        rows
    }

    fn lead(&self, root: &Path) -> TokenStream {
        match self.lead {
            Letter::T | Letter::O => quote!(#root::__private::Lead::Drift),
            Letter::V => quote!(#root::__private::Lead::Kick),
        }
    }

    fn literal(&self, root: &Path) -> TokenStream {
        let lead = self.lead(root);
        let rows = self.rows.iter().map(|row| row.literal(root));
        quote!(#root::__private::Rows { lead: #lead, rows: &[#(#rows),*] })
    }
}

/// What lies between the letters of a step and after the last one: `γ` of the flows of all parts in their order or, after
/// every other letter, backwards.
fn between(scheme: &Scheme) -> Vec<Double> {
    let mut gamma = Double::ZERO;
    let gammas = scheme.stages.elements().iter().map(|element| {
        gamma = element.coefficient.value - gamma;
        gamma
    });
    let mut gammas: Vec<_> = gammas.collect();
    // Roundings of the sums are all that is left after the last letter.
    let Some((behind, between)) = gammas.split_last_mut() else { return gammas };
    *behind = Double::ZERO;
    if scheme.proof.symmetric {
        // To the last bit, for coordinates on a grid.
        let (first, second) = between.split_at_mut(between.len() / 2);
        first.iter().zip(second.iter_mut().rev()).for_each(|(one, mirrored)| *mirrored = *one);
    }
    gammas
}

/// One drift and one kick, the fractions of the step at which they read the time, and what lies after each.
#[derive(Clone, Copy, PartialEq)]
struct Row {
    drift: Double,
    kick: Double,
    gradient: Double,
    drift_time: Double,
    kick_time: Double,
    middle: [Double; 2],
}

impl Row {
    const NONE: Self = Self {
        drift: Double::ZERO,
        kick: Double::ZERO,
        gradient: Double::ZERO,
        drift_time: Double::ZERO,
        kick_time: Double::ZERO,
        middle: [Double::ZERO; 2],
    };

    fn set(&mut self, element: &Element, clock: &mut Clock) {
        match element.letter {
            Letter::T => {
                self.drift = element.coefficient.value;
                self.drift_time = clock.kicks;
                clock.drifts = clock.drifts + self.drift;
            }
            Letter::V => {
                self.kick = element.coefficient.value;
                self.gradient = element.gradient.value;
                self.kick_time = clock.drifts;
                clock.kicks = clock.kicks + self.kick;
            }
            Letter::O => {}
        }
    }

    fn is_half(&self) -> bool {
        self.drift == Double::ZERO || (self.kick == Double::ZERO && self.gradient == Double::ZERO)
    }

    fn numbers(&self) -> [f64; 7] {
        let [within, behind] = self.middle;
        [self.drift, self.kick, self.gradient, self.drift_time, self.kick_time, within, behind].map(Double::value)
    }

    fn literal(&self, root: &Path) -> TokenStream {
        if *self == Self::NONE {
            return quote!(#root::__private::Stage::NONE);
        }
        let [drift, kick, gradient, drift_time, kick_time, within, behind] = self.numbers().map(number);
        quote! {
            #root::__private::Stage {
                drift: #drift,
                kick: #kick,
                gradient: #gradient,
                drift_time: #drift_time,
                kick_time: #kick_time,
                middle: [#within, #behind],
            }
        }
    }
}

/// A literal. Its minus sign is a token of its own, as a parser would have it.
pub(super) fn number(value: f64) -> TokenStream {
    let sign = (value < 0.0).then(|| quote!(-));
    let magnitude = Literal::f64_unsuffixed(value.abs());
    quote!(#sign #magnitude)
}
