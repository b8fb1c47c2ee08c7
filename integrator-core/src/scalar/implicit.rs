//! Maps that are solved for: their derivatives follow from the solution, and do not go through the way to it.

use crate::scalar::real::Real;

/// A map of positions and momenta with some constants. Values are found in numbers of any kind, derivatives from what these found.
pub trait Implicit<const D: usize, const C: usize> {
    /// The solution found on the way to an image.
    type Solution<F: Real>;
    /// The quantities that the derivatives are computed from.
    type Slopes<F: Real>;

    /// The image of a point, the lanes in which there is none, and what was found on the way; implementations are `inline(always)`.
    fn solve<F: Real>(point: [[F; D]; 2], constants: [F; C]) -> (Image<F, D>, Self::Solution<F>);

    /// Returns the quantities that the derivatives in all directions share; implementations are `inline(always)`.
    fn slopes<F: Real>(point: [[F; D]; 2], constants: [F; C], solution: Self::Solution<F>) -> Self::Slopes<F>;

    /// The derivative of the image along a direction, in which constants may change, too; implementations are `inline(always)`.
    fn slope<F: Real>(at: &Self::Slopes<F>, point: [[F; D]; 2], constants: [F; C]) -> [[F; D]; 2];
}

/// The image of a point, and the lanes in which there is none.
pub struct Image<F: Real, const D: usize> {
    /// Positions and momenta.
    pub point: [[F; D]; 2],
    /// The lanes in which there is no image.
    pub failed: F::Mask,
}

impl<F: Real, const D: usize> Image<F, D> {
    /// The image in other numbers, whose mask is the same.
    #[inline(always)]
    pub(crate) fn with<G: Real<Mask = F::Mask>>(self, point: [[G; D]; 2]) -> Image<G, D> {
        Image { point, failed: self.failed }
    }
}
