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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_start_without_a_coordinate_that_is_read_is_refused() {
        assert_eq!(are_at_least(4, 3), Err(Error::FewCoordinates { least: 4, length: 3 }));
        assert_eq!(are_at_least(4, 4), Ok(()));
    }
}
