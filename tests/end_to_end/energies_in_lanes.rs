//! Energies whose sums are in lanes or of pairs: they are those of the user's own functions, to the rounding of their sums, and
//! bitwise identical however they are computed.

use integrator_core::prelude::*;

/// Charges with a soft core, of which the first ones act; all terms are positive.
#[derive(Clone)]
struct Charges {
    acting: usize,
    charges: Vec<f64>,
    masses: Vec<f64>,
    bonds: Vec<[usize; 2]>,
}

#[hamiltonian]
impl Charges {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.25;
        for i in 0..p.len() {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / (2.0 * self.masses[i]);
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.5;
        for i in 0..self.acting {
            energy += self.charges[i] * (1.0 + q[i][0].sin());
            for j in 0..i {
                let mut r2 = 0.1;
                for k in 0..3 {
                    r2 += (q[i][k] - q[j][k]).powi(2);
                }
                energy += self.charges[i] * self.charges[j] / r2.sqrt();
            }
        }
        for &[a, b] in &self.bonds {
            energy += (q[a][0] - q[b][0]).powi(2);
        }
        energy
    }
}

/// A liquid with a cutoff and momenta that are not squared.
struct Relativistic {
    cutoff: f64,
}

#[hamiltonian]
impl Relativistic {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().map(|p| (1.0 + p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt()).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let (mut energy, square) = (0.0, self.cutoff.powi(2));
        for i in 0..q.len() {
            for j in i + 1..q.len() {
                let mut r2 = 0.0;
                for k in 0..3 {
                    r2 += (q[i][k] - q[j][k]).powi(2);
                }
                if r2 < square {
                    energy += (square - r2).powi(3);
                }
            }
        }
        energy
    }
}

/// Bonds that are saturated beyond a distance, where there is an energy without a force.
struct Saturated;

#[hamiltonian]
impl Saturated {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let mut r2 = 0.0;
                for k in 0..3 {
                    r2 += (q[i][k] - q[j][k]).powi(2);
                }
                energy += if r2 < 4.0 { r2 / 4.0 } else { 1.0 };
            }
        }
        energy
    }
}

/// Charges that are switched on at a time, and masses that change at another one.
struct Switched;

#[hamiltonian]
impl Switched {
    fn kinetic(&self, p: &[[f64; 3]], t: f64) -> f64 {
        let rate = if t < 2.0 { 1.0 } else { 0.5 };
        p.iter().flatten().map(|p| rate * p * p / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; 3]], t: f64) -> f64 {
        let (mut energy, charge) = (0.0, if t < 1.0 { 1.0 } else { 3.0 });
        for i in 0..q.len() {
            for j in 0..i {
                let mut r2 = 0.1;
                for k in 0..3 {
                    r2 += (q[i][k] - q[j][k]).powi(2);
                }
                energy += charge / r2.sqrt();
            }
        }
        energy
    }
}

/// Rotors in a row.
struct Rotors;

#[hamiltonian]
impl Rotors {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        (1..q.len()).map(|i| 1.0 - (q[i] - q[i - 1]).cos()).sum()
    }
}

/// Numbers of bodies: some that fill rows and some that do not, of which lists of neighbours are made, and whose pairs are
/// summed in chunks.
fn sizes() -> impl Iterator<Item = usize> {
    (2..=26).chain([391, 520])
}

fn points(bodies: usize) -> Phase<Vec<[f64; 3]>> {
    let spread = |i: usize, k: usize| 0.2 * ((5 * i + 3 * k) as f64).sin();
    let site = |i: usize| [i % 8, i / 8 % 8, i / 64];
    let q = (0..bodies).map(|i| [0, 1, 2].map(|k| 1.1 * site(i)[k] as f64 + spread(i, k))).collect();
    Phase::new(q, (0..bodies).map(|i| [0, 1, 2].map(|k| spread(i, k + 1))).collect())
}

fn charges(bodies: usize, acting: usize) -> Charges {
    Charges {
        acting,
        charges: (0..bodies).map(|i| 1.0 + 0.5 * (i as f64).cos()).collect(),
        masses: (0..bodies).map(|i| 1.0 + (i % 3) as f64).collect(),
        bonds: (1..acting).map(|i| [i - 1, i]).collect(),
    }
}

/// Compares energies at a state with this many positive terms. Each sum of `n` of them has an error of at most `n` roundings of
/// itself, in any order, and a term one of a few.
fn compare<C: integrator_core::Coords>(name: &str, run: &Run<C>, terms: usize, [kinetic, potential]: [f64; 2]) {
    let bound = (terms + 20) as f64 * f64::EPSILON;
    for (part, found, stated) in [("T", run.kinetic(), kinetic), ("V", run.potential(), potential)] {
        assert!(stated > 0.0, "{name}: {part}");
        assert!((found - stated).abs() <= 2.0 * bound * stated, "{name}: {part} is {found}, and not {stated}");
    }
    let total = run.kinetic() + run.potential();
    assert!((run.energy() - total).abs() <= f64::EPSILON * total, "{name}: {}", run.energy());
}

