//! Lists that a motion hands to another one of the same system: to that of an energy, or of a state that was changed from outside.

use super::{
    Arc, Neighbours, Vec,
    listed::{Listed, epsilon},
    lists::Lists,
};
use crate::{
    layout::bodies::load_store::WIDTH,
    scalar::{real::Real, simd::row::Row},
    system::motion::Found,
};

/// Lists for a motion that may compute in other numbers.
struct FoundLists<const D: usize> {
    lists: Arc<Lists>,
    /// The positions of the bodies when the lists were made.
    reference: Vec<[f64; D]>,
    slack: f64,
    skin: f64,
    sums: u32,
    /// The spacing of the numbers that the lists were made for.
    epsilon: f64,
}

impl<R: Real, const D: usize> Neighbours<R, D> {
    /// The lists of one state, for another motion of this number of bodies with the same constants.
    pub(crate) fn found(&self, bodies: usize) -> Option<Found> {
        let listed = self.last().filter(|_| R::LANES == 1)?;
        let mut reference = Vec::with_capacity(bodies);
        for (row, first) in listed.reference.iter().zip((0..bodies).step_by(WIDTH)) {
            let (mut numbers, mut points) = ([R::of(0.0); WIDTH], [[0.0; D]; WIDTH]);
            for d in 0..D {
                row[d].write(&mut numbers);
                for lane in 0..WIDTH {
                    points[lane][d] = numbers[lane].lane(0);
                }
            }
            reference.extend_from_slice(&points[..WIDTH.min(bodies - first)]);
        }
        let (lists, epsilon) = (listed.lists.clone(), epsilon::<R>());
        Some(Arc::new(FoundLists {
            lists,
            reference,
            slack: listed.slack,
            skin: listed.skin,
            sums: self.sums,
            epsilon,
        }))
    }

    /// Takes over lists, unless they were made for numbers that round less than those that are computed in here.
    pub(crate) fn use_found(&mut self, found: &Found, bodies: usize) {
        let Some(found) = found.downcast_ref::<FoundLists<D>>() else { return };
        if R::LANES != 1 || found.epsilon < epsilon::<R>() || found.reference.len() != bodies {
            return;
        }
        let mut reference = Vec::with_capacity(bodies.div_ceil(WIDTH));
        for bodies in found.reference.chunks(WIDTH) {
            let mut row = [Real::of(0.0); D];
            for (axis, row) in row.iter_mut().enumerate() {
                *row = Real::parameter(&|lane| bodies[lane % bodies.len()][axis]);
            }
            reference.push(row);
        }
        let (lists, slack, skin) = (found.lists.clone(), found.slack, found.skin);
        self.listed = Some(Arc::new(Listed { lists, reference, slack, skin }));
        self.sums = found.sums;
    }
}
