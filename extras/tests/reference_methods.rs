//! Methods that are no compositions: they are what they claim to be, run like compositions, and none that is not
//! symplectic is certified.

use integrator_core::{
    Divergence, Method, Unsolved,
    check::{
        CertifyError, CheckError, Shortfall, certify, observed_order, poisson_bracket, reversibility,
        symplectic_defect, tangent_maps,
    },
    prelude::*,
};
use integrator_reference::{
    AdamsBashforth4, AdamsBashforthMoulton4, AnyReference, BackwardEuler, Bdf, DormandPrince5, DormandPrince8,
    ExplicitMidpoint, ForwardEuler, GraggBulirschStoer, ImplicitMidpoint, RungeKutta4, StaggeredLeapfrog, Stoermer4,
    StoermerCowell4,
};

struct Pendulum;

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

/// Two degrees of freedom that are coupled, and a T that is not quadratic.
struct Fast {
    coupling: f64,
}

#[hamiltonian]
impl Fast {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (1.0 + px * px + py * py).sqrt()
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (x * x + y * y) + self.coupling * (x * x * y - y.powi(3) / 3.0)
    }
}

struct Driven;

#[hamiltonian]
impl Driven {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        -q[0].cos() * (1.0 + 0.5 * t.sin())
    }
}

struct Oscillator {
    mass: f64,
}

#[hamiltonian]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / (2.0 * self.mass)
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0] * q[0]
    }
}

/// A particle in a well whose wall is a million times as steep as its floor.
struct Stiff;

#[hamiltonian]
impl Stiff {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * x * x + 5e5 * y * y
    }
}

const SWING: Phase<[f64; 1]> = Phase { q: [2.0], p: [0.3] };
const TURN: Phase<[f64; 2]> = Phase { q: [0.3, -0.2], p: [0.1, 0.4] };

/// Calls back with every method of a fixed step, and whether it is symplectic: a row for each.
macro_rules! with_fixed_steps {
    ($callback:ident) => {
        $callback! {
            ForwardEuler false;
            BackwardEuler false;
            StaggeredLeapfrog true;
            ExplicitMidpoint false;
            ImplicitMidpoint true;
            RungeKutta4 false;
            AdamsBashforthMoulton4 false;
            GraggBulirschStoer false;
        }
    };
}

/// What a method is refused for.
fn shortfalls<H: Hamiltonian, X: Method<H>>(system: &H, method: X, start: &Phase<H::Coords>, h: f64) -> Vec<Shortfall> {
    match certify::<H, X, f64>(system, method, start.clone(), h) {
        Ok(_) => Vec::new(),
        Err(CertifyError::Refused { shortfalls, .. }) => shortfalls,
        Err(error) => panic!("{}: {error}", method.facts().name),
    }
}

fn judged<H: Hamiltonian, X: Method<H>>(system: &H, method: X, start: &Phase<H::Coords>, h: f64, symplectic: bool) {
    let found = shortfalls(system, method, start, h);
    let name = method.facts().name;
    if symplectic {
        assert!(found.is_empty(), "{name}: {found:?}");
    } else {
        let measured = |shortfall: &Shortfall| matches!(shortfall, Shortfall::Symplecticity { .. });
        assert!(found.iter().any(measured), "{name} passes for symplectic: {found:?}");
        assert!(found.contains(&Shortfall::NotSymplectic { method: name }), "{found:?}");
    }
}

fn defective<H: Hamiltonian, X: Method<H>>(system: &H, method: X, start: &Phase<H::Coords>, symplectic: bool) {
    let defect = symplectic_defect::<H, X, f64>(system, method, start.clone(), 0.5).expect("a defect");
    // Hundreds of roundings come to 1e-13.
    assert_eq!(defect < 1e-12, symplectic, "{}: {defect}", method.facts().name);
}

/// A test for each, so that they run side by side.
mod only_the_symplectic_ones_are_certified {
    use super::{Driven, Fast, Pendulum, SWING, TURN, defective, judged};

