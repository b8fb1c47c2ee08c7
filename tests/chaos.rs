//! Exponents and indicators of chaos against published numbers and closed forms.

#[path = "support/comet.rs"]
mod comet;
#[path = "support/instruction_sets.rs"]
mod instruction_sets;

use comet::Comet;
use integrator_core::{
    Differentiable,
    chaos::{self, End, Indicator, Spectrum, Verdict},
    check::{CheckError, monodromy},
    prelude::*,
};
use std::f64::consts::{PI, TAU};

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

/// A start on the section x = 0 with an energy of 1/8.
fn on_section(y: f64, py: f64) -> Phase<[f64; 2]> {
    let square = 2.0 * (0.125 - y * y / 2.0 + y.powi(3) / 3.0) - py * py;
    Phase::new([0.0, y], [square.sqrt(), py])
}

/// Chirikov's standard map, as a step of one unit of time: `p' = p + K sin q`, `q' = q + p'`.
struct StandardMap {
    strength: f64,
}

#[hamiltonian]
impl StandardMap {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.strength * q[0].cos()
    }
}

struct Oscillators;

#[hamiltonian]
impl Oscillators {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        (q[0] * q[0] + 2.0 * q[1] * q[1]) / 2.0
    }
}

/// A saddle in one direction, a well in the other.
struct Saddle;

#[hamiltonian]
impl Saddle {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        (q[1] * q[1] - 0.09 * q[0] * q[0]) / 2.0
    }
}

#[test]
fn the_galaxy_of_henon_and_heiles_has_the_orbits_that_are_published() {
    // Skokos 2001, J. Phys. A 34, 10029, figures 5 and 6: a regular orbit and a chaotic one on the section x = 0 of the
    // energy 1/8.
    let regular =
        chaos::indicators(&HenonHeiles, BlanesMoanSrkn11, on_section(0.55, 0.0), 0.2, 25_000).expect("an orbit");
    let chaotic =
        chaos::indicators(&HenonHeiles, BlanesMoanSrkn11, on_section(-0.016, 0.0), 0.2, 25_000).expect("an orbit");
    assert_eq!((regular.verdict, chaotic.verdict), (Verdict::Regular, Verdict::Chaotic), "{regular}, {chaotic}");
    // On a torus MEGNO swings about 2, exponents fall like ln t / t, and the smaller alignment index stays of order one;
    // the volumes of three and four vectors fall like 1/t² and 1/t⁴ (Skokos, Bountis and Antonopoulos 2007).
    assert!((regular.mean_megno - 2.0).abs() < 0.2, "{regular:?}");
    assert!(regular.exponent < 2.0 * 5000.0_f64.ln() / 5000.0 && regular.sali > 1e-2, "{regular:?}");
    let time = regular.time;
    let scaled = [regular.gali[1] * time.powi(2), regular.gali[2] * time.powi(4)];
    assert!((1.0..1e3).contains(&scaled[0]) && (1.0..1e6).contains(&scaled[1]), "{scaled:?}");
    // The exponent at this energy is about 0.045; the alignment indices fall exponentially.
    assert!((0.03..0.07).contains(&chaotic.exponent), "{chaotic:?}");
    assert!(chaotic.sali < 1e-10 && chaotic.gali[0] < 1e-10, "{chaotic:?}");
    assert!(chaotic.mean_megno > 20.0 && chaotic.fli > 100.0, "{chaotic:?}");
    let text = [regular, chaotic].map(|indicators| indicators.to_string());
    assert!(text[0].starts_with("regular: ") && text[1].starts_with("chaotic: "), "{text:?}");
}

