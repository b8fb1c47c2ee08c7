//! Pictures inside of the page: each chart is an SVG of its own, so that charts move below each other on a narrow screen.

use super::{Content, Figure, escaped};
use crate::laboratory::Drawing;
use integrator_plot::{Chart, Panels, SaveError};
use std::fmt::Write;

/// The size of a chart on the page, so that its letters are legible on a screen of 500 pixels.
const SIZE: (u32, u32) = (560, 400);
/// If there are more panels than `MOST`, these are shown before the others are unfolded.
const FIRST: usize = 4;
const MOST: usize = 6;
/// The width of the page with the gaps between columns, and the least width of a column of the page, in pixels.
const PAGE: u32 = 1168;
const GAP: u32 = 16;
const COLUMN: u32 = 340;
/// The size of the first portraits, two in a row, and their least width.
const LARGE: (u32, u32) = (560, 300);
const HALF: u32 = 440;

impl Content<'_> {
    /// A picture with its caption, its claims, and a switch if it has optional series.
    pub(super) fn figure(&self, Figure { name, drawing }: &Figure) -> Result<String, SaveError> {
        let ([title, claim, measured], inside) = match drawing {
            Drawing::Chart(chart) => (chart.words(), svg(chart, SIZE)?),
            Drawing::Panels(panels) => (panels.words(), panels_of(panels, name == "portraits")?),
        };
        // The page itself is about the system.
        let title = title.split_once(": ").map_or(title, |(title, _)| title);
        // The columns of the page that the picture takes.
        let whole = match drawing {
            Drawing::Chart(_) => "",
            Drawing::Panels(panels) if panels.charts().len() == 2 => " class=\"wide\"",
            Drawing::Panels(_) => " class=\"whole\"",
        };
        let switch = if inside.contains("class=\"more\"") {
            "<label><input type=\"checkbox\"> all methods</label>\n"
        } else {
            ""
        };
        let claims = self.links(name);
        Ok(format!(
            "<figure id=\"{name}\"{whole}>\n<figcaption><h3>{title}</h3>\n{claim}{measured}{claims}{switch}</figcaption>\n{inside}</figure>\n",
            title = escaped(title),
            claim = paragraph(claim, "p"),
            measured = paragraph(measured, "b"),
        ))
    }

    /// Links to the claims that a picture or a table shows.
    pub(super) fn links(&self, picture: &str) -> String {
        let claims: Vec<String> = self
            .claims_of(picture)
            .map(|(index, verdict)| {
                let word = if verdict.holds() { "" } else { " class=\"FAILED\"" };
                format!("<a{word} href=\"#{}\">{}</a>", verdict.name, index + 1)
            })
            .collect();
        match claims.len() {
            0 => String::new(),
            1 => format!("<p>Claim {}</p>\n", claims[0]),
            _ => format!("<p>Claims {}</p>\n", claims.join(", ")),
        }
    }
}

/// The panels in columns; of many, the first ones, and the others behind a fold.
fn panels_of(panels: &Panels, large: bool) -> Result<String, SaveError> {
    let (charts, (width, height), columns) = (panels.charts(), panels.chart_size(), panels.column_count() as u32);
    let size = (width.min(SIZE.0), height.min(SIZE.1));
    let least = (PAGE / columns - GAP).min(COLUMN);
    let grid = |charts: &[Chart], size: (u32, u32), least: u32| -> Result<String, SaveError> {
        let mut grid = format!("<div class=\"panels\" style=\"--least:{least}px\">\n");
        for chart in charts {
            let [title, claim, measured] = chart.words();
            let (claim, measured) = (paragraph(claim, "p"), paragraph(measured, "b"));
            let _ = writeln!(grid, "<div><h4>{}</h4>\n{claim}{measured}{}</div>", escaped(title), svg(chart, size)?);
        }
        Ok(grid + "</div>\n")
    };
    if charts.len() <= MOST {
        return grid(charts, size, least);
    }
    let (first, rest) = charts.split_at(FIRST);
    let (wide, half) = if large { (LARGE, HALF) } else { (size, least) };
    let (first, count, rest) = (grid(first, wide, half)?, rest.len(), grid(rest, size, least)?);
    Ok(format!("{first}<details><summary>{count} more</summary>\n{rest}</details>\n"))
}

/// A chart as an element of the page.
fn svg(chart: &Chart, size: (u32, u32)) -> Result<String, SaveError> {
    let label = format!("<svg role=\"img\" aria-label=\"{}\"", escaped(chart.words()[0]));
    Ok(chart.embedded(size)?.replacen("<svg", &label, 1))
}

/// A paragraph, if there is text.
fn paragraph(text: &str, element: &str) -> String {
    match (text, element) {
        ("", _) => String::new(),
        (text, "p") => format!("<p>{}</p>\n", escaped(text)),
        (text, element) => format!("<p><{element}>{}</{element}></p>\n", escaped(text)),
    }
}
