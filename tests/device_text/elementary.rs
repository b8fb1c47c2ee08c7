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
        abs acos asin atan cbrt ceil cos exp floor ln round signum sin sqrt tan tanh fast_acos fast_asin fast_atan fast_cbrt
        fast_cos fast_exp fast_ln fast_sin fast_tan fast_tanh;
        atan2 fast_atan2 max min powf remainder)
}

/// How many pairs of arguments are held against each other at a time.
const BATCH: usize = 20_000;

/// How many there are: the gate asks for ten million.
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
        for expected in [values::<Fused<f64>>(x, y), values::<Fused<f32>>(x, y)] {
            for (name, expected) in expected {
                let found = found.next().expect("a value");
                // A NaN has no sign that anybody reads.
                let alike = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
                assert!(alike, "{name} of {x:e} and {y:e} is {found:e} on a device and {expected:e} here");
            }
        }
    }
    assert!(found.next().is_none());
}
