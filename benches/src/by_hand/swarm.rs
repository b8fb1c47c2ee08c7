//! Ensembles: groups of vectors in flight. The state of a group stays in registers and the L1 cache for all steps.

use crate::{
    by_hand::points::{Careful, Fast, HenonHeiles, Kepler, Lanes, Pendulum, Point},
    enter::{Kernel, enter},
    plan::{HandWritten, Plan},
    vector::{Number, Row, Vector},
};

/// Several vectors, advanced in alternation to hide the latency of each.
struct Group<L, const IN_FLIGHT: usize>([L; IN_FLIGHT]);

impl<L: HandWritten, const IN_FLIGHT: usize> HandWritten for Group<L, IN_FLIGHT> {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        for lanes in &mut self.0 {
            lanes.drift(t);
        }
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        for lanes in &mut self.0 {
            lanes.kick(t);
        }
    }
}

/// Trajectories as columns of coordinates and parameters, in `f64` or `f32`.
pub struct Swarm<T> {
    point: Point,
    columns: [Vec<T>; 4],
}

struct March<'s, T> {
    swarm: &'s mut Swarm<T>,
    plan: &'s Plan,
    steps: u64,
}

impl<T: Number> March<'_, T> {
    #[inline(always)]
    fn march<V: Vector<Number = T>, L: Lanes<V>, const IN_FLIGHT: usize>(self) {
        let columns = &mut self.swarm.columns;
        for first in (0..columns[0].len()).step_by(IN_FLIGHT * V::LANES) {
            let mut group = Group::<L, IN_FLIGHT>(std::array::from_fn(|i| L::load(columns, first + i * V::LANES)));
            self.plan.march(&mut group, self.steps);
            for (i, lanes) in group.0.iter().enumerate() {
                lanes.store(columns, first + i * V::LANES);
            }
        }
    }

    #[inline(always)]
    fn of_point<V: Vector<Number = T>>(self) {
        // Four vectors of Hénon–Heiles stars fit into the registers and wait little. The longer forces of the others
        // profit from eight vectors.
        match self.swarm.point {
            Point::Pendulum => self.march::<V, Pendulum<V, Careful>, 8>(),
            Point::FastPendulum => self.march::<V, Pendulum<V, Fast>, 8>(),
            Point::HenonHeiles => self.march::<V, HenonHeiles<V>, 4>(),
            Point::Kepler => self.march::<V, Kepler<V>, 8>(),
        }
    }
}

macro_rules! precision {
    ($number:ident in $vectors:ident, groups of $group:literal) => {
        impl Kernel for March<'_, $number> {
            type Out = ();
            #[inline(always)]
            fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) {
                self.of_point::<$vectors>();
            }
        }

        impl Swarm<$number> {
            /// Creates a swarm from the coordinates and parameters of each trajectory.
            ///
            /// # Panics
            /// If their number is not a multiple of that in a group of the widest vectors.
            pub fn new(point: Point, members: &[[f64; 4]]) -> Self {
                assert_eq!(members.len() % $group, 0, "whole groups");
                let column = |i: usize| members.iter().map(|member| $number::of(member[i])).collect();
                Self { point, columns: [0, 1, 2, 3].map(column) }
            }

            /// Takes `steps` steps of every trajectory.
            pub fn advance(&mut self, plan: &Plan, steps: u64) {
                enter(March { swarm: self, plan, steps });
            }

            /// Returns the coordinates and parameters of a trajectory.
            pub fn member(&self, member: usize) -> [f64; 4] {
                [0, 1, 2, 3].map(|i| self.columns[i][member].widen())
            }
        }
    };
}
precision!(f64 in V, groups of 64);
precision!(f32 in S, groups of 128);
