//! Tests of the laboratory on small runs: claims can fail, pictures have axes, words and curves, and a page is
//! self-contained.

use crate::{
    Drawing, Laboratory, Plan, Verdict, claims::verdicts, errors::exact, page::Content, pictures::PICTURES,
    portrait::portrait, problem::Stepped, study::Study, tangents::defect,
};
use integrator_core::prelude::*;
use integrator_plot::{Canvas, Picture};
use integrator_reference::{AnyReference, RungeKutta4};
use std::{env, fs, path::PathBuf, sync::OnceLock};

/// A pendulum with a zero of its energy and with units of length, mass and energy.
struct Pendulum {
    zero: f64,
    length: f64,
    mass: f64,
    weight: f64,
}

#[hamiltonian(taylor)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0] / self.mass
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.weight * (self.zero - (q[0] / self.length).cos())
    }
}

const PENDULUM: Pendulum = Pendulum { zero: 0.0, length: 1.0, mass: 1.0, weight: 1.0 };

/// A Hamiltonian that reads the time, of two coordinates in a list.
struct Driven {
    shake: f64,
    frequency: f64,
}

const DRIVEN: Driven = Driven { shake: 0.1, frequency: 1.0 };

#[hamiltonian]
impl Driven {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64], t: f64) -> f64 {
        q.iter().map(|q| 0.5 * q * q - self.shake * q.cos() * (self.frequency * t).sin()).sum()
    }
}

fn pendulum() -> Laboratory<'static, Pendulum> {
    let start = Phase::new([2.0], [0.0]);
    Laboratory::new(&PENDULUM, start, 8.35).formula("H = p²/2 − cos q").step(0.1).blob(0.3).plan(Plan::SMALL)
}

fn driven(view: [usize; 2]) -> Laboratory<'static, Driven> {
    let start = Phase::new(vec![1.0, 0.5], vec![0.0, 0.2]);
    Laboratory::new(&DRIVEN, start, 6.5).step(0.1).blob(0.1).view(view).plan(Plan::SMALL)
}

/// The measurements of the pendulum, made once.
fn study() -> Study {
    static STUDY: OnceLock<Study> = OnceLock::new();
    STUDY.get_or_init(|| pendulum().study().expect("measurements")).clone()
}

/// The measurements of the driven oscillators, made once.
fn driven_study() -> Study {
    static STUDY: OnceLock<Study> = OnceLock::new();
    STUDY.get_or_init(|| driven([0, 3]).study().expect("measurements")).clone()
}

fn verdict(name: &str, study: &Study) -> Verdict {
    verdicts(study).into_iter().find(|verdict| verdict.name == name).expect("a claim")
}

/// Each claim, and the method whose measurements it must not be content with.
const WRONG: [(&str, &str, &str); 13] = [
    ("forward_euler_energy_grows", "forward Euler", "Verlet"),
    ("backward_euler_energy_decays", "backward Euler", "forward Euler"),
    ("symplectic_euler_bracket_is_one", "symplectic Euler", "Runge–Kutta 4"),
    ("forward_euler_bracket_is_not_one", "forward Euler", "symplectic Euler"),
    ("forward_euler_bracket_leaves_one", "forward Euler", "Verlet"),
    ("forward_euler_area_is_not_preserved", "forward Euler", "Verlet"),
    ("forward_euler_does_not_come_back", "forward Euler", "Verlet"),
    ("symplectic_euler_does_not_come_back", "symplectic Euler", "Verlet"),
    ("runge_kutta_4_does_not_come_back", "Runge–Kutta 4", "implicit midpoint"),
    ("verlet_order_2", "Verlet", "symplectic Euler"),
    ("rk4_order_4", "Runge–Kutta 4", "Verlet"),
    ("yoshida4_order_4", "Yoshida 4", "Blanes–Moan 6"),
    ("gauss_legendre4_order_4", "Gauss–Legendre 4", "implicit midpoint"),
];

