//! Members of an ensemble in SIMD lanes.

use super::{GaussLegendre4, GaussLegendre6, ImplicitMidpoint};
use crate::{
    ensemble::in_lanes::{InLanes, ResumableInLanes},
    system::System,
};

impl<H: System> InLanes<H> for ImplicitMidpoint {}
impl<H: System> InLanes<H> for GaussLegendre4 {}
impl<H: System> InLanes<H> for GaussLegendre6 {}

impl<H: System> ResumableInLanes<H> for ImplicitMidpoint {}
impl<H: System> ResumableInLanes<H> for GaussLegendre4 {}
impl<H: System> ResumableInLanes<H> for GaussLegendre6 {}
