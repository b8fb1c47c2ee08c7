//! The iterations of loops, eight side by side.
//!
//! Comes in: which coordinates each iteration reads and moves, and its constants, once per run. Goes out: the same as
//! rows of registers, where eight iterations lie in one. Always true: in which order a coordinate gets its addends
//! follows from the order of iterations and targets, so that bits depend on the text alone.

use super::{
    addends::{Addend, Addends},
    arrangement::{EightIterations, List, alone, dealt, in_lanes},
    places::Places,
    table::{Coefficients, EIGHT, Layout, Wide, is_narrow},
};
use crate::scalar::{real::Real, simd::row::Row};
use alloc::vec::Vec;

/// Numbers side by side, one of each iteration; or that of one iteration.
pub type Abreast<R> = Wide<R>;

/// The same number in all iterations.
#[inline(always)]
pub fn spread<R: Real>(x: R) -> Abreast<R> {
    Abreast::<R>::splat(x)
}

/// Eight iterations side by side, or one, each of which reads so many points and has so many constants; `T` is what
/// they keep.
pub struct Line<R: Real, T, const READS: usize, const CONSTANTS: usize> {
    /// What the iterations keep.
    pub kept: T,
    /// Their constants.
    pub constants: [Abreast<R>; CONSTANTS],
    reads: [Places; READS],
}

impl<R: Real, T, const READS: usize, const CONSTANTS: usize> Line<R, T, READS, CONSTANTS> {
    /// What the iterations read from coefficients: so many components of a point, of the orders from this one on.
    #[inline(always)]
    pub fn read<const COMPONENTS: usize, const AT_ONCE: usize>(
        &self,
        point: usize,
        from: &Coefficients<'_, R>,
        order: usize,
    ) -> [[Abreast<R>; AT_ONCE]; COMPONENTS] {
        self.reads[point].read(from, order)
    }
}

/// So many numbers that iterations have computed, each of the orders that are found at once.
type Found<R, const VALUES: usize, const AT_ONCE: usize> = [[Abreast<R>; AT_ONCE]; VALUES];

/// What a coordinate that iterations move gets from them.
#[derive(Clone, Copy)]
pub struct Target {
    /// Of positions (0) or momenta (1).
    part: usize,
    /// Which of the numbers that an iteration has computed,
    value: usize,
    /// and one, or minus one where it is taken away.
    sign: i8,
}

impl Target {
    /// A position that gets such a number.
    pub const fn position(value: usize) -> Self {
        Self { part: 0, value, sign: 1 }
    }
    /// A momentum that gets such a number.
    pub const fn momentum(value: usize) -> Self {
        Self { part: 1, value, sign: 1 }
    }
    /// The same, with the sign changed.
    pub const fn negated(self) -> Self {
        Self { sign: -self.sign, ..self }
    }
}

/// Which iterations each line computes, whatever they compute in: compiled once, and not with every system.
struct Arrangement {
    lines: Vec<EightIterations>,
    /// Where each line reads, one after the other.
    reads: Vec<Places>,
}

impl Arrangement {
    /// That of iterations which read so many points each, for coordinates that lie so: eight of them side by side, or
    /// one by one in the same order.
    #[cold]
    #[inline(never)]
    fn of(iterations: &List, reads: usize, is_narrow: bool, layout: Layout, targets: &[Target]) -> Self {
        let rows = match layout.is_interleaved() {
            true => in_lanes(iterations),
            // Where one register holds a component of all points, any iterations read from registers.
            false if layout.stride() == EIGHT => {
                dealt(iterations, &targets.iter().map(|target| target.value).collect::<Vec<_>>())
            }
            false => dealt(iterations, &(0..targets.len()).collect::<Vec<_>>()),
        };
        if is_narrow {
            let lines: Vec<usize> = rows.into_iter().flatten().flatten().collect();
            let reads = lines
                .iter()
                .flat_map(|iteration| iterations.reads(*iteration))
                .map(|place| Places::Neighbours(*place))
                .collect();
            return Self { lines: lines.into_iter().map(alone).collect(), reads };
        }
        let places = |row: &EightIterations, read| {
            Places::of(row.map(|iteration| iteration.map(|iteration| iterations.reads(iteration)[read])), layout)
        };
        let reads = rows.iter().flat_map(|row| (0..reads).map(move |read| places(row, read))).collect();
        Self { lines: rows, reads }
    }