/// Methods that not every Hamiltonian admits have their claims where they are, and these can fail.
#[test]
fn methods_of_some_systems_have_claims_of_their_own() {
    let sound = study();
    let claims = ["chin_4a_order_4", "stoermer4_order_4", "stoermer_cowell4_order_4", "taylor_follows_its_tolerance"];
    for claim in claims {
        assert!(verdict(claim, &sound).holds(), "{claim}");
    }
    let mut wrong = sound.clone();
    for name in ["Chin 4A", "Störmer 4", "Störmer–Cowell 4"] {
        let method = wrong.methods.iter_mut().find(|measured| measured.name() == name).expect("T is quadratic");
        method.slope = sound.method("Verlet").expect("a method").slope;
    }
    let taylor = wrong.adaptive.iter_mut().find(|adaptive| adaptive.row.name == "Taylor").expect("recurrences");
    taylor.errors.iter_mut().for_each(|rung| rung.error = 1e-6);
    for claim in claims {
        assert!(!verdict(claim, &wrong).holds(), "{claim}");
    }
    // Of a system without recurrences nothing is claimed of them.
    let other = driven_study();
    assert!(other.method("Chin 4A").is_some() && other.adaptive.len() + 1 == sound.adaptive.len());
    assert!(!verdicts(&other).iter().any(|verdict| verdict.name.contains("taylor")));
}

#[test]
fn a_claim_fails_for_another_method() {
    claims_fail_for_other_methods(&study());
}

fn claims_fail_for_other_methods(study: &Study) {
    for (claim, method, other) in WRONG.into_iter().filter(|(claim, ..)| study.resolved || !claim.contains("energy")) {
        assert!(verdict(claim, study).holds(), "{claim}");
        let without = Study {
            methods: study.methods.iter().filter(|measured| measured.name() != method).cloned().collect(),
            ..study.clone()
        };
        let mut wrong = without.clone();
        for measured in &mut wrong.methods {
            if measured.name() == other {
                measured.row.name = method;
            }
        }
        let missing = verdict(claim, &without);
        assert!(
            !missing.holds() && missing.measured.is_nan() && missing.word() == "FAILED",
            "{claim} without {method}"
        );
        let wrong = verdict(claim, &wrong);
        assert!(!wrong.holds(), "{claim} holds of {other}: {:e}", wrong.measured);
    }
}

#[test]
fn a_claim_fails_for_a_number_that_is_off() {
    let holds = |name: &str, study: &Study| verdict(name, study).holds();
    let sound = study();
    assert!(
        verdicts(&sound).iter().all(Verdict::holds),
        "{:#?}",
        verdicts(&sound).iter().filter(|verdict| !verdict.holds()).collect::<Vec<_>>()
    );
    let mut study = sound.clone();
    study.shifted.apart = 1e-3;
    study.brackets.iter_mut().flatten().for_each(|row| row.measured[7].1 += 1e-9);
    let extrapolation = study.extrapolation.as_mut().expect("a table");
    extrapolation.corner = 1e-9;
    // The second column gains nothing.
    extrapolation.halved[1][1] = extrapolation.errors[1][1] / 8.0;
    // The last column is worse than the one before.
    extrapolation.halved[3][3] = 1.3 * extrapolation.halved[3][2];
    study.modified[1].excess = Some(-2.0);
    let steps = study.steps.as_mut().expect("steps");
    (steps.exponent, steps.change) = (0.0, 1e-6);
    let dormand = study.adaptive.iter_mut().find(|adaptive| adaptive.row.name == "Dormand–Prince 5").expect("a method");
    dormand.errors.iter_mut().for_each(|rung| rung.error = 1e-6);
    let multistep = study.multistep.as_mut().expect("roots");
    multistep.growth = 1.01;
    multistep.roots[3].exponent = 4.0;
    study.gear.explodes = 1.0;
    study.gear.stays = 0.1;
    study.gear.exponents[5] = 5.0;
    study.gear.angles[5] = 18.8;
    study.gear.parasitic.reverse();
    // Forward Euler, taken for symplectic; it is neither, and it is not symmetric.
    study.methods[0].symplectic = true;
    study.methods[0].symmetric = true;
    for claim in [
        "verlet_equals_shifted_leapfrog",
        "each_column_of_the_extrapolation_gains_two_orders",
        "each_column_of_the_extrapolation_is_more_accurate",
        "the_extrapolation_ends_in_gragg_bulirsch_stoer",
        "forward_euler_bracket_has_a_formula",
        "backward_euler_bracket_is_the_inverse",
        "dormand_prince_5_follows_its_tolerance",
        "adaptive_steps_follow_the_force",
        "adaptive_runge_kutta_energy_changes",
        "a_parasitic_root_grows",
        "principal_roots_follow_the_motion",
        "explicit_steps_explode_on_a_stiff_equation",
        "backward_differences_stay_on_a_stiff_equation",
        "backward_differences_have_their_orders",
        "backward_differences_are_stable_in_sectors",
        "backward_differences_of_order_6_are_stable",
        "backward_differences_of_order_7_are_not",
        "brackets_stay_one_at_every_step",
        "maps_tell_symplectic_methods",
        "symplectic_methods_preserve_areas",
        "symmetric_methods_come_back",
        "forward_euler_energy_stays",
        "verlet_modified_energy_stays",
    ] {
        assert!(!holds(claim, &study), "{claim}");
    }
    // Verlet, taken for a method that loses energy.
    let mut study = sound;
    study.methods.iter_mut().find(|measured| measured.name() == "Verlet").expect("a method").symplectic = false;
    assert!(!holds("verlet_energy_changes", &study));
}

