//! Bodies in Jacobi coordinates: the outer solar system of the examples in Kepler parts and interaction.

#[path = "../examples/outer_solar_system/system.rs"]
#[allow(dead_code, reason = "the example reads more of it")]
mod inertial;
#[path = "support/motions.rs"]
#[allow(dead_code, reason = "other tests read more of it")]
mod motions;

use inertial::{OuterSolarSystem, measured, reference, relative};
use integrator_core::{Coords, QuadraticKinetic, check::symplectic_defect, prelude::*};

const GRAVITY: f64 = 2.95912208286e-4;
const DAYS: f64 = 999_999.0;

/// Bodies that attract each other.
#[derive(Clone)]
struct Bodies<const N: usize> {
    gravity: f64,
    mass: Vec<f64>,
}

#[hamiltonian(coordinates = jacobi(self.mass), split = kepler + interaction, compose = Aba1064)]
impl<const N: usize> Bodies<N> {
    fn kinetic(&self, p: &[[f64; 3]; N]) -> f64 {
        (0..N).map(|i| (0..3).map(|d| p[i][d].powi(2)).sum::<f64>() / (2.0 * self.mass[i])).sum()
    }
    fn potential(&self, q: &[[f64; 3]; N]) -> f64 {
        let mut energy = 0.0;
        for i in 0..N {
            for j in 0..i {
                let square = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                energy -= self.gravity * self.mass[i] * self.mass[j] / square.sqrt();
            }
        }
        energy
    }
}

/// The outer solar system, whose six bodies are one row.
#[derive(Clone)]
struct Solar {
    mass: Vec<f64>,
}

