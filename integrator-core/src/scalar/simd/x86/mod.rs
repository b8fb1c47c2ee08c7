//! The SIMD vectors of x86-64: members of an ensemble, or consecutive numbers of an array.
//!
//! Always true: every lane has the bits of the [`Fused`](crate::scalar::fma::Fused) scalar of the same variant: the
//! operations are the same IEEE ones, elementary functions have one kernel for both or are called lane by lane. Only
//! code that runs where the instruction set was chosen names these types; that is what makes their instructions sound.

/// Runs instructions of the set that a vector belongs to. Those that read or write through a pointer are in separate
/// blocks, which state how much memory it refers to.
macro_rules! instruction {
    ($call:expr) => {
        // SAFETY: a vector is named only where its instruction set was chosen, which means that it was detected.
        unsafe { $call }
    };
}

mod avx2;
mod avx512;
mod bits;
mod pair;
mod real;
mod roots;
mod row;

pub use avx2::{S8, V8, X4};
pub use avx512::{S16, X8};
pub use pair::X2;
pub use roots::Estimate;
pub(crate) use roots::{div_pow_3_2, div_sqrt};

/// The same number, which no optimisation puts into a vector with others.
#[inline(always)]
pub(crate) fn apart(mut number: f64) -> f64 {
    // SAFETY: there is no instruction.
    unsafe { core::arch::asm!("/* {0} */", inout(xmm_reg) number, options(pure, nomem, nostack, preserves_flags)) };
    number
}

#[cfg(test)]
mod tests {
    use super::{S8, S16, V8, X4, X8};
    use crate::scalar::{
        fma::{Avx512, Fma, Fused},
        instruction_set::InstructionSet,
        real::{Mask, Real},
        simd::block::{Block, PICKED},
    };

    /// Points where the operations and comparisons have their edges: 1e-310 is subnormal in double precision, 1e-40 in
    /// single precision.
    const POINTS: [f64; 13] = [
        0.0,
        -0.0,
        1.5,
        -2.25,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        1e-310,
        1e-40,
        // The largest number below a half, a half, and a whole number too large for a half to be added.
        0.499_999_999_999_999_94,
        -0.5,
        4_503_599_627_370_497.0,
        -0.499_999_97,
    ];

    /// Every operation on the numbers `a` and `b`: all lanes of the results.
    fn results<R: Real>(a: R, b: R) -> Vec<Vec<u64>> {
        let mut results = vec![
            a + b,
            a - b,
            a * b,
            a / b,
            -a,
            a.fma(b, b),
            a.sqrt(),
            a.abs(),
            a.sin(),
            a.min(b),
            a.powf(b),
            a.apart(),
        ];
        results.extend([a.sin_cos().0, a.sin_cos().1]);
        results.extend([a.floor(), a.ceil(), a.trunc(), a.round(), a.round_ties_even(), a.remainder(b)]);
        let masks = [
            a.less(b),
            a.less_or_equal(b),
            a.equal(b),
            a.less(b).not(),
            a.less(b).or(b.less(a)),
            a.less_or_equal(b).and(b.less_or_equal(a)),
            Mask::of(true),
            Mask::of(false),
        ];
        results.extend(masks.map(|mask| R::select(mask, a, b)));
        results.into_iter().map(|value| (0..R::LANES).map(|lane| bits(value.lane(lane))).collect()).collect()
    }

    /// The bits of a number; all NaNs are one.
    fn bits(x: f64) -> u64 {
        if x.is_nan() { u64::MAX } else { x.to_bits() }
    }

    /// Every operation on every pair of points, with other points in the other lanes, against the scalar.
    fn compare<V: Real, R: Real>() {
        let point = |lane: usize| POINTS[lane % POINTS.len()];
        for first in 0..POINTS.len() {
            for second in 0..POINTS.len() {
                let (a, b) = (V::state(&|lane| point(first + lane)), V::state(&|lane| point(second + 2 * lane)));
                let together = results(a, b);
                for lane in 0..V::LANES {
                    let (x, y) = (point(first + lane), point(second + 2 * lane));
                    let alone = results(R::of(x), R::of(y));
                    for (operation, (together, alone)) in together.iter().zip(&alone).enumerate() {
                        assert_eq!(together[lane], alone[0], "operation {operation} on {x} and {y} in lane {lane}");
                    }
                }
            }
        }
    }

