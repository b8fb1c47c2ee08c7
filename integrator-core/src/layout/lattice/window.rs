//! What is around a site of a lattice, as a flow sees it: one site, or as many side by side as a block holds. The lattice
//! is a line of sites, or a plane of rows of them.

use crate::scalar::{
    real::{Mask, Real},
    simd::block::{Block, WIDEST},
};
use core::{marker::PhantomData, ops::Range};

/// How far ahead of a site or behind it a flow may look.
pub(crate) const FARTHEST: usize = 2;

/// The blocks behind, here and ahead, as many of them as are looked at.
pub(crate) type Around<W> = [W; 2 * FARTHEST + 1];

/// The coordinates around a block of sites, and where the block lies.
pub struct Neighbours<R: Real, W: Block<R>> {
    pub(crate) around: Around<W>,
    /// The same in the rows above and below.
    pub(crate) beside: [Around<W>; 2],
    /// The first site of the block.
    pub(crate) site: usize,
    /// How many sites there are in the line or in a row.
    pub(crate) length: usize,
    /// The row of the block.
    pub(crate) row: usize,
    /// How many rows there are.
    pub(crate) rows: usize,
    /// Whether something is different at some site of the block from what it is in the middle of the lattice.
    pub(crate) edge: bool,
    pub(crate) scalar: PhantomData<R>,
}

impl<R: Real, W: Block<R>> Neighbours<R, W> {
    /// How many sites there are in the line or in a row.
    #[inline(always)]
    pub fn length(&self) -> usize {
        self.length
    }

    /// How many rows there are.
    #[inline(always)]
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The coordinates `ahead` places further on, behind if that is negative.
    #[inline(always)]
    pub fn at(&self, ahead: isize) -> W {
        Self::ahead(self.around, ahead)
    }

    /// The coordinates in the row above.
    #[inline(always)]
    pub fn above(&self, ahead: isize) -> W {
        Self::ahead(self.beside[0], ahead)
    }

    /// The coordinates in the row below.
    #[inline(always)]
    pub fn below(&self, ahead: isize) -> W {
        Self::ahead(self.beside[1], ahead)
    }

    #[inline(always)]
    fn ahead(around: Around<W>, ahead: isize) -> W {
        let [before_last, previous, here, next, after_next] = around;
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
        let mut elements = [R::of(0.0); WIDEST];
        for (place, element) in elements[..W::WIDTH].iter_mut().enumerate() {
            let at = (first + place as isize).rem_euclid(self.length as isize) as usize;
            if at < table.len() {
                *element = table[at];
            }
        }
        W::read(&elements)
    }

    /// The element of a table over rows, `down` rows further on; zero where it has none.
    #[inline(always)]
    pub fn table_over_rows(&self, table: &[R], down: isize) -> W {
        W::splat(self.of_row(table, down).copied().unwrap_or(R::of(0.0)))
    }

    /// The elements of a table of rows, `down` rows and `ahead` places further on; zero where it has none.
    #[inline(always)]
    pub fn table_of_rows(&self, table: &[impl AsRef<[R]>], down: isize, ahead: isize) -> W {
        self.of_row(table, down).map_or(W::of(0.0), |row| self.table(row.as_ref(), ahead))
    }

    #[inline(always)]
    fn of_row<'t, T>(&self, table: &'t [T], down: isize) -> Option<&'t T> {
        table.get((self.row as isize + down).rem_euclid(self.rows as isize) as usize)
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

    /// A value in the rows of a range, zero in others.
    #[inline(always)]
    pub fn within_rows(&self, rows: Range<usize>, value: W) -> W {
        if self.edge && !rows.contains(&self.row) { W::of(0.0) } else { value }
    }

    /// A sum, with a value added to it in the few rows of a range near an end of the plane.
    #[inline(always)]
    pub fn plus_in_rows(&self, rows: Range<usize>, sum: W, value: W) -> W {
        if self.edge && rows.contains(&self.row) { sum + value } else { sum }
    }

    /// Which of the block's sites lie in a range.
    #[inline(always)]
    fn mask(&self, sites: Range<usize>) -> W::Mask {
        if W::WIDTH == 1 {
            return W::Mask::of(sites.contains(&self.site));
        }
        let mut places = [R::of(0.0); WIDEST];
        for (place, number) in places.iter_mut().enumerate() {
            *number = R::of(place as f64);
        }
        let place = W::read(&places);
        let from = W::of(sites.start as f64 - self.site as f64);
        let to = W::of(sites.end as f64 - self.site as f64);
        from.less_or_equal(place).and(place.less(to))
    }
}
