//! Deviation vectors beside a run: the derivative of its steps, whatever the system splits into and its layout is.

#[path = "support/derivatives.rs"]
mod derivatives;
#[path = "support/instruction_sets.rs"]
mod instruction_sets;

use derivatives::{directions, holds, numbers};
use integrator_core::{BlanesCasasMurua6S11 as Processed, Chin4A, Error, VectorFault, check::branches, prelude::*};

/// A pendulum whose point of suspension is shaken.
struct Pendulum {
    shaken: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        -(1.0 + self.shaken * t.sin()) * q[0].cos()
    }
}

struct HenonHeiles;

#[hamiltonian(compose = Yoshida4)]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (x * x + y * y) / 2.0 + x * x * y - y.powi(3) / 3.0
    }
}

/// The same in parts that are solved by matrices and shears.
struct Rotated;

#[hamiltonian(split = quadratic + rest, compose = Aba864)]
impl Rotated {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py + x * x + y * y) / 2.0 + x * x * y - y.powi(3) / 3.0
    }
}

/// The same in one piece.
struct Whole;

#[hamiltonian(split = none, compose = GaussLegendre4)]
impl Whole {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py + x * x + y * y) / 2.0 + x * x * y - y.powi(3) / 3.0
    }
}

/// The same with two copies of the state.
struct Copied;

#[hamiltonian(split = symmetric(omega = 20.0))]
impl Copied {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py + x * x + y * y) / 2.0 + x * x * y - y.powi(3) / 3.0
    }
}

/// A chain of sites with a nonlinear force of each bond.
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
        energy
    }
}

/// Bodies that attract each other: a few of them are one row, many are several.
struct Bodies<const N: usize>;

#[hamiltonian]
impl<const N: usize> Bodies<N> {
    fn kinetic(&self, p: &[[f64; 3]; N]) -> f64 {
        (0..N).map(|i| (0..3).map(|d| p[i][d].powi(2)).sum::<f64>() / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; 3]; N]) -> f64 {
        let mut energy = 0.0;
        for i in 0..N {
            for j in 0..i {
                let square = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                energy -= 0.01 / square.sqrt();
            }
        }
        energy
    }
}

/// A star and two planets in Jacobi coordinates.
struct Planets {
    mass: [f64; 3],
}

#[hamiltonian(coordinates = jacobi(self.mass), split = kepler + interaction, compose = Aba864)]
impl Planets {
    fn kinetic(&self, p: &[[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| (0..2).map(|d| p[i][d].powi(2)).sum::<f64>() / (2.0 * self.mass[i])).sum()
    }
    fn potential(&self, q: &[[f64; 2]; 3]) -> f64 {
        let mut energy = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let square = (0..2).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                energy -= self.mass[i] * self.mass[j] / square.sqrt();
            }
        }
        energy
    }
}

/// A flow that the user wrote, and a function with a stated derivative.
#[derive(Clone)]
struct Own;

#[hamiltonian(split = rotation + rest, compose = Verlet)]
impl Own {
    fn rotation(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
        (q[0] * q[0] + p[0] * p[0]).powi(2) / 4.0
    }
    #[flow(rotation)]
    fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {
        let (sine, cosine) = ((q[0] * q[0] + p[0] * p[0]) * duration).sin_cos();
        (q[0], p[0]) = (q[0] * cosine + p[0] * sine, p[0] * cosine - q[0] * sine);
    }
    fn rest(&self, q: [f64; 1]) -> f64 {
        self.well(q[0])
    }
    #[derivative(force)]
    fn well(&self, x: f64) -> f64 {
        x.sin()
    }
    #[derivative(stiffness)]
    fn force(&self, x: f64) -> f64 {
        x.cos()
    }
    fn stiffness(&self, x: f64) -> f64 {
        -x.sin()
    }
}

