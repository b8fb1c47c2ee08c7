//! Lattices, whose flows run along neighbouring sites in blocks, tiles and threads, and lists, whose terms share vectors: no
//! bit tells which.
//!
//! All of it holds on every instruction set. A process uses one, so [`instruction_sets`] runs these tests again in a
//! process for each of the others.

mod every_length;
mod flat_planes;
#[path = "../support/instruction_sets.rs"]
mod instruction_sets;
mod lists;
mod planes;
mod tiles;
mod volumes;
