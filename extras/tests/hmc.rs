//! Hamiltonian Monte Carlo of the examples: the data and the steps are those of the literature, and draws have the mean of the
//! posterior.

#[path = "../../examples/hmc/by_hand.rs"]
mod by_hand;
#[path = "support/drawn.rs"]
mod drawn;
#[path = "../../examples/hmc/normal_density.rs"]
mod normal_density;
#[path = "../../examples/hmc/picture.rs"]
mod picture;
#[path = "../../examples/hmc/posterior.rs"]
mod posterior;
#[path = "../../examples/hmc/sampler.rs"]
mod sampler;
#[path = "../../examples/hmc/statistics.rs"]
mod statistics;

use integrator_core::{Method, prelude::*};
use normal_density::{COUNT, Normal};
use picture::MORNING;
use sampler::{MinimumError2, MinimumError3, Sampler};

/// The table is the one of Dalal, Fowlkes and Hoadley: without a prior, the maximum is at their coefficients.
#[test]
fn the_launches_are_those_of_the_literature() {
    let posterior = posterior::Posterior::measured(1e6).expect("the table of the examples");
    assert_eq!(posterior.launches().count(), 23);
    assert_eq!(posterior.launches().filter(|(_, distress)| *distress == 1.0).count(), 7);
    let mut at = [0.0; 2];
    // Newton's method, with differences over 1e-4 for derivatives: off by 1e-8 in the gradient.
    for _ in 0..20 {
        let potential = |x: f64, y: f64| posterior.potential([at[0] + 1e-4 * x, at[1] + 1e-4 * y]);
        let (left, right, below, above) =
            (potential(-1.0, 0.0), potential(1.0, 0.0), potential(0.0, -1.0), potential(0.0, 1.0));
        let middle = potential(0.0, 0.0);
        let gradient = [(right - left) / 2e-4, (above - below) / 2e-4];
        let corners = potential(1.0, 1.0) + potential(-1.0, -1.0) - potential(1.0, -1.0) - potential(-1.0, 1.0);
        let [xx, yy, xy] = [left + right - 2.0 * middle, below + above - 2.0 * middle, corners / 4.0].map(|d| d / 1e-8);
        let determinant = xx * yy - xy * xy;
        at[0] -= (yy * gradient[0] - xy * gradient[1]) / determinant;
        at[1] -= (xx * gradient[1] - xy * gradient[0]) / determinant;
    }
    let [intercept, slope] = posterior.per_degree(at);
    assert!((intercept - 15.0429).abs() < 1e-3 && (slope + 0.232_16).abs() < 1e-4, "{intercept} {slope}");
}

#[test]
fn draws_have_the_mean_of_the_posterior() {
    let posterior = posterior::Posterior::measured(3.0).expect("the table of the examples");
    let reference = posterior.mean_on_grid(120, |b| [b[0], b[1], posterior.probability(b, MORNING)]);
    // The sum over the grid has converged.
    let coarser = posterior.mean_on_grid(80, |b| [b[0], b[1], posterior.probability(b, MORNING)]);
    assert!(reference.iter().zip(coarser).all(|(a, b)| (a - b).abs() < 1e-6), "{reference:?} {coarser:?}");
    let mut sampler = Sampler::new(&posterior, MinimumError3, 1.2, 4, 1986).expect("a posterior");
    let draws: Vec<_> = (0..4_000).map(|_| sampler.draw().expect("a posterior")).collect();
    assert!((0.9..0.999).contains(&sampler.acceptance()), "{}", sampler.acceptance());
    let series = [
        draws.iter().map(|b| b[0]).collect::<Vec<_>>(),
        draws.iter().map(|b| b[1]).collect(),
        picture::probabilities(&posterior, &draws, MORNING),
    ];
    for (series, reference) in series.iter().zip(reference) {
        let ((mean, variance), size) = (statistics::moments(series), statistics::effective_size(series));
        assert!(size > 1_000.0, "{size} effective draws of 4,000");
        // Four standard errors: the seed is fixed, so that this holds always or never.
        assert!((mean - reference).abs() < 4.0 * (variance / size).sqrt(), "{mean} for {reference}");
    }
    let drawing = picture::picture(&posterior, &draws, [reference[0], reference[1]], sampler.acceptance());
    let words =
        ["Draws from the posterior", "probability at 31 °F: 99 %", "temperature in °F", "slope per °F", "accepted"];
    let text = drawn::drawn("posterior", &drawing, &words);
    assert_eq!(text.matches("<circle").count(), 1 + 23, "the mean, and a dot for each launch");
}

/// A series of which every number is said four times has a quarter of its size.
#[test]
fn effective_sizes_count_independent_draws() {
    let mut random = fastrand::Rng::with_seed(7);
    let series: Vec<f64> = (0..5_000).flat_map(|_| [random.f64(); 4]).collect();
    let size = statistics::effective_size(&series);
    assert!((size / 5_000.0 - 1.0).abs() < 0.1, "{size}");
}

/// An oscillator, on which the mean energy error of a sampler has a closed form.
struct Oscillator;

#[hamiltonian]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0] * q[0]
    }
}

