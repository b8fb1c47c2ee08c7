//! Several charts in rows.

use crate::{
    canvas::Canvas,
    chart::Chart,
    picture::{Picture, SaveError, head, save},
    text::bold,
};
use std::path::Path;

/// Charts of equal size in rows under a common title, each with its own title and claim.
#[derive(Clone, Debug)]
pub struct Panels {
    title: String,
    claim: String,
    measured: String,
    columns: usize,
    panel: (u32, u32),
    charts: Vec<Chart>,
}

impl Panels {
    /// Creates an empty picture with rows of three charts.
    pub fn new(title: impl Into<String>, claim: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            claim: claim.into(),
            measured: String::new(),
            columns: 3,
            panel: (380, 360),
            charts: Vec::new(),
        }
    }

    /// Sets the measured result, in bold under the claim.
    #[must_use]
    pub fn measured(mut self, measured: impl Into<String>) -> Self {
        self.measured = measured.into();
        self
    }

    /// Sets the number of charts in a row.
    #[must_use]
    pub fn columns(mut self, columns: usize) -> Self {
        self.columns = columns.max(1);
        self
    }

    /// Sets the width and height of a chart in pixels. The default is 380 by 360.
    #[must_use]
    pub fn panel(mut self, width: u32, height: u32) -> Self {
        self.panel = (width, height);
        self
    }

    /// Adds a chart.
    #[must_use]
    pub fn chart(mut self, chart: Chart) -> Self {
        self.charts.push(chart);
        self
    }

    /// Writes the panels to `file`, and creates its folder. The extension selects the format: `.png` or `.svg`.
    ///
    /// A PNG has twice the resolution of the picture, for sharp print.
    ///
    /// # Errors
    /// The extension is another one, or the file cannot be written.
    pub fn save(&self, file: impl AsRef<Path>) -> Result<(), SaveError> {
        save(file.as_ref(), self)
    }

    /// Returns title, claim and measured result, for a page that shows them beside the charts.
    #[must_use]
    pub fn words(&self) -> [&str; 3] {
        [&self.title, &self.claim, &self.measured]
    }

    /// Returns the charts.
    #[must_use]
    pub fn charts(&self) -> &[Chart] {
        &self.charts
    }

    /// Returns the number of charts in a row.
    #[must_use]
    pub fn column_count(&self) -> usize {
        self.columns
    }

    /// Returns the width and height of a chart in pixels.
    #[must_use]
    pub fn chart_size(&self) -> (u32, u32) {
        self.panel
    }

    fn width(&self) -> u32 {
        self.panel.0 * self.columns as u32 + 24
    }

    /// The room for the common head: the title, and lines of some nine pixels for a letter.
    fn head(&self) -> u32 {
        let lines = |text: &str| (9 * text.chars().count() as u32).div_ceil(self.width().max(100) - 48);
        64 + 21 * (lines(&self.claim) + lines(&self.measured))
    }
}

impl Picture for Panels {
    fn size(&self) -> (u32, u32) {
        let rows = self.charts.len().div_ceil(self.columns).max(1) as u32;
        (self.width(), self.panel.1 * rows + self.head() + 8)
    }

    fn draw(&self, canvas: &mut Canvas) {
        let below = head(canvas, &self.title, &self.claim);
        canvas.paragraph(&self.measured, (24.0, below), f64::from(self.width()) - 48.0, bold(16.0));
        let (width, height) = self.panel;
        for (place, chart) in self.charts.iter().enumerate() {
            let (row, column) = ((place / self.columns) as u32, (place % self.columns) as u32);
            let (left, top) = (12 + column * width, self.head() + row * height);
            chart.draw_panel(canvas, [left, top, left + width, top + height].map(f64::from));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Panels;
    use crate::{Axis, Chart, Picture, drawn};

    #[test]
    fn every_panel_has_its_title_and_its_curve() {
        let panels = (0..4).fold(Panels::new("All", "Four of them").columns(2), |panels, i| {
            let points = (0..20).map(|x| (f64::from(x), f64::from(x * i)));
            panels.chart(Chart::new(format!("number {i}")).along(Axis::linear("x")).line("", points))
        });
        assert_eq!(panels.size(), (784, 2 * 360 + 64 + 21 + 8));
        let (text, _) = drawn(&panels);
        for word in ["All", "Four of them", "number 0", "number 3"] {
            assert!(text.contains(word), "{word} is missing in {text}");
        }
        assert_eq!(text.matches(r##"stroke="#1e1e1e""##).count(), 4, "a curve in each");
    }

    #[test]
    fn names_at_the_ends_of_curves_are_inside_of_their_panel() {
        let name = "a name of some length";
        let chart = || Chart::new("Ends").with_names_at_ends().line("", [(0.0, 0.0), (1.0, 1.0)]);
        let chart =
            || [name, "other"].into_iter().fold(chart(), |chart, name| chart.line(name, [(0.0, 0.0), (1.0, 1.0)]));
        let (text, _) = drawn(&Panels::new("One", "").columns(1).panel(600, 400).chart(chart()));
        let x =
            text.lines().find(|line| line.contains(name)).and_then(|line| line.split("x=\"").nth(1)?.split('"').next());
        let x: f64 = x.expect("a place").parse().expect("a number");
        // Letters of a bold face of 13 pixels are seven wide on the mean.
        assert!(x + 7.0 * name.len() as f64 <= 624.0, "{x}");
    }
}
