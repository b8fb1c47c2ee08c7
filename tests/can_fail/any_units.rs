//! No verdict depends on the units, the zero of the energy, the amplitude, the direction or the origin of time, the order of
//! the coordinates, or a faster motion that the step resolves: neither of right steppers, nor of wrong ones.

use crate::schemes::{EulerThatClaims2, Late, Lopsided, Strong};
use integrator_core::{
    __private::Composition,
    System,
    chaos::indicators,
    check::{
        CertifyError, Goal, Start, branches, certify, choose, energy_drift, monodromy, observed_order, shadow,
        stability, turns_in_time,
    },
    prelude::*,
};

/// How a motion is described.
#[derive(Clone, Copy, Debug)]
struct Seen {
    length: f64,
    momentum: f64,
    energy: f64,
    /// The potential energy where it would be zero.
    zero: f64,
    /// The origin of time.
    begin: f64,
}

/// As the formulas of the test stand.
const PLAIN: Seen = Seen { length: 1.0, momentum: 1.0, energy: 1.0, zero: 0.0, begin: 0.0 };

impl Seen {
    /// The unit of time.
    fn time(&self) -> f64 {
        self.length * self.momentum / self.energy
    }
}

/// Systems from `T` and `V`, each three times: with its coordinates in the order of the first list, in that of the second,
/// and with an oscillator beside them.
macro_rules! seen {
    ($(
        $plain:ident, $renumbered:ident, $beside:ident: $n:literal + 1 = $more:literal,
        [$($q:ident),*], [$($other_q:ident),*], [$($p:ident),*], [$($other_p:ident),*];
        |$self:ident $(, $t:ident)?| $kinetic:expr, $potential:expr;
    )*) => {
        $(
            impl $plain {
                const COUNT: usize = $n;
            }

            seen!(@ $plain, $n, [$($q),*], [$($p),*], |$self $(, $t)?| $kinetic, $potential);
            seen!(@ $renumbered, $n, [$($other_q),*], [$($other_p),*], |$self $(, $t)?| $kinetic, $potential);
            seen!(@ $beside, $more, [$($q,)* fast], [$($p,)* going], |$self $(, $t)?|
                $kinetic + 0.5 * going * going, $potential + 4.5 * fast * fast);
        )*
    };
    (@ $name:ident, $n:literal, [$($q:ident),*], [$($p:ident),*], |$self:ident $(, $t:ident)?| $kinetic:expr, $potential:expr) => {
        struct $name(Seen);

        #[hamiltonian]
        impl $name {
            fn kinetic(&$self, [$($p),*]: [f64; $n]) -> f64 {
                $(let $p = $p / $self.0.momentum;)*
                $self.0.energy * ($kinetic)
            }
            fn potential(&$self, [$($q),*]: [f64; $n] $(, $t: f64)?) -> f64 {
                $(let $t = ($t - $self.0.begin) / ($self.0.length * $self.0.momentum / $self.0.energy);)?
                $(let $q = $q / $self.0.length;)*
                $self.0.zero + $self.0.energy * ($potential)
            }
        }
    };
}

seen! {
    Pendulum, PendulumAgain, PendulumBeside: 1 + 1 = 2, [x], [x], [a], [a]; |self| 0.5 * a * a, -x.cos();
    HenonHeiles, HeilesHenon, HenonHeilesBeside: 2 + 1 = 3, [x, y], [y, x], [a, b], [b, a];
        |self| 0.5 * (a * a + b * b), 0.5 * (x * x + y * y) + x * x * y - y * y * y / 3.0;
    Kepler, KeplerTurned, KeplerBeside: 2 + 1 = 3, [x, y], [y, x], [a, b], [b, a];
        |self| 0.5 * (a * a + b * b), -1.0 / (x * x + y * y).sqrt();
    Toda, TodaReversed, TodaBeside: 3 + 1 = 4, [x, y, z], [z, y, x], [a, b, c], [c, b, a];
        |self| 0.5 * (a * a + b * b + 2.0 * c * c), (x - y).exp() + (y - z).exp() + (z - x).exp();
    Nucleus, NucleusAgain, NucleusBeside: 1 + 1 = 2, [x], [x], [a], [a]; |self| 0.5 * a * a, -5.0 / (1.0 + (x * x - 4.0).exp());
    Bar, BarTurned, BarBeside: 2 + 1 = 3, [x, y], [y, x], [a, b], [b, a];
        |self| 0.5 * (a * a + b * b), 0.5 * (x * x + y * y) + if x > 0.5 { (x - 0.5).powi(12) } else { 0.0 };
    Relativistic, RelativisticAgain, RelativisticBeside: 1 + 1 = 2, [x], [x], [a], [a];
        |self| (1.0 + a * a).sqrt(), 0.25 * x * x * x * x;
    Shaken, ShakenAgain, ShakenBeside: 1 + 1 = 2, [x], [x], [a], [a];
        |self, t| 0.5 * a * a, -(1.0 + 0.3 * (0.9 * t).cos()) * x.cos();
}

