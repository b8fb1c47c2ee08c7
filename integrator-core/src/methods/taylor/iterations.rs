//! The iterations of loops in blocks of eight, one in each lane of vectors.
//!
//! Comes in: the indices that each iteration reads and moves, and its constants, once per run. Goes out: blocks with
//! their access patterns, and the scatter-add of their results. Always true: the order in which a coordinate gets its
//! addends follows from the order of iterations and targets, so that bits depend on the text alone.

use super::{
    access_pattern::AccessPattern,
    scatter_add::{Addend, ScatterAdd},
    schedule::{BlockLanes, IterationList, by_lane, list_schedule, single},
    table::{Coefficients, EIGHT, Layout, Wide, is_narrow},
};
use crate::scalar::{real::Real, simd::row::Row};
use alloc::vec::Vec;

/// Returns a block with the same number in all iterations.
#[inline(always)]
pub fn splat<R: Real, V: Row<Wide<R>>>(x: R) -> V {
    V::splat(Wide::<R>::splat(x))
}

/// A block of eight iterations, or one, each of which reads this number of points and has this number of constants; `T`
/// is their record.
pub struct IterationBlock<R: Real, T, const READS: usize, const CONSTANTS: usize> {
    /// The record of the iterations.
    pub kept: T,
    /// The constants of the iterations.
    pub constants: [Wide<R>; CONSTANTS],
    reads: [AccessPattern; READS],
}

impl<R: Real, T, const READS: usize, const CONSTANTS: usize> IterationBlock<R, T, READS, CONSTANTS> {
    /// The coefficients of a point that the iterations read: all components, of the orders from this one on.
    #[inline(always)]
    pub fn read<const COMPONENTS: usize, const ORDERS: usize>(
        &self,
        point: usize,
        from: &Coefficients<'_, R>,
        order: usize,
    ) -> [[Wide<R>; ORDERS]; COMPONENTS] {
        self.reads[point].read(from, order)
    }
}

/// The values that iterations compute, each of this number of orders.
type Results<R, const VALUES: usize, const ORDERS: usize> = [[Wide<R>; ORDERS]; VALUES];

/// A coordinate that each iteration moves.
#[derive(Clone, Copy)]
pub struct Target {
    /// The half that the coordinate belongs to: 0 for positions, 1 for momenta.
    half: usize,
    /// The number of the value that the coordinate gets.
    value: usize,
    /// The sign of the value.
    sign: i8,
}

impl Target {
    /// A position that gets a value.
    pub const fn position(value: usize) -> Self {
        Self { half: 0, value, sign: 1 }
    }
    /// A momentum that gets a value.
    pub const fn momentum(value: usize) -> Self {
        Self { half: 1, value, sign: 1 }
    }
    /// Returns this target with the sign changed.
    pub const fn negated(self) -> Self {
        Self { sign: -self.sign, ..self }
    }
}

/// The schedule of iterations, independent of the scalar: compiled once, and not with every system.
struct Schedule {
    blocks: Vec<BlockLanes>,
    /// The access patterns of each block, one after the other.
    reads: Vec<AccessPattern>,
}

impl Schedule {
    /// The schedule of iterations which read this number of points each: in blocks of eight, or one by one in the same
    /// order.
    #[cold]
    #[inline(never)]
    fn of(iterations: &IterationList, reads: usize, is_narrow: bool, layout: Layout, targets: &[Target]) -> Self {
        let blocks = match layout.is_interleaved() {
            true => by_lane(iterations),
            // Where one vector holds a component of all points, no iterations need a gather.
            false if layout.stride() == EIGHT => {
                list_schedule(iterations, &targets.iter().map(|target| target.value).collect::<Vec<_>>())
            }
            false => list_schedule(iterations, &(0..targets.len()).collect::<Vec<_>>()),
        };
        if is_narrow {
            let lanes: Vec<usize> = blocks.into_iter().flatten().flatten().collect();
            let reads = lanes
                .iter()
                .flat_map(|iteration| iterations.reads(*iteration))
                .map(|index| AccessPattern::Contiguous(*index))
                .collect();
            return Self { blocks: lanes.into_iter().map(single).collect(), reads };
        }
        let pattern = |block: &BlockLanes, read| {
            AccessPattern::of(
                block.map(|iteration| iteration.map(|iteration| iterations.reads(iteration)[read])),
                layout,
            )
        };
        let reads = blocks.iter().flat_map(|block| (0..reads).map(move |read| pattern(block, read))).collect();
        Self { blocks, reads }
    }

