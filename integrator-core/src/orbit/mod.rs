//! Orbital elements: conversion to states, from which runs start, and back.
//!
//! [`Elements`] describe one orbit around a centre, on any conic section. [`state`] and [`elements`] convert whole systems with
//! masses, heliocentric or in Jacobi coordinates ([`Frame`]). Angles are in radians. Lengths, times and masses have the units of
//! the gravitational constant that you pass.
//!
//! ```
//! use integrator_core::{
//!     orbit::{self, Anomaly, Elements, Frame},
//!     prelude::*,
//! };
//!
//! struct Planets {
//!     mass: [f64; 3],
//! }
//!
//! #[hamiltonian(coordinates = jacobi(self.mass), split = kepler + interaction, compose = WisdomHolmanTouma17)]
//! impl Planets {
//!     fn kinetic(&self, p: [[f64; 3]; 3]) -> f64 {
//!         (0..3).map(|i| (0..3).map(|d| p[i][d].powi(2)).sum::<f64>() / (2.0 * self.mass[i])).sum()
//!     }
//!     fn potential(&self, q: [[f64; 3]; 3]) -> f64 {
//!         let mut energy = 0.0;
//!         for i in 0..3 {
//!             for j in 0..i {
//!                 let square = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
//!                 energy -= self.mass[i] * self.mass[j] / square.sqrt();
//!             }
//!         }
//!         energy
//!     }
//! }
//!
//! // Units with G = 1: solar masses, astronomical units, and years over 2π.
//! let planets = Planets { mass: [1.0, 9.5e-4, 2.9e-4] };
//! let jupiter = Elements { inclination: 0.0227, node: 1.755, argument: -1.499, ..Elements::with_axis(5.203, 0.048) };
//! let saturn = Elements { anomaly: Anomaly::Mean(0.87), ..Elements::with_axis(9.537, 0.054) };
//! let start: Phase<[[f64; 3]; 3]> = orbit::state(Frame::Jacobi, 1.0, &planets.mass, &[jupiter, saturn])?;
//!
//! let mut run = planets.run(start, jupiter.period(1.0) / 20.0)?;
//! run.advance(1_000)?;
//! let after = orbit::elements(Frame::Jacobi, 1.0, &planets.mass, &run.state())?;
//! assert!((after[0].axis() - 5.203).abs() < 0.02);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bodies;
mod elements;
mod error;
mod osculating;

pub use bodies::{Frame, elements, state};
pub use elements::{Anomaly, Elements};
pub use error::OrbitError;