/// Returns the columns of a step on the oscillator: where it leads from a position of 1, and from a momentum of 1.
fn columns<X: Method<Oscillator>>(method: X, h: f64) -> [[f64; 2]; 2] {
    [[1.0, 0.0], [0.0, 1.0]].map(|[q, p]| {
        let mut run = Oscillator.run_with(method, Phase::new([q], [p]), h).expect("a start");
        run.advance(1).expect("a step");
        [run.state().q[0], run.state().p[0]]
    })
}

/// Returns the same for a step by hand, with alternating fractions of kicks and drifts.
fn columns_by_hand(fractions: &[f64], h: f64) -> [[f64; 2]; 2] {
    [[1.0, 0.0], [0.0, 1.0]].map(|[mut q, mut p]| {
        for (number, fraction) in fractions.iter().enumerate() {
            match number % 2 {
                0 => p -= fraction * h * q,
                _ => q += fraction * h * p,
            }
        }
        [q, p]
    })
}

/// Returns the largest bound on the mean energy error for steps up to `most`: `(B + C)²/(2 (1 - A²))`, where the step is the matrix
/// `[[A, B], [C, A]]` (Blanes, Casas and Sanz-Serna 2014).
fn bound(fractions: &[f64], most: f64) -> f64 {
    let at = |h: f64| {
        let [[a, c], [b, _]] = columns_by_hand(fractions, h);
        (b + c).powi(2) / (2.0 * (1.0 - a * a))
    };
    (1..=3000).map(|i| at(most * f64::from(i) / 3000.0)).fold(0.0, f64::max)
}

/// The coefficients are those that minimise the mean energy error, with the digits that are given.
#[test]
fn steps_of_the_sampler_have_the_smallest_energy_error() {
    let two = |b: f64| [b, 0.5, 1.0 - 2.0 * b, 0.5, b];
    // Three kicks on a curve of coefficients, as in the article.
    let three = |b: f64| {
        let a = (0.5 - b) / (2.0 - 6.0 * b);
        [b, a, 0.5 - b, 1.0 - 2.0 * a, 0.5 - b, a, b]
    };
    let (b_two, b_three) = (0.21178, 0.118_880_109_665_48);
    for h in [0.3, 1.0, 2.0] {
        for (found, exact) in [
            (columns(MinimumError2, h), columns_by_hand(&two(b_two), h)),
            (columns(MinimumError3, h), columns_by_hand(&three(b_three), h)),
        ] {
            // Sums of up to eight numbers of order one. The second drift of the article has 14 digits.
            assert!(
                found.iter().zip(exact).all(|(x, y)| x.iter().zip(y).all(|(x, y)| (x - y).abs() < 1e-13)),
                "{found:?}"
            );
        }
    }
    let [least_two, least_three] = [bound(&two(b_two), 2.0), bound(&three(b_three), 3.0)];
    for sign in [-1.0, 1.0] {
        assert!(
            bound(&two(b_two + sign * 1e-5), 2.0) > least_two
                && bound(&three(b_three + sign * 1e-6), 3.0) > least_three
        );
    }
    // Two and three leapfrog steps of the same duration.
    let leapfrog = bound(&[0.5, 1.0, 0.5], 1.0);
    assert!(least_two < 0.02 * leapfrog && least_three < 0.002 * leapfrog, "{least_two} {least_three} {leapfrog}");
}

/// All samplers have the variances of the closed form, and the loop by hand accepts as often as the library's leapfrog.
#[test]
fn draws_have_the_widths_of_a_normal_distribution() {
    let (draws, wide) = (4_000, Normal::wide());
    let mut three = Sampler::new(&wide, MinimumError3, 0.3, 8, 1986).expect("a density");
    let mut two = Sampler::new(&wide, MinimumError2, 0.2, 12, 1986).expect("a density");
    let mut by_hand = by_hand::ByHand::new(Normal::wide(), 0.1, 24, 1986);
    let mut samplers: [&mut dyn FnMut() -> [f64; COUNT]; 3] =
        [&mut || three.draw().expect("a density"), &mut || two.draw().expect("a density"), &mut || by_hand.draw()];
    for sampler in &mut samplers {
        let draws: Vec<_> = (0..draws).map(|_| sampler()).collect();
        for coordinate in [0, COUNT / 2, COUNT - 1] {
            let squares: Vec<f64> =
                draws.iter().map(|q| q[coordinate] * q[coordinate] * wide.stiffness[coordinate]).collect();
            let ((mean, variance), size) = (statistics::moments(&squares), statistics::effective_size(&squares));
            // Four standard errors, with a fixed seed; they exclude a width that is wrong by a quarter.
            assert!((mean - 1.0).abs() < 4.0 * (variance / size).sqrt(), "{mean} for coordinate {coordinate}");
            assert!(4.0 * (variance / size).sqrt() < 0.5, "{size} effective draws");
        }
    }
    let mut leapfrog = Sampler::new(&wide, VelocityVerlet, 0.1, 24, 1986).expect("a density");
    let mut by_hand = by_hand::ByHand::new(Normal::wide(), 0.1, 24, 1986);
    for _ in 0..20 {
        let (a, b) = (leapfrog.draw().expect("a density"), by_hand.draw());
        // The same random numbers, and steps that differ by rounding.
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-10), "{a:?} and {b:?}");
    }
    assert!(
        three.acceptance() > 0.95 && leapfrog.acceptance() < 0.9,
        "{} {}",
        three.acceptance(),
        leapfrog.acceptance()
    );
}
