//! Derivatives of the end of a run by parameters of the system, beside those by its start.

#[path = "support/instruction_sets.rs"]
mod instruction_sets;

use integrator_core::{Chin4A, Coords, Error, Memoryless, VectorFault, prelude::*};

/// A shaken pendulum, whose constants are made by helpers, a branch and a function of the parameters.
#[derive(Clone)]
struct Pendulum {
    mass: f64,
    length: f64,
    gravity: f64,
}

#[hamiltonian(sensitive(mass, length), compose = Yoshida4)]
impl Pendulum {
    fn inertia(&self) -> f64 {
        let Self { mass, length, .. } = self;
        mass * length.powi(2)
    }
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / (2.0 * self.inertia())
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        let pull = if self.length > 0.5 { self.gravity * self.length.sqrt() } else { 1.0 };
        -self.mass * pull * (1.0 + 0.1 * (self.length * t).sin()) * q[0].cos()
    }
}

/// A chain of sites.
#[derive(Clone)]
struct Chain {
    stiffness: f64,
    hardening: f64,
}

#[hamiltonian(sensitive(hardening, stiffness))]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() - 1 {
            let stretch = q[i + 1] - q[i];
            energy += self.stiffness * stretch * stretch / 2.0 + self.hardening * stretch.powi(4) / 4.0;
        }
        energy
    }
}

/// Bodies that attract each other, softened: a few of them are one row, many are several.
#[derive(Clone)]
struct Bodies<const N: usize> {
    mass: [f64; N],
    unit: f64,
    gravity: f64,
    softening: f64,
}

#[hamiltonian(sensitive(unit, gravity, softening))]
impl<const N: usize> Bodies<N> {
    fn kinetic(&self, p: &[[f64; 3]; N]) -> f64 {
        (0..N).map(|i| (0..3).map(|d| p[i][d].powi(2)).sum::<f64>() / (2.0 * self.unit * self.mass[i])).sum()
    }
    fn potential(&self, q: &[[f64; 3]; N]) -> f64 {
        let mut energy = 0.0;
        for i in 0..N {
            for j in 0..i {
                let square = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                let strength = self.gravity * self.unit * self.mass[i] * self.unit * self.mass[j];
                energy -= strength / (square + self.softening.powi(2)).sqrt();
            }
        }
        energy
    }
}

/// A charge in a wave, whose vector potential is along x and depends on x.
#[derive(Clone)]
struct Wave {
    field: f64,
    number: f64,
}

#[hamiltonian(split = x + y + well, sensitive(field, number))]
impl Wave {
    fn x(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        0.5 * (p[0] - self.field * (self.number * q[0] - q[1]).sin()).powi(2)
    }
    fn y(&self, p: [f64; 2]) -> f64 {
        0.5 * p[1] * p[1]
    }
    fn well(&self, q: [f64; 2]) -> f64 {
        0.25 * q[0].powi(4) + 0.5 * q[1] * q[1]
    }
}

/// A particle in one piece.
#[derive(Clone)]
struct Whole {
    field: f64,
}

#[hamiltonian(split = none, compose = GaussLegendre4, sensitive(field))]
impl Whole {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        let (vx, vy) = (px + self.field * y, py - self.field * x);
        (vx * vx + vy * vy) / 2.0 + x * x * y
    }
}

/// Parts of which one is solved by matrices that the parameter is not in.
#[derive(Clone)]
struct Parts {
    cubic: f64,
}

#[hamiltonian(split = quadratic + rest, compose = Aba864, sensitive(cubic))]
impl Parts {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py + x * x + y * y) / 2.0 + self.cubic * (x * x * y - y.powi(3) / 3.0)
    }
}

/// A well that is called as it is, with the parameter as an argument.
#[derive(Clone)]
struct Called {
    width: f64,
}

#[hamiltonian(sensitive(width), compose = Verlet)]
impl Called {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.well(q[0] / self.width)
    }
    #[derivative(force)]
    fn well(&self, x: f64) -> f64 {
        -x.cos()
    }
    #[derivative(stiffness)]
    fn force(&self, x: f64) -> f64 {
        x.sin()
    }
    fn stiffness(&self, x: f64) -> f64 {
        x.cos()
    }
}

/// The numbers of a point, positions first.
fn numbers<C: Coords<Leaf = f64>>(point: &Phase<C>) -> Vec<f64> {
    point.q.flat().iter().chain(point.p.flat()).copied().collect()
}

