//! How fast a card is: members × steps per second against members, in both function modes, beside a kernel by hand, two threads
//! of the processor, and what the card can do at most. Nothing is held, since what a card can do depends on the card.

use crate::{
    Pendulum,
    card::{BY_HAND, Card, Mix, compiled, text_of},
    native_pendulums, on_device, orbits, pendulums, systems,
};
use integrator_core::{Coords, Ensemble as OnProcessor, prelude::*};
use integrator_gpu::{Ensemble, Error as GpuError};
use integrator_plot::{Axis, Chart, MARKERS, Mark};
use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
    time::Instant,
};

/// The most steps of a launch that is timed, and about how many steps of all members together.
const STEPS: u64 = 10_000;
const WORK: u64 = 10_000_000_000;

/// The operations of a drift and a kick, as they stand in the assembly that NVRTC makes of the text; what is done for angles beyond
/// 2^20 quarter turns is left out. Yoshida4 has three of both in a step.
const STAGES: f64 = 3.0;
const PENDULUM: Mix = Mix { fused: 25, quotients: 0, roots: 0 };
const NATIVE_PENDULUM: Mix = Mix { fused: 16, quotients: 0, roots: 0 };
const KEPLER: Mix = Mix { fused: 11, quotients: 1, roots: 1 };

/// Members × steps per second of so many steps in one call, after one that loads the module.
fn rate<C: Coords>(made: Result<Ensemble<C>, GpuError>, steps: u64) -> Option<f64> {
    rate_of_calls(made, 1, steps)
}

/// The same of several calls.
fn rate_of_calls<C: Coords>(made: Result<Ensemble<C>, GpuError>, calls: u64, steps: u64) -> Option<f64> {
    let mut device = on_device(made)?;
    device.advance(1).expect("finite");
    let begin = Instant::now();
    for _ in 0..calls {
        device.advance(steps).expect("finite");
    }
    Some(device.len() as f64 * (calls * steps) as f64 / begin.elapsed().as_secs_f64())
}

/// The same on two threads of the processor, with fewer steps.
fn rate_on_processor(count: usize) -> f64 {
    let ensemble = OnProcessor::new(Yoshida4, pendulums(count), 0.01).expect("an ensemble");
    let (mut ensemble, steps) = (ensemble.with_threads(2), (100_000_000 / count as u64).clamp(1, STEPS));
    ensemble.advance(1).expect("finite");
    let begin = Instant::now();
    ensemble.advance(steps).expect("finite");
    count as f64 * steps as f64 / begin.elapsed().as_secs_f64()
}

/// How fast its momentum makes a pendulum, and how strong it is pulled.
fn constants(count: usize) -> Vec<[f64; 2]> {
    pendulums(count).map(|(Pendulum { length }, _)| [1.0 / length.powi(2), 9.81 * length]).collect()
}

#[test]
fn speed_is_printed() {
    let Some(card) = Card::first() else { return eprintln!("SKIPPED: there is no device whose speed could be told") };
    println!("{}", card.name());
    let names = ["exact functions", "native functions", "hand-written kernel", "two CPU threads"];
    let mut table = format!("members,{}\n", names.join(","));
    let mut series = [(); 4].map(|()| Vec::new());
    for count in [1_000, 10_000, 100_000, 1_000_000, 4_000_000] {
        let steps = (WORK / count as u64).min(STEPS);
        let Some(exact) = rate(Ensemble::new(Yoshida4, pendulums(count), 0.01), steps) else { return };
        let Some(native) = rate(Ensemble::new(Yoshida4, native_pendulums(count), 0.01), steps) else { return };
        let by_hand = card.by_hand(&constants(count), 0.01, steps as i64).expect("the kernel by hand");
        let rates = [exact, native, by_hand, rate_on_processor(count)];
        println!(
            "pendulum, Yoshida4: {count} members, {exact:.3e} members × steps per second, {native:.3e} with native functions, \
             {by_hand:.3e} by hand (by hand / native: {:.3}), {:.3e} by two threads of the processor",
            by_hand / native,
            rates[3]
        );
        table += &format!("{count},{}\n", rates.map(|rate| rate.to_string()).join(","));
        series.iter_mut().zip(rates).for_each(|(points, rate)| points.push((count as f64, rate)));
    }
    for (count, steps) in [(10_000, 100), (10_000, 1_000), (1_000_000, 10), (1_000_000, 100)] {
        let made = Ensemble::new(Yoshida4, pendulums(count), 0.01);
        let Some(short) = rate_of_calls(made, 100, steps) else { return };
        println!(
            "pendulum, exact functions: {count} members, {steps} steps for each call: {short:.3e} members × steps per second"
        );
    }
    let at_most = |mix| card.rounds(mix, 10_000).expect("the mix");
    let most = |series: &[(f64, f64)]| series.iter().map(|(_, rate)| *rate).fold(0.0, f64::max);
    let share = |name: &str, rate: f64, mix| {
        println!("{name}: {:.1} % of what the card can do in this mix", 100.0 * STAGES * rate / at_most(mix));
    };
    share("pendulum, exact functions", most(&series[0]), PENDULUM);
    share("pendulum, native functions", most(&series[1]), NATIVE_PENDULUM);
    let count = 1_000_000;
    if let Some(kepler) = rate(Ensemble::new(Yoshida4, orbits(count), 0.01), 1_000) {
        println!("Kepler, Yoshida4: {count} members, {kepler:.3e} members × steps per second");
        share("Kepler, exact functions", kepler, KEPLER);
    }
    if let Some(planets) = rate(Ensemble::new(Yoshida4, systems(100_000), 0.01), 1_000) {
        println!("six planets, Yoshida4: 100000 members, {planets:.3e} members × steps per second");
    }
    draw(&card.name(), &table, names, series);
}