#[test]
fn one_vector_has_the_indicators_that_it_has_among_several() {
    for (start, steps) in
        [(on_section(0.55, 0.0), 25_000), (on_section(-0.016, 0.0), 25_000), (on_section(0.1, 0.0), 100)]
    {
        let all = chaos::indicators(&HenonHeiles, BlanesMoanSrkn11, start, 0.2, steps).expect("an orbit");
        let one = chaos::megno(&HenonHeiles, BlanesMoanSrkn11, start, 0.2, steps).expect("an orbit");
        assert_eq!(
            [one.exponent, one.megno, one.mean_megno, one.fli, one.ofli, one.time],
            [all.exponent, all.megno, all.mean_megno, all.fli, all.ofli, all.time]
        );
        assert_eq!((one.verdict, one.to_string()), (all.verdict, all.to_string()));
    }
}

/// A pendulum, all of whose orbits but one pair are periodic.
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

#[test]
fn neighbours_of_a_periodic_orbit_leave_along_it() {
    // A neighbour of another period runs ahead, in proportion to time: 200 periods are some hundred times as far. What is
    // orthogonal to the orbit comes back after each period.
    let periodic =
        chaos::indicators(&Pendulum, BlanesMoanSrkn11, Phase::new([2.0], [0.0]), 0.1, 16_000).expect("an orbit");
    assert!(periodic.fli > 4.0 && periodic.ofli < 2.0, "{periodic:?}");
    // On a chaotic orbit both grow at its exponent: what is orthogonal is a part of the order of one.
    let chaotic =
        chaos::indicators(&HenonHeiles, BlanesMoanSrkn11, on_section(-0.016, 0.0), 0.2, 25_000).expect("an orbit");
    assert!(chaotic.ofli > 100.0 && (chaotic.ofli - chaotic.fli).abs() < 5.0, "{chaotic:?}");
    // Implicit steps of the same H in one piece have a field of their own text.
    let whole = chaos::indicators(&Whole, GaussLegendre4, Phase::new([2.0], [0.0]), 0.1, 4_000).expect("an orbit");
    assert!(whole.fli > 3.0 && whole.ofli < 2.0, "{whole:?}");
}

/// The chain of Fermi, Pasta, Ulam and Tsingou with the force `x + x³` of each spring, between walls.
struct Chain;

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() - 1 {
            let stretch = q[i + 1] - q[i];
            energy += stretch * stretch / 2.0 + stretch.powi(4) / 4.0;
        }
        energy + (q[0] * q[0] + q[q.len() - 1] * q[q.len() - 1]) / 2.0
    }
}

#[test]
fn a_chain_is_chaotic_where_its_energy_is_high() {
    let sites = 8_usize;
    let start = |amplitude: f64| {
        let mode = |i: usize| amplitude * (PI * (i + 1) as f64 / (sites + 1) as f64).sin();
        Phase::new((0..sites).map(mode).collect::<Vec<_>>(), vec![0.0; sites])
    };
    // In its lowest mode: weakly, the chain comes back (Fermi, Pasta and Ulam 1955), and strongly, above the threshold of
    // Izrailev and Chirikov (1966), its modes overlap.
    let weak = chaos::indicators(&Chain, BlanesMoanSrkn11, start(0.1), 0.2, 3_000).expect("an orbit");
    let strong = chaos::indicators(&Chain, BlanesMoanSrkn11, start(10.0), 0.05, 4_000).expect("an orbit");
    assert_eq!((weak.verdict, strong.verdict), (Verdict::Regular, Verdict::Chaotic), "{weak}, {strong}");
    assert!(strong.exponent > 0.05 && weak.exponent < 0.01, "{weak:?}, {strong:?}");
}

