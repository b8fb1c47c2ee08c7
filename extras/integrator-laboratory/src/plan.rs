//! The amount of measurements.

/// The amount of measurements: large for a page, small for tests.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// The number of periods of the portraits and of the energies.
    pub periods: f64,
    /// The number of points on the outline of the set of starts; even.
    pub outline: usize,
    /// The number of step sizes of the errors. The first is about an eighth of a period, and each is half of the previous
    /// one.
    pub rungs: u32,
    /// The number of step sizes for which the largest energy change is measured.
    pub limits: u32,
}

impl Plan {
    /// All measurements.
    pub const WHOLE: Self = Self { periods: 20.0, outline: 256, rungs: 12, limits: 60 };
    /// The measurements that are enough for claims to hold and for pictures to show their result.
    pub const SMALL: Self = Self { periods: 6.0, outline: 64, rungs: 5, limits: 4 };
}
