//! What measured numbers say: slopes, trends, distances.

pub(crate) mod course;
pub(crate) mod line;
pub(crate) mod path;
pub(crate) mod points;
pub(crate) mod spectrum;