    macro_rules! judge {
        ($($method:ident $symplectic:literal;)*) => {$(
            #[test]
            #[allow(non_snake_case, reason = "named as the method is")]
            fn $method() {
                judged(&Pendulum, super::$method, &SWING, 0.2, $symplectic);
                defective(&Fast { coupling: 1.0 }, super::$method, &TURN, $symplectic);
                defective(&Driven, super::$method, &SWING, $symplectic);
            }
        )*};
    }
    with_fixed_steps!(judge);
}

#[test]
fn a_defect_below_the_rounding_and_an_adaptive_method_are_not_certified() {
    // Where the rounding hides the defect, a certificate is refused all the same.
    let accurate = shortfalls(&Pendulum, GraggBulirschStoer, &SWING, 0.01);
    assert_eq!(accurate[0], Shortfall::NotSymplectic { method: "GraggBulirschStoer" }, "{accurate:?}");
    // Adaptive ones begin anew in each of the thousands of steps of a certificate.
    let tolerance = 1e-6;
    defective(&Pendulum, DormandPrince5 { tolerance }, &SWING, false);
    defective(&Pendulum, DormandPrince8 { tolerance }, &SWING, false);
    defective(&Pendulum, Bdf { tolerance }, &SWING, false);
}

fn order<H: Hamiltonian, X: Method<H>>(system: &H, method: X, start: &Phase<H::Coords>, h: f64) {
    let order = observed_order::<H, X, f64>(system, method, start.clone(), h);
    let facts = method.facts();
    let order = order.unwrap_or_else(|error| panic!("{}: {error}", facts.name));
    let off = (order.slope - f64::from(facts.order)).abs();
    // Four to eight points of a slope whose next term is of one order (or two) more.
    assert!(off <= 0.3, "{}: {} of {order:?}", facts.name, facts.order);
}

/// Over the longest time that four steps follow, the exponents of multistep methods are those of no order: 3.81, 4.55 and 4.34 here.
#[test]
fn exponents_of_a_fast_drive_are_whole_numbers() {
    let observed = [
        observed_order(&Shaken, Stoermer4, Phase::new([0.5], [0.0]), 0.02),
        observed_order(&Shaken, StoermerCowell4, Phase::new([0.5], [0.0]), 0.02),
        observed_order(&Shaken, StoermerCowell4, Phase::new([2.0], [0.0]), 0.02),
    ];
    for order in observed.map(|order| order.expect("an order")) {
        assert!((order.slope - 4.0).abs() < 0.1, "{order:?}");
        assert!(order.span < order.followed, "the longest time will do: {order:?}");
    }
}

/// A pendulum whose support is shaken twelve times as fast as it swings.
struct Shaken;

#[hamiltonian]
impl Shaken {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        -(1.0 + 0.3 * (12.0 * t).cos()) * q[0].cos()
    }
}

#[test]
fn errors_fall_with_the_order_that_is_claimed() {
    macro_rules! orders {
        ($($method:ident $symplectic:literal;)*) => {$(
            order(&Pendulum, $method, &SWING, 0.1);
            order(&Fast { coupling: 1.0 }, $method, &TURN, 0.1);
            order(&Driven, $method, &SWING, 0.1);
        )*};
    }
    with_fixed_steps!(orders);
}

/// Those for `q'' = a(q)` take any constant mass, and a force that reads the time.
#[test]
fn second_order_equations_have_methods_of_their_own() {
    macro_rules! check {
        ($($method:ident $forces:literal $gains:literal;)*) => {$({
            order(&Pendulum, $method, &SWING, 0.05);
            order(&Driven, $method, &SWING, 0.05);
            order(&Oscillator { mass: 0.3 }, $method, &SWING, 0.02);
            judged(&Pendulum, $method, &SWING, 0.2, false);
            defective(&Driven, $method, &SWING, false);
            let mut run = Oscillator { mass: 1.0 }.run_with($method, SWING, 0.7).expect("a start");
            let energy = run.energy();
            run.advance(200).expect("finite states");
            assert_eq!(run.evaluations(), 200 * $forces, "{}", stringify!($method));
            // In long steps the one loses energy and the other one gains it.
            let change = run.energy() / energy;
            assert!(if $gains { change > 1.05 } else { change < 0.5 }, "{}: {change}", stringify!($method));
        })*};
    }
    check! {
        Stoermer4 1 false;
        StoermerCowell4 2 true;
    }
}