#[test]
fn the_standard_map_stretches_as_chirikov_says() {
    // Chirikov 1979, Phys. Rep. 52, 263: the exponent of the chaotic sea is ln(K/2) for large K.
    for strength in [5.0, 10.0] {
        let map = StandardMap { strength };
        let start = Phase::new([0.3], [0.4]);
        let Spectrum { exponents, uncertainties, .. } =
            chaos::lyapunov_spectrum(&map, Euler, start, 1.0, 30_000).expect("an orbit");
        let asymptotic = (strength / 2.0).ln();
        assert!((exponents[0] / asymptotic - 1.0).abs() < 0.1, "K = {strength}: {exponents:?}");
        assert!(uncertainties[0] < 0.02, "K = {strength}: known to {uncertainties:?}");
    }
    // About the stable fixed point a circle, for a K below and above that of the last torus.
    for strength in [0.6, 0.971635] {
        let map = StandardMap { strength };
        let regular = chaos::indicators(&map, Euler, Phase::new([PI + 0.3], [0.0]), 1.0, 5_000).expect("an orbit");
        assert_eq!(regular.verdict, Verdict::Regular, "K = {strength}: {regular:?}");
    }
    // Near the unstable one the thin chaotic layer of K = 0.971635.
    let map = StandardMap { strength: 0.971635 };
    let chaotic = chaos::indicators(&map, Euler, Phase::new([1e-3], [0.0]), 1.0, 5_000).expect("an orbit");
    assert_eq!(chaotic.verdict, Verdict::Chaotic, "{chaotic:?}");
}

#[test]
fn exponents_of_a_saddle_are_its_rates() {
    let (h, steps) = (0.1_f64, 10_000);
    let start = Phase::new([0.0, 0.1], [0.0, 0.0]);
    let spectrum = chaos::lyapunov_spectrum(&Saddle, Verlet, start, h, steps).expect("an orbit");
    // A step of Verlet on the saddle has the trace 2 + (0.3 h)², whose larger eigenvalue is the growth of a step.
    let half_trace = 1.0 + (0.3 * h).powi(2) / 2.0;
    let rate = (half_trace + (half_trace * half_trace - 1.0).sqrt()).ln() / h;
    // The first vectors are not the eigenvectors, which costs a factor of order one once.
    let bound = 3.0 / (h * steps as f64);
    for (measured, exact) in spectrum.exponents.iter().zip([rate, 0.0, 0.0, -rate]) {
        assert!((measured - exact).abs() < bound, "{:?} are not ±{rate} and 0", spectrum.exponents);
    }
    // Every orthogonalisation rounds lengths by some ulps, and so does every step.
    assert!(spectrum.sum().abs() < 1e3 * f64::EPSILON / h, "{}", spectrum.sum());
    assert!(spectrum.pairing() < bound, "{}", spectrum.pairing());
}

#[test]
fn exponents_of_a_chaotic_orbit_come_in_pairs() {
    let spectrum = chaos::lyapunov_spectrum(&HenonHeiles, BlanesMoanSrkn11, on_section(-0.016, 0.0), 0.2, 20_000)
        .expect("an orbit");
    let [first, second, third, last] = spectrum.exponents[..] else { panic!("four exponents: {spectrum:?}") };
    assert!((0.03..0.07).contains(&first) && first > 10.0 * second.abs(), "{spectrum:?}");
    assert!(spectrum.sum().abs() < 1e-10 && spectrum.pairing() < 2e-3 && third.abs() < 2e-3, "{spectrum:?}");
    assert!((first + last).abs() < 2.0 * spectrum.uncertainties[0], "{spectrum:?}");
    // The largest exponent is the rate that one vector grows at.
    let one =
        chaos::indicators(&HenonHeiles, BlanesMoanSrkn11, on_section(-0.016, 0.0), 0.2, 20_000).expect("an orbit");
    assert!((one.exponent - first).abs() < 1e-3, "{} and {first}", one.exponent);
}

#[test]
fn a_map_has_the_numbers_of_its_orbits_alone() {
    let starts: Vec<_> = (0..21).map(|i| on_section(-0.3 + 0.04 * f64::from(i), 0.05)).collect();
    let steps = 2_000;
    let megno = chaos::map(&HenonHeiles, Yoshida4, starts.clone(), 0.2, steps, Indicator::Megno).expect("starts");
    let exponents =
        chaos::map(&HenonHeiles, Yoshida4, starts.clone(), 0.2, steps, Indicator::Exponent).expect("starts");
    let fli = chaos::map(&HenonHeiles, Yoshida4, starts.clone(), 0.2, steps, Indicator::Fli).expect("starts");
    for (i, start) in starts.into_iter().enumerate() {
        let alone = chaos::indicators(&HenonHeiles, Yoshida4, start, 0.2, steps).expect("an orbit");
        // Runs on machines with fused multiply-add have the bits of members; elsewhere, too.
        assert_eq!([megno[i], exponents[i], fli[i]], [alone.mean_megno, alone.exponent, alone.fli], "orbit {i}");
    }
}

