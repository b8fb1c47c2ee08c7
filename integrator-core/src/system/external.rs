//! External functions: methods of the user that generated code calls, as tables and splines, with stated derivatives.

use crate::scalar::real::Real;
use alloc::{sync::Arc, vec::Vec};

/// A function of a few numbers, one per lane.
pub type External<const N: usize> = Vec<Arc<dyn Fn([f64; N]) -> f64 + Send + Sync>>;

/// The value of a function in every lane; `None` where its value or a derivative is not stated.
#[inline]
pub fn external<R: Real, const N: usize>(
    arguments: [R; N],
    value: Option<&External<N>>,
    slopes: [Option<&External<N>>; N],
) -> R {
    let of = |function: Option<&External<N>>, lane: usize, x: [f64; N]| match function.and_then(|lanes| lanes.get(lane))
    {
        Some(function) => function(x),
        None => f64::NAN,
    };
    R::lane_by_lane(arguments, |lane, x| of(value, lane, x), |lane, x| slopes.map(|slope| of(slope, lane, x)))
}
