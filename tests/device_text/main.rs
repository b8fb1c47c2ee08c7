//! The text for devices, compiled as C++ by this machine's compiler: its states have the bits of an ensemble's on a machine
//! with fused multiply-add, and its elementary functions those of the kernels.
//!
//! All systems are one program, which is compiled once.

#[path = "../../integrator-gpu/src/columns.rs"]
mod columns;
mod elementary;
#[path = "../../integrator-gpu/src/host.rs"]
mod host;
#[path = "../../integrator-gpu/src/launch.rs"]
mod launch;
mod systems;

use columns::{columns, constants};
use host::Memory;
use integrator_core::{
    __private::{Composition, Coords, DeviceText, LaneScalars},
    Ensemble, InLanes, InstructionSet,
    prelude::*,
};
use launch::{ANY_COMPOSITION, Launch};
use std::{
    env, fs,
    path::{Path, PathBuf},
    process::Command,
};
use systems::*;

/// What tells a process which instruction set to use.
const VARIABLE: &str = "INTEGRATOR_ISA";

/// The systems of the program, in the order of their numbers.
const SYSTEMS: &[(&str, &str)] = &[
    ("pendulum", Pendulum::TEXT),
    ("henon_heiles", HenonHeiles::TEXT),
    ("kepler", Kepler::TEXT),
    ("wells", Wells::TEXT),
    ("twisted", Twisted::TEXT),
    ("charge", Charge::TEXT),
    ("paired", Paired::TEXT),
    ("stiff", Stiff::TEXT),
    ("turned", Turned::TEXT),
    ("deep", Deep::TEXT),
    ("runaway", Runaway::TEXT),
    ("native", Native::TEXT),
    ("picked", Picked::TEXT),
    ("planets", Planets::TEXT),
    ("charges", Charges::TEXT),
    ("ring", Ring::TEXT),
    ("walls", Walls::TEXT),
];

/// Steps of the two launches of each case.
const PORTIONS: [u64; 2] = [7, 1100];

/// The columns of all states, and the steps of each member.
type Expected = (Vec<f64>, Vec<u64>);

/// Launches, each with the states that an ensemble has after both portions, and the steps that its members have done.
#[derive(Default)]
struct Cases {
    names: Vec<String>,
    jobs: Vec<(u64, Launch, Memory)>,
    expected: Vec<[Expected; 2]>,
}

impl Cases {
    fn add<H, X, K, C>(&mut self, system: &str, composition: X, members: Vec<(H, Phase<C>)>, h: f64)
    where
        H: DeviceText + Clone + Send + Sync + 'static,
        X: Composition<H> + InLanes<H>,
        K: LaneScalars,
        H::Coords: Coords<With<K> = C>,
        C: Coords<Leaf = K>,
    {
        let position = SYSTEMS.iter().position(|(name, _)| *name == system).expect("a known system");
        let precision =
            ["f64", "f32", "compensated f64"].iter().position(|name| *name == K::NAME).expect("a precision");
        let (launch, stages) = Launch::new::<H, X, K>(h, members.len());
        let parameters: Vec<_> = members.iter().map(|(system, start)| system.parameters(start.q.length())).collect();
        let states: Vec<_> = members.iter().map(|(_, start)| start.clone()).collect();
        let memory = Memory {
            stages,
            constants: constants::<H>(&parameters).expect("short lists"),
            state: columns(&states),
            shown: Vec::new(),
            lost: vec![0; members.len() + 1],
        };
        self.names.push(format!("{system} with {} in {}", X::NAME, K::NAME));
        self.jobs.push(((3 * position + precision) as u64, launch, memory));
        let mut ensemble = Ensemble::new(composition, members, h).expect("an ensemble");
        self.expected.push(PORTIONS.map(|steps| {
            // Who is lost is named by the error, and by the steps below.
            let _ = ensemble.advance(steps);
            let states: Vec<_> = ensemble.states().collect();
            let steps = (0..states.len()).map(|member| ensemble.steps_of(member).expect("a member"));
            (columns(&states), steps.collect())
        }));
    }

    /// Holds launches whose functions are the maths library's against ensembles, whose functions are others.
    fn assert_near(mut self, program: &Path) {
        let [steps, _] = PORTIONS;
        self.jobs.iter_mut().for_each(|(_, launch, _)| launch.steps = steps);
        Memory::run(program, &mut self.jobs).expect("the program runs");
        for ((name, (_, _, memory)), [(numbers, _), _]) in self.names.iter().zip(&self.jobs).zip(&self.expected) {
            for (found, expected) in memory.shown.iter().zip(numbers) {
                // Numbers near one, and two roundings of a unit in some fifty evaluations that a step divides by fifty.
                assert!((found - expected).abs() < 1e-14, "{name}: {:?}, {numbers:?}", memory.shown);
            }
        }
    }