    /// Predicates over all lanes.
    fn whole<V: Real>() {
        for special in 0..V::LANES {
            for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                assert!(!V::state(&|lane| if lane == special { x } else { 1.0 }).finite(), "{x} in lane {special}");
            }
            let ramp = V::state(&|lane| lane as f64);
            assert!(ramp.equal(V::of(special as f64)).any());
            assert!(!ramp.equal(V::of(special as f64 + 0.5)).any());
        }
        assert!(V::state(&|lane| lane as f64).finite());
    }

    /// Blocks are loaded and stored at any index of an array, and store nothing outside of themselves.
    fn loads_and_stores<V: Block<R>, R: Real>() {
        let array: Vec<R> = (0..3 * V::WIDTH).map(|i| R::of(i as f64 + 0.5)).collect();
        for first in [0, 1, V::WIDTH, 2 * V::WIDTH] {
            let mut copy = array.clone();
            (V::read(&array[first..]) + V::splat(R::of(100.0))).write(&mut copy[first..]);
            for (i, number) in copy.iter().enumerate() {
                let moved = if (first..first + V::WIDTH).contains(&i) { 100.0 } else { 0.0 };
                assert_eq!(number.lane(0), i as f64 + 0.5 + moved, "element {i} of a block at {first}");
            }
        }
        let [first, second] = [0, V::WIDTH].map(|begin| V::read(&array[begin..]));
        for lane in 0..V::WIDTH {
            let (later, earlier) = (first.after(second), second.before(first));
            assert_eq!(later.lane(lane), (lane + 1) as f64 + 0.5, "one element later");
            assert_eq!(earlier.lane(lane), (V::WIDTH + lane - 1) as f64 + 0.5, "one element earlier");
        }
        let of_both = |pair: [V; 2], at: usize| pair[at / V::WIDTH].lane(at % V::WIDTH);
        let ([evens, odds], back) = (first.deinterleave(second), |[evens, odds]: [V; 2]| evens.interleave(odds));
        for at in 0..2 * V::WIDTH {
            let from = if at < V::WIDTH { 2 * at } else { 2 * (at - V::WIDTH) + 1 };
            assert_eq!(of_both([evens, odds], at), from as f64 + 0.5, "even elements, then odd ones: {at}");
            assert_eq!(of_both(back([evens, odds]), at), at as f64 + 0.5, "element {at} of both in turn");
        }
    }

    /// Words whose bits are set are picked in order.
    fn picks<V: Block<R>, R: Real>() {
        let words: [u32; PICKED] = std::array::from_fn(|at| 1000 + at as u32);
        for bits in [0, 1, u64::MAX, 1 << 63, 0x8000_ffff_0001_8001, 0x9e37_79b9_7f4a_7c15, !0x9e37_79b9_7f4a_7c15] {
            let (mut picked, expected) =
                ([0; PICKED], (0..PICKED).filter(|at| bits >> at & 1 == 1).map(|at| words[at]));
            let count = V::pick(&words, bits, &mut picked);
            assert!(picked[..count].iter().copied().eq(expected), "{bits:x}: {:?}", &picked[..count]);
        }
    }

    fn every_lane_is_the_scalar<V: Block<R>, R: Real>(set: InstructionSet) {
        if InstructionSet::available().contains(&set) {
            compare::<V, R>();
            whole::<V>();
            loads_and_stores::<V, R>();
            picks::<V, R>();
        }
    }

    #[test]
    fn every_lane_is_the_fused_scalar() {
        every_lane_is_the_scalar::<X4, Fused<f64, Fma>>(InstructionSet::Fused);
        every_lane_is_the_scalar::<S8, Fused<f32, Fma>>(InstructionSet::Fused);
        every_lane_is_the_scalar::<V8, Fused<f32, Avx512>>(InstructionSet::Avx512);
        every_lane_is_the_scalar::<X8, Fused<f64, Avx512>>(InstructionSet::Avx512);
        every_lane_is_the_scalar::<S16, Fused<f32, Avx512>>(InstructionSet::Avx512);
    }

    #[test]
    fn both_fused_variants_have_the_same_bits() {
        compare::<Fused<f64, Fma>, Fused<f64, Avx512>>();
        compare::<Fused<f32, Fma>, Fused<f32, Avx512>>();
    }
}
