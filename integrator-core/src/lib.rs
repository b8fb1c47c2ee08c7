//! Symplectic splitting integrators.
