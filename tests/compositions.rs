//! The catalogue end to end: what the macro proved, measured on nonlinear problems.

#[path = "../integrator-core/src/composition/catalogue_list.rs"]
mod catalogue;
#[path = "support/slope.rs"]
mod slope;

use catalogue::for_each_composition;
use integrator_core::{Visitor, prelude::*};
use std::{fs, path::Path};

/// Hénon and Heiles's galaxy: `T` is quadratic.
struct Galaxy;

#[hamiltonian]
impl Galaxy {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (x * x + y * y) / 2.0 + x * x * y - y * y * y / 3.0
    }
}

/// An electron in a crystal, held in a well without symmetry: `T` is not quadratic.
struct Crystal;

#[hamiltonian]
impl Crystal {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        -p[0].cos() - p[1].cos()
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (x * x + y * y) / 2.0 + x * x * y - y * y * y / 3.0 + x.powi(4)
    }
}

type Point = [f64; 4];

const NEAR: Point = [0.3, -0.2, 0.25, 0.4];

/// Where `steps` steps of `h` lead, with the rounding of every update carried.
fn flow<H, X>(system: &H, composition: X, from: Point, h: f64, steps: u64) -> Option<Point>
where
    H: Hamiltonian<Coords = [f64; 2]>,
    X: Composition<H>,
{
    let from = Phase::compensated([from[0], from[1]], [from[2], from[3]]);
    let mut run = system.run_with(composition, from, h).expect("a start");
    run.advance(steps).ok()?;
    let Phase { q, p } = run.state();
    Some([q[0].value, q[1].value, p[0].value, p[1].value])
}

