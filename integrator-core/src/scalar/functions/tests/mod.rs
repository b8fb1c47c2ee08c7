//! Every function that has a kernel, from one table: its accuracy, its edges, and the bits of its lanes.

mod points;
mod table;

use crate::scalar::{
    fma::{Fma, Fused},
    instruction_set::InstructionSet,
    real::{Kernel, Real},
};
use dashu_float::{FBig, round::mode::HalfEven};
use points::Points;
use table::{ROWS, Row};

/// A number with the requested number of digits.
type Big = FBig<HalfEven, 2>;

/// Digits in base 2 of the references for single points.
const SHARP: usize = 140;

/// A function, in anything that is computed in; one of a single argument ignores the second.
trait Function {
    fn call<R: Real>(x: R, y: R) -> R;
}

/// A function at many points, in the variant of `R`.
fn evaluate<F: Function, R: Real>(points: &[[f64; 2]]) -> Vec<f64> {
    struct Sweep<'a, F, R>(&'a [[f64; 2]], std::marker::PhantomData<(F, R)>);
    impl<F: Function, R: Real> Kernel for Sweep<'_, F, R> {
        type Out = Vec<f64>;
        #[inline(always)]
        fn call(self) -> Vec<f64> {
            let mut values = Vec::with_capacity(self.0.len());
            for points in self.0.chunks(R::LANES) {
                let [x, y] = [0, 1].map(|argument| R::state(&|lane| points[lane.min(points.len() - 1)][argument]));
                let value = F::call(x, y);
                values.extend((0..points.len()).map(|lane| value.lane(lane)));
            }
            values
        }
    }
    R::enter(Sweep::<F, R>(points, std::marker::PhantomData))
}

/// A precision: its spacing, and what it is computed in.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Precision {
    Double,
    Single,
}

impl Precision {
    /// The nearest number.
    fn round(self, x: f64) -> f64 {
        match self {
            Self::Double => x,
            Self::Single => f64::from(x as f32),
        }
    }

    /// The spacing of the numbers around `x`, the wider one at a power of two.
    fn unit(self, x: f64) -> f64 {
        let (digits, least) = match self {
            Self::Double => (52, f64::from_bits(1)),
            Self::Single => (23, f64::from(f32::from_bits(1))),
        };
        let power = f64::from_bits(x.to_bits() & f64::INFINITY.to_bits());
        (power * 0.5_f64.powi(digits)).max(least)
    }
}

/// The largest error of `values`, in units of the last place, and where.
///
/// The reference for all points has 53 digits, all right (`pxfm` rounds correctly): enough to measure singles. Doubles
/// have to be one of its neighbours, and some of those that differ from it are measured with more digits.
fn largest_error(row: &Row, precision: Precision, points: &[[f64; 2]], values: &[f64]) -> (f64, [f64; 2]) {
    let mut largest = (0.0, [0.0; 2]);
    let mut differ = 0;
    for (&x, &value) in points.iter().zip(values) {
        let reference = (row.exact)(x);
        if bits(value) == bits(precision.round(reference)) {
            continue;
        }
        let unit = precision.unit(reference);
        let mut error = (value - reference).abs() / unit;
        if precision == Precision::Double && error <= 1.0 {
            differ += 1;
            if differ % 256 == 1 {
                error = row.sharp_error(x, value, unit);
            }
        }
        if error.is_nan() || error > largest.0 {
            largest = (error, x);
        }
    }
    largest
}

#[test]
fn every_function_is_as_near_as_it_says() {
    let mut too_far = Vec::new();
    for row in ROWS {
        for set in row.points {
            for (scalar, precision, evaluate) in row.scalars {
                let points = set.arguments(precision, &format!("{} of {scalar}", row.name));
                let (error, at) = largest_error(row, precision, &points, &evaluate(&points));
                if error.is_nan() || error > row.ulps {
                    too_far.push(format!("{} of {scalar}, {set:?}: {error} ulp off at {at:?}", row.name));
                }
            }
        }
    }
    assert!(too_far.is_empty(), "{too_far:#?}");
}

/// Zeros, the ends of the exponents, NaN, and arguments that are far out for every function.
const EDGES: [f64; 20] = [
    0.0,
    5e-324,
    1e-310,
    f64::MIN_POSITIVE,
    1e-45,
    1e-40,
    f32::MIN_POSITIVE as f64,
    1e-20,
    0.5,
    1.0,
    1.5,
    709.0,
    3_215.5,
    1_647_098.0,
    1_647_100.0,
    1e22,
    f32::MAX as f64,
    f64::MAX,
    f64::INFINITY,
    f64::NAN,
];

/// All pairs of these, of both signs.
fn edges() -> impl Iterator<Item = [f64; 2]> {
    let signed = || EDGES.into_iter().flat_map(|x| [x, -x]);
    signed().flat_map(move |x| signed().map(move |y| [x, y]))
}

fn bits(x: f64) -> u64 {
    if x.is_nan() { u64::MAX } else { x.to_bits() }
}

#[test]
fn edges_are_those_of_std() {
    for row in ROWS {
        for (scalar, precision, evaluate) in row.scalars {
            let points: Vec<_> = edges().map(|point| point.map(|x| precision.round(x))).collect();
            for (&x, value) in points.iter().zip(evaluate(&points)) {
                let expected = precision.round((row.std)(x));
                let special = expected == 0.0 || !expected.is_finite();
                let near = (value - expected).abs() <= row.ulps * precision.unit(expected);
                let right = if special { bits(value) == bits(expected) } else { near };
                assert!(right, "{} of {x:?} in {scalar} is {value:e} for {expected:e}", row.name);
            }
        }
    }
}

#[test]
fn every_lane_is_the_scalar() {
    for row in ROWS {
        for (vector, set, lanes, scalar) in row.vectors {
            if !InstructionSet::available().contains(set) {
                continue;
            }
            for set in row.points {
                // A step that is coprime to all numbers of lanes mixes edges and ordinary numbers.
                let mut points = set.arguments(Precision::Single, row.name);
                points.truncate(10_000);
                points.iter_mut().step_by(5).zip(edges()).for_each(|(point, edge)| *point = edge);
                for ((&x, together), alone) in points.iter().zip(lanes(&points)).zip(scalar(&points)) {
                    assert_eq!(bits(together), bits(alone), "{} of {x:?} in {vector}", row.name);
                }
            }
        }
    }
}

#[test]
fn sine_and_cosine_together_are_the_two_alone() {
    fn both<R: Real>() {
        for x in EDGES.into_iter().chain((0..1000).map(|i| f64::from(i) * 0.37 - 150.0)) {
            let x = R::of(x);
            let (sine, cosine) = x.sin_cos();
            assert_eq!([bits(sine.lane(0)), bits(cosine.lane(0))], [x.sin(), x.cos()].map(|value| bits(value.lane(0))));
        }
    }
    both::<f64>();
    both::<f32>();
    both::<Fused<f64, Fma>>();
    both::<Fused<f32, Fma>>();
}