    /// The addends of positions or momenta from iterations that compute this number of values each.
    #[cold]
    #[inline(never)]
    fn addends(&self, iterations: &IterationList, targets: &[Target], half: usize, values: usize) -> Vec<Addend> {
        let mut addends = Vec::new();
        for (number, block) in self.blocks.iter().enumerate() {
            for (lane, iteration) in
                block.iter().enumerate().filter_map(|(lane, iteration)| Some((lane, (*iteration)?)))
            {
                for (index, moved) in
                    iterations.targets(iteration).iter().zip(targets).filter(|(_, moved)| moved.half == half)
                {
                    let result = number * values + moved.value;
                    addends.push(Addend { index: *index, result, lane, sign: moved.sign });
                }
            }
        }
        addends
    }
}

/// The iterations of a loop, or of nested loops: each reads this number of points, has this number of constants, and
/// moves this number of coordinates by this number of values, of this number of orders per call; `T` is the record of a
/// block.
pub struct Iterations<
    R: Real,
    T,
    const READS: usize,
    const CONSTANTS: usize,
    const TARGETS: usize,
    const VALUES: usize,
    const ORDERS: usize,
> {
    iterations: IterationList,
    constants: Vec<[R; CONSTANTS]>,
    blocks: Vec<IterationBlock<R, T, READS, CONSTANTS>>,
    results: Vec<Results<R, VALUES, ORDERS>>,
    /// The scatter-adds to positions and to momenta.
    sums: [ScatterAdd<R>; 2],
}

impl<
    R: Real,
    T,
    const READS: usize,
    const CONSTANTS: usize,
    const TARGETS: usize,
    const VALUES: usize,
    const ORDERS: usize,
> Default for Iterations<R, T, READS, CONSTANTS, TARGETS, VALUES, ORDERS>
{
    fn default() -> Self {
        Self {
            iterations: IterationList::default(),
            constants: Vec::new(),
            blocks: Vec::new(),
            results: Vec::new(),
            sums: [ScatterAdd::default(), ScatterAdd::default()],
        }
    }
}

impl<
    R: Real,
    T: Default,
    const READS: usize,
    const CONSTANTS: usize,
    const TARGETS: usize,
    const VALUES: usize,
    const ORDERS: usize,
> Iterations<R, T, READS, CONSTANTS, TARGETS, VALUES, ORDERS>
{
    /// Whether the blocks have not been built yet.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }
    /// Appends an iteration.
    pub fn push(&mut self, reads: [usize; READS], constants: [R; CONSTANTS], targets: [usize; TARGETS]) {
        self.iterations.push(&reads, &targets);
        self.constants.push(constants);
    }
    /// Builds the blocks, for coordinates in this layout.
    #[cold]
    #[inline(never)]
    pub fn build(&mut self, layout: Layout, targets: [Target; TARGETS]) {
        let iterations = core::mem::take(&mut self.iterations);
        let constants = core::mem::take(&mut self.constants);
        let schedule = Schedule::of(&iterations, READS, is_narrow::<R>(), layout, &targets);
        for (number, block) in schedule.blocks.iter().enumerate() {
            // Lanes without an iteration have the constants of the first one.
            let first = block.iter().flatten().next();
            let mut of_iterations = [Wide::<R>::of(0.0); CONSTANTS];
            for constant in 0..CONSTANTS {
                let mut numbers = [R::of(0.0); EIGHT];
                for lane in 0..EIGHT {
                    if let Some(iteration) = block[lane].as_ref().or(first) {
                        numbers[lane] = constants[*iteration][constant];
                    }
                }
                of_iterations[constant] = Wide::<R>::read(&numbers);
            }
            let mut reads = [AccessPattern::Contiguous(0); READS];
            reads.copy_from_slice(&schedule.reads[number * READS..][..READS]);
            self.blocks.push(IterationBlock { kept: T::default(), constants: of_iterations, reads });
            self.results.push([[Wide::<R>::of(0.0); ORDERS]; VALUES]);
        }
        for (half, sums) in self.sums.iter_mut().enumerate() {
            *sums = ScatterAdd::of(schedule.addends(&iterations, &targets, half, VALUES), layout.width());
        }
    }
    /// The blocks of iterations, and their results.
    #[inline(always)]
    pub fn blocks(
        &mut self,
    ) -> impl Iterator<Item = (&mut IterationBlock<R, T, READS, CONSTANTS>, &mut Results<R, VALUES, ORDERS>)> {
        self.blocks.iter_mut().zip(&mut self.results)
    }
    /// Adds the results of all iterations to the coefficients of positions, of the orders from this one on.
    #[inline(always)]
    pub fn add_to_positions(&self, q: &mut Coefficients<'_, R>, order: usize) {
        self.sums[0].add(self.results.as_flattened(), q, order);
    }
    /// Adds the results of all iterations to the coefficients of momenta, of the orders from this one on.
    #[inline(always)]
    pub fn add_to_momenta(&self, p: &mut Coefficients<'_, R>, order: usize) {
        self.sums[1].add(self.results.as_flattened(), p, order);
    }
}