#[test]
fn a_chaotic_orbit_changes_no_bit_of_a_regular_one_beside_it() {
    // The vector of the sea grows beyond 2^256 and is divided, that of the island is not.
    let map = StandardMap { strength: 2.0 };
    let starts = [PI + 0.1, 0.3, PI + 0.2, 0.4, PI - 0.3].map(|q| Phase::new([q], [0.0]));
    let megno = chaos::map(&map, Euler, starts, 1.0, 2_000, Indicator::Megno).expect("starts");
    let fli = chaos::map(&map, Euler, starts, 1.0, 2_000, Indicator::Fli).expect("starts");
    assert!(fli[1] > 256.0 && fli[0] < 20.0, "{fli:?}");
    for (i, start) in starts.into_iter().enumerate() {
        let alone = chaos::indicators(&map, Euler, start, 1.0, 2_000).expect("an orbit");
        assert_eq!([megno[i], fli[i]], [alone.mean_megno, alone.fli], "orbit {i}");
    }
    // Vectors that are shown only once the processor is undone.
    let megno = chaos::map(&map, BlanesCasasMurua6S11, starts, 1.0, 200, Indicator::Megno).expect("starts");
    for (i, start) in starts.into_iter().enumerate() {
        let alone = chaos::indicators(&map, BlanesCasasMurua6S11, start, 1.0, 200).expect("an orbit");
        assert_eq!(megno[i], alone.mean_megno, "orbit {i}");
    }
}

/// A pendulum in one piece.
#[derive(Clone)]
struct Whole;

#[hamiltonian(split = none, compose = GaussLegendre4)]
impl Whole {
    fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0 - q[0].cos()
    }
}

#[test]
fn steps_that_cannot_be_solved_end_an_orbit() {
    let start = |q: f64| Phase::new([q], [1.9]);
    let found = chaos::map(&Whole, GaussLegendre4, [0.1, 1.0, 2.0].map(start), 1e6, 100, Indicator::Fli);
    assert_eq!(found.expect("starts").len(), 3);
}

#[test]
fn failed_orbits_change_no_other() {
    // Beyond the three saddles orbits fall to minus infinity, in some tens of units of time.
    let inside = on_section(0.1, 0.05);
    let outside = Phase::new([0.0, 1.5], [0.0, 0.5]);
    let alone = chaos::map(&HenonHeiles, Yoshida4, [inside], 0.2, 1_000, Indicator::Megno).expect("a start");
    let mixed = chaos::map(
        &HenonHeiles,
        Yoshida4,
        [outside, inside, outside, outside, inside, outside, inside, outside, outside, outside],
        0.2,
        1_000,
        Indicator::Megno,
    );
    let mixed = mixed.expect("starts");
    for (orbit, value) in mixed.iter().enumerate() {
        let lost = ![1, 4, 6].contains(&orbit);
        assert!(lost != (*value == alone[0]), "orbit {orbit} has {value}, alone {}", alone[0]);
        assert_eq!(lost.then_some(*value), lost.then_some(mixed[0]), "all that are lost are alike");
    }
}

