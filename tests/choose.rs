//! Choosing a composition: what is ranked keeps what it promises, and what cannot be ranked says why.

use integrator_core::{
    GaussLegendre,
    check::{
        CheckError, ChooseError, Goal, LogarithmicSteps, NestedSteps, PacedSteps, Splitting, candidates,
        candidates_with, certify, choose, choose_among,
    },
    prelude::*,
    taylor::Taylor,
};

#[path = "../examples/choose/systems.rs"]
#[expect(dead_code, reason = "the example chooses for more systems")]
mod systems;

use systems::{Kepler, Pendulum, Problem, henon_heiles, kepler, pendulum};

/// A relativistic oscillator whose spring changes with time where `rate` is not zero.
struct Relativistic {
    rate: f64,
}

#[hamiltonian]
impl Relativistic {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        (1.0 + p[0] * p[0]).sqrt()
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        q[0] * q[0] * (1.0 + (self.rate * t).sin() / 2.0)
    }
}

#[test]
fn a_tight_tolerance_on_an_eccentric_orbit_wants_a_high_order() {
    let Problem { system, start, .. } = kepler();
    let ranking = choose(&system, start, 13.0, Goal::Trajectory(1e-9)).expect("a ranking");
    assert!(ranking.best().order >= 8, "{ranking}");
    assert!(ranking.choices().is_sorted_by_key(|choice| choice.evaluations));
    assert!(ranking.choices().iter().all(|choice| choice.error <= 1e-9 && choice.seconds > 0.0), "{ranking}");
    // Verlet's error falls with the square of the step: it would need more than a hundred times the work.
    assert!(ranking.choices().iter().all(|choice| choice.composition != "Verlet"));
    // Thirteen kicks a step; twenty in the processor, and twenty in its inverse, once.
    let processed =
        ranking.choices().iter().find(|choice| choice.composition == "BlanesCasasMurua8").expect("a choice");
    assert_eq!(processed.evaluations, 13 * processed.steps + 40);
    let most = ranking.choices().iter().map(|choice| choice.evaluations).max();
    assert!(most <= Some(16 * ranking.best().evaluations), "{ranking}");
}

struct Expanded;

