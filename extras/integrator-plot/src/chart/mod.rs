//! Curves and points over two axes.

mod draw;
#[cfg(test)]
mod tests;

use crate::{
    axis::Axis,
    canvas::Marker,
    colour::Colour,
    field::Field,
    picture::{SaveError, save},
    series::{DASHES, Mark, Series},
};
use std::{ops::RangeInclusive, path::Path};

/// A chart: title, claim, axes and series, set by method calls.
#[derive(Clone, Debug)]
pub struct Chart {
    title: String,
    claim: String,
    measured: String,
    axes: [Axis; 2],
    field: Option<Field>,
    series: Vec<Series>,
    equal_units: bool,
    names_at_ends: bool,
    is_embedded: bool,
    size: (u32, u32),
}

impl Chart {
    /// Creates a chart without series. Both axes are linear and unnamed until [`Chart::along`] and [`Chart::up`] set
    /// them.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            claim: String::new(),
            measured: String::new(),
            axes: [Axis::linear(""), Axis::linear("")],
            field: None,
            series: Vec::new(),
            equal_units: false,
            names_at_ends: false,
            is_embedded: false,
            size: (1000, 640),
        }
    }

    /// Sets the title; an empty text removes it.
    #[must_use]
    pub fn title(mut self, title: impl Into<String>) -> Self {
        self.title = title.into();
        self
    }

    /// Sets the claim under the title: the result that the chart shows.
    #[must_use]
    pub fn claim(mut self, claim: impl Into<String>) -> Self {
        self.claim = claim.into();
        self
    }

    /// Sets the measured result, in bold under the claim.
    #[must_use]
    pub fn measured(mut self, measured: impl Into<String>) -> Self {
        self.measured = measured.into();
        self
    }

    /// Sets the horizontal axis.
    #[must_use]
    pub fn along(mut self, axis: Axis) -> Self {
        self.axes[0] = axis;
        self
    }

    /// Sets the vertical axis.
    #[must_use]
    pub fn up(mut self, axis: Axis) -> Self {
        self.axes[1] = axis;
        self
    }

    /// Makes equal differences equally long along both axes: circles are round.
    #[must_use]
    pub fn with_equal_units(mut self) -> Self {
        self.equal_units = true;
        self
    }

    /// Writes the names at the ends of their series, without overlap, instead of in a legend.
    #[must_use]
    pub fn with_names_at_ends(mut self) -> Self {
        self.names_at_ends = true;
        self
    }

    /// Sets the width and height in pixels. The default is 1000 by 640. In [`Panels`](crate::Panels), all charts have
    /// the size of the panel.
    #[must_use]
    pub fn sized(mut self, width: u32, height: u32) -> Self {
        self.size = (width, height);
        self
    }

    /// Adds a series with any mark. A series with an empty name is not in the legend.
    #[must_use]
    pub fn series(mut self, mark: Mark, name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let place = self.series.len();
        self.series.push(Series::new(place, name.into(), mark, points.into_iter().collect()));
        self
    }

    /// Adds a line.
    #[must_use]
    pub fn line(self, name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.series(Mark::Line, name, points)
    }

    /// Adds a circle for each point, for some hundreds of points.
    #[must_use]
    pub fn dots(self, name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.series(Mark::Dots, name, points)
    }

    /// Adds a pixel for each point, for any number of points.
    ///
    /// All clouds of a chart are one bitmap, so an SVG has the same size for a thousand points and for a million.
    #[must_use]
    pub fn cloud(self, name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.series(Mark::Cloud, name, points)
    }

    /// Adds numbers over a plane as colours, with a colour bar: rows from the lowest one up, each from left to right,
    /// all of the same length.
    ///
    /// Cells without a finite number stay white; on a logarithmic axis, cells that are not positive as well. Series are
    /// drawn above the field.
    #[must_use]
    pub fn field<R: AsRef<[f64]>>(
        mut self,
        [along, up]: [RangeInclusive<f64>; 2],
        values: Axis,
        rows: impl IntoIterator<Item = R>,
    ) -> Self {
        let corners = [(*along.start(), *up.start()), (*along.end(), *up.end())];
        let mut field = Field { corners, columns: 0, values: Vec::new(), axis: values };
        for row in rows {
            let row = row.as_ref();
            if field.values.is_empty() {
                field.columns = row.len();
            }
            field.values.extend((0..field.columns).map(|column| row.get(column).copied().unwrap_or(f64::NAN)));
        }
        self.field = (field.columns > 0).then_some(field);
        self
    }

    /// Sets the colour of the last series, and makes its line solid.
    #[must_use]
    pub fn coloured(self, colour: Colour) -> Self {
        self.last(|series| (series.colour, series.dashes) = (colour, &[]))
    }

    /// Draws the last series with dashes, if it is a line.
    #[must_use]
    pub fn dashed(self) -> Self {
        self.last(|series| series.dashes = DASHES)
    }

    /// Sets the marker of the last series.
    #[must_use]
    pub fn marked(self, marker: Marker) -> Self {
        self.last(|series| series.marker = marker)
    }

    /// Sets the width of the last series in pixels. The default is 2.
    #[must_use]
    pub fn wide(self, width: f64) -> Self {
        self.last(|series| series.width = width)
    }

    /// Names the series in the order in which they were added, such as the bodies of [`orbit`](crate::orbit). Further series keep their
    /// names.
    #[must_use]
    pub fn names(mut self, names: impl IntoIterator<Item = impl Into<String>>) -> Self {
        self.series.iter_mut().zip(names).for_each(|(series, name)| series.name = name.into());
        self
    }

    /// Marks the last series as optional: in [`Chart::embedded`] it has the class `more` and no name beside the axes, so that
    /// the style of a page can hide it.
    #[must_use]
    pub fn optional(self) -> Self {
        self.last(|series| series.optional = true)
    }

    /// Returns title, claim and measured result, for a page that shows them beside the chart.
    #[must_use]
    pub fn words(&self) -> [&str; 3] {
        [&self.title, &self.claim, &self.measured]
    }

    fn last(mut self, change: impl FnOnce(&mut Series)) -> Self {
        if let Some(last) = self.series.last_mut() {
            change(last);
        }
        self
    }

    /// Writes the chart to `file`, and creates its folder. The extension selects the format: `.png` or `.svg`.
    ///
    /// A PNG has twice the resolution of the picture, for sharp print.
    ///
    /// # Errors
    /// The extension is another one, or the file cannot be written.
    pub fn save(&self, file: impl AsRef<Path>) -> Result<(), SaveError> {
        save(file.as_ref(), self)
    }
}
