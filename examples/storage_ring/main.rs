//! Computes the tune and the dynamic aperture of a storage ring of FODO cells.
//!
//! The elements of a cell are the parts of H. The program compares the tune of small oscillations with that of the matrices of
//! the textbook. The last table shows the amplitude beyond which the sextupoles lose a particle. Smaller amplitudes stay,
//! larger ones are lost after some turns, and the border is sharp.

mod ring;

use integrator_core::prelude::*;
use ring::{Cell, tracked_advance};
use std::f64::consts::TAU;

const CELL: Cell = Cell { quadrupole: 0.5, gradient: 0.6, drift: 2.0, sextupole: 0.4 };
const CELLS: u64 = 100_000;

fn main() -> Result<(), Error> {
    let advances = CELL.phase_advances();
    for (name, axis) in [("x", 0), ("y", 1)] {
        let tracked = tracked_advance(&CELL, axis)?;
        println!("tune of a cell in {name}: {:.9} by matrices, {:.9} tracked", advances[axis] / TAU, tracked / TAU);
    }
    println!("{:>10} {:>10}", "x (mm)", "cells");
    for millimetres in (80..=160).step_by(10) {
        let start = Phase::new([1e-3 * f64::from(millimetres), 1e-3], [0.0; 2]);
        let cells = CELL.survives(start, CELLS, 10.0)?;
        println!("{millimetres:>10} {:>10}", if cells == CELLS { "all".to_owned() } else { cells.to_string() });
    }
    Ok(())
}