#[test]
fn vectors_are_derivatives_of_the_steps_of_every_system() {
    let galaxy = Phase::new([0.3, -0.2], [0.1, 0.35]);
    holds("a shaken pendulum", &Pendulum { shaken: 0.3 }, Yoshida4, Phase::new([2.0], [0.3]), 0.1);
    holds("Hénon-Heiles", &HenonHeiles, BlanesMoanSrkn11, galaxy, 0.2);
    holds("force gradients", &HenonHeiles, Chin4A, galaxy, 0.2);
    holds("a processor", &HenonHeiles, Processed, galaxy, 0.1);
    holds("matrices", &Rotated, Aba864, galaxy, 0.2);
    holds("an implicit method", &Whole, GaussLegendre4, galaxy, 0.2);
    let site = |i: usize| (0.4 * i as f64).sin();
    let chain = Phase::new((0..21).map(site).collect::<Vec<_>>(), (0..21).map(|i| site(i + 3)).collect());
    holds("a chain", &Chain, Verlet, chain, 0.1);
    let body = |i: usize| [site(2 * i) + i as f64, site(i + 1), 0.3 * site(3 * i)];
    let bodies = |i: usize| body(i + 5).map(|p| 0.1 * p);
    let few = Phase::new([0, 1, 2, 3, 4].map(body), [0, 1, 2, 3, 4].map(bodies));
    holds("a few bodies", &Bodies::<5>, Verlet, few, 0.1);
    let many = Phase::new(std::array::from_fn(body), std::array::from_fn(bodies));
    holds("many bodies", &Bodies::<11>, Verlet, many, 0.1);
    let mass = [1.0, 0.4, 0.3];
    let planets = Phase::new([[0.0, 0.0], [1.0, 0.0], [0.0, -4.0]], [[0.0, -0.2], [0.1, 0.4], [0.2, 0.0]]);
    holds("planets in Jacobi coordinates", &Planets { mass }, Aba864, planets, 0.1);
    holds("a flow of the user", &Own, Verlet, Phase::new([0.4], [0.7]), 0.1);
}

#[test]
fn other_precisions_support_vectors() {
    let galaxy = ([0.3, -0.2], [0.1, 0.35]);
    let vectors = directions(&Phase::new(galaxy.0, galaxy.1), 4);
    let advanced = |start: Phase<[f64; 2]>| {
        let mut tangent = HenonHeiles.tangent(Yoshida4, start, vectors.clone(), 0.1).expect("a start");
        tangent.advance(100).expect("finite states");
        tangent.vectors()
    };
    let plain = advanced(Phase::new(galaxy.0, galaxy.1));

    let compensated = |v: &Phase<[f64; 2]>| Phase::compensated(v.q, v.p);
    let start = Phase::compensated(galaxy.0, galaxy.1);
    let mut tangent = HenonHeiles.tangent(Yoshida4, start, vectors.iter().map(compensated), 0.1).expect("a start");
    let mut run = HenonHeiles.run_with(Yoshida4, start, 0.1).expect("a start");
    tangent.advance(100).and_then(|()| run.advance(100)).expect("finite states");
    assert_eq!(tangent.state(), run.state(), "compensated");

    let single = |v: &Phase<[f64; 2]>| Phase::new(v.q.map(|x| x as f32), v.p.map(|x| x as f32));
    let start = single(&Phase::new(galaxy.0, galaxy.1));
    let mut of_singles = HenonHeiles.tangent(Yoshida4, start, vectors.iter().map(single), 0.1).expect("a start");
    let mut run = HenonHeiles.run_with(Yoshida4, start, 0.1).expect("a start");
    of_singles.advance(100).and_then(|()| run.advance(100)).expect("finite states");
    assert_eq!(of_singles.state(), run.state(), "f32");

    // Some thousand roundings, each carried on by a factor of at most a hundred over ten periods.
    for (vector, plain) in plain.iter().enumerate() {
        for place in 0..2 {
            let other = tangent.vectors()[vector].q[place].value;
            assert!((other - plain.q[place]).abs() < 1e5 * f64::EPSILON, "compensated vector {vector}");
            let other = f64::from(of_singles.vectors()[vector].q[place]);
            assert!((other - plain.q[place]).abs() < 1e5 * f64::from(f32::EPSILON), "vector {vector} in f32");
        }
    }
}

#[test]
fn the_symplectic_form_of_two_vectors_is_kept() {
    let vectors = directions(&Phase::new([0.0; 2], [0.0; 2]), 4);
    let form =
        |a: &Phase<[f64; 2]>, b: &Phase<[f64; 2]>| (0..2).map(|i| a.q[i] * b.p[i] - a.p[i] * b.q[i]).sum::<f64>();
    let start = Phase::new([0.0, 0.1], [0.45, 0.05]);
    let mut tangent = HenonHeiles.tangent(BlanesMoanSrkn11, start, vectors.clone(), 0.1).expect("a start");
    let steps = 20_000;
    tangent.advance(steps).expect("finite states");
    let arrived = tangent.vectors();
    let size = arrived.iter().flat_map(numbers).fold(0.0, |size: f64, x| size.max(x.abs()));
    // A regular orbit, whose vectors grow with the time: the form is a difference of products of such vectors, into
    // which each of the 22 flows of a step rounds them; a factor of 8 covers the tail of the walk.
    let walk = 8.0 * f64::EPSILON * size * size * (22.0 * steps as f64).sqrt();
    for (i, j) in [(0, 1), (0, 2), (1, 3), (2, 3)] {
        let (before, after) = (form(&vectors[i], &vectors[j]), form(&arrived[i], &arrived[j]));
        assert!((after - before).abs() < walk, "the form of {i} and {j} was {before} and is {after}; {walk:e}");
    }
    // The same vectors as if the last one had lost a rounding in every step would not pass.
    assert!(walk < 1e-3, "the walk {walk:e} would hide a vector that is not symplectic");
}

