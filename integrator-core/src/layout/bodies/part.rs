//! A part of H that is a sum over pairs of bodies, beside other parts: rows of bodies as a copy of the positions.
//!
//! The state stays in the user's own shape, in which the other parts move it. The copy takes part of the time of a sum over
//! pairs: a number is read and written for each coordinate, where a sum reads those of dozens of neighbours.

use crate::{
    layout::bodies::{
        load_store::{WIDTH, load_constants},
        many_rows::{ManyRows, bodies_of_row},
        pair_sums::{BodyConstants, ManyBody, OfBodies},
    },
    scalar::{real::Real, simd::row::Row},
    state::{coords::Coords, precision::Slot},
    system::motion::{InRegisters, Prepared, Solver},
};
use alloc::vec::Vec;
use core::marker::PhantomData;

/// The prepared constants of the bodies of a part. Written by `#[hamiltonian]`.
pub trait PartConstants<const S: usize>: OfBodies + 'static {
    /// The constants of one body.
    fn body_constants(parameters: &Self::Parameters<f64>, body: usize) -> [f64; S];
    /// How many of this number of bodies act on each other: the first ones.
    fn acting(_parameters: &Self::Parameters<f64>, bodies: usize) -> usize {
        bodies
    }
}

/// The constants of a system, read for one of its parts.
struct OfPart<'p, H: OfBodies>(&'p H::Parameters<f64>);

impl<H: PartConstants<S>, const S: usize> BodyConstants<S> for OfPart<'_, H> {
    fn body_constants(&self, body: usize) -> [f64; S] {
        H::body_constants(self.0, body)
    }
}

/// The rows of bodies of a part `H`.
pub struct PartOfBodies<H: OfBodies, R: Real, const D: usize, const S: usize> {
    rows: Option<ManyRows<R, f64, H::Parameters<R>, D, S>>,
    part: PhantomData<fn(H)>,
}

impl<H: OfBodies, R: Real, const D: usize, const S: usize> Clone for PartOfBodies<H, R, D, S> {
    fn clone(&self) -> Self {
        Self { rows: self.rows.clone(), part: PhantomData }
    }
}

impl<H: OfBodies, R: Real, const D: usize, const S: usize> Default for PartOfBodies<H, R, D, S> {
    fn default() -> Self {
        Self { rows: None, part: PhantomData }
    }
}

impl<H, R, const D: usize, const S: usize> Solver<H::Parameters<f64>> for PartOfBodies<H, R, D, S>
where
    H: PartConstants<S>,
    R: Real,
{
    const IN_REGISTERS: InRegisters = InRegisters::Never;

    fn of(constants: &[&H::Parameters<f64>], length: usize) -> Self {
        let bodies = length * H::Coords::COMPONENTS / D;
        let acting = constants.first().map_or(bodies, |constants| H::acting(constants, bodies));
        let of_part: Vec<_> = constants.iter().map(|constants| OfPart::<H>(constants)).collect();
        let of_part: Vec<_> = of_part.iter().collect();
        let row = |row: usize| load_constants::<R, OfPart<'_, H>, WIDTH, S>(&bodies_of_row(row, bodies), &of_part);
        let rows = (0..bodies.div_ceil(WIDTH)).map(row).collect();
        let rows = ManyRows::at_origin(H::Parameters::<R>::gather(constants), rows, bodies, acting);
        Self { rows: Some(rows), part: PhantomData }
    }
    fn at_rest(&self) -> Self {
        self.clone()
    }
    fn copy_state(&mut self, from: &Self) {
        if let (Some(rows), Some(from)) = (&mut self.rows, &from.rows) {
            rows.neighbours.share(&from.neighbours);
        }
    }
    fn share_among(&mut self, threads: Option<usize>) {
        if let Some(rows) = &mut self.rows {
            rows.use_threads(threads);
        }
    }
}

impl<H: ManyBody<D, S>, R: Real, const D: usize, const S: usize> PartOfBodies<H, R, D, S> {
    /// Applies the flow of the part.
    #[inline(always)]
    pub fn kick<C: Coords>(&mut self, q: &C::Slots<R>, p: &mut C::Slots<R>, duration: f64, time: f64) {
        let Some(rows) = &mut self.rows else { return };
        place::<R, _, D>(&mut rows.q, C::slots(q));
        rows.p.fill([Slot::<R::Row<WIDTH>>::zero(); D]);
        rows.kick::<H>(duration, time);
        let (points, _) = C::slots_mut(p).as_chunks_mut::<D>();
        for (row, points) in rows.p.iter().zip(points.chunks_mut(WIDTH)) {
            let mut numbers = [[R::of(0.0); WIDTH]; D];
            for d in 0..D {
                row[d].write(&mut numbers[d]);
            }
            for (lane, point) in points.iter_mut().enumerate() {
                for d in 0..D {
                    point[d].add(numbers[d][lane]);
                }
            }
        }
    }

    /// Returns the energy of the part.
    pub fn energy<C: Coords>(&self, q: &C::Slots<R>, time: f64) -> R {
        let Some(mut rows) = self.rows.clone() else { return R::of(f64::NAN) };
        place::<R, _, D>(&mut rows.q, C::slots(q));
        rows.potential::<H>(time)
    }
}

/// Copies positions to rows; lanes after the last body repeat the first bodies of their row.
#[inline(always)]
fn place<R: Real, L: Slot<R>, const D: usize>(rows: &mut [[R::Row<WIDTH>; D]], q: &[L]) {
    let (points, _) = q.as_chunks::<D>();
    for (row, points) in rows.iter_mut().zip(points.chunks(WIDTH)) {
        let mut numbers = [[R::of(0.0); WIDTH]; D];
        for lane in 0..WIDTH {
            let point = &points[lane % points.len()];
            for d in 0..D {
                numbers[d][lane] = point[d].value();
            }
        }
        for d in 0..D {
            row[d] = <R::Row<WIDTH> as Row<R>>::read(&numbers[d]);
        }
    }
}
