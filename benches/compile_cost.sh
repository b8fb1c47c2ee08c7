#!/usr/bin/env bash
# What a small user crate costs to compile: two systems (a pendulum and the outer solar system) by ten compositions each,
# in release on two cores, the library itself being built before. Prints seconds and bytes; more than 25 s is an error.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
crate=$root/target/compile_cost
limit=25
mkdir -p "$crate/src"

cat > "$crate/Cargo.toml" << END
[package]
name = "user"
version = "0.0.0"
edition = "2024"

[dependencies]
integrator-core = { path = "$root/integrator-core", default-features = false, features = ["std"] }

# What is counted is code, not the names in it.
[profile.release]
strip = true

[workspace]
END
cp "$root/Cargo.lock" "$crate/Cargo.lock"

# Builds what stands in main.rs; the elapsed and the processor's seconds go to stdout.
build() {
    local TIMEFORMAT='%R %U %S'
    { time cargo build --release --quiet --jobs 2 --manifest-path "$crate/Cargo.toml" >&2; } 2>&1
}
bytes() {
    wc -c < "$crate/target/release/user"
}

echo 'fn main() { println!("{}", std::env::args().count()); }' > "$crate/src/main.rs"
build > /dev/null
empty=$(bytes)

cat > "$crate/src/main.rs" << 'END'
use integrator_core::prelude::*;

struct Pendulum { length: f64 }

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 { p[0].powi(2) / (2.0 * self.length.powi(2)) }
    fn potential(&self, q: [f64; 1]) -> f64 { -9.81 * self.length * q[0].cos() }
}

struct Solar { masses: [f64; 6] }

#[hamiltonian]
impl Solar {
    fn kinetic(&self, p: &[[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / (2.0 * self.masses[i]);
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for j in 0..i {
                let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                energy -= self.masses[i] * self.masses[j] / (x * x + y * y + z * z).sqrt();
            }
        }
        energy
    }
}

macro_rules! all {
    ($run:ident) => {
        $run!(Verlet VelocityVerlet Yoshida4 BlanesMoan4 BlanesMoanSrkn6 BlanesMoanSrkn11 BlanesMoanSrkn14 KahanLi8
              Teloy8C SofroniouSpaletta10)
    };
}

fn main() -> Result<(), Error> {
    let steps = std::env::args().count() as u64;
    let start = Phase::new(std::array::from_fn(|i| [i as f64, (i * i) as f64, 0.0]), [[0.0; 3]; 6]);
    macro_rules! run {
        ($($composition:ident)*) => {$(
            let mut run = Pendulum { length: 1.0 }.run_with($composition, Phase::new([1.0], [0.0]), 0.01)?;
            run.advance(steps)?;
            println!("{:?}", run.state());
            let mut run = Solar { masses: [1.0; 6] }.run_with($composition, start, 0.01)?;
            run.advance(steps)?;
            println!("{:?}", run.state());
        )*};
    }
    all!(run);
    Ok(())
}
END
read -r elapsed user system <<< "$(build)"
full=$(bytes)
cpu=$(awk "BEGIN { print $user + $system }")
echo "two systems by ten compositions: $elapsed s elapsed, $cpu s of CPU, $(((full - empty) / 1024)) KiB over an empty program"
echo "compile_seconds=$elapsed"
echo "compile_cpu_seconds=$cpu"
echo "compile_bytes=$((full - empty))"
# Processor time of two cores, so that a busy machine fails nobody.
awk "BEGIN { exit !($cpu <= 2 * $limit) }"
