//! Compositions with friction, as the macro writes them.

use crate::trajectory::method::Facts;

/// A stage of a composition with friction: a flow, and its duration as a fraction of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Letter {
    /// A drift: the flow of `T`, or of the first part.
    T(f64),
    /// A kick: the flow of `V`, or of the last part.
    V(f64),
    /// Friction, with noise if there is a temperature.
    O(f64),
}

/// The properties of a composition with friction, proved when it is compiled. `composition!` implements this trait for
/// sequences with the letter `O`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no letter `O`",
    label = "not a composition with friction",
    note = "use `Obabo` or `Baoab`, or declare a composition with `O` by `composition!`"
)]
pub trait FrictionScheme: Copy + Default + Send + Sync + 'static {
    /// The name in the declaration.
    const NAME: &'static str;
    /// The publication; empty if the declaration has no citation.
    const CITATION: &'static str;
    /// The order of damped motion, and the weak order if there is noise.
    const ORDER: u32;
    /// Whether the sequence is a palindrome.
    const SYMMETRIC: bool;
    /// Force evaluations per step, after merging across steps.
    const FORCE_EVALUATIONS: usize;
    /// The smallest `h·ω` beyond which the step without friction is unstable for a harmonic oscillator.
    const STABILITY_LIMIT: f64;
    /// The stages of a step, in the order of their application.
    const LETTERS: &'static [Letter];
}

/// Returns the facts of a composition with friction as a method.
pub fn facts_with_friction<X: FrictionScheme>() -> Facts {
    Facts {
        name: X::NAME,
        order: X::ORDER,
        symmetric: X::SYMMETRIC,
        forces: Some(X::FORCE_EVALUATIONS),
        stability_limit: Some(X::STABILITY_LIMIT),
        roundings: X::LETTERS.len(),
        friction: true,
        negative_friction: X::LETTERS.iter().any(|letter| matches!(letter, Letter::O(duration) if *duration < 0.0)),
        ..Facts::UNCLAIMED
    }
}
