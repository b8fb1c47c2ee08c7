//! The Hamiltonians of the cookbook, each certified.

#[path = "../examples/cookbook/beams.rs"]
mod beams;
#[path = "../examples/cookbook/edges.rs"]
mod edges;
#[path = "../examples/cookbook/galaxies.rs"]
mod galaxies;
#[path = "../examples/cookbook/lattices.rs"]
mod lattices;
#[path = "../examples/cookbook/molecules.rs"]
mod molecules;
#[path = "../examples/cookbook/planets.rs"]
mod planets;
#[path = "../examples/cookbook/plasmas.rs"]
mod plasmas;
#[path = "../examples/cookbook/samplers.rs"]
mod samplers;
#[path = "../examples/cookbook/teaching.rs"]
mod teaching;

use integrator_core::{Method, prelude::*};

/// A wave in a ring of eight, of no symmetry.
const RING: [f64; 8] = [0.1, 0.5, 0.3, -0.2, -0.4, -0.1, 0.2, 0.0];

/// Holds a system to everything that a certificate holds, its invariants among it.
fn certified<H: Hamiltonian>(system: &H, start: Phase<H::Coords>, h: f64) {
    certified_by(system, Verlet, start, h);
}

/// The same by another method than Verlet.
fn certified_by<H: Hamiltonian, X: Method<H>>(system: &H, method: X, start: Phase<H::Coords>, h: f64) {
    if let Err(error) = certify(system, method, start, h) {
        panic!("{error}");
    }
}

#[test]
fn planets_are_certified() {
    use planets::*;
    certified(&Kepler { strength: 1.0 }, Phase::new([1.0, 0.0], [0.0, 0.9]), 0.02);
    certified(&Satellite { flattening: 0.01 }, Phase::new([1.0, 0.0, 0.0], [0.0, 0.8, 0.6]), 0.02);
    certified(&BlackHole { radius: 0.05 }, Phase::new([1.0, 0.0], [0.0, 1.0]), 0.02);
    certified(&SpinOrbit { asphericity: 0.2, eccentricity: 0.05 }, Phase::new([0.3], [1.2]), 0.05);
    certified(
        &FigureEight,
        Phase::new(
            [[0.970_004_36, -0.243_087_53], [-0.970_004_36, 0.243_087_53], [0.0, 0.0]],
            [[0.466_203_685, 0.432_365_73], [0.466_203_685, 0.432_365_73], [-0.932_407_37, -0.864_731_46]],
        ),
        0.01,
    );
}

#[test]
fn molecules_are_certified() {
    use molecules::*;
    certified(&Morse { depth: 1.0, width: 1.0 }, Phase::new([0.5], [0.3]), 0.05);
    certified(&Stretches { coupling: 0.2 }, Phase::new([0.3, -0.1], [0.1, 0.2]), 0.05);
    certified(&Butane { inertia: 1.0 }, Phase::new([0.3], [1.0]), 0.005);
    certified(&Trimer, Phase::new([[0.0, 0.0, 0.0], [1.15, 0.0, 0.0], [0.5, 1.0, 0.1]], [[0.0; 3]; 3]), 0.002);
}

#[test]
fn beams_are_certified() {
    use beams::*;
    certified(&Sextupole { strength: 0.3 }, Phase::new([0.3, 0.2], [0.1, 0.0]), 0.05);
    certified(&Bucket { slip: 0.5, synchronous: 0.3 }, Phase::new([0.5], [0.2]), 0.05);
    certified(&PeriodicPotential { amplitude: 0.5 }, Phase::new([2.0], [0.6]), 0.05);
}

#[test]
fn plasmas_are_certified() {
    use plasmas::*;
    certified(&TwoWaves { first: 0.1, second: 0.1 }, Phase::new([0.3], [0.4]), 0.05);
    certified(&PaulTrap { a: 0.0, q: 0.3 }, Phase::new([0.5], [0.1]), 0.05);
    certified(&IonChain, Phase::new([-1.1, 0.1, 1.2], [0.1, 0.0, -0.2]), 0.02);
}

#[test]
fn lattices_are_certified() {
    use lattices::*;
    certified(&Fput { cubic: 0.25 }, Phase::new(RING, [0.0; 8]), 0.05);
    certified(&Toda, Phase::new(RING, [0.0; 8]), 0.05);
    certified(&FrenkelKontorova { ground: 0.5 }, Phase::new(RING, [0.0; 8]), 0.05);
    certified(&PhiFour, Phase::new(RING, [0.0; 8]), 0.05);
    certified(&Rotors { coupling: 0.8 }, Phase::new(RING, [0.0; 8]), 0.05);
}

#[test]
fn galaxies_are_certified() {
    use galaxies::*;
    certified(&HenonHeiles { coupling: 1.0 }, Phase::new([0.1, 0.2], [0.2, 0.1]), 0.05);
    certified(&Logarithmic { core: 0.3, flattening: 0.8 }, Phase::new([0.7, 0.2], [0.1, 0.6]), 0.02);
    certified(&Disk { length: 1.0, height: 0.3 }, Phase::new([1.0, 0.0, 0.2], [0.0, 0.5, 0.1]), 0.05);
    certified(&Isochrone { length: 1.0 }, Phase::new([1.0, 0.0], [0.1, 0.4]), 0.05);
}

#[test]
fn samplers_are_certified() {
    use samplers::*;
    certified(&Correlated { correlation: 0.8 }, Phase::new([0.5, -0.3], [0.7, 0.2]), 0.02);
    certified(&Banana { bend: 0.5 }, Phase::new([0.5, -0.3], [0.7, 0.2]), 0.03);
    certified(&Funnel { width: 3.0 }, Phase::new([0.5, 0.4], [0.3, -0.6]), 0.02);
}

#[test]
fn teaching_are_certified() {
    use teaching::*;
    certified(&Pendulum { length: 1.0 }, Phase::new([1.5], [0.0]), 0.01);
    certified(&Duffing { stiffening: 1.0 }, Phase::new([1.0], [0.0]), 0.05);
    certified(&Swing { stiffness: 20.0 }, Phase::new([0.3, -1.4], [0.2, 0.0]), 0.01);
}

#[test]
fn edges_are_certified() {
    use edges::*;
    // Of eccentricity 0.99, from its aphelion; the step is one of the time that slows down near the star.
    let comet = Phase::new([1.99, 0.0], [0.0, (0.01_f64 / 1.99).sqrt()]);
    certified_by(&Comet, Logarithmic(Yoshida4), comet, 0.05);
    certified(&Pulse { strength: 0.5, on: 2.0, off: 5.0 }, Phase::new([0.3], [0.2]), 0.05);
    let q = vec![[0.1, 0.2], [0.9, 0.3], [0.4, 1.1]];
    let p = vec![[0.1, 0.0], [-0.1, 0.1], [0.0, -0.1]];
    certified(&Soft { cutoff: 1.5 }, Phase::new(q.clone(), p.clone()), 0.02);
    certified(&Periodic { side: 2.5, cutoff: 1.2 }, Phase::new(q, p), 0.02);
}
