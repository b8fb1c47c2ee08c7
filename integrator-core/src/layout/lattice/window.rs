//! The stencil window: the coordinates around a site of a lattice, or around as many sites as a block holds. The
//! lattice is a line of sites, a plane of rows of them, or a volume of planes.

use crate::scalar::{
    real::{Mask, Real},
    simd::block::{Block, WIDEST},
};
use core::{marker::PhantomData, ops::Range};

/// The largest radius of a stencil, in sites.
pub(crate) const MAX_RADIUS: usize = 2;

/// The number of rows that are adjacent to a row: two in its plane, and two in the planes around.
pub(crate) const ADJACENT: usize = 4;

/// The blocks of a window before, at and after the position; those that the stencil does not read hold no coordinates.
pub(crate) type Blocks<W> = [W; 2 * MAX_RADIUS + 1];

/// The position of a row in its lattice.
#[derive(Clone, Copy)]
pub(crate) struct RowPosition {
    /// The number of sites in the line or in a row.
    pub(crate) length: usize,
    /// The index of the row.
    pub(crate) row: usize,
    /// The number of rows, of a plane where there are several.
    pub(crate) rows: usize,
    /// The index of the row's plane, and the number of planes.
    pub(crate) plane: [usize; 2],
}

/// The coordinates around a block of sites, and the position of the block in the lattice.
pub struct Window<R: Real, W: Block<R>> {
    pub(crate) blocks: Blocks<W>,
    /// The blocks of the adjacent rows: those above and below, and the same row of the previous and the next plane.
    pub(crate) adjacent: [Blocks<W>; ADJACENT],
    /// The index of the block's first site.
    pub(crate) site: usize,
    pub(crate) row: RowPosition,
    /// Whether some site of the block may differ from those of the lattice's interior.
    pub(crate) at_boundary: bool,
    pub(crate) scalar: PhantomData<R>,
}

impl<R: Real, W: Block<R>> Window<R, W> {
    /// The number of sites in the line or in a row.
    #[inline(always)]
    pub fn length(&self) -> usize {
        self.row.length
    }

    /// The number of rows, of a plane where there are several.
    #[inline(always)]
    pub fn rows(&self) -> usize {
        self.row.rows
    }

    /// The number of planes.
    #[inline(always)]
    pub fn planes(&self) -> usize {
        self.row.plane[1]
    }

    /// The coordinates at an offset, before the sites if it is negative.
    #[inline(always)]
    pub fn at(&self, offset: isize) -> W {
        Self::shifted(self.blocks, offset)
    }

    /// The coordinates in the row above.
    #[inline(always)]
    pub fn above(&self, offset: isize) -> W {
        Self::shifted(self.adjacent[0], offset)
    }

    /// The coordinates in the row below.
    #[inline(always)]
    pub fn below(&self, offset: isize) -> W {
        Self::shifted(self.adjacent[1], offset)
    }

    /// The coordinates in the same row of the previous plane.
    #[inline(always)]
    pub fn previous_plane(&self, offset: isize) -> W {
        Self::shifted(self.adjacent[2], offset)
    }

    /// The coordinates in the same row of the next plane.
    #[inline(always)]
    pub fn next_plane(&self, offset: isize) -> W {
        Self::shifted(self.adjacent[3], offset)
    }

    #[inline(always)]
    fn shifted(blocks: Blocks<W>, offset: isize) -> W {
        let [before_last, previous, here, next, after_next] = blocks;
        match (offset, W::WIDTH) {
            (0, _) => here,
            (1, _) => here.after(next),
            (-1, _) => here.before(previous),
            (2, 1) => after_next,
            (-2, 1) => before_last,
            (2, _) => here.after(next).after(next.after(next)),
            _ => here.before(previous).before(previous.before(previous)),
        }
    }

    /// The elements of a table over sites, at an offset from the block's; zero where it has none.
    #[inline(always)]
    pub fn table(&self, table: &[R], offset: isize) -> W {
        let first = self.site as isize + offset;
        if !self.at_boundary {
            return W::read(&table[first as usize..]);
        }
        let mut elements = [R::of(0.0); WIDEST];
        for (lane, element) in elements[..W::WIDTH].iter_mut().enumerate() {
            let at = (first + lane as isize).rem_euclid(self.row.length as isize) as usize;
            if at < table.len() {
                *element = table[at];
            }
        }
        W::read(&elements)
    }

