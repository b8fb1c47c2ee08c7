//! Flows of lattices in gather form: a site gets all its addends at once, and each of them is computed once.
//!
//! At every site something is computed from its neighbourhood, the bond to the next one for instance, and shared out
//! among the site and the next ones. A sweep carries shares along with it, so that no buffer is filled and no bond
//! computed twice; in a plane it goes along a row, and what the row shares with the next one is passed on to that. The
//! order of the addends of a site is that of the shares, whatever the width of a block is and wherever a sweep begins: so
//! are the bits.

use crate::{
    hamiltonian::Hamiltonian,
    layout::lattice::window::{Around, FARTHEST, Neighbours},
    scalar::{
        real::Real,
        simd::block::{Block, WIDEST},
    },
    state::precision::Slot,
};
use core::{marker::PhantomData, ops::Range};

/// The flow of `T`, as a parameter of [`Gather`].
pub struct Drift;

/// The flow of `V`, as a parameter of [`Gather`].
pub struct Kick;

/// Where a lattice ends, and how far its sites look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edges {
    /// How many sites at the beginning compute something of their own.
    pub first: usize,
    /// How many sites at the end do.
    pub last: usize,
    /// How many places further on the farthest share goes.
    pub onward: usize,
    /// How far behind a site's shares depend on coordinates.
    pub behind: usize,
    /// How far ahead they do.
    pub ahead: usize,
    /// Whether the last site is followed by the first.
    pub periodic: bool,
}

impl Edges {
    /// Whether every site is like all others, and looks at itself alone.
    const fn none(&self) -> bool {
        self.first == 0 && self.last == 0 && self.onward == 0 && self.behind == 0 && self.ahead == 0
    }
}

/// A flow that every site takes part in alike. Written by `#[hamiltonian]`; `F` is [`Drift`] or [`Kick`].
pub trait Gather<F>: Hamiltonian {
    /// What is computed at a site: element `k` is an addend for the site `k` places further on. Behind the farthest of
    /// these come those for the next row, for the site below and further on.
    type Shares<W: Copy>: Array<W>;

    /// Where the sites are that are not like all others.
    const EDGES: Edges;

    /// Where the rows of a plane are that are not like all others.
    const ROWS: Option<Edges> = None;

    /// The shares of a block of sites.
    fn shares<R: Real, W: Block<R>>(
        near: &Neighbours<R, W>,
        parameters: &Self::Parameters<R>,
        time: f64,
    ) -> Self::Shares<W>;
}

/// A flow on its way over sites that it finds in slices, which may be windows of a longer lattice, or rows of a plane.
pub(crate) struct Sweep<'m, H: Hamiltonian, F, R: Real, S> {
    /// The coordinates that the flow depends on.
    pub(crate) read: &'m [S],
    /// Those that it moves.
    pub(crate) moved: &'m mut [S],
    /// The site that the slices begin with.
    pub(crate) first: usize,
    /// How many sites there are in the line or in a row.
    pub(crate) length: usize,
    /// What lies beside the sites.
    pub(crate) beside: Beside<'m, R, S>,
    pub(crate) parameters: &'m H::Parameters<R>,
    pub(crate) step: R,
    pub(crate) time: f64,
    pub(crate) flow: PhantomData<F>,
}

/// The other rows of a plane, as a sweep along one of them sees them.
pub(crate) struct Beside<'m, R, S> {
    /// The number of the row that is swept.
    pub(crate) row: usize,
    /// How many rows there are.
    pub(crate) rows: usize,
    /// Whether something is different in the row from what it is in the middle of the plane.
    pub(crate) edge: bool,
    /// What the flow depends on in the rows above and below; nothing beyond an end.
    pub(crate) read: [&'m [S]; 2],
    /// What the row above shares with this one, and after the sweep what this one shares with the row below.
    pub(crate) passed: &'m mut [R],
}

impl<R, S> Beside<'_, R, S> {
    /// Nothing is beside a line.
    #[inline(always)]
    pub(crate) fn line() -> Self {
        Self { row: 0, rows: 1, edge: false, read: [&[], &[]], passed: &mut [] }
    }
}

