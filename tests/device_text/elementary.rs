//! Elementary functions of the header for devices against the kernels.

use integrator_core::__private::{Fused, Real};
use std::{
    io::{Read, Write},
    path::Path,
    process::{Command, Stdio},
    thread,
};

macro_rules! values {
    ($scalar:ty, $x:expr, $y:expr; $($unary:ident)*; $($binary:ident)*) => {{
        let (x, y) = (<$scalar>::of($x), <$scalar>::of($y));
        let (sine, cosine) = x.sin_cos();
        vec![$((stringify!($unary), x.$unary().lane(0)),)* $((stringify!($binary), x.$binary(y).lane(0)),)*
            ("the sine of both", sine.lane(0)), ("the cosine of both", cosine.lane(0))]
    }};
}

/// The functions in the order of `functions.cpp`, with their values.
fn values<R: Real>(x: f64, y: f64) -> Vec<(&'static str, f64)> {
    values!(R, x, y;
        abs acos asin atan cbrt ceil cos exp floor ln ln_1p round round_ties_even signum sin sqrt tan tanh trunc fast_acos fast_asin
        fast_atan fast_cbrt fast_cos fast_exp fast_ln fast_ln_1p fast_sin fast_tan fast_tanh;
        atan2 fast_atan2 max min powf remainder)
}

/// How many pairs of arguments are held against each other at a time.
const BATCH: usize = 20_000;

/// How many there are: `.ci/run` sets the variable for more.
fn count() -> usize {
    std::env::var("DEVICE_TEXT_POINTS").ok().and_then(|count| count.parse().ok()).unwrap_or(3_000)
}

/// Pairs of arguments of all sizes and signs, and those at which functions change their way.
fn arguments(batch: usize) -> Vec<[f64; 2]> {
    let special =
        [0.0, -0.0, 0.5, -0.5, 1.0, -1.0, 2.0, 1e-300, 1e300, f64::INFINITY, -f64::INFINITY, f64::NAN, 709.5, -745.0];
    let mut random = fastrand::Rng::with_seed(batch as u64);
    let mut drawn = || {
        let number = (random.f64() - 0.5) * [2.0, 20.0, 2e3, 2e6][random.usize(0..4)];
        if random.u8(0..8) == 0 { f64::from_bits(random.u64(..)) } else { number }
    };
    let drawn = (0..BATCH.min(count() - batch * BATCH)).map(|_| [drawn(), drawn()]).collect::<Vec<_>>();
    special.into_iter().flat_map(|x| special.map(|y| [x, y])).chain(drawn).collect()
}

/// Whether a kernel leaves these arguments to the maths library, of which a program of C++ may have another than a program of
/// Rust has.
fn is_left_to_library(name: &str, x: f64, y: f64, is_single: bool) -> bool {
    let (least, greatest, farthest, near, far, power) = match is_single {
        true => (f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX), 3_216.0, 1e-13, 1e13, 87.0),
        false => (f64::MIN_POSITIVE, f64::MAX, 1_647_099.0, 1e-140, 1e140, 708.0),
    };
    let is_normal = |x: f64| (least..=greatest).contains(&x);
    let [small, big] = [x.abs().min(y.abs()), x.abs().max(y.abs())];
    match name.trim_start_matches("fast_") {
        "sin" | "cos" | "tan" | "the sine of both" | "the cosine of both" => x.abs() > farthest,
        "ln" => !is_normal(x),
        "ln_1p" => !(x > -1.0 && x <= 0.25 * greatest),
        "cbrt" => !is_normal(x.abs()),
        "atan2" => !(near < big && big < far && (near < small || small == 0.0)),
        // The product of the exponent and the logarithm is rounded.
        "powf" => !(is_normal(x) && (y * x.ln()).abs() < 0.999 * power),
        _ => false,
    }
}

/// The most units in the last place that two maths libraries are apart.
const LIBRARIES: f64 = 4.0;

/// Every function that device code may call.
#[test]
fn every_function_of_devices_is_compared() {
    let compared: Vec<&str> = values::<f64>(0.5, 0.5).into_iter().map(|(name, _)| name).collect();
    for name in integrator_symbolic::device_functions() {
        assert!(compared.contains(&name), "`{name}`");
    }
}

/// Holds every function at every argument against the kernels with fused multiply-add.
pub(crate) fn compare(program: &Path) {
    (0..count().div_ceil(BATCH)).for_each(|batch| compare_at(program, &arguments(batch)));
}

fn compare_at(program: &Path, arguments: &[[f64; 2]]) {
    let mut child =
        Command::new(program).arg("functions").stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("starts");
    let (mut to, mut from) = (child.stdin.take().expect("a pipe"), child.stdout.take().expect("a pipe"));
    let input: Vec<u8> = arguments.iter().flatten().flat_map(|number| number.to_ne_bytes()).collect();
    let writer = thread::spawn(move || to.write_all(&input));
    let mut output = Vec::new();
    from.read_to_end(&mut output).expect("output");
    writer.join().expect("a thread").expect("input");
    assert!(child.wait().expect("an end").success());
    let mut found = output.chunks_exact(8).map(|word| f64::from_ne_bytes(word.try_into().expect("eight bytes")));
    for &[x, y] in arguments {
        let [single_x, single_y] = [x, y].map(|number| f64::from(number as f32));
        let of_double = (values::<Fused<f64>>(x, y), x, y, false);
        let of_single = (values::<Fused<f32>>(x, y), single_x, single_y, true);
        for (expected, x, y, is_single) in [of_double, of_single] {
            let (epsilon, least) = match is_single {
                true => (f64::from(f32::EPSILON), f64::from(f32::MIN_POSITIVE)),
                false => (f64::EPSILON, f64::MIN_POSITIVE),
            };
            for (name, expected) in expected {
                let found = found.next().expect("a value");
                // A NaN has no sign that anybody reads.
                let equal = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
                let near = (found - expected).abs() <= LIBRARIES * epsilon * expected.abs().max(least);
                let alike = equal || near && is_left_to_library(name, x, y, is_single);
                assert!(alike, "{name} of {x:e} and {y:e} is {found:e} on a device and {expected:e} here");
            }
        }
    }
    assert!(found.next().is_none());
}
