//! A page is self-contained: claims, formulas, and what was added.

use super::{DRIVEN, PENDULUM, driven, pendulum, study};
use crate::{Laboratory, Verdict, page::Content, pictures::PICTURES, study::Study};
use integrator_core::prelude::*;
use std::{env, fs, path::PathBuf};

/// Tests that a change by rounding is called neither a gain nor a loss.
#[test]
fn rounding_is_no_gain() {
    let mut study = study();
    for measured in &mut study.methods {
        measured.energies.iter_mut().for_each(|(_, change)| *change = 7.9e-15);
    }
    let page = page(&study, &[]);
    assert_eq!(page.matches("kept to rounding").count(), study.methods.len());
    assert!(!page.contains("gains ") && !page.contains("loses "));
}

pub(super) fn page(study: &Study, verdicts: &[Verdict]) -> String {
    let content = Content { name: "", formula: "", study: Some(study), verdicts, figures: &[] };
    content.page().expect("fonts")
}

fn folder(name: &str) -> PathBuf {
    env::temp_dir().join(format!("integrator-laboratory-{}-{name}", std::process::id()))
}

#[test]
fn a_page_has_its_claims_its_formulas_and_what_was_added() {
    let folder = folder("page");
    let own = integrator_plot::Chart::new("My own").line("", [(0.0, 0.0), (1.0, 1.0)]);
    let claim = Verdict::new("mine", "Mine is < theirs", [0.0, 1.0], Some(2.0));
    let report =
        pendulum().called("swing").claim(claim).picture("own", own).symbols(["θ", "ω"]).report(&folder).expect("files");
    assert_eq!(report.page, folder.join("swing.html"));
    assert!(!report.holds() && report.to_string().contains("\nclaim_mine=FAILED value=2.000e0\n"), "{report}");
    let page = fs::read_to_string(&report.page).expect("a page");
    for part in [
        "<p>H = p²/2 − cos q</p>",
        "0.1: 83.5 steps",
        "Mine is &lt; theirs",
        ">at most 1<",
        ">2<",
        "<mfrac>",
        "My own",
        "1 of ",
    ] {
        assert!(page.contains(part), "{part} is missing");
    }
    assert_eq!(page.matches("<figure").count(), PICTURES.len() + 1);
    assert!(page.matches("<math").count() > study().methods.len(), "a formula for each method");
    for measured in study().methods {
        assert!(
            page.contains(&format!(
                "<td class=\"method\"><span class=\"chip\" style=\"background:{}",
                if measured.symplectic { "rgb" } else { "repeating" }
            )),
            "{}",
            measured.name()
        );
    }
    // The triangle of the extrapolation, below its head.
    let table = page.split("<table id=\"extrapolation\">").nth(1).and_then(|rest| rest.split("</table>").next());
    let table = table.expect("a table");
    assert_eq!((table.matches("<tr>").count(), table.matches("class=\"number\"").count()), (5, 10), "{table}");
    for name in ["portraits", "own"] {
        for ending in ["svg", "png"] {
            let file = folder.join("swing").join(name).with_extension(ending);
            assert!(fs::metadata(&file).is_ok_and(|file| file.len() > 1_000), "{}", file.display());
        }
    }
    fs::remove_dir_all(&folder).expect("a folder");
}

#[test]
fn a_view_of_a_coordinate_that_there_is_not_is_refused() {
    let refusal = driven([0, 4]).study().expect_err("a refusal").to_string();
    assert_eq!(refusal, "a view of coordinate 4: there are 2 positions, then as many momenta");
}

/// Without anything chosen: the name of the type, and what follows from the start and the period.
#[test]
fn a_laboratory_has_defaults() {
    let laboratory = Laboratory::new(&PENDULUM, Phase::new([3.0], [4.0]), 8.0);
    let problem = &laboratory.problem;
    assert_eq!(
        (laboratory.name.as_str(), problem.step, problem.blob, problem.view),
        ("Pendulum", problem.step_of(80), None, [0, 1])
    );
    let laboratory = Laboratory::new(&DRIVEN, Phase::new(vec![1.0; 3], vec![0.0; 3]), 1.0);
    assert_eq!((laboratory.name.as_str(), laboratory.problem.view), ("Driven", [0, 1]));
}
