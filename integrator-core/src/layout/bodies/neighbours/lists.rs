//! Lists of neighbours: for each body those within a radius, in the order of their numbers.
//!
//! Eight bodies that are near each other are a row, and the lists of a row are one after the other in steps: the first
//! neighbours of all eight, then the second ones. Always true: which bodies make a row depends on where they are, and
//! changes no bit: every lane adds up its own neighbours, in the order of their numbers.

use super::{candidates::Candidates, cells::Cells};
use crate::{
    layout::bodies::load_store::WIDTH,
    scalar::{
        fma::{Avx512, Fma, Fused},
        instruction_set::InstructionSet,
        real::{Kernel, Real},
    },
    threads::{Job, at_once},
};
use alloc::{boxed::Box, vec, vec::Vec};
use core::{marker::PhantomData, ops::Range};

/// The most portions that lists are made in, and that threads take.
pub(crate) const PORTIONS: usize = 64;

/// The fewest rows in a portion: a few times what it takes to hand them to a thread that is awake.
const LEAST_ROWS: usize = 32;

/// The most numbers in all lists: a gibibyte. Where there are more, all pairs are summed.
const MOST_NUMBERS: usize = 1 << 28;

/// The lists of all bodies.
pub(crate) struct Lists {
    /// The slot of each body.
    pub(crate) slot_of: Vec<u32>,
    /// The lists; none if lists would be too long, because the bodies are too close to each other.
    pub(crate) portions: Option<Vec<Portion>>,
}

/// The lists of consecutive rows.
#[derive(Default)]
pub(crate) struct Portion {
    pub(crate) rows: Range<usize>,
    pub(crate) heads: Vec<Head>,
    /// The slots of neighbours, one for each lane in a step.
    pub(crate) steps: Vec<[u32; WIDTH]>,
}

/// The lists of a row.
#[derive(Clone, Copy)]
pub(crate) struct Head {
    /// The first of its steps.
    pub(crate) first: usize,
    /// The number of neighbours of each lane.
    pub(crate) counts: [u32; WIDTH],
    /// The number of neighbours that have lower numbers.
    pub(crate) before: [u32; WIDTH],
}

impl Lists {
    /// Lists this number of bodies that are within a radius of each other in any of the members, in whose cells they
    /// are; in the memory of old lists.
    pub(crate) fn new<const D: usize>(bodies: usize, cells: &[Cells<D>], threads: usize, old: Option<Self>) -> Self {
        let rows = bodies.div_ceil(WIDTH);
        let each = rows.div_ceil(PORTIONS).max(LEAST_ROWS);
        let mut portions = old.and_then(|old| old.portions).unwrap_or_default();
        portions.resize_with(rows.div_ceil(each), Portion::default);
        for (number, portion) in portions.iter_mut().enumerate() {
            portion.rows = number * each..rows.min((number + 1) * each);
            portion.heads.clear();
            portion.steps.clear();
        }
        let mut slot_of = vec![0; bodies];
        for (slot, body) in cells.iter().take(1).flat_map(|cells| &cells.body_of).enumerate() {
            slot_of[*body as usize] = slot as u32;
        }
        let most = (bodies / 4).min(MOST_NUMBERS / bodies.max(1)) * WIDTH;
        let slots = &slot_of[..];
        let share = portions.len().div_ceil(threads.max(1)).max(1);
        let mut jobs = Vec::<Job<'_>>::with_capacity(portions.len().div_ceil(share));
        for portions in portions.chunks_mut(share) {
            jobs.push(Box::new(move || {
                for portion in portions {
                    let most = most * portion.rows.len() / WIDTH;
                    match InstructionSet::chosen() {
                        InstructionSet::Baseline => f32::enter(Fill::<f32, D>::new(portion, cells, slots, most)),
                        InstructionSet::Fused => {
                            Fused::<f32, Fma>::enter(Fill::<Fused<f32, Fma>, D>::new(portion, cells, slots, most));
                        }
                        InstructionSet::Avx512 => {
                            Fused::<f32, Avx512>::enter(Fill::<Fused<f32, Avx512>, D>::new(
                                portion, cells, slots, most,
                            ));
                        }
                    }
                }
            }));
        }
        at_once(jobs);
        if portions.iter().all(|portion| portion.heads.len() == portion.rows.len()) {
            return Self { slot_of, portions: Some(portions) };
        }
        // All others are taken in the order of their slots, which has to be that of their numbers.
        Self::none(bodies)
    }

