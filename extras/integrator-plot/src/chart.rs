//! Curves and points over two axes.

use crate::{
    axis::Axis,
    canvas::{Canvas, Marker, Place},
    colour::Colour,
    field::Field,
    frame::{Frame, Margins, Room},
    picture::{Picture, SaveError, head, save},
    series::{DASHES, Mark, Series},
    text::{bold, font},
};
use std::{ops::RangeInclusive, path::Path};

/// The width in pixels from which an embedded chart has letters of full size.
const WIDE: u32 = 500;

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

    /// Returns the axes and series as SVG of this size, without title, claim and measured result.
    ///
    /// # Errors
    /// The fonts cannot be read.
    pub fn embedded(&self, (width, height): (u32, u32)) -> Result<String, SaveError> {
        let mut canvas = Canvas::new((width, height)).map_err(SaveError::Fonts)?;
        let bare = Self { is_embedded: true, ..self.clone() };
        let text = if width < WIDE { 13.0 } else { 15.0 };
        let beside = bare.beside(&canvas, text);
        let margins = Margins { top: 8.0, right: beside + 4.0, text };
        bare.plot(&mut canvas, [0.0, 0.0, f64::from(width), f64::from(height)], margins);
        bare.legend(&mut canvas, (f64::from(width) - beside - 2.0, 20.0), text);
        Ok(canvas.svg())
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

    fn named(&self) -> impl Iterator<Item = &Series> {
        self.series.iter().filter(|series| !(series.name.is_empty() || self.is_embedded && series.optional))
    }

    /// Whether names are needed: one series is what the title says.
    fn has_names(&self) -> bool {
        self.named().nth(1).is_some()
    }

    /// Returns the width of the names or the bar on the right of the axes.
    fn beside(&self, canvas: &Canvas, text: f64) -> f64 {
        let names = self.named().filter(|_| self.has_names()).map(|series| {
            let (width, room) = if self.names_at_ends {
                (canvas.width(&series.name, bold(text)), 6.0)
            } else {
                (canvas.width(&series.name, font(text)), 54.0)
            };
            width + room
        });
        names.fold(self.field.as_ref().map_or(0.0, |field| field.width(canvas, text)), f64::max)
    }

    /// Draws between the axes, and these.
    fn plot(&self, canvas: &mut Canvas, room: Room, margins: Margins) {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let corners = || self.field.iter().flat_map(|field| field.corners);
        let field = self.field.as_ref();
        let fit = |i: usize, of: fn(&(f64, f64)) -> f64| {
            let axis = &self.axes[i];
            // A field fills its axes, without room around.
            let ends = field.filter(|_| axis.ends.is_none()).map(|field| field.corners.map(|corner| of(&corner)));
            match ends {
                Some([least, most]) => axis.clone().between(least, most).fit([]),
                None => axis.fit(points().map(of).chain(corners().map(|corner| of(&corner)))),
            }
        };
        let scales = [fit(0, |point| point.0), fit(1, |point| point.1)];
        let mut frame = Frame::new(canvas, room, margins, scales);
        if self.equal_units {
            frame = frame.with_equal_units();
        }
        let clouds = self.series.iter().filter(|series| series.mark == Mark::Cloud);
        let clouds: Vec<_> = clouds.map(|series| (&series.points[..], series.colour)).collect();
        match field {
            Some(field) => field.draw(&mut frame),
            None if clouds.is_empty() => frame.grid(),
            None => frame.clouds(&clouds),
        }
        for series in &self.series {
            let grouped = self.is_embedded && (series.optional || !series.name.is_empty());
            if grouped {
                frame.begin(&series.name, series.optional);
            }
            series.draw(&mut frame);
            if grouped {
                frame.end();
            }
        }
        frame.axes([&self.axes[0].name, &self.axes[1].name]);
        if self.names_at_ends && self.has_names() {
            let ends =
                self.named().filter_map(|series| Some((*series.points.last()?, &series.name[..], series.colour)));
            frame.names(&ends.collect::<Vec<_>>());
        }
        let border = frame.border();
        if let Some(field) = field {
            field.bar(canvas, border, margins.text);
        }
    }

    fn legend(&self, canvas: &mut Canvas, (x, mut y): Place, text: f64) {
        if self.names_at_ends || !self.has_names() {
            return;
        }
        for series in self.named() {
            series.sign(canvas, (x, y));
            canvas.text(&series.name, (x + 38.0, y + 0.36 * text), font(text));
            y += 1.6 * text;
        }
    }

    /// Draws the chart as one of several: a smaller head, and no names but those at the ends of curves.
    pub(crate) fn draw_panel(&self, canvas: &mut Canvas, room: Room) {
        let [left, top, right, _] = room;
        let (x, width) = (left + 12.0, right - left - 20.0);
        let mut below = canvas.paragraph(&self.title, (x, top + 6.0), width, bold(16.0));
        below = canvas.paragraph(&self.claim, (x, below), width, font(13.0));
        below = canvas.paragraph(&self.measured, (x, below), width, bold(13.0));
        let right = if self.names_at_ends {
            self.beside(canvas, 13.0) + 12.0
        } else {
            self.field.as_ref().map_or(0.0, |field| field.width(canvas, 13.0)) + 2.0
        };
        self.plot(canvas, room, Margins { top: below - top + 8.0, right, text: 13.0 });
    }
}

