//! The scatter-add of the iterations' results to the coordinates.
//!
//! Always true: the order in which a coordinate gets its addends follows from the iterations and their targets alone,
//! so that bits do not depend on the plan.

use super::table::{Coefficients, EIGHT, Wide, is_narrow};
use crate::scalar::{real::Real, simd::row::Row};
use alloc::{collections::BTreeMap, vec::Vec};

/// An addend of a coordinate.
#[derive(Clone, Copy)]
pub(super) struct Addend {
    /// The index of the coordinate.
    pub(super) index: usize,
    /// The number of the result vector.
    pub(super) result: usize,
    /// The lane in the result vector.
    pub(super) lane: usize,
    /// One, or minus one where the result is subtracted.
    pub(super) sign: i8,
}

/// The lane and the sign that each of eight consecutive coordinates gets of a result vector, if any.
type Permutation = [Option<(usize, i8)>; EIGHT];

/// The permutations by which eight coordinates get their addends of one result vector, at most one each.
fn permutations(addends: &[Addend]) -> Vec<Permutation> {
    let mut permutations: Vec<Permutation> = Vec::new();
    for Addend { index, lane, sign, .. } in addends {
        let (index, gets) = (index % EIGHT, Some((*lane, *sign)));
        match permutations.iter_mut().find(|permutation| permutation[index].is_none()) {
            Some(permutation) => permutation[index] = gets,
            None => {
                let mut permutation = [None; EIGHT];
                permutation[index] = gets;
                permutations.push(permutation);
            }
        }
    }
    permutations
}

/// The most target vectors in a block.
const MOST: usize = 3;

/// One, two or three vectors of eight coordinates, such as the components of points, with the same permutations: each
/// permutation is read once for all.
struct TargetBlock {
    /// The first index of each vector.
    begins: [usize; MOST],
    /// The number of passes over them.
    passes: usize,
}

/// A pass over a block, which adds consecutive result vectors to its target vectors by one permutation. The signs are
/// numbers of type `S`.
struct Pass<S> {
    /// The first result vector.
    result: usize,
    /// The lanes of results that the coordinates get; `None` if each gets its own lane.
    lanes: Option<[u64; EIGHT]>,
    /// The signs of the results: zero where a coordinate gets nothing.
    signs: S,
}

/// The first index of a target vector, and the result vector of each pass over it.
type Passes = (usize, Vec<usize>);

/// The plan of a scatter-add.
struct Plan<S> {
    /// Target vectors in blocks, first those of three, then those of two and of one.
    blocks: [Vec<TargetBlock>; MOST],
    /// The passes of the blocks, in the same order.
    passes: Vec<Pass<S>>,
    /// Addends one by one, in place of blocks.
    single: Vec<Addend>,
}

impl<S> Default for Plan<S> {
    fn default() -> Self {
        Self { blocks: [Vec::new(), Vec::new(), Vec::new()], passes: Vec::new(), single: Vec::new() }
    }
}

/// Independent of the scalar: compiled once, and not with every system.
impl Plan<[i8; EIGHT]> {
    /// The plan for an order slice of such a width.
    fn of(addends: Vec<Addend>, width: usize) -> Self {
        let mut plan = Self::default();
        if width < EIGHT {
            plan.single = addends;
            return plan;
        }
        // ScatterAdd by target vector and by result vector.
        let mut vectors: BTreeMap<usize, BTreeMap<usize, Vec<Addend>>> = BTreeMap::new();
        for addend in addends {
            let results = vectors.entry(addend.index / EIGHT * EIGHT).or_default();
            results.entry(addend.result).or_default().push(addend);
        }
        let mut alike: BTreeMap<Vec<Permutation>, Vec<Passes>> = BTreeMap::new();
        for (begin, results) in vectors {
            let passes =
                results.iter().flat_map(|(result, addends)| permutations(addends).into_iter().map(|of| (of, *result)));
            let (permutations, result) = passes.unzip();
            alike.entry(permutations).or_default().push((begin, result));
        }
        let mut blocks = Vec::new();
        for (permutations, vectors) in &alike {
            let mut rest = vectors.as_slice();
            while !rest.is_empty() {
                // One is contiguous.
                let count =
                    (1..=MOST.min(rest.len())).rev().find(|count| are_consecutive(&rest[..*count])).unwrap_or(1);
                let (block, others) = rest.split_at(count);
                blocks.push((permutations, block));
                rest = others;
            }
        }
        blocks.sort_by_key(|(_, vectors)| MOST - vectors.len());
        for (permutations, vectors) in blocks {
            let begins = core::array::from_fn(|vector| vectors.get(vector).map_or(0, |(begin, _)| *begin));
            plan.blocks[MOST - vectors.len()].push(TargetBlock { begins, passes: permutations.len() });
            plan.passes.extend(permutations.iter().zip(&vectors[0].1).map(|(permutation, result)| Pass {
                result: *result,
                lanes: lanes(permutation),
                signs: permutation.map(|gets| gets.map_or(0, |(_, sign)| sign)),
            }));
        }
        plan
    }
}

/// Whether the result vectors of consecutive target vectors are consecutive.
fn are_consecutive(vectors: &[Passes]) -> bool {
    let is_next = |(number, (_, results)): (usize, &Passes)| {
        results.iter().zip(&vectors[0].1).all(|(result, first)| *result == first + number)
    };
    vectors.iter().enumerate().all(is_next)
}