impl<H: Gather<F>, F, R: Real, S: Slot<R>> Sweep<'_, H, F, R, S> {
    /// Whether the rows above and below are looked at.
    pub(crate) const LOOKED_AT: [bool; 2] = match H::ROWS {
        Some(rows) => [rows.behind > 0, rows.ahead > 0],
        None => [false; 2],
    };

    /// Whether a row shares anything with the next one.
    pub(crate) const PASSES_ON: bool = matches!(H::ROWS, Some(Edges { onward: 1.., .. }));

    /// Whether sites have nothing to do with each other, as the momenta of a kinetic energy that is a sum of squares.
    const APART: bool = H::EDGES.none() && H::ROWS.is_none();

    /// Moves the coordinates of `sites`: whole blocks, then one by one the sites that fill none.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn over(mut self, sites: Range<usize>) {
        let rest = self.blocks::<S::Wide>(sites.clone());
        if const { S::Wide::WIDTH > 1 } && rest < sites.end {
            self.singles(rest..sites.end);
        }
    }

    /// Moves whole blocks of `sites`, and returns where they end.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn blocks<W: Block<R>>(&mut self, sites: Range<usize>) -> usize {
        let (mut site, end) = (sites.start, sites.end);
        if site + W::WIDTH > end {
            return site;
        }
        if const { Self::APART } {
            let blocks = (end - site) / W::WIDTH;
            self.middle::<W>(site, blocks, Self::nothing());
            return site + blocks * W::WIDTH;
        }
        let mut carried = self.carried::<W>(site);
        while site < H::EDGES.first && site + W::WIDTH <= end {
            carried = self.block(site, carried);
            site += W::WIDTH;
        }
        let alike = self.alike::<W>(site..end);
        if alike > 0 {
            carried = self.middle(site, alike, carried);
            site += alike * W::WIDTH;
        }
        while site + W::WIDTH <= end {
            carried = self.block(site, carried);
            site += W::WIDTH;
        }
        site
    }

    /// Moves sites one by one.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn singles(&mut self, sites: Range<usize>) {
        if const { Self::APART } {
            self.middle::<R>(sites.start, sites.len(), Self::nothing());
        } else {
            let mut carried = self.carried::<R>(sites.start);
            for site in sites {
                carried = self.block(site, carried);
            }
        }
    }

    /// How many blocks from the beginning of `sites` on have no site of the last ones, and all around them at hand.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn alike<W: Block<R>>(&self, sites: Range<usize>) -> usize {
        if self.beside.edge {
            return 0;
        }
        let [_, farthest] = Self::window::<W>();
        let at_hand = (self.first + self.read.len()).saturating_sub((farthest - FARTHEST) * W::WIDTH);
        let end = self.length.saturating_sub(H::EDGES.last).min(at_hand).min(sites.end);
        end.saturating_sub(sites.start) / W::WIDTH
    }

    /// Moves a block that may have sites unlike others; `carried` as below.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn block<W: Block<R>>(&mut self, site: usize, carried: [H::Shares<W>; FARTHEST]) -> [H::Shares<W>; FARTHEST] {
        let found = self.shares::<W>(site);
        let begin = site - self.first;
        let passed = if const { H::ROWS.is_some() } { &mut self.beside.passed[begin..] } else { &mut [] };
        S::update(&mut self.moved[begin..], self.step, Self::sum(found, carried, passed));
        [found, carried[0]]
    }

    /// Moves blocks that are alike; `carried` are the shares of the sites before them, nearest first. A window goes along,
    /// so that every coordinate is read once.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn middle<W: Block<R>>(
        &mut self,
        mut site: usize,
        blocks: usize,
        mut carried: [H::Shares<W>; FARTHEST],
    ) -> [H::Shares<W>; FARTHEST] {
        if const { H::ROWS.is_some() } {
            return self.middle_of_row(site, blocks, carried);
        }
        let [nearest, farthest] = Self::window::<W>();
        let begin = site - self.first;
        let mut around = [W::of(0.0); 2 * FARTHEST + 1];
        if const { !Self::APART } {
            around = self.around(self.read, site as isize - W::WIDTH as isize);
        }
        // Slices of one length, so that nothing is asked at a block.
        let sites = blocks * W::WIDTH;
        let mut read = &self.read[begin + (farthest - FARTHEST) * W::WIDTH..][..sites];
        let mut moved = &mut self.moved[begin..][..sites];
        while read.len() >= W::WIDTH && moved.len() >= W::WIDTH {
            for place in nearest..farthest {
                around[place] = around[place + 1];
            }
            around[farthest] = S::read(read);
            let (beside, length) = ([around; 2], self.length);
            let near = Neighbours { around, beside, site, length, row: 0, rows: 1, edge: false, scalar: PhantomData };
            let found = H::shares::<R, W>(&near, self.parameters, self.time);
            S::update(moved, self.step, Self::sum(found, carried, &mut []));
            carried = [found, carried[0]];
            site += W::WIDTH;
            read = &read[W::WIDTH..];
            moved = &mut moved[W::WIDTH..];
        }
        carried
    }

    /// What a block of sites gets; `carried` are the shares of the sites before it, nearest first. What the row above
    /// passed on is replaced by what is passed on to the row below.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn sum<W: Block<R>>(found: H::Shares<W>, carried: [H::Shares<W>; FARTHEST], passed: &mut [R]) -> W {
        let below = H::EDGES.onward + 1;
        let mut sum = Self::sum_of(0..below, found, carried);
        if const { Self::PASSES_ON } {
            sum += W::read(passed);
            Self::sum_of(below..found.as_ref().len(), found, carried).write(passed);
        }
        sum
    }

    /// The sum of those of the shares that a block of sites gets.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sum_of<W: Block<R>>(shares: Range<usize>, found: H::Shares<W>, carried: [H::Shares<W>; FARTHEST]) -> W {
        let mut sum = found.as_ref()[shares.start];
        for share in shares.start + 1..shares.end {
            let [nearest, farther] = carried;
            let carried = [nearest.as_ref()[share], farther.as_ref()[share]];
            sum += arriving::<R, W>(share - shares.start, found.as_ref()[share], carried);
        }
        sum
    }

    /// The shares of the sites before `site`, as if the sweep came from there.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn carried<W: Block<R>>(&self, site: usize) -> [H::Shares<W>; FARTHEST] {
        let mut carried = Self::nothing::<W>();
        for nearer in 0..H::EDGES.onward {
            let behind = H::EDGES.onward - nearer;
            let before = match site.checked_sub(behind) {
                None if H::EDGES.periodic => (site + FARTHEST * self.length - behind) % self.length,
                None => continue,
                Some(before) => before,
            };
            let found = self.shares::<R>(before);
            let [nearest, farther] = &mut carried;
            *farther = *nearest;
            for share in 1..found.as_ref().len() {
                let found = W::splat(found.as_ref()[share]);
                // In a block of one the farther share is a block of its own.
                let nearest = &mut nearest.as_mut()[share];
                *nearest = nearest.after(found);
            }
        }
        carried
    }

    /// Shares of nothing.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn nothing<W: Block<R>>() -> [H::Shares<W>; FARTHEST] {
        [H::Shares::<W>::filled(W::of(0.0)); FARTHEST]
    }

    /// The shares of a block that may have sites unlike others.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shares<W: Block<R>>(&self, site: usize) -> H::Shares<W> {
        let around = self.around(self.read, site as isize);
        let beside = if const { H::ROWS.is_some() } { self.beside(around, site as isize) } else { [around; 2] };
        let (length, row, rows) = (self.length, self.beside.row, self.beside.rows);
        let near = Neighbours { around, beside, site, length, row, rows, edge: true, scalar: PhantomData };
        H::shares::<R, W>(&near, self.parameters, self.time)
    }

    /// Where in [`Neighbours::around`] the first and the last block are that are looked at.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn window<W: Block<R>>() -> [usize; 2] {
        [FARTHEST - H::EDGES.behind.div_ceil(W::WIDTH), FARTHEST + H::EDGES.ahead.div_ceil(W::WIDTH)]
    }

    /// The coordinates of a row around the block that begins at `site`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn around<W: Block<R>>(&self, row: &[S], site: isize) -> Around<W> {
        let [nearest, farthest] = Self::window::<W>();
        let mut around = [self.coordinates::<W>(row, site); 2 * FARTHEST + 1];
        for distance in 1..FARTHEST + 1 {
            let far = (distance * W::WIDTH) as isize;
            if FARTHEST >= nearest + distance {
                around[FARTHEST - distance] = self.coordinates(row, site - far);
            }
            if FARTHEST + distance <= farthest {
                around[FARTHEST + distance] = self.coordinates(row, site + far);
            }
        }
        around
    }

    /// The same in the rows above and below, where they are looked at.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn beside<W: Block<R>>(&self, around: Around<W>, site: isize) -> [Around<W>; 2] {
        let [looks_above, looks_below] = Self::LOOKED_AT;
        let [above, below] = self.beside.read;
        [
            if looks_above { self.around(above, site) } else { around },
            if looks_below { self.around(below, site) } else { around },
        ]
    }

    /// The coordinates of the block from a site on, which may lie beyond an end.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn coordinates<W: Block<R>>(&self, row: &[S], site: isize) -> W {
        let length = self.length as isize;
        let site = match site {
            _ if !H::EDGES.periodic => site,
            behind if behind < 0 => behind + length,
            ahead if ahead >= length => ahead - length,
            inside => inside,
        };
        let begin = site - self.first as isize;
        if begin >= 0 && begin as usize + W::WIDTH <= row.len() {
            return S::read(&row[begin as usize..]);
        }
        let mut numbers = [R::of(0.0); WIDEST];
        for (place, number) in numbers[..W::WIDTH].iter_mut().enumerate() {
            let site = site + place as isize;
            let site = if H::EDGES.periodic { site.rem_euclid(length) } else { site };
            let at = site - self.first as isize;
            if at >= 0 && (at as usize) < row.len() {
                *number = row[at as usize].value();
            }
        }
        W::read(&numbers)
    }
}

/// What comes to a block of sites from `onward` places behind: shares of the block itself, and those carried to it.
#[cfg_attr(not(debug_assertions), inline(always))]
fn arriving<R: Real, W: Block<R>>(onward: usize, own: W, carried: [W; FARTHEST]) -> W {
    let [nearest, _] = carried;
    match (onward, W::WIDTH) {
        (_, 1) => carried[onward - 1],
        (1, _) => own.before(nearest),
        _ => own.before(nearest).before(nearest.before(nearest)),
    }
}

/// An array whose length the generator chose.
pub trait Array<T>: AsRef<[T]> + AsMut<[T]> + Copy {
    /// The array of so many times the same.
    fn filled(with: T) -> Self;
}

impl<T: Copy, const N: usize> Array<T> for [T; N] {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn filled(with: T) -> Self {
        [with; N]
    }
}