#[test]
fn areas_change_by_the_factors_of_the_step_matrix() {
    // With h·ω = h for a mass of one: det (1 h; -h 1), its inverse at -h, and the polynomial of the classical method.
    let (h, start) = (0.25, Phase::new([1.0], [0.5]));
    let square = h * h;
    let oscillator = Oscillator { mass: 1.0 };
    let bracket = |found: Result<f64, CheckError>| found.expect("a bracket");
    let rows = [
        ("forward", bracket(poisson_bracket(&oscillator, ForwardEuler, start, h, 0)), 1.0 + square),
        ("backward", bracket(poisson_bracket(&oscillator, BackwardEuler, start, h, 0)), 1.0 / (1.0 + square)),
        ("midpoint", bracket(poisson_bracket(&oscillator, ExplicitMidpoint, start, h, 0)), 1.0 + square * square / 4.0),
        (
            "classical",
            bracket(poisson_bracket(&oscillator, RungeKutta4, start, h, 0)),
            1.0 - square.powi(3) / 72.0 + square.powi(4) / 576.0,
        ),
        ("implicit", bracket(poisson_bracket(&oscillator, ImplicitMidpoint, start, h, 0)), 1.0),
        ("leapfrog", bracket(poisson_bracket(&oscillator, StaggeredLeapfrog, start, h, 0)), 1.0),
        ("composition", bracket(poisson_bracket(&oscillator, Yoshida4, start, h, 0)), 1.0),
    ];
    for (name, found, exact) in rows {
        // Some ten roundings of numbers up to one.
        assert!((found - exact).abs() < 20.0 * f64::EPSILON, "{name}: {found} instead of {exact}");
    }
    let refused = poisson_bracket(&oscillator, ForwardEuler, start, h, 1);
    assert_eq!(refused, Err(CheckError::NoCoordinate { index: 1, coordinates: 1 }));
}

/// On an oscillator the map of many steps is a power of that of one, which turns by an angle and stretches by a factor; a method
/// with a memory has that of its starter first.
#[test]
fn tangent_maps_of_many_steps_are_powers() {
    let (h, steps, start) = (0.25_f64, 40, Phase::new([1.0], [0.5]));
    let oscillator = Oscillator { mass: 1.0 };
    let [forward, verlet] = [
        tangent_maps(&oscillator, ForwardEuler, start, h, steps).expect("maps"),
        tangent_maps(&oscillator, Verlet, start, h, steps).expect("maps"),
    ];
    assert_eq!((forward.len(), verlet.len()), (steps, steps));
    for (count, (forward, verlet)) in (1..).zip(forward.iter().zip(&verlet)) {
        // 1 ± ih is √(1 + h²) e^(±i atan h); a trace of 2 - h² is one of 2 cos φ. Each step rounds a few times.
        let (factor, angle) = ((1.0 + h * h).sqrt().powi(count), f64::from(count) * h.atan());
        let bound = 8.0 * f64::from(count) * f64::EPSILON * factor * factor;
        let [[a, b], [c, d]] = [0, 1].map(|row| [0, 1].map(|column| forward.matrix()[row][column]));
        let exact = [factor * angle.cos(), factor * angle.sin()];
        assert!((a - exact[0]).abs() < bound && (b - exact[1]).abs() < bound, "{count} steps: {forward:?}");
        assert!((c + exact[1]).abs() < bound && (d - exact[0]).abs() < bound, "{count} steps: {forward:?}");
        assert!((forward.determinant() - factor * factor).abs() < bound, "{count} steps: {forward:?}");
        assert!(forward.bracket(0).is_some_and(|bracket| (bracket - factor * factor).abs() < bound));
        let turned = 2.0 * (f64::from(count) * (1.0 - h * h / 2.0).acos()).cos();
        assert!((verlet.matrix()[0][0] + verlet.matrix()[1][1] - turned).abs() < bound, "{count} steps: {verlet:?}");
        assert!((verlet.determinant() - 1.0).abs() < bound && verlet.bracket(1).is_none());
    }
    let memory = tangent_maps(&oscillator, AdamsBashforth4, start, h, 5).expect("maps");
    let starter = tangent_maps(&oscillator, RungeKutta4, start, h, 5).expect("maps");
    let same: Vec<_> = memory.iter().zip(&starter).map(|(memory, starter)| memory == starter).collect();
    assert_eq!(same, [true, true, true, false, false], "three steps of a starter");
    assert!(tangent_maps(&oscillator, Verlet, start, f64::NAN, 1).is_err());
}

