//! Exported headers: compiled without warnings, with the bits of Rust runs.

use super::{
    SYSTEMS, compiled, compiler,
    functions::{Faster, Precise, Waves},
    systems::*,
};
use crate::answer;
use integrator_core::{__private::Coords, InstructionSet, Method, prelude::*};
use std::{env, fs, path::PathBuf, process::Command};

const FUNCTIONS: &str = "integrator-cli/tests/cli/export/functions.rs";
const VARIABLE: &str = "INTEGRATOR_ISA";
const STEPS: u64 = 1000;

/// Steps of a header, as lines of C, with the numbers that they print and the energies that they have to be near.
#[derive(Default)]
struct Cases {
    headers: Vec<String>,
    lines: String,
    expected: Vec<(String, Vec<f64>, f64)>,
}

impl Cases {
    /// Exports a system with compositions.
    fn export(&mut self, system: &str, compositions: &[&str]) {
        let file = if ["Precise", "Faster", "Waves"].contains(&system) { FUNCTIONS } else { SYSTEMS };
        let mut arguments = vec!["export", "--c", file, "--system", system];
        compositions.iter().for_each(|name| arguments.extend(["--composition", *name]));
        self.headers.push(answer(&arguments));
    }

    /// Adds a run; parameters are an initialiser in C, or nothing.
    fn add<H, X, C>(&mut self, name: &str, system: &H, method: X, parameters: &str, start: Phase<C>, h: f64)
    where
        H: Hamiltonian<Coords: Coords<With<f64> = C>>,
        X: Method<H> + std::fmt::Debug,
        C: Coords<Leaf = f64>,
    {
        let composition = format!("{method:?}");
        let mut run = system.run_with(method, start.clone(), h).expect("a run");
        let energy = run.energy();
        run.advance(STEPS).expect("finite");
        let end = run.state();
        let list = |half: &C| half.flat().iter().map(|number| format!("{number:?}")).collect::<Vec<_>>().join(", ");
        let count = start.q.flat().len();
        let (declared, pass) = match parameters {
            "" => (String::new(), ""),
            _ => (format!("const {name}_parameters parameters = {parameters};\n"), "&parameters, "),
        };
        self.lines += &format!(
            "{{\n{declared}const double q[] = {{{}}}, p[] = {{{}}};\n{name}_state state = {{0}};\nmemcpy(state.q, q, sizeof q);\n\
             memcpy(state.p, p, sizeof p);\nshow({name}_energy({pass}&state));\n{name}_advance_{composition}({pass}&state, {h:?}, {STEPS});\n\
             show_all(&state, {});\n}}\n",
            list(&start.q),
            list(&start.p),
            2 * count + 1
        );
        let numbers = end.q.flat().iter().chain(end.p.flat()).copied().chain([STEPS as f64 * h]).collect();
        self.expected.push((format!("{name} with {composition}"), numbers, energy));
    }

    /// Compiles and runs all cases; the first whose end has other bits, if there is one.
    fn compare(&self, compiler: &str, name: &str) -> Result<(), String> {
        let main = format!(
            "{}#include <stdio.h>\nstatic void show(double x) {{ printf(\"%a\\n\", x); }}\n\
             static void show_all(const void *state, int count) {{\n    double numbers[2000];\n    memcpy(numbers, state, (size_t)count * \
             sizeof(double));\n    for (int i = 0; i < count; ++i) show(numbers[i]);\n}}\nint main(void) {{\n{}return 0;\n}}\n",
            self.headers.concat(),
            self.lines
        );
        let output = output(compiler, name, &main)?;
        let mut found = output.lines().map(hexadecimal);
        for (name, numbers, energy) in &self.expected {
            let shown = found.next().expect("an energy");
            // A sum of at most 100 terms, each within a few roundings, none of which is larger than ten.
            if (shown - energy).abs() > 1e-12 {
                return Err(format!("{name}: energy {shown}, and {energy} in Rust"));
            }
            for (number, expected) in numbers.iter().enumerate() {
                let shown = found.next().expect("a number");
                if shown.to_bits() != expected.to_bits() {
                    return Err(format!("{name}: number {number} is {shown:e}, and {expected:e} in Rust"));
                }
            }
        }
        Ok(())
    }
}

