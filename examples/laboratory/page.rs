//! One HTML file with all pictures inside.

use crate::{claims::Verdict, study::Study};
/// A picture as SVG, with its name.
pub(crate) struct Figure {
    pub(crate) name: &'static str,
    pub(crate) svg: String,
}

const STYLE: &str = "body{font:16px/1.5 sans-serif;color:#282828;max-width:1300px;margin:2em auto;padding:0 1em}\
svg{max-width:100%;height:auto}figure{margin:2em 0;border-top:1px solid #e2e2e2}table{border-collapse:collapse}\
td,th{padding:.2em .8em;text-align:left;border-bottom:1px solid #e2e2e2}.FAILED{color:#d55e00;font-weight:bold}";

/// The page: what was measured, which claims hold, all pictures. It needs nothing from elsewhere.
pub(crate) fn page(study: &Study, verdicts: &[Verdict], figures: &[Figure]) -> String {
    let (system, formula) = (escaped(study.system), escaped(study.formula));
    let rows: String = verdicts.iter().map(row).collect();
    let pictures: String = figures.iter().map(figure).collect();
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Laboratory: {system}</title>\n\
         <style>{STYLE}</style>\n</head>\n<body>\n<h1>Laboratory: {system}</h1>\n<p>{formula}; step {step}</p>\n\
         <h2>Claims</h2>\n<table>\n<tr><th>claim</th><th>measured</th><th></th></tr>\n{rows}</table>\n\
         <h2>Pictures</h2>\n{pictures}</body>\n</html>\n",
        step = study.step,
    )
}

/// A claim with its number.
fn row(verdict: &Verdict) -> String {
    let (says, word) = (escaped(verdict.says), verdict.word());
    format!(
        "<tr id=\"{}\"><td>{says}</td><td>{:.3e}</td><td class=\"{word}\">{word}</td></tr>\n",
        verdict.name, verdict.value
    )
}

/// A picture inside of the page.
fn figure(Figure { name, svg }: &Figure) -> String {
    // What stands before the element is for files of their own.
    let drawing = svg.find("<svg").map_or("", |begin| &svg[begin..]);
    let drawing = drawing.replacen("<svg", &format!("<svg role=\"img\" aria-label=\"{name}\""), 1);
    format!("<figure id=\"{name}\">\n{drawing}</figure>\n")
}

/// Text in which no character means anything to HTML.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
