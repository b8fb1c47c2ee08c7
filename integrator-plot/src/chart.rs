//! Curves and points over two axes.

use crate::{
    axis::Axis,
    frame::{Frame, Margins},
    picture::{Area, Outcome, Picture, head},
    series::{Mark, Series},
    text::{bold, font, paragraph, width},
};
use plotters::{element::DashedPathElement, prelude::*};
use std::error::Error;

/// A chart, put together call by call: what it is called, what it shows, its axes, then its series.
#[derive(Clone, Debug)]
pub struct Chart {
    title: String,
    claim: String,
    measured: String,
    axes: [Axis; 2],
    series: Vec<Series>,
    equal_units: bool,
    size: (u32, u32),
}

impl Chart {
    /// A chart without axes and series. Both axes are linear and have no name until [`Chart::along`] and [`Chart::up`].
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            claim: String::new(),
            measured: String::new(),
            axes: [Axis::linear(""), Axis::linear("")],
            series: Vec::new(),
            equal_units: false,
            size: (1000, 640),
        }
    }

    /// What there is to see, under the title.
    #[must_use]
    pub fn claim(mut self, claim: impl Into<String>) -> Self {
        self.claim = claim.into();
        self
    }

    /// The number that was measured for it, in bold under the claim.
    #[must_use]
    pub fn measured(mut self, measured: impl Into<String>) -> Self {
        self.measured = measured.into();
        self
    }

    /// The horizontal axis.
    #[must_use]
    pub fn along(mut self, axis: Axis) -> Self {
        self.axes[0] = axis;
        self
    }

    /// The vertical axis.
    #[must_use]
    pub fn up(mut self, axis: Axis) -> Self {
        self.axes[1] = axis;
        self
    }

    /// Equal differences are equally long along both axes: circles are round.
    #[must_use]
    pub fn with_equal_units(mut self) -> Self {
        self.equal_units = true;
        self
    }

    /// Width and height in pixels, 1000 by 640 without this. In [`Panels`](crate::Panels) all charts have the size of the
    /// panel.
    #[must_use]
    pub fn sized(mut self, width: u32, height: u32) -> Self {
        self.size = (width, height);
        self
    }

    /// A series drawn in any way. A name that is empty has no place in the legend.
    #[must_use]
    pub fn series(mut self, mark: Mark, name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let place = self.series.len();
        self.series.push(Series::new(place, name.into(), mark, points.into_iter().collect()));
        self
    }

    /// A line.
    #[must_use]
    pub fn line(self, name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.series(Mark::Line, name, points)
    }

    /// A dot for each point: some hundreds of them, drawn as circles.
    #[must_use]
    pub fn dots(self, name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.series(Mark::Dots, name, points)
    }

    /// A pixel for each point: any number of them. All clouds of a chart are one bitmap, also in the SVG, which has
    /// therefore the same size for a thousand points and for a million.
    #[must_use]
    pub fn cloud(self, name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        self.series(Mark::Cloud, name, points)
    }

    /// Another colour for the last series than that of its place, and a whole line, whichever place that is.
    #[must_use]
    pub fn coloured(mut self, colour: RGBColor) -> Self {
        if let Some(last) = self.series.last_mut() {
            (last.colour, last.dashed) = (colour, false);
        }
        self
    }

    /// Dashes for the last series, if it is a line.
    #[must_use]
    pub fn dashed(mut self) -> Self {
        if let Some(last) = self.series.last_mut() {
            last.dashed = true;
        }
        self
    }

    fn named(&self) -> impl Iterator<Item = &Series> {
        self.series.iter().filter(|series| !series.name.is_empty())
    }

    /// Whether names are needed: one series is what the title says.
    fn has_legend(&self) -> bool {
        self.named().nth(1).is_some()
    }

    /// Draws between the axes, and these.
    fn plot<B: DrawingBackend>(&self, area: &Area<B>, margins: Margins, stroke: u32) -> Outcome
    where
        B::ErrorType: 'static,
    {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let scales = [self.axes[0].fit(points().map(|point| point.0)), self.axes[1].fit(points().map(|point| point.1))];
        let mut frame = Frame::new(area, margins, scales)?;
        if self.equal_units {
            frame = frame.with_equal_units(margins)?;
        }
        let clouds = self.series.iter().filter(|series| series.mark == Mark::Cloud);
        let clouds: Vec<_> = clouds.map(|series| (&series.points[..], series.colour)).collect();
        if clouds.is_empty() {
            frame.grid()?;
        } else {
            frame.clouds(&clouds)?;
        }
        for series in &self.series {
            series.draw(&frame, stroke)?;
        }
        frame.axes([&self.axes[0].name, &self.axes[1].name])
    }

    /// How wide the legend is.
    fn legend_width<B: DrawingBackend>(&self, area: &Area<B>) -> Result<i32, Box<dyn Error>>
    where
        B::ErrorType: 'static,
    {
        let mut widest = 0;
        for series in self.named().filter(|_| self.has_legend()) {
            widest = widest.max(width(area, &series.name, &font(15))? + 64);
        }
        Ok(widest)
    }

    fn legend<B: DrawingBackend>(&self, area: &Area<B>, [x, mut y]: [i32; 2]) -> Outcome
    where
        B::ErrorType: 'static,
    {
        for series in self.named().filter(|_| self.has_legend()) {
            let (middle, ends) = (y + 6, [(x, y + 6), (x + 30, y + 6)]);
            let (line, filled) = (series.colour.stroke_width(3), series.colour.filled());
            match series.mark {
                Mark::Line => self::line(area, ends, line, series.dashed)?,
                Mark::Dotted => {
                    self::line(area, ends, line, series.dashed)?;
                    area.draw(&Circle::new((x + 15, middle), 5, filled))?;
                }
                Mark::Dots => area.draw(&Circle::new((x + 15, middle), 5, filled))?,
                Mark::Cloud | Mark::Filled => {
                    area.draw(&Rectangle::new([(x + 8, middle - 7), (x + 22, middle + 7)], filled))?;
                }
            }
            area.draw_text(&series.name, &font(15), (x + 40, y))?;
            y += 25;
        }
        Ok(())
    }

    /// Draws the chart as one of several: a smaller head, and no legend.
    pub(crate) fn draw_panel<B: DrawingBackend>(&self, area: &Area<B>) -> Outcome
    where
        B::ErrorType: 'static,
    {
        let room = area.dim_in_pixel().0 as i32 - 20;
        let mut below = paragraph(area, &self.title, &bold(16), [12, 8], [room, 20])?;
        below = paragraph(area, &self.claim, &font(13), [12, below], [room, 17])?;
        below = paragraph(area, &self.measured, &bold(13), [12, below], [room, 17])?;
        self.plot(area, Margins { top: below + 6, right: 2, text: 13 }, 2)
    }
}

