//! Flows of volumes: planes of rows, one behind the other.
//!
//! A plane hands nothing on to the next one: where a bond goes across, what it contributes is computed on both sides, from the
//! rows of the planes before and behind. Within a plane rows are passed as those of a plane alone.

use crate::{
    layout::lattice::{
        plane::{AdjacentPlanes, Moves, Plane, RowCarries},
        sites::Sites,
        stencil::{Boundary, Drift, Kick, Stencil},
        time_tiling::Flow,
    },
    scalar::real::{Kernel, Real},
    state::{
        coords::Coords,
        precision::{Precision, Slot},
    },
    system::motion::Plain,
};
use core::{marker::PhantomData, ops::Range};

impl<R: Real, C: Coords, P> Plain<R, C, P> {
    /// The flow of `T` of a volume.
    #[inline(always)]
    pub fn drift_planes<H: Stencil<Drift, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let mut planes = self.layers();
        let range = 0..planes.length;
        planes.apply_planes::<H, Drift>(R::of(duration), time, range);
    }

    /// The flow of `V` of a volume.
    #[inline(always)]
    pub fn kick_planes<H: Stencil<Kick, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let mut planes = self.layers();
        let range = 0..planes.length;
        planes.apply_planes::<H, Kick>(R::of(-duration), time, range);
    }
}

impl<R: Real, K: Precision, P> Sites<'_, R, K, P> {
    /// Applies a flow to some `planes`.
    #[inline(always)]
    pub fn apply_to_planes<H>(&mut self, flow: &Flow, planes: Range<usize>)
    where
        H: Stencil<Drift, Parameters<R> = P> + Stencil<Kick, Parameters<R> = P>,
    {
        if flow.drifts {
            self.apply_planes::<H, Drift>(R::of(flow.duration), flow.time, planes);
        } else {
            self.apply_planes::<H, Kick>(R::of(-flow.duration), flow.time, planes);
        }
    }

    #[inline(always)]
    fn apply_planes<H: Stencil<F, Parameters<R> = P>, F: Moves>(&mut self, step: R, time: f64, range: Range<usize>) {
        let Self { q, p, parameters, first, length: planes, columns: sites, carries } = self;
        let (read, moved): (&[_], _) = if F::POSITIONS { (p, q) } else { (q, p) };
        let (first, planes, sites, parameters) = (*first, *planes, *sites, *parameters);
        let flow = PhantomData::<(H, F)>;
        let mut none = RowCarries::default();
        let carries = carries.as_deref_mut().unwrap_or(&mut none);
        R::enter(Volume { sites, planes, first, range, read, moved, carries, parameters, step, time, flow });
    }
}

/// A flow of some planes of a volume.
struct Volume<'m, H: Stencil<F>, F, R: Real, S> {
    /// The number of sites in a plane.
    sites: usize,
    /// The number of planes of the whole volume.
    planes: usize,
    /// The index of the first plane in the slices.
    first: usize,
    /// The planes that are moved.
    range: Range<usize>,
    /// The coordinates that the flow depends on, plane by plane.
    read: &'m [S],
    /// Those that it moves.
    moved: &'m mut [S],
    carries: &'m mut RowCarries<R>,
    parameters: &'m H::Parameters<R>,
    step: R,
    time: f64,
    flow: PhantomData<(H, F)>,
}

impl<H: Stencil<F>, F, R: Real, S: Slot<R>> Volume<'_, H, F, R, S> {
    /// A plane of the coordinates that the flow depends on; nothing beyond an end.
    #[inline(always)]
    fn at(&self, plane: Option<usize>) -> &[S] {
        plane.map_or(&self.read[..0], |plane| &self.read[(plane - self.first) * self.sites..][..self.sites])
    }

    /// The planes around one of them.
    #[inline(always)]
    fn around(&self, plane: usize, boundary: Boundary) -> AdjacentPlanes<'_, S> {
        let beyond = |plane: usize| if boundary.periodic { Some(plane) } else { None };
        let before = if boundary.behind > 0 { plane.checked_sub(1).or(beyond(self.planes - 1)) } else { None };
        let behind =
            if boundary.ahead > 0 { Some(plane + 1).filter(|next| *next < self.planes).or(beyond(0)) } else { None };
        let differs = plane < boundary.first || plane + boundary.last >= self.planes;
        let reads_beyond = boundary.behind > 0 && before.is_none() || boundary.ahead > 0 && behind.is_none();
        AdjacentPlanes {
            plane: [plane, self.planes],
            at_boundary: differs || reads_beyond,
            read: [self.at(before), self.at(behind)],
        }
    }
}

impl<H: Stencil<F>, F, R: Real, S: Slot<R>> Kernel for Volume<'_, H, F, R, S> {
    type Out = ();

    #[inline(always)]
    fn call(mut self) {
        let (Some(rows), Some(boundary)) = (H::Coords::ROWS, H::PLANE_BOUNDARY) else { return };
        let columns = self.sites.checked_div(rows).unwrap_or(0);
        let (moved, mut carries) = (core::mem::take(&mut self.moved), core::mem::take(self.carries));
        for number in self.range.clone() {
            let begin = (number - self.first) * self.sites;
            Plane {
                columns,
                rows,
                first: 0,
                range: 0..rows,
                around: self.around(number, boundary),
                read: self.at(Some(number)),
                moved: &mut moved[begin..][..self.sites],
                carries: &mut carries,
                parameters: self.parameters,
                step: self.step,
                time: self.time,
                flow: self.flow,
            }
            .call();
        }
        *self.carries = carries;
    }
}