/// A particle on a parabolic hill.
struct Hill;

#[hamiltonian(compose = Verlet)]
impl Hill {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0] * q[0] / 2.0
    }
}

#[test]
fn vectors_are_rescaled_by_powers_of_two_to_avoid_overflow() {
    let (h, steps) = (0.5_f64, 10_000);
    let mut tangent = Hill.tangent(Verlet, Phase::new([0.0], [0.0]), [Phase::new([1.0], [1.0])], h).expect("a start");
    tangent.advance(steps).expect("finite vectors");
    // A step has the trace 2 + h² and the determinant 1, which tells the factor of the growing direction.
    let half_trace = 1.0 + h * h / 2.0;
    let growth = (half_trace + (half_trace * half_trace - 1.0).sqrt()).ln() * steps as f64;
    let (vector, exponent): (f64, i64) = (tangent.vectors()[0].q[0], tangent.exponents()[0]);
    assert!(exponent > 5_000 && (1e-100..1e100).contains(&vector.abs()), "{vector} · 2^{exponent}");
    let measured = vector.ln() + exponent as f64 * std::f64::consts::LN_2;
    // What the vector has of the growing direction at first is between a half and twice.
    assert!((measured - growth).abs() < 2.0, "{measured} is not {growth}");

    // In other portions the same numbers.
    let mut other = Hill.tangent(Verlet, Phase::new([0.0], [0.0]), [Phase::new([1.0], [1.0])], h).expect("a start");
    for portion in [1, 63, 64, 65, 807, 9_000] {
        other.advance(portion).expect("finite vectors");
    }
    assert_eq!((other.vectors(), other.exponents()), (tangent.vectors(), tangent.exponents()));
}

/// A force with an infinite slope at the origin.
struct Kink;

#[hamiltonian(compose = Verlet)]
impl Kink {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        q[0].abs().powf(1.5) + q[1] * q[1]
    }
}

/// A slope that begins at one.
struct Ramp;

#[hamiltonian(compose = Verlet)]
impl Ramp {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        if q[0] > 1.0 { 3.0 * (q[0] - 1.0) } else { 0.0 }
    }
}

#[test]
fn branches_that_an_orbit_crosses_are_named() {
    // Up the ramp at a time of 1, down again two thirds later.
    let found = branches(&Ramp, Verlet, Phase::new([0.0], [1.0]), 0.01, 200).expect("an orbit");
    let [crossing] = &found.crossed[..] else { panic!("one branch: {found}") };
    assert_eq!((crossing.part, crossing.number, crossing.times, found.comparisons), ("potential", 1, 2, 1), "{found}");
    assert!((crossing.first.1 - 1.0).abs() < 0.02 && crossing.first.0.abs_diff(100) < 2, "{found}");
    let [before, after] = crossing.operands;
    assert!((before[0] < before[1]) != (after[0] < after[1]), "{found}");
    // On one side, in a state of another precision, from another time.
    let start = Phase::new([0.0_f32], [1.0]).at_time(5.0);
    let found = branches(&Ramp, Yoshida4, start, 0.01, 90).expect("an orbit");
    assert!(found.crossed.is_empty() && found.comparisons == 1, "{found}");
    // Functions with kinks are branches; a system without them has none.
    let found = branches(&Kink, Verlet, Phase::new([0.5, 0.0], [0.0, 1.0]), 0.01, 300).expect("an orbit");
    assert!(matches!(&found.crossed[..], [crossing] if crossing.by == "abs"), "{found}");
    let found = branches(&HenonHeiles, Yoshida4, Phase::new([0.1, 0.2], [0.3, 0.1]), 0.1, 100).expect("an orbit");
    assert_eq!((found.comparisons, found.crossed.len()), (0, 0), "{found}");
    assert!(branches(&Ramp, Verlet, Phase::new([0.0], [f64::NAN]), 0.01, 10).is_err());
}

