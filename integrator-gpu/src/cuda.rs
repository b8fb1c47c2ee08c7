//! Launches on a CUDA device, whose libraries are loaded when the first ensemble needs them.

use crate::{
    error::Error,
    host::{Memory, RUNTIME},
    launch::Launch,
};
use cudarc::{
    driver::{
        CudaContext, CudaFunction, CudaSlice, CudaStream, DeviceRepr, DriverError, LaunchConfig, PushKernelArg,
        sys as driver, sys::CUresult,
    },
    nvrtc::{CompileError, CompileOptions, Ptx, compile_ptx_with_opts, sys as nvrtc},
};
use std::sync::Arc;

/// The threads of a block: few, since each holds the whole state of a member in registers.
const THREADS: u32 = 128;

/// The functions of a module, which a driver finds by their names.
const ADVANCE: &str = "advance";
const SHOW: &str = "show";

// SAFETY: `Launch` is `repr(C)` with fields of the same types and order as in `stepper.h`, and plain numbers alone.
unsafe impl DeviceRepr for Launch {}

/// The text of a module: that of the runtime, of a system with its composition, and two kernels in one precision.
fn module_text(text: &str, precision: &str) -> String {
    let runtime = RUNTIME.concat();
    let (scalar, slot) = match precision {
        "f32" => ("float", "Plain"),
        "compensated f64" => ("double", "Compensated"),
        _ => ("double", "Plain"),
    };
    let kernel = |name: &str, lost: &str| {
        format!(
            "extern \"C\" __global__ void {name}(integrator::Launch launch, const integrator::Stage* stages, const double* \
             constants, const double* from, double* to, {lost}unsigned long long* lost) {{\n    \
             integrator::Member<integrator::System, integrator::Composed, {scalar}, \
             integrator::{slot}<{scalar}>>::{name}(launch, stages, constants, from, to, lost);\n}}\n"
        )
    };
    let (advance, show) = (kernel(ADVANCE, ""), kernel(SHOW, "const "));
    format!("{runtime}namespace integrator {{\n{text}}}\n{advance}{show}")
}

/// Compiles the kernels of a system with its composition in a precision, to the assembly that any driver takes.
///
/// # Errors
/// [`Error::Compiler`], [`Error::Kernel`]
pub(crate) fn compiled(text: &str, precision: &str) -> Result<Ptx, Error> {
    // SAFETY: nothing but the search for a library.
    if !unsafe { nvrtc::is_culib_present() } {
        return Err(Error::Compiler);
    }
    let options = ["--std=c++17", "--fmad=false", "-diag-suppress=177"].map(str::to_owned).into();
    let options = CompileOptions { options, ..CompileOptions::default() };
    compile_ptx_with_opts(module_text(text, precision), options).map_err(|error| match error {
        CompileError::CompileError { log, .. } => Error::Kernel(log.to_string_lossy().into_owned()),
        other => Error::Kernel(other.to_string()),
    })
}

/// Members on a device: their constants and stages, and two arrays of states, of which each launch reads one and writes the
/// other.
pub(crate) struct Members {
    stream: Arc<CudaStream>,
    advance: CudaFunction,
    show: CudaFunction,
    stages: CudaSlice<f64>,
    constants: CudaSlice<f64>,
    state: CudaSlice<f64>,
    other: CudaSlice<f64>,
    lost: CudaSlice<u64>,
    blocks: u32,
}