    /// What a part of the state gets from iterations that compute so many values each.
    #[cold]
    #[inline(never)]
    fn addends(&self, iterations: &List, targets: &[Target], part: usize, values: usize) -> Vec<Addend> {
        let mut addends = Vec::new();
        for (number, row) in self.lines.iter().enumerate() {
            for (lane, iteration) in row.iter().enumerate().filter_map(|(lane, iteration)| Some((lane, (*iteration)?)))
            {
                for (place, moved) in
                    iterations.targets(iteration).iter().zip(targets).filter(|(_, moved)| moved.part == part)
                {
                    let found = number * values + moved.value;
                    addends.push(Addend { place: *place, found, lane, sign: moved.sign });
                }
            }
        }
        addends
    }
}

/// The iterations of a loop, or of loops inside each other: each reads so many points, has so many constants, and moves
/// so many coordinates by so many values, of so many orders at once; `T` is what eight of them keep.
pub struct Iterations<
    R: Real,
    T,
    const READS: usize,
    const CONSTANTS: usize,
    const TARGETS: usize,
    const VALUES: usize,
    const AT_ONCE: usize,
> {
    iterations: List,
    constants: Vec<[R; CONSTANTS]>,
    lines: Vec<Line<R, T, READS, CONSTANTS>>,
    found: Vec<Found<R, VALUES, AT_ONCE>>,
    /// What positions and momenta get.
    addends: [Addends<R>; 2],
}

impl<
    R: Real,
    T,
    const READS: usize,
    const CONSTANTS: usize,
    const TARGETS: usize,
    const VALUES: usize,
    const AT_ONCE: usize,
