//! The stages of a step: a flat list of drifts and kicks, in order of application.
//!
//! Always true: adjacent stages have different letters, and no stage has zero duration. [`Stages::push`] is the only
//! way to add a stage: flows of the same part commute, so they merge into one of the summed duration.

use super::coefficient::Coefficient;

/// The part of the Hamiltonian that a stage moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Letter {
    /// The first part, mostly the kinetic one; its stage is a drift.
    T,
    /// The second part, mostly the potential one; its stage is a kick.
    V,
    /// Friction, perhaps with noise.
    O,
}

/// What a sequence calls the two parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Letters {
    /// `T` and `V`, the kinetic and the potential energy.
    #[default]
    Kinetic,
    /// `A` and `B`, the first and the second part of any split.
    Parts,
}

impl Letters {
    /// The letter that a name stands for, and the alphabet that it is of; `O` is in both.
    pub(super) fn read(name: &str) -> Option<(Letter, Option<Self>)> {
        match name {
            "T" => Some((Letter::T, Some(Self::Kinetic))),
            "V" => Some((Letter::V, Some(Self::Kinetic))),
            "A" => Some((Letter::T, Some(Self::Parts))),
            "B" => Some((Letter::V, Some(Self::Parts))),
            "O" => Some((Letter::O, None)),
            _ => None,
        }
    }

    /// A letter as the sequence has it.
    pub(super) fn name(self, letter: Letter) -> char {
        match (self, letter) {
            (Self::Kinetic, Letter::T) => 'T',
            (Self::Kinetic, Letter::V) => 'V',
            (Self::Parts, Letter::T) => 'A',
            (Self::Parts, Letter::V) => 'B',
            (_, Letter::O) => 'O',
        }
    }
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

    /// The inverse step: every stage undone, the last one first.
    pub(super) fn inverse(&self) -> Self {
        let undone = |element: &Element| Element {
            letter: element.letter,
            coefficient: -element.coefficient,
            gradient: -element.gradient,
        };
        Self { elements: self.elements.iter().rev().map(undone).collect() }
    }

    /// Whether the step is its own adjoint.
    pub(super) fn is_symmetric(&self) -> bool {
        self.elements.iter().zip(self.elements.iter().rev()).all(|(one, other)| {
            one.letter == other.letter
                && (one.coefficient - other.coefficient).vanishes()
                && (one.gradient - other.gradient).vanishes()
        })
    }

    /// Whether some stage is friction.
    pub(super) fn has_friction(&self) -> bool {
        self.elements.iter().any(|element| element.letter == Letter::O)
    }

    /// The stages without friction.
    pub(super) fn without_friction(&self) -> Self {
        let mut stages = Self::default();
        self.elements.iter().filter(|element| element.letter != Letter::O).for_each(|element| stages.push(*element));
        stages
    }

    pub(super) fn has_gradients(&self) -> bool {
        self.elements.iter().any(|element| !element.gradient.vanishes())
    }

    pub(super) fn sum(&self, letter: Letter) -> Coefficient {
        let coefficients = self.elements.iter().filter(|element| element.letter == letter);
        coefficients.fold(Coefficient::ZERO, |sum, element| sum + element.coefficient)
    }
}

#[cfg(test)]
mod tests {
    use crate::scheme::tests::scheme;

    fn text(sequence: &str) -> String {
        let elements = scheme(sequence).stages.elements().to_vec();
        let text = elements.iter().map(|element| {
            format!(
                "{:?}({:.3}, {:.3})",
                element.letter,
                element.coefficient.value.value(),
                element.gradient.value.value()
            )
        });
        text.collect::<Vec<_>>().join(" ").replace(", 0.000)", ")")
    }

    #[test]
    fn neighbours_merge_and_nothing_is_dropped_but_zeros() {
        assert_eq!(text("T(1/4) T(1/4) V(0) T(-1/2) V(1) T(1)"), "V(1.000) T(1.000)");
        assert_eq!(text("compose(Verlet, Verlet)"), "T(0.250) V(0.500) T(0.500) V(0.500) T(0.250)");
        assert_eq!(text("V(1/2) V(1/2, 1/8) T(1)"), "V(1.000, 0.125) T(1.000)");
        assert_eq!(text("compose(T(1) V(1, 8), Euler)"), "T(0.500) V(1.000, 1.000) T(0.500)");
    }

    #[test]
    fn an_adjoint_reads_backwards() {
        assert_eq!(text("adjoint(V(1/3) T(1) V(2/3))"), "V(0.667) T(1.000) V(0.333)");
        assert!(scheme("compose(Euler, adjoint(Euler))").stages.is_symmetric());
        assert!(!scheme("compose(Euler, Euler)").stages.is_symmetric());
        assert!(!scheme("V(1/2, 1/8) T(1) V(1/2)").stages.is_symmetric());
    }
}
