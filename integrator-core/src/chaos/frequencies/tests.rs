//! Sums of known terms, closed forms, regular and chaotic orbits, wrong input.

use super::{
    Drift, drift, frequencies, frequencies_of_run, frequencies_with_window, frequency_map,
    peak::Peaks,
    series::{ORDER, Series},
};
use crate::{check::CheckError, prelude::*};
use std::f64::consts::{PI, TAU};

/// A term `a exp(iνt)`, as it was chosen.
#[derive(Clone, Copy, Debug)]
struct Known {
    frequency: f64,
    modulus: f64,
    phase: f64,
}

const INTERVAL: f64 = 0.5;

fn sampled(terms: &[Known], count: usize) -> Vec<[f64; 2]> {
    let value = |time: f64| {
        let part = |part: fn(f64) -> f64| {
            terms.iter().map(|term| term.modulus * part(term.frequency * time + term.phase)).sum::<f64>()
        };
        [part(f64::cos), part(f64::sin)]
    };
    (0..count).map(|index| value(INTERVAL * index as f64)).collect()
}

/// Numbers between 0 and 1 (SplitMix64).
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = state;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Terms in descending order of amplitude, with frequencies at least 20 of the `samples` resolvable frequencies apart.
fn chosen(count: usize, samples: usize, mut next: impl FnMut() -> f64) -> Vec<Known> {
    let resolution = TAU / (samples as f64 * INTERVAL);
    let mut terms: Vec<Known> = Vec::new();
    while terms.len() < count {
        let frequency = (2.0 * next() - 1.0) * 0.9 * PI / INTERVAL;
        let is_apart = |other: f64| (frequency - other).abs() > 20.0 * resolution;
        if is_apart(0.0) && terms.iter().all(|term| is_apart(term.frequency)) {
            let modulus = 0.6_f64.powi(terms.len() as i32) * (1.0 + 0.3 * next());
            terms.push(Known { frequency, modulus, phase: TAU * next() });
        }
    }
    terms
}

/// The largest relative error of a frequency, and the largest error of an amplitude relative to it.
fn errors(found: &[super::Line], terms: &[Known]) -> [f64; 2] {
    assert_eq!(found.len(), terms.len(), "{found:?} {terms:?}");
    let mut worst = [0.0_f64; 2];
    for (line, term) in found.iter().zip(terms) {
        let [re, im] = [term.modulus * term.phase.cos(), term.modulus * term.phase.sin()];
        worst[0] = worst[0].max(((line.frequency - term.frequency) / term.frequency).abs());
        worst[1] = worst[1].max((line.amplitude[0] - re).hypot(line.amplitude[1] - im) / term.modulus);
    }
    worst
}

#[test]
fn sums_of_terms_are_found_to_rounding() {
    let mut worst = [0.0_f64; 2];
    for count in 1..=10 {
        let terms = chosen(count, 10_000, numbers(count as u64));
        let found = frequencies(&sampled(&terms, 10_000), INTERVAL, 10).expect("samples");
        let found = errors(&found, &terms);
        worst = [worst[0].max(found[0]), worst[1].max(found[1])];
    }
    assert!(worst[0] < 1e-12 && worst[1] < 1e-10, "{worst:?}");
}

/// Each step of the method is necessary for the accuracy of the test above.
#[test]
fn without_a_step_of_the_method_the_accuracy_is_lost() {
    let terms = chosen(2, 10_000, numbers(7));
    let samples = sampled(&terms, 10_000);
    let error = |frequency: f64| ((frequency - terms[0].frequency) / terms[0].frequency).abs();
    // The point of the Fourier transform, without refinement.
    let series = Series::new(&samples, INTERVAL, ORDER).expect("samples");
    let peak = Peaks::new(samples.len()).largest(&series, &series.values, &[]).expect("a peak") / INTERVAL;
    let spacing = TAU / (32_768.0 * INTERVAL);
    assert!(error((peak / spacing).round() * spacing) > 1e-6);
    // The refined peak alone, in a rectangular window and in Hann windows: the side lobes of the other term disturb it.
    let alone = |order| frequencies_with_window(&samples, INTERVAL, 1, order).expect("samples")[0].frequency;
    assert!(error(alone(0)) > 1e-8, "{:e}", error(alone(0)));
    assert!(error(alone(1)) < error(alone(0)) / 100.0);
    assert!(error(alone(0)) > 1e3 * error(frequencies(&samples, INTERVAL, 2).expect("samples")[0].frequency));
}

