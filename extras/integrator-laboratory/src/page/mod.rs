//! A self-contained HTML file with all pictures: what the system is, what holds of it, and a chapter for each subject.

mod figures;
mod tables;

use crate::{claims::Verdict, laboratory::Drawing, numbers::plain, pictures::CHAPTERS, study::Study};
use std::fmt::Write;

/// A picture with the name of its files.
pub(crate) struct Figure {
    pub(crate) name: String,
    pub(crate) drawing: Drawing,
}

const STYLE: &str = include_str!("style.css");

/// The chapter of pictures that no chapter of the course has.
const OWN: (&str, &str, &[&str]) = ("own", "Of this system alone", &[]);

/// What a page is made of.
pub(crate) struct Content<'c> {
    pub(crate) name: &'c str,
    pub(crate) formula: &'c str,
    pub(crate) study: Option<&'c Study>,
    pub(crate) verdicts: &'c [Verdict],
    pub(crate) figures: &'c [Figure],
}

impl Content<'_> {
    /// The claims that a picture shows, with their numbers.
    fn claims_of<'v>(&'v self, picture: &'v str) -> impl Iterator<Item = (usize, &'v Verdict)> {
        self.verdicts.iter().enumerate().filter(move |(_, verdict)| verdict.picture == picture)
    }

    /// The page.
    ///
    /// # Errors
    /// The fonts of pictures cannot be read.
    pub(crate) fn page(&self) -> Result<String, integrator_plot::SaveError> {
        let name = escaped(self.name);
        let is_of_course = |name: &str| CHAPTERS.iter().any(|(.., pictures)| pictures.contains(&name));
        let (mut contents, mut chapters) = (String::new(), String::new());
        for (id, title, pictures) in CHAPTERS.iter().copied().chain([OWN]) {
            let inside = self.figures.iter().filter(|figure| {
                if id == OWN.0 { !is_of_course(&figure.name) } else { pictures.contains(&figure.name.as_str()) }
            });
            let mut drawn = String::new();
            for figure in inside {
                drawn.push_str(&self.figure(figure)?);
            }
            let tables = match (id, self.study) {
                ("series", Some(study)) => tables::extrapolations(self, study),
                _ => String::new(),
            };
            if !(drawn.is_empty() && tables.is_empty()) {
                contents.push_str(&link(id, title));
                let _ = write!(
                    chapters,
                    "<details class=\"chapter\" id=\"{id}\" open>\n<summary><h2>{title}</h2></summary>\n\
                     <div class=\"figures\">\n{drawn}</div>\n{tables}</details>\n"
                );
            }
        }
        let methods = self.study.map(tables::methods).unwrap_or_default();
        if self.study.is_some() {
            contents.push_str(&link("methods", "All methods with their formulas"));
        }
        contents.push_str(&link("claims", "All claims"));
        Ok(format!(
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>Laboratory: {name}</title>\n\
             <style>\n{STYLE}</style>\n</head>\n<body>\n<h1>Laboratory: {name}</h1>\n{head}{summary}\
             <nav>\n<ul>\n{contents}</ul>\n</nav>\n{chapters}{methods}{claims}</body>\n</html>\n",
            head = self.head(),
            summary = self.summary(),
            claims = tables::claims(self),
        ))
    }

    /// The Hamiltonian, the start, the step and the units.
    fn head(&self) -> String {
        let mut head = format!("<p>{}</p>\n", escaped(self.formula));
        let Some(study) = self.study else { return head };
        let half = |numbers: &[f64], symbols: &[String]| {
            let one = |(symbol, number): (&String, &f64)| format!("{symbol} = {}", plain(*number));
            symbols.iter().zip(numbers).take(SHOWN).map(one).collect::<Vec<_>>().join(", ")
        };
        let n = study.freedom;
        let dots = if n > SHOWN { ", …" } else { "" };
        let (q, p) = (half(&study.start[..n], &study.symbols[..n]), half(&study.start[n..], &study.symbols[n..]));
        let equations = match &study.equations[..] {
            [] => String::new(),
            lines => {
                let lines: Vec<_> = lines.iter().map(|line| format!("<li>{}</li>", escaped(line))).collect();
                format!("<dt>equations</dt><dd><ul class=\"equations\">{}</ul></dd>\n", lines.concat())
            }
        };
        let _ = write!(
            head,
            "<dl>\n{equations}<dt>start</dt><dd>{q}{dots}; {p}{dots}</dd>\n\
             <dt>step <i>h</i></dt><dd>{step}: {count} steps in a period of {period}, unless a picture says otherwise</dd>\n\
             <dt>units</dt><dd>energies in <i>K</i> = {unit}, the largest kinetic energy; times in periods; distances in sizes of the orbit</dd>\n</dl>\n",
            step = plain(study.step),
            period = plain(study.period),
            count = plain(study.period / study.step),
            unit = plain(study.unit),
        );
        head
    }

    /// Says how many claims hold, and which do not.
    fn summary(&self) -> String {
        let failing = || self.verdicts.iter().enumerate().filter(|(_, verdict)| !verdict.holds());
        let (all, failed) = (self.verdicts.len(), failing().count());
        if failed == 0 {
            return format!(
                "<section class=\"summary\" id=\"summary\">\n<p><strong>All {all} <a href=\"#claims\">claims</a> hold.</strong></p>\n</section>\n"
            );
        }
        let list: String = failing().map(|(index, verdict)| tables::failure(index, verdict)).collect();
        format!(
            "<section class=\"summary failing\" id=\"summary\">\n<p><strong>{failed} of {all} <a href=\"#claims\">claims</a> fail for this system.</strong></p>\n\
             <ul>\n{list}</ul>\n</section>\n"
        )
    }
}

/// The number of coordinates of the start that are listed.
const SHOWN: usize = 6;

fn link(id: &str, title: &str) -> String {
    format!("<li><a href=\"#{id}\">{title}</a></li>\n")
}

/// Text in which no character means anything to HTML.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