/// A method with a memory is judged by its own steps and not by those of its starter: the defect of the map of Adams,
/// Bashforth and Moulton is not that of Runge and Kutta.
#[test]
fn multistep_methods_are_judged_after_their_starter() {
    let study = study();
    let [abm, rk] = ["Adams–Bashforth–Moulton 4", "Runge–Kutta 4"].map(|name| study.method(name).expect("a method"));
    assert_eq!(abm.bracket(), rk.bracket(), "the first step is that of the starter");
    let apart = abm.defects.iter().zip(&rk.defects).filter(|(a, b)| a.1 > 2.0 * b.1 || b.1 > 2.0 * a.1).count();
    assert!(apart >= 4, "{:?} and {:?}", abm.defects, rk.defects);
}

/// A curve does not pass through fifteen decades where an energy that was too high is too low.
#[test]
fn curves_of_energies_are_broken_where_their_sign_changes() {
    let mut study = study();
    let pieces = |study: &Study| {
        let (_, draw) = PICTURES.iter().find(|(name, _)| *name == "energy_error").expect("a picture");
        let svg = svg(&draw(study).expect("an energy"));
        // Names at the ends have lines of their own, in grey.
        let integrator_plot::Colour(red, green, blue) = study.methods[0].row.colour;
        let colour = format!("#{red:02x}{green:02x}{blue:02x}");
        svg.split("<polyline").filter(|rest| rest.split('>').next().is_some_and(|line| line.contains(&colour))).count()
    };
    let before = pieces(&study);
    let euler = &mut study.methods[0];
    let half = euler.energies.len() / 2;
    euler.energies[half..].iter_mut().for_each(|(_, change)| *change = -*change);
    assert!(pieces(&study) > before);
}

/// Tests that visible energy changes are those of methods that are not symplectic, and how far reversals end from the
/// start.
#[test]
fn portraits_show_what_a_method_does() {
    let study = study();
    for measured in &study.methods {
        let (portrait, name) = (&measured.portrait, measured.name());
        assert_eq!(portrait.change.abs() > crate::portrait::SEEN, !measured.symplectic, "{name}: {}", portrait.change);
        let count = if measured.symplectic { 30 } else { portrait.count.min(30) };
        assert_eq!(measured.reversal.count, count, "{name}");
    }
    let apart = study.method("Runge–Kutta 4").and_then(|measured| measured.reversal.apart).expect("an end");
    assert!(apart > 0.1, "the end is seen to be another point than the start: {apart}");
}

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

fn page(study: &Study, verdicts: &[Verdict]) -> String {
    let content = Content { name: "", formula: "", study: Some(study), verdicts, figures: &[] };
    content.page().expect("fonts")
}

fn svg(drawing: &Drawing) -> String {
    let of = |picture: &dyn Fn(&mut Canvas), size| {
        let mut canvas = Canvas::new(size).expect("fonts");
        picture(&mut canvas);
        canvas.svg()
    };
    match drawing {
        Drawing::Chart(chart) => of(&|canvas| chart.draw(canvas), chart.size()),
        Drawing::Panels(panels) => of(&|canvas| panels.draw(canvas), panels.size()),
    }
}

