//! Device code as a program of this machine, built by any available C++ compiler, which integrates members one after
//! the other. It tests the code on machines without a device.

use super::launch::Launch;
use integrator_core::__private::StageRow;
use std::{
    env, fs, io,
    io::{Read, Write},
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

/// The elementary functions, the loop over steps, inner steps, and the kicks of bodies.
pub(crate) const RUNTIME: [&str; 4] = [
    include_str!("cuda/functions.h"),
    include_str!("cuda/stepper.h"),
    include_str!("cuda/inner_steps.h"),
    include_str!("cuda/pairs.h"),
];
/// What the host's compiler needs before these, and after them.
const HOST: [&str; 2] = [include_str!("cuda/host.h"), include_str!("cuda/serve.h")];

/// The options without which the compiler would fuse or reassociate operations.
const OPTIONS: [&str; 4] = ["-std=c++17", "-O1", "-ffp-contract=off", "-fno-fast-math"];

/// The C++ compiler of this machine: what `CXX` says, `c++` or `g++`; `None` where none of them runs.
pub(crate) fn compiler() -> Option<String> {
    let named = env::var("CXX").ok().into_iter();
    let mut known = named.chain(["c++", "g++", "clang++"].map(str::to_owned));
    known.find(|name| {
        let mut asked = Command::new(name);
        asked.arg("--version").stdout(Stdio::null()).stderr(Stdio::null());
        asked.status().is_ok_and(|status| status.success())
    })
}

/// The text of a program for these systems with their compositions, by their names, with what else stands among them.
pub(crate) fn program(systems: &[(&str, &str)], main: &str) -> String {
    let (runtime, [before, behind]) = (RUNTIME.concat(), HOST);
    let systems =
        systems.iter().map(|(name, text)| format!("namespace integrator {{\nnamespace {name} {{\n{text}}}\n}}\n"));
    let systems: String = systems.collect();
    format!("{before}{runtime}{behind}{systems}{main}")
}

/// The `main` that serves launches of these systems, each in three precisions.
pub(crate) fn serving(names: &[&str]) -> String {
    let added: String = names
        .iter()
        .map(|name| {
            format!("    integrator::add_system<integrator::{name}::System, integrator::{name}::Composed>(all);\n")
        })
        .collect();
    format!("int main() {{\n    std::vector<integrator::Kernels> all;\n{added}    return integrator::serve(all);\n}}\n")
}

/// Compiles a program into a folder.
pub(crate) fn compile(compiler: &str, text: &str, folder: &Path) -> io::Result<PathBuf> {
    let (source, program) = (folder.join("device_text.cpp"), folder.join("device_text"));
    fs::write(&source, text)?;
    let output = Command::new(compiler).args(OPTIONS).arg(&source).arg("-o").arg(&program).output()?;
    match output.status.success() {
        true => Ok(program),
        false => Err(io::Error::other(String::from_utf8_lossy(&output.stderr).into_owned())),
    }
}

/// What a launch works on, and what it leaves behind: the states as they continue, as they are shown, and one more than
/// the last finite step of those that failed, with whether there are any.
#[derive(Clone, Debug)]
pub(crate) struct Memory {
    pub(crate) stages: Vec<StageRow>,
    pub(crate) constants: Vec<f64>,
    pub(crate) state: Vec<f64>,
    pub(crate) shown: Vec<f64>,
    pub(crate) lost: Vec<u64>,
}

impl Memory {
    /// Runs launches one after the other, each of the system of a number, and in one process.
    pub(crate) fn run(program: &Path, jobs: &mut [(u64, Launch, Memory)]) -> io::Result<()> {
        let mut child = Command::new(program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
        let input: Vec<u8> = jobs.iter().flat_map(|(system, launch, memory)| memory.request(*system, launch)).collect();
        let (Some(mut to), Some(mut from)) = (child.stdin.take(), child.stdout.take()) else {
            return Err(io::Error::other("the program has no pipes"));
        };
        // Both pipes hold only so much.
        let writer = std::thread::spawn(move || to.write_all(&input));
        let mut output = Vec::new();
        from.read_to_end(&mut output)?;
        let written = writer.join().map_err(|_| io::Error::other("writing to the program panicked"))?;
        let status = child.wait()?;
        if !status.success() {
            return Err(io::Error::other(format!("the program ended with {status}")));
        }
        written?;
        let mut words = output.chunks_exact(8).map(|word| u64::from_ne_bytes(word.try_into().unwrap_or_default()));
        for (_, _, memory) in jobs {
            memory.shown = vec![0.0; memory.state.len()];
            for numbers in [&mut memory.state, &mut memory.shown] {
                numbers.iter_mut().for_each(|number| *number = f64::from_bits(words.next().unwrap_or_default()));
            }
            memory.lost.iter_mut().for_each(|lost| *lost = words.next().unwrap_or_default());
        }
        Ok(())
    }

    fn request(&self, system: u64, launch: &Launch) -> Vec<u8> {
        let numbers = self.stages.iter().flatten().chain(&self.constants).chain(&self.state);
        let words = numbers.map(|number| number.to_bits()).chain(self.lost.iter().copied());
        let head = system.to_ne_bytes().into_iter().chain(launch.bytes());
        head.chain(words.flat_map(u64::to_ne_bytes)).collect()
    }
}