#[test]
fn a_periodic_orbit_has_the_multipliers_of_its_closed_form() {
    // Two oscillators, of which one is at rest: after the period of the other its phase has advanced by 2π√2.
    let period = 1_000;
    let found =
        monodromy(&Oscillators, BlanesMoanSrkn11, Phase::new([1.0, 0.0], [0.0, 0.0]), TAU / period as f64, period)
            .expect("an orbit");
    assert!(found.is_stable() && found.gap < 1e-10, "{found}");
    let phase = TAU * 2.0_f64.sqrt();
    let of_other = found
        .multipliers
        .iter()
        .filter(|m| (m.re - phase.cos()).abs() < 1e-8 && (m.im.abs() - phase.sin().abs()).abs() < 1e-8);
    assert_eq!(of_other.count(), 2, "{found}");
    let ones =
        found.multipliers.iter().filter(|m| (m.re - 1.0).abs() < found.uncertainty && m.im.abs() < found.uncertainty);
    assert_eq!(ones.count(), 2, "{found}");

    let saddle = monodromy(&Saddle, BlanesMoanSrkn11, Phase::new([0.0, 1.0], [0.0, 0.0]), TAU / 1000.0, 1_000)
        .expect("an orbit");
    assert!(!saddle.is_stable() && saddle.to_string().starts_with("unstable"), "{saddle}");
    assert!((saddle.multipliers[0].re / (0.3 * TAU).exp() - 1.0).abs() < 1e-9, "{saddle}");
}

/// Whatever time a method has of its own, the growth of differences at equal times is that of the flow.
#[test]
fn methods_in_fictitious_time_measure_the_growth_at_equal_times() {
    fn holds<X: Differentiable<Comet>>(name: &str, method: X, h: f64) {
        let comet = Phase::new([0.4, 0.1], [-0.2, 1.6]);
        let report = chaos::indicators(&Comet, method, comet, h, 320).expect("an orbit");
        // The same time in equal steps, fifty of them in each passage of the centre.
        let steps = (report.time / 0.002).round();
        let equal = chaos::indicators(&Comet, SofroniouSpaletta8, comet, report.time / steps, steps as u64);
        let equal = equal.expect("an orbit");
        // Both are of eighth order at errors of some 1e-9, which a neighbour's time turns into as much of its growth; the
        // uncorrected difference is off by a multiple of the motion itself.
        for (of, own, other) in [
            ("exponent", report.exponent, equal.exponent),
            ("sali", report.sali, equal.sali),
            ("gali", report.gali[2], equal.gali[2]),
        ] {
            assert!((own - other).abs() < 1e-6, "{name}: {of} is {own}, and {other} in equal steps");
        }
        // Some revolutions may be too few for a verdict.
        assert_ne!(report.verdict, Verdict::Chaotic, "{name}: {report}");
    }
    holds("logarithmic", Logarithmic(SofroniouSpaletta8), 0.05);
    holds("a pace", Paced(SofroniouSpaletta8), 0.05);
    holds("polynomials", Taylor::tolerance(1e-14), 0.05);
}

#[test]
fn orbits_without_enough_information_are_refused() {
    let start = on_section(0.1, 0.0);
    let few = CheckError::TooFewSteps { steps: 3, needed: 16 };
    assert_eq!(chaos::indicators(&HenonHeiles, Verlet, start, 0.1, 3), Err(few.clone()));
    assert_eq!(chaos::megno(&HenonHeiles, Verlet, start, 0.1, 3), Err(few.clone()));
    assert_eq!(chaos::lyapunov_spectrum(&HenonHeiles, Verlet, start, 0.1, 3), Err(few.clone()));
    assert_eq!(chaos::map(&HenonHeiles, Verlet, [start], 0.1, 3, Indicator::Fli), Err(few));
    assert_eq!(monodromy(&HenonHeiles, Verlet, start, 0.1, 0), Err(CheckError::TooFewSteps { steps: 0, needed: 1 }));
    let growing = monodromy(&Saddle, Verlet, Phase::new([0.0, 0.1], [0.0, 0.0]), 0.1, 25_000);
    assert_eq!(growing, Err(CheckError::Growth { steps: 25_000 }));
    let bad = Phase::new([f64::NAN, 0.0], [0.0, 0.0]);
    let error =
        chaos::map(&HenonHeiles, Verlet, [start, bad], 0.1, 100, Indicator::Fli).expect_err("a start that is NaN");
    assert!(error.to_string().starts_with("member 1: the initial state is not finite"), "{error}");
    let none: [Phase<[f64; 2]>; 0] = [];
    assert_eq!(chaos::map(&HenonHeiles, Verlet, none, 0.1, 100, Indicator::Fli), Ok(vec![]));
}

