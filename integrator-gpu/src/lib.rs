//! Ensembles of Hamiltonian systems on a GPU.
//!
//! `#[hamiltonian(gpu)]` writes the flows of a system also as C++; this crate compiles them with NVRTC when an ensemble is
//! made, and launches them through the driver. Both libraries are loaded then and not before, so that everything builds and
//! is tested without them.

mod column;
mod columns;
mod composed;
mod cuda;
mod ensemble;
mod error;
mod host;
mod launch;
mod looks;
mod place;

pub use ensemble::{Device, Ensemble};
pub use error::Error;

/// Compiles the kernels of a system, whose text is `#[hamiltonian(gpu)]`'s, in double precision and for any composition: what can be
/// known of them without a device.
///
/// # Errors
/// [`Error::Compiler`] where NVRTC cannot be loaded, [`Error::Kernel`] where they do not compile.
pub fn compile<H: integrator_core::__private::DeviceText>() -> Result<String, Error> {
    Ok(cuda::compiled(&(launch::ANY_COMPOSITION.to_owned() + H::TEXT), "f64")?.to_src())
}
