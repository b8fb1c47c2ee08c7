//! Ensembles of Hamiltonian systems on a GPU.
//!
//! `#[hamiltonian(gpu)]` generates the flows of a system as C++ as well. When an ensemble is created, this crate
//! compiles them with NVRTC and launches them through the driver. Both libraries are loaded at that time only, so a
//! program builds, and its tests run, without them.

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

/// Compiles the kernels of a system in double precision, for any composition; needs no device.
///
/// The code of the kernels is the one that `#[hamiltonian(gpu)]` generates.
///
/// # Errors
/// - [`Error::Compiler`]: NVRTC cannot be loaded.
/// - [`Error::Kernel`]: the kernels do not compile.
pub fn compile<H: integrator_core::__private::DeviceText>() -> Result<String, Error> {
    Ok(cuda::compiled(&(launch::ANY_COMPOSITION.to_owned() + H::TEXT), "f64")?.to_src())
}