#[test]
fn real_and_constant_functions_have_symmetric_and_zero_frequencies() {
    let samples: Vec<[f64; 2]> =
        (0..2_000).map(|index| [3.0 + (0.7 * INTERVAL * f64::from(index) + 0.2).cos(), 0.0]).collect();
    let found = frequencies(&samples, INTERVAL, 5).expect("samples");
    assert_eq!(found.len(), 3);
    assert!(found[0].frequency.abs() < 1e-15 && (found[0].modulus() - 3.0).abs() < 1e-13, "{:?}", found[0]);
    let mut pair = [found[1], found[2]];
    pair.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
    for (line, sign) in pair.iter().zip([-1.0, 1.0]) {
        assert!((line.frequency - sign * 0.7).abs() < 1e-13, "{line:?}");
        assert!((line.modulus() - 0.5).abs() < 1e-13 && (line.phase() - sign * 0.2).abs() < 1e-12, "{line:?}");
    }
    let without_mean: Vec<_> = samples.iter().map(|[re, im]| [re - 3.0, *im]).collect();
    let Drift { frequency, halves, .. } = drift(&without_mean, INTERVAL).expect("samples");
    assert!([frequency, halves[0], halves[1]].iter().all(|found| (found - 0.7).abs() < 1e-12), "{halves:?}");
}

/// A weak term is found beside strong ones, close terms are separated, and scales do not matter.
#[test]
fn weak_close_and_extreme_terms_are_found() {
    let known = |frequency, modulus| Known { frequency, modulus, phase: 1.0 };
    let terms = [known(1.0, 1.0), known(-2.5, 0.5), known(2.0, 1e-9)];
    let [of_frequencies, _] = errors(&frequencies(&sampled(&terms, 4_096), INTERVAL, 8).expect("samples"), &terms);
    // Rounding of the strong terms, relative to the weak one, over the phase of the whole time.
    assert!(of_frequencies < 1e-9, "{of_frequencies:e}");
    let resolution = TAU / (4_096.0 * INTERVAL);
    let close = [known(1.0, 1.0), known(1.0 + 4.0 * resolution, 0.6)];
    let [of_frequencies, of_amplitudes] =
        errors(&frequencies(&sampled(&close, 4_096), INTERVAL, 2).expect("samples"), &close);
    assert!(of_frequencies < 1e-12 && of_amplitudes < 1e-10, "{of_frequencies:e} {of_amplitudes:e}");
    for scale in [1e-310, 1e-300, 1e300, 1e307] {
        let samples: Vec<_> = sampled(&close, 512).iter().map(|sample| sample.map(|part| scale * part)).collect();
        let found = frequencies(&samples, INTERVAL, 2).expect("samples");
        assert!((found[0].frequency - 1.0).abs() < 1e-2 && found[0].modulus() > 0.5 * scale, "{scale:e} {found:?}");
    }
}

#[test]
fn noise_and_nothing_have_finite_lines() {
    let mut next = numbers(3);
    let noise: Vec<[f64; 2]> = (0..999).map(|_| [next() - 0.5, next() - 0.5]).collect();
    for order in [0, 1, 5, 20] {
        let found = frequencies_with_window(&noise, INTERVAL, 12, order).expect("samples");
        assert!(!found.is_empty() && found.len() <= 12, "{order}: {found:?}");
        let limit = PI / INTERVAL * (1.0 + f64::EPSILON);
        assert!(found.iter().all(|line| line.frequency.abs() <= limit && line.modulus().is_finite()), "{found:?}");
        assert!(found.is_sorted_by(|a, b| a.modulus() >= b.modulus()));
    }
    assert_eq!(frequencies(&[[0.0; 2]; 64], INTERVAL, 3), Ok(Vec::new()));
    assert_eq!(frequencies(&noise, INTERVAL, 0), Ok(Vec::new()));
    assert_eq!(drift(&[[0.0; 2]; 64], INTERVAL), Ok(Drift { frequency: 0.0, halves: [0.0; 2] }));
}

#[test]
fn wrong_input_is_an_error() {
    let samples = [[1.0, 0.0]; 64];
    for interval in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-320] {
        let found = frequencies(&samples, interval, 1);
        assert!(matches!(found, Err(CheckError::SampleTime { .. })), "{interval}: {found:?}");
    }
    let too_few = |samples, needed| Err(CheckError::TooFewSamples { samples, needed });
    assert_eq!(frequencies(&samples[..31], 1.0, 1), too_few(31, 32));
    assert_eq!(frequencies(&[], 1.0, 1), too_few(0, 32));
    assert_eq!(frequencies_with_window(&samples, 1.0, 1, 8), too_few(64, 72));
    assert!(frequencies_with_window(&samples, 1.0, 1, u32::MAX).is_err());
    assert!(drift(&samples[..63], 1.0).is_err());
    for wrong in [f64::NAN, f64::INFINITY] {
        let mut samples = samples;
        samples[5][1] = wrong;
        assert_eq!(frequencies(&samples, 1.0, 1), Err(CheckError::SampleNotFinite { index: 5 }));
    }
}

struct Pendulum;

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