/// A line of the legend.
fn line<B: DrawingBackend>(area: &Area<B>, ends: [(i32, i32); 2], style: ShapeStyle, dashed: bool) -> Outcome
where
    B::ErrorType: 'static,
{
    if dashed {
        area.draw(&DashedPathElement::new(ends, 7, 5, style))?;
    } else {
        area.draw(&PathElement::new(ends, style))?;
    }
    Ok(())
}

impl Picture for Chart {
    fn size(&self) -> (u32, u32) {
        self.size
    }

    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Outcome
    where
        B::ErrorType: 'static,
    {
        let (across, _) = self.size;
        let mut below = head(area, &self.title, &self.claim)?;
        below = paragraph(area, &self.measured, &bold(16), [24, below], [across as i32 - 48, 21])?;
        let legend = self.legend_width(area)?;
        self.plot(area, Margins { top: below + 12, right: legend + 8, text: 16 }, 2)?;
        self.legend(area, [across as i32 - legend, below + 16])
    }
}

#[cfg(test)]
mod tests {
    use super::Chart;
    use crate::{Axis, write};
    use std::{env, fs, path::PathBuf};

    /// The SVG and the size of the PNG of a chart.
    fn drawn(name: &str, chart: &Chart) -> (String, u64) {
        let file: PathBuf = env::temp_dir().join(format!("integrator-plot-{name}-{}", std::process::id()));
        write(&file, chart).expect("two files");
        let [svg, png] = ["svg", "png"].map(|extension| file.with_extension(extension));
        let drawn = (fs::read_to_string(&svg).expect("text"), fs::metadata(&png).expect("a picture").len());
        for file in [svg, png] {
            fs::remove_file(file).expect("a file");
        }
        drawn
    }

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
        let (text, png) = drawn("words", &chart);
        for word in
            ["Errors", "They fall", "order 2.00", "step", "error", "first", "second", "third", "\n10⁻⁸\n", "\n4\n"]
        {
            assert!(text.contains(word), "{word} is missing in {text}");
        }
        assert_eq!(text.matches("<circle").count(), 9 + 1, "the dots, and one in the legend");
        assert!(png > 1_000);
    }

    #[test]
    fn a_million_points_are_a_small_picture() {
        let spiral = (0..1_000_000).map(|i| f64::from(i) * 1e-3).map(|t| (t.sin() * t, t.cos() * t));
        let (text, png) = drawn("million", &Chart::new("Spiral").cloud("", spiral).with_equal_units());
        assert!(text.contains("<image"), "points are a bitmap");
        assert!(text.len() < 2_000_000 && png < 2_000_000, "{} and {png} bytes", text.len());
    }

    #[test]
    fn one_named_series_needs_no_legend() {
        let chart = |names: &[&str]| {
            names.iter().fold(Chart::new("Legend"), |chart, name| chart.line(*name, [(0.0, 0.0), (1.0, 1.0)]))
        };
        assert!(!drawn("alone", &chart(&["alone"])).0.contains("alone"));
        assert!(drawn("two", &chart(&["alone", "other"])).0.contains("alone"));
    }
}
