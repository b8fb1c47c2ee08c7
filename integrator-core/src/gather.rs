//! Flows of lattices in gather form: a site gets all its addends at once, and each of them is computed once.
//!
//! At every site something is computed from its neighbourhood, the bond to the next one for instance, and shared out
//! among the site and the next ones. A sweep carries shares along with it, so that no buffer is filled and no bond
//! computed twice. The order of the addends of a site is that of the shares, whatever the width of a block is and
//! wherever a sweep begins: so are the bits.

use crate::{
    block::Block,
    hamiltonian::Hamiltonian,
    neighbours::{FARTHEST, Neighbours},
    real::Real,
    slot::Slot,
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

/// A flow that every site takes part in alike. Written by `#[hamiltonian]`; `F` is [`Drift`] or [`Kick`].
pub trait Gather<F>: Hamiltonian {
    /// What is computed at a site: element `k` is an addend for the site `k` places further on.
    type Shares<W: Copy>: Array<W>;

    /// Where the sites are that are not like all others.
    const EDGES: Edges;

    /// The shares of a block of sites.
    fn shares<R: Real, W: Block<R>>(
        near: &Neighbours<R, W>,
        parameters: &Self::Parameters<R>,
        time: f64,
    ) -> Self::Shares<W>;
}

/// A flow on its way over sites that it finds in two slices, which may be windows of a longer lattice.
pub(crate) struct Sweep<'m, H: Hamiltonian, F, R: Real, S> {
    /// The coordinates that the flow depends on.
    pub(crate) read: &'m [S],
    /// Those that it moves.
    pub(crate) moved: &'m mut [S],
    /// The site that the slices begin with.
    pub(crate) first: usize,
    /// How many sites the lattice has.
    pub(crate) length: usize,
    pub(crate) parameters: &'m H::Parameters<R>,
    pub(crate) step: R,
    pub(crate) time: f64,
    pub(crate) flow: PhantomData<F>,
}

