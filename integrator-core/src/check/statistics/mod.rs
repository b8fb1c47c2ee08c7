//! Statistics of measured numbers: slopes, trends, distances.

pub(crate) mod least_squares;
pub(crate) mod path;
pub(crate) mod points;
pub(crate) mod quadrature;
pub(crate) mod spectrum;
pub(crate) mod trend;
