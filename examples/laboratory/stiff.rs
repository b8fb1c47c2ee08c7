//! A stiff system: a pendulum with a stiff spring beside it, which hardly moves.
//!
//! Explicit methods must follow the fast motion however little there is of it; implicit ones take steps for the slow one.

use integrator_core::{Method, prelude::*};
use integrator_laboratory::{Plan, Report, Verdict, colour, plain, write};
use integrator_plot::{Axis, Chart, Mark, colour::GREY};
use integrator_reference::{BackwardEuler, Bdf, DormandPrince5, GaussLegendre4, ImplicitMidpoint, RungeKutta4};
use std::path::Path;

/// `H = |p|²/2 − cos x + ω²y²/2 + x²y`.
pub(crate) struct Coupled {
    pub(crate) omega: f64,
}

#[hamiltonian]
impl Coupled {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -x.cos() + 0.5 * self.omega.powi(2) * y * y + x * x * y
    }
}

const OMEGA: f64 = 100.0;
/// Time span and longest step.
const SPAN: f64 = 12.0;
const LONGEST: f64 = 0.5;
/// Error from which a method counts as unstable.
const LEFT: f64 = 3.0;

/// Errors of a method: step, error and force evaluations.
struct Ladder {
    name: &'static str,
    implicit: bool,
    rungs: Vec<(f64, f64, f64)>,
}

fn start() -> Phase<[f64; 2]> {
    // The spring starts in equilibrium with the force of the pendulum.
    Phase::new([1.0, -1.0 / OMEGA.powi(2)], [0.0, 0.0])
}

/// Returns the error of `x` at the end of the span, at most [`LEFT`].
fn error<M: Method<Coupled>>(method: M, h: f64, steps: u64, exact: f64) -> Result<(f64, f64), Error> {
    let mut run = Coupled { omega: OMEGA }.run_with(method, start(), h)?;
    if run.advance(steps).is_err() {
        return Ok((LEFT, f64::NAN));
    }
    let off = (run.state().q[0] - exact).abs();
    Ok((if off < LEFT { off } else { LEFT }, run.evaluations() as f64))
}

fn ladder<M: Method<Coupled>>(
    name: &'static str,
    implicit: bool,
    method: M,
    rungs: u32,
    exact: f64,
) -> Result<Ladder, Error> {
    let steps = (0..rungs).map(|rung| (SPAN / LONGEST) as u64 * (1 << rung));
    let rungs = steps.map(|steps| {
        let h = SPAN / steps as f64;
        let (error, evaluations) = error(method, h, steps, exact)?;
        Ok((h, error, evaluations))
    });
    Ok(Ladder { name, implicit, rungs: rungs.collect::<Result<_, Error>>()? })
}

/// Returns the errors of an adaptive method for decreasing tolerances.
fn tolerances<M: Method<Coupled>>(
    name: &'static str,
    implicit: bool,
    method: fn(f64) -> M,
    rungs: u32,
    exact: f64,
) -> Result<Ladder, Error> {
    let rungs = (0..rungs.min(8)).map(|rung| {
        let tolerance = 0.1 / 10.0_f64.powi(rung as i32);
        let (error, evaluations) = error(method(tolerance), SPAN, 1, exact)?;
        Ok((tolerance, error, evaluations))
    });
    Ok(Ladder { name, implicit, rungs: rungs.collect::<Result<_, Error>>()? })
}

/// Measures all methods and writes the page.
pub(crate) fn report(plan: &Plan, folder: &Path) -> Result<Report, Box<dyn std::error::Error>> {
    let rungs = plan.rungs.clamp(6, 11);
    let mut reference = Coupled { omega: OMEGA }.run_with(KahanLi8, start(), SPAN / 12_000.0)?;
    reference.advance(12_000)?;
    let exact = reference.state().q[0];
    let fixed = [
        ladder("Verlet", false, Verlet, rungs, exact)?,
        ladder("Yoshida 4", false, Yoshida4, rungs, exact)?,
        ladder("Runge–Kutta 4", false, RungeKutta4, rungs, exact)?,
        ladder("backward Euler", true, BackwardEuler, rungs, exact)?,
        ladder("implicit midpoint", true, ImplicitMidpoint, rungs, exact)?,
        ladder("Gauss–Legendre 4", true, GaussLegendre4, rungs, exact)?,
    ];
    let adaptive = [
        tolerances("Dormand–Prince 5", false, |tolerance| DormandPrince5 { tolerance }, rungs, exact)?,
        tolerances("backward differences", true, |tolerance| Bdf { tolerance }, rungs, exact)?,
    ];
    let formula =
        format!("H = |p|²/2 − cos x + ω²y²/2 + x²y with ω = {OMEGA}, from x = 1 at rest; followed to t = {SPAN}");
    let pictures = vec![
        ("step".to_owned(), against_step(&fixed).into()),
        ("work".to_owned(), against_work(&fixed, &adaptive).into()),
    ];
    write(folder, "stiff", &formula, claims(&fixed), pictures)
}