#[hamiltonian(taylor)]
impl Expanded {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

#[test]
fn a_series_is_ranked_by_its_time_where_there_is_one() {
    let (start, span) = (Phase::new([2.0], [0.0]), 16.0);
    for goal in [Goal::Trajectory(1e-10), Goal::Energy(1e-11)] {
        let ranking = choose(&Expanded, start, span, goal).expect("a ranking");
        let place = ranking.choices().iter().position(|choice| choice.composition == "Taylor").expect("a series");
        let (before, rest) = ranking.choices().split_at(place);
        let [series, after @ ..] = rest else { panic!("it is there") };
        assert!(before.iter().all(|choice| choice.seconds <= series.seconds), "{ranking}");
        assert!(after.first().is_none_or(|choice| choice.seconds > series.seconds), "{ranking}");
        // Its tolerance is what a run needs to be this one.
        let tolerance = series.tolerance.expect("a tolerance");
        let mut run = Expanded.run_with(Taylor::tolerance(tolerance), start, span / 4.0).expect("a start");
        run.advance(4).expect("finite states");
        assert_eq!(
            (run.evaluations(), run.own_steps().map(|own| own.taken + 1)),
            (series.evaluations, Some(series.steps))
        );
        assert!(series.error <= goal.tolerance() && series.step == span / series.steps as f64, "{ranking}");
        assert!(ranking.to_string().contains("\nTaylor("), "{ranking}");
        // A looser one by a digit does not reach the goal, or it would have been taken.
        assert!(tolerance < 1e-3 && tolerance > goal.tolerance() * 1e-6, "{ranking}");
    }
    let none = choose(&Pendulum, start, span, Goal::Trajectory(1e-6)).expect("a ranking");
    assert!(none.choices().iter().all(|choice| choice.composition != "Taylor" && choice.tolerance.is_none()), "{none}");
}

/// Ten periods on a circle, of which the position after every time is known.
#[test]
fn the_promised_step_keeps_the_promise() {
    let (start, span, tolerance) = (Phase::new([1.0, 0.0], [0.0, 1.0]), 62.0, 1e-3);
    let ranking = choose(&Kepler, start, span, Goal::Trajectory(tolerance)).expect("a ranking");
    let verlet = ranking.choices().iter().find(|choice| choice.composition == "Verlet").expect("few steps do");
    assert_eq!(verlet.step, span / verlet.steps as f64);
    assert_eq!(verlet.evaluations, verlet.steps);
    let distance = |steps: u64| {
        let mut run = Kepler.run_with(Verlet, start, span / steps as f64).expect("a start");
        // The root of the mean square over the ends of four quarters, in units of the diameters of both circles.
        let squares = (1..=4).map(|quarter| {
            run.advance(steps / 4).expect("finite states");
            let (Phase { q, p }, angle) = (run.state(), span * f64::from(quarter) / 4.0);
            let (sine, cosine) = angle.sin_cos();
            (q[0] - cosine).powi(2) + (q[1] - sine).powi(2) + (p[0] + sine).powi(2) + (p[1] - cosine).powi(2)
        });
        (squares.sum::<f64>() / 4.0).sqrt() / 2.0
    };
    // The reference sees the diameters from the ends of its steps, at least six in a period and never twice at the same
    // places: a hundredth is what these may miss.
    assert!((distance(verlet.steps) / verlet.error - 1.0).abs() < 1e-2, "{} {verlet:?}", distance(verlet.steps));
    // The step is the longest: with a tenth fewer steps, the error is a fifth larger.
    let fewer = verlet.steps / 40 * 36;
    assert!(distance(fewer) > tolerance, "{} in {fewer} steps", distance(fewer));
}

/// The same ellipse with recurrences, whose true motion is a series.
struct WithRecurrences;

#[hamiltonian(taylor)]
impl WithRecurrences {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

#[test]
fn a_true_motion_by_series_ranks_as_one_by_a_run_does() {
    let (start, span, goal) = (Phase::new([1.0, 0.0], [0.0, 1.1]), 20.0, Goal::Trajectory(1e-6));
    let by_series = choose(&WithRecurrences, start, span, goal).expect("a ranking");
    let by_run = choose(&Kepler, start, span, goal).expect("a ranking");
    let composed = by_series.choices().iter().filter(|choice| choice.composition != "Taylor");
    assert_eq!(composed.clone().count(), by_run.choices().len());
    for choice in composed {
        let same =
            by_run.choices().iter().find(|other| other.composition == choice.composition).expect("the same ones");
        // Both see how far the motion goes at other times, which moves errors by a per cent, and a step may follow.
        assert!((choice.error / same.error - 1.0).abs() < 0.1, "{choice:?}, {same:?}");
        assert!((choice.step / same.step - 1.0).abs() < 0.05, "{choice:?}, {same:?}");
    }
}

#[test]
fn only_admissible_compositions_are_ranked() {
    let name = |choice: &integrator_core::check::Choice| choice.composition;
    let start = Phase::new([0.5], [0.2]);
    let general = choose(&Relativistic { rate: 0.0 }, start, 20.0, Goal::Trajectory(1e-5)).expect("a ranking");
    let quadratic = choose(&Pendulum, start, 20.0, Goal::Trajectory(1e-5)).expect("a ranking");
    let nystrom = |names: &[&str]| names.contains(&"BlanesMoanSrkn11") || names.contains(&"Chin4A");
    let general: Vec<_> = general.choices().iter().map(name).collect();
    let quadratic: Vec<_> = quadratic.choices().iter().map(name).collect();
    assert!(!nystrom(&general) && general.contains(&"BlanesMoan6"), "{general:?}");
    assert!(nystrom(&quadratic) && quadratic.contains(&"BlanesMoan6"), "{quadratic:?}");
}

#[test]
fn the_scalar_type_of_the_start_limits_the_accuracy() {
    let (Problem { start, .. }, span) = (pendulum(), 25.0);
    let goal = Goal::Energy(3e-14);
    let compensated = choose(&Pendulum, Phase::compensated(start.q, start.p), span, goal).expect("a ranking");
    assert!(compensated.best().error <= 3e-14);
    let single = Phase::new([2.0_f32], [0.0]);
    let coarse = choose(&Pendulum, single, span, Goal::Energy(1e-4)).expect("a ranking");
    assert!(coarse.best().step > 0.1, "{coarse}");
    let fine = choose(&Pendulum, single, span, Goal::Energy(1e-9));
    // ε of f32 is 1.2e-7; a hundred steps and more round to it.
    assert!(matches!(fine, Err(ChooseError::Unreached { error, .. }) if error > 1e-8 && error < 1e-5), "{fine:?}");
}

#[test]
fn a_clock_hides_no_order_but_the_energy() {
    let (driven, start) = (Relativistic { rate: 1.3 }, Phase::new([0.5], [0.2]));
    assert!(choose(&driven, start, 20.0, Goal::Trajectory(1e-6)).is_ok());
    let energy = choose(&driven, start, 20.0, Goal::Energy(1e-6));
    assert_eq!(energy, Err(ChooseError::Check(CheckError::NotAutonomous)));
}

#[test]
fn impossible_choices_report_the_reason() {
    let Problem { system, start, span } = henon_heiles();
    for span in [0.0, f64::NAN, f64::INFINITY] {
        let refused = choose(&system, start, span, Goal::Energy(1e-3));
        assert!(matches!(refused, Err(ChooseError::Span { .. })), "{refused:?}");
    }
    for tolerance in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
        let refused = choose(&system, start, span, Goal::Energy(tolerance));
        assert!(matches!(refused, Err(ChooseError::Tolerance { .. })), "{refused:?}");
    }
    let nowhere = choose(&system, Phase::new([f64::NAN, 0.0], [0.0; 2]), span, Goal::Energy(1e-3));
    assert!(matches!(nowhere, Err(ChooseError::Check(CheckError::Run(_)))), "{nowhere:?}");
    let beyond = choose(&system, start, span, Goal::Trajectory(1e-17));
    assert!(matches!(beyond, Err(ChooseError::Unfollowed { difference, .. }) if difference < 1e-12), "{beyond:?}");
    // A swing that backward steps follow as well as forward ones.
    let back = choose(&Pendulum, Phase::new([2.0], [0.0]), -20.0, Goal::Trajectory(1e-3)).expect("a ranking");
    assert!(back.best().step < 0.0);
}

/// Two oscillators whose coupling is a thousandth of them, in T + V.
struct Coupled {
    stiffness: f64,
}

#[hamiltonian]
impl Coupled {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        self.stiffness * (q[0] * q[0] + 2.0 * q[1] * q[1]) / 2.0 + 1e-3 * q[0] * q[0] * q[1] * q[1]
    }
}