/// The lanes that coordinates get, unless each gets its own.
fn lanes(permutation: &Permutation) -> Option<[u64; EIGHT]> {
    // A lane without an iteration may hold NaN, which no factor makes zero.
    let some = permutation.iter().flatten().next().map_or(0, |(lane, _)| *lane);
    let lanes = permutation.map(|gets| gets.map_or(some, |(lane, _)| lane) as u64);
    let is_own = lanes == core::array::from_fn(|lane| lane as u64);
    (!is_own).then_some(lanes)
}

/// The scatter-add of all iterations to positions, or to momenta.
pub(super) struct ScatterAdd<R: Real>(Plan<Wide<R>>);

impl<R: Real> Default for ScatterAdd<R> {
    fn default() -> Self {
        Self(Plan::default())
    }
}

impl<R: Real> ScatterAdd<R> {
    /// The scatter-add of these addends to an order slice of such a width.
    pub(super) fn of(addends: Vec<Addend>, width: usize) -> Self {
        let plan = Plan::of(addends, if is_narrow::<R>() { 0 } else { width });
        let mut passes = Vec::with_capacity(plan.passes.len());
        for Pass { result, lanes, signs } in &plan.passes {
            let mut numbers = [R::of(0.0); EIGHT];
            for lane in 0..EIGHT {
                numbers[lane] = R::of(f64::from(signs[lane]));
            }
            passes.push(Pass { result: *result, lanes: *lanes, signs: Wide::<R>::read(&numbers) });
        }
        Self(Plan { blocks: plan.blocks, passes, single: plan.single })
    }

    /// Adds results of `ORDERS` orders to the coefficients from this order on.
    #[inline(always)]
    pub(super) fn add<const ORDERS: usize>(
        &self,
        results: &[[Wide<R>; ORDERS]],
        to: &mut Coefficients<'_, R>,
        order: usize,
    ) {
        let Plan { blocks: [threes, twos, ones], passes, single } = &self.0;
        let mut passes = passes.as_slice();
        if const { !is_narrow::<R>() } {
            for block in threes {
                passes = add_to::<R, ORDERS, 3>(block, passes, results, to, order);
            }
            for block in twos {
                passes = add_to::<R, ORDERS, 2>(block, passes, results, to, order);
            }
            for block in ones {
                passes = add_to::<R, ORDERS, 1>(block, passes, results, to, order);
            }
        }
        for Addend { index, result: number, lane, sign } in single {
            for at in 0..ORDERS {
                let number = in_lane(results[*number][at], *lane);
                to[order + at][*index] += R::of(f64::from(*sign)) * number;
            }
        }
    }
}

/// The number in a lane.
#[inline(always)]
fn in_lane<R: Real>(numbers: Wide<R>, lane: usize) -> R {
    if const { is_narrow::<R>() } {
        let mut single = [R::of(0.0)];
        numbers.write(&mut single);
        return single[0];
    }
    let mut lanes = [R::of(0.0); EIGHT];
    numbers.write(&mut lanes);
    lanes[lane]
}

/// Adds to a block of this number of vectors by the first passes, and returns the passes of the next blocks.
#[inline(always)]
fn add_to<'r, R: Real, const ORDERS: usize, const VECTORS: usize>(
    block: &TargetBlock,
    passes: &'r [Pass<Wide<R>>],
    results: &[[Wide<R>; ORDERS]],
    to: &mut Coefficients<'_, R>,
    order: usize,
) -> &'r [Pass<Wide<R>>] {
    let mut sums = [[Wide::<R>::of(0.0); ORDERS]; VECTORS];
    for vector in 0..VECTORS {
        for at in 0..ORDERS {
            sums[vector][at] = Row::read(&to[order + at][block.begins[vector]..]);
        }
    }
    let (passes, others) = passes.split_at(block.passes);
    for Pass { result: first, lanes, signs } in passes {
        let results = &results[*first..][..VECTORS];
        match lanes {
            None => {
                for vector in 0..VECTORS {
                    for at in 0..ORDERS {
                        sums[vector][at] = results[vector][at].fma(*signs, sums[vector][at]);
                    }
                }
            }
            Some(lanes) => {
                for vector in 0..VECTORS {
                    for at in 0..ORDERS {
                        sums[vector][at] = results[vector][at].permute(lanes).fma(*signs, sums[vector][at]);
                    }
                }
            }
        }
    }
    for vector in 0..VECTORS {
        for at in 0..ORDERS {
            sums[vector][at].write(&mut to[order + at][block.begins[vector]..]);
        }
    }
    others
}

/// The number of result vectors that are added as they are, and of those that are permuted.
#[cfg(test)]
pub(super) fn pass_counts(addends: Vec<Addend>, width: usize) -> [usize; 2] {
    let plan = Plan::of(addends, width);
    let mut passes = plan.passes.iter();
    let mut counts = [0; 2];
    for (blocks, vectors) in plan.blocks.iter().zip([3, 2, 1]) {
        for pass in blocks.iter().flat_map(|block| passes.by_ref().take(block.passes).collect::<Vec<_>>()) {
            counts[usize::from(pass.lanes.is_some())] += vectors;
        }
    }
    counts
}
