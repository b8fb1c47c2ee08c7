//! The number of coordinates that a start must have.

use crate::error::Error;

/// Checks that a start has all coordinates that the functions of the system read by number.
///
/// # Errors
/// [`Error::FewCoordinates`]
pub fn are_at_least(least: usize, length: usize) -> Result<(), Error> {
    match length < least {
        true => Err(Error::FewCoordinates { least, length }),
        false => Ok(()),
    }
}

/// Checks that flat coordinates are points with this number of components each, and as many as the functions of the system read.
///
/// # Errors
/// [`Error::PartialPoint`], [`Error::FewCoordinates`]
pub fn are_points(components: usize, least: usize, length: usize) -> Result<(), Error> {
    match length % components {
        0 => are_at_least(least, length),
        _ => Err(Error::PartialPoint { components, length }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_start_without_a_coordinate_that_is_read_is_refused() {
        assert_eq!(are_at_least(4, 3), Err(Error::FewCoordinates { least: 4, length: 3 }));
        assert_eq!(are_at_least(4, 4), Ok(()));
    }

    #[test]
    fn flat_coordinates_are_whole_points() {
        assert_eq!(are_points(3, 6, 7), Err(Error::PartialPoint { components: 3, length: 7 }));
        assert_eq!(are_points(3, 9, 6), Err(Error::FewCoordinates { least: 9, length: 6 }));
        assert_eq!(are_points(3, 6, 9), Ok(()));
    }
}
