//! How a chart is drawn: alone, as one of several, and inside of a page.

use super::Chart;
use crate::{
    canvas::{Canvas, Place},
    frame::{Frame, Margins, Room},
    picture::{Picture, SaveError, head},
    series::{Mark, Series},
    text::{bold, font},
};

/// The width in pixels from which an embedded chart has letters of full size, and names beside its axes.
const WIDE: u32 = 500;

impl Chart {
    /// Returns the axes and series as SVG of this size, without title, claim and measured result.
    ///
    /// # Errors
    /// The fonts cannot be read.
    pub fn embedded(&self, (width, height): (u32, u32)) -> Result<String, SaveError> {
        let mut canvas = Canvas::new((width, height)).map_err(SaveError::Fonts)?;
        let bare = Self { is_embedded: true, size: (width, height), ..self.clone() };
        let text = if width < WIDE { 13.0 } else { 15.0 };
        let beside = bare.beside(&canvas, text);
        let margins = Margins { top: 8.0, right: beside + 4.0, text };
        bare.plot(&mut canvas, [0.0, 0.0, f64::from(width), f64::from(height)], margins);
        bare.legend(&mut canvas, (f64::from(width) - beside - 2.0, 20.0), text);
        Ok(canvas.svg())
    }

    fn named(&self) -> impl Iterator<Item = &Series> {
        self.series.iter().filter(|series| !(series.name.is_empty() || self.is_embedded && series.optional))
    }

    /// Whether names are needed: one series is what the title says. A narrow chart of a page has no room for them; they are shown for
    /// a series under the pointer.
    fn has_names(&self) -> bool {
        !(self.is_embedded && self.size.0 < WIDE) && self.named().nth(1).is_some()
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
