//! Time transformations of the members of an ensemble, each lane with its own time.

use super::{Logarithmic, Paced, Power, Rated, TimeTransformed};
use crate::{
    composition::{Composition, Scheme},
    trajectory::in_lanes::InLanes,
};

impl<H: TimeTransformed, X: Composition<H>> InLanes<H> for Logarithmic<X> {}
impl<H: TimeTransformed, X: Composition<H>> InLanes<H> for Power<X> {}
impl<H: Rated, X: Composition<H> + Scheme> InLanes<H> for Paced<X> {}
