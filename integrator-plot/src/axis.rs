//! Linear and logarithmic axes.

use crate::ticks;

/// What an axis is called and how it goes. Without [`Axis::between`], it reaches from the least to the greatest
/// coordinate with some room on both sides.
#[derive(Clone, Debug, Default)]
pub struct Axis {
    pub(crate) name: String,
    pub(crate) logarithmic: bool,
    pub(crate) ends: Option<[f64; 2]>,
}

impl Axis {
    /// An axis along which equal lengths are equal differences.
    pub fn linear(name: impl Into<String>) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    /// An axis along which equal lengths are equal factors. What is not positive is not drawn.
    pub fn logarithmic(name: impl Into<String>) -> Self {
        Self { name: name.into(), logarithmic: true, ..Self::default() }
    }

    /// Ends the axis here and there. What lies beyond is cut off.
    #[must_use]
    pub fn between(mut self, least: f64, most: f64) -> Self {
        self.ends = Some([least, most]);
        self
    }

    /// The scale that these coordinates need.
    #[must_use]
    pub fn fit(&self, coordinates: impl IntoIterator<Item = f64>) -> Scale {
        let scale = Scale { logarithmic: self.logarithmic, least: 0.0, most: 1.0 };
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
            _ if self.logarithmic || least == 0.0 => 0.5,
            _ => 0.5 * least.abs(),
        };
        Scale { least: least - room, most: most + room, ..scale }
    }
}

/// An axis whose ends are known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    pub(crate) logarithmic: bool,
    /// The ends; decimal logarithms of them on a logarithmic axis.
    pub(crate) least: f64,
    pub(crate) most: f64,
}

impl Scale {
    /// The coordinate, or its logarithm; not finite where that has none.
    fn height(&self, coordinate: f64) -> f64 {
        if self.logarithmic { coordinate.log10() } else { coordinate }
    }

    /// Where a coordinate lies: zero is the beginning, one is the end.
    #[must_use]
    pub fn part(&self, coordinate: f64) -> Option<f64> {
        let part = (self.height(coordinate) - self.least) / (self.most - self.least);
        part.is_finite().then_some(part)
    }

    /// What is written along the axis, with its place, at most so many labels.
    #[must_use]
    pub fn labels(&self, at_most: usize) -> Vec<(f64, String)> {
        let ticks = if self.logarithmic { ticks::logarithmic } else { ticks::linear };
        let length = self.most - self.least;
        let labels = ticks(self.least..=self.most, at_most).into_iter();
        labels.map(|(height, text)| ((height - self.least) / length, text)).collect()
    }

    /// The same middle, and so many times the length.
    pub(crate) fn stretched(self, factor: f64) -> Self {
        let (middle, half) = (0.5 * (self.least + self.most), 0.5 * factor * (self.most - self.least));
        Self { least: middle - half, most: middle + half, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::Axis;

    #[test]
    fn a_scale_holds_what_it_is_fitted_to() {
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
            for axis in [Axis::linear("x"), Axis::logarithmic("x")] {
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
}