impl Picture for Chart {
    fn size(&self) -> (u32, u32) {
        self.size
    }

    fn draw(&self, canvas: &mut Canvas) {
        let [across, down] = [self.size.0, self.size.1].map(f64::from);
        let mut below = head(canvas, &self.title, &self.claim);
        below = canvas.paragraph(&self.measured, (24.0, below), across - 48.0, bold(16.0));
        let beside = self.beside(canvas, 15.0);
        let margins = Margins { top: below + 12.0, right: beside + 12.0, text: 15.0 };
        self.plot(canvas, [0.0, 0.0, across, down], margins);
        self.legend(canvas, (across - beside - 6.0, below + 24.0), 15.0);
    }
}

#[cfg(test)]
mod tests {
    use super::Chart;
    use crate::{Axis, drawn};

    #[test]
    fn a_chart_has_its_words_curves_and_dots() {
        let points = || (1..=9).map(|i| (f64::from(i), 10.0_f64.powi(-i)));
        let chart = Chart::new("Errors")
            .claim("They fall")
            .measured("order 2.00")
            .along(Axis::linear("step"))
            .up(Axis::logarithmic("error"))
            .line("first", points())
            .line("second", points().map(|(x, y)| (x, y / 2.0)))
            .dashed()
            .dots("third", points());
        let (text, png) = drawn(&chart);
        for word in ["Errors", "They fall", "order 2.00", "step", "error", "first", "second", "third", ">10⁻⁸<", ">4<"]
        {
            assert!(text.contains(word), "{word} is missing in {text}");
        }
        assert_eq!(text.matches("<circle").count(), 9 + 1, "the dots, and one in the legend");
        assert!(png.len() > 1_000);
    }

    #[test]
    fn a_million_points_are_a_small_picture() {
        let spiral = (0..1_000_000).map(|i| f64::from(i) * 1e-3).map(|t| (t.sin() * t, t.cos() * t));
        let (text, png) = drawn(&Chart::new("Spiral").cloud("", spiral).with_equal_units());
        assert!(text.contains("<image"), "points are a bitmap");
        assert!(text.len() < 2_000_000 && png.len() < 2_000_000, "{} and {} bytes", text.len(), png.len());
    }

    #[test]
    fn a_line_of_a_million_points_is_a_small_picture() {
        let noise = (0..1_000_000).map(|i| (f64::from(i), (f64::from(i) * 1e3).sin()));
        let (text, _) = drawn(&Chart::new("Noise").line("", noise));
        assert!(text.len() < 200_000, "{} bytes", text.len());
    }

