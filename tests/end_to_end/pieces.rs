//! Hamiltonians that are defined by pieces in time, whose edges lie where steps end.

use crate::measured_order::{assert_order, observed_order};
use integrator_core::{
    Compensated, InLanes, Method, Visitor,
    check::{ChooseError, Goal, certify, choose},
    prelude::*,
    taylor::Taylor,
};

/// Magnets along a ring, each with its own strength: a negative one defocuses.
struct Magnets {
    edges: [f64; 5],
    strengths: [f64; 4],
}

#[hamiltonian(taylor)]
impl Magnets {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        let mut energy = 0.0;
        for i in 0..4 {
            if t >= self.edges[i] && t < self.edges[i + 1] {
                energy += self.strengths[i] * q[0] * q[0] / 2.0;
            }
        }
        energy
    }
}

/// A magnet is so long; as a power of two it divides into steps without a rounding.
const LENGTH: f64 = 2.0;

fn magnets() -> Magnets {
    Magnets { edges: [0.0, 1.0, 2.0, 3.0, 4.0].map(|edge| edge * LENGTH), strengths: [1.0, -1.5, 4.0, 0.5] }
}

/// The matrix of each magnet.
fn matrices() -> [[[f64; 2]; 2]; 4] {
    magnets().strengths.map(|strength| {
        let omega = strength.abs().sqrt();
        let angle = omega * LENGTH;
        if strength > 0.0 {
            [[angle.cos(), angle.sin() / omega], [-omega * angle.sin(), angle.cos()]]
        } else {
            [[angle.cosh(), angle.sinh() / omega], [omega * angle.sinh(), angle.cosh()]]
        }
    })
}

/// The end of a particle that starts at (1, 0.3).
fn exact() -> [f64; 2] {
    matrices().iter().fold([1.0, 0.3], |[q, p], matrix| matrix.map(|[of_q, of_p]| of_q * q + of_p * p))
}

/// How far a run in so many steps per magnet ends from there.
fn error<M: Method<Magnets>>(method: M, steps: u64) -> f64 {
    let start = Phase::compensated([1.0], [0.3]);
    let mut run = magnets().run_with(method, start, LENGTH / steps as f64).expect("an admissible start");
    run.advance(4 * steps).expect("finite");
    let (state, [q, p]) = (run.state(), exact());
    (state.q[0].value - q).hypot(state.p[0].value - p)
}

/// The order of every composition, and that a run over the edges is one run after the other, bit for bit.
struct OverEdges(usize);

impl Visitor<Magnets> for OverEdges {
    fn visit<X: Composition<Magnets>>(&mut self, composition: X) {
        assert_order(X::NAME, X::ORDER, observed_order(X::ORDER, |steps| error(composition, steps)));

        let (magnets, h, start) = (magnets(), LENGTH / 8.0, Phase::new([1.0], [0.3]));
        let run = |start, step| magnets.run_with(composition, start, step).expect("an admissible start");
        let mut whole = run(start, h);
        whole.advance(32).expect("finite");
        let parts = (0..32).fold(start, |state, step| {
            let mut part = run(state, h).at_time(step as f64 * h);
            part.advance(1).expect("finite");
            part.state()
        });
        assert_eq!(whole.state(), parts, "{}", X::NAME);
        let mut portions = run(start, h);
        for portion in [1, 7, 0, 20, 4] {
            portions.advance(portion).expect("finite");
        }
        assert_eq!(portions.state(), parts, "{}", X::NAME);

        let mut there = run(start, h);
        there.advance(1).expect("finite");
        // Each of them is a kick or a part of one, and the last is not merged with the first.
        let kicks = X::FORCE_EVALUATIONS as u64;
        assert!(there.evaluations() >= kicks, "{}: {}", X::NAME, there.evaluations());
        self.0 += 1;
    }
}

#[test]
fn all_compositions_keep_their_order_over_edges() {
    let mut compositions = OverEdges(0);
    Magnets::visit_compositions(&mut compositions);
    assert!(compositions.0 > 40, "{}", compositions.0);
}