/// A saddle whose step is exact however long it is.
struct Exact;

#[hamiltonian(split = quadratic + rest)]
impl Exact {
    fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0] - 0.5 * q[0] * q[0] + 0.0 * q[0].powi(4)
    }
}

/// The exponents are 1 and -1, or the error that says that a step is too long: never other numbers.
#[test]
fn exponents_of_a_long_step_are_right_or_refused() {
    for h in [0.1, 1.0, 5.0, 10.0, 12.0, 14.0, 15.0, 16.0, 17.0, 18.0, 19.0, 20.0, 24.0, 30.0, 100.0, 300.0] {
        match chaos::lyapunov_spectrum(&Exact, Verlet, Phase::new([0.0], [0.0]), h, 1_600) {
            Ok(Spectrum { exponents, .. }) => {
                // The shorter vector has a relative error of e^2h roundings, up to a thousandth, in each of its steps.
                let allowed = 1e-3 / h + 1e-9;
                let errors = [exponents[0] - 1.0, exponents[1] + 1.0];
                assert!(h < 16.0 && errors.iter().all(|error| error.abs() < allowed), "h = {h}: {exponents:?}");
            }
            Err(CheckError::LongForExponents { step, factor, shorter }) => {
                assert!(h > 12.0 && step == h && factor > 1e12, "{factor} at {h}");
                assert!(
                    chaos::lyapunov_spectrum(&Exact, Verlet, Phase::new([0.0], [0.0]), shorter.min(5.0), 1_600).is_ok()
                );
            }
            Err(error) => panic!("h = {h}: {error}"),
        }
    }
}

#[test]
fn a_verdict_needs_enough_time() {
    // The exponents are 0.3 and about 0.045: at a mean MEGNO of 4, after some 27 and 180 units of time.
    for (steps, expected) in
        [(16, Verdict::Undecided), (400, Verdict::Undecided), (1_000, Verdict::Undecided), (6_000, Verdict::Chaotic)]
    {
        let found =
            chaos::indicators(&Saddle, Verlet, Phase::new([0.0, 0.0], [0.0, 0.0]), 0.01, steps).expect("an orbit");
        assert_eq!(found.verdict, expected, "{steps}: {found}");
    }
    for steps in [16, 100, 300, 1_000, 10_000] {
        let found = chaos::indicators(&HenonHeiles, BlanesMoanSrkn11, on_section(-0.016, 0.0), 0.2, steps);
        let found = found.expect("an orbit");
        let expected = if steps < 1_000 { Verdict::Undecided } else { Verdict::Chaotic };
        assert!(
            found.verdict == expected || (steps == 1_000 && found.verdict == Verdict::Undecided),
            "{steps}: {found}"
        );
        assert!(found.to_string().starts_with(if found.verdict == Verdict::Chaotic { "chaotic" } else { "undecided" }));
    }
}

/// A density on a half line: left of zero, forces are finite and energies are not numbers.
#[derive(Clone)]
struct Gamma {
    shape: f64,
}

#[hamiltonian]
impl Gamma {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] - self.shape * q[0].ln()
    }
}