    #[test]
    fn one_named_series_needs_no_legend() {
        let chart = |names: &[&str]| {
            names.iter().fold(Chart::new("Legend"), |chart, name| chart.line(*name, [(0.0, 0.0), (1.0, 1.0)]))
        };
        assert!(!drawn(&chart(&["alone"])).0.contains("alone"));
        for chart in [chart(&["alone", "other"]), chart(&["alone", "other"]).with_names_at_ends()] {
            assert!(drawn(&chart).0.contains(">alone<"));
        }
    }

    /// The heights at which a text of the SVG stands.
    fn height(svg: &str, text: &str) -> f64 {
        let before = svg.split(&format!(">{text}<")).next().expect("a beginning");
        let number = before.rsplit("y=\"").next().and_then(|rest| rest.split('"').next());
        number.and_then(|number| number.parse().ok()).expect("a height")
    }

    #[test]
    fn an_embedded_chart_has_axes_and_no_head_and_optional_series_can_be_hidden() {
        let series = |chart: Chart, name: &str| chart.line(name, [(0.0, 0.0), (1.0, 1.0)]);
        let chart = series(series(Chart::new("Title").claim("Claim").along(Axis::linear("axis")), "one"), "two");
        let chart = series(chart, "three & more").optional();
        let embedded = chart.embedded((720, 460)).expect("fonts");
        for part in
            [">axis<", ">one</text>", "<g class=\"more\"><title>three &amp; more</title>", "<g><title>one</title>"]
        {
            assert!(embedded.contains(part), "{part} is missing in {embedded}");
        }
        assert!(!embedded.contains("Title") && !embedded.contains("Claim") && !embedded.contains("more</text>"));
        assert_eq!(embedded.matches("<g").count(), embedded.matches("</g>").count());
        assert!(drawn(&chart).0.contains(">three &amp; more</text>"), "a file has all names");
        assert_eq!(chart.words(), ["Title", "Claim", ""]);
    }

    #[test]
    fn more_lines_than_colours_differ_in_their_dashes() {
        let count = 4 * crate::colour::COLOURS.len();
        let chart = (0..count).fold(Chart::new("Many"), |chart, i| chart.line("", [(0.0, 0.0), (1.0, i as f64)]));
        let style = |series: &super::Series| (series.colour, series.dashes);
        assert!((0..count).all(|i| (0..i).all(|j| style(&chart.series[i]) != style(&chart.series[j]))));
    }

    #[test]
    fn names_at_ends_are_clear_of_each_other() {
        let names = ["one", "two", "three"];
        let chart = names
            .iter()
            .fold(Chart::new("Ends").with_names_at_ends(), |chart, name| chart.line(*name, [(0.0, 0.0), (1.0, 1.0)]));
        let (svg, _) = drawn(&chart);
        let mut heights = names.map(|name| height(&svg, name));
        heights.sort_by(f64::total_cmp);
        assert!(heights.windows(2).all(|pair| pair[1] - pair[0] > 15.0), "{heights:?}");
    }

    #[test]
    fn a_field_has_a_bar_and_leaves_cells_without_a_number_white() {
        let rows = [vec![1.0, 2.0], vec![f64::NAN, 4.0], vec![3.0]];
        let chart = Chart::new("Field").field([0.0..=1.0, 0.0..=3.0], Axis::linear("height"), rows);
        let (svg, _) = drawn(&chart);
        assert_eq!(svg.matches("<image").count(), 2, "the field and its bar");
        assert!(svg.contains(">height<") && svg.contains(">1.5<"), "{svg}");
        let nothing: [Vec<f64>; 0] = [];
        let (svg, _) = drawn(&Chart::new("Nothing").field([0.0..=1.0, 0.0..=1.0], Axis::linear(""), nothing));
        assert!(!svg.contains("<image"));
    }
}
