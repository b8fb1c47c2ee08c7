//! Error against CPU time, with a curve for each method.

use crate::precision::{Curve, Kind};
use integrator_plot::{
    Axis, Canvas, Colour, DASHES, Frame, MARKERS, Margins, Marker, Outcome, Picture, Place, Stroke, bold,
    colour::{COLOURS, WHITE},
    font, head, write,
};
use std::path::Path;

/// Draws `<file>.svg` and `<file>.png`.
///
/// # Errors
/// If a file cannot be written.
pub fn work_precision(file: &Path, title: &str, curves: &[Curve], kind: Kind) -> Outcome {
    write(file, &WorkPrecision { title, curves, kind })
}

struct WorkPrecision<'c> {
    title: &'c str,
    curves: &'c [Curve],
    kind: Kind,
}

/// Style of a curve. Curves of other crates are thin and pale, each with its own marker and colour.
struct Look {
    stroke: Stroke,
    marker: Marker,
}

/// Width of the legend on the right, and height of its lines.
const LEGEND: f64 = 350.0;
const LINE: f64 = 25.0;

impl WorkPrecision<'_> {
    /// Returns the styles of the curves. A compensated method has the colour of the same method without compensation.
    fn looks(&self) -> Vec<Look> {
        let plain = |method: &str| method.split(',').next().unwrap_or_default().to_owned();
        let mut methods: Vec<String> = Vec::new();
        let mut others = 0;
        let look = |curve: &Curve| {
            if !curve.ours {
                let place = others;
                others += 1;
                let colour: Colour = COLOURS[place % COLOURS.len()].towards(WHITE, 0.35);
                return Look { stroke: Stroke::new(colour, 1.25), marker: MARKERS[1 + place % (MARKERS.len() - 1)] };
            }
            let method = plain(&curve.method);
            let place = methods.iter().position(|known| *known == method).unwrap_or_else(|| {
                methods.push(method);
                methods.len() - 1
            });
            let stroke = Stroke::new(COLOURS[place % COLOURS.len()], 2.5);
            let dashed = curve.method.contains(',') || (place / COLOURS.len()) % 2 == 1;
            Look { stroke: if dashed { stroke.dashed(DASHES) } else { stroke }, marker: Marker::Disc }
        };
        self.curves.iter().map(look).collect()
    }

    /// Returns the points of a curve; errors below 1e-16 are drawn there.
    fn points(&self, curve: &Curve) -> Vec<(f64, f64)> {
        let points = curve.points.iter().filter(|point| point.error(self.kind) < 1.0);
        points.map(|point| (point.milliseconds, point.error(self.kind).max(1e-16))).collect()
    }

    fn legend(&self, canvas: &mut Canvas, (x, mut y): Place, looks: &[Look]) {
        for (ours, name) in [(true, "this library"), (false, "other crates")] {
            canvas.text(name, (x, y), bold(15.0));
            y += LINE;
            for (curve, look) in self.curves.iter().zip(looks).filter(|(curve, _)| curve.ours == ours) {
                canvas.line([(x, y - 5.0), (x + 30.0, y - 5.0)], look.stroke);
                canvas.marker(look.marker, (x + 15.0, y - 5.0), 4.0, look.stroke.colour);
                canvas.text(&curve.method, (x + 40.0, y), font(15.0));
                y += LINE;
            }
            y += 0.5 * LINE;
        }
    }
}

impl Picture for WorkPrecision<'_> {
    fn size(&self) -> (u32, u32) {
        (1250, 780)
    }

    fn draw(&self, canvas: &mut Canvas) {
        let looks = self.looks();
        let error = match self.kind {
            Kind::Energy => "largest relative energy error",
            Kind::Global => "relative position error at the end",
        };
        let claim = "CPU time of a run against its error; lower left is better";
        let below = head(canvas, self.title, claim);
        let [across, down] = [self.size().0, self.size().1].map(f64::from);
        self.legend(canvas, (across - LEGEND + 8.0, below + 24.0), &looks);

        let all: Vec<(f64, f64)> = self.curves.iter().flat_map(|curve| self.points(curve)).collect();
        let names = ["CPU time in ms", error];
        let [along, up] = names.map(Axis::logarithmic);
        let scales = [along.fit(all.iter().map(|point| point.0)), up.fit(all.iter().map(|point| point.1))];
        let margins = Margins { top: below + 12.0, right: LEGEND, text: 16.0 };
        let mut frame = Frame::new(canvas, [0.0, 0.0, across, down], margins, scales);
        frame.grid();
        // Curves of this library are drawn on top of the others.
        for (curve, look) in self.curves.iter().zip(&looks).rev() {
            let points = self.points(curve);
            frame.line(points.iter().copied(), look.stroke);
            frame.markers(points.iter().copied(), look.marker, 3.5, look.stroke.colour);
        }
        frame.axes(names);
    }
}