    /// The element of a table over rows, `down` rows below the block's; zero where it has none.
    #[inline(always)]
    pub fn table_over_rows(&self, table: &[R], down: isize) -> W {
        W::splat(self.of_row(table, down).copied().unwrap_or(R::of(0.0)))
    }

    /// The elements of a table over rows and sites, `down` rows below the block's and at an offset from its sites; zero
    /// where it has none.
    #[inline(always)]
    pub fn table_of_rows(&self, table: &[impl AsRef<[R]>], down: isize, offset: isize) -> W {
        self.of_row(table, down).map_or(W::of(0.0), |row| self.table(row.as_ref(), offset))
    }

    /// The element of a table over planes, at an offset from the plane of the block; zero if the table has none.
    #[inline(always)]
    pub fn table_over_planes(&self, table: &[R], behind: isize) -> W {
        W::splat(self.of_plane(table, behind).copied().unwrap_or(R::of(0.0)))
    }

    /// The elements of a table over planes, rows and sites, at offsets from the plane, row and sites of the block; zero
    /// if the table has none.
    #[inline(always)]
    pub fn table_of_planes<Rows: AsRef<[R]>>(
        &self,
        table: &[impl AsRef<[Rows]>],
        [behind, down]: [isize; 2],
        offset: isize,
    ) -> W {
        self.of_plane(table, behind).map_or(W::of(0.0), |plane| self.table_of_rows(plane.as_ref(), down, offset))
    }

    #[inline(always)]
    fn of_row<'t, T>(&self, table: &'t [T], down: isize) -> Option<&'t T> {
        table.get((self.row.row as isize + down).rem_euclid(self.row.rows as isize) as usize)
    }

    #[inline(always)]
    fn of_plane<'t, T>(&self, table: &'t [T], behind: isize) -> Option<&'t T> {
        let [plane, planes] = self.row.plane;
        table.get((plane as isize + behind).rem_euclid(planes as isize) as usize)
    }

    /// A value at the sites of a range, zero at others.
    #[inline(always)]
    pub fn masked(&self, sites: Range<usize>, value: W) -> W {
        if self.at_boundary { W::select(self.mask(sites), value, W::of(0.0)) } else { value }
    }

    /// A sum, to which a value is added at the few sites of a range near an end of the lattice.
    #[inline(always)]
    pub fn masked_add(&self, sites: Range<usize>, sum: W, value: W) -> W {
        let overlaps = sites.start < self.site + W::WIDTH && self.site < sites.end;
        if self.at_boundary && overlaps { W::select(self.mask(sites), sum + value, sum) } else { sum }
    }

    /// A value in the rows of a range, zero in others.
    #[inline(always)]
    pub fn row_masked(&self, rows: Range<usize>, value: W) -> W {
        if self.at_boundary && !rows.contains(&self.row.row) { W::of(0.0) } else { value }
    }

    /// A sum, to which a value is added in the few rows of a range near an end of the plane.
    #[inline(always)]
    pub fn row_masked_add(&self, rows: Range<usize>, sum: W, value: W) -> W {
        if self.at_boundary && rows.contains(&self.row.row) { sum + value } else { sum }
    }

    /// A value in the planes of a range, zero in others.
    #[inline(always)]
    pub fn plane_masked(&self, planes: Range<usize>, value: W) -> W {
        if self.at_boundary && !planes.contains(&self.row.plane[0]) { W::of(0.0) } else { value }
    }

    /// A sum, to which a value is added in the few planes of a range near an end of the volume.
    #[inline(always)]
    pub fn plane_masked_add(&self, planes: Range<usize>, sum: W, value: W) -> W {
        if self.at_boundary && planes.contains(&self.row.plane[0]) { sum + value } else { sum }
    }

    /// The mask of the block's sites that lie in a range.
    #[inline(always)]
    fn mask(&self, sites: Range<usize>) -> W::Mask {
        if W::WIDTH == 1 {
            return W::Mask::of(sites.contains(&self.site));
        }
        let mut lanes = [R::of(0.0); WIDEST];
        for (lane, number) in lanes.iter_mut().enumerate() {
            *number = R::of(lane as f64);
        }
        let lane = W::read(&lanes);
        let from = W::of(sites.start as f64 - self.site as f64);
        let to = W::of(sites.end as f64 - self.site as f64);
        from.less_or_equal(lane).and(lane.less(to))
    }
}