#[test]
fn symmetric_ones_come_back() {
    for (name, distance) in [
        ("leapfrog", reversibility(&Pendulum, StaggeredLeapfrog, SWING, 0.1, 500)),
        ("midpoint", reversibility(&Pendulum, ImplicitMidpoint, SWING, 0.1, 500)),
    ] {
        // A thousand steps of a few roundings, in a motion in which they grow with the time: 1000 · 100 · ε at most.
        assert!(distance.as_ref().is_ok_and(|distance| *distance < 2e-11), "{name}: {distance:?}");
    }
    let classical = reversibility(&Pendulum, RungeKutta4, SWING, 0.1, 500).expect("a distance");
    assert!(classical > 1e-9, "its errors do not cancel on the way back: {classical}");
}

#[test]
fn runs_are_runs() {
    macro_rules! check {
        ($($method:ident $symplectic:literal;)*) => {$({
            let start = |start| Pendulum.run_with($method, start, 0.1);
            let (mut whole, mut parts) = (start(SWING).expect("a run"), start(SWING).expect("a run"));
            whole.advance(3_000).expect("finite");
            for _ in 0..3 {
                parts.advance(7).expect("finite");
                let _ = (parts.energy(), parts.clone().samples(2).nth(2));
                parts.advance(993).expect("finite");
            }
            assert_eq!((whole.time(), whole.state()), (300.0, parts.state()), stringify!($method));

            let single = Phase::new([2.0_f32], [0.3]);
            let mut rough = Pendulum.run_with($method, single, 0.1).expect("a run");
            let mut careful = Pendulum.run_with($method, Phase::compensated(SWING.q, SWING.p), 0.1).expect("a run");
            let mut plain = start(SWING).expect("a run");
            plain.advance(50).expect("finite");
            rough.advance(50).expect("finite");
            careful.advance(50).expect("finite");
            let exact = plain.state().q[0];
            // Fifty steps of a few roundings each, which the motion lets grow tenfold at most.
            assert!((f64::from(rough.state().q[0]) - exact).abs() < 5e3 * f64::from(f32::EPSILON), stringify!($method));
            assert!((careful.state().q[0].value - exact).abs() < 5e3 * f64::EPSILON, stringify!($method));
        })*};
    }
    with_fixed_steps!(check);
}

#[test]
fn a_tolerance_is_kept() {
    // One period of a linear oscillation, in ten steps of the run.
    let (start, h) = (Phase::new([1.0], [0.0]), std::f64::consts::TAU / 10.0);
    for tolerance in [1e-5, 1e-8, 1e-11] {
        let end = |run: Result<Run<[f64; 1]>, Error>| {
            let mut run = run.expect("a run");
            run.advance(10).expect("an end");
            let state = run.state();
            (state.q[0] - 1.0).hypot(state.p[0])
        };
        let unit = Oscillator { mass: 1.0 };
        let errors = [
            end(unit.run_with(DormandPrince5 { tolerance }, start, h)),
            end(unit.run_with(DormandPrince8 { tolerance }, start, h)),
            end(unit.run_with(Bdf { tolerance }, start, h)),
        ];
        // Each step of theirs errs by the tolerance at most; backward differences take thousands of them.
        for (error, room) in errors.into_iter().zip([100.0, 100.0, 3e3]) {
            assert!(error < room * tolerance, "{errors:?} at {tolerance}");
        }
    }
}

