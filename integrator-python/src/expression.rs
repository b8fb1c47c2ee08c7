//! Coordinates as text, such as `q[0]` or `p[1, 2] - 0.5`: functions whose crossings are searched.

use crate::errors::input_error;
use pyo3::PyResult;

/// A coordinate minus a number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Expression {
    is_position: bool,
    index: usize,
    offset: f64,
}

impl Expression {
    /// Parses a coordinate of arrays with these axes, with a number added or subtracted.
    ///
    /// # Errors
    /// `InputError` with the axes.
    pub(crate) fn parse(text: &str, axes: &[usize]) -> PyResult<Self> {
        Self::of(&text.replace(' ', ""), axes).ok_or_else(|| {
            let indices = if axes.len() == 1 { "q[0]" } else { "q[0, 1]" };
            input_error(format!(
                "the expression {text:?} is not a coordinate of arrays with the shape {axes:?}\nhelp: write \"{indices}\" or \
                 \"{indices} - 0.5\", or pass a function f(q, p, t) of flat arrays"
            ))
        })
    }

    fn of(text: &str, axes: &[usize]) -> Option<Self> {
        let (name, rest) = text.split_once('[')?;
        let end = rest.rfind(']')?;
        let indices: Vec<usize> =
            rest[..end].split(',').flat_map(|part| part.split("][")).map(str::parse).collect::<Result<_, _>>().ok()?;
        let offset = match &rest[end + 1..] {
            "" => 0.0,
            offset if offset.starts_with(['+', '-']) => offset.parse().ok()?,
            _ => return None,
        };
        let is_within = indices.len() == axes.len() && indices.iter().zip(axes).all(|(index, axis)| index < axis);
        let index = indices.iter().zip(axes).fold(0, |flat, (index, axis)| flat * axis + index);
        (is_within && ["q", "p"].contains(&name)).then_some(Self { is_position: name == "q", index, offset })
    }

    /// Evaluates the expression for flat positions and momenta.
    pub(crate) fn value(self, q: &[f64], p: &[f64]) -> f64 {
        (if self.is_position { q } else { p }).get(self.index).map_or(f64::NAN, |value| value + self.offset)
    }
}