/// The number that `%a` prints.
fn hexadecimal(text: &str) -> f64 {
    let (sign, digits) = text.strip_prefix('-').map_or((1.0, text), |digits| (-1.0, digits));
    let (mantissa, exponent) = digits.trim_start_matches("0x").split_once('p').expect("a power");
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let bits = u64::from_str_radix(&format!("{whole}{fraction}"), 16).expect("digits");
    let exponent = exponent.parse::<i32>().expect("an exponent") - 4 * fraction.len() as i32;
    // Both factors are powers of two and normal numbers, and only the last product may be rounded: a subnormal one is exact.
    sign * (bits as f64 * 2_f64.powi(exponent / 2)) * 2_f64.powi(exponent - exponent / 2)
}

/// What a program prints, compiled as strictly as can be.
fn output(compiler: &str, name: &str, text: &str) -> Result<String, String> {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("export");
    fs::create_dir_all(&folder).expect("a folder");
    let (source, program) = (folder.join(name).with_extension("c"), folder.join(name));
    fs::write(&source, text).expect("a file");
    compiled(compiler, &["-Wall", "-Wextra", "-Werror", "-std=c99", "-pedantic", "-O1"], &source, &program);
    let output = Command::new(&program).output().expect("the program runs");
    assert!(output.status.success(), "{name}");
    Ok(String::from_utf8(output.stdout).expect("text"))
}

