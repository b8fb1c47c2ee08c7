//! Deviation vectors of methods that are no compositions: Taylor's, and those with a time of their own.

#[path = "support/comet.rs"]
mod comet;
#[path = "support/derivatives.rs"]
#[allow(dead_code, reason = "not all that is shared is needed here")]
mod derivatives;
#[path = "support/instruction_sets.rs"]
mod instruction_sets;

use comet::Comet;
use derivatives::{directions, holds, numbers, point};
use integrator_core::{Differentiable, prelude::*};

/// A chain, whose coefficients are computed in vectors where there are no derivatives.
struct Chain;

#[hamiltonian(taylor)]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() - 1 {
            let stretch = q[i + 1] - q[i];
            energy += stretch * stretch / 2.0 + stretch.sin() * stretch.powi(3) / 4.0;
        }
        energy
    }
}

/// Bodies that attract each other.
struct Bodies;

#[hamiltonian(taylor)]
impl Bodies {
    fn kinetic(&self, p: &[[f64; 3]; 5]) -> f64 {
        (0..5).map(|i| (0..3).map(|d| p[i][d].powi(2)).sum::<f64>() / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; 3]; 5]) -> f64 {
        let mut energy = 0.0;
        for i in 0..5 {
            for j in 0..i {
                let square = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                energy -= 0.01 / square.sqrt();
            }
        }
        energy
    }
}

/// The same body as [`Comet`], seen from axes that turn.
struct Turning;

#[hamiltonian(split = none)]
impl Turning {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0 + 0.3 * (y * px - x * py) - 1.0 / x.hypot(y)
    }
    fn rate(&self, [x, y]: [f64; 2]) -> f64 {
        x.hypot(y).powf(-1.5)
    }
}

const COMET: Phase<[f64; 2]> = Phase { q: [0.4, 0.1], p: [-0.2, 1.6] };

#[test]
fn vectors_of_paced_runs_are_derivatives_of_their_steps() {
    holds("logarithmic", &Comet, Logarithmic(SofroniouSpaletta8), COMET, 0.1);
    holds("logarithmic, a kick first", &Comet, Logarithmic(Verlet), COMET, 0.1);
    holds("a power", &Comet, Power(0.5, Yoshida4), COMET, 0.1);
    holds("a pace", &Comet, Paced(KahanLi8), COMET, 0.1);
    holds("a pace of an implicit method", &Turning, Paced(GaussLegendre::<4>), COMET, 0.1);
}

/// Polynomials of high order: the error of a difference of steps is that of the steps.
#[test]
fn vectors_of_taylor_runs_are_derivatives_of_their_steps() {
    let method = Taylor::tolerance(1e-16);
    holds("a comet", &Comet, method, COMET, 0.1);
    let site = |i: usize| (0.4 * i as f64).sin();
    let chain = Phase::new((0..21).map(site).collect::<Vec<_>>(), (0..21).map(|i| site(i + 3)).collect());
    holds("a chain", &Chain, method, chain, 0.1);
    let body = |i: usize| [site(2 * i) + i as f64, site(i + 1), 0.3 * site(3 * i)];
    let bodies = |i: usize| body(i + 5).map(|p| 0.1 * p);
    holds("bodies", &Bodies, method, Phase::new([0, 1, 2, 3, 4].map(body), [0, 1, 2, 3, 4].map(bodies)), 0.1);
}

/// A neighbour takes as many steps to another time.
fn time_of<H, X>(system: &H, method: X, start: Phase<[f64; 2]>) -> f64
where
    H: Hamiltonian<Coords = [f64; 2]>,
    X: Differentiable<H>,
{
    let mut run = system.run_with(method, start, 0.1).expect("a start");
    run.advance(12).expect("finite states");
    run.time()
}