    /// Runs all launches, and tells of the first that leaves something else behind than an ensemble does.
    fn compare(mut self, program: &Path) -> Result<(), String> {
        for (portion, steps) in PORTIONS.into_iter().enumerate() {
            self.jobs.iter_mut().for_each(|(_, launch, _)| launch.steps = steps);
            Memory::run(program, &mut self.jobs).expect("the program runs");
            self.jobs.iter_mut().for_each(|(_, launch, _)| launch.done += steps);
            for ((name, (_, launch, memory)), expected) in self.names.iter().zip(&self.jobs).zip(&self.expected) {
                let (numbers, steps) = &expected[portion];
                let lost = &memory.lost[..steps.len()];
                let done = lost.iter().map(|lost| lost.checked_sub(1).unwrap_or(launch.done));
                let done: Vec<_> = done.collect();
                let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
                if done != *steps || bits(&memory.shown) != bits(numbers) {
                    let shown = &memory.shown;
                    return Err(format!("{name}: {done:?} steps to {shown:?}, and {steps:?} to {numbers:?}"));
                }
            }
        }
        Ok(())
    }
}

/// The program of all systems, or `None` with the reason said where no compiler is.
fn program() -> Option<PathBuf> {
    let Some(compiler) = host::compiler() else {
        eprintln!("SKIPPED: no C++ compiler is installed, so that the text for devices was not compiled");
        return None;
    };
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("device_text");
    fs::create_dir_all(&folder).expect("a folder");
    // Those with a mistake come last.
    let rounded =
        Pendulum::TEXT.replacen("motion.p[0].fma(", "motion.p[0].add(1.0 * ", 1).replacen(", sin(", " * sin(", 1);
    let late = Turned::TEXT.replacen("inner_steps, duration, at)", "inner_steps, duration, at + duration)", 1);
    let systems = SYSTEMS.iter().copied().chain([("rounded", rounded.as_str()), ("late", late.as_str())]);
    let systems: Vec<_> = systems.map(|(name, text)| (name, ANY_COMPOSITION.to_owned() + text)).collect();
    let systems: Vec<_> = systems.iter().map(|(name, text)| (*name, text.as_str())).collect();
    let names: Vec<_> = systems.iter().map(|(name, _)| *name).collect();
    let asked = "int main(int count, char**) {\n    if (count > 1) return integrator::functions();";
    let serving = host::serving(&names).replace("int main() {", asked);
    let text = host::program(&systems, &(include_str!("functions.cpp").to_owned() + &serving));
    Some(host::compile(&compiler, &text, &folder).unwrap_or_else(|error| panic!("{compiler}: {error}")))
}

/// Members with other parameters and other starts each.
fn members<H, C: Clone>(count: usize, of: impl Fn(f64) -> (H, C)) -> Vec<(H, C)> {
    (0..count).map(|member| of(member as f64)).collect()
}

/// Adds a system of two coordinates in each precision.
fn add_in_all<H, X>(cases: &mut Cases, name: &str, composition: X, system: impl Fn(f64) -> H)
where
    H: DeviceText<Coords = [f64; 2]> + Clone + Send + Sync + 'static,
    X: Composition<H> + InLanes<H>,
{
    let start = |k: f64| ([0.3 - 0.1 * k, 0.2], [0.1, 0.1 * k]);
    let of = |k: f64| {
        let (q, p) = start(k);
        (system(k), Phase::new(q, p))
    };
    cases.add(name, composition, members(3, of), 0.03);
    let of = |k: f64| {
        let (q, p) = start(k);
        (system(k), Phase::new(q.map(|q| q as f32), p.map(|p| p as f32)))
    };
    cases.add(name, composition, members(3, of), -0.02);
    let of = |k: f64| {
        let (q, p) = start(k);
        (system(k), Phase::compensated(q, p))
    };
    cases.add(name, composition, members(3, of), 0.03);
}

