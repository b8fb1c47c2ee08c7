//! Members of an ensemble side by side.

use super::{GaussLegendre4, GaussLegendre6, ImplicitMidpoint};
use crate::{ensemble::in_lanes::InLanes, hamiltonian::Hamiltonian};

impl<H: Hamiltonian> InLanes<H> for ImplicitMidpoint {}
impl<H: Hamiltonian> InLanes<H> for GaussLegendre4 {}
impl<H: Hamiltonian> InLanes<H> for GaussLegendre6 {}
