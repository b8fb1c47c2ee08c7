//! Hamiltonian Monte Carlo of the examples: the data are those of the literature, and draws have the mean of the posterior.

#[path = "support/drawn.rs"]
mod drawn;
#[path = "../../examples/hmc/picture.rs"]
mod picture;
#[path = "../../examples/hmc/posterior.rs"]
mod posterior;
#[path = "../../examples/hmc/sampler.rs"]
mod sampler;

use picture::MORNING;

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
    let mut sampler = sampler::Sampler::new(&posterior, 0.4, 12, 1986).expect("a posterior");
    let draws: Vec<_> = (0..4_000).map(|_| sampler.draw().expect("a posterior")).collect();
    assert!((0.9..0.99).contains(&sampler.acceptance()), "{}", sampler.acceptance());
    let series = [
        draws.iter().map(|b| b[0]).collect::<Vec<_>>(),
        draws.iter().map(|b| b[1]).collect(),
        picture::probabilities(&posterior, &draws, MORNING),
    ];
    for (series, reference) in series.iter().zip(reference) {
        let ((mean, variance), size) = (sampler::moments(series), sampler::effective_size(series));
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
    let size = sampler::effective_size(&series);
    assert!((size / 5_000.0 - 1.0).abs() < 0.1, "{size}");
}