/// Returns the claims about steps longer than 2/ω, the limit of explicit methods.
fn claims(fixed: &[Ladder]) -> Vec<Verdict> {
    let long = |name: &str| -> Option<Vec<f64>> {
        let ladder = fixed.iter().find(|ladder| ladder.name == name)?;
        Some(
            ladder
                .rungs
                .iter()
                .filter(|(h, ..)| (2.5..10.0).contains(&(h * OMEGA)))
                .map(|(_, error, _)| *error)
                .collect(),
        )
    };
    let best = |name: &str| long(name)?.into_iter().reduce(f64::min);
    let worst = |name: &str| long(name)?.into_iter().reduce(f64::max);
    let steps = "in steps between 2.5/ω and 10/ω";
    let claims = vec![
        Verdict::new(
            "verlet_leaves",
            format!("Verlet leaves, {steps}: its least error"),
            [1.0, f64::INFINITY],
            best("Verlet"),
        ),
        Verdict::new(
            "runge_kutta_4_leaves",
            format!("Runge–Kutta 4 leaves, {steps}: its least error"),
            [1.0, f64::INFINITY],
            best("Runge–Kutta 4"),
        ),
        Verdict::new(
            "implicit_midpoint_stays",
            format!("The implicit midpoint rule stays, {steps}: its largest error"),
            [0.0, 0.1],
            worst("implicit midpoint"),
        ),
        Verdict::new(
            "gauss_legendre_4_stays",
            format!("So does Gauss–Legendre 4, {steps}: its largest error"),
            [0.0, 0.1],
            worst("Gauss–Legendre 4"),
        ),
    ];
    claims.into_iter().map(|claim| claim.shown_in("step")).collect()
}

/// Adds a curve for each method: solid for implicit methods, dashed for explicit ones.
fn curves<'l>(
    chart: Chart,
    ladders: impl IntoIterator<Item = &'l Ladder>,
    along: fn(&(f64, f64, f64)) -> f64,
) -> Chart {
    ladders.into_iter().fold(chart, |chart, ladder| {
        let chart = chart.series(Mark::Dotted, ladder.name, ladder.rungs.iter().map(|rung| (along(rung), rung.1)));
        let chart = colour(ladder.name).into_iter().fold(chart, Chart::coloured);
        if ladder.implicit { chart } else { chart.dashed() }
    })
}

fn against_step(fixed: &[Ladder]) -> Chart {
    let claim = "Dashed: explicit methods, which are unstable for steps beyond about 2/ω, the grey line, whatever their order. \
                 Solid: implicit methods, whose step is limited by the slow motion only.";
    let chart = Chart::new("A stiff system: error against step")
        .claim(claim)
        .measured(format!("2/ω = {}", plain(2.0 / OMEGA)))
        .along(Axis::logarithmic("step"))
        .up(Axis::logarithmic("error of x at the end").between(1e-12, 2.0 * LEFT))
        .sized(1100, 680);
    let chart = curves(chart, fixed, |rung| rung.0);
    chart.line("", [(2.0 / OMEGA, 1e-12), (2.0 / OMEGA, 2.0 * LEFT)]).coloured(GREY)
}

fn against_work(fixed: &[Ladder], adaptive: &[Ladder]) -> Chart {
    let claim = "Backward differences, designed for stiff systems, need the fewest evaluations for a few digits. The other implicit methods \
                 take steps as long, and each step costs dozens of evaluations.";
    let chart = Chart::new("A stiff system: error against work")
        .claim(claim)
        .along(Axis::logarithmic("force evaluations"))
        .up(Axis::logarithmic("error of x at the end").between(1e-12, 2.0 * LEFT))
        .sized(1100, 680);
    curves(chart, fixed.iter().chain(adaptive), |rung| rung.2)
}