/// Words of each picture that stand on its axes or in its head, and whether all methods have their colour in it.
const SHOWN: [(&str, [&str; 3], bool); 17] = [
    ("portraits", ["Phase portraits", "symplectic", "gains energy"], true),
    ("energy_error", ["Energy error against time", "10⁻⁵", "Dormand–Prince 5"], true),
    ("energy", ["Energy in the first periods", "periods", "forward Euler"], false),
    ("shifted", ["Both sequences", "Interleaved times", "qₙ₊½ = qₙ₋½ + h T′(pₙ)"], false),
    ("brackets", ["Poisson bracket of one step", "1 + h² T″ V″", "backward Euler divides"], false),
    ("modified", ["Modified Hamiltonians", "with further terms h⁴, h⁶", "Yoshida 4"], false),
    ("areas", ["Areas", " at the end: 1 ", "preserve"], true),
    ("maps", ["Symplectic or not", "step", "implicit midpoint"], true),
    ("tangents", ["Length of a deviation", "{q, p} − 1", "Deviations evolved by"], true),
    ("reversal", ["Reversibility", "distance from the start: ", "Verlet"], false),
    ("limits", ["Energy error against step", "2/ω", "Yoshida 4"], false),
    ("errors", ["Error against step", "Runge–Kutta 4: ", "distance from the reference"], true),
    ("work_precision", ["Work and precision", "force evaluations", "Dormand–Prince 8"], true),
    ("adaptive", ["Adaptive Runge–Kutta", "eccentricity 0.8", "tolerance"], false),
    ("roots", ["Parasitic roots", "a root leaves the circle at hω", "Störmer 4"], false),
    ("gear", ["A stiff equation", "cos t", "backward Euler"], false),
    ("regions", ["Regions of stability", "BDF 6: 17.84°", "Re hλ"], false),
];

#[test]
fn every_picture_has_its_words_and_the_colours_of_methods() {
    let study = study();
    assert_eq!(SHOWN.map(|(name, ..)| name), PICTURES.map(|(name, _)| name));
    for ((name, words, all), (_, draw)) in SHOWN.into_iter().zip(PICTURES) {
        let svg = svg(&draw(&study).expect("a picture"));
        for word in words {
            assert!(svg.contains(word), "{name} lacks {word:?}");
        }
        for measured in study.methods.iter().filter(|_| all) {
            let integrator_plot::Colour(red, green, blue) = measured.row.colour;
            assert!(
                svg.contains(&format!("#{red:02x}{green:02x}{blue:02x}")),
                "{name} has nothing in the colour of {}",
                measured.name()
            );
        }
        // A hundredth of what a line for every step of every method would take.
        assert!(svg.len() < 1_000_000, "{name}: {} bytes", svg.len());
    }
    let adaptive = study.adaptive.iter().map(|adaptive| adaptive.row.colour);
    let colours: Vec<_> = study.methods.iter().map(|measured| measured.row.colour).chain(adaptive).collect();
    assert!((0..colours.len()).all(|i| !colours[..i].contains(&colours[i])), "one colour for each method");
    let verlet = study.method("Verlet").map(|verlet| verlet.row.colour);
    assert_eq!((crate::colour("Verlet"), crate::colour("Störmer")), (verlet, None), "for pictures of one's own");
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

/// Tests that the page of a Hamiltonian that reads the time has no claims about the energy, and all others.
#[test]
fn a_hamiltonian_that_reads_the_time_has_its_page() {
    let study = driven_study();
    assert_eq!((study.autonomous, study.view.clone()), (false, ["q₁".to_owned(), "p₂".to_owned()]));
    let verdicts = verdicts(&study);
    assert!(verdicts.iter().all(|verdict| !verdict.name.contains("energy")) && verdicts.len() > 10);
    for verdict in &verdicts {
        assert!(verdict.holds(), "{}: {:e}", verdict.name, verdict.measured);
    }
    let drawn = |name: &str| PICTURES.iter().any(|(picture, draw)| *picture == name && draw(&study).is_some());
    assert!(drawn("portraits") && drawn("areas") && !drawn("energy") && !drawn("energy_error"));
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

/// Tests that verdicts depend neither on units nor on the zero of the energy or the amplitude, and that wrong methods fail.
#[test]
fn verdicts_hold_in_any_units() {
    let plan = Plan { periods: 6.0, outline: 16, rungs: 5, limits: 2 };
    // A length, a mass and an energy, so that positions, momenta and times have units of their own.
    let units = Pendulum { zero: 100.0, length: 2.0_f64.powi(20), mass: 2.0_f64.powi(-30), weight: 2.0_f64.powi(-6) };
    // Of an angle of 1e-8 the cosine is one, up to its rounding: nothing is said of the energy, and the rest holds.
    for (name, system, angle, unresolved) in [("units", units, 2.0, false), ("small", PENDULUM, 1e-8, true)] {
        let start = Phase::new([angle * system.length], [0.0]);
        let unit = system.length * (system.mass / system.weight).sqrt();
        let period = unit * if unresolved { std::f64::consts::TAU } else { 8.35 };
        let study = Laboratory::new(&system, start, period).plan(plan).study().expect("measurements");
        assert_ne!(study.resolved, unresolved, "{name}");
        for verdict in verdicts(&study) {
            assert!(verdict.holds(), "{name}: {} is {:e}", verdict.name, verdict.measured);
        }
        claims_fail_for_other_methods(&study);
    }
}

/// Tests that errors do not add up because a step divides the period, which is exact here.
#[test]
fn a_period_that_is_exact_is_no_resonance() {
    let (start, plan) = (Phase::new([2.5], [0.5]), Plan::SMALL);
    // The period is 4 K(sin(A/2)) of the amplitude A, by the arithmetic-geometric mean.
    let amplitude = (2.5_f64.cos() - 0.5 * 0.5 * 0.5).acos();
    let (mut a, mut b) = (1.0_f64, (0.5 * amplitude).cos());
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    let laboratory = Laboratory::new(&PENDULUM, start, std::f64::consts::TAU / a);
    let exact = exact(&laboratory.problem).expect("a reference");
    let growth = |method: Box<dyn Stepped<[f64; 1]> + '_>| {
        portrait(&laboratory.problem, &*method, &plan, &exact).expect("an orbit").growth()
    };
    let problem = &laboratory.problem;
    let growths = [growth(problem.by(KahanLi8)), growth(problem.by(BlanesMoan6)), growth(problem.by(GaussLegendre6))];
    // With a whole number of steps they are 1.83, 1.59 and 1.54.
    assert!(growths.iter().all(|growth| *growth < 1.1), "{growths:?}");
}

/// Tests that maps which stretch tangents by large factors are symplectic up to rounding, and that others are not.
#[test]
fn maps_that_stretch_are_symplectic_up_to_rounding() {
    let shaken = Driven { shake: 40.0, frequency: 20.0 };
    let laboratory = Laboratory::new(&shaken, Phase::new(vec![3.0], vec![0.0]), 12.57);
    let problem = &laboratory.problem;
    let exact = exact(problem).expect("a reference");
    let defects = |method: Box<dyn Stepped<Vec<f64>> + '_>| {
        [0.01, 0.1, 0.3, 0.6].map(|h| defect(problem, &*method, &exact, h, 8).expect("a map"))
    };
    for method in [problem.by(Euler), problem.by(Verlet), problem.by(KahanLi8)] {
        let name = method.facts().name;
        let found = defects(method);
        assert!(found.iter().all(|defect| *defect <= 1.0), "{name}: {found:?}");
    }
    let found = defects(problem.by(AnyReference::from(RungeKutta4)));
    assert!(found.iter().all(|defect| *defect > 1.0), "{found:?}");
}