impl<H: Gather<F>, F, R: Real, S: Slot<R>> Sweep<'_, H, F, R, S> {
    /// Moves the coordinates of `sites`: whole blocks, then one by one the sites that fill none.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn over(mut self, sites: Range<usize>) {
        let rest = self.blocks::<S::Wide>(sites.clone());
        if rest < sites.end {
            self.blocks::<R>(rest..sites.end);
        }
    }

    /// Moves whole blocks of `sites`, and returns where they end.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn blocks<W: Block<R>>(&mut self, sites: Range<usize>) -> usize {
        let (mut site, end) = (sites.start, sites.end);
        if site + W::WIDTH > end {
            return site;
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

    /// How many blocks from the beginning of `sites` on have no site of the last ones, and all around them at hand.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn alike<W: Block<R>>(&self, sites: Range<usize>) -> usize {
        let [_, farthest] = Self::window::<W>();
        let at_hand = (self.first + self.read.len()).saturating_sub((farthest - FARTHEST) * W::WIDTH);
        let end = self.length.saturating_sub(H::EDGES.last).min(at_hand).min(sites.end);
        end.saturating_sub(sites.start) / W::WIDTH
    }

    /// Moves a block that may have sites unlike others; `carried` as below.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn block<W: Block<R>>(&mut self, site: usize, carried: [H::Shares<W>; FARTHEST]) -> [H::Shares<W>; FARTHEST] {
        let found = self.shares::<W>(site);
        S::update(&mut self.moved[site - self.first..], self.step, Self::sum(found, carried));
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
        let [nearest, farthest] = Self::window::<W>();
        let begin = site - self.first;
        let mut around = self.around::<W>(site as isize - W::WIDTH as isize);
        let read = self.read[begin + (farthest - FARTHEST) * W::WIDTH..].chunks_exact(W::WIDTH).take(blocks);
        let moved = self.moved[begin..].chunks_exact_mut(W::WIDTH);
        for (next, moved) in read.zip(moved) {
            around.copy_within(nearest + 1..=farthest, nearest);
            around[farthest] = S::read(next);
            let near = Neighbours { around, site, length: self.length, edge: false, scalar: PhantomData };
            let found = H::shares::<R, W>(&near, self.parameters, self.time);
            S::update(moved, self.step, Self::sum(found, carried));
            carried = [found, carried[0]];
            site += W::WIDTH;
        }
        carried
    }

    /// What a block of sites gets; `carried` are the shares of the sites before it, nearest first.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sum<W: Block<R>>(found: H::Shares<W>, carried: [H::Shares<W>; FARTHEST]) -> W {
        let mut sum = found.as_ref()[0];
        for onward in 1..=H::EDGES.onward {
            let [nearest, farther] = carried;
            let carried = [nearest.as_ref()[onward], farther.as_ref()[onward]];
            sum += arriving::<R, W>(onward, found.as_ref()[onward], carried);
        }
        sum
    }

    /// The shares of the sites before `site`, as if the sweep came from there.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn carried<W: Block<R>>(&self, site: usize) -> [H::Shares<W>; FARTHEST] {
        let mut carried = [H::Shares::<W>::filled(W::of(0.0)); FARTHEST];
        for behind in (1..=H::EDGES.onward).rev() {
            let before = match site.checked_sub(behind) {
                None if H::EDGES.periodic => (site + FARTHEST * self.length - behind) % self.length,
                None => continue,
                Some(before) => before,
            };
            let found = self.shares::<R>(before);
            let [nearest, farther] = &mut carried;
            *farther = *nearest;
            for onward in 1..=H::EDGES.onward {
                let found = W::splat(found.as_ref()[onward]);
                // In a block of one the farther share is a block of its own.
                let nearest = &mut nearest.as_mut()[onward];
                *nearest = nearest.after(found);
            }
        }
        carried
    }

    /// The shares of a block that may have sites unlike others.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shares<W: Block<R>>(&self, site: usize) -> H::Shares<W> {
        let around = self.around(site as isize);
        let near = Neighbours { around, site, length: self.length, edge: true, scalar: PhantomData };
        H::shares::<R, W>(&near, self.parameters, self.time)
    }

    /// Where in [`Neighbours::around`] the first and the last block are that are looked at.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn window<W: Block<R>>() -> [usize; 2] {
        [FARTHEST - H::EDGES.behind.div_ceil(W::WIDTH), FARTHEST + H::EDGES.ahead.div_ceil(W::WIDTH)]
    }

    /// The coordinates around the block that begins at `site`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn around<W: Block<R>>(&self, site: isize) -> [W; 2 * FARTHEST + 1] {
        let [nearest, farthest] = Self::window::<W>();
        let mut around = [self.coordinates::<W>(site); 2 * FARTHEST + 1];
        for place in (nearest..=farthest).filter(|place| *place != FARTHEST) {
            around[place] = self.coordinates::<W>(site + (place as isize - FARTHEST as isize) * W::WIDTH as isize);
        }
        around
    }

    /// The coordinates of the block from a site on, which may lie beyond an end.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn coordinates<W: Block<R>>(&self, site: isize) -> W {
        let length = self.length as isize;
        let site = match site {
            _ if !H::EDGES.periodic => site,
            behind if behind < 0 => behind + length,
            ahead if ahead >= length => ahead - length,
            inside => inside,
        };
        let begin = site - self.first as isize;
        if begin >= 0 && begin as usize + W::WIDTH <= self.read.len() {
            return S::read(&self.read[begin as usize..]);
        }
        W::from_places(|place| {
            let site = site + place as isize;
            let site = if H::EDGES.periodic { site.rem_euclid(length) } else { site };
            let slot = usize::try_from(site - self.first as isize).ok().and_then(|place| self.read.get(place));
            slot.map_or(R::of(0.0), |slot| slot.value())
        })
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
