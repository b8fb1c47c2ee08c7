//! Generated steppers do, bit for bit, what a person would write out.
//!
//! Each is a plain loop over `f64` with the stages of neighbouring steps merged. On machines with fused multiply-add
//! the hand-written stepper uses it where an expert would; `instruction_sets` runs these tests on the baseline too.

use crate::systems::{Chain, HenonHeiles, Kepler, Pendulum, State};
use integrator_core::{
    __private::{Fused, Real},
    InstructionSet,
    prelude::*,
};

const STEPS: u64 = 3000;

/// `a·b + c`, with one rounding or with two as the instruction set has it.
fn fma(a: f64, b: f64, c: f64) -> f64 {
    match InstructionSet::chosen() {
        InstructionSet::Baseline => a * b + c,
        InstructionSet::Fused | InstructionSet::Avx512 => a.mul_add(b, c),
    }
}

/// The library's own sine, which `std` has not.
fn sin(x: f64) -> f64 {
    match InstructionSet::chosen() {
        InstructionSet::Baseline => Real::sin(x),
        InstructionSet::Fused | InstructionSet::Avx512 => Real::sin(Fused::<f64>::new(x)).lane(0),
    }
}

fn generated<H: Hamiltonian<Coords = [f64; N]>, X: Composition<H>, const N: usize>(
    system: &H,
    composition: X,
    (q, p): State<N>,
    h: f64,
) -> State<N> {
    let mut run = system.run_with::<f64, X>(composition, Phase::new(q, p), h).expect("an admissible start");
    run.advance(STEPS).expect("finite");
    let state = run.state();
    (state.q, state.p)
}

/// The very same, but for AVX-512, where 1/r³ has a kernel that is off by two ulp at most. What a kick is off by grows
/// with the time since, no faster than STEPS times, and there are STEPS kicks of h times a pull below ten.
fn same_orbit((q, p): State<2>, expected: State<2>, h: f64) {
    if InstructionSet::chosen() != InstructionSet::Avx512 {
        assert_eq!((q, p), expected);
        return;
    }
    let limit = 2.0 * f64::EPSILON * 10.0 * h * (STEPS as f64).powi(2);
    for (by_hand, generated) in q.iter().chain(&p).zip(expected.0.iter().chain(&expected.1)) {
        assert!((by_hand - generated).abs() < limit, "{by_hand} for {generated}");
    }
}

#[test]
fn the_pendulum_by_yoshida() {
    let system = Pendulum { mass: 1.7, length: 0.6, gravity: 9.81 };
    let (mut q, mut p, h) = (2.0, 0.3, 0.01);
    let expected = generated(&system, Yoshida4, ([q], [p]), h);

    let per_inertia = 2.0 / (2.0 * system.mass * system.length.powi(2));
    let weight = -system.mass * system.gravity * system.length;
    // g = 1/(2 - cbrt 2): kicks of g, 1 - 2g and g; drifts of g/2, (1 - g)/2, (1 - g)/2 and g/2.
    let (outer, inner) = (1.3512071919596575, -1.7024143839193153);
    let (half, middle) = (0.6756035959798288, -0.17560359597982883);
    let drift = |q: &mut f64, p: f64, a: f64| *q = fma(h * a * per_inertia, p, *q);
    let kick = |p: &mut f64, q: f64, b: f64| *p = fma(-(-(h * b) * weight), sin(q), *p);

    for step in 0..STEPS {
        drift(&mut q, p, if step == 0 { half } else { outer });
        kick(&mut p, q, outer);
        drift(&mut q, p, middle);
        kick(&mut p, q, inner);
        drift(&mut q, p, middle);
        kick(&mut p, q, outer);
    }
    drift(&mut q, p, half);
    assert_eq!(([q], [p]), expected);
}

#[test]
fn the_galaxy_by_verlet() {
    let (mut x, mut y, mut px, mut py, h) = (0.3, -0.2, 0.1, 0.35, 0.05);
    let expected = generated(&HenonHeiles, Verlet, ([x, y], [px, py]), h);

    for step in 0..STEPS {
        let duration = if step == 0 { h * 0.5 } else { h };
        x = fma(duration, px, x);
        y = fma(duration, py, y);
        px = fma(-h * 2.0 * x, y + 0.5, px);
        py = fma(-h, y + fma(-y, y, x * x), py);
    }
    x = fma(h * 0.5, px, x);
    y = fma(h * 0.5, py, y);
    assert_eq!(([x, y], [px, py]), expected);
}

