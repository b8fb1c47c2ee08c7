//! Flows of volumes, which are consecutive planes of rows.
//!
//! A plane hands nothing on to the next one: where a bond goes across, what it contributes is computed on both sides, from the
//! rows of the planes before and after. Within a plane rows are passed as those of a plane alone.

use crate::{
    layout::lattice::{
        plane::{AdjacentPlanes, Plane},
        stencil::Stencil,
    },
    scalar::real::{Kernel, Real},
    state::{coords::Coords, precision::Slot},
    system::sites::RowCarries,
};

/// A flow of some planes of a volume, which are the rows here.
pub(super) struct Volume<'m, H: Stencil<F>, F, R: Real, S>(pub(super) Plane<'m, H, F, R, S>);

impl<H: Stencil<F>, F, R: Real, S: Slot<R>> Kernel for Volume<'_, H, F, R, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self(mut planes) = self;
        let sites = planes.columns;
        let (moved, mut carries) = (core::mem::take(&mut planes.moved), core::mem::take(planes.carries));
        for (number, moved) in planes.range.clone().zip(moved.chunks_exact_mut(sites.max(1))) {
            if let Some(plane) = planes.plane(number, moved, &mut carries) {
                plane.call();
            }
        }
        *planes.carries = carries;
    }
}

impl<H: Stencil<F>, F, R: Real, S: Slot<R>> Plane<'_, H, F, R, S> {
    /// A plane of a volume, whose planes are the rows here.
    #[inline(always)]
    pub(super) fn plane<'p>(
        &'p self,
        number: usize,
        moved: &'p mut [S],
        carries: &'p mut RowCarries<R>,
    ) -> Option<Plane<'p, H, F, R, S>> {
        let (rows, boundary) = (H::Coords::ROWS?, H::PLANE_BOUNDARY?);
        let ([before, behind], at_boundary) = self.beside(number, boundary);
        Some(Plane {
            columns: self.columns.checked_div(rows).unwrap_or(0),
            rows,
            first: 0,
            range: 0..rows,
            around: AdjacentPlanes {
                plane: [number, self.rows],
                at_boundary,
                read: [self.at(before), self.at(behind)],
            },
            read: self.at(Some(number)),
            moved,
            carries,
            parameters: self.parameters,
            step: self.step,
            time: self.time,
            flow: self.flow,
        })
    }
}
