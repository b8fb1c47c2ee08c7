//! The facts of a part that takes inner steps.

/// A part of H that takes inner steps, instead of one exact flow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InnerSteps {
    /// The number of inner steps in the annotation.
    pub steps: u32,
    /// The names of all parts in the parentheses.
    pub parts: &'static [&'static str],
    /// The order of the inner composition.
    pub order: u32,
    /// The orders of the inner composition if its second part takes steps again: [`Scheme::ORDERS_OVER_INNER`](crate::Scheme).
    pub orders_over_inner: [u32; 4],
    /// Whether an inner step by `-h` undoes one by `h`.
    pub symmetric: bool,
    /// The smallest `h·ω` at which an inner step is unstable for a harmonic oscillator.
    pub stability_limit: f64,
    /// The drifts of an inner step, its flows between the first part and the last, and its kicks.
    pub flows: [u64; 3],
    /// The same of the end of the last inner step.
    pub closing: [u64; 3],
    /// The number of times that an inner step rounds the state.
    pub roundings: usize,
}
