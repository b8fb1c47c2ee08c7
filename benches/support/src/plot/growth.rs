//! Errors that grow with the number of steps, beside a random walk.

use super::{COLOURS, FONT, INK, Outcome, PALE, Picture, head, power, write};
use plotters::{coord::Shift, prelude::*, style::FontStyle};
use std::path::Path;

/// A problem, the exponent of its growth, and its errors after so many steps.
#[derive(Clone, Debug)]
pub struct Growing {
    /// What it is about, with whatever was fitted.
    pub name: String,
    /// Steps and errors, both positive.
    pub points: Vec<(f64, f64)>,
}

/// Draws `<file>.svg` and `<file>.png`. A grey line through the middle of each problem has the slope of a random walk.
///
/// # Errors
/// If a file cannot be written.
pub fn growth(file: &Path, title: &str, problems: &[Growing]) -> Outcome {
    write(file, &Growth { title, problems })
}

struct Growth<'p> {
    title: &'p str,
    problems: &'p [Growing],
}

/// Decades on the right for the names.
const ROOM: f64 = 0.9;

impl Growing {
    fn logarithms(&self) -> Vec<(f64, f64)> {
        self.points.iter().map(|(steps, error)| (steps.log10(), error.log10())).collect()
    }

    /// A line of slope one half with the mean of the points.
    fn walk(&self) -> Vec<(f64, f64)> {
        let points = self.logarithms();
        let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / points.len() as f64;
        let (x, y) = (mean(|point| point.0), mean(|point| point.1));
        points.iter().map(|point| (point.0, y + (point.0 - x) / 2.0)).collect()
    }
}

impl Picture for Growth<'_> {
    fn size(&self) -> (u32, u32) {
        (1000, 700)
    }

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Outcome
    where
        B::ErrorType: 'static,
    {
        head(area, self.title, "Grey: a random walk, which grows like the root of the number of steps")?;
        let all: Vec<(f64, f64)> = self.problems.iter().flat_map(Growing::logarithms).collect();
        let range = |of: fn(&(f64, f64)) -> f64, room: f64| {
            let least = all.iter().map(of).fold(f64::INFINITY, f64::min);
            let most = all.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
            least - 0.2..most + room
        };
        let (steps, errors) = (range(|point| point.0, ROOM), range(|point| point.1, 0.2));
        // At most a label for every power of ten, so that there are none between them.
        let [decades, decades_of_error] = [&steps, &errors].map(|range| (range.end - range.start) as usize + 1);
        let mut chart = ChartBuilder::on(area)
            .margin_top(84)
            .margin_right(24)
            .margin_left(12)
            .margin_bottom(10)
            .x_label_area_size(56)
            .y_label_area_size(84)
            .build_cartesian_2d(steps, errors)?;
        chart
            .configure_mesh()
            .x_labels(decades)
            .y_labels(decades_of_error)
            .x_label_formatter(&|x| power(*x))
            .y_label_formatter(&|y| power(*y))
            .x_desc("steps")
            .y_desc("root mean square of the energy error")
            .axis_desc_style((FONT, 17).into_font().color(&INK))
            .label_style((FONT, 16).into_font().color(&INK))
            .bold_line_style(PALE)
            .light_line_style(WHITE)
            .axis_style(INK)
            .draw()?;
        for (problem, colour) in self.problems.iter().zip(COLOURS.iter().skip(1)) {
            chart.draw_series(LineSeries::new(problem.walk(), RGBColor(150, 150, 150).stroke_width(1)))?;
            let points = problem.logarithms();
            chart.draw_series(LineSeries::new(points.iter().copied(), colour.stroke_width(3)))?;
            chart.draw_series(points.iter().map(|point| Circle::new(*point, 4, colour.filled())))?;
            if let Some(last) = points.last() {
                let font = (FONT, 16, FontStyle::Bold).into_font().color(colour);
                chart.draw_series([EmptyElement::at(*last) + Text::new(problem.name.clone(), (12, -8), font)])?;
            }
        }
        Ok(())
    }
}
