//! One HTML file with all pictures inside.

use crate::{claims::Verdict, study::Study};
use std::fmt::Write;

/// A picture as SVG, with its name.
pub(crate) struct Figure {
    pub(crate) name: &'static str,
    pub(crate) svg: String,
}

const STYLE: &str = "body{font:16px/1.5 sans-serif;color:#282828;max-width:1300px;margin:2em auto;padding:0 1em}\
svg{max-width:100%;height:auto}figure{margin:2em 0}table{border-collapse:collapse}\
td,th{padding:.2em .8em;text-align:left;border-bottom:1px solid #e2e2e2}.FAILED{color:#d55e00;font-weight:bold}";

/// The page: what was measured, which claims hold, all pictures. It needs nothing from elsewhere.
pub(crate) fn page(study: &Study, verdicts: &[Verdict], figures: &[Figure]) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>Laboratory: {}</title>\n<style>{STYLE}</style>\n\
         <h1>Laboratory: {}</h1>\n<p>{}</p>\n<h2>Claims</h2>\n<table>\n<tr><th>claim<th>measured<th>\n",
        escaped(study.system),
        escaped(study.system),
        escaped(study.formula),
    );
    // Writing to a string does not fail.
    for Verdict { says, value, .. } in verdicts {
        let _ = write!(page, "<tr><td>{}<td>{value:.3e}", escaped(says));
    }
    for Figure { name, svg } in figures {
        let drawing = svg.find("<svg").map_or("", |begin| &svg[begin..]);
        let drawing = drawing.replacen("<svg", &format!("<svg role=\"img\" aria-label=\"{name}\""), 1);
        let _ = writeln!(page, "<figure id=\"{name}\">\n{drawing}</figure>");
    }
    page.push_str("</html>\n");
    page
}

/// Text in which no character means anything to HTML.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
