//! Errors of ensembles on a device.

use integrator_core::{Error as CoreError, Lost};

/// The reason why an ensemble on a device failed, with a remedy.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A member or a step is invalid, for the reasons of an ensemble on the processor.
    #[error(transparent)]
    Core(CoreError),
    /// The NVIDIA driver library is not installed, or cannot be loaded.
    #[error(
        "no NVIDIA driver: libcuda cannot be loaded; install the driver, or take `Device::Best`, which falls back to the processor"
    )]
    Driver,
    /// The library that compiles kernels, NVRTC, is not installed, or cannot be loaded.
    #[error(
        "no NVRTC: libnvrtc cannot be loaded; it comes with the CUDA toolkit and with `pip install nvidia-cuda-nvrtc-cu12`, whose \
         folder `lib` belongs into LD_LIBRARY_PATH"
    )]
    Compiler,
    /// The driver does not support the output of this version of NVRTC.
    #[error(
        "NVRTC is newer than the driver, which cannot load its kernels: take a newer driver, or the NVRTC of the CUDA version that \
         `nvidia-smi` names, as by `pip install 'nvidia-cuda-nvrtc-cu12==12.4.*'`"
    )]
    NewerCompiler,
    /// The machine has no device with this index.
    #[error("no device {0}: the driver knows {1}; `nvidia-smi` lists them")]
    NoDevice(usize, usize),
    /// The members do not fit into the memory of the device.
    #[error("{0} members take {1} MiB, more than the device has free: take fewer of them at a time")]
    Memory(usize, usize),
    /// A list of a member is longer than the limit of the device code.
    #[error(
        "member {0} has a list of more than 16 elements that is read in a loop whose end is a field or a constant, and a device has \
         room for 16: let the loop run to a number, as in `for i in 0..40`"
    )]
    List(usize),
    /// The kernel does not compile, because of a bug in this library.
    #[error("the kernel does not compile, please report it: {0}")]
    Kernel(String),
    /// A call of the driver failed.
    #[error(
        "the driver says {0}; nothing more can be asked of these members: go on from a checkpoint, on another device or with \
         `Device::Best`"
    )]
    Call(String),
    /// The program for [`Device::Text`](crate::Device::Text) could not be built or run.
    #[error("the program of the text for devices: {0}")]
    Program(String),
    /// The checkpoint has other members or another method, or is damaged.
    #[error("{0}")]
    Checkpoint(String),
    /// Members diverged. They keep their last finite states; the others have taken the steps.
    #[error(transparent)]
    Lost(Lost),
}

/// Members that are lost have a name of their own, wherever they were.
impl From<CoreError> for Error {
    fn from(error: CoreError) -> Self {
        match error {
            CoreError::Lost(lost) => Self::Lost(lost),
            other => Self::Core(other),
        }
    }
}