    /// All bodies in the order of their numbers, without lists.
    pub(crate) fn none(bodies: usize) -> Self {
        Self { slot_of: (0..bodies as u32).collect(), portions: None }
    }

    /// The steps that have the neighbours of the body in a slot, in its lane; `None` without lists.
    #[inline(always)]
    pub(crate) fn of_slot(&self, slot: usize) -> Option<&[[u32; WIDTH]]> {
        let portions = self.portions.as_ref()?;
        let (row, lane) = (slot / WIDTH, slot % WIDTH);
        let portion = &portions[row / portions[0].rows.len()];
        let head = &portion.heads[row - portion.rows.start];
        Some(&portion.steps[head.first..][..head.counts[lane] as usize])
    }
}

/// Makes the lists of a portion, or some of them where all would be more than `most` steps.
struct Fill<'l, T, const D: usize> {
    portion: &'l mut Portion,
    cells: &'l [Cells<D>],
    slots: &'l [u32],
    most: usize,
    scalar: PhantomData<T>,
}

impl<'l, T, const D: usize> Fill<'l, T, D> {
    fn new(portion: &'l mut Portion, cells: &'l [Cells<D>], slots: &'l [u32], most: usize) -> Self {
        Self { portion, cells, slots, most, scalar: PhantomData }
    }
}

impl<T: Real, const D: usize> Kernel for Fill<'_, T, D> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { portion: Portion { rows, heads, steps }, cells, slots, most, .. } = self;
        let bodies = slots.len();
        let mut candidates = Candidates::<T, D>::new();
        let mut near: [Vec<u32>; WIDTH] = core::array::from_fn(|_| Vec::new());
        for row in rows.clone() {
            let (mut counts, mut before) = ([0; WIDTH], [0; WIDTH]);
            for lane in 0..WIDTH {
                let (slot, near) = (row * WIDTH + lane, &mut near[lane]);
                if slot >= bodies {
                    continue;
                }
                [counts[lane], before[lane]] = match cells {
                    [cells] => {
                        candidates.gather(cells, slot);
                        candidates.near(slot, near)
                    }
                    cells => near_in_any(cells, slots, cells[0].body_of[slot], near),
                };
            }
            let longest = counts.into_iter().max().unwrap_or(0) as usize;
            let first = steps.len();
            heads.push(Head { first, counts, before });
            if first + longest > most {
                heads.clear();
                return;
            }
            steps.resize(first + longest, [0; WIDTH]);
            let steps = &mut steps[first..];
            for (lane, near) in near.iter().enumerate() {
                let (listed, rest) = steps.split_at_mut(counts[lane] as usize);
                for (step, slot) in listed.iter_mut().zip(near) {
                    step[lane] = *slot;
                }
                // A lane that has no more neighbours repeats its last one, or itself; nothing of it is added.
                let own = (row * WIDTH + lane).min(bodies - 1) as u32;
                let last = listed.last().map_or(own, |step| step[lane]);
                rest.iter_mut().for_each(|step| step[lane] = last);
            }
        }
    }
}

/// Writes the slots of the bodies that are near one in any member, in the order of their numbers, and returns how many they
/// are, and how many have lower ones.
fn near_in_any<const D: usize>(cells: &[Cells<D>], slots: &[u32], body: u32, near: &mut Vec<u32>) -> [u32; 2] {
    near.clear();
    for cells in cells {
        cells.near(body, near);
    }
    near.sort_unstable();
    near.dedup();
    let before = near.partition_point(|other| *other < body);
    for number in near.iter_mut() {
        *number = slots[*number as usize];
    }
    [near.len(), before].map(|number| number as u32)
}