/// The test runs in a process of its own, whose ensembles use fused multiply-add.
#[test]
fn states_and_functions_have_the_bits_of_a_processor() {
    if env::var_os(VARIABLE).is_none() {
        if !InstructionSet::available().contains(&InstructionSet::Fused) {
            eprintln!("SKIPPED: this machine has no fused multiply-add, so that there is nothing to compare with");
            return;
        }
        let mut test = Command::new(env::current_exe().expect("the path of this test"));
        test.args(["--exact", "states_and_functions_have_the_bits_of_a_processor", "--nocapture"]);
        let output = test.env(VARIABLE, InstructionSet::Fused.to_string()).output().expect("it starts");
        let text = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
        assert!(output.status.success() && text.contains("1 passed"), "{text}");
        assert!(!text.contains("SKIPPED: somebody chose"), "{text}");
        eprint!("{text}");
        return;
    }
    if InstructionSet::chosen() != InstructionSet::Fused {
        eprintln!("SKIPPED: somebody chose {}", InstructionSet::chosen());
        return;
    }
    let Some(program) = program() else { return };
    elementary::compare(&program);

    let mut cases = Cases::default();
    let pendulum =
        |k: f64| (Pendulum { mass: 1.0 + 0.1 * k, length: 1.3 - 0.05 * k }, Phase::new([2.0 - 0.2 * k], [0.1 * k]));
    cases.add("pendulum", Verlet, members(5, pendulum), 0.01);
    cases.add("pendulum", VelocityVerlet, members(3, pendulum), -0.02);
    cases.add("pendulum", Chin4A, members(3, pendulum), 0.05);
    cases.add(
        "pendulum",
        Yoshida4,
        members(3, |k| (pendulum(k).0, Phase::new([2.0_f32 - 0.2 * k as f32], [0.1]))),
        0.05,
    );
    cases.add("pendulum", Yoshida4, members(3, |k| (pendulum(k).0, Phase::compensated([2.0 - 0.2 * k], [0.1]))), 0.05);
    let henon_heiles = |k: f64| (HenonHeiles, Phase::new([0.1 * k, 0.1], [0.3, 0.05 * k]));
    cases.add("henon_heiles", Yoshida4, members(3, henon_heiles), 0.05);
    cases.add("henon_heiles", TakahashiImada4, members(3, henon_heiles), 0.05);
    let kepler = |k: f64| (Kepler { attraction: 1.0 + 0.1 * k }, Phase::new([1.0, 0.1, 0.0], [0.0, 0.9, 0.05 * k]));
    cases.add("kepler", BlanesMoanSrkn11, members(3, kepler), 0.1);
    let wells = |k: f64| {
        let system = Wells { double: [0.5, 1.0 + 0.1 * k, 1.5], switch: 0.4 + 0.1 * k, long: k != 1.0 };
        (system, [[0.1 * k, 0.2], [-0.5, 0.3], [0.4, -0.2]], [[0.1, 0.2], [0.0, -0.3], [0.3, 0.1 * k]])
    };
    let of = |k: f64| {
        let (system, q, p) = wells(k);
        (system, Phase::new(q, p))
    };
    cases.add("wells", Yoshida4, members(4, of), 0.02);
    let of = |k: f64| {
        let (system, q, p) = wells(k);
        (system, Phase::compensated(q, p))
    };
    cases.add("wells", Verlet, members(4, of), 0.02);
    cases.add(
        "twisted",
        Yoshida4,
        members(3, |k| (Twisted { rate: 0.1 * k }, Phase::new([0.3, 0.1], [0.2, 0.1 * k]))),
        0.05,
    );
    cases.add(
        "charge",
        Yoshida4,
        members(5, |k| (Charge { number: 1.0 + 0.3 * k }, Phase::new([0.3, 0.1], [0.2, 0.1 * k]))),
        0.05,
    );
    cases.add(
        "paired",
        Verlet,
        members(3, |k| (Paired { rate: 0.1 * k }, Phase::new([0.3, 0.1], [0.2, 0.1 * k]))),
        0.05,
    );
    let stiff = |k: f64| Stiff { inner_steps: 1.0 + 0.1 * k };
    add_in_all(&mut cases, "stiff", Verlet, stiff);
    add_in_all(&mut cases, "stiff", VelocityVerlet, stiff);
    add_in_all(&mut cases, "stiff", Yoshida4, stiff);
    add_in_all(&mut cases, "stiff", KahanLi8, stiff);
    let turned = |k: f64| Turned { rate: 0.1 * k };
    add_in_all(&mut cases, "turned", Verlet, turned);
    add_in_all(&mut cases, "turned", VelocityVerlet, turned);
    add_in_all(&mut cases, "turned", BlanesMoan4, turned);
    let deep = |k: f64| Deep { stiffness: [1.0 + 0.1 * k, 2.0, 5.0] };
    add_in_all(&mut cases, "deep", Verlet, deep);
    add_in_all(&mut cases, "deep", VelocityVerlet, deep);
    add_in_all(&mut cases, "deep", BlanesMoan4, deep);
    cases.add("runaway", Verlet, members(3, |k| (Runaway { strength: k - 1.0 }, Phase::new([1.0], [1.0]))), 0.01);
    let picked = |k: f64| {
        let system = Picked { site: k as usize, count: 3 - k as usize, partner: [0, 1 + k as usize] };
        (system, [0.3, 0.1, -0.2, 0.1 * k], [0.2, 0.1 * k, 0.0, -0.1])
    };
    let of = |k: f64| {
        let (system, q, p) = picked(k);
        (system, Phase::new(q, p))
    };
    cases.add("picked", Yoshida4, members(3, of), 0.02);
    let of = |k: f64| {
        let (system, q, p) = picked(k);
        (system, Phase::new(q.map(|x: f64| x as f32), p.map(|x: f64| x as f32)))
    };
    cases.add("picked", Chin4A, members(3, of), 0.02);
    let planets = |k: f64| {
        let system = Planets { gravity: 1.0, mass: [1.0, 0.01, 0.02, 0.03 + 0.001 * k, 0.001, 1e-6] };
        let point = |body: f64| [body, 0.1 * body, 0.05 * k];
        let velocity = |body: f64, mass: f64| [0.0, mass / (1.0 + body).sqrt(), 0.01 * mass * k];
        let q = std::array::from_fn(|body| point(body as f64));
        let p = std::array::from_fn(|body| velocity(body as f64, system.mass[body]));
        (system, q, p)
    };
    let of = |k: f64| {
        let (system, q, p) = planets(k);
        (system, Phase::new(q, p))
    };
    cases.add("planets", Yoshida4, members(3, of), 0.01);
    cases.add("planets", Chin4A, members(2, of), 0.02);
    let of = |k: f64| {
        let (system, q, p) = planets(k);
        (system, Phase::compensated(q, p))
    };
    cases.add("planets", Verlet, members(3, of), 0.01);
    let charges = |k: f64| (Charges { charge: [1.0, 0.5, 0.3 + 0.1 * k, 2.0, 0.1] }, [0.3, 0.1, -0.2, 0.1 * k, 1.0]);
    let of = |k: f64| {
        let (system, q) = charges(k);
        (system, Phase::new(q, [0.1; 5]))
    };
    cases.add("charges", Yoshida4, members(3, of), 0.02);
    let of = |k: f64| {
        let (system, q) = charges(k);
        (system, Phase::new(q.map(|q| q as f32), [0.1_f32; 5]))
    };
    cases.add("charges", Verlet, members(3, of), 0.02);
    let wave = |site: usize, k: f64| 0.3 * (0.7 * site as f64 + k).sin();
    let ring = |k: f64| {
        let mass = std::array::from_fn(|site| 1.0 + 0.1 * (site % 3) as f64);
        let system = Ring { mass, alpha: std::array::from_fn(|site| 0.25 + 0.01 * k * site as f64) };
        (system, std::array::from_fn(|site| wave(site, k)))
    };
    let of = |k: f64| {
        let (system, q) = ring(k);
        (system, Phase::new(q, [0.1; 16]))
    };
    cases.add("ring", Yoshida4, members(3, of), 0.02);
    cases.add("ring", Chin4A, members(2, of), 0.02);
    let walls = |k: f64| {
        let system = Walls { stiffness: std::array::from_fn(|site| 1.0 + 0.1 * k * site as f64) };
        (system, std::array::from_fn::<_, 12, _>(|site| wave(site, k)))
    };
    let of = |k: f64| {
        let (system, q) = walls(k);
        (system, Phase::compensated(q, [0.1; 12]))
    };
    cases.add("walls", Yoshida4, members(3, of), 0.02);
    let of = |k: f64| {
        let (system, q) = walls(k);
        (system, Phase::new(q.map(|q| q as f32), [0.1_f32; 12]))
    };
    cases.add("walls", Verlet, members(3, of), 0.02);
    assert!(cases.expected.iter().any(|[_, (_, steps)]| steps.iter().any(|steps| *steps < 1107)), "somebody is lost");
    cases.compare(&program).expect("the bits of an ensemble");

    let mut native = Cases::default();
    native.add(
        "native",
        Yoshida4,
        members(3, |k| (Native { stiffness: 1.0 + 0.1 * k }, Phase::new([0.3, 0.1], [0.2, 0.1 * k]))),
        0.02,
    );
    native.assert_near(&program);

    let mut wrong = Cases::default();
    wrong.add("pendulum", Verlet, members(5, pendulum), 0.01);
    wrong.jobs[0].0 = 3 * (SYSTEMS.len() as u64);
    let found = wrong.compare(&program).expect_err("a text in which one product is rounded before it is added");
    assert!(found.contains("pendulum with Verlet"), "{found}");

    let mut wrong = Cases::default();
    wrong.add("turned", Verlet, members(3, |k| (turned(k), Phase::new([0.3, 0.2], [0.1, 0.1 * k]))), 0.03);
    wrong.jobs[0].0 = 3 * (SYSTEMS.len() as u64 + 1);
    let found = wrong.compare(&program).expect_err("a text whose inner steps begin too late");
    assert!(found.contains("turned with Verlet"), "{found}");
}
