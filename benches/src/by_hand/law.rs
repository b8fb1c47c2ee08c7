//! Potentials of the bonds and of the sites of a chain.

use crate::{functions, vector::Vector};

/// Potential energy of a chain. Bonds are functions of `s = q[i + 1] - q[i]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// `s²/2 + α s³/3`
    Fput {
        /// Nonlinear coefficient.
        alpha: f64,
    },
    /// `exp(s) - s`
    Toda,
    /// `κ s²/2`, and `1 - cos q` on each site
    SineGordon {
        /// Stiffness of the bonds.
        stiffness: f64,
    },
    /// `κ s²/2`, and `(q² - 1)²/4` on each site
    Phi4 {
        /// Stiffness of the bonds.
        stiffness: f64,
    },
}

/// The derivatives of the energies of a bond and of a site.
pub(crate) trait Forces: Copy {
    fn bond<V: Vector<Number = f64>>(self, stretch: V) -> V;
    /// Returns `None` if the sites have no potential.
    fn site<V: Vector<Number = f64>>(self, q: V) -> Option<V>;
    /// The same with functions of the standard library.
    fn plain(self, stretch: f64) -> f64;
    fn plain_site(self, q: f64) -> f64;
}

#[derive(Clone, Copy)]
pub(crate) struct Fput(pub(crate) f64);
#[derive(Clone, Copy)]
pub(crate) struct Toda;
#[derive(Clone, Copy)]
pub(crate) struct SineGordon(pub(crate) f64);
#[derive(Clone, Copy)]
pub(crate) struct Phi4(pub(crate) f64);

impl Forces for Fput {
    #[inline(always)]
    fn bond<V: Vector<Number = f64>>(self, stretch: V) -> V {
        (V::splat(self.0) * stretch).fma(stretch, stretch)
    }
    #[inline(always)]
    fn site<V: Vector<Number = f64>>(self, _: V) -> Option<V> {
        None
    }
    #[inline(always)]
    fn plain(self, stretch: f64) -> f64 {
        (self.0 * stretch).mul_add(stretch, stretch)
    }
    #[inline(always)]
    fn plain_site(self, _: f64) -> f64 {
        0.0
    }
}

impl Forces for Toda {
    #[inline(always)]
    fn bond<V: Vector<Number = f64>>(self, stretch: V) -> V {
        functions::exponential(stretch) - V::splat(1.0)
    }
    #[inline(always)]
    fn site<V: Vector<Number = f64>>(self, _: V) -> Option<V> {
        None
    }
    #[inline(always)]
    fn plain(self, stretch: f64) -> f64 {
        stretch.exp() - 1.0
    }
    #[inline(always)]
    fn plain_site(self, _: f64) -> f64 {
        0.0
    }
}

impl Forces for SineGordon {
    #[inline(always)]
    fn bond<V: Vector<Number = f64>>(self, stretch: V) -> V {
        V::splat(self.0) * stretch
    }
    #[inline(always)]
    fn site<V: Vector<Number = f64>>(self, q: V) -> Option<V> {
        Some(functions::sine(q))
    }
    #[inline(always)]
    fn plain(self, stretch: f64) -> f64 {
        self.0 * stretch
    }
    #[inline(always)]
    fn plain_site(self, q: f64) -> f64 {
        q.sin()
    }
}

impl Forces for Phi4 {
    #[inline(always)]
    fn bond<V: Vector<Number = f64>>(self, stretch: V) -> V {
        V::splat(self.0) * stretch
    }
    #[inline(always)]
    fn site<V: Vector<Number = f64>>(self, q: V) -> Option<V> {
        Some((q * q - V::splat(1.0)) * q)
    }
    #[inline(always)]
    fn plain(self, stretch: f64) -> f64 {
        self.0 * stretch
    }
    #[inline(always)]
    fn plain_site(self, q: f64) -> f64 {
        (q * q - 1.0) * q
    }
}