/// The same backwards in time, from the end.
#[test]
fn steps_that_run_backwards_belong_to_the_same_pieces() {
    let h = LENGTH / 8.0;
    let grid = 1.0 / (1_u64 << 40) as f64;
    let start = Phase::reversible([1.0], [0.25], grid);
    let mut there = magnets().run_with(VelocityYoshida4, start, h).expect("an admissible start");
    there.advance(32).expect("finite");
    let mut back = magnets().run_with(VelocityYoshida4, there.state(), -h).expect("an admissible start");
    back = back.at_time(there.time());
    back.advance(32).expect("finite");
    assert_eq!(back.state(), start);
}

#[test]
fn taylor_polynomials_end_at_edges() {
    let norm = |matrix: &[[f64; 2]; 2]| matrix.as_flattened().iter().map(|x| x * x).sum::<f64>().sqrt();
    let stretch: f64 = matrices().iter().map(norm).product();
    for steps in [1, 2, 3] {
        let error = error(Taylor::tolerance(1e-18), steps);
        // Each of fewer than a hundred polynomials begins at a state that is off by an ε of its size, and stretched from there on.
        assert!(error < 100.0 * f64::EPSILON * stretch, "{steps} steps per magnet: {error:e}");
    }
}

#[test]
fn members_are_runs_alone_over_edges() {
    fn agree<M: InLanes<Magnets> + Method<Magnets>>(method: M) {
        let start = |member: u32| Phase::new([1.0 + f64::from(member)], [0.3]);
        let system = |member: u32| Magnets { strengths: [1.0, -1.5, 4.0, f64::from(member)], ..magnets() };
        let members = (0..9).map(|member| (system(member), start(member)));
        let mut swarm = Ensemble::new(method, members, LENGTH / 3.0).expect("admissible starts");
        swarm.advance(5).expect("finite");
        swarm.advance(7).expect("finite");
        for member in 0..9 {
            let mut alone = system(member).run_with(method, start(member), LENGTH / 3.0).expect("an admissible start");
            alone.advance(12).expect("finite");
            assert_eq!(swarm.state(member as usize).expect("under way"), alone.state(), "{member}");
        }
    }
    agree(VelocityYoshida4);
    agree(BlanesCasasMurua6S11);
    agree(Taylor::tolerance(1e-12));
}

/// A long chain that is shaken for a while: its flows are collected and carried out in tiles.
struct Shaken {
    until: f64,
}

#[hamiltonian]
impl Shaken {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64], t: f64) -> f64 {
        let field = if t < self.until { 1.0 + t } else { 0.5 };
        let mut sum = 0.0;
        for i in 0..q.len() - 1 {
            sum += (q[i + 1] - q[i]).powi(2) / 2.0 + field * q[i].powi(4);
        }
        sum
    }
}

#[test]
fn tiles_do_not_reach_over_edges() {
    let (h, system) = (0.125, Shaken { until: 0.5 });
    let q: Vec<f64> = (0..5000).map(|site| f64::from(site % 7) / 8.0).collect();
    let mut state = Phase::new(q.clone(), vec![0.0; q.len()]);
    let mut whole = system.run_with(VelocityVerlet, state.clone(), h).expect("an admissible start");
    whole.advance(8).expect("finite");
    for step in 0..8 {
        let mut part = system.run_with(VelocityVerlet, state, h).expect("an admissible start");
        part = part.at_time(f64::from(step) * h);
        part.advance(1).expect("finite");
        state = part.state();
    }
    assert_eq!(whole.state(), state);
}

/// Cells of a focusing lens, a drift, a defocusing lens and a drift, one after the other without an end.
struct Fodo {
    cell: f64,
    strength: f64,
}

#[hamiltonian]
impl Fodo {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        let along = t % self.cell;
        if along < self.cell / 4.0 {
            self.strength * q[0] * q[0] / 2.0
        } else if along >= self.cell / 2.0 && along < 0.75 * self.cell {
            -self.strength * q[0] * q[0] / 2.0
        } else {
            0.0
        }
    }
}

