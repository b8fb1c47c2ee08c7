//! Energies of planes and volumes: each site computes its terms from its neighbourhood, in blocks as a flow computes them.
//!
//! Terms of a row are added as iterations in lanes are: site `x` adds to partial sum `x` modulo sixteen. Sums of rows are
//! added one after the other, and those of planes likewise. So the bits of an energy do not depend on the width of a block.

use crate::{
    layout::{
        lattice::{
            plane::{AdjacentPlanes, Plane},
            stencil::Stencil,
        },
        loops::sum,
    },
    scalar::real::{Kernel, Real},
    state::{coords::Coords, precision::Slot},
    system::{motion::Plain, sites::RowCarries},
};
use core::marker::PhantomData;

/// The energy `T`, as a parameter of [`Stencil`]: a site has one contribution, its terms.
pub struct KineticEnergy;

/// The energy `V`, as a parameter of [`Stencil`].
pub struct PotentialEnergy;

impl<R: Real, C: Coords, P> Plain<R, C, P> {
    /// `T` of a plane or a volume.
    #[inline(always)]
    pub fn kinetic_of_layers<H: Stencil<KineticEnergy, Parameters<R> = P>>(&self, time: f64) -> R {
        self.energy_of_layers::<H, _>(C::slots(&self.p), time)
    }

    /// `V` of a plane or a volume.
    #[inline(always)]
    pub fn potential_of_layers<H: Stencil<PotentialEnergy, Parameters<R> = P>>(&self, time: f64) -> R {
        self.energy_of_layers::<H, _>(C::slots(&self.q), time)
    }

    #[inline(always)]
    fn energy_of_layers<H: Stencil<F, Parameters<R> = P>, F>(&self, read: &[impl Slot<R>], time: f64) -> R {
        let Some(columns) = H::columns::<R>(&self.parameters, read.len()) else { return R::of(0.0) };
        let rows = read.len().checked_div(columns).unwrap_or(0);
        let (around, carries) = (AdjacentPlanes::none(), &mut RowCarries::default());
        let (parameters, step, flow) = (&self.parameters, R::of(1.0), PhantomData::<(H, F)>);
        let moved = &mut [];
        R::enter(Energy(Plane {
            columns,
            rows,
            first: 0,
            range: 0..rows,
            around,
            read,
            moved,
            carries,
            parameters,
            step,
            time,
            flow,
        }))
    }
}

/// The sum over some rows of a plane, or over some planes of a volume in place of rows.
struct Energy<'m, H: Stencil<F>, F, R: Real, S>(Plane<'m, H, F, R, S>);

impl<H: Stencil<F>, F, R: Real, S: Slot<R>> Kernel for Energy<'_, H, F, R, S> {
    type Out = R;

    #[inline(always)]
    fn call(self) -> R {
        let Self(layers) = self;
        if const { H::PLANE_BOUNDARY.is_none() } {
            return energy_of(&layers);
        }
        let mut energy = R::of(0.0);
        for number in layers.range.clone() {
            let mut carries = RowCarries::default();
            if let Some(plane) = layers.plane(number, &mut [], &mut carries) {
                energy += energy_of(&plane);
            }
        }
        energy
    }
}

/// The sum over the rows of a plane.
#[inline(always)]
fn energy_of<H: Stencil<F>, F, R: Real, S: Slot<R>>(plane: &Plane<'_, H, F, R, S>) -> R {
    let mut energy = R::of(0.0);
    for row in plane.range.clone() {
        if let Some(along) = plane.along(row, &mut [], &mut []) {
            let of_block = |site| along.contributions::<R::Block>(site).as_ref()[0];
            energy += sum(plane.columns, of_block, |site| along.contributions::<R>(site).as_ref()[0]);
        }
    }
    energy
}
