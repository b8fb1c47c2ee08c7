//! The stages of a step: a flat list of drifts and kicks, in order of application.
//!
//! Always true: neighbours have different letters and no stage moves nothing, because [`Stages::push`] is the only way
//! in: flows of the same part commute, so they merge into one of the summed duration.

use super::coefficient::Coefficient;

/// The part of the Hamiltonian that a stage moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Letter {
    /// The kinetic part; its stage is a drift.
    T,
    /// The potential part; its stage is a kick.
    V,
}

/// One stage, as a fraction of the step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Element {
    pub(super) letter: Letter,
    pub(super) coefficient: Coefficient,
    /// `c` of the kick with `b V + c h^2 |grad V|^2`; zero in plain kicks and in drifts.
    pub(super) gradient: Coefficient,
}

/// The stages of a step, merged.
#[derive(Clone, Debug, Default)]
pub(super) struct Stages {
    elements: Vec<Element>,
}

impl Stages {
    pub(super) fn elements(&self) -> &[Element] {
        &self.elements
    }

    pub(super) fn push(&mut self, element: Element) {
        match self.elements.last_mut() {
            Some(last) if last.letter == element.letter => {
                last.coefficient = last.coefficient + element.coefficient;
                last.gradient = last.gradient + element.gradient;
                if last.coefficient.vanishes() && last.gradient.vanishes() {
                    self.elements.pop();
                }
            }
            _ if element.coefficient.vanishes() && element.gradient.vanishes() => {}
            _ => self.elements.push(element),
        }
    }

    /// Appends the stages of a step that is `weight` as long.
    pub(super) fn append(&mut self, step: &Self, weight: Coefficient) {
        for element in &step.elements {
            self.push(Element {
                letter: element.letter,
                coefficient: element.coefficient * weight,
                // The gradient term goes with the cube of the step.
                gradient: element.gradient * weight * weight * weight,
            });
        }
    }

    /// The adjoint step, the inverse of a step backwards: the same stages in the opposite order.
    pub(super) fn reversed(&self) -> Self {
        Self { elements: self.elements.iter().rev().copied().collect() }
    }

    /// Whether the step is its own adjoint.
    pub(super) fn is_symmetric(&self) -> bool {
        self.elements.iter().zip(self.elements.iter().rev()).all(|(one, other)| {
            one.letter == other.letter
                && (one.coefficient - other.coefficient).vanishes()
                && (one.gradient - other.gradient).vanishes()
        })
    }

    pub(super) fn has_gradients(&self) -> bool {
        self.elements.iter().any(|element| !element.gradient.vanishes())
    }

    pub(super) fn sum(&self, letter: Letter) -> Coefficient {
        let coefficients = self.elements.iter().filter(|element| element.letter == letter);
        coefficients.fold(Coefficient::ZERO, |sum, element| sum + element.coefficient)
    }
}