/// What has to hold of every system and method: the state has the bits of the run alone, vectors at the start those that
/// they have without parameters, and the derivatives by parameters are limits of differences.
fn holds<H, X, C>(name: &str, system: &H, change: impl Fn(usize, f64) -> H, method: X, start: Phase<C>, h: f64)
where
    H: Sensitive + Hamiltonian<Coords = C>,
    X: Memoryless<H>,
    C: Coords<Leaf = f64, With<f64> = C>,
{
    let mut tangent = system.sensitivities::<f64, X>(method, start.clone(), [start.clone()], h).expect("a start");
    tangent.advance(5).and_then(|()| tangent.advance(7)).expect("finite states");
    let end = |system: &H| {
        let mut run = system.run_with::<f64, X>(method, start.clone(), h).expect("a start");
        run.advance(12).expect("finite states");
        run.state()
    };
    assert_eq!(tangent.state(), end(system), "{name}: the state");
    let mut alone = system.tangent::<f64, X>(method, start.clone(), [start.clone()], h).expect("a start");
    alone.advance(12).expect("finite states");
    let vectors = tangent.vectors();
    assert_eq!(vectors[0], alone.vectors()[0], "{name}: the vector at the start");
    assert_eq!(vectors.len(), 1 + H::SENSITIVE.len(), "{name}");

    // The gradient of a function of the end multiplies the derivatives by parameters.
    let weights = Phase { q: start.p.clone(), p: start.q.clone() };
    let found =
        system.gradient::<f64, X>(method, start.clone(), h, 12, |_| (0.0, weights.clone())).expect("a gradient");
    for (number, image) in vectors[1..].iter().enumerate() {
        let products = numbers(&weights).into_iter().zip(numbers(image)).map(|(a, b)| a * b);
        let (sum, size) = products.fold((0.0, 0.0), |(sum, size), product| (sum + product, size + product.abs()));
        // Both ways round each number a few hundred times.
        let apart = (found.parameters[number] - sum).abs();
        assert!(apart < 1e3 * f64::EPSILON * size, "{name}: {} is off by {apart:e} of {size:e}", H::SENSITIVE[number]);
    }
    assert_eq!(found.parameters.len(), H::SENSITIVE.len(), "{name}");

    // Differences of fourth order; the width of the coarser ones is twice that of the others, so that what both differ by
    // bounds the error of the finer ones. A rounding of the ends, of which there are a few hundred, is divided by the
    // width.
    for (number, parameter) in H::SENSITIVE.iter().enumerate() {
        let along = |width: f64| {
            let at = |s: f64| numbers(&end(&change(number, s * width)));
            let (far, near) = ([at(-2.0), at(2.0)], [at(-1.0), at(1.0)]);
            let of = |i: usize| (8.0 * (near[1][i] - near[0][i]) - (far[1][i] - far[0][i])) / (12.0 * width);
            (0..near[0].len()).map(of).collect::<Vec<_>>()
        };
        let width = 1.0 / 1024.0;
        let (fine, coarse, exact) = (along(width), along(2.0 * width), numbers(&vectors[1 + number]));
        let size = exact.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
        assert!(exact.iter().any(|x| x.abs() > 1e-3), "{name}: nothing depends on `{parameter}`, {exact:?}");
        for place in 0..exact.len() {
            let tolerance = (fine[place] - coarse[place]).abs() + 1e3 * f64::EPSILON / width * size;
            let apart = (exact[place] - fine[place]).abs();
            assert!(apart <= tolerance, "{name}: component {place} by `{parameter}` is off by {apart:e}");
        }
    }
}

