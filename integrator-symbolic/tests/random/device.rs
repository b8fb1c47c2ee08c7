//! The text for devices of random systems, compiled by this machine's C++ compiler and held against the generated Rust text
//! in this interpreter, bit for bit.
//!
//! Elementary functions are those of the maths library in both, since those of devices are compared with the kernels
//! elsewhere; each operation is that of the texts. All systems are one program. `DEVICE_TEXT_SYSTEMS` asks for more.

use crate::{
    choice::seeds,
    expansion::Expansion,
    grammar,
    judge::{Case, System, machine, method},
    machine::Machine,
    number::{Kind, Number},
    systems::corpus,
    value::{Outcome, Stop, Value, foreign},
};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use std::{
    collections::BTreeMap,
    env,
    fmt::Write as _,
    fs, io,
    io::Write as _,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    rc::Rc,
};
use syn::{Expr, ImplItemFn, ItemImpl, Stmt};

/// What is compared of each system, as far as it has it.
const FLOWS: [&str; 3] = ["drift", "kick", "hessian"];
/// A duration that is no power of two, so that products with it are rounded.
const DURATION: f64 = 0.37;

/// What a host's compiler and the loop over steps need, as the crate for devices has them.
const HOST: &str = include_str!("../../../integrator-gpu/src/cuda/host.h");
const STEPPER: &str = include_str!("../../../integrator-gpu/src/cuda/stepper.h");
const INNER_STEPS: &str = include_str!("../../../integrator-gpu/src/cuda/inner_steps.h");
const PAIRS: &str = include_str!("../../../integrator-gpu/src/cuda/pairs.h");
const FUNCTIONS: &str = include_str!("functions.h");
const MAIN: &str = include_str!("device.cpp");

/// A state that a flow starts from, with the constants of the system, and where the Rust text ends.
struct Launch {
    name: String,
    system: usize,
    flow: usize,
    numbers: Vec<f64>,
    expected: Vec<f64>,
}

/// The systems of one program.
#[derive(Default)]
struct Systems {
    texts: Vec<String>,
    launches: Vec<Launch>,
    refusals: BTreeMap<String, usize>,
}

impl Systems {
    fn add(&mut self, name: &str, system: &System) {
        let Some(expansion) = self.expand(quote!(gpu), system.item.clone()) else { return };
        let Ok(item) = syn::parse2::<ItemImpl>(system.item.clone()) else { return };
        let methods: Vec<_> = item.items.iter().filter_map(method).collect();
        let Some((text, constants)) = expansion.device_text() else { return };
        // Rust brings a cube root of its own.
        if text.contains("cbrt(") {
            return;
        }
        self.texts.push(text);
        for case in &system.cases {
            for (number, flow) in FLOWS.into_iter().enumerate() {
                let Some(function) = expansion.flow(flow) else { continue };
                let name = format!("{name}, {flow}");
                match moved(&methods, &expansion, constants, case, function) {
                    Ok((numbers, expected)) => {
                        let system = self.texts.len() - 1;
                        self.launches.push(Launch { name, system, flow: number, numbers, expected });
                    }
                    // Indices beyond the end are a panic in Rust, and anything in C++.
                    Err(Stop::Panic(_)) => {}
                    Err(stop) => panic!("{name}: {stop}"),
                }
            }
        }
    }

    /// What the macro makes of a system, if it has a text for devices.
    fn expand(&mut self, arguments: TokenStream, item: TokenStream) -> Option<Expansion> {
        match Expansion::read(integrator_symbolic::hamiltonian(arguments, item)) {
            Ok(expansion) => Some(expansion),
            Err(refusal) => {
                *self.refusals.entry(refusal).or_default() += 1;
                None
            }
        }
    }