/// The frequency of a pendulum of amplitude `a` is `agm(1, cos(a/2))`, from the complete elliptic integral.
#[test]
fn a_pendulum_has_the_frequency_of_the_elliptic_integral() {
    for amplitude in [0.1, 1.0, 2.5] {
        let (mut a, mut b) = (1.0_f64, (amplitude / 2.0_f64).cos());
        for _ in 0..8 {
            (a, b) = ((a + b) / 2.0, (a * b).sqrt());
        }
        let mut run = Pendulum.run_with(Teloy8C, Phase::new([amplitude], [0.0]), 0.05).expect("a run");
        let found = frequencies_of_run(&mut run, 8, 2_048, 6, |state| [state.q[0], state.p[0]]).expect("a run");
        assert_eq!(run.steps(), 8 * 2_047);
        // Positions and momenta turn clockwise.
        assert!((found[0].frequency + a).abs() < 2e-12, "{amplitude}: {:e}", found[0].frequency + a);
    }
}

#[test]
fn runs_report_wrong_intervals_and_fictitious_times() {
    let of_run = |every, samples| {
        let mut run = Pendulum.run_with(Verlet, Phase::new([1.0], [0.0]), 0.1).expect("a run");
        frequencies_of_run(&mut run, every, samples, 1, |state| [state.q[0], state.p[0]])
    };
    assert_eq!(of_run(0, 64), Err(CheckError::Run(Error::SampleInterval)));
    assert_eq!(of_run(1, 0), Err(CheckError::TooFewSamples { samples: 0, needed: 32 }));
    let start = Phase::new([1.0, 0.0], [0.0, 0.8]);
    let pace = Logarithmic::<Verlet>::default();
    let position = |state: &Phase<[f64; 2]>| state.q;
    let mut run = Kepler.run_with(pace, start, 0.1).expect("a run");
    let found = frequencies_of_run(&mut run, 1, 64, 1, position);
    assert!(matches!(found, Err(CheckError::UnequalSteps { .. })), "{found:?}");
    let mut ensemble = Ensemble::new(pace, [(Kepler, start)], 0.1).expect("a start");
    let found = frequency_map(&mut ensemble, 1, 64, |state| [position(state)]).expect("steps");
    assert!(matches!(found[0], Err(CheckError::UnequalSteps { .. })), "{found:?}");
}

struct Kepler;

#[hamiltonian]
impl Kepler {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / (x * x + y * y).sqrt()
    }
}

struct HenonHeiles;

#[hamiltonian]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (x * x + y * y) / 2.0 + x * x * y - y.powi(3) / 3.0
    }
}

/// On the section x = 0 with the energy 1/8: near the centre of an island, and in the chaotic sea. The third escapes.
fn orbits() -> [Phase<[f64; 2]>; 3] {
    let at = |y: f64| Phase::new([0.0, y], [(0.25 - y * y + 2.0 * y.powi(3) / 3.0).sqrt(), 0.0]);
    [at(0.2), at(-0.016), Phase::new([0.0, 0.1], [0.7, 0.1])]
}

fn pairs(state: &Phase<[f64; 2]>) -> [[f64; 2]; 2] {
    [[state.q[0], state.p[0]], [state.q[1], state.p[1]]]
}

#[test]
fn frequencies_drift_on_chaotic_orbits_only() {
    let members = orbits().map(|start| (HenonHeiles, start));
    let mut ensemble = Ensemble::new(BlanesMoanSrkn11, members, 0.2).expect("starts");
    let map = frequency_map(&mut ensemble, 2, 8_192, pairs).expect("steps");
    let [regular, chaotic] = [0, 1].map(|member| map[member].clone().expect("a bounded orbit")[0]);
    assert!(regular.change() < 1e-10 && regular.diffusion() < -10.0, "{regular:?}");
    assert!(chaotic.change() > 1e-4 && chaotic.diffusion() > -4.0, "{chaotic:?}");
    assert!(matches!(&map[2], Err(CheckError::Run(Error::Lost(lost))) if lost.members[0].0 == 2), "{:?}", map[2]);
    // Bitwise the same alone, and on one thread.
    let island = (HenonHeiles, orbits()[0]);
    let mut alone = Ensemble::new(BlanesMoanSrkn11, [island], 0.2).expect("a start").with_threads(1);
    assert_eq!(frequency_map(&mut alone, 2, 8_192, pairs).expect("steps")[0], map[0]);
    // The map of a member that has failed before.
    let again = frequency_map(&mut ensemble, 2, 64, pairs).expect("steps");
    assert!(again[0].is_ok() && again[2] == Err(CheckError::TooFewSamples { samples: 1, needed: 64 }), "{again:?}");
}

#[test]
fn maps_report_wrong_intervals() {
    let ensemble = || Ensemble::new(Verlet, [(HenonHeiles, orbits()[0])], 0.2).expect("a start");
    assert_eq!(frequency_map(&mut ensemble(), 0, 64, pairs), Err(CheckError::Run(Error::SampleInterval)));
    assert_eq!(
        frequency_map(&mut ensemble(), 1, 63, pairs),
        Err(CheckError::TooFewSamples { samples: 63, needed: 64 })
    );
    assert!(matches!(frequency_map(&mut ensemble(), u64::MAX, 64, pairs), Err(CheckError::Run(_))));
}
