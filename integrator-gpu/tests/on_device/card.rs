//! Kernels that are written by hand, on the same card: what the pendulum is held against, and what the card can do at most.

use cudarc::{
    driver::{CudaContext, CudaFunction, CudaSlice, CudaStream, LaunchConfig, PushKernelArg, sys},
    nvrtc::{CompileOptions, Ptx, compile_ptx_with_opts, sys as nvrtc},
};
use std::{
    error::Error,
    sync::Arc,
    time::{Duration, Instant},
};

/// A kernel by hand.
pub(crate) const BY_HAND: &str = include_str!("by_hand.cu");
const MIX: &str = include_str!("mix.cu");

/// The threads of a block, as the library has them.
const THREADS: u32 = 128;

/// Operations in double precision of one stage of a method.
#[derive(Clone, Copy)]
pub(crate) struct Mix {
    /// Sums, products, and both in one.
    pub(crate) fused: u32,
    pub(crate) quotients: u32,
    pub(crate) roots: u32,
}

/// The program of one of them for NVRTC; `None` where it cannot be loaded.
pub(crate) fn compiled(text: &str) -> Option<Ptx> {
    // SAFETY: nothing but the search for a library.
    if !unsafe { nvrtc::is_culib_present() } {
        return None;
    }
    let options = CompileOptions { options: vec!["--std=c++17".to_owned()], ..CompileOptions::default() };
    Some(compile_ptx_with_opts(text, options).unwrap_or_else(|error| panic!("{error}")))
}

/// The text of a kernel of a mix.
pub(crate) fn text_of(Mix { fused, quotients, roots }: Mix) -> String {
    format!("#define FUSED {fused}\n#define QUOTIENTS {quotients}\n#define ROOTS {roots}\n{MIX}")
}

/// The first device.
pub(crate) struct Card {
    context: Arc<CudaContext>,
    stream: Arc<CudaStream>,
}

impl Card {
    /// The device, or `None` where there is none.
    pub(crate) fn first() -> Option<Self> {
        // SAFETY: nothing but the search for a library.
        if !unsafe { sys::is_culib_present() } || CudaContext::device_count().ok()? == 0 {
            return None;
        }
        let context = CudaContext::new(0).ok()?;
        let stream = context.default_stream();
        Some(Self { context, stream })
    }

    /// Takes its memory, but for so many bytes and at most a mebibyte more.
    pub(crate) fn fill(&self, left: usize) -> Result<Vec<CudaSlice<u8>>, Box<dyn Error>> {
        let (mut taken, mut piece) = (Vec::new(), 1 << 32);
        while piece >= 1 << 20 {
            let (free, _) = self.context.mem_get_info()?;
            match free.checked_sub(left + piece).and_then(|_| self.stream.alloc_zeros(piece).ok()) {
                Some(slice) => taken.push(slice),
                None => piece /= 2,
            }
        }
        self.stream.synchronize()?;
        Ok(taken)
    }

    /// Its name.
    pub(crate) fn name(&self) -> String {
        self.context.name().unwrap_or_default()
    }

    fn function(&self, text: &str, name: &str) -> Result<CudaFunction, Box<dyn Error>> {
        let program = compiled(text).ok_or("NVRTC cannot be loaded")?;
        Ok(self.context.load_module(program)?.load_function(name)?)
    }

    fn config(count: usize) -> LaunchConfig {
        LaunchConfig {
            grid_dim: ((count as u32).div_ceil(THREADS), 1, 1),
            block_dim: (THREADS, 1, 1),
            shared_mem_bytes: 0,
        }
    }

    /// How long a second launch takes.
    fn time(&self, mut launch: impl FnMut() -> Result<(), Box<dyn Error>>) -> Result<Duration, Box<dyn Error>> {
        launch()?;
        self.stream.synchronize()?;
        let begin = Instant::now();
        launch()?;
        self.stream.synchronize()?;
        Ok(begin.elapsed())
    }

    /// How many members × steps per second the kernel by hand takes; of each pendulum how fast its momentum makes it, and how strong
    /// it is pulled.
    pub(crate) fn by_hand(&self, constants: &[[f64; 2]], h: f64, steps: i64) -> Result<f64, Box<dyn Error>> {
        let function = self.function(BY_HAND, "pendulums")?;
        let column = |number: usize| constants.iter().map(|own| own[number]).collect::<Vec<_>>();
        let [velocity, pull] = [self.stream.clone_htod(&column(0))?, self.stream.clone_htod(&column(1))?];
        let start = |number: f64| self.stream.clone_htod(&vec![number; constants.len()]);
        let (mut q, mut p): (CudaSlice<f64>, CudaSlice<f64>) = (start(2.0)?, start(0.1)?);
        let members = constants.len() as i64;
        let taken = self.time(|| {
            let mut arguments = self.stream.launch_builder(&function);
            arguments.arg(&members).arg(&steps).arg(&h).arg(&velocity).arg(&pull).arg(&mut q).arg(&mut p);
            // SAFETY: the arguments are those of the kernel, whose arrays have an element for each member.
            unsafe { arguments.launch(Self::config(constants.len())) }?;
            Ok(())
        })?;
        Ok(constants.len() as f64 * steps as f64 / taken.as_secs_f64())
    }

    /// How many rounds of a mix per second all threads of the card do together.
    pub(crate) fn rounds(&self, mix: Mix, rounds: i64) -> Result<f64, Box<dyn Error>> {
        const COUNT: usize = 1 << 20;
        let function = self.function(&text_of(mix), "mix")?;
        let (factor, mut to) = (0.999_f64, self.stream.alloc_zeros::<f64>(COUNT)?);
        let taken = self.time(|| {
            let mut arguments = self.stream.launch_builder(&function);
            arguments.arg(&rounds).arg(&factor).arg(&mut to);
            // SAFETY: the arguments are those of the kernel, whose array has an element for each thread.
            unsafe { arguments.launch(Self::config(COUNT)) }?;
            Ok(())
        })?;
        Ok(COUNT as f64 * rounds as f64 / taken.as_secs_f64())
    }
}
