//! Error against CPU time, a curve for each method.

use crate::precision::{Curve, Kind};
use integrator_plot::{
    Area, Axis, Frame, Margins, Outcome, Picture, bold,
    colour::{COLOURS, GREY},
    font, head,
    plotters::{element::DashedPathElement, prelude::*},
    write,
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

/// How a curve is drawn: those of other crates are grey and carry a letter.
struct Look {
    colour: RGBColor,
    dashed: bool,
    letter: Option<char>,
}

/// The room for the legend on the right, and a line of it.
const LEGEND: u32 = 350;
const LINE: i32 = 25;

impl WorkPrecision<'_> {
    /// Curves in the order of the legend: ours first. One that carries rounding errors along has the colour of the same
    /// method without.
    fn looks(&self) -> Vec<Look> {
        let plain = |method: &str| method.split(',').next().unwrap_or_default().to_owned();
        let mut methods: Vec<String> = Vec::new();
        let mut letters = 'a'..;
        let look = |curve: &Curve| {
            if !curve.ours {
                return Look { colour: GREY, dashed: false, letter: letters.next() };
            }
            let method = plain(&curve.method);
            let place = methods.iter().position(|known| *known == method).unwrap_or_else(|| {
                methods.push(method);
                methods.len() - 1
            });
            Look { colour: COLOURS[place % COLOURS.len()], dashed: curve.method.contains(','), letter: None }
        };
        self.curves.iter().map(look).collect()
    }

    /// The points of a curve, none of them below what doubles hold.
    fn points(&self, curve: &Curve) -> Vec<(f64, f64)> {
        let points = curve.points.iter().filter(|point| point.error(self.kind) < 1.0);
        points.map(|point| (point.milliseconds, point.error(self.kind).max(1e-16))).collect()
    }

    fn legend<B: DrawingBackend>(&self, area: &Area<B>, looks: &[Look]) -> Outcome
    where
        B::ErrorType: 'static,
    {
        let (bold, font) = (bold(15), font(15));
        let mut y = 90;
        for (ours, name) in [(true, "this library"), (false, "other crates")] {
            area.draw_text(name, &bold, (8, y))?;
            y += LINE;
            for (curve, look) in self.curves.iter().zip(looks).filter(|(curve, _)| curve.ours == ours) {
                match look.letter {
                    Some(letter) => area.draw_text(&letter.to_string(), &font, (20, y))?,
                    None => draw_line(area, [(8, y + 9), (38, y + 9)], look)?,
                }
                area.draw_text(&curve.method, &font, (48, y))?;
                y += LINE;
            }
            y += LINE / 2;
        }
        Ok(())
    }
}

/// A line in the legend.
fn draw_line<B: DrawingBackend>(area: &Area<B>, ends: [(i32, i32); 2], look: &Look) -> Outcome
where
    B::ErrorType: 'static,
{
    let style = look.colour.stroke_width(3);
    if look.dashed {
        area.draw(&DashedPathElement::new(ends, 6, 4, style))?;
    } else {
        area.draw(&PathElement::new(ends, style))?;
    }
    Ok(())
}

impl Picture for WorkPrecision<'_> {
    fn size(&self) -> (u32, u32) {
        (1250, 780)
    }

    fn draw<B: DrawingBackend>(&self, area: &Area<B>) -> Outcome
    where
        B::ErrorType: 'static,
    {
        let looks = self.looks();
        let error = match self.kind {
            Kind::Energy => "largest relative error of the energy",
            Kind::Global => "relative error of the positions at the end",
        };
        let claim = "CPU time of a run against its error: further down and to the left is better";
        let below = head(area, self.title, claim)?;
        let (left, right) = area.split_horizontally(self.size().0 - LEGEND);
        self.legend(&right, &looks)?;

        let all: Vec<(f64, f64)> = self.curves.iter().flat_map(|curve| self.points(curve)).collect();
        let names = ["CPU time, ms", error];
        let [along, up] = names.map(Axis::logarithmic);
        let scales = [along.fit(all.iter().map(|point| point.0)), up.fit(all.iter().map(|point| point.1))];
        let frame = Frame::new(&left, Margins { top: below + 12, right: 0, text: 16 }, scales)?;
        frame.grid()?;
        // Ours on top of the others.
        for (curve, look) in self.curves.iter().zip(&looks).rev() {
            let points = self.points(curve);
            let width = if look.letter.is_some() { 2 } else { 3 };
            frame.line(points.iter().copied(), look.colour.stroke_width(width), look.dashed)?;
            if look.letter.is_none() {
                frame.dots(points.iter().copied(), 3, look.colour.filled())?;
            }
            if let Some((letter, end)) = look.letter.zip(points.last()) {
                frame.text(*end, (5, -8), &letter.to_string(), &bold(16))?;
            }
        }
        frame.axes(names)
    }
}
