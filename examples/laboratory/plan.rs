//! How much is measured.

/// How much is measured: all of it on the page, less in tests.
pub(crate) struct Plan {
    /// Periods of the portraits and of the energies.
    pub(crate) periods: f64,
    /// Points on the outline of the blob; even.
    pub(crate) outline: usize,
    /// Step sizes of the errors, each half of the one before; the first is an eighth of a period.
    pub(crate) rungs: u32,
    /// Crossings of each orbit of the Poincaré section.
    pub(crate) crossings: usize,
}

impl Plan {
    pub(crate) const WHOLE: Self = Self { periods: 20.0, outline: 256, rungs: 12, crossings: 1200 };
}
