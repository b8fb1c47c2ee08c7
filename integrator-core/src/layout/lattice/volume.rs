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
};

/// A flow of some planes of a volume, which are the rows here.
pub(super) struct Volume<'m, H: Stencil<F>, F, R: Real, S>(pub(super) Plane<'m, H, F, R, S>);

impl<H: Stencil<F>, F, R: Real, S: Slot<R>> Kernel for Volume<'_, H, F, R, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self(mut planes) = self;
        let (Some(rows), Some(boundary)) = (H::Coords::ROWS, H::PLANE_BOUNDARY) else { return };
        let (sites, columns) = (planes.columns, planes.columns.checked_div(rows).unwrap_or(0));
        let (moved, mut carries) = (core::mem::take(&mut planes.moved), core::mem::take(planes.carries));
        for (number, moved) in planes.range.clone().zip(moved.chunks_exact_mut(sites.max(1))) {
            let ([before, behind], at_boundary) = planes.beside(number, boundary);
            let read = [planes.at(before), planes.at(behind)];
            Plane {
                columns,
                rows,
                first: 0,
                range: 0..rows,
                around: AdjacentPlanes { plane: [number, planes.rows], at_boundary, read },
                read: planes.at(Some(number)),
                moved,
                carries: &mut carries,
                parameters: planes.parameters,
                step: planes.step,
                time: planes.time,
                flow: planes.flow,
            }
            .call();
        }
        *planes.carries = carries;
    }
}
