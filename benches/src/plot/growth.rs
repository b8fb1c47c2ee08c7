//! Growth of errors with the number of steps, compared with a random walk.

use integrator_plot::{
    Axis, Canvas, Frame, MARKERS, Margins, Outcome, Picture, Stroke, bold,
    colour::{COLOURS, GREY},
    head, write,
};
use std::path::Path;

/// Errors of one problem against the number of steps.
#[derive(Clone, Debug)]
pub struct Growing {
    /// Name of the problem, with the fitted exponent.
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

impl Growing {
    /// A line of slope one half through the mean of the points.
    fn walk(&self) -> Vec<(f64, f64)> {
        let logarithms = || self.points.iter().map(|(steps, error)| (steps.log10(), error.log10()));
        let count = self.points.len() as f64;
        let (x, y) = logarithms().fold((0.0, 0.0), |(x, y), point| (x + point.0 / count, y + point.1 / count));
        self.points.iter().map(|(steps, _)| (*steps, 10.0_f64.powf(y + (steps.log10() - x) / 2.0))).collect()
    }
}

impl Picture for Growth<'_> {
    fn size(&self) -> (u32, u32) {
        (1000, 700)
    }

    fn draw(&self, canvas: &mut Canvas) {
        let claim = "Grey lines have slope 1/2, that of a random walk; numbers are the measured exponents";
        let below = head(canvas, self.title, claim);
        let points = || self.problems.iter().flat_map(|problem| &problem.points);
        let widest = self.problems.iter().map(|problem| canvas.width(&problem.name, bold(16.0))).fold(0.0, f64::max);
        let [along, up] = ["steps", "root mean square of the relative energy error"].map(Axis::logarithmic);
        let scales = [along.fit(points().map(|point| point.0)), up.fit(points().map(|point| point.1))];
        let room = [0.0, 0.0, f64::from(self.size().0), f64::from(self.size().1)];
        let margins = Margins { top: below + 12.0, right: widest + 8.0, text: 16.0 };
        let mut frame = Frame::new(canvas, room, margins, scales);
        frame.grid();
        let mut names = Vec::new();
        for ((problem, colour), marker) in self.problems.iter().zip(COLOURS.iter().skip(1)).zip(&MARKERS) {
            frame.line(problem.walk(), Stroke::new(GREY, 1.0));
            let points = || problem.points.iter().copied();
            frame.line(points(), Stroke::new(*colour, 3.0));
            frame.markers(points(), *marker, 5.0, *colour);
            names.extend(problem.points.last().map(|last| (*last, &problem.name[..], *colour)));
        }
        frame.names(&names);
        frame.axes(["steps", "root mean square of the relative energy error"]);
    }
}
