//! A part that is a sum over pairs of many bodies, under force gradients: its force at rest is that of its pairs.

use integrator_core::prelude::*;

/// Ions on a line in a trap, whose motion without the ions' repulsion is exact.
struct Ions;

const IONS: usize = 34;

#[hamiltonian(split = trap + repulsion)]
impl Ions {
    fn trap(&self, q: [f64; IONS], p: [f64; IONS]) -> f64 {
        (0..IONS).map(|i| 0.5 * (p[i] * p[i] + q[i] * q[i])).sum()
    }
    fn repulsion(&self, q: [f64; IONS]) -> f64 {
        let mut energy = 0.0;
        for i in 0..IONS {
            for j in 0..i {
                energy += 0.02 / (1.0 + (q[i] - q[j]).powi(2));
            }
        }
        energy
    }
}

/// The end after so many steps of a time.
fn end(composition: impl integrator_core::Method<Ions>, steps: u32) -> [f64; IONS] {
    let start = Phase::new(std::array::from_fn(|i| 0.2 * i as f64 - 3.0), [0.1; IONS]);
    let mut run = Ions.run_with(composition, start, 4.0 / f64::from(steps)).expect("a start");
    run.advance(u64::from(steps)).expect("finite");
    run.state().q
}

#[test]
fn force_gradients_keep_their_order() {
    let run = Ions.run(Phase::new([0.0; IONS], [0.0; IONS]), 0.1).expect("a start");
    assert_eq!(run.layout().kick(), "pairs");
    let exact = end(KahanLi8, 512);
    let error = |steps: u32| {
        let squares = end(Chin4C, steps).into_iter().zip(exact).map(|(found, exact)| (found - exact).powi(2));
        squares.sum::<f64>().sqrt()
    };
    let (coarse, fine) = (error(32), error(64));
    // Errors of the next order still show; without the gradient of the force the order is 2.
    assert!((coarse / fine).log2() > 3.6, "{coarse:e}, {fine:e}");
}