#[test]
fn stiff_motion_is_damped_by_bdf() {
    let start = Phase::new([1.0, 1e-6], [0.0, 0.0]);
    let mut run = Stiff.run_with(Bdf { tolerance: 1e-4 }, start, 1.0).expect("a run");
    run.advance(3).expect("an end");
    let state = run.state();
    assert!((state.q[0] - 3.0_f64.cos()).abs() < 1e-2, "{state:?}");
    let mut explicit = Stiff.run_with(RungeKutta4, start, 1.0).expect("a run");
    explicit.advance(10).expect("finite so far");
    assert!(explicit.state().q[1].abs() > 1e60, "{:?}", explicit.state());
    let mut implicit = Stiff.run_with(ImplicitMidpoint, start, 0.1).expect("a run");
    implicit.advance(10_000).expect("an end");
    // It conserves quadratic energies, whatever the step, up to the rounding of ten thousand solutions.
    let energy = Stiff.kinetic(start.p) + Stiff.potential(start.q);
    assert!((implicit.energy() - energy).abs() < 1e-9, "{}", implicit.energy());
}

#[test]
fn an_unsolved_step_is_a_typed_error() {
    /// Falls into a cusp, where no implicit step has an end.
    struct Cusp;

    #[hamiltonian]
    impl Cusp {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            0.5 * p[0] * p[0]
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            -(q[0] * q[0] + 1e-24).powf(-0.75)
        }
    }

    let start = Phase::new([0.1_f64], [0.0]);
    let mut run = Cusp.run_with(BackwardEuler, start, 0.05).expect("a run");
    let error = run.advance(100).expect_err("no end");
    let Error::NotSolved { method, step, time, reason: Unsolved::Newton { .. } } = error else {
        panic!("{error:?}");
    };
    assert_eq!((method, step, time), ("BackwardEuler", run.steps() + 1, run.time()));
    assert!(run.state().q[0].is_finite(), "the last good state is kept");
    assert_eq!(run.advance(1), Err(error), "and there it stays");

    let tight = DormandPrince8 { tolerance: 1e-300 };
    let mut run = Pendulum.run_with(tight, SWING, 0.5).expect("a run");
    assert!(matches!(run.advance(1), Err(Error::NotSolved { reason: Unsolved::Adaptive(_), .. })), "{run:?}");
    assert_eq!(run.state(), SWING);
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = Pendulum.run_with(Bdf { tolerance }, SWING, 0.5);
        assert!(matches!(refused, Err(Error::Tolerance { method: "Bdf", .. })), "{tolerance}: {refused:?}");
    }
}

#[test]
fn starts_and_divergence_are_treated_as_for_compositions() {
    struct Hill;

    #[hamiltonian]
    impl Hill {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            0.5 * p[0] * p[0]
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            -q[0].powi(4)
        }
    }
    let mut run = Hill.run_with(RungeKutta4, Phase::new([1.0_f64], [0.0]), 0.1).expect("a run");
    let Err(Error::Diverged(Divergence { step, .. })) = run.advance(1_000) else { panic!("{run:?}") };
    assert_eq!(step, run.steps() + 1);
    assert!(run.state().q[0].is_finite());

    let massless = Oscillator { mass: 0.0 };
    assert!(matches!(massless.run_with(RungeKutta4, SWING, 0.1), Err(Error::Parameters { .. })));
    assert!(matches!(massless.run_with(BackwardEuler, SWING, 0.1), Err(Error::Parameters { .. })));
    assert!(matches!(Pendulum.run_with(RungeKutta4, SWING, 0.0), Err(Error::Step { .. })));
    let grid = Phase::reversible(SWING.q, SWING.p, 1.0 / f64::from(1 << 20));
    let refused = Pendulum.run_with(RungeKutta4, grid, 0.1);
    assert!(matches!(refused, Err(Error::NotSymmetric { composition: "RungeKutta4" })), "{refused:?}");
}

#[test]
fn the_defect_of_a_method_is_that_of_its_areas() {
    // In one degree of freedom the defect is the change of areas.
    let start = Phase::new([1.0], [0.5]);
    let defect = symplectic_defect(&Oscillator { mass: 1.0 }, ForwardEuler, start, 0.25).expect("a defect");
    assert!((defect - 0.0625).abs() < 4.0 * f64::EPSILON, "{defect}");
}

