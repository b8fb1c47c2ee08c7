//! The bits of vectors, one text for all, from a table of instructions.

/// Gives a vector the operations that kernels of elementary functions need.
macro_rules! bits {
    (
        $vector:ident of $scalar:ident, words of $word:ident, masked by $mask:ident;
        to integers $integers:ident, back $back:ident, and $and:ident, xor $xor:ident,
        add $add:ident, left $left:ident, right $right:ident, splat $splat:ident,
        odd |$x:ident| $odd:expr
    ) => {
        impl crate::scalar::functions::Bits for $vector {
            type Scalar = $scalar;

            const FUSED: bool = true;

            #[inline(always)]
            fn pattern(bits: u64) -> Self {
                Self(instruction!($splat($scalar::from_bits(bits as $word))))
            }
            #[inline(always)]
            fn bits_and(self, other: Self) -> Self {
                Self(instruction!($and(self.0, other.0)))
            }
            #[inline(always)]
            fn bits_xor(self, other: Self) -> Self {
                Self(instruction!($xor(self.0, other.0)))
            }
            #[inline(always)]
            fn bits_add(self, other: Self) -> Self {
                Self(instruction!($back($add($integers(self.0), $integers(other.0)))))
            }
            #[inline(always)]
            fn bits_right(self, by: u32) -> Self {
                let by = instruction!(core::arch::x86_64::_mm_cvtsi32_si128(by.cast_signed()));
                Self(instruction!($back($right($integers(self.0), by))))
            }
            #[inline(always)]
            fn bits_left(self, by: u32) -> Self {
                let by = instruction!(core::arch::x86_64::_mm_cvtsi32_si128(by.cast_signed()));
                Self(instruction!($back($left($integers(self.0), by))))
            }
            #[inline(always)]
            fn is_odd(self) -> $mask {
                let $x = instruction!($integers(self.0));
                $mask(instruction!($odd))
            }
            #[inline(always)]
            fn zip_scalars(self, other: Self, each: impl Fn(&mut [$scalar], &[$scalar])) -> Self {
                let mut lanes = self.lanes();
                each(&mut lanes, &other.lanes());
                Self::of_lanes(lanes)
            }
        }
    };
}
pub(super) use bits;