/// The same, with both oscillators as one part.
struct Solved {
    stiffness: f64,
}

#[hamiltonian(split = quadratic + rest, compose = Aba864)]
impl Solved {
    fn hamiltonian(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        let oscillators = p[0] * p[0] + p[1] * p[1] + self.stiffness * (q[0] * q[0] + 2.0 * q[1] * q[1]);
        oscillators / 2.0 + 1e-3 * q[0] * q[0] * q[1] * q[1]
    }
}

const OSCILLATORS: Phase<[f64; 2]> = Phase { q: [1.0, 0.5], p: [0.0, 0.8] };

#[test]
fn splittings_are_ranked_by_time_in_any_order() {
    let (plain, solved) = (Coupled { stiffness: 1.0 }, Solved { stiffness: 1.0 });
    let orders: [[&dyn Splitting<[f64; 2]>; 2]; 2] = [[&plain, &solved], [&solved, &plain]];
    for (splittings, goal) in orders.into_iter().zip([Goal::Trajectory(1e-7), Goal::Energy(1e-7)]) {
        let ranking = choose_among(&splittings, OSCILLATORS, 25.0, goal).expect("a ranking");
        let (choices, best) = (ranking.choices(), ranking.best());
        assert!(choices.is_sorted_by(|a, b| a.seconds <= b.seconds), "{ranking}");
        assert!(
            choices.iter().all(|choice| choice.seconds <= 16.0 * best.seconds && choice.error <= 1e-7),
            "{ranking}"
        );
        // What a stage costs is another matter in tests, which are compiled without optimisation; stages are fewer.
        let fewest = |system: &str| {
            let of_system = choices.iter().filter(|choice| choice.splitting.system == system);
            of_system.map(|choice| choice.evaluations).min().expect("some of each")
        };
        assert!(4 * fewest("Solved") < fewest("Coupled"), "{ranking}");
        let table = ranking.to_string();
        assert_eq!(table.lines().count(), 1 + choices.len(), "{table}");
        let names = ["Coupled (kinetic + potential) ", "Solved (quadratic + rest) "];
        assert!(names.iter().all(|name| table.lines().any(|line| line.starts_with(name))), "{table}");
    }
    // One of them alone keeps the order by evaluations, and no column for what there is but one of.
    let alone = choose(&solved, OSCILLATORS, 25.0, Goal::Trajectory(1e-7)).expect("a ranking");
    assert!(alone.choices().is_sorted_by_key(|choice| choice.evaluations) && !alone.to_string().contains("quadratic"));
}