fn distance(one: Point, other: Point) -> f64 {
    one.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The slope of the error over the step, where it is smallest and yet well above rounding.
fn slope<H, X>(system: &H, composition: X, start: Point, reference: Point) -> f64
where
    H: Hamiltonian<Coords = [f64; 2]>,
    X: Composition<H>,
{
    const FLOOR: f64 = 2e-14;
    let mut points = Vec::new();
    for refinement in 0..50 {
        let steps = (8.0 * 2_f64.powf(f64::from(refinement) / 4.0)).round();
        let Some(end) = flow(system, composition, start, SPAN / steps, steps as u64) else { continue };
        let error = distance(end, reference);
        if error < FLOOR || steps * X::FORCE_EVALUATIONS as f64 > 20_000.0 {
            break;
        }
        points.push((SPAN / steps, error));
    }
    let last = &points[points.len().saturating_sub(3)..];
    assert!(last.len() >= 3, "{}: too few steps above rounding", X::NAME);
    slope::slope(last)
}

const SPAN: f64 = 8.0;

/// The end of the span, on which two methods of order 10 agree.
fn reference<H: Hamiltonian<Coords = [f64; 2]>>(system: &H, start: Point) -> Point
where
    SofroniouSpaletta10: Composition<H>,
    KahanLi10: Composition<H>,
{
    let one = flow(system, SofroniouSpaletta10, start, SPAN / 128.0, 128).expect("a finite state");
    let other = flow(system, KahanLi10, start, SPAN / 128.0, 128).expect("a finite state");
    assert!(distance(one, other) < 2e-15, "{one:?} {other:?}");
    one
}

#[test]
fn the_error_falls_with_the_proved_order() {
    let mut wrong = Vec::new();
    let galaxy = reference(&Galaxy, NEAR);
    let crystal = reference(&Crystal, NEAR);
    macro_rules! on_galaxy {
        ($($name:ident)*) => {$(
            let measured = slope(&Galaxy, $name, NEAR, galaxy);
            if (measured - f64::from($name::ORDER)).abs() > 0.2 {
                wrong.push(format!("{} on a quadratic T: {measured:.2}", $name::NAME));
            }
        )*};
    }
    macro_rules! on_both {
        ($($name:ident)*) => {
            on_galaxy!($($name)*);
            $(
                let measured = slope(&Crystal, $name, NEAR, crystal);
                if (measured - f64::from($name::ORDER)).abs() > 0.2 {
                    wrong.push(format!("{} on another T: {measured:.2}", $name::NAME));
                }
            )*
        };
    }
    for_each_composition!(general: on_both!);
    for_each_composition!(quadratic: on_galaxy!);
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A free particle in a weak potential, so that the part of the drifts is the large one.
struct Weak {
    epsilon: f64,
}

#[hamiltonian]
impl Weak {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        self.epsilon * ((x + 0.3 * y).sin() + 0.5 * (x - y).cos())
    }
}

/// What is of one order in the size of a weak potential, by central differences; without it there is no error.
struct Differences {
    /// The potentials, and where each leads in the span.
    ends: Vec<(Weak, Point)>,
    weights: [f64; 4],
}

impl Differences {
    const START: Point = [0.3, -0.2, 2.7, 0.4];

    fn of(size: f64, weights: [f64; 4]) -> Self {
        let ends = [-2.0, -1.0, 1.0, 2.0].map(|times| {
            let weak = Weak { epsilon: times * size };
            let end = flow(&weak, SofroniouSpaletta10, Self::START, SPAN / 512.0, 512).expect("a finite state");
            (weak, end)
        });
        Self { ends: ends.into(), weights }
    }

    /// What the error of so many steps over the span has of this order.
    fn error<X: Composition<Weak>>(&self, composition: X, steps: u32) -> f64 {
        let mut sum = [0.0; 4];
        for ((weak, exact), weight) in self.ends.iter().zip(self.weights) {
            let end = flow(weak, composition, Self::START, SPAN / f64::from(steps), steps.into());
            for (sum, (end, exact)) in sum.iter_mut().zip(end.expect("a finite state").iter().zip(exact)) {
                *sum += weight / 12.0 * (end - exact);
            }
        }
        sum.into_iter().map(f64::abs).fold(0.0, f64::max)
    }

    /// How fast that falls with the step, from the last two steps at which it is above rounding: a few 1e-15 in each end,
    /// with weights of up to 3.
    fn slope<X: Composition<Weak>>(&self, composition: X) -> f64 {
        let steps = (5..24).map(|k| 1.25_f64.powi(k).round() as u32);
        let points = steps.map(|steps| (f64::from(steps), self.error(composition, steps)));
        match points.take_while(|(_, error)| *error > 3e-13).collect::<Vec<_>>()[..] {
            [.., (fewer, larger), (steps, error)] => (larger / error).ln() / (steps / fewer).ln(),
            _ => f64::NAN,
        }
    }
}

#[test]
fn generalised_orders_are_those_of_the_powers_of_a_small_part() {
    let mut wrong = Vec::new();
    // The sizes are such that the next power with the same stencil, two above, is below rounding or falls as fast.
    let powers = [
        Differences::of(2e-3, [1.0, -8.0, 8.0, -1.0]),
        Differences::of(0.05, [-1.0, 16.0, 16.0, -1.0]),
        Differences::of(0.2, [-6.0, 12.0, -12.0, 6.0]),
    ];
    macro_rules! on_weak {
        ($($name:ident)*) => {$(
            let orders = $name::GENERALISED_ORDERS;
            assert_eq!(orders.last(), Some(&$name::ORDER), "{}", $name::NAME);
            for (power, differences) in powers.iter().enumerate() {
                let claimed = f64::from(*orders.get(power).unwrap_or(&$name::ORDER));
                let measured = differences.slope($name);
                // Nearer to the claimed order than to any other.
                if (measured - claimed).abs().is_nan() || (measured - claimed).abs() >= 0.5 {
                    wrong.push(format!("{}, power {}: {measured:.2} and not {claimed}", $name::NAME, power + 1));
                }
            }
        )*};
    }
    for_each_composition!(near_integrable: on_weak!);
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert_eq!(Verlet::GENERALISED_ORDERS, [2]);
}

#[test]
fn symmetric_compositions_run_back() {
    macro_rules! back {
        ($($name:ident)*) => {$(
            let forth = flow(&Galaxy, $name, NEAR, 0.25, 20).expect("a finite state");
            let back = flow(&Galaxy, $name, forth, -0.25, 20).expect("a finite state");
            let error = distance(back, NEAR);
            assert_eq!(error < 2e-15, $name::SYMMETRIC, "{}: {error:e}", $name::NAME);
        )*};
    }
    for_each_composition!(general: back!);
    for_each_composition!(quadratic: back!);
    for_each_composition!(near_integrable: back!);
}

#[test]
fn a_processor_changes_no_run_and_shows_no_kernel() {
    let run = || Galaxy.run_with(BlanesCasasMurua8, Phase::new([0.3, -0.2], [0.25, 0.4]), 0.25).expect("a start");
    assert_eq!(run().state(), Phase::new([0.3, -0.2], [0.25, 0.4]), "a run shows its start untouched");
    let (mut whole, mut parts) = (run(), run());
    whole.advance(100).expect("finite states");
    for _ in 0..100 {
        parts.advance(1).expect("a finite state");
        parts.state();
    }
    assert_eq!(whole.state(), parts.state());
    let energies: Vec<f64> = run().samples(1).take(40).map(|sample| sample.expect("a sample").energy()).collect();
    let drift = energies.iter().map(|energy| (energy - energies[0]).abs()).fold(0.0, f64::max);
    assert!(drift < 1e-8, "the kernel alone would err by 1e-5: {drift:e}");
}

#[test]
fn facts_are_constants() {
    assert_eq!(KahanLi8::NAME, "KahanLi8");
    assert!(KahanLi8::CITATION.contains("1997"));
    assert_eq!((KahanLi8::ORDER, KahanLi8::FORCE_EVALUATIONS, KahanLi8::GRADIENT_EVALUATIONS), (8, 17, 0));
    assert_eq!(Verlet::STABILITY_LIMIT, 2.0);
    assert!(BlanesMoanSrkn14::LEADING_ERROR < BlanesMoanSrkn11::LEADING_ERROR);
    assert!(BlanesMoanSrkn11::LEADING_ERROR < Omelyan6::LEADING_ERROR);
}

/// The names of what a Hamiltonian admits.
struct Names(Vec<&'static str>);

impl<H: Hamiltonian> Visitor<H> for Names {
    fn visit<X: Composition<H>>(&mut self, _: X) {
        self.0.push(X::NAME);
    }
}

#[test]
fn every_composition_of_the_catalogue_is_tested() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("integrator-core/src/composition/catalogue");
    let files = fs::read_dir(folder).expect("the catalogue").map(|entry| entry.expect("a file").path());
    let text: String = files.map(|file| fs::read_to_string(file).expect("text")).collect();
    let mut declared: Vec<&str> =
        text.lines().filter_map(|line| line.trim().strip_prefix("pub struct ")?.split(':').next()).collect();
    let mut tested = Vec::new();
    macro_rules! note {
        ($($name:ident)*) => { tested.extend([$($name::NAME),*]); };
    }
    for_each_composition!(general: note!);
    for_each_composition!(quadratic: note!);
    let mut visited = Names(Vec::new());
    Galaxy::visit_compositions(&mut visited);
    assert_eq!(visited.0, tested, "a kinetic and a potential energy have no small part");
    for_each_composition!(near_integrable: note!);
    declared.sort_unstable();
    tested.sort_unstable();
    assert_eq!(tested, declared);
}