impl Members {
    /// Moves members to a device.
    ///
    /// # Errors
    /// [`Error::Driver`], [`Error::NoDevice`], [`Error::Compiler`], [`Error::Kernel`], [`Error::NewerCompiler`], [`Error::Memory`],
    /// [`Error::Call`]
    pub(crate) fn new(ordinal: usize, text: &str, precision: &str, memory: &Memory) -> Result<Self, Error> {
        // SAFETY: nothing but the search for a library.
        if !unsafe { driver::is_culib_present() } {
            return Err(Error::Driver);
        }
        let count = CudaContext::device_count().map_err(|_| Error::NoDevice(ordinal, 0))?;
        if ordinal >= count as usize {
            return Err(Error::NoDevice(ordinal, count as usize));
        }
        let module = compiled(text, precision)?;
        let members = memory.lost.len() - 1;
        let bytes = 8 * (memory.constants.len() + 2 * memory.state.len() + members);
        let refused = |error: DriverError| match error.0 {
            CUresult::CUDA_ERROR_OUT_OF_MEMORY => Error::Memory(members, bytes >> 20),
            CUresult::CUDA_ERROR_UNSUPPORTED_PTX_VERSION => Error::NewerCompiler,
            _ => Error::Call(error.to_string()),
        };
        let context = CudaContext::new(ordinal).map_err(refused)?;
        let module = context.load_module(module).map_err(refused)?;
        let stream = context.default_stream();
        let stages: Vec<f64> = memory.stages.iter().flatten().copied().collect();
        // No array is empty: a system without constants has one that nobody reads.
        let constants = if memory.constants.is_empty() { &[0.0][..] } else { &memory.constants };
        Ok(Self {
            advance: module.load_function(ADVANCE).map_err(refused)?,
            show: module.load_function(SHOW).map_err(refused)?,
            stages: stream.clone_htod(&stages).map_err(refused)?,
            constants: stream.clone_htod(constants).map_err(refused)?,
            state: stream.clone_htod(&memory.state).map_err(refused)?,
            other: stream.clone_htod(&memory.state).map_err(refused)?,
            lost: stream.clone_htod(&memory.lost).map_err(refused)?,
            blocks: u32::try_from(members.div_ceil(THREADS as usize))
                .map_err(|_| Error::Memory(members, bytes >> 20))?,
            stream,
        })
    }

    /// Takes the steps of a launch, and returns one more than the last finite step of those that fail, or nothing if none
    /// was lost in them: to fetch a number of each member takes as long as hundreds of steps.
    pub(crate) fn advance(&mut self, launch: &Launch) -> Result<Vec<u64>, Error> {
        self.run(launch, true)?;
        std::mem::swap(&mut self.state, &mut self.other);
        let members = self.lost.len() - 1;
        let mut anybody = self.lost.slice_mut(members..);
        if self.stream.clone_dtoh(&anybody).map_err(call)? == [0] {
            return Ok(Vec::new());
        }
        self.stream.memset_zeros(&mut anybody).map_err(call)?;
        self.stream.clone_dtoh(&self.lost.slice(..members)).map_err(call)
    }

    /// The states with the current step completed.
    pub(crate) fn show(&mut self, launch: &Launch) -> Result<Vec<f64>, Error> {
        self.run(launch, false)?;
        self.stream.clone_dtoh(&self.other).map_err(call)
    }

    /// The states in the middle of the current step.
    pub(crate) fn unfinished(&self) -> Result<Vec<f64>, Error> {
        self.stream.clone_dtoh(&self.state).map_err(call)
    }

    /// Continues from other states.
    pub(crate) fn restart(&mut self, state: &[f64]) -> Result<(), Error> {
        self.stream.memcpy_htod(state, &mut self.state).map_err(call)
    }

    /// Takes no more steps with those of whom `lost` is not zero.
    pub(crate) fn hold(&mut self, lost: &[u64]) -> Result<(), Error> {
        self.stream.memcpy_htod(lost, &mut self.lost).map_err(call)
    }

    fn run(&mut self, launch: &Launch, advances: bool) -> Result<(), Error> {
        let Self { stream, advance, show, stages, constants, state, other, lost, blocks } = self;
        let mut arguments = stream.launch_builder(if advances { advance } else { show });
        arguments.arg(launch).arg(&*stages).arg(&*constants).arg(&*state).arg(other).arg(lost);
        let config = LaunchConfig { grid_dim: (*blocks, 1, 1), block_dim: (THREADS, 1, 1), shared_mem_bytes: 0 };
        // SAFETY: the arguments are those of both kernels, and the arrays as long as the members of the launch require,
        // since all were made of the same `Memory`; threads beyond the members return at once.
        unsafe { arguments.launch(config) }.map_err(call)?;
        stream.synchronize().map_err(call)
    }
}

fn call(error: DriverError) -> Error {
    Error::Call(error.to_string())
}