#[test]
fn sums_over_pairs_are_those_of_the_functions() {
    for bodies in sizes() {
        for acting in [bodies, bodies - bodies / 4].into_iter().filter(|acting| *acting > 1) {
            let (system, name) = (charges(bodies, acting), format!("{acting} of {bodies} charges"));
            let mut run = system.run(points(bodies), 0.01).expect("a good start");
            for _ in 0..2 {
                let state = run.state();
                let stated = [system.kinetic(&state.p), system.potential(&state.q)];
                compare(&name, &run, acting * (acting + 1) / 2 + 3 * bodies, stated);
                run.advance(3).expect("bounded");
            }
        }
        let (system, name) = (Relativistic { cutoff: 1.7 }, format!("{bodies} bodies within a cutoff"));
        let mut run = system.run(points(bodies), 0.01).expect("a good start");
        for _ in 0..2 {
            let state = run.state();
            let stated = [system.kinetic(&state.p), system.potential(&state.q)];
            if stated[1] > 0.0 {
                compare(&name, &run, bodies * bodies, stated);
            }
            run.advance(3).expect("bounded");
        }
        let (start, name) = (points(bodies), format!("{bodies} saturated bonds"));
        let run = Saturated.run(start.clone(), 0.01).expect("a good start");
        compare(&name, &run, bodies * bodies, [Saturated.kinetic(&start.p), Saturated.potential(&start.q)]);
    }
}

/// Steps read conditions on the time in their middle, energies where they are.
#[test]
fn energies_are_those_of_their_time() {
    let start = points(12);
    let own =
        |state: &Phase<Vec<[f64; 3]>>, time| [Switched.kinetic(&state.p, time), Switched.potential(&state.q, time)];
    for begin in [0.0, 0.96, 1.5, 1.97, 3.0] {
        let mut run = Switched.run(start.clone(), 0.1).expect("a good start").at_time(begin);
        compare("a start", &run, 100, own(&run.state(), begin));
        run.advance(1).expect("bounded");
        compare("a step", &run, 100, own(&run.state(), run.time()));
        let sample = run.clone().samples(1).next().expect("one").expect("bounded");
        assert_eq!(sample.energy().to_bits(), run.energy().to_bits(), "{begin}");
        run.advance_to(begin + 0.17).expect("bounded");
        compare("within a step", &run, 100, own(&run.state(), run.time()));
    }
    let members = (0..9).map(|_| (Switched, start.clone()));
    let mut swarm = Ensemble::new(Verlet, members, 0.1).expect("good starts").at_time(1.9);
    swarm.advance(2).expect("bounded");
    let [kinetic, potential] = own(&swarm.state(8).expect("a member"), swarm.time());
    let total = kinetic + potential;
    assert!((swarm.energies()[8] - total).abs() <= 300.0 * f64::EPSILON * total);
}

#[test]
fn sums_in_lanes_are_those_of_the_functions() {
    for sites in (2..=50).chain([1_000, 1_003]) {
        let start = |k: usize| (0..sites).map(|i| 0.7 * ((i + k) as f64 * 1.3).sin()).collect::<Vec<f64>>();
        let mut run = Rotors.run(Phase::new(start(1), start(5)), 0.1).expect("a good start");
        run.advance(3).expect("bounded");
        let state = run.state();
        // `1 - cos` of a small angle has an error of a rounding of one.
        let angles = state.q.windows(2).map(|pair| pair[1] - pair[0]);
        let lost = angles.map(|angle| 1.0 / (1.0 - angle.cos()).max(1e-3)).fold(1.0, f64::max).ceil() as usize;
        compare(
            &format!("{sites} rotors"),
            &run,
            sites + 2 * lost,
            [Rotors.kinetic(&state.p), Rotors.potential(&state.q)],
        );
    }
}

/// Of a run, of its samples, of a run that begins there, of a changed state, and on more threads.
#[test]
fn every_way_to_an_energy_has_its_bits() {
    fn check<H: Hamiltonian<Coords = C>, C>(system: &H, start: Phase<C>)
    where
        C: integrator_core::Coords<Leaf = f64, With<f64> = C>,
    {
        let mut run = system.run(start, 0.01).expect("a good start").with_threads(1);
        let mut shared = run.clone().with_threads(3);
        for _ in 0..3 {
            run.advance(4).expect("bounded");
            shared.advance(4).expect("bounded");
            let energy = run.energy().to_bits();
            assert_eq!(shared.energy().to_bits(), energy);
            let again = system.run(run.state(), 0.01).expect("a good start");
            assert_eq!(again.energy().to_bits(), energy);
            let mut changed = run.clone();
            changed.map_state(|state| *state = state.reversed().reversed()).expect("finite");
            assert_eq!(changed.energy().to_bits(), energy);
            // The first sample is the present state.
            let sample = run.clone().samples(1).next().expect("one").expect("bounded");
            assert_eq!(sample.energy().to_bits(), energy);
        }
    }
    for bodies in [5, 12, 130, 520] {
        check(&charges(bodies, bodies - 2), points(bodies));
        check(&Relativistic { cutoff: 1.7 }, points(bodies));
    }
    check(&Rotors, Phase::new((0..99).map(|i| f64::from(i).sin()).collect(), vec![0.1; 99]));
}

/// In lanes, each member with its own lists and constants.
#[test]
fn energies_of_members_are_those_of_each() {
    let member = |seed: usize| {
        let mut system = charges(12, 11);
        system.charges.iter_mut().for_each(|charge| *charge += 0.01 * seed as f64);
        (system, points(12))
    };
    let mut swarm = Ensemble::new(Verlet, (0..11).map(member), 0.01).expect("good starts");
    for time in [0.0, 0.04, 0.05] {
        swarm.advance_to(time).expect("bounded");
        let energies = swarm.energies();
        assert_eq!(energies.len(), 11);
        for (member, energy) in energies.iter().enumerate() {
            assert_eq!(Some(energy.to_bits()), swarm.energy(member).map(f64::to_bits), "{member} at {time}");
        }
        swarm.map_states(|_, state| *state = state.reversed()).expect("finite");
        assert_eq!(swarm.energies(), energies);
    }
}
