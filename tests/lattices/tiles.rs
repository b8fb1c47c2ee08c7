//! Long lattices in tiles and on threads, against the flows one after the other on the whole lattice.

use crate::every_length::{Ring, Second, Walls, start};
use integrator_core::prelude::*;

const STEP: f64 = 0.01;

/// Lengths around the one from which on there are tiles, and around borders of tiles.
const TILED: [usize; 4] = [3071, 3072, 3073, 5 * 1024 + 1];

/// Lengths that are worth two threads, and three.
const SHARED: [usize; 2] = [2 * 4 * 1024 + 13, 3 * 4 * 1024 + 1];

/// The state after `steps` steps by one composition, on so many threads, with `advance` called for `portion` at a time.
fn after<H, X>(system: &H, start: Phase<Vec<f64>>, threads: usize, portion: u64) -> Phase<Vec<f64>>
where
    H: Hamiltonian<Coords = Vec<f64>>,
    X: Composition<H>,
{
    let mut run = system.run_with(X::default(), start, STEP).expect("a start").with_threads(threads);
    for _ in 0..18 / portion {
        run.advance(portion).expect("finite states");
    }
    run.state()
}

/// One step at a time is a flow or a few at a time, which hardly lean. All at once fill the tiles, which lean far back.
fn tiles_change_no_bit<H, X>(of: impl Fn(usize) -> H, lengths: &[usize], ways: &[(usize, u64)])
where
    H: Hamiltonian<Coords = Vec<f64>>,
    X: Composition<H>,
{
    for sites in lengths.iter().copied() {
        let system = of(sites);
        let expected = after::<H, X>(&system, start(sites), 1, 1);
        for (threads, portion) in ways.iter().copied() {
            let state = after::<H, X>(&system, start(sites), threads, portion);
            assert!(state == expected, "{sites} sites, {threads} threads, {portion} steps at a time");
        }
    }
}

#[test]
fn tiles_change_no_bit_of_any_composition() {
    tiles_change_no_bit::<_, Verlet>(|_| Walls, &TILED, &[(1, 18), (1, 6)]);
    tiles_change_no_bit::<_, VelocityVerlet>(Ring::example, &TILED, &[(1, 18), (1, 6)]);
    tiles_change_no_bit::<_, Yoshida4>(Second::example, &TILED, &[(1, 18)]);
    tiles_change_no_bit::<_, KahanLi8>(Ring::example, &TILED[3..], &[(1, 18)]);
}

#[test]
fn threads_change_no_bit() {
    tiles_change_no_bit::<_, Verlet>(|_| Walls, &SHARED, &[(1, 18), (2, 18), (3, 18), (4, 18)]);
    tiles_change_no_bit::<_, VelocityVerlet>(Ring::example, &SHARED[..1], &[(2, 18)]);
    tiles_change_no_bit::<_, Verlet>(Second::example, &SHARED[1..], &[(3, 18)]);
}