#[cfg(test)]
mod tests {
    use super::{
        super::{
            scatter_add::pass_counts,
            table::{Layout, Table},
        },
        *,
    };
    use crate::scalar::{
        dual::Dual,
        fma::{Avx512, Fma, Fused},
        instruction_set::InstructionSet,
    };

    /// Numbers with so few digits that sums of products are exact, in whatever order; others in each lane.
    fn number<R: Real>(seed: usize) -> R {
        R::state(&|lane| ((seed + 11 * lane) * 7 % 31) as f64 / 8.0 - 2.0)
    }

    /// The iterations of two loops: what each reads and the two coordinates that it moves.
    fn lists() -> Vec<(&'static str, usize, Vec<[usize; 2]>)> {
        let pairs = |n: usize| (0..n).flat_map(move |i| (0..i).map(move |j| [i, j])).collect();
        vec![
            ("neighbours", 32, (0..31).map(|i| [i, i + 1]).collect()),
            ("a ring", 24, (0..19).map(|i| [i, (i + 1) % 19]).collect()),
            ("pairs of six", 8, pairs(6)),
            ("pairs of eleven", 16, pairs(11)),
            ("one coordinate", 8, vec![[3, 3]; 11]),
            ("anywhere", 64, (0..21).map(|i| [i * 37 % 61, i * 53 % 64]).collect()),
            ("few coordinates", 4, pairs(4)),
        ]
    }

