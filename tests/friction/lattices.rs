//! Long lattices in baths: tiles and threads have the bits of one flow after the other.

use crate::Chain;
use integrator_core::prelude::*;

/// The φ⁴ field on a square lattice, closed in both directions, in a bath.
struct Plane;

const SIDE: usize = 96;

#[hamiltonian(split = kinetic + potential + friction)]
impl Plane {
    fn kinetic(&self, p: &[[f64; SIDE]; SIDE]) -> f64 {
        p.iter().flatten().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; SIDE]; SIDE]) -> f64 {
        let mut energy = 0.0;
        for i in 0..SIDE {
            for j in 0..SIDE {
                energy += (q[i][(j + 1) % SIDE] - q[i][j]).powi(2) / 2.0;
                energy += (q[(i + 1) % SIDE][j] - q[i][j]).powi(2) / 2.0 + (q[i][j].powi(2) - 1.0).powi(2) / 8.0;
            }
        }
        energy
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        400.0
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        2.0
    }
}

/// The end of three steps, which is the same on one thread, in portions on two, and in an ensemble, whose members are in lanes.
fn end<H, C>(system: impl Fn() -> H, start: &Phase<C>) -> Phase<C>
where
    H: Hamiltonian<Coords = C>,
    C: integrator_core::Coords<Leaf = f64, With<f64> = C>,
    Baoab: integrator_core::InLanes<H>,
{
    let end = |threads: usize, portions: &[u64]| {
        let run = system().run_with(Baoab, start.clone(), 0.01).expect("a run");
        let mut run = run.with_seed(3).with_threads(threads);
        portions.iter().for_each(|steps| run.advance(*steps).expect("steps"));
        run.state()
    };
    let one = end(1, &[3]);
    assert!(end(2, &[2, 1]) == one, "threads");
    let mut swarm = Ensemble::new(Baoab, [(system(), start.clone())], 0.01).expect("an ensemble").with_seed(3);
    swarm.advance(3).expect("steps");
    assert!(swarm.state(0).as_ref() == Some(&one), "lanes");
    one
}

#[test]
fn a_chain_has_the_same_bits_on_threads_and_in_an_ensemble() {
    // Enough for tiles and for two threads.
    let length = 140_000;
    end(|| Chain { length }, &Phase::new((0..length).map(|i| (i % 7) as f64 / 10.0).collect(), vec![0.1; length]));
}

#[test]
fn a_plane_has_the_same_bits_on_threads_and_in_an_ensemble() {
    // Without optimisation, copies of the arrays fill the stack of a test.
    let thread = std::thread::Builder::new().stack_size(1 << 26).spawn(plane).expect("a thread");
    thread.join().expect("a plane");
}

fn plane() {
    let start = Phase::new([[1.0; SIDE]; SIDE], [[0.0; SIDE]; SIDE]);
    let end = end(|| Plane, &start);
    // Friction of rate 400 leaves exp(-4) of a momentum at the middle of a step, so that those of all sites are independent.
    let count = (SIDE * SIDE) as f64;
    let flat: Vec<f64> = end.p.iter().flatten().map(|p| p / 2.0_f64.sqrt()).collect();
    let mean = |lag: usize| (0..flat.len()).map(|i| flat[i] * flat[(i + lag) % flat.len()]).sum::<f64>() / count;
    // Kicks of half a step change momenta by some hundredths.
    assert!((mean(0) - 1.0).abs() < 5.0 * (2.0 / count).sqrt() + 0.02, "{}", mean(0));
    for lag in [1, 2, 3, 8, 16, SIDE, SIDE + 1] {
        assert!(mean(lag).abs() < 5.0 / count.sqrt() + 0.01, "{lag}: {}", mean(lag));
    }
}
