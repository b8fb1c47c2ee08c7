//! The catalogue end to end: what the macro proved, measured on nonlinear problems.

#[path = "../integrator-core/src/composition/catalogue_list.rs"]
mod catalogue;

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
        points.push((steps.ln(), error.ln()));
    }
    let last = &points[points.len().saturating_sub(3)..];
    assert!(last.len() >= 3, "{}: too few steps above rounding", X::NAME);
    let count = last.len() as f64;
    let (x, y) = last.iter().fold((0.0, 0.0), |sum, point| (sum.0 + point.0 / count, sum.1 + point.1 / count));
    let (above, below) = last
        .iter()
        .fold((0.0, 0.0), |sum, point| (sum.0 + (point.0 - x) * (point.1 - y), sum.1 + (point.0 - x) * (point.0 - x)));
    -above / below
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
    declared.sort_unstable();
    tested.sort_unstable();
    visited.0.sort_unstable();
    assert_eq!(tested, declared);
    assert_eq!(visited.0, declared);
}