/// The steps that are promised do it, held against the other splitting with steps that are short.
#[test]
fn splittings_are_measured_against_one_motion() {
    let (plain, solved) = (Coupled { stiffness: 1.0 }, Solved { stiffness: 1.0 });
    let (span, tolerance) = (100.0, 1e-6);
    let ranking = choose_among(&[&plain, &solved], OSCILLATORS, span, Goal::Trajectory(tolerance)).expect("a ranking");
    let promised =
        ranking.choices().iter().find(|choice| (choice.splitting.system, choice.composition) == ("Solved", "Aba864"));
    let promised = promised.expect("it reaches this");
    let end = |mut run: Run<[f64; 2]>, steps| {
        run.advance(steps).expect("finite states");
        run.state()
    };
    let found = end(solved.run(OSCILLATORS, promised.step).expect("a start"), promised.steps);
    let exact = end(plain.run_with(SofroniouSpaletta10, OSCILLATORS, span / 4096.0).expect("a start"), 4096);
    let distance = (0..2).map(|i| (found.q[i] - exact.q[i]).hypot(found.p[i] - exact.p[i])).fold(0.0, f64::hypot);
    // Errors are in units of how far the motion goes, which is about 2.5 for positions and for momenta; the mean over four
    // quarters is at least half of what the last of them has.
    assert!(distance <= 5.0 * tolerance && distance > promised.error / 100.0, "{distance:e}, {promised:?}");
}

#[test]
fn a_splitting_of_another_hamiltonian_is_reported_with_its_error() {
    let (plain, stiffer) = (Coupled { stiffness: 1.0 }, Solved { stiffness: 1.01 });
    let goal = Goal::Trajectory(1e-5);
    let ranking = choose_among(&[&plain, &stiffer], OSCILLATORS, 50.0, goal).expect("a ranking");
    assert!(ranking.choices().iter().all(|choice| choice.splitting.system == "Coupled"), "{ranking}");
    let [other] = ranking.unranked() else { panic!("{ranking}") };
    // Half a per cent of the phase of 50 to 70 radians, in units of two amplitudes.
    assert!(other.splitting.system == "Solved" && other.error > 1e-2 && other.error < 1.0, "{other:?}");
    assert!(ranking.to_string().ends_with(&format!("comes closest with {:.1e}", other.error)), "{ranking}");
    let none: [&dyn Splitting<[f64; 2]>; 0] = [];
    assert_eq!(choose_among(&none, OSCILLATORS, 50.0, goal), Err(ChooseError::NoSplitting));
}

/// A body that is attracted by `pull/r`, with a pace of its own.
#[derive(Clone, Copy)]
struct Comet {
    pull: f64,
}

#[hamiltonian(taylor)]
impl Comet {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -self.pull / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
    fn rate(&self, q: [f64; 2]) -> f64 {
        1.0 / (q[0] * q[0] + q[1] * q[1]).sqrt()
    }
}

