//! How much is measured.

/// How much is measured: all of it on a page, less in tests.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// Periods of the portraits and of the energies.
    pub periods: f64,
    /// Points on the outline of the blob; even.
    pub outline: usize,
    /// Step sizes of the errors, each half of the one before; the first is an eighth of a period.
    pub rungs: u32,
    /// Step sizes between long and short ones for which the largest change of the energy is measured.
    pub limits: u32,
}

impl Plan {
    /// All of it.
    pub const WHOLE: Self = Self { periods: 20.0, outline: 256, rungs: 12, limits: 60 };
    /// Enough for claims to hold and for pictures to show what they show.
    pub const SMALL: Self = Self { periods: 6.0, outline: 64, rungs: 5, limits: 4 };
}
