//! Members of an ensemble in SIMD lanes.

use super::{GaussLegendre4, GaussLegendre6, ImplicitMidpoint};
use crate::{
    ensemble::in_lanes::{InLanes, ResumableInLanes},
    hamiltonian::Hamiltonian,
};

impl<H: Hamiltonian> InLanes<H> for ImplicitMidpoint {}
impl<H: Hamiltonian> InLanes<H> for GaussLegendre4 {}
impl<H: Hamiltonian> InLanes<H> for GaussLegendre6 {}

impl<H: Hamiltonian> ResumableInLanes<H> for ImplicitMidpoint {}
impl<H: Hamiltonian> ResumableInLanes<H> for GaussLegendre4 {}
impl<H: Hamiltonian> ResumableInLanes<H> for GaussLegendre6 {}