/// Work is known beforehand or counted; looks at a run are none of it, and portions do not matter.
#[test]
fn evaluations_are_those_of_the_steps() {
    let start = Phase::new([1.0], [0.0]);
    macro_rules! evaluations {
        ($method:expr) => {{
            let mut run = Pendulum.run_with($method, start, 0.1).expect("a start");
            run.advance(30).expect("finite states");
            run.state();
            let crossings = run.clone().crossings(100, Direction::Either, |state, _| state.q[0]);
            assert!(crossings.count() > 0);
            run.advance(70).expect("finite states");
            let mut whole = Pendulum.run_with($method, start, 0.1).expect("a start");
            whole.advance(100).expect("finite states");
            assert_eq!(run.evaluations(), whole.evaluations());
            run.evaluations()
        }};
    }
    assert_eq!(evaluations!(Verlet), 100);
    assert_eq!(evaluations!(Yoshida4), 300);
    assert_eq!(evaluations!(RungeKutta4), 400);
    // An iteration of Newton takes the field and its two columns, and a step at least one iteration and one more to see
    // that it was the last.
    let implicit = evaluations!(ImplicitMidpoint);
    assert!((600..2_000).contains(&implicit), "{implicit}");
    // Seven stages per step, and a tighter tolerance takes more steps.
    let [loose, tight] = [1e-3, 1e-12].map(|tolerance| evaluations!(DormandPrince5 { tolerance }));
    assert!(loose >= 600 && tight > 2 * loose, "{loose}, {tight}");
}

/// A value among others takes the steps of the method itself, what it remembers included.
#[test]
fn any_method_has_the_bits_of_the_method() {
    fn end<M: Method<Pendulum>>(method: M) -> (Phase<[f64; 1]>, u64) {
        let mut run = Pendulum.run_with(method, SWING, 0.1).expect("a start");
        run.advance(7).expect("finite states");
        run.advance(20).expect("finite states");
        (run.state(), run.evaluations())
    }
    macro_rules! same {
        ($($method:expr),*) => {$(
            let method = AnyReference::from($method);
            assert_eq!(end(method), end($method), "{method:?}");
        )*};
    }
    same!(StaggeredLeapfrog, AdamsBashforthMoulton4, DormandPrince5 { tolerance: 1e-6 });
    let refused = Pendulum.run_with(AnyReference::from(DormandPrince5 { tolerance: -1.0 }), SWING, 0.1);
    assert!(refused.is_err(), "a tolerance below zero");
}

/// How far the third zero of an oscillator's position is from `5π/2`.
fn crossing_error<X: Method<Oscillator>>(method: X, h: f64) -> f64 {
    let run = Oscillator { mass: 1.0 }.run_with(method, Phase::new([1.0], [0.0]), h).expect("a start");
    let third = run.crossings((9.0 / h) as u64, Direction::Either, |state, _| state.q[0]).nth(2);
    (third.expect("a crossing").expect("finite states").time - 2.5 * std::f64::consts::PI).abs()
}

/// Methods with a memory, an implicit equation or steps of their own shorten their steps at a crossing.
#[test]
fn the_times_of_crossings_have_the_order_of_the_method() {
    for (order, errors) in [
        // Of first order in the amplitude, but these turn by atan h in a step, which is h but for h³/3.
        (2.0, [0.01, 0.005].map(|h| crossing_error(ForwardEuler, h))),
        (2.0, [0.01, 0.005].map(|h| crossing_error(BackwardEuler, h))),
        (2.0, [0.1, 0.05].map(|h| crossing_error(StaggeredLeapfrog, h))),
        (4.0, [0.1, 0.05].map(|h| crossing_error(RungeKutta4, h))),
        (4.0, [0.05, 0.025].map(|h| crossing_error(AdamsBashforthMoulton4, h))),
    ] {
        let observed = (errors[0] / errors[1]).log2();
        assert!((observed - order).abs() < 0.25, "{observed} for {order}: {errors:?}");
    }
    // Within its tolerance, for four quarters of a period.
    let adaptive =
        [crossing_error(DormandPrince8 { tolerance: 1e-10 }, 0.5), crossing_error(Bdf { tolerance: 1e-8 }, 0.5)];
    assert!(adaptive[0] < 1e-8 && adaptive[1] < 1e-5, "{adaptive:?}");
}