#[test]
fn an_orbit_without_an_energy_is_named() {
    let start = |p: f64| Phase::new([0.02], [p]);
    let gamma = Gamma { shape: 0.1 };
    let refused = chaos::indicators(&gamma, Verlet, start(-3.0), 0.1, 64);
    assert!(matches!(&refused, Err(CheckError::Run(Error::NoEnergy { energy, .. })) if energy.is_nan()), "{refused:?}");
    let starts = [-3.0, 0.01, -3.0].map(|p| Phase::new([if p < 0.0 { 0.02 } else { 0.1 }], [p]));
    let found = chaos::map(&gamma, Verlet, starts, 0.01, 640, Indicator::Megno).expect("starts");
    let followed = chaos::map_while(&gamma, Verlet, starts, 0.01, 640, Indicator::Megno, |_| true).expect("starts");
    assert_eq!(found.iter().map(|value: &f64| value.is_nan()).collect::<Vec<_>>(), [true, false, true]);
    let ends: Vec<_> = followed.iter().map(|orbit| orbit.end.clone()).collect();
    assert_eq!(ends, [End::NoEnergy, End::Followed, End::NoEnergy]);
    assert_eq!(followed[1].value, found[1]);
}

/// A ring of magnets, out of which particles are lost.
struct Ring;

#[hamiltonian]
impl Ring {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        p[2] - ((1.0 + p[2]).powi(2) - p[0] * p[0] - p[1] * p[1]).sqrt()
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        0.2 * (q[0] * q[0] + q[1] * q[1]) + (q[0].powi(3) - 3.0 * q[0] * q[1] * q[1]) / 6.0 + 0.0 * q[2]
    }
}

/// A map names the orbits that are lost, ejected or refused, whoever shares their lanes; the others have the bits of a map without
/// them.
#[test]
fn failed_orbits_of_a_map_are_distinguished_from_regular_ones() {
    let start =
        |i: u32| Phase::new([0.05 * f64::from(i), 0.02, 0.0], [0.0, 0.01, if i == 3 { f64::NAN } else { 1e-4 }]);
    let (h, steps) = (0.2, 2_000);
    let within = |state: &Phase<[f64; 3]>| state.q[0].hypot(state.q[1]) < 1.5;
    let found =
        chaos::map_while(&Ring, Yoshida4, (0..37).map(start), h, steps, Indicator::Megno, within).expect("a step");
    let open =
        chaos::map_while(&Ring, Yoshida4, (0..37).map(start), h, steps, Indicator::Megno, |_| true).expect("a step");
    let regular = (0..37).filter(|i| matches!(found[*i as usize].end, End::Followed)).map(start);
    let alone = chaos::map(&Ring, Yoshida4, regular, h, steps, Indicator::Megno).expect("starts");
    let mut alone = alone.into_iter();
    let mut counts = [0; 3];
    for (i, (orbit, open)) in (0..).zip(found.iter().zip(&open)) {
        if i == 3 {
            assert!(matches!(orbit.end, End::Refused(Error::Start { .. })) && orbit.value.is_nan(), "{orbit:?}");
            continue;
        }
        let mut run = Ring.run_with(Yoshida4, start(i), h).expect("a start");
        let goes_on = run.advance(steps).is_ok();
        assert_eq!(matches!(open.end, End::Followed), goes_on, "{i}: {open:?}");
        match &orbit.end {
            End::Followed => {
                assert!(goes_on && orbit.time == h * steps as f64, "{i}: {orbit:?}");
                assert_eq!(Some(orbit.value), alone.next(), "{i}");
                assert_eq!(orbit.value, open.value, "{i}");
                counts[0] += 1;
            }
            // Steps of a time that is shorter than that in which a particle moves by its distance.
            End::Gone => {
                assert!(orbit.time < h * steps as f64, "{i}: {orbit:?}");
                counts[1] += 1;
            }
            end => {
                assert_eq!(*end, End::Lost, "{i}");
                assert!(!goes_on);
                counts[2] += 1;
            }
        }
    }
    assert!(counts[0] > 5 && counts[1] > 0 && counts[2] > 5, "{counts:?}");
    let refused = chaos::map(&Ring, Yoshida4, [3, 1, 3, 2].map(start), h, steps, Indicator::Megno);
    let Err(CheckError::Run(Error::Members { members, count: 4 })) = refused else { panic!("{refused:?}") };
    assert_eq!(members.iter().map(|(member, _)| *member).collect::<Vec<_>>(), [0, 2]);
}