/// The test runs in a process of its own, whose runs use fused multiply-add.
#[test]
fn states_have_the_bits_of_rust() {
    if env::var_os(VARIABLE).is_none() {
        if !InstructionSet::available().contains(&InstructionSet::Fused) {
            eprintln!("SKIPPED: this machine has no fused multiply-add, so that there is nothing to compare with");
            return;
        }
        let mut test = Command::new(env::current_exe().expect("the path of this test"));
        test.args(["--exact", "export::states::states_have_the_bits_of_rust", "--nocapture"]);
        let output = test.env(VARIABLE, InstructionSet::Fused.to_string()).output().expect("it starts");
        let text = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
        assert!(output.status.success() && text.contains("1 passed"), "{text}");
        eprint!("{text}");
        return;
    }
    if InstructionSet::chosen() != InstructionSet::Fused {
        eprintln!("SKIPPED: somebody chose {}", InstructionSet::chosen());
        return;
    }
    let Some(compiler) = compiler() else { return };

    let mut cases = Cases::default();
    cases.export("Pendulum", &["Verlet", "VelocityVerlet", "Chin4A", "Yoshida4"]);
    let (pendulum, start) = (Pendulum { mass: 1.1, length: 1.3 }, Phase::new([2.0], [0.1]));
    cases.add("pendulum", &pendulum, Verlet, "{1.1, 1.3}", start, 0.01);
    cases.add("pendulum", &pendulum, VelocityVerlet, "{1.1, 1.3}", start, -0.02);
    cases.add("pendulum", &pendulum, Chin4A, "{1.1, 1.3}", start, 0.05);
    cases.add("pendulum", &pendulum, Yoshida4, "{1.1, 1.3}", start, 0.05);
    cases.export("HenonHeiles", &["KahanLi8", "TakahashiImada4", "BlanesCasasRos6"]);
    let start = Phase::new([0.1, 0.1], [0.3, 0.05]);
    cases.add("henon_heiles", &HenonHeiles, KahanLi8, "", start, 0.05);
    cases.add("henon_heiles", &HenonHeiles, TakahashiImada4, "", start, 0.05);
    cases.add("henon_heiles", &HenonHeiles, BlanesCasasRos6, "", start, 0.05);
    cases.export("Kepler", &["BlanesMoanSrkn11"]);
    let start = Phase::new([1.0, 0.1, 0.0], [0.0, 0.9, 0.05]);
    cases.add("kepler", &Kepler { attraction: 1.1 }, BlanesMoanSrkn11, "{1.1}", start, 0.1);
    cases.export("Wells", &["Yoshida4"]);
    let wells = Wells { double: [0.5, 1.1, 1.5], switch: 0.4, long: true };
    let start = Phase::new([[0.1, 0.2], [-0.5, 0.3], [0.4, -0.2]], [[0.1, 0.2], [0.0, -0.3], [0.3, 0.1]]);
    cases.add("wells", &wells, Yoshida4, "{{0.5, 1.1, 1.5}, 0.4, 1}", start, 0.02);
    let start = Phase::new([0.3, 0.1], [0.2, 0.1]);
    cases.export("Twisted", &["Yoshida4"]);
    cases.add("twisted", &Twisted { rate: 0.1 }, Yoshida4, "{0.1}", start, 0.01);
    cases.export("Charge", &["Yoshida4"]);
    cases.add("charge", &Charge { number: 1.3 }, Yoshida4, "{1.3}", start, 0.05);
    cases.export("Paired", &["Verlet"]);
    cases.add("paired", &Paired { rate: 0.1 }, Verlet, "{0.1}", start, 0.01);
    cases.export("Planets", &["Yoshida4", "Chin4A"]);
    let mass = [1.0, 0.01, 0.02, 0.03, 0.001, 1e-6];
    let planets = Planets { gravity: 1.0, mass };
    let q = std::array::from_fn(|body| [body as f64, 0.1 * body as f64, 0.05]);
    let p = std::array::from_fn(|body| [0.0, mass[body] / (1.0 + body as f64).sqrt(), 0.01 * mass[body]]);
    let parameters = "{1.0, {1.0, 0.01, 0.02, 0.03, 0.001, 1e-6}}";
    cases.add("planets", &planets, Yoshida4, parameters, Phase::new(q, p), 0.01);
    cases.add("planets", &planets, Chin4A, parameters, Phase::new(q, p), 0.02);
    cases.export("Charges", &["Yoshida4"]);
    let charges = Charges { charge: [1.0, 0.5, 0.3, 2.0, 0.1] };
    let start = Phase::new([0.3, 0.1, -0.2, 0.1, 1.0], [0.1; 5]);
    cases.add("charges", &charges, Yoshida4, "{{1.0, 0.5, 0.3, 2.0, 0.1}}", start, 0.02);
    cases.export("Ring", &["Yoshida4", "Chin4A"]);
    let (masses, alpha) = ([1.0, 1.1, 1.2, 1.3].repeat(4), [0.25, 0.26].repeat(8));
    let ring = Ring { mass: masses.clone().try_into().expect("16"), alpha: alpha.clone().try_into().expect("16") };
    let start = Phase::new(std::array::from_fn(|site| 0.3 * (0.7 * site as f64).sin()), [0.1; 16]);
    let text = |list: &[f64]| format!("{list:?}").replace('[', "{").replace(']', "}");
    let parameters = format!("{{{}, {}}}", text(&masses), text(&alpha));
    cases.add("ring", &ring, Yoshida4, &parameters, start, 0.02);
    cases.add("ring", &ring, Chin4A, &parameters, start, 0.02);
    cases.export("Walls", &["Yoshida4"]);
    let stiffness: [f64; 11] = std::array::from_fn(|site| 1.0 + 0.1 * site as f64);
    let start = Phase::new(std::array::from_fn(|site| 0.3 * (0.7 * site as f64).sin()), [0.1; 12]);
    cases.add("walls", &Walls { stiffness }, Yoshida4, &format!("{{{}}}", text(&stiffness)), start, 0.02);
    let start = Phase::new([0.3, 0.1], [0.2, 0.1]);
    cases.export("Precise", &["Yoshida4"]);
    let precise = Precise { scale: 0.7, title: "unread title".to_owned() };
    cases.add("precise", &precise, Yoshida4, "{0.7}", start, 0.02);
    assert!(!cases.headers.concat().contains(&precise.title), "a field that H does not read");
    cases.export("Faster", &["Yoshida4"]);
    cases.add("faster", &Faster { scale: 0.7 }, Yoshida4, "{0.7}", start, 0.02);
    cases.export("Waves", &["Yoshida4"]);
    let waves = Waves { height: std::array::from_fn(|k| 0.01 * k as f64), first: 3 };
    cases.add("waves", &waves, Yoshida4, &format!("{{{}, 3}}", text(&waves.height)), start, 0.01);
    cases.compare(&compiler, "cases").expect("the bits of Rust");

    // A coefficient of the sine that is another in its seventh digit.
    let mut wrong = Cases::default();
    wrong.export("Pendulum", &["Verlet"]);
    let (coefficient, other) = ("1.9841269829358506e-4", "1.9841279829358506e-4");
    assert!(wrong.headers[0].contains(coefficient), "the kernel of sine");
    wrong.headers[0] = wrong.headers[0].replace(coefficient, other);
    wrong.add("pendulum", &pendulum, Verlet, "{1.1, 1.3}", Phase::new([2.0], [0.1]), 0.01);
    let found = wrong.compare(&compiler, "wrong_sine").expect_err("another coefficient of sine");
    assert!(found.starts_with("pendulum with Verlet: "), "{found}");
    // A coefficient of the composition.
    let mut wrong = Cases::default();
    wrong.export("Pendulum", &["Yoshida4"]);
    let coefficient = "1.3512071919596575";
    assert!(wrong.headers[0].contains(coefficient), "the table of Yoshida4");
    wrong.headers[0] = wrong.headers[0].replace(coefficient, "1.3512071919596675");
    wrong.add("pendulum", &pendulum, Yoshida4, "{1.1, 1.3}", Phase::new([2.0], [0.1]), 0.05);
    wrong.compare(&compiler, "wrong_table").expect_err("another coefficient of the composition");
}