/// Writes the table and the picture.
fn draw(card: &str, table: &str, names: [&str; 4], series: [Vec<(f64, f64)>; 4]) {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let (file, picture) = (folder.join("members_and_steps.csv"), folder.join("members_and_steps.svg"));
    fs::write(&file, table).expect("a folder for files");
    let chart = Chart::new("Ensemble of pendulums by Yoshida4 in double precision")
        .measured(card)
        .along(Axis::logarithmic("members"))
        .up(Axis::logarithmic("members × steps per second"));
    let chart = names.into_iter().zip(series).zip(MARKERS).fold(chart, |chart, ((name, points), marker)| {
        let chart = chart.series(Mark::Dotted, name, points).marked(marker).wide(3.0);
        // It nearly covers that of the native functions.
        if name == "hand-written kernel" { chart.dashed() } else { chart }
    });
    chart.save(&picture).expect("a picture");
    println!("{}\n{}", file.display(), picture.display());
}

#[test]
fn hand_written_kernels_compile() {
    for (text, entry) in [
        (BY_HAND.to_owned(), ".entry pendulums"),
        (text_of(PENDULUM), ".entry mix"),
        (text_of(NATIVE_PENDULUM), ".entry mix"),
        (text_of(KEPLER), ".entry mix"),
    ] {
        match compiled(&text) {
            Some(program) => assert!(program.to_src().contains(entry)),
            None => eprintln!("SKIPPED: NVRTC is not installed, so that no kernel by hand was compiled"),
        }
    }
}

/// As a program of this machine, the kernel by hand ends where an ensemble does: it is the same method.
#[test]
fn the_hand_written_kernel_uses_the_same_method() {
    const MEMBERS: usize = 5;
    const MAIN: &str = "int main() {
        double velocity[5], pull[5], q[5], p[5];
        for (int i = 0; i < 5; ++i) {
            if (std::scanf(\"%lf %lf\", &velocity[i], &pull[i]) != 2) return 1;
            q[i] = 2.0, p[i] = 0.1, blockIdx.x = i;
            pendulums(5, 100, 0.01, velocity, pull, q, p);
            std::printf(\"%.17g %.17g\\n\", q[i], p[i]);
        }
    }";
    let Some(compiler) =
        ["c++", "g++", "clang++"].into_iter().find(|name| Command::new(name).arg("--version").output().is_ok())
    else {
        return eprintln!("SKIPPED: no C++ compiler is installed, so that the kernel by hand was not run");
    };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let (source, program, input) = (folder.join("by_hand.cpp"), folder.join("by_hand"), folder.join("by_hand.txt"));
    let by_hand = BY_HAND.replace("extern \"C\" ", "");
    fs::write(&source, format!("{}{by_hand}{MAIN}", include_str!("../../src/cuda/host.h")))
        .expect("a folder for files");
    let numbers = constants(MEMBERS).iter().map(|[velocity, pull]| format!("{velocity} {pull}\n")).collect::<String>();
    fs::write(&input, numbers).expect("a folder for files");
    let compiled = Command::new(compiler).args(["-std=c++17", "-O1"]).arg(&source).arg("-o").arg(&program).output();
    let compiled = compiled.expect("the compiler starts");
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let output = Command::new(program).stdin(fs::File::open(input).expect("it is there")).output().expect("it starts");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let mut numbers = text.split_whitespace().map(|number| number.parse::<f64>().expect("a number"));
    let mut ensemble = OnProcessor::new(Yoshida4, pendulums(MEMBERS), 0.01).expect("an ensemble");
    ensemble.advance(100).expect("finite");
    for Phase { q, p } in ensemble.states() {
        for expected in [q[0], p[0]] {
            let found = numbers.next().expect("two numbers of each member");
            // Six roundings of numbers below eight in each of three stages of a hundred steps, which a swing of a second in which
            // neighbours part at a rate of five at most makes 150 times as large.
            assert!((found - expected).abs() < 150.0 * 1800.0 * 8.0 * f64::EPSILON / 2.0, "{found} and {expected}");
        }
    }
    assert_eq!(numbers.next(), None);
}