    /// The text of a program of all systems.
    fn program(&self) -> String {
        let mut text = format!("{HOST}{FUNCTIONS}{STEPPER}{INNER_STEPS}{PAIRS}{MAIN}");
        for (number, system) in self.texts.iter().enumerate() {
            let _ = writeln!(text, "namespace integrator {{ namespace system_{number} {{\n{system}}} }}");
        }
        text += "int main() {\nstd::vector<Flows> all;\n";
        for number in 0..self.texts.len() {
            let _ = writeln!(text, "add<integrator::system_{number}::System>(all);");
        }
        text + "return serve(all);\n}\n"
    }

    /// What is wrong with the texts, as far as their program tells.
    fn faults(&self, program: &Path) -> Vec<String> {
        let mut input = Vec::new();
        for launch in &self.launches {
            [launch.system, launch.flow].iter().for_each(|word| input.extend((*word as u64).to_ne_bytes()));
            launch.numbers.iter().for_each(|number| input.extend(number.to_ne_bytes()));
        }
        let output = piped(program, input).expect("the program runs");
        let mut words = output.chunks_exact(8).map(|word| f64::from_ne_bytes(word.try_into().expect("eight bytes")));
        let mut faults = Vec::new();
        for Launch { name, system, expected, .. } in &self.launches {
            let found: Vec<_> = words.by_ref().take(expected.len()).collect();
            let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
            if found.len() != expected.len() || !found.iter().zip(expected).all(same) {
                faults.push(format!("{name}: {found:?} where Rust has {expected:?}\n{}", self.texts[*system]));
            }
        }
        faults
    }
}

/// The constants of a device, the state and the times of a flow, and the state that the Rust text makes of it.
fn moved(
    methods: &[&ImplItemFn],
    expansion: &Expansion,
    constants: &ImplItemFn,
    case: &Case,
    flow: &ImplItemFn,
) -> Outcome<(Vec<f64>, Vec<f64>)> {
    let mut machine = machine(methods, case);
    expansion.teach(&mut machine);
    let parameters = expansion.function("parameters").ok_or_else(|| Stop::Foreign("no `parameters`".into()))?;
    let parameters = machine.call(parameters, vec![Value::size(case.state[0].len())])?;
    let mut numbers = pushed(&mut machine, constants, &parameters)?;
    let slots =
        |part: usize| case.shaped(&case.state[part], |value| Value::Slot(Number::plain(value).of_kind(Kind::Scalar)));
    let fields = [("q", slots(0)), ("p", slots(1)), ("parameters", parameters.lifted(Kind::Scalar))];
    let motion = Value::Struct(Rc::new(fields.map(|(name, value)| (name.to_owned(), value)).to_vec()));
    let state = |motion: &Value| -> Outcome<Vec<f64>> {
        let mut numbers = Vec::new();
        ["q", "p"].iter().try_for_each(|half| motion.field(half).map(|half| half.numbers(&mut numbers)))?;
        Ok(numbers.into_iter().map(|number| number.main.value).collect())
    };
    let before = state(&motion)?;
    numbers.extend(&before);
    numbers.extend([DURATION, case.time]);
    let duration = (flow.sig.inputs.len() == 3).then(|| Value::plain(DURATION));
    let arguments = [Some(motion), duration, Some(Value::plain(case.time))].into_iter().flatten().collect();
    let (_, after) = machine.run(flow, arguments, Some(0))?;
    // A flow without a gradient has no motion to name.
    let after = if let Value::Struct(_) = after { state(&after)? } else { before };
    Ok((numbers, after))
}