/// Tests that steps resolve a drive which is faster than the motion, and that the page warns of a step that does not.
#[test]
fn steps_follow_a_fast_drive() {
    let shaken = Driven { frequency: 20.0, ..DRIVEN };
    let laboratory = Laboratory::new(&shaken, Phase::new(vec![1.0], vec![0.0]), 12.57);
    assert_eq!(laboratory.problem.cycles(), 40);
    assert!((laboratory.problem.step - 12.57 / 40.0 / 80.618).abs() < 1e-6);
    let mut study = driven_study();
    let warns = |study: &Study| page(study, &[]).contains("half the period of the drive");
    assert!(study.half_drive.is_some_and(|half| (half - 3.2).abs() < 0.1) && !warns(&study), "{:?}", study.half_drive);
    study.half_drive = Some(0.99 * study.step);
    assert!(warns(&study));
}

/// Tests that brackets by formula agree with those of steps under a drive, where the force at the end of a step is another one.
#[test]
fn brackets_of_a_shaken_pendulum_are_those_of_the_formulas() {
    let shaken = Driven { shake: 0.3, frequency: 2.0 };
    let laboratory = Laboratory::new(&shaken, Phase::new(vec![0.5], vec![0.0]), 6.3).step(0.1);
    let rows = crate::brackets::brackets(&laboratory.problem).expect("brackets");
    assert!(
        rows.len() == 2 && rows.iter().all(|row| row.off() < 1e-13),
        "{:?}",
        rows.iter().map(|row| row.off()).collect::<Vec<_>>()
    );
}
