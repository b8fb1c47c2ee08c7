//! Members of an ensemble, each on polynomials of its own.

use super::{Recurrences, Taylor};
use crate::trajectory::in_lanes::InLanes;

impl<H: Recurrences> InLanes<H> for Taylor {}