#[test]
fn invalid_vectors_and_steppers_without_a_tangent_map_are_refused() {
    let start = Phase::new(vec![0.0, 0.1], vec![0.0, 0.0]);
    let refused = |vectors: Vec<Phase<Vec<f64>>>| {
        Chain.tangent(Verlet, start.clone(), vectors, 0.1).expect_err("these are no vectors")
    };
    let vector = |q: [f64; 2], p: &[f64]| Phase::new(q.to_vec(), p.to_vec());
    let good = vector([1.0, 0.0], &[0.0, 0.0]);
    assert_eq!(refused(vec![]), Error::VectorCount { count: 0, most: 4 });
    assert_eq!(refused(vec![good.clone(); 5]), Error::VectorCount { count: 5, most: 4 });
    let table = [
        (vector([0.0, 0.0], &[0.0, 0.0]), VectorFault::Zero),
        (vector([0.0, f64::NAN], &[1.0, 0.0]), VectorFault::NotFinite),
        (vector([1.0, 1.0], &[1.0]), VectorFault::Length { lengths: [2, 1], positions: 2 }),
    ];
    for (bad, fault) in table {
        assert_eq!(refused(vec![good.clone(), bad]), Error::Vector { vector: 1, fault });
    }
    let grid = 1.0 / (1_u64 << 40) as f64;
    let on_grid = |x: f64| Phase::reversible([x], [0.0], grid);
    let refused = Pendulum { shaken: 0.0 }.tangent(Verlet, on_grid(1.0), [on_grid(1.0)], 0.1);
    assert!(matches!(refused, Err(Error::NoTangent { .. })), "{refused:?}");
    let galaxy = Phase::new([0.1, 0.2], [0.3, 0.4]);
    let refused = Copied.tangent(Verlet, galaxy, [galaxy], 0.1);
    assert!(matches!(refused, Err(Error::NoTangent { .. })), "{refused:?}");
}

#[test]
fn a_failed_vector_is_named_and_all_stay_at_the_last_step() {
    // On the axis the first coordinate stays where its force has an infinite slope.
    let on_axis = Phase::new([0.0, 0.25], [0.0, 0.0]);
    let vectors = directions(&on_axis, 4);
    let mut tangent = Kink.tangent(Verlet, on_axis, vectors.clone(), 0.125).expect("a start");
    let error = tangent.advance(100).expect_err("no second derivative on the axis");
    assert!(matches!(error, Error::Vector { vector: 0, fault: VectorFault::Lost { step: 1, .. } }), "{error}");
    assert_eq!((tangent.steps(), tangent.vectors()), (0, vectors));
    // An edge of H that is met after some scales were looked at, with two groups of vectors.
    let start = Phase::new([0.0, 0.1, 0.2], [1.0, 0.0, 0.0]);
    let mut tangent = Edge.tangent(Verlet, start, directions(&start, 6), 0.01).expect("a start");
    let mut run = Edge.run_with(Verlet, start, 0.01).expect("a start");
    let (error, of_run) = (tangent.advance(1_000), run.advance(1_000));
    assert!(of_run.is_err() && run.steps() > 70, "{} steps", run.steps());
    assert_eq!((error, tangent.steps(), tangent.state()), (of_run, run.steps(), run.state()));
    let mut shorter = Edge.tangent(Verlet, start, directions(&start, 6), 0.01).expect("a start");
    shorter.advance(run.steps()).expect("finite states");
    assert_eq!(tangent.vectors(), shorter.vectors());
    // Forces are finite where the energy is not.
    let outside = Phase::new([-1.0, 0.1, 0.2], [0.0; 3]);
    let refused = Timed.tangent(Verlet, outside, directions(&outside, 6), 0.01).expect("a start").advance(10);
    assert!(matches!(refused, Err(Error::Energy { .. })), "{refused:?}");
}

/// A force with an edge at one.
struct Edge;

#[hamiltonian(compose = Verlet)]
impl Edge {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 2.0
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        -0.1 * (1.0 - q[0]).sqrt() + q[1] * q[2]
    }
}

/// A logarithm and the time.
struct Timed;

#[hamiltonian(compose = Verlet)]
impl Timed {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 2.0
    }
    fn potential(&self, q: [f64; 3], t: f64) -> f64 {
        q[0].ln() + t.cos() * q[1] * q[2]
    }
}