/// A verdict on a system, a start, and a step.
#[derive(Debug, PartialEq)]
struct Row {
    of: &'static str,
    verdict: String,
}

/// The reasons for which a stepper is refused, without their numbers; or that it is certified.
fn certificate<H: Hamiltonian<Coords = [f64; N]>, X: Composition<H>, const N: usize>(
    system: &H,
    composition: X,
    start: &Start<[f64; N]>,
    h: f64,
) -> String {
    let kind = |text: String| {
        text.split(|character: char| character.is_ascii_digit() || character == '-').next().map(str::to_owned)
    };
    match certify(system, composition, *start, h) {
        Ok(_) => "certified".to_owned(),
        Err(CertifyError::Refused { shortfalls, .. }) => {
            shortfalls.iter().filter_map(|shortfall| kind(shortfall.to_string())).collect::<Vec<_>>().join(", ")
        }
        Err(error) => error.to_string(),
    }
}

/// The number of certificates among the verdicts on methods, which come first, and of all of these.
const CERTIFICATES: usize = 6;
const METHODS: usize = CERTIFICATES + 1;

/// The verdicts on methods, which are the same for any motion that their steps resolve.
fn of_methods<H: Hamiltonian<Coords = [f64; N]>, const N: usize>(
    system: &H,
    start: &Start<[f64; N]>,
    h: f64,
) -> Vec<Row> {
    let row = |of, verdict| Row { of, verdict };
    let order = observed_order(system, Yoshida4, *start, h).map(|order| order.slope.round());
    vec![
        row("Verlet", certificate(system, Verlet, start, h)),
        row("KahanLi8", certificate(system, KahanLi8, start, h)),
        row("EulerThatClaims2", certificate(system, EulerThatClaims2, start, h)),
        row("Lopsided", certificate(system, Lopsided, start, h)),
        row("Strong", certificate(system, Strong, start, h)),
        row("Late", certificate(system, Late, start, h)),
        row("observed_order", format!("{order:?}")),
    ]
}

/// All verdicts, also those on the motion.
fn verdicts<H: Hamiltonian<Coords = [f64; N]>, const N: usize>(
    system: &H,
    start: &Start<[f64; N]>,
    h: f64,
) -> Vec<Row> {
    let mut rows = of_methods(system, start, h);
    let mut row = |of, verdict| rows.push(Row { of, verdict });
    let found = shadow(system, Verlet, *start, h).map(|shadow| shadow.is_conserved());
    row("shadow", format!("{found:?}"));
    let found = shadow(system, Strong, *start, h).map(|shadow| shadow.is_conserved());
    row("shadow of Strong", format!("{found:?}"));
    let found = energy_drift(system, Verlet, *start, h, 8192).map(|drift| (drift.course, drift.is_bounded()));
    row("energy_drift", format!("{found:?}"));
    // The frequency to six digits: energies are rounded.
    let found = stability(system, Verlet, *start, h).map(|found| (format!("{:.6}", found.share()), found.is_near()));
    row("stability", format!("{found:?}"));
    let found = branches(system, Verlet, *start, h, 200).map(|found| found.crossed.len());
    row("branches", format!("{found:?}"));
    let found = monodromy(system, Verlet, *start, h, 100).map(|found| found.is_stable());
    row("monodromy", format!("{found:?}"));
    let found = indicators(system, Yoshida4, *start, 3.0 * h, 20_000).map(|found| found.verdict);
    row("indicators", format!("{found:?}"));
    row("turns_in_time", format!("{:?}", turns_in_time(system, *start, 100.0 * h)));
    // Compositions with as many evaluations are in the order of their times.
    let found = choose(system, *start, 200.0 * h, Goal::Trajectory(1e-6)).map(|found| {
        let mut chosen: Vec<_> = found.choices().iter().map(|choice| (choice.composition, choice.steps)).collect();
        chosen.sort_unstable();
        chosen
    });
    row("choose", format!("{found:?}"));
    rows
}

/// Asserts that verdicts are the same, or says which are not.
fn assert_same(found: &[Row], expected: &[Row], of: &str) {
    let differ: Vec<_> = found.iter().zip(expected).filter(|(found, expected)| found != expected).collect();
    assert!(differ.is_empty() && found.len() == expected.len(), "{of}: found and expected were {differ:#?}");
}