/// A quarter of a cell is 0.7 radians of the lens, and the phase turns by 48 degrees per cell.
const FODO: Fodo = Fodo { cell: 2.0, strength: 2.0 };
const CELLS: u64 = 100;

/// The end of a particle that starts at (1, 0.3), behind so many cells.
fn behind_cells() -> [f64; 2] {
    let (omega, length) = (FODO.strength.sqrt(), FODO.cell / 4.0);
    let angle = omega * length;
    let drift = [[1.0, length], [0.0, 1.0]];
    let cell = [
        [[angle.cos(), angle.sin() / omega], [-omega * angle.sin(), angle.cos()]],
        drift,
        [[angle.cosh(), angle.sinh() / omega], [omega * angle.sinh(), angle.cosh()]],
        drift,
    ];
    let elements = (0..CELLS).flat_map(|_| cell);
    elements.fold([1.0, 0.3], |[q, p], matrix| matrix.map(|[of_q, of_p]| of_q * q + of_p * p))
}

/// The order of every composition behind all cells.
struct AlongCells(usize);

impl Visitor<Fodo> for AlongCells {
    fn visit<X: Composition<Fodo>>(&mut self, composition: X) {
        let [q, p] = behind_cells();
        let error = |steps: u64| {
            let (start, h) = (Phase::compensated([1.0], [0.3]), FODO.cell / (4 * steps) as f64);
            let mut run = FODO.run_with(composition, start, h).expect("an admissible start");
            // Steps that are too long for the lens may lead anywhere.
            match run.advance(4 * steps * CELLS) {
                Ok(()) => (run.state().q[0].value - q).hypot(run.state().p[0].value - p),
                Err(_) => f64::INFINITY,
            }
        };
        // The motion is linear, so that an error is the leading one and a share of about its own size.
        let small = if X::ORDER < 4 { 0.05 } else { 1e-3 };
        let (mut steps, mut coarse) = (1, error(1));
        while coarse > small {
            steps *= 2;
            coarse = error(steps);
            assert!(steps < 1 << 12, "{}: {coarse:e} in {steps} steps per element", X::NAME);
        }
        assert_order(X::NAME, X::ORDER, (coarse / error(2 * steps)).log2());
        self.0 += 1;
    }
}

#[test]
fn all_compositions_keep_their_order_over_a_hundred_cells() {
    let mut compositions = AlongCells(0);
    Fodo::visit_compositions(&mut compositions);
    assert!(compositions.0 > 40, "{}", compositions.0);
}

#[test]
fn cells_are_certified() {
    fn certified<X: Composition<Fodo>>(composition: X) {
        let (start, h) = (Phase::compensated([1.0], [0.3]), FODO.cell / 32.0);
        let outcome = certify::<_, _, Compensated<f64>>(&FODO, composition, start, h);
        let certificate = outcome.unwrap_or_else(|refused| panic!("{refused}"));
        assert!((certificate.observed_order - f64::from(X::ORDER)).abs() < 0.5, "{certificate}");
        assert!(certificate.order_until >= CELLS as f64 * FODO.cell, "{certificate}");
    }
    certified(Verlet);
    certified(VelocityVerlet);
    certified(Yoshida4);
    certified(BlanesMoanSrkn6);
    certified(KahanLi8);
}

/// Steps of a choice end at all edges, or it is told where none does.
#[test]
fn the_chosen_method_steps_on_edges() {
    let start = || Phase::compensated([1.0], [0.3]);
    let ranking = choose(&FODO, start(), 10.0 * FODO.cell, Goal::Trajectory(1e-6)).expect("a ranking");
    for choice in ranking.choices() {
        assert!(choice.steps.is_multiple_of(4 * 10), "{}: {} steps", choice.composition, choice.steps);
    }
    assert!(ranking.best().order >= 4, "{ranking}");
    let between = choose(&FODO, start(), 7.0_f64.sqrt(), Goal::Trajectory(1e-6));
    assert!(matches!(between, Err(ChooseError::Edge { time: 0.5, .. })), "{between:?}");
}