#[test]
fn steps_in_fictitious_time_are_ranked_with_fixed_ones() {
    let comet = Comet { pull: 1.0 };
    let (start, span, tolerance) = (Phase::new([0.1, 0.0], [0.0, 19_f64.sqrt()]), 13.0, 1e-6);
    let splittings: [&dyn Splitting<_>; 3] = [&comet, &LogarithmicSteps(&comet), &PacedSteps(&comet)];
    let ranking = choose_among(&splittings, start, span, Goal::Trajectory(tolerance)).expect("a ranking");
    let text = ranking.to_string();
    assert!(text.contains("Comet (Paced)"), "{text}");
    assert_eq!(ranking.best().splitting.to_string(), "Comet (Logarithmic)", "{text}");
    // The step is one of the method itself, and so many lead through the span, but for a few.
    let best =
        ranking.choices().iter().find(|choice| choice.composition == "SofroniouSpaletta8").expect("among the best");
    let mut run = comet.run_with(Logarithmic(SofroniouSpaletta8), start, best.step).expect("a start");
    run.advance_to(span).expect("finite states");
    assert!((run.steps() as f64 / best.steps as f64 - 1.0).abs() < 0.1, "{} and {}", run.steps(), best.steps);
    let mut exact = comet.run_with(Taylor::tolerance(1e-14), start, span).expect("a start");
    exact.advance(1).expect("finite states");
    let ([x, y], [u, v]) = (run.state().q, exact.state().q);
    // The root of the mean square over four times is at least half of the last one, in units of the orbit's length of two.
    assert!(f64::hypot(x - u, y - v) < 2.0 * 2.0 * tolerance, "{text}");
}

#[test]
fn a_pace_that_does_not_apply_reports_why_it_was_not_tried() {
    let comet = Comet { pull: -1.0 };
    let start = Phase::new([1.0, 0.0], [0.0, 1.0]);
    let splittings: [&dyn Splitting<_>; 2] = [&comet, &LogarithmicSteps(&comet)];
    let ranking = choose_among(&splittings, start, 5.0, Goal::Energy(1e-6)).expect("a ranking");
    let reason = ranking.unranked()[0].not_tried.expect("a reason");
    assert!(reason.contains("V is not negative"), "{reason}");
    assert!(ranking.to_string().ends_with(&format!("Comet (Logarithmic): not tried, {reason}")));
    assert!(matches!(
        choose_among(&[&LogarithmicSteps(&comet)], start, 5.0, Goal::Energy(1e-6)),
        Err(ChooseError::Unreached { .. })
    ));
}

/// A particle whose mass depends on where it is, in one piece.
struct OnePiece;

#[hamiltonian(split = none)]
impl OnePiece {
    fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
        (p[0] * p[0] / (1.0 + q[0] * q[0]) + q[0] * q[0]) / 2.0
    }
}

/// The same, as two copies that are coupled.
struct Copies;

#[hamiltonian(split = symmetric(omega = 20.0))]
impl Copies {
    fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
        (p[0] * p[0] / (1.0 + q[0] * q[0]) + q[0] * q[0]) / 2.0
    }
}

#[test]
fn implicit_methods_are_ranked_where_h_stays_in_one_piece() {
    let (start, span, goal) = (Phase::new([1.0], [0.0]), 20.0, Goal::Energy(1e-6));
    let ranking = choose(&OnePiece, start, span, goal).expect("a ranking");
    let names: Vec<_> = ranking.choices().iter().map(|choice| choice.composition).collect();
    assert_eq!(
        names,
        ["GaussLegendre<8>", "GaussLegendre<4>", "GaussLegendre6", "GaussLegendre4", "ImplicitMidpoint"],
        "{ranking}"
    );
    // The work is what a run counts.
    let best = ranking.best();
    let mut run = OnePiece.run_with(GaussLegendre::<8>, start, span / best.steps as f64).expect("a start");
    run.advance(best.steps).expect("solved steps");
    assert_eq!(run.evaluations(), best.evaluations);
    // Two copies follow the same motion by compositions.
    let goal = Goal::Trajectory(1e-6);
    let ranking = choose_among(&[&OnePiece, &Copies], start, span, goal).expect("a ranking");
    for (name, order) in
        [("OnePiece (in one piece)", 6), ("Copies (hamiltonian + hamiltonian of the copy + coupling)", 4)]
    {
        let found = ranking.choices().iter().find(|choice| choice.splitting.to_string() == name);
        assert!(found.is_some_and(|choice| choice.order >= order && choice.error <= 1e-6), "{ranking}");
    }
    let refused = choose(&OnePiece, start, span, Goal::Trajectory(1e-20)).expect_err("less than a rounding");
    assert!(matches!(refused, ChooseError::Unfollowed { .. }), "{refused}");
}