    /// The sums are those of a loop.
    fn iterations_are_those_of_a_loop<R: Real>() {
        for (case, interleaved) in lists().into_iter().flat_map(|list| [(list.clone(), false), (list, true)]) {
            let (name, width, points) = case;
            let layout = Layout::of::<Vec<f64>>(width, interleaved);
            let list: Vec<[usize; 2]> = points.into_iter().map(|points| points.map(|i| layout.index(i, 0))).collect();
            let mut iterations: Iterations<R, (), 2, 1, 4, 3, 2> = Iterations::default();
            assert!(iterations.is_empty());
            for (seed, [i, j]) in list.iter().enumerate() {
                iterations.push([*i, *j], [number(seed)], [*i, *j, *i, *j]);
            }
            let momenta = [Target::momentum(0), Target::momentum(1)];
            let positions = [Target::position(2), Target::position(2).negated()];
            iterations.build(layout, [momenta[0], momenta[1], positions[0], positions[1]]);
            let together = if is_narrow::<R>() { 1 } else { EIGHT };
            assert!(iterations.blocks().count() >= list.len().div_ceil(together), "{name}");
            let (mut of_q, mut of_p) = (Table::new(layout), Table::new(layout));
            let (mut q, mut p) = (of_q.of(layout, R::of(1.0)), of_p.of(layout, R::of(1.0)));
            let from: Vec<R> = (0..width).map(|index| number(index + 100)).collect();
            for order in [3, 4] {
                q[order].copy_from_slice(&from);
                p[order].copy_from_slice(&from);
            }
            for (block, results) in iterations.blocks() {
                let [[[a]], [[b]]] = [block.read(0, &q, 3), block.read(1, &q, 3)];
                let [constant] = block.constants;
                *results = [[a * b, b], [(a - b) * constant, a - b], [splat::<R, Wide<R>>(R::of(2.0)) * a, a * a]];
            }
            iterations.add_to_positions(&mut q, 3);
            iterations.add_to_momenta(&mut p, 3);

            // What an iteration that reads these indices, with its constant, adds where.
            type Adds<'a, R> = &'a dyn Fn([usize; 2], R) -> (usize, R);
            let after = |addends: &[Adds<'_, R>]| {
                let mut to = from.clone();
                for addend in addends {
                    for (iteration, indices) in list.iter().enumerate() {
                        let (index, value) = addend(*indices, number(iteration));
                        to[index] += value;
                    }
                }
                to
            };
            let x = |i: usize| from[i];
            let expected = [
                after(&[&|[i, _], _| (i, R::of(2.0) * x(i)), &|[i, j], _| (j, R::of(-2.0) * x(i))]),
                after(&[&|[i, _], _| (i, x(i) * x(i)), &|[i, j], _| (j, -(x(i) * x(i)))]),
                after(&[&|[i, j], _| (i, x(i) * x(j)), &|[i, j], constant| (j, (x(i) - x(j)) * constant)]),
                after(&[&|[i, j], _| (i, x(j)), &|[i, j], _| (j, x(i) - x(j))]),
            ];
            let bits = |numbers: &[R]| -> Vec<u64> {
                numbers.iter().flat_map(|x| (0..R::LANES).map(|lane| x.lane(lane).to_bits())).collect()
            };
            for (found, expected) in [&q[3], &q[4], &p[3], &p[4]].into_iter().zip(&expected) {
                assert_eq!(bits(found), bits(expected), "{name}, interleaved: {interleaved}");
            }
        }
    }

    #[test]
    fn blocks_of_iterations_have_the_sums_of_a_loop() {
        iterations_are_those_of_a_loop::<f64>();
        iterations_are_those_of_a_loop::<f32>();
        let available = InstructionSet::available();
        if available.contains(&InstructionSet::Fused) {
            iterations_are_those_of_a_loop::<Fused<f64, Fma>>();
            iterations_are_those_of_a_loop::<Fused<f32, Fma>>();
            iterations_are_those_of_a_loop::<Dual<Fused<f64, Fma>>>();
            iterations_are_those_of_a_loop::<Dual<Fused<f32, Fma>, 4>>();
        }
        if available.contains(&InstructionSet::Avx512) {
            iterations_are_those_of_a_loop::<Fused<f64, Avx512>>();
            iterations_are_those_of_a_loop::<Fused<f32, Avx512>>();
            iterations_are_those_of_a_loop::<Dual<Fused<f64, Avx512>>>();
            iterations_are_those_of_a_loop::<Dual<Fused<f64, Avx512>, 4>>();
        }
    }

    #[test]
    fn a_chain_reads_and_moves_whole_vectors() {
        let layout = Layout::of::<Vec<f64>>(32, true);
        let mut iterations = IterationList::default();
        for i in 0..31 {
            let indices = [i, i + 1].map(|i| layout.index(i, 0));
            iterations.push(&indices, &indices);
        }
        let targets = [Target::momentum(0), Target::momentum(0).negated()];
        let schedule = Schedule::of(&iterations, 2, false, layout, &targets);
        let reads = &schedule.reads;
        let whole =
            reads.iter().filter(|pattern| matches!(pattern, AccessPattern::Contiguous(begin) if begin % EIGHT == 0));
        // All but those of the neighbours of the last vector, which are shifted by one lane in the first vector.
        assert_eq!((reads.len(), whole.count()), (8, 7));
        // One value is added and one subtracted, both in all lanes but where the chain ends and at the seam.
        assert_eq!(pass_counts(schedule.addends(&iterations, &targets, 1, 1), layout.width()), [6, 2]);
    }
}
