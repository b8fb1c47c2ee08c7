//! The way back of gradients for members in lanes: each has a state and a vector beside it.

use crate::{
    composition::{Processor, Stages},
    ensemble::{in_lanes, lane_scalars::LaneScalars},
    scalar::{dual::Dual, instruction_set::InstructionSet, real::Real},
    state::{clock::Clock, coords::Coords, phase::Phase, point::Point, precision::Precision},
    system::{Shaped, System, parameter_derivatives::ParameterDerivatives},
    trajectory::{
        by_table::slopes::{self, Steps, StepsOf, has_slopes},
        dispatch::Deviations,
        engine::Engine,
        in_lanes::InLanes,
        method::Differentiable,
        motions::{Constants, Motions, load},
        tangent::BETWEEN_SCALES,
    },
};
use std::sync::Arc;

/// The lanes of a member: its state, and one vector.
pub(super) const LANES_OF_MEMBER: usize = 2;

/// States, each followed by its vector, and the derivatives with respect to parameters of each member.
type Arrived<C> = Option<(Vec<Phase<C>>, Vec<f64>)>;

/// Takes steps from points, each of a member.
type Take<'b, C> = dyn Fn(&[(usize, Phase<C>)], Clock, u64) -> Arrived<C> + Sync + 'b;

/// A number of lanes, and the steps with points in them.
type InLanesOf<H, K> = (usize, StepsOf<<H as System>::Parameters<f64>, Shaped<H, K>>);

/// The way back of members in lanes.
pub(super) struct Back<'b, C: Coords> {
    /// The number of lanes of a whole motion, or of motions that go through each stage together.
    pub(super) lanes: usize,
    /// The number of parameters.
    pub(super) parameters: usize,
    /// Takes steps from points, each of a member; nothing if one of them cannot take them all.
    pub(super) take: Box<Take<'b, C>>,
}

/// Whether members share lanes on the way back.
pub(super) const fn shares_lanes<H: ParameterDerivatives, X: Differentiable<H>, K: Precision>() -> bool {
    !K::REVERSIBLE && (H::SENSITIVE.is_empty() || X::IS_PLAIN_TABLE && has_slopes::<H, K>())
}

/// The way back by a method, for members with these constants that [share lanes](shares_lanes); nothing if a composition has no
/// table.
pub(super) fn back<'b, H, X, C>(
    method: X,
    constants: Constants<X::Constants>,
    parameters: &'b [Option<Arc<H::Parameters<f64>>>],
) -> Option<Back<'b, C>>
where
    H: ParameterDerivatives,
    X: InLanes<H> + Differentiable<H>,
    C: Coords<Leaf: LaneScalars>,
    H::Coords: Coords<With<C::Leaf> = C>,
{
    // A constant, so that one of both is compiled.
    if const { H::SENSITIVE.is_empty() } {
        Some(by_vectors(in_lanes::<H, X, C::Leaf, Deviations<1>>(constants)))
    } else {
        let table = method.facts().table?;
        let (lanes, steps) = match InstructionSet::chosen() {
            InstructionSet::Baseline => steps_in::<H, Dual<<C::Leaf as LaneScalars>::Plain>, C::Leaf>(),
            InstructionSet::Fused => steps_in::<H, Dual<<C::Leaf as LaneScalars>::Fused>, C::Leaf>(),
            InstructionSet::Avx512 => steps_in::<H, Dual<<C::Leaf as LaneScalars>::Avx512>, C::Leaf>(),
        };
        let take = move |points: &[(usize, Phase<C>)], clock: Clock, count: u64| {
            let (mut ends, mut slopes) = (Vec::with_capacity(points.len()), Vec::new());
            for points in points.chunks(lanes) {
                let of_lanes =
                    points.iter().map(|(member, _)| parameters[*member].as_deref()).collect::<Option<Vec<_>>>()?;
                let points: Vec<_> = points.iter().map(|(_, point)| point).collect();
                let sums = vec![0.0; points.len() / LANES_OF_MEMBER * H::SENSITIVE.len()];
                let (reached, sums) = by_slopes(table, steps, &of_lanes, (&points, sums), clock, count)?;
                ends.extend(reached);
                slopes.extend(sums);
            }
            Some((ends, slopes))
        };
        Some(Back { lanes, parameters: H::SENSITIVE.len(), take: Box::new(take) })
    }
}

/// The lanes of a number with one derivative, and the steps in it.
fn steps_in<H: ParameterDerivatives, R: Real, K: LaneScalars>() -> InLanesOf<H, K> {
    (R::LANES, slopes::steps::<H, R, K>)
}

/// The way back with deviation vectors, by motions like these.
fn by_vectors<'b, C: Coords>(like: Box<dyn Motions>) -> Back<'b, C> {
    let lanes = like.lanes();
    let take = move |points: &[(usize, Phase<C>)], mut clock: Clock, steps: u64| {
        let of_lanes = points.iter().map(|(member, point)| (*member, point as &dyn Point)).collect();
        let mut engine = Engine::new(load(&*like, of_lanes));
        take(&mut engine, &mut clock, steps)?;
        let ends = points.iter().enumerate().map(|(lane, (_, point))| lane_of(&engine, clock, lane, point)).collect();
        Some((ends, Vec::new()))
    };
    Back { lanes, parameters: 0, take: Box::new(take) }
}

/// Takes steps with the members of one motion, in the blocks of a member alone, whose vectors are not divided meanwhile.
fn by_slopes<P, C: Coords>(
    table: (Stages, Processor),
    steps: StepsOf<P, C>,
    parameters: &[&P],
    (points, mut sums): (&[&Phase<C>], Vec<f64>),
    clock: Clock,
    count: u64,
) -> Arrived<C> {
    let mut reached: Vec<_> = points.iter().map(|point| (*point).clone()).collect();
    let mut done = 0;
    while done < count {
        let block = BETWEEN_SCALES.min(count - done);
        let points: Vec<_> = reached.iter().collect();
        let begin = Clock { t0: clock.at(done), ..clock };
        let Steps { points, slopes, is_finite } = steps(table, parameters, &points, begin, block);
        if !is_finite {
            return None;
        }
        for (sum, slope) in sums.iter_mut().zip(slopes) {
            *sum -= slope;
        }
        reached = points;
        done += block;
    }
    Some((reached, sums))
}

/// Takes steps with all members; nothing if one of them cannot take them all.
pub(super) fn take(engine: &mut Engine, clock: &mut Clock, steps: u64) -> Option<()> {
    let mut taken = 0;
    engine.advance(*clock, steps, &mut taken);
    clock.steps += taken;
    (taken == steps).then_some(())
}

pub(super) fn lane_of<C: Coords>(engine: &Engine, clock: Clock, lane: usize, like: &Phase<C>) -> Phase<C> {
    let mut point = like.clone();
    engine.lane(clock, lane, &mut point);
    point
}
