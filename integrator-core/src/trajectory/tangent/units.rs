//! Units in which lengths of deviation vectors do not depend on the units of the system.

use crate::{
    scalar::exact::{exponent, power_of_two},
    state::{coords::Coords, phase::Phase, precision::Precision},
};

/// The unit of positions in deviation vectors, where that of momenta is one.
///
/// It is a power of two, so that vectors are scaled exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Units {
    position: i32,
}

impl Units {
    /// Returns the units in which two blocks of the derivative of a step have about the same size: that of the positions by
    /// the momenta and that of the momenta by the positions.
    ///
    /// If one of them is zero, as for free motion, the other one has the size one.
    pub(crate) fn balancing([of_momenta, of_positions]: [f64; 2]) -> Self {
        let size = |number: f64| (number.is_finite() && number != 0.0).then(|| exponent(number));
        let position = match (size(of_momenta), size(of_positions)) {
            (Some(by_momenta), Some(by_positions)) => (by_momenta - by_positions) / 2,
            (Some(by_momenta), None) => by_momenta,
            (None, Some(by_positions)) => -by_positions,
            (None, None) => 0,
        };
        Self { position }
    }

    /// Two vectors whose images by a step are what [`Units::of_images`] requires: the momenta of a vector, and its positions.
    pub(crate) fn probes<C: Coords>(vector: &Phase<C>) -> [Phase<C>; 2] {
        let zero = C::Leaf::from_parts([0.0; 2]);
        let mut probes = [vector.clone(), vector.clone()];
        probes[0].q.flat_mut().fill(zero);
        probes[1].p.flat_mut().fill(zero);
        probes
    }

    /// Returns the units for the images of both probes by a step.
    pub(crate) fn of_images<C: Coords>([of_momenta, of_positions]: [&Phase<C>; 2]) -> Self {
        let largest = |leaves: &[C::Leaf]| leaves.iter().map(|leaf| leaf.to_f64().abs()).fold(0.0, f64::max);
        Self::balancing([largest(of_momenta.q.flat()), largest(of_positions.p.flat())])
    }

    /// A vector of these units in those of the system.
    pub(crate) fn stretched<C: Coords>(self, vector: Phase<C>) -> Phase<C> {
        each_position(vector, |number| self.stretched_position(number))
    }

    /// A vector of the system in these units.
    pub(crate) fn measured<C: Coords>(self, vector: Phase<C>) -> Phase<C> {
        each_position(vector, |number| self.measured_position(number))
    }

    /// The difference of two positions in these units.
    pub(crate) fn measured_position(self, number: f64) -> f64 {
        number * power_of_two(-self.position)
    }

    /// A difference of positions of these units in those of the system.
    pub(crate) fn stretched_position(self, number: f64) -> f64 {
        number * power_of_two(self.position)
    }

    /// The square of a length in these units, from those of its positions and of its momenta; zero if one of these may have
    /// lost digits to underflow.
    pub(crate) fn square(self, [of_positions, of_momenta]: [f64; 2]) -> f64 {
        if !(of_positions.is_normal() && of_momenta.is_normal()) {
            return 0.0;
        }
        self.measured_position(self.measured_position(of_positions)) + of_momenta
    }
}

fn each_position<C: Coords>(mut vector: Phase<C>, change: impl Fn(f64) -> f64) -> Phase<C> {
    vector.q.flat_mut().iter_mut().for_each(|leaf| *leaf = C::Leaf::from_parts(leaf.parts().map(&change)));
    vector
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_do_not_depend_on_the_units_of_positions() {
        // A step of an oscillator with the frequency one, in units that are as far apart as these powers of two.
        for power in [-200, -31, -2, 0, 2, 64, 200] {
            let length = power_of_two(power);
            let units = Units::balancing([0.1 * length, 0.1 / length]);
            let vector = Phase::new([3.0 * length], [4.0]);
            assert_eq!(units.measured(vector), Phase::new([3.0], [4.0]), "2^{power}");
            assert_eq!(units.stretched(Phase::new([3.0], [4.0])), vector, "2^{power}");
            assert_eq!(units.square([9.0 * length * length, 16.0]), 25.0, "2^{power}");
        }
        assert_eq!(Units::balancing([0.0, f64::NAN]), Units::balancing([1.0, 1.0]));
        assert_eq!(Units::balancing([8.0, 0.0]).measured_position(8.0), 1.0);
        assert_eq!(Units::balancing([0.0, 8.0]).measured_position(1.0), 8.0);
        assert_eq!(Units::balancing([1.0; 2]).square([1e-310, 1.0]), 0.0);
    }
}
