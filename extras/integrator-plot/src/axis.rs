//! Linear, logarithmic and signed logarithmic axes.

use crate::ticks;

/// The scale of an axis: equal lengths are equal differences of the scaled numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Form {
    #[default]
    Linear,
    /// Decimal logarithms.
    Logarithmic,
    /// Decimal logarithms of both signs, with numbers up to this one drawn linearly between them.
    Signed(f64),
}

/// The name and the scale of an axis. Without [`Axis::between`], it extends from the smallest to the largest
/// coordinate, with some margin.
#[derive(Clone, Debug, Default)]
pub struct Axis {
    pub(crate) name: String,
    pub(crate) form: Form,
    pub(crate) ends: Option<[f64; 2]>,
}

impl Axis {
    /// Creates a linear axis.
    pub fn linear(name: impl Into<String>) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    /// Creates a logarithmic axis. Coordinates that are not positive are not drawn.
    pub fn logarithmic(name: impl Into<String>) -> Self {
        Self { name: name.into(), form: Form::Logarithmic, ..Self::default() }
    }

    /// Creates a logarithmic axis for numbers of both signs, with a linear band around zero.
    ///
    /// The band is one decade high on either side and contains numbers up to `smallest`. Growing, decaying and small
    /// quantities are hence visible in one chart. If `smallest` is not positive, the axis is linear.
    pub fn signed_logarithmic(name: impl Into<String>, smallest: f64) -> Self {
        let form = if smallest > 0.0 && smallest.is_finite() { Form::Signed(smallest) } else { Form::Linear };
        Self { name: name.into(), form, ..Self::default() }
    }

    /// Sets the ends of the axis. Points beyond them are cut off.
    #[must_use]
    pub fn between(mut self, least: f64, most: f64) -> Self {
        self.ends = Some([least, most]);
        self
    }

    /// Returns the scale for these coordinates.
    #[must_use]
    pub fn fit(&self, coordinates: impl IntoIterator<Item = f64>) -> Scale {
        let scale = Scale { form: self.form, least: 0.0, most: 1.0 };
        if let Some(ends) = self.ends {
            let [least, most] = ends.map(|end| scale.height(end));
            return Scale { least, most, ..scale };
        }
        let heights = coordinates.into_iter().map(|x| scale.height(x)).filter(|height| height.is_finite());
        let (least, most) =
            heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)));
        if least > most {
            return scale;
        }
        // A single number lies in the middle of a decade, or of as much as it is.
        let room = match most - least {
            length if length > 0.0 => 0.04 * length,
            _ if self.form != Form::Linear || least == 0.0 => 0.5,
            _ => 0.5 * least.abs(),
        };
        Scale { least: least - room, most: most + room, ..scale }
    }
}

/// An axis with known ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    form: Form,
    /// The heights of the ends.
    pub(crate) least: f64,
    pub(crate) most: f64,
}

impl Scale {
    /// The coordinate, or its logarithm; not finite where that has none.
    fn height(&self, coordinate: f64) -> f64 {
        match self.form {
            Form::Linear => coordinate,
            Form::Logarithmic => coordinate.log10(),
            Form::Signed(smallest) if coordinate.abs() <= smallest => coordinate / smallest,
            Form::Signed(smallest) => (1.0 + (coordinate.abs() / smallest).log10()).copysign(coordinate),
        }
    }

    /// Returns the position of a coordinate as a fraction of the axis, from zero to one.
    #[must_use]
    pub fn part(&self, coordinate: f64) -> Option<f64> {
        let part = (self.height(coordinate) - self.least) / (self.most - self.least);
        part.is_finite().then_some(part)
    }

    /// Returns at most `at_most` labels along the axis, with their positions.
    #[must_use]
    pub fn labels(&self, at_most: usize) -> Vec<(f64, String)> {
        let range = self.least..=self.most;
        let labels = match self.form {
            Form::Linear => ticks::linear(range, at_most),
            Form::Logarithmic => ticks::logarithmic(range, at_most),
            Form::Signed(smallest) => ticks::signed(range, smallest, at_most),
        };
        let length = self.most - self.least;
        labels.into_iter().map(|(height, text)| ((height - self.least) / length, text)).collect()
    }

    /// Returns the range with the same middle, and this number of times the length.
    pub(crate) fn stretched(self, factor: f64) -> Self {
        let (middle, half) = (0.5 * (self.least + self.most), 0.5 * factor * (self.most - self.least));
        Self { least: middle - half, most: middle + half, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::Axis;

    #[test]
    fn a_scale_contains_the_values_it_is_fitted_to() {
        let inside = |part: Option<f64>| part.is_some_and(|part| (0.0..=1.0).contains(&part));
        let linear = Axis::linear("x").fit([-3.0, 5.0, f64::NAN]);
        assert!(inside(linear.part(-3.0)) && inside(linear.part(5.0)) && !inside(linear.part(9.0)));
        let logarithmic = Axis::logarithmic("x").fit([1e-9, 0.0, 1e3, f64::INFINITY]);
        assert!(inside(logarithmic.part(1e-9)) && inside(logarithmic.part(1e3)));
        assert_eq!(logarithmic.part(0.0), None);
        assert_eq!(logarithmic.part(-1.0), None);
    }

    #[test]
    fn a_scale_for_one_number_or_none_has_a_length() {
        for numbers in [&[][..], &[0.0], &[7.0]] {
            for axis in [Axis::linear("x"), Axis::logarithmic("x"), Axis::signed_logarithmic("x", 1e-3)] {
                let scale = axis.fit(numbers.iter().copied());
                assert!(scale.most > scale.least, "{numbers:?}");
                assert!(!scale.labels(6).is_empty(), "{numbers:?}");
            }
        }
    }

    #[test]
    fn given_ends_are_the_ends() {
        let scale = Axis::logarithmic("x").between(0.1, 10.0).fit([1e9]);
        assert_eq!([0.1, 1.0, 10.0].map(|x| scale.part(x)), [Some(0.0), Some(0.5), Some(1.0)]);
    }

    #[test]
    fn a_signed_axis_has_decades_on_both_sides_of_zero() {
        let scale = Axis::signed_logarithmic("x", 1e-3).between(-1.0, 1.0).fit([]);
        // Four decades each way, the innermost of which is linear.
        let places = [-1.0, -1e-3, 0.0, 5e-4, 1e-3, 1e-2, 1.0].map(|x| scale.part(x).expect("a place"));
        let expected = [0.0, 0.375, 0.5, 0.5625, 0.625, 0.75, 1.0];
        for (place, expected) in places.iter().zip(expected) {
            assert!((place - expected).abs() < 1e-12, "{places:?}");
        }
        assert_eq!(Axis::signed_logarithmic("x", 0.0).between(0.0, 2.0).fit([]).part(1.0), Some(0.5));
    }
}
