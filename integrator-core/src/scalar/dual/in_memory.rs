//! Numbers with derivatives as they are in memory: each value, followed by its derivatives.

use super::Dual;
use core::slice;

impl<F, const N: usize, const SENSITIVE: bool> Dual<F, N, false, SENSITIVE> {
    /// Whether there is nothing between the numbers.
    const IS_DENSE: bool = size_of::<Self>() == (N + 1) * size_of::<F>() && align_of::<Self>() == align_of::<F>();

    /// Values and derivatives, one after the other. Copied one by one, they are written as vectors and read in pieces of these,
    /// which waits until they have arrived in memory.
    #[allow(unsafe_code, reason = "there is no safe view of a slice of structs as one of their fields")]
    #[inline(always)]
    pub(super) fn in_memory(duals: &[Self]) -> &[F] {
        const { assert!(Self::IS_DENSE) };
        // SAFETY: A `Dual` is `repr(C)` and has fields of type `F` alone, N + 1 of them without padding, as asserted; the slice
        // is borrowed for as long as what is returned.
        unsafe { slice::from_raw_parts(duals.as_ptr().cast(), (N + 1) * duals.len()) }
    }

    /// Values and derivatives, one after the other, as a mutable slice.
    #[allow(unsafe_code, reason = "there is no safe view of a slice of structs as one of their fields")]
    #[inline(always)]
    pub(super) fn in_memory_mut(duals: &mut [Self]) -> &mut [F] {
        const { assert!(Self::IS_DENSE) };
        // SAFETY: As above, and borrowed mutably; any `F` is a value of a field.
        unsafe { slice::from_raw_parts_mut(duals.as_mut_ptr().cast(), (N + 1) * duals.len()) }
    }
}
