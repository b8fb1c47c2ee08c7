//! Statistics of measured numbers: slopes, trends, distances.

pub(crate) mod least_squares;
pub(crate) mod path;
pub(crate) mod points;
pub(crate) mod quadrature;
pub(crate) mod spectrum;
pub(crate) mod trend;

/// The golden section. Its multiples fall evenly into (0, 1) and share no period with anything.
pub(crate) const GOLDEN: f64 = 0.618_033_988_749_894_9;