> Default for Iterations<R, T, READS, CONSTANTS, TARGETS, VALUES, AT_ONCE>
{
    fn default() -> Self {
        Self {
            iterations: List::default(),
            constants: Vec::new(),
            lines: Vec::new(),
            found: Vec::new(),
            addends: [Addends::default(), Addends::default()],
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
    const AT_ONCE: usize,
> Iterations<R, T, READS, CONSTANTS, TARGETS, VALUES, AT_ONCE>
{
    /// Whether the iterations are not there yet.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }
    /// Another iteration.
    pub fn take(&mut self, reads: [usize; READS], constants: [R; CONSTANTS], targets: [usize; TARGETS]) {
        self.iterations.push(&reads, &targets);
        self.constants.push(constants);
    }
    /// Lays the iterations out in rows, for coordinates that lie so.
    #[cold]
    #[inline(never)]
    pub fn lay_out(&mut self, layout: Layout, targets: [Target; TARGETS]) {
        let iterations = core::mem::take(&mut self.iterations);
        let constants = core::mem::take(&mut self.constants);
        let arrangement = Arrangement::of(&iterations, READS, is_narrow::<R>(), layout, &targets);
        for (number, row) in arrangement.lines.iter().enumerate() {
            // One of the iterations stands in for those that are not there.
            let first = row.iter().flatten().next();
            let mut of_iterations = [Abreast::<R>::of(0.0); CONSTANTS];
            for constant in 0..CONSTANTS {
                let mut numbers = [R::of(0.0); EIGHT];
                for lane in 0..EIGHT {
                    if let Some(iteration) = row[lane].as_ref().or(first) {
                        numbers[lane] = constants[*iteration][constant];
                    }
                }
                of_iterations[constant] = Abreast::<R>::read(&numbers);
            }
            let mut reads = [Places::Neighbours(0); READS];
            reads.copy_from_slice(&arrangement.reads[number * READS..][..READS]);
            self.lines.push(Line { kept: T::default(), constants: of_iterations, reads });
            self.found.push([[Abreast::<R>::of(0.0); AT_ONCE]; VALUES]);
        }
        for (part, addends) in self.addends.iter_mut().enumerate() {
            *addends = Addends::of(arrangement.addends(&iterations, &targets, part, VALUES), layout.width());
        }
    }
    /// The rows of iterations, and where each puts down what it has computed.
    #[inline(always)]
    pub fn rows(
        &mut self,
    ) -> impl Iterator<Item = (&mut Line<R, T, READS, CONSTANTS>, &mut Found<R, VALUES, AT_ONCE>)> {
        self.lines.iter_mut().zip(&mut self.found)
    }
    /// Adds what all iterations have computed to the coefficients of positions, of the orders from this one on.
    #[inline(always)]
    pub fn add_to_positions(&self, q: &mut Coefficients<'_, R>, order: usize) {
        self.addends[0].add(self.found.as_flattened(), q, order);
    }
    /// Adds what all iterations have computed to the coefficients of momenta, of the orders from this one on.
    #[inline(always)]
    pub fn add_to_momenta(&self, p: &mut Coefficients<'_, R>, order: usize) {
        self.addends[1].add(self.found.as_flattened(), p, order);
    }
}

#[cfg(test)]
mod tests {
    use super::{
        super::{
            addends::rounds,
            table::{Layout, Table},
        },
        *,
    };
    use crate::scalar::{
        fma::{Avx512, Fma, Fused},
        instruction_set::InstructionSet,
    };

    /// Numbers with so few digits that sums of products are exact, in whatever order.
    fn number(seed: usize) -> f64 {
        (seed * 7 % 31) as f64 / 8.0 - 2.0
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
            let list: Vec<[usize; 2]> = points.into_iter().map(|points| points.map(|i| layout.place(i, 0))).collect();
            let mut iterations: Iterations<R, (), 2, 1, 4, 3, 2> = Iterations::default();
            assert!(iterations.is_empty());
            for (seed, [i, j]) in list.iter().enumerate() {
                iterations.take([*i, *j], [R::of(number(seed))], [*i, *j, *i, *j]);
            }
            let momenta = [Target::momentum(0), Target::momentum(1)];
            let positions = [Target::position(2), Target::position(2).negated()];
            iterations.lay_out(layout, [momenta[0], momenta[1], positions[0], positions[1]]);
            let together = if is_narrow::<R>() { 1 } else { EIGHT };
            assert!(iterations.rows().count() >= list.len().div_ceil(together), "{name}");
            let (mut of_q, mut of_p) = (Table::new(layout), Table::new(layout));
            let (mut q, mut p) = (of_q.of(layout), of_p.of(layout));
            let from: Vec<R> = (0..width).map(|place| R::of(number(place + 100))).collect();
            for order in [3, 4] {
                q[order].copy_from_slice(&from);
                p[order].copy_from_slice(&from);
            }
            for (row, found) in iterations.rows() {
                let [[[a]], [[b]]] = [row.read(0, &q, 3), row.read(1, &q, 3)];
                let [constant] = row.constants;
                *found = [[a * b, b], [(a - b) * constant, a - b], [spread(R::of(2.0)) * a, a * a]];
            }
            iterations.add_to_positions(&mut q, 3);
            iterations.add_to_momenta(&mut p, 3);

            // What an iteration that reads these places, with its constant, adds where.
            type Adds<'a, R> = &'a dyn Fn([usize; 2], R) -> (usize, R);
            let after = |addends: &[Adds<'_, R>]| {
                let mut to = from.clone();
                for addend in addends {
                    for (iteration, places) in list.iter().enumerate() {
                        let (place, value) = addend(*places, R::of(number(iteration)));
                        to[place] += value;
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
            let bits = |numbers: &[R]| -> Vec<u64> { numbers.iter().map(|x| x.lane(0).to_bits()).collect() };
            for (found, expected) in [&q[3], &q[4], &p[3], &p[4]].into_iter().zip(&expected) {
                assert_eq!(bits(found), bits(expected), "{name}, interleaved: {interleaved}");
            }
        }
    }

    #[test]
    fn iterations_side_by_side_have_the_sums_of_a_loop() {
        iterations_are_those_of_a_loop::<f64>();
        iterations_are_those_of_a_loop::<f32>();
        let available = InstructionSet::available();
        if available.contains(&InstructionSet::Fused) {
            iterations_are_those_of_a_loop::<Fused<f64, Fma>>();
            iterations_are_those_of_a_loop::<Fused<f32, Fma>>();
        }
        if available.contains(&InstructionSet::Avx512) {
            iterations_are_those_of_a_loop::<Fused<f64, Avx512>>();
            iterations_are_those_of_a_loop::<Fused<f32, Avx512>>();
        }
    }

    #[test]
    fn a_chain_reads_and_moves_whole_registers() {
        let layout = Layout::of::<Vec<f64>>(32, true);
        let mut iterations = List::default();
        for i in 0..31 {
            let places = [i, i + 1].map(|i| layout.place(i, 0));
            iterations.push(&places, &places);
        }
        let targets = [Target::momentum(0), Target::momentum(0).negated()];
        let arrangement = Arrangement::of(&iterations, 2, false, layout, &targets);
        let reads = &arrangement.reads;
        let whole = reads.iter().filter(|places| matches!(places, Places::Neighbours(begin) if begin % EIGHT == 0));
        // All but those of the neighbours of the last register, which are one lane further on in the first.
        assert_eq!((reads.len(), whole.count()), (8, 7));
        // One number is added and one taken away, both in all lanes but where the chain ends and at the seam.
        assert_eq!(rounds(arrangement.addends(&iterations, &targets, 1, 1), layout.width()), [6, 2]);
    }
}
