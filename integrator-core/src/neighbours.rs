//! What is around a site of a lattice, as a flow sees it: one site, or as many side by side as a block holds.

use crate::{
    block::Block,
    real::{Mask, Real},
};
use core::{marker::PhantomData, ops::Range};

/// How far ahead of a site or behind it a flow may look.
pub(crate) const FARTHEST: usize = 2;

/// The coordinates around a block of sites, and where the block lies.
pub struct Neighbours<R: Real, W: Block<R>> {
    /// The blocks behind, here and ahead, as many of them as are looked at.
    pub(crate) around: [W; 2 * FARTHEST + 1],
    /// The first site of the block.
    pub(crate) site: usize,
    /// How many sites there are.
    pub(crate) length: usize,
    /// Whether something is different at some site of the block from what it is in the middle of the lattice.
    pub(crate) edge: bool,
    pub(crate) scalar: PhantomData<R>,
}

impl<R: Real, W: Block<R>> Neighbours<R, W> {
    /// How many sites there are.
    #[inline(always)]
    pub fn length(&self) -> usize {
        self.length
    }

    /// The coordinates `ahead` places further on, behind if that is negative.
    #[inline(always)]
    pub fn at(&self, ahead: isize) -> W {
        let [before_last, previous, here, next, after_next] = self.around;
        match (ahead, W::WIDTH) {
            (0, _) => here,
            (1, _) => here.after(next),
            (-1, _) => here.before(previous),
            (2, 1) => after_next,
            (-2, 1) => before_last,
            (2, _) => here.after(next).after(next.after(next)),
            _ => here.before(previous).before(previous.before(previous)),
        }
    }

    /// The elements of a table, `ahead` places further on than the sites; zero where it has none.
    #[inline(always)]
    pub fn table(&self, table: &[R], ahead: isize) -> W {
        let first = self.site as isize + ahead;
        if !self.edge {
            return W::read(&table[first as usize..]);
        }
        W::from_places(|place| {
            let element = (first + place as isize).rem_euclid(self.length as isize);
            table.get(element as usize).copied().unwrap_or(R::of(0.0))
        })
    }

    /// A value at the sites of a range, zero at others.
    #[inline(always)]
    pub fn within(&self, sites: Range<usize>, value: W) -> W {
        if self.edge { W::select(self.mask(sites), value, W::of(0.0)) } else { value }
    }

    /// A sum, with a value added to it at the few sites of a range near an end of the lattice.
    #[inline(always)]
    pub fn plus(&self, sites: Range<usize>, sum: W, value: W) -> W {
        let meets = sites.start < self.site + W::WIDTH && self.site < sites.end;
        if self.edge && meets { W::select(self.mask(sites), sum + value, sum) } else { sum }
    }

    /// Which of the block's sites lie in a range.
    #[inline(always)]
    fn mask(&self, sites: Range<usize>) -> W::Mask {
        if W::WIDTH == 1 {
            return W::Mask::of(sites.contains(&self.site));
        }
        let place = W::from_places(|place| R::of(place as f64));
        let [from, to] = [sites.start, sites.end].map(|end| W::of(end as f64 - self.site as f64));
        from.less_or_equal(place).and(place.less(to))
    }
}