/// The constants that `push_constants` adds to its list.
fn pushed(machine: &mut Machine<'_>, function: &ImplItemFn, parameters: &Value) -> Outcome<Vec<f64>> {
    let mut numbers = Vec::new();
    machine.names.push((quote::format_ident!("parameters"), parameters.clone()));
    for statement in &function.block.stmts {
        let arguments = match statement {
            Stmt::Expr(Expr::MethodCall(call), _) => Some(&call.args),
            Stmt::Expr(Expr::Call(call), _) => Some(&call.args),
            _ => None,
        };
        let Some(pushed) = arguments.and_then(|arguments| arguments.first()) else {
            return foreign(statement.to_token_stream().to_string());
        };
        let pushed = machine.expression(pushed)?;
        let lengths: Vec<usize> = match arguments.and_then(|arguments| arguments.iter().nth(1)) {
            Some(Expr::Reference(lengths)) => {
                let text = lengths.expr.to_token_stream().to_string();
                text.split(|letter: char| !letter.is_ascii_digit()).filter_map(|length| length.parse().ok()).collect()
            }
            _ => Vec::new(),
        };
        push(&pushed, &lengths, &mut numbers)?;
    }
    machine.names.pop();
    Ok(numbers.into_iter().map(|number| number.main.value).collect())
}

/// Adds a constant, and zeros for the elements that its lists lack of these lengths.
fn push(constant: &Value, lengths: &[usize], numbers: &mut Vec<Number>) -> Outcome<()> {
    match (constant, lengths) {
        (Value::List(elements), [length, inner @ ..]) => {
            elements.iter().try_for_each(|element| push(element, inner, numbers))?;
            let Some(missing) = length.checked_sub(elements.len()) else {
                // The runtime refuses such a member.
                return Err(Stop::Panic("a list is too long".into()));
            };
            numbers.extend((0..missing * inner.iter().product::<usize>()).map(|_| Number::plain(0.0)));
        }
        _ => constant.numbers(numbers),
    }
    Ok(())
}

/// The C++ compiler of this machine; `None` with the reason said where there is none.
fn compiler() -> Option<String> {
    let named = env::var("CXX").ok().into_iter();
    let found = named.chain(["c++", "g++", "clang++"].map(str::to_owned)).find(|name| {
        let mut asked = Command::new(name);
        asked.arg("--version").stdout(Stdio::null()).stderr(Stdio::null());
        asked.status().is_ok_and(|status| status.success())
    });
    if found.is_none() {
        eprintln!("SKIPPED: no C++ compiler is installed, so that the text for devices was not compiled");
    }
    found
}

fn compiled(compiler: &str, text: &str, name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let (source, program) = (folder.join(format!("{name}.cpp")), folder.join(name));
    fs::write(&source, text).expect("a folder for files");
    let options = ["-std=c++17", "-O0", "-mfma", "-ffp-contract=off", "-Werror=shadow=compatible-local"];
    let mut command = Command::new(compiler);
    // Fused multiply-add is an instruction where there is one, or a call: both round once.
    #[cfg(target_arch = "x86_64")]
    let fused = std::arch::is_x86_feature_detected!("fma");
    #[cfg(not(target_arch = "x86_64"))]
    let fused = false;
    command.args(options.iter().filter(|option| fused || **option != "-mfma"));
    let output = command.arg(&source).arg("-o").arg(&program).output().expect("the compiler starts");
    assert!(output.status.success(), "{}: {}", source.display(), String::from_utf8_lossy(&output.stderr));
    program
}

