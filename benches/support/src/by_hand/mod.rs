//! What a person would write who has the time: the yardsticks of the benches.
//!
//! | file | holds |
//! |---|---|
//! | [`plain`] | the five problems in safe Rust without vectors, in code compiled for fused multiply-add |
//! | [`points`] | pendulum, Hénon-Heiles and Kepler over any vector: a single trajectory or lanes of an ensemble |
//! | [`oscillators`] | Hénon-Heiles as oscillators that turn by prepared angles, and kicks of the rest |
//! | [`swarm`] | ensembles of these, several vectors in flight |
//! | [`pace`] | two bodies in steps of the logarithmic Hamiltonian |
//! | [`carried`] | small systems that carry the rounding errors of their updates |
//! | [`row`] | six bodies, and 32 sites of a chain, side by side in registers |
//! | [`orbits`] | five planets on Kepler orbits side by side in registers |
//! | [`chain`] | long chains in one pass per step, several steps per tile, and in two plain passes |
//! | [`field`] | the φ⁴ field on a plane or a volume, in one pass per step, several steps one after the other, and in two plain passes |
//! | [`tangent`] | a state and one deviation vector beside it |
//! | [`taylor`] | Taylor integrators of the five problems |
//! | `liquid` | atoms with a cutoff in a box, over lists of neighbours; for AVX-512 alone |
//! | [`molecule`] | bonds, angles and dihedrals in lists, a vector of them at a time |
//! | [`tiles`] | many bodies, pairs in tiles that use the third law |

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
