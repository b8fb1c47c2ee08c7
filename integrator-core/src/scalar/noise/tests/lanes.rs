//! Every lane is the scalar, bit by bit.

use super::scrambled;
use crate::scalar::{
    double_double::DoubleDouble,
    dual::Dual,
    fma::{Avx512, Fused},
    instruction_set::InstructionSet,
    interval::Interval,
    noise::{gaussian::of_words, gaussians, philox},
    real::{Kernel, Real},
    simd::lanes::Lanes,
};
use std::marker::PhantomData;

/// Words at the ends: of the mantissa, of the sign, of quarters and of the circle.
const EDGES: [u32; 8] = [0, 1, u32::MAX, 1 << 31, (1 << 31) - 1, 1 << 30, 0x000f_ffff, 0xb504_f334];

/// Words of pairs: all edges, then words that look random.
pub(super) fn words(count: usize) -> Vec<[u64; 4]> {
    let edges = (0..EDGES.len().pow(4)).map(|number| {
        std::array::from_fn(|word| u64::from(EDGES[number / EDGES.len().pow(word as u32) % EDGES.len()]))
    });
    edges.chain((0..count).map(|number| std::array::from_fn(|word| u64::from(scrambled(4 * number + word))))).collect()
}

/// The numbers of words, in the variant of `R`: lanes of each member.
pub(super) fn of_all<R: Real>(words: &[[u64; 4]]) -> Vec<[Vec<f64>; 2]> {
    struct All<'a, R>(&'a [[u64; 4]], PhantomData<R>);
    impl<R: Real> Kernel for All<'_, R> {
        type Out = Vec<[Vec<f64>; 2]>;
        #[inline(always)]
        fn call(self) -> Self::Out {
            let (parts, mut numbers) = (R::LANES / R::MEMBERS, Vec::with_capacity(self.0.len()));
            for words in self.0.chunks(R::MEMBERS) {
                let pair = of_words::<R>(|member: usize| words[member.min(words.len() - 1)]);
                for member in 0..words.len() {
                    numbers
                        .push(pair.map(|number| (0..parts).map(|part| number.lane(member * parts + part)).collect()));
                }
            }
            numbers
        }
    }
    R::enter(All::<R>(words, PhantomData))
}

/// The number in lane 0 of each member is that of `S`, and its derivatives are zero.
fn compare<V: Real, S: Real>(name: &str) {
    let words = words(10_000);
    for ((lanes, alone), words) in of_all::<V>(&words).iter().zip(of_all::<S>(&words)).zip(&words) {
        for (lanes, alone) in lanes.iter().zip(alone) {
            let bits = |x: f64| x.to_bits();
            assert_eq!(bits(lanes[0]), bits(alone[0]), "{name}: {} for {} of {words:x?}", lanes[0], alone[0]);
            assert!(lanes[1..].iter().all(|along| *along == 0.0), "{name}: {lanes:?} of {words:x?}");
        }
    }
    counters_of_lanes::<V, S>(name);
}

/// The counters of lanes are those of members.
fn counters_of_lanes<V: Real, S: Real>(name: &str) {
    struct Draw<R>([u32; 2], u32, PhantomData<R>);
    impl<R: Real> Kernel for Draw<R> {
        type Out = [R; 2];
        #[inline(always)]
        fn call(self) -> [R; 2] {
            gaussians(self.0, |lane: usize| [lane as u32 + self.1, 5, 1 << 31, 7])
        }
    }
    let (key, parts) = ([3, 0x8000_0001], V::LANES / V::MEMBERS);
    let together = V::enter(Draw::<V>(key, 0, PhantomData));
    for member in 0..V::MEMBERS {
        let alone = S::enter(Draw::<S>(key, (member * parts) as u32, PhantomData));
        for (together, alone) in together.iter().zip(alone) {
            let lane = together.lane(member * parts);
            assert_eq!(lane.to_bits(), alone.lane(0).to_bits(), "{name}, member {member}");
        }
    }
}