fn piped(program: &Path, input: Vec<u8>) -> io::Result<Vec<u8>> {
    let mut child = Command::new(program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
    let mut to = child.stdin.take().expect("a pipe");
    let writer = std::thread::spawn(move || to.write_all(&input));
    let output = child.wait_with_output()?;
    writer.join().expect("no panic")?;
    if output.status.success() { Ok(output.stdout) } else { Err(io::Error::other(output.status.to_string())) }
}

/// All systems in one program, which is compiled once.
fn faults(systems: &Systems, name: &str) -> Option<Vec<String>> {
    Some(systems.faults(&compiled(&compiler()?, &systems.program(), name)))
}

#[test]
fn device_code_is_bitwise_identical_to_the_rust_code() {
    let mut systems = Systems::default();
    let seeds = seeds(["RANDOM_SYSTEMS_SEED", "DEVICE_TEXT_SYSTEMS"], 16);
    let count = seeds.end - seeds.start;
    for seed in seeds {
        systems.add(&format!("system {seed}"), &grammar::fixed_system(seed));
    }
    systems.add("names", &named());
    let random = systems.texts.len();
    assert!(random as u64 * 3 >= count, "{:#?}", systems.refusals);
    // Fields have values in random systems alone; texts of the corpus have to compile.
    for system in corpus() {
        let others = system.arguments;
        let expansion = systems.expand(quote!(gpu, #others), system.item.to_token_stream());
        systems.texts.extend(expansion.and_then(|expansion| Some(expansion.device_text()?.0)));
    }
    assert!(systems.texts.len() >= random + 25, "{:#?}", systems.refusals);
    println!("{} texts, {} flows; {:#?}", systems.texts.len(), systems.launches.len(), systems.refusals);
    let Some(faults) = faults(&systems, "texts_of_random_systems") else { return };
    assert!(faults.is_empty(), "{} of {}:\n{}", faults.len(), systems.launches.len(), faults[0]);
}

/// A product that is rounded before it is added is found, and so are two constants in each other's place.
#[test]
fn device_code_with_a_mistake_is_found() {
    for (from, to) in [("fma(step, gradient[i])", "add(step * gradient[i])"), ("number(0)", "number(1)")] {
        let mut systems = Systems::default();
        systems.add("names", &named());
        systems.texts[0] = systems.texts[0].replacen(from, to, 1);
        let Some(faults) = faults(&systems, "texts_of_a_mistake") else { return };
        assert!(!faults.is_empty(), "{to} stays unnoticed");
    }
}

/// Names that mean something in C++, in CUDA or in the text, and those that these become.
const NAMES: &str = "alignas and asm auto bool class default delete double float int long new not operator or short \
    signed sizeof template this_ typename union unsigned void volatile while_ xor fma sin sin_cos powf fast_exp infinity \
    not_a_number motion step time gradient duration at parameters position momentum number Parameters Source System R K i0 \
    i0_ i0__ path_0 path_0_ DEVICE NAN errno stdin M_PI HUGE_VAL __CUDACC__ _Bool linux unix threadIdx blockIdx warpSize \
    integrator Plain drift kick middle INNER inner_steps \u{3b1} U3b1_ u3b1 double_ double__ Double";

/// A system whose fields and indices have them.
fn named() -> System {
    let names: Vec<_> = NAMES.split_whitespace().collect();
    let mut energy = String::from("std::f64::consts::PI * q[0] + ");
    for name in &names {
        let _ = write!(energy, "self.{name} * q[0].sin() + {{ let mut v = 0.0; ");
        let _ = write!(energy, "for {name} in 0..2 {{ v += self.table[{name}] * q[{name}].cos(); }} v }} + ");
    }
    let item = format!(
        "impl System {{
            fn kinetic(&self, p: [f64; 2]) -> f64 {{ self.at * p[0] * p[0] + self.step * p[1] * p[1] }}
            fn potential(&self, q: [f64; 2], t: f64) -> f64 {{ {energy} t * q[1] }}
        }}"
    );
    let numbers =
        names.iter().zip(1..).map(|(name, number)| ((*name).to_owned(), Value::plain(f64::from(number).sqrt())));
    let table = ("table".to_owned(), Value::list([0.3, -0.4].map(Value::plain)));
    let fields = Value::Struct(Rc::new(numbers.chain([table]).collect()));
    // One rounding more is often none: several states tell.
    let cases = (1..=4).map(|number| Case {
        fields: fields.clone(),
        state: [[0.3, 0.2], [0.7, -0.6]].map(|half| half.map(|x| vec![x / f64::from(number)]).to_vec()),
        is_flat: true,
        time: 0.9,
    });
    System { item: item.parse().unwrap_or_else(|error| panic!("{error}: {item}")), cases: cases.collect() }
}