/// The derivative of a run by its start.
#[test]
fn tangents_are_those_of_rust() {
    let Some(compiler) = compiler() else { return };
    let mut cases = Cases::default();
    cases.export("Kepler", &["Yoshida4"]);
    let (start, vector) =
        (Phase::new([1.0, 0.1, 0.0], [0.0, 0.9, 0.05]), Phase::new([0.1, 0.2, 0.3], [-0.3, 0.2, 0.1]));
    let mut tangent = Kepler { attraction: 1.1 }.tangent(Yoshida4, start, [vector], 0.01).expect("a run");
    tangent.advance(STEPS).expect("finite");
    let main = format!(
        "{}#include <stdio.h>\nint main(void) {{\n    const kepler_parameters parameters = {{1.1}};\n    kepler_state state = {{{{1.0, 0.1, \
         0.0}}, {{0.0, 0.9, 0.05}}, 0.0}}, tangent = {{{{0.1, 0.2, 0.3}}, {{-0.3, 0.2, 0.1}}, 0.0}};\n    \
         kepler_tangent_Yoshida4(&parameters, &state, &tangent, 0.01, {STEPS});\n    for (int i = 0; i < 3; ++i) \
         printf(\"%.17g\\n%.17g\\n\", tangent.q[i], tangent.p[i]);\n    return 0;\n}}\n",
        cases.headers[0],
    );
    let output = output(&compiler, "tangent", &main).expect("it runs");
    let found: Vec<f64> = output.lines().map(|line| line.parse().expect("a number")).collect();
    let [vector] = &tangent.vectors()[..] else { panic!("one vector") };
    let expected = vector.q.iter().zip(&vector.p).flat_map(|(q, p)| [*q, *p]);
    let size = found.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    assert!(size > 1.0, "{found:?}");
    for (found, expected) in found.iter().zip(expected) {
        // 6000 drifts and kicks of some ten roundings, 1.2e-16 of the largest number; a vector of a Kepler motion grows in
        // proportion to time, so that each of them grows to a hundred times its size at most in ten units of time.
        assert!((found - expected).abs() < 6000.0 * 10.0 * 1.2e-16 * 100.0 * size, "{found} and {expected}");
    }
}
