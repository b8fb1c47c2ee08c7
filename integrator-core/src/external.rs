//! Methods of the user that generated code calls as they are: tables, splines, anything with a stated derivative.

use crate::real::Real;
use alloc::{sync::Arc, vec::Vec};

/// A function of one number, one per lane.
pub type External = Vec<Arc<dyn Fn(f64) -> f64 + Send + Sync>>;

/// A function of two numbers, one per lane.
pub type ExternalTwo = Vec<Arc<dyn Fn(f64, f64) -> f64 + Send + Sync>>;

/// The value of a function of one number in every lane; `None` where its derivative is not stated.
#[inline]
pub fn external<R: Real>(x: R, value: Option<&External>, slope: Option<&External>) -> R {
    let of = |function: Option<&External>, lane: usize, x: f64| match function.and_then(|lanes| lanes.get(lane)) {
        Some(function) => function(x),
        None => f64::NAN,
    };
    x.lane_by_lane(x, |lane, x, _| of(value, lane, x), |lane, x, _| [of(slope, lane, x), 0.0])
}

/// The value of a function of two numbers in every lane; `None` where a derivative is not stated.
#[inline]
pub fn external_two<R: Real>(x: R, y: R, value: Option<&ExternalTwo>, slopes: [Option<&ExternalTwo>; 2]) -> R {
    let of = |function: Option<&ExternalTwo>, lane: usize, x: f64, y: f64| match function
        .and_then(|lanes| lanes.get(lane))
    {
        Some(function) => function(x, y),
        None => f64::NAN,
    };
    x.lane_by_lane(y, |lane, x, y| of(value, lane, x, y), |lane, x, y| slopes.map(|slope| of(slope, lane, x, y)))
}
