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
        "there is no NVIDIA driver: libcuda cannot be loaded\nhelp: install the driver, or use `Device::Best`, which \
         falls back to the processor"
    )]
    Driver,
    /// The library that compiles kernels, NVRTC, is not installed, or cannot be loaded.
    #[error(
        "there is no NVRTC: libnvrtc cannot be loaded\nhelp: install the CUDA toolkit, or write `pip install \
         nvidia-cuda-nvrtc-cu12` and add its folder `lib` to LD_LIBRARY_PATH"
    )]
    Compiler,
    /// The driver does not support the output of this version of NVRTC.
    #[error(
        "the driver cannot load kernels of this NVRTC, which is newer\nhelp: install a newer driver, or the NVRTC of the \
         CUDA version that `nvidia-smi` prints, as in `pip install 'nvidia-cuda-nvrtc-cu12==12.4.*'`"
    )]
    NewerCompiler,
    /// The machine has no device with this index.
    #[error("there is no device {0}: the driver reports {1}\nhelp: `nvidia-smi` lists the devices")]
    NoDevice(usize, usize),
    /// The members do not fit into the memory of the device.
    #[error(
        "{0} members require {1} MiB, which is more than the free memory of the device\nhelp: integrate fewer members at \
         a time"
    )]
    Memory(usize, usize),
    /// A list of a member is longer than the limit of the device code.
    #[error(
        "member {0} has a list of more than 16 elements, which the device code does not support here\nhelp: write the \
         end of the loop as a literal, as in `for i in 0..40`\nnote: a loop up to a field or a constant reads this list"
    )]
    List(usize),
    /// The kernel does not compile, because of a bug in this library.
    #[error("the kernel does not compile: {0}\nhelp: please report this as a bug")]
    Kernel(String),
    /// A call of the driver failed.
    #[error(
        "the driver reports {0}\nhelp: resume from a checkpoint, on another device or with `Device::Best`\nnote: the \
         members on this device are lost"
    )]
    Call(String),
    /// The program for [`Device::Text`](crate::Device::Text) could not be built or run.
    #[error("the program of the device code failed: {0}")]
    Program(String),
    /// The checkpoint has other members or another method, or is damaged.
    #[error("{0}")]
    Checkpoint(String),
    /// Members diverged. They keep their last finite states; the others have taken the steps.
    #[error(transparent)]
    Lost(Lost),
}

/// Failed members have a variant of their own, wherever they were computed.
impl From<CoreError> for Error {
    fn from(error: CoreError) -> Self {
        match error {
            CoreError::Lost(lost) => Self::Lost(lost),
            other => Self::Core(other),
        }
    }
}