/// Seventeen kicks, all written out.
#[test]
fn the_galaxy_by_kahan_and_li() {
    let (mut x, mut y, mut px, mut py, h) = (0.3, -0.2, 0.1, 0.35, 0.25);
    let expected = generated(&HenonHeiles, KahanLi8, ([x, y], [px, py]), h);

    let drift = |x: &mut f64, y: &mut f64, px: f64, py: f64, a: f64| {
        *x = fma(h * a, px, *x);
        *y = fma(h * a, py, *y);
    };
    let kick = |x: f64, y: f64, px: &mut f64, py: &mut f64, b: f64| {
        *px = fma(-(h * b) * 2.0 * x, y + 0.5, *px);
        *py = fma(-(h * b), y + fma(-y, y, x * x), *py);
    };
    for step in 0..STEPS {
        drift(&mut x, &mut y, px, py, if step == 0 { 0.06510124154444503 } else { 0.13020248308889007 });
        kick(x, y, &mut px, &mut py, 0.13020248308889007);
        drift(&mut x, &mut y, px, py, 0.3456827324319992);
        kick(x, y, &mut px, &mut py, 0.5611629817751084);
        drift(&mut x, &mut y, px, py, 0.08584400956513055);
        kick(x, y, &mut px, &mut py, -0.38947496264484727);
        drift(&mut x, &mut y, px, py, -0.11531652804484584);
        kick(x, y, &mut px, &mut py, 0.1588419065551556);
        drift(&mut x, &mut y, px, py, -0.11853099378904099);
        kick(x, y, &mut px, &mut py, -0.39590389413323757);
        drift(&mut x, &mut y, px, py, -0.10568212657746094);
        kick(x, y, &mut px, &mut py, 0.1845396409783157);
        drift(&mut x, &mut y, px, py, 0.22145701433231887);
        kick(x, y, &mut px, &mut py, 0.25837438768632204);
        drift(&mut x, &mut y, px, py, 0.27669305564781616);
        kick(x, y, &mut px, &mut py, 0.2950117236093103);
        drift(&mut x, &mut y, px, py, -0.15524840511036211);
        kick(x, y, &mut px, &mut py, -0.6055085338300346);
        drift(&mut x, &mut y, px, py, -0.15524840511036211);
        kick(x, y, &mut px, &mut py, 0.2950117236093103);
        drift(&mut x, &mut y, px, py, 0.27669305564781616);
        kick(x, y, &mut px, &mut py, 0.25837438768632204);
        drift(&mut x, &mut y, px, py, 0.22145701433231887);
        kick(x, y, &mut px, &mut py, 0.1845396409783157);
        drift(&mut x, &mut y, px, py, -0.10568212657746094);
        kick(x, y, &mut px, &mut py, -0.39590389413323757);
        drift(&mut x, &mut y, px, py, -0.11853099378904099);
        kick(x, y, &mut px, &mut py, 0.1588419065551556);
        drift(&mut x, &mut y, px, py, -0.11531652804484584);
        kick(x, y, &mut px, &mut py, -0.38947496264484727);
        drift(&mut x, &mut y, px, py, 0.08584400956513055);
        kick(x, y, &mut px, &mut py, 0.5611629817751084);
        drift(&mut x, &mut y, px, py, 0.3456827324319992);
        kick(x, y, &mut px, &mut py, 0.13020248308889007);
    }
    drift(&mut x, &mut y, px, py, 0.06510124154444503);
    assert_eq!(([x, y], [px, py]), expected);
}

#[test]
fn a_planet_by_velocity_verlet() {
    let system = Kepler { mu: 1.1 };
    let (mut x, mut y, mut px, mut py, h) = (0.4, 0.0, 0.0, 2.0, 0.01);
    let expected = generated(&system, VelocityVerlet, ([x, y], [px, py]), h);

    let kick = |x: f64, y: f64, px: &mut f64, py: &mut f64, duration: f64| {
        let squared = fma(y, y, x * x);
        let pull = -duration * -system.mu / (squared * squared.sqrt());
        *px = fma(-pull, x, *px);
        *py = fma(-pull, y, *py);
    };
    for step in 0..STEPS {
        kick(x, y, &mut px, &mut py, if step == 0 { h * 0.5 } else { h });
        x = fma(h, px, x);
        y = fma(h, py, y);
    }
    kick(x, y, &mut px, &mut py, h * 0.5);
    same_orbit(([x, y], [px, py]), expected, h);
}

#[test]
fn a_planet_by_euler_where_nothing_merges() {
    let system = Kepler { mu: 1.0 };
    let (mut x, mut y, mut px, mut py, h) = (0.4, 0.0, 0.0, 2.0, 0.001);
    let expected = generated(&system, Euler, ([x, y], [px, py]), h);

    for _ in 0..STEPS {
        let squared = fma(y, y, x * x);
        let pull = h / (squared * squared.sqrt());
        px = fma(-pull, x, px);
        py = fma(-pull, y, py);
        x = fma(h, px, x);
        y = fma(h, py, y);
    }
    same_orbit(([x, y], [px, py]), expected, h);
}

#[test]
fn a_chain_with_loops_by_verlet() {
    let system = Chain { alpha: 0.25, mass: std::array::from_fn(|i| 1.0 + i as f64 / 8.0) };
    let (mut q, mut p, h): ([f64; 8], _, _) = (std::array::from_fn(|i| (i as f64 + 1.0).sin()), [0.1; 8], 0.05);
    let expected = generated(&system, Verlet, (q, p), h);

    let inverse_mass = system.mass.map(|mass| 2.0 / (2.0 * mass));
    let spring = |stretch: f64| {
        let squared = stretch * stretch;
        stretch + fma(system.alpha, squared, squared * stretch)
    };
    let drift = |q: &mut [f64; 8], p: &[f64; 8], duration: f64| {
        for i in 0..8 {
            q[i] = fma(duration, inverse_mass[i] * p[i], q[i]);
        }
    };
    for step in 0..STEPS {
        drift(&mut q, &p, if step == 0 { h * 0.5 } else { h });
        // Each site has the bond to the next one, which pulls at both, and the ends have a wall.
        let bond: [f64; 8] = std::array::from_fn(|i| if i < 7 { spring(q[i + 1] - q[i]) } else { 0.0 });
        let wall = |stretch: f64, sign: f64| {
            let squared = stretch * stretch;
            stretch + (squared * stretch + sign * (system.alpha * squared))
        };
        for i in 0..8 {
            let own = match i {
                0 => -bond[0] + wall(q[0], 1.0),
                7 => wall(q[7], -1.0),
                _ => -bond[i],
            };
            let gradient = if i == 0 { own } else { own + bond[i - 1] };
            p[i] = fma(-h, gradient, p[i]);
        }
    }
    drift(&mut q, &p, h * 0.5);
    assert_eq!((q, p), expected);
}
