//! What every page has to be: well-formed HTML whose links lead somewhere, with letters that are legible on a narrow screen.

use crate::{Written, written};
use std::collections::HashSet;

/// The width of a picture on a screen of 500 pixels, and the least size of letters there.
const NARROW: f64 = 468.0;
const LEAST: f64 = 9.0;

/// Elements of HTML without an end.
const VOID: [&str; 4] = ["meta", "br", "input", "!doctype"];

/// The tags of a page, each without its brackets.
fn tags(page: &str) -> impl Iterator<Item = &str> {
    page.split('<').skip(1).filter_map(|rest| rest.split('>').next())
}

/// The value of an attribute in a tag.
fn attribute<'t>(tag: &'t str, name: &str) -> Option<&'t str> {
    tag.split_once(&format!(" {name}=\""))?.1.split('"').next()
}

/// Everything that is wrong with a page.
fn faults(page: &str) -> Vec<String> {
    let (mut faults, mut open, mut ids) = (Vec::new(), Vec::new(), HashSet::new());
    let mut links = Vec::new();
    let mut width = NARROW;
    for tag in tags(page) {
        let name = tag.trim_end_matches('/').split_whitespace().next().unwrap_or_default();
        if let Some(ended) = name.strip_prefix('/') {
            if open.pop() != Some(ended) {
                faults.push(format!("</{ended}> ends another element"));
            }
        } else if !VOID.contains(&name.to_ascii_lowercase().as_str()) && !tag.ends_with('/') {
            open.push(name);
        }
        if let Some(id) = attribute(tag, "id")
            && !ids.insert(id)
        {
            faults.push(format!("the id {id} is there twice"));
        }
        links.extend(attribute(tag, "href").and_then(|link| link.strip_prefix('#')));
        let number = |name: &str| attribute(tag, name).and_then(|number| number.parse::<f64>().ok());
        if name == "svg" {
            width = number("width").unwrap_or(NARROW);
        }
        if let Some(size) = number("font-size").map(|size| size * (NARROW / width).min(1.0))
            && size < LEAST
        {
            faults.push(format!("letters of {size:.1} pixels"));
        }
    }
    faults.extend(open.iter().map(|name| format!("<{name}> has no end")));
    faults.extend(links.iter().filter(|link| !ids.contains(*link)).map(|link| format!("#{link} leads nowhere")));
    faults
}

#[test]
fn every_page_is_well_formed_and_legible_and_its_links_lead_somewhere() {
    for Written { system, report, page } in written() {
        assert_eq!(faults(page), [""; 0], "{system}");
        assert!(page.contains("<g><title>"), "{system}: lines have their names");
        for claim in &report.claims {
            assert!(page.contains(&format!("<tr id=\"{}\">", claim.name)), "{system}: no row for {}", claim.name);
            // From a claim to its picture, and back.
            let (there, back) = (format!("href=\"#{}\"", claim.picture), format!("href=\"#{}\"", claim.name));
            assert!(page.contains(&there) && page.contains(&back), "{system}: {} is shown in no picture", claim.name);
        }
    }
}

#[test]
fn faults_of_a_page_are_found() {
    let cases = [
        ("<p><b>a</p></b>", "</p> ends another element"),
        ("<p>", "<p> has no end"),
        ("<p id=\"a\"></p><p id=\"a\"></p>", "the id a is there twice"),
        ("<a href=\"#b\"></a>", "#b leads nowhere"),
        ("<svg width=\"936\"><text font-size=\"13\"></text></svg>", "letters of 6.5 pixels"),
    ];
    for (page, fault) in cases {
        assert!(faults(page).iter().any(|found| found == fault), "{page}: {:?}", faults(page));
    }
    assert_eq!(faults("<p id=\"a\">x<br>y<use/></p><a href=\"#a\"></a>"), [""; 0]);
}