#[test]
fn every_lane_is_the_scalar() {
    compare::<Lanes<f64, 2>, f64>("two lanes");
    compare::<Lanes<f64, 3>, f64>("three lanes");
    compare::<Lanes<f32, 8>, f32>("eight lanes of singles");
    compare::<<f64 as Real>::Row<8>, f64>("a row");
    compare::<Lanes<<f64 as Real>::Row<8>, 8>, f64>("a row of members");
    compare::<Lanes<Lanes<f64, 16>, 8>, f64>("the largest row of members");
    compare::<Dual, f64>("a dual");
    compare::<Dual<f32, 3>, f32>("three directions");
    compare::<Dual<Dual>, f64>("second derivatives");
    compare::<Lanes<Dual, 4>, f64>("lanes of duals");
    compare::<Dual<Lanes<f64, 4>, 2>, f64>("duals of lanes");
    compare::<<Dual as Real>::Row<8>, f64>("a row of duals");
}

#[test]
fn every_fused_lane_is_the_fused_scalar() {
    compare::<Fused<f64, Avx512>, Fused<f64>>("the other variant");
    compare::<Fused<f32, Avx512>, Fused<f32>>("the other variant in singles");
    compare::<Dual<Fused<f64>>, Fused<f64>>("a dual");
    if InstructionSet::available().contains(&InstructionSet::Fused) {
        compare::<<Fused<f64> as Real>::Block, Fused<f64>>("a block of AVX2");
        compare::<<Fused<f32> as Real>::Block, Fused<f32>>("a block of singles of AVX2");
        compare::<<Fused<f64> as Real>::Row<8>, Fused<f64>>("a row of AVX2");
        compare::<Dual<<Fused<f64> as Real>::Block>, Fused<f64>>("a dual of a block of AVX2");
    }
    if InstructionSet::available().contains(&InstructionSet::Avx512) {
        type Wide<F> = <Fused<F, Avx512> as Real>::Block;
        compare::<Wide<f64>, Fused<f64>>("a block of AVX-512");
        compare::<Wide<f32>, Fused<f32>>("a block of singles of AVX-512");
        compare::<<Fused<f32, Avx512> as Real>::Row<8>, Fused<f32>>("a row of singles of AVX-512");
        compare::<<Wide<f64> as Real>::Row<8>, Fused<f64>>("a row of members in AVX-512");
        compare::<<Wide<f32> as Real>::Row<8>, Fused<f32>>("a row of members in singles of AVX-512");
        compare::<Dual<Wide<f64>>, Fused<f64>>("a dual of a block of AVX-512");
    }
}

/// Otherwise lanes of the wrong scalar would pass.
#[test]
fn fused_numbers_differ_from_others() {
    let words = words(1_000);
    assert_ne!(of_all::<f64>(&words), of_all::<Fused<f64>>(&words));
    assert_ne!(of_all::<f32>(&words), of_all::<Fused<f32>>(&words));
}

#[test]
fn intervals_and_double_doubles_enclose_or_approach_the_number() {
    let words = words(2_000);
    let (plain, bounds, longer) = (of_all::<f64>(&words), of_all::<Interval>(&words), of_all::<DoubleDouble>(&words));
    for (((plain, bounds), longer), words) in plain.iter().zip(bounds).zip(longer).zip(&words) {
        for number in 0..2 {
            let (x, [low, high]) = (plain[number][0], [bounds[number][0], bounds[number][1]]);
            assert!(low <= x && x <= high, "{x} in {low}..{high} of {words:x?}");
            // Each of some thirty operations on numbers below ten widens the bounds by few roundings.
            assert!(high - low < 1000.0 * f64::EPSILON, "{low}..{high} of {words:x?}");
            assert!((longer[number][0] - x).abs() <= high - low, "{x} for {} of {words:x?}", longer[number][0]);
        }
    }
}

#[test]
fn numbers_are_those_of_the_words() {
    for number in 0..1000 {
        let [a, b, c, d, e, f] = std::array::from_fn(|word| scrambled(6 * number + word));
        let [x, y] = gaussians::<f64>([e, f], |_: usize| [a, b, c, d]);
        let words = philox([a, b, c, d], [e, f]).map(u64::from);
        assert_eq!([x, y], of_words::<f64>(|_: usize| words));
        // Upper halves do not matter.
        assert_eq!([x, y], of_words::<f64>(|_: usize| words.map(|word| word | u64::from(e) << 32)));
    }
}
