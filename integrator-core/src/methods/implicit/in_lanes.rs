//! Members of an ensemble in SIMD lanes.

use super::{gauss_legendre::GaussLegendre, rated::RatedField, tableau::Stages};
use crate::{
    methods::pace::Paced,
    system::System,
    trajectory::in_lanes::{InLanes, ResumableInLanes},
};

impl<H: System, const S: usize> InLanes<H> for GaussLegendre<S> where Self: Stages<S> {}
impl<H: System, const S: usize> ResumableInLanes<H> for GaussLegendre<S> where Self: Stages<S> {}
impl<H: RatedField, const S: usize> InLanes<H> for Paced<GaussLegendre<S>> where GaussLegendre<S>: Stages<S> {}