#[test]
fn candidates_are_listed_without_a_precision() {
    let listed = candidates(&Pendulum);
    let single = candidates_with::<_, f32>(&Pendulum);
    assert!(
        listed.iter().map(|candidate| candidate.facts().name).eq(single.iter().map(|candidate| candidate.facts().name))
    );
    let verlet = single.iter().find(|candidate| candidate.facts().name == "Verlet").expect("a candidate");
    let start = Phase::new([2.0_f32], [0.0]);
    let mut run = verlet.run(start, 0.1).expect("a start");
    let mut named = Pendulum.run_with(Verlet, start, 0.1).expect("a start");
    run.advance(100).expect("finite states");
    named.advance(100).expect("finite states");
    assert_eq!(run.state(), named.state());
}

/// An oscillator with this angular frequency.
struct Turning {
    rate: f64,
}

#[hamiltonian]
impl Turning {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        self.rate * p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.rate * q[0] * q[0] / 2.0
    }
}

/// In any unit of time, no table has a row of zeros.
#[test]
fn small_and_large_numbers_of_tables_have_an_exponent() {
    let start = Phase::new([1.0], [0.0]);
    for unit in [1e-9, 1e9] {
        let system = Turning { rate: 1.0 / unit };
        let ranking = choose(&system, start, 10.0 * unit, Goal::Trajectory(1e-3)).expect("a ranking").to_string();
        let certificate = certify(&system, Verlet, start.at_time(unit), 0.1 * unit).expect("a certificate").to_string();
        for text in [ranking, certificate] {
            assert!(!text.contains("0.0000") && !text.contains("00000."), "{text}");
        }
    }
}

/// A stiff spring in a soft, anharmonic well.
struct Stiff;

#[hamiltonian(split = well + 4 * (spring + kinetic))]
impl Stiff {
    fn well(&self, q: [f64; 2]) -> f64 {
        (q[0] + q[1]).powi(4) - q[1].cos()
    }
    fn spring(&self, q: [f64; 2]) -> f64 {
        200.0 * (q[0] - q[1]).powi(2)
    }
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
}

#[test]
fn numbers_of_inner_steps_are_ranked_by_time() {
    let (start, span, tolerance) = (Phase::new([0.5, 0.4], [0.0, 0.2]), 4.0, 1e-4);
    let ranking = choose(&Stiff, start, span, Goal::Trajectory(tolerance)).expect("a ranking");
    assert!(ranking.choices().is_sorted_by(|a, b| a.seconds <= b.seconds), "{ranking}");
    let mut numbers: Vec<_> = ranking.choices().iter().filter_map(|choice| choice.splitting.inner_steps).collect();
    numbers.sort();
    numbers.dedup();
    assert!(numbers.len() > 2, "{numbers:?}");
    for choice in ranking.choices().iter().filter(|choice| choice.composition == "Verlet") {
        let steps = choice.splitting.inner_steps.expect("a number of inner steps");
        assert!(ranking.to_string().contains(&format!("Verlet.nested({steps})")), "{ranking}");
        let end = |refined: u64| {
            let steps_of_run = choice.steps * refined;
            let mut run = Stiff.run_with(Verlet.nested(steps), start, span / steps_of_run as f64).expect("a start");
            run.advance(steps_of_run).expect("finite");
            (run.state(), run.evaluations())
        };
        let ((state, evaluations), (exact, _)) = (end(1), end(32));
        assert_eq!(evaluations, choice.evaluations, "{ranking}");
        // Positions and momenta are in units of how far they go, several units of each; the end is one of four times.
        let off: f64 = state.q[0] - exact.q[0];
        assert!(choice.error <= tolerance && off.abs() < 4.0 * tolerance, "{steps}: {off:e}");
    }
    let among = choose_among(&[&Stiff, &NestedSteps { system: &Stiff, steps: 8 }], start, span, Goal::Energy(1e-2));
    let names: Vec<_> = among.expect("a ranking").choices().iter().map(|choice| choice.splitting.to_string()).collect();
    assert!(names.contains(&"Stiff (well + spring + kinetic, 8 inner steps)".to_owned()), "{names:?}");
}