/// The start of a motion as it is described.
fn start_of<const N: usize>([q, p]: [[f64; N]; 2], seen: Seen, amplitude: f64) -> Start<[f64; N]> {
    let scaled = |numbers: [f64; N], unit: f64| numbers.map(|number| number * amplitude * unit);
    Phase::new(scaled(q, seen.length), scaled(p, seen.momentum)).at_time(seen.begin)
}

/// Other descriptions of the same motion. Powers of two scale every number exactly.
fn others() -> [Seen; 3] {
    let power = |exponent| 2_f64.powi(exponent);
    [
        Seen { length: power(-60), momentum: power(31), energy: power(-77), ..PLAIN },
        Seen { zero: 10.8, ..PLAIN },
        Seen { begin: 100.0, ..PLAIN },
    ]
}

/// Asserts that the verdicts on a system are those on its other descriptions, backwards, in another order of its coordinates,
/// and beside an oscillator; whether they are on a small oscillation, if the origin is an equilibrium.
macro_rules! assert_same_verdicts {
    ($plain:ident, $renumbered:ident, $beside:ident, $q:expr, $p:expr, $h:literal, rests = $rests:literal) => {{
        let (q, p, h) = ($q, $p, $h);
        let plain = verdicts(&$plain(PLAIN), &start_of([q, p], PLAIN, 1.0), h);
        for seen in others() {
            let found = verdicts(&$plain(seen), &start_of([q, p], seen, 1.0), h * seen.time());
            assert_same(&found, &plain, &format!("{seen:?}"));
        }
        let back = p.map(|p: f64| -p);
        assert_same(&verdicts(&$plain(PLAIN), &start_of([q, back], PLAIN, 1.0), -h), &plain, "backwards");
        let (mut turned_q, mut turned_p) = (q, p);
        turned_q.reverse();
        turned_p.reverse();
        let found = verdicts(&$renumbered(PLAIN), &start_of([turned_q, turned_p], PLAIN, 1.0), h);
        assert_same(&found, &plain, "renumbered");
        let (mut more_q, mut more_p) = ([0.05; $plain::COUNT + 1], [0.03; $plain::COUNT + 1]);
        more_q[..q.len()].copy_from_slice(&q);
        more_p[..p.len()].copy_from_slice(&p);
        let methods = &plain[..METHODS];
        let found = of_methods(&$beside(PLAIN), &start_of([more_q, more_p], PLAIN, 1.0), h);
        assert_same(&found, methods, "beside an oscillator");
        if $rests {
            assert_same(
                &of_methods(&$plain(PLAIN), &start_of([q, p], PLAIN, 1e-8), h),
                methods,
                "of a small amplitude",
            );
        }
        // So that equal verdicts are not those of checks that always pass, or never.
        for Row { of, verdict } in &methods[..CERTIFICATES] {
            let is_right = ["Verlet", "KahanLi8"].contains(of) || (*of == "Late" && <$plain as System>::AUTONOMOUS);
            assert_eq!(verdict == "certified", is_right, "{of}: {verdict}");
        }
    }};
}

#[test]
fn of_a_pendulum() {
    assert_same_verdicts!(Pendulum, PendulumAgain, PendulumBeside, [1.0], [0.3], 0.05, rests = true);
}

#[test]
fn of_henon_and_heiles() {
    assert_same_verdicts!(HenonHeiles, HeilesHenon, HenonHeilesBeside, [0.1, -0.2], [0.3, 0.25], 0.05, rests = true);
}

#[test]
fn of_an_ellipse() {
    assert_same_verdicts!(Kepler, KeplerTurned, KeplerBeside, [1.0, 0.1], [0.0, 0.8], 0.02, rests = false);
}

#[test]
fn of_a_chain() {
    // At 1e-8 of this amplitude forces are differences of numbers near one.
    assert_same_verdicts!(Toda, TodaReversed, TodaBeside, [0.3, -0.2, 0.1], [0.2, 0.1, -0.3], 0.05, rests = true);
}

#[test]
fn of_a_potential_that_falls_off() {
    assert_same_verdicts!(Nucleus, NucleusAgain, NucleusBeside, [1.0], [0.3], 0.05, rests = false);
}

#[test]
fn of_a_potential_in_pieces() {
    assert_same_verdicts!(Bar, BarTurned, BarBeside, [0.3, -0.2], [0.6, 0.5], 0.05, rests = true);
}

#[test]
fn of_a_relativistic_oscillator() {
    assert_same_verdicts!(Relativistic, RelativisticAgain, RelativisticBeside, [1.5], [0.5], 0.05, rests = false);
}

#[test]
fn of_a_shaken_pendulum() {
    assert_same_verdicts!(Shaken, ShakenAgain, ShakenBeside, [1.0], [0.3], 0.05, rests = true);
}
