//! Hand-written steppers, with which the benches compare the generated code.
//!
//! | file | contents |
//! |---|---|
//! | [`plain`] | the five problems in safe Rust without vectors, in code compiled for fused multiply-add |
//! | [`points`] | pendulum, Hénon–Heiles and Kepler over any vector: a single trajectory or lanes of an ensemble |
//! | [`oscillators`] | Hénon–Heiles split into oscillators (precomputed rotations) and the cubic rest |
//! | [`swarm`] | ensembles of the systems in `points`, several vectors in flight |
//! | [`pace`] | two bodies with the logarithmic Hamiltonian |
//! | [`carried`] | small systems with compensated states |
//! | [`row`] | six bodies, and 32 sites of a chain, in SIMD lanes |
//! | [`orbits`] | five planets on Kepler orbits, in SIMD lanes |
//! | [`chain`] | long chains in one pass per step, several steps per tile, and in two plain passes |
//! | [`field`] | the φ⁴ field on a plane or a volume: one pass per step, several steps per pass, and two plain passes |
//! | [`tangent`] | a state and one deviation vector |
//! | [`taylor`] | Taylor integrators of the five problems |
//! | `liquid` | atoms with a cutoff in a box, with neighbour lists; AVX-512 only |
//! | [`molecule`] | lists of bonds, angles and dihedrals, a vector of terms at a time |
//! | [`tiles`] | many bodies: pairs in tiles, with Newton's third law |

pub mod carried;
pub mod chain;
pub mod field;
pub mod law;
#[cfg(target_arch = "x86_64")]
pub mod liquid;
pub mod molecule;
pub mod orbits;
pub mod oscillators;
pub mod pace;
pub mod plain;
pub mod points;
pub mod row;
pub mod swarm;
pub mod tangent;
pub mod taylor;
pub mod tiles;