#[test]
fn times_have_derivatives_along_vectors() {
    fn holds<H, X>(name: &str, system: &H, method: X)
    where
        H: Hamiltonian<Coords = [f64; 2]>,
        X: Differentiable<H>,
    {
        let vectors = directions(&COMET, 4);
        let mut tangent = system.tangent::<f64, X>(method, COMET, vectors.clone(), 0.1).expect("a start");
        tangent.advance(12).expect("finite states");
        for (vector, slope) in vectors.iter().zip(tangent.time_slopes()) {
            let width = 1.0 / 1024.0;
            let at = |s: f64| time_of(system, method, point(&COMET, |place, x| x + s * width * numbers(vector)[place]));
            let fine = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * width);
            let coarse = (8.0 * (at(2.0) - at(-2.0)) - (at(4.0) - at(-4.0))) / (24.0 * width);
            // As for vectors: what both differ by, and roundings over the width.
            let tolerance = (fine - coarse).abs() + 1e3 * f64::EPSILON / width;
            assert!((slope - fine).abs() <= tolerance, "{name}: {slope} and not {fine}");
            assert!(slope.abs() > 1e-3, "{name}: the time depends on the start");
        }
    }
    holds("logarithmic", &Comet, Logarithmic(SofroniouSpaletta8));
    holds("a power", &Comet, Power(0.5, Yoshida4));
    holds("a pace", &Comet, Paced(KahanLi8));
    holds("a pace of an implicit method", &Turning, Paced(GaussLegendre::<4>));
    let mut tangent = Comet.tangent(Yoshida4, COMET, [COMET], 0.1).expect("a start");
    tangent.advance(12).expect("finite states");
    assert_eq!(tangent.time_slopes(), [0.0], "steps that are equal in time");
}

#[test]
fn tangents_are_seen_at_any_time() {
    fn holds<H, X>(name: &str, system: &H, method: X, count: usize)
    where
        H: Hamiltonian<Coords = [f64; 2]>,
        X: Differentiable<H>,
    {
        let vectors = directions(&COMET, count);
        let mut tangent = system.tangent::<f64, X>(method, COMET, vectors.clone(), 0.1).expect("a start");
        let mut whole = tangent.clone();
        let mut run = system.run_with::<f64, X>(method, COMET, 0.1).expect("a start");
        let time = 1.234_567;
        tangent.advance_to(time).and_then(|()| run.advance_to(time)).expect("finite states");
        assert_eq!(
            (tangent.time(), tangent.state(), tangent.energy()),
            (run.time(), run.state(), run.energy()),
            "{name}"
        );
        // What neighbours have at the same time; where that is part of the state, at the time that they have with as long
        // a shorter step.
        let (at, slopes) = (tangent.vectors(), tangent.time_slopes());
        for (vector, (image, slope)) in vectors.iter().zip(at.iter().zip(&slopes)) {
            let width = 1.0 / 1024.0;
            let along = |s: f64| {
                let start = point(&COMET, |place, x| x + s * width * numbers(vector)[place]);
                let mut run = system.run_with::<f64, X>(method, start, 0.1).expect("a start");
                run.advance_to(time + s * width * slope).expect("finite states");
                numbers(&run.state())
            };
            let quotient = |w: f64| {
                let ends = [along(w), along(-w), along(2.0 * w), along(-2.0 * w)];
                let of = |i: usize| (8.0 * (ends[0][i] - ends[1][i]) - (ends[2][i] - ends[3][i])) / (12.0 * w * width);
                (0..4).map(of).collect::<Vec<_>>()
            };
            let (fine, coarse) = (quotient(1.0), quotient(2.0));
            for (place, exact) in numbers(image).into_iter().enumerate() {
                let tolerance = 2.0 * (fine[place] - coarse[place]).abs() + 1e4 * f64::EPSILON / width;
                let apart = (exact - fine[place]).abs();
                assert!(apart <= tolerance, "{name}: component {place} is off by {apart:e}, and not {tolerance:e}");
            }
        }
        // Seen or not, it goes on from the last whole step.
        assert!(matches!(tangent.advance_to(0.5), Err(Error::Passed { .. })), "{name}");
        tangent.advance(3).and_then(|()| whole.advance(tangent.steps())).expect("finite states");
        assert_eq!((tangent.state(), tangent.vectors()), (whole.state(), whole.vectors()), "{name}");
    }
    holds("a composition", &Comet, BlanesMoan6, 1);
    holds("a processor", &Comet, BlanesCasasMurua6S11, 4);
    holds("an implicit method", &Comet, GaussLegendre6, 2);
    holds("logarithmic", &Comet, Logarithmic(SofroniouSpaletta8), 1);
    holds("a pace", &Comet, Paced(KahanLi8), 4);
    holds("a pace of an implicit method", &Turning, Paced(GaussLegendre::<4>), 2);
    holds("Taylor", &Comet, Taylor::tolerance(1e-16), 1);
}
