//! What measurements are held against: exact derivatives, and motions found by other ways.

pub(crate) mod compensated;
pub(crate) mod edges;
pub(crate) mod exact;
pub(crate) mod march;
pub(crate) mod reference;
pub(crate) mod series;
pub(crate) mod tangent;