#[test]
fn ends_have_derivatives_by_the_parameters_of_every_layout() {
    let pendulum = Pendulum { mass: 0.8, length: 1.3, gravity: 2.0 };
    let change = |number: usize, by: f64| {
        let mut changed = pendulum.clone();
        *[&mut changed.mass, &mut changed.length][number] += by;
        changed
    };
    holds("a shaken pendulum", &pendulum, change, Yoshida4, Phase::new([1.0], [0.3]), 0.1);
    holds("an implicit method", &pendulum, change, GaussLegendre4, Phase::new([1.0], [0.3]), 0.1);
    holds("force gradients", &pendulum, change, Chin4A, Phase::new([1.0], [0.3]), 0.1);

    let chain = Chain { stiffness: 0.7, hardening: 0.4 };
    let change = |number: usize, by: f64| {
        let mut changed = chain.clone();
        *[&mut changed.hardening, &mut changed.stiffness][number] += by;
        changed
    };
    let site = |i: usize| (0.4 * i as f64).sin();
    let start = Phase::new((0..21).map(site).collect::<Vec<_>>(), (0..21).map(|i| site(i + 3)).collect());
    holds("a chain", &chain, change, Verlet, start, 0.1);

    fn of_bodies<const N: usize>(name: &str) {
        let mass = std::array::from_fn(|i| 1.0 + 0.1 * i as f64);
        let bodies = Bodies::<N> { mass, unit: 1.1, gravity: 0.3, softening: 0.5 };
        let change = |number: usize, by: f64| {
            let mut changed = bodies.clone();
            *[&mut changed.unit, &mut changed.gravity, &mut changed.softening][number] += by;
            changed
        };
        let site = |i: usize| (0.4 * i as f64).sin();
        let start = Phase::new(
            std::array::from_fn(|i| [site(2 * i) + i as f64, site(i + 1), 0.3 * site(3 * i)]),
            std::array::from_fn(|i| [site(2 * i + 5), site(i + 6), 0.3 * site(3 * i)].map(|p| 0.1 * p)),
        );
        holds(name, &bodies, change, Verlet, start, 0.1);
    }
    of_bodies::<5>("a few bodies");
    of_bodies::<11>("many bodies");

    let galaxy = Phase::new([0.3, -0.2], [0.1, 0.35]);
    holds("one piece", &Whole { field: 0.6 }, |_, by| Whole { field: 0.6 + by }, GaussLegendre4, galaxy, 0.2);
    holds("parts", &Parts { cubic: 0.9 }, |_, by| Parts { cubic: 0.9 + by }, Aba864, galaxy, 0.2);
    let change = |number: usize, by: f64| {
        let mut changed = Wave { field: 0.7, number: 1.5 };
        *[&mut changed.field, &mut changed.number][number] += by;
        changed
    };
    holds("a kinetic momentum", &change(0, 0.0), change, Yoshida4, Phase::new([0.4, -0.3], [0.2, 0.5]), 0.1);
    let called = |_, by| Called { width: 1.2 + by };
    holds("a function that is called", &Called { width: 1.2 }, called, Verlet, Phase::new([0.4], [0.7]), 0.1);
}

/// A particle on a parabolic hill.
struct Hill {
    slope: f64,
}

#[hamiltonian(sensitive(slope), compose = Verlet)]
impl Hill {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.slope * q[0] * q[0] / 2.0
    }
}

#[test]
fn derivatives_by_parameters_are_never_rescaled_and_end_when_they_overflow() {
    let vector = Phase::new([1e-200], [1e-200]);
    let start = Phase::new([1e-250], [0.0]);
    let mut tangent = Hill { slope: 1.0 }.sensitivities(Verlet, start, [vector], 0.5).expect("a start");
    // 300 steps grow by about e^148: the vector was divided, the derivative by the slope was not.
    tangent.advance(300).expect("finite vectors");
    let exponents = tangent.exponents();
    assert!(exponents[0] < -200 && exponents[1] == 0, "{exponents:?}");
    let mut other = Hill { slope: 1.0 }.sensitivities(Verlet, start, [vector], 0.5).expect("a start");
    other.advance(64).and_then(|()| other.advance(236)).expect("finite vectors");
    assert_eq!((other.vectors(), other.exponents()), (tangent.vectors(), tangent.exponents()));

    // The derivative grows by another factor of the number of steps than the state, and leaves the numbers before it.
    let start = Phase::new([1e150], [0.0]);
    let mut tangent = Hill { slope: 1.0 }.sensitivities(Verlet, start, [], 0.5).expect("a start");
    let error = tangent.advance(1_000).expect_err("no number is as large");
    assert!(matches!(error, Error::Vector { vector: 0, fault: VectorFault::Lost { .. } }), "{error}");
}

#[test]
fn other_precisions_support_derivatives_by_parameters() {
    let hill = Hill { slope: 1.0 };
    let by_slope = |q: f64| {
        let mut tangent = hill.sensitivities(Yoshida4, Phase::new([q], [0.0]), [], 0.01).expect("a start");
        tangent.advance(100).expect("finite vectors");
        tangent.vectors()[0].q[0]
    };
    // q = cosh(t √k), whose derivative by k at one is t sinh(t) / 2; a step errs by 1e-10.
    let exact = 1.0_f64.sinh() / 2.0;
    assert!((by_slope(1.0) - exact).abs() < 1e-8);
    let mut single = hill.sensitivities(Yoshida4, Phase::new([1.0_f32], [0.0]), [], 0.01).expect("a start");
    single.advance(100).expect("finite vectors");
    assert!((f64::from(single.vectors()[0].q[0]) - exact).abs() < 1e3 * f64::from(f32::EPSILON));
    let mut compensated = hill.sensitivities(Yoshida4, Phase::compensated([1.0], [0.0]), [], 0.01).expect("a start");
    compensated.advance(100).expect("finite vectors");
    assert!((compensated.vectors()[0].q[0].value - exact).abs() < 1e-8);
}
