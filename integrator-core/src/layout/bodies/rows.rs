//! Layouts of bodies as what they have in common: rows of positions and of momenta.

use crate::{
    layout::bodies::{
        load_store::{WIDTH, body_and_lane},
        many_rows::ManyRows,
        one_row::OneRow,
    },
    scalar::{real::Real, simd::row::Row},
    state::precision::{Precision, Slot},
    system::motion::Prepared,
};
use alloc::vec::Vec;
use core::{
    ops::Range,
    slice::{from_mut, from_ref},
};

/// A layout of bodies with `D` coordinates each in rows.
pub trait Rows<const D: usize>: Clone + Send + Sync + 'static {
    /// The scalar that flows are computed in.
    type Scalar: Real;
    /// The scalar type of the coordinates.
    type Leaf: Precision;
    /// A row of bodies.
    type Row: Row<Self::Scalar>;
    /// The layout with slots that hold numbers and nothing else.
    type AtRest: Rows<D, Scalar = Self::Scalar, Leaf = f64, Row = Self::Row>;

    /// The number of bodies in a full row.
    const WIDTH: usize;

    /// The number of bodies.
    fn bodies(&self) -> usize;
    /// The rows of positions, and those of momenta.
    fn rows(&self) -> [&[Coordinates<Self, D>]; 2];
    /// The rows of positions, and those of momenta, as mutable slices.
    fn rows_mut(&mut self) -> [&mut [Coordinates<Self, D>]; 2];
    /// Rotates a row: each lane gets the body that is this number of lanes ahead.
    fn rotate(row: Self::Row, by: usize) -> Self::Row;
    /// Returns a layout with these positions and without momenta.
    fn at_rest(&self) -> Self::AtRest;
    /// Sets the time at which conditions are read: the middle of the current step.
    fn begin_step(&mut self, middle: f64);
}

/// The slots of a row.
pub(crate) type Coordinates<L, const D: usize> = [<<L as Rows<D>>::Leaf as Precision>::Slot<<L as Rows<D>>::Row>; D];

impl<R, K, P, const N: usize, const D: usize, const S: usize> Rows<D> for OneRow<R, K, P, N, D, S>
where
    R: Real,
    K: Precision,
    P: Prepared<R>,
{
    type Scalar = R;
    type Leaf = K;
    type Row = R::Row<N>;
    type AtRest = OneRow<R, f64, P, N, D, S>;

    const WIDTH: usize = N;

    #[inline(always)]
    fn bodies(&self) -> usize {
        N
    }
    #[inline(always)]
    fn rows(&self) -> [&[Coordinates<Self, D>]; 2] {
        [from_ref(&self.q), from_ref(&self.p)]
    }
    #[inline(always)]
    fn rows_mut(&mut self) -> [&mut [Coordinates<Self, D>]; 2] {
        [from_mut(&mut self.q), from_mut(&mut self.p)]
    }
    #[inline(always)]
    fn rotate(row: Self::Row, by: usize) -> Self::Row {
        row.rotate::<N>(by)
    }
    fn at_rest(&self) -> Self::AtRest {
        OneRow::at_rest(self)
    }
    #[inline(always)]
    fn begin_step(&mut self, middle: f64) {
        self.parameters.begin_step(middle);
    }
}

impl<R, K, P, const D: usize, const S: usize> Rows<D> for ManyRows<R, K, P, D, S>
where
    R: Real,
    K: Precision,
    P: Prepared<R>,
{
    type Scalar = R;
    type Leaf = K;
    type Row = R::Row<WIDTH>;
    type AtRest = ManyRows<R, f64, P, D, S>;

    const WIDTH: usize = WIDTH;

    #[inline(always)]
    fn bodies(&self) -> usize {
        self.bodies
    }
    #[inline(always)]
    fn rows(&self) -> [&[Coordinates<Self, D>]; 2] {
        [&self.q, &self.p]
    }
    #[inline(always)]
    fn rows_mut(&mut self) -> [&mut [Coordinates<Self, D>]; 2] {
        [&mut self.q, &mut self.p]
    }
    #[inline(always)]
    fn rotate(row: Self::Row, by: usize) -> Self::Row {
        row.rotate::<WIDTH>(by)
    }
    fn at_rest(&self) -> Self::AtRest {
        ManyRows::at_rest(self)
    }
    #[inline(always)]
    fn begin_step(&mut self, middle: f64) {
        self.parameters.begin_step(middle);
    }
}

/// The bodies of a row.
#[inline(always)]
pub(crate) fn bodies_of_row(row: usize, width: usize, bodies: usize) -> Range<usize> {
    row * width..bodies.min((row + 1) * width)
}

/// The points of all bodies.
pub(crate) fn points<L: Rows<D>, const D: usize>(layout: &L, rows: &[Coordinates<L, D>]) -> Vec<[L::Scalar; D]> {
    let (mut points, bodies) = (Vec::with_capacity(layout.bodies()), layout.bodies());
    for (number, row) in rows.iter().enumerate() {
        for lane in 0..bodies_of_row(number, L::WIDTH, bodies).len() {
            let mut point = [L::Scalar::of(0.0); D];
            for d in 0..D {
                point[d] = row[d].value().part(lane);
            }
            points.push(point);
        }
    }
    points
}

/// A row of the bodies of a range; lanes after the last of them repeat the first ones.
fn row_of<R: Real, W: Row<R>>(bodies: &Range<usize>, number: impl Fn(usize) -> R) -> W {
    if const { W::PARTS == 0 } {
        return W::state(&|lane| {
            let (body, lane) = body_and_lane::<R>(bodies, lane);
            number(body).lane(lane)
        });
    }
    let mut row = W::of(0.0);
    for part in 0..W::PARTS {
        row.set_part(part, number(bodies.start + part % bodies.len()));
    }
    row
}

/// Sets the rows of all bodies to these points.
pub(crate) fn set_points<L: Rows<D>, const D: usize>(rows: &mut [Coordinates<L, D>], points: &[[L::Scalar; D]]) {
    for (number, row) in rows.iter_mut().enumerate() {
        let bodies = bodies_of_row(number, L::WIDTH, points.len());
        for (d, slot) in row.iter_mut().enumerate() {
            *slot = Slot::zero();
            slot.add(row_of::<L::Scalar, L::Row>(&bodies, |body| points[body][d]));
        }
    }
}