#[hamiltonian(coordinates = jacobi(self.mass), split = kepler + interaction, compose = Aba1064)]
impl Solar {
    fn kinetic(&self, p: &[[f64; 3]; 6]) -> f64 {
        (0..6).map(|i| (0..3).map(|d| p[i][d].powi(2)).sum::<f64>() / (2.0 * self.mass[i])).sum()
    }
    fn potential(&self, q: &[[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for j in 0..i {
                let square = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                energy -= GRAVITY * self.mass[i] * self.mass[j] / square.sqrt();
            }
        }
        energy
    }
}

type State = Phase<[[f64; 3]; 6]>;

fn solar() -> (Solar, State) {
    let (OuterSolarSystem { masses }, start) = measured().expect("the table of the examples");
    (Solar { mass: masses.to_vec() }, start)
}

/// The state after so many steps.
fn end<H: Hamiltonian, X: Composition<H>>(
    system: &H,
    composition: X,
    start: Phase<H::Coords>,
    h: f64,
    n: u64,
) -> Phase<H::Coords>
where
    H::Coords: Coords<Leaf = f64>,
{
    let mut run = system.run_with::<f64, X>(composition, start, h).expect("a run");
    run.advance(n).expect("steps");
    run.state()
}

/// The error of the positions after 999,999 days, relative to their length.
fn error<X: Composition<Solar>>(composition: X, steps: u64) -> f64 {
    let (system, start) = solar();
    let state = end(&system, composition, start, DAYS / steps as f64, steps);
    relative(state.q.as_flattened(), &reference().expect("a reference"))
}

/// Errors at steps that are halved, each less than the one before by two to the power of the order in the step, until
/// roundings are reached: each of some 10⁴ to 10⁵ flows rounds by an ulp at random, and the phase sums these up twice.
#[test]
fn the_planets_arrive_at_the_reference() {
    let order = |errors: [f64; 2]| (errors[0] / errors[1]).log2();
    assert!((1.9..2.1).contains(&order([4096, 8192].map(|steps| error(Verlet, steps)))));
    assert!((3.8..4.3).contains(&order([4096, 8192].map(|steps| error(Yoshida4, steps)))));
    // Kicks along the gradient of the squared force, with the Hessian of the interaction.
    assert!((3.8..4.3).contains(&order([8192, 16384].map(|steps| error(Chin4A, steps)))));
    // Proved for a quadratic T alone: the brackets that it leaves out vanish for Kepler parts too.
    assert!((8.0..12.0).contains(&order([2048, 4096].map(|steps| error(BlanesMoanSrkn11, steps)))));
    let at = error(Aba1064, 4096);
    assert!(at < 1e-10, "{at:e} with steps of 244 days");
}

/// An error of the order `ε h²` and one of `ε² h²`: in units of the planets' masses.
#[test]
fn errors_shrink_with_the_masses_of_planets() {
    let (system, start) = solar();
    let error = |scale: f64, coarse: &dyn Fn(&Solar, State, f64, u64) -> State| {
        let mut mass = system.mass.clone();
        let mut start = start;
        for (mass, p) in mass.iter_mut().zip(&mut start.p).skip(1) {
            *mass *= scale;
            *p = p.map(|p| scale * p);
        }
        let system = Solar { mass };
        let fine = end(&system, Aba1064, start, 50.0, 400);
        relative(coarse(&system, start, 200.0, 100).q.as_flattened(), fine.q.as_flattened())
    };
    let power =
        |coarse: &dyn Fn(&Solar, State, f64, u64) -> State| (error(1.0, coarse) / error(0.125, coarse)).log2() / 3.0;
    let verlet = power(&|system, start, h, n| end(system, Verlet, start, h, n));
    assert!((0.9..1.1).contains(&verlet), "{verlet}");
    let saba4 = power(&|system, start, h, n| end(system, Saba4, start, h, n));
    assert!((1.8..2.2).contains(&saba4), "{saba4}");
}

/// Two bodies have no interaction: whatever the step, they are where Kepler's equation has them.
#[test]
fn two_bodies_move_on_their_ellipse() {
    let (eccentricity, mass) = (0.3, vec![0.75, 0.25]);
    let relative = |time: f64| motions::ellipse(eccentricity, time);
    // The centre moves as well.
    let state = |time: f64| {
        let [x, y, u, v] = relative(time);
        let centre = [0.1 * time, 0.5, -0.2 * time];
        let point = |share: f64| [centre[0] + share * x, centre[1] + share * y, centre[2]];
        let momentum = |mass: f64, share: f64| [mass * (0.1 + share * u), mass * share * v, -0.2 * mass];
        Phase::new([point(-0.25), point(0.75)], [momentum(0.75, -0.25), momentum(0.25, 0.75)])
    };
    let system = Bodies::<2> { gravity: 1.0, mass };
    for (h, n) in [(2.0, 1_u64), (-0.7, 3), (0.01, 500)] {
        let (found, exact) = (end(&system, Verlet, state(0.0), h, n), state(n as f64 * h));
        let error = relative_distance(&found, &exact);
        // A few roundings in each step, which the phase sums up.
        assert!(error < 16.0 * f64::EPSILON * n as f64, "{error:e} after {n} steps of {h}");
    }
}

fn relative_distance<const N: usize>(a: &Phase<[[f64; 3]; N]>, b: &Phase<[[f64; 3]; N]>) -> f64 {
    relative(a.q.as_flattened(), b.q.as_flattened()).max(relative(a.p.as_flattened(), b.p.as_flattened()))
}

/// The energy of the first part is that of the Kepler motions, by the definition of Jacobi coordinates, and that of both
/// is `H`.
#[test]
fn the_energies_of_the_parts_add_up() {
    let (system, start) = solar();
    let run = system.run(start, 100.0).expect("a run");
    let (mut kepler, mut scale) = (0.0, 0.0);
    let (mut mass, mut moment, mut total) = (0.0, [0.0; 3], [0.0; 3]);
    for ((&m, q), p) in system.mass.iter().zip(start.q).zip(start.p) {
        if mass > 0.0 {
            let square = |x: [f64; 3]| x.iter().map(|x| x * x).sum::<f64>();
            let place: [f64; 3] = std::array::from_fn(|d| q[d] - moment[d] / mass);
            let velocity: [f64; 3] = std::array::from_fn(|d| p[d] / m - total[d] / mass);
            let reduced = m * mass / (m + mass);
            let (moving, bound) = (0.5 * reduced * square(velocity), GRAVITY * m * mass / square(place).sqrt());
            kepler += moving - bound;
            scale += moving + bound;
        }
        mass += m;
        moment = std::array::from_fn(|d| moment[d] + m * q[d]);
        total = std::array::from_fn(|d| total[d] + p[d]);
    }
    kepler += total.iter().map(|p| p * p).sum::<f64>() / (2.0 * mass);
    // Some roundings of each of the two ways.
    let close = |a: f64, b: f64| (a - b).abs() < 16.0 * f64::EPSILON * scale;
    assert!(close(run.kinetic(), kepler), "{:e} is not {kepler:e}", run.kinetic());
    let whole = system.kinetic(&start.p) + system.potential(&start.q);
    assert!(close(run.energy(), whole), "{:e} is not {whole:e}", run.energy());
    // The interaction is small: of the order of the planets' masses.
    assert!(run.potential().abs() < 1e-2 * scale, "{:e} of {scale:e}", run.potential());
}

#[test]
fn reading_saving_and_portions_change_no_bit() {
    let (system, start) = solar();
    let mut run = system.run(start, 120.0).expect("a run");
    run.advance(300).expect("steps");
    let mut looked = system.run(start, 120.0).expect("a run");
    for _ in 0..300 {
        assert_eq!(looked.state(), looked.state());
        looked.advance(1).expect("a step");
    }
    assert_eq!(run.state(), looked.state());
    let mut resumed = Run::resume(&system, &run.checkpoint()).expect("a checkpoint");
    run.advance(100).expect("steps");
    resumed.advance(100).expect("steps");
    assert_eq!(run.state(), resumed.state());
}

#[test]
fn members_move_as_they_do_alone() {
    let (system, start) = solar();
    let members: Vec<_> = (0..11)
        .map(|member| {
            let mut system = system.clone();
            system.mass[3] *= 1.0 + 0.01 * f64::from(member);
            let mut start = start;
            start.q[2][1] += 0.001 * f64::from(member);
            (system, start)
        })
        .collect();
    let mut ensemble = Ensemble::new(Aba1064, members.iter().cloned(), 200.0).expect("members");
    ensemble.advance(50).expect("steps");
    let states: Vec<State> = ensemble.states().collect();
    for ((system, start), state) in members.iter().zip(states) {
        assert_eq!(end(system, Aba1064, *start, 200.0, 50), state);
    }
}

/// Compensated coordinates carry what plain ones round off, and those of single precision lose it.
#[test]
fn the_precision_is_that_of_the_state() {
    let (system, start) = solar();
    let (h, steps) = (DAYS / 8192.0, 8192);
    let mut run = system.run(Phase::compensated(start.q, start.p), h).expect("a run");
    run.advance(steps).expect("steps");
    let values: Vec<f64> = run.state().q.as_flattened().iter().map(|leaf| leaf.value).collect();
    let error = relative(&values, &reference().expect("a reference"));
    assert!(error < 2e-12, "{error:e}");
    let single = start.q.map(|point| point.map(|x| x as f32));
    let mut run = system.run(Phase::new(single, start.p.map(|point| point.map(|x| x as f32))), 100.0).expect("a run");
    run.advance(10).expect("steps");
    let values: Vec<f64> = run.state().q.as_flattened().iter().map(|x| f64::from(*x)).collect();
    let error = relative(&values, end(&system, Aba1064, start, 100.0, 10).q.as_flattened());
    assert!((1e-9..1e-5).contains(&error), "{error:e}");
}

/// Ten bodies are more than one row: the sums over bodies go on from row to row.
#[test]
fn any_number_of_bodies_may_move() {
    fn cluster<const N: usize>() -> (Bodies<N>, Phase<[[f64; 3]; N]>) {
        let mass: Vec<f64> = (0..N).map(|i| if i == 0 { 1.0 } else { 1e-4 * (1 + i % 3) as f64 }).collect();
        let place = |i: usize| {
            let (radius, angle) = (i as f64, 2.4 * i as f64);
            [radius * angle.cos(), radius * angle.sin(), 0.01 * radius]
        };
        let momentum = |i: usize| match i {
            0 => [0.0; 3],
            _ => {
                let [x, y, _] = place(i);
                let speed = mass[i] * (i as f64).powf(-1.5);
                [-y * speed, x * speed, 0.0]
            }
        };
        let (q, p) = (std::array::from_fn(place), std::array::from_fn(momentum));
        (Bodies { gravity: 1.0, mass }, Phase::new(q, p))
    }
    /// The same by `T + V`.
    struct Inertial<const N: usize>(Bodies<N>);
    #[hamiltonian(compose = BlanesMoanSrkn14)]
    impl<const N: usize> Inertial<N> {
        fn kinetic(&self, p: &[[f64; 3]; N]) -> f64 {
            (0..N).map(|i| (0..3).map(|d| p[i][d].powi(2)).sum::<f64>() / (2.0 * self.0.mass[i])).sum()
        }
        fn potential(&self, q: &[[f64; 3]; N]) -> f64 {
            let mut energy = 0.0;
            for i in 0..N {
                for j in 0..i {
                    let square = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                    energy -= self.0.mass[i] * self.0.mass[j] / square.sqrt();
                }
            }
            energy
        }
    }
    fn compared<const N: usize>() {
        let (system, start) = cluster::<N>();
        let jacobi = end(&system, Aba1064, start, 0.05, 100);
        let inertial = end(&Inertial(system), BlanesMoanSrkn14, start, 0.02, 250);
        let error = relative_distance(&jacobi, &inertial);
        assert!(error < 1e-11, "{N} bodies: {error:e}");
    }
    compared::<3>();
    compared::<10>();
    compared::<17>();
}

#[test]
fn no_bodies_at_all_are_a_system() {
    let start: Phase<[[f64; 3]; 0]> = Phase::new([], []);
    let system = Bodies::<0> { gravity: 1.0, mass: Vec::new() };
    assert_eq!(end(&system, Aba1064, start, 0.1, 3), start);
    let mut run = system.run(start, 0.1).expect("a run");
    run.advance(3).expect("nothing to move");
    assert_eq!(run.energy(), 0.0);
}

#[test]
fn masses_that_make_no_coordinates_are_refused() {
    let (system, start) = solar();
    let refusal = |mass: Vec<f64>| {
        let system = Solar { mass };
        let error = system.run(start, 1.0).expect_err("no run");
        let member = Ensemble::new(Aba1064, [(system, start)], 1.0).expect_err("no ensemble");
        assert_eq!(member.to_string(), format!("member 0: {error}"));
        error
    };
    let with = |body: usize, mass: f64| {
        let mut masses = system.mass.clone();
        masses[body] = mass;
        masses
    };
    assert_eq!(refusal(system.mass[..4].to_vec()), Error::FewMasses { masses: 4, bodies: 6 });
    assert!(matches!(refusal(with(0, 0.0)), Error::Mass { body: 0, .. }));
    assert!(matches!(refusal(with(3, 0.0)), Error::Mass { body: 3, .. }));
    assert!(matches!(refusal(with(5, f64::NAN)), Error::Mass { body: 5, .. }));
    assert!(matches!(refusal(with(1, -1e-3)), Error::Mass { body: 1, .. }));
}

/// Masses of the coordinates that are not those of `kinetic`.
#[test]
fn other_masses_are_refused() {
    struct Other;
    #[hamiltonian(coordinates = jacobi([1.0, 0.1, 0.2]), split = kepler + interaction)]
    impl Other {
        fn kinetic(&self, p: &[[f64; 2]; 3]) -> f64 {
            (0..3).map(|i| 0.5 * (p[i][0].powi(2) + p[i][1].powi(2))).sum()
        }
        fn potential(&self, q: &[[f64; 2]; 3]) -> f64 {
            let mut energy = 0.0;
            for i in 0..3 {
                for j in 0..i {
                    energy -= 1.0 / ((q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2)).sqrt();
                }
            }
            energy
        }
    }
    let start = Phase::new([[0.0, 0.0], [1.0, 0.0], [0.0, 2.0]], [[0.0; 2]; 3]);
    assert!(matches!(Other.run(start, 0.1), Err(Error::Mass { body: 1, .. })));
}

/// The flows of both parts and, as kicks along the gradient of the squared force read it, the product with the Hessian.
#[test]
fn the_stepper_is_symplectic() {
    fn admits<H: QuadraticKinetic>(_: &H) {}
    let (system, start) = solar();
    admits(&system);
    // A certificate takes twenty seconds where nothing is optimised: the order is measured above, and `tests/kepler.rs` certifies.
    let defect = symplectic_defect(&system, Chin4A, start, 60.0).expect("a step");
    assert!(defect < 1e-12, "{defect:e}");
}

/// A push that begins with the hundredth step moves all bodies alike, beside what they do to each other.
#[test]
fn conditions_on_the_time_are_read_in_the_middle_of_steps() {
    struct Pushed {
        mass: [f64; 3],
        push: f64,
    }
    #[hamiltonian(coordinates = jacobi(self.mass), split = kepler + interaction)]
    impl Pushed {
        fn kinetic(&self, p: &[[f64; 2]; 3]) -> f64 {
            (0..3).map(|i| (p[i][0].powi(2) + p[i][1].powi(2)) / (2.0 * self.mass[i])).sum()
        }
        fn potential(&self, q: &[[f64; 2]; 3], t: f64) -> f64 {
            let push = if t > 1.0 { self.push } else { 0.0 };
            let mut energy = 0.0;
            for i in 0..3 {
                energy += push * self.mass[i] * q[i][0];
                for j in 0..i {
                    let distance = ((q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2)).sqrt();
                    energy -= self.mass[i] * self.mass[j] / distance;
                }
            }
            energy
        }
    }
    let mass = [1.0, 1e-3, 2e-3];
    let momenta = [[0.0, 0.0], [0.0, 1e-3], [-1.2e-3, 0.0]];
    let start = Phase::new([[0.0, 0.0], [1.0, 0.0], [0.0, 2.5]], momenta);
    let moved = |push: f64| {
        let mut run = Pushed { mass, push }.run(start, 0.01).expect("a run");
        run.advance(300).expect("steps");
        run.state()
    };
    let (free, pushed) = (moved(0.0), moved(0.25));
    for (i, mass) in mass.into_iter().enumerate() {
        // 2 units of time; the displacement is of the size of the coordinates, each step rounds it.
        let [shift, change] = [pushed.q[i][0] - free.q[i][0] + 0.5, pushed.p[i][0] - free.p[i][0] + 0.5 * mass];
        assert!(shift.abs() < 300.0 * f64::EPSILON && change.abs() < 300.0 * f64::EPSILON, "{shift:e} {change:e}");
        assert!((pushed.q[i][1] - free.q[i][1]).abs() < 1e-13);
    }
}
