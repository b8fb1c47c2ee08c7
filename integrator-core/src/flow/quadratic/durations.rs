//! The durations of a flow, in the order in which they recur.

use alloc::vec::Vec;

/// The largest number of uses that are remembered. A composition has fewer stages; after more, the memory is cleared.
const MOST: usize = 1024;

/// The durations of a flow, which compositions repeat in their order: at each use, the one that came next the last time
/// is looked at first.
#[derive(Clone, Debug, Default)]
pub(super) struct Durations {
    uses: Vec<Use>,
    last: usize,
    distinct: usize,
}

/// A duration that follows another one.
#[derive(Clone, Copy, Debug)]
struct Use {
    duration: f64,
    /// The duration before it.
    before: f64,
    /// The number of the duration among the distinct ones.
    number: usize,
    /// The use that came next.
    next: usize,
}

/// The state of a duration in the list of known ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Known {
    /// The duration is known, with this number.
    Before,
    /// The duration is new.
    New,
    /// The duration is new, and the others are forgotten, since there are too many.
    Anew,
}

impl Durations {
    /// The number of the duration that comes next, if it is this one.
    #[inline(always)]
    pub(super) fn next(&mut self, duration: f64) -> Option<usize> {
        let next = self.uses.get(self.last)?.next;
        let found = self.uses.get(next)?;
        if !same(found.duration, duration) {
            return None;
        }
        self.last = next;
        Some(found.number)
    }

    /// The number of a duration that was not expected.
    pub(super) fn turn(&mut self, duration: f64) -> (usize, Known) {
        let mut known = Known::Before;
        if self.uses.len() == MOST {
            *self = Self::default();
            known = Known::Anew;
        }
        let before = self.uses.get(self.last).map_or(0.0, |last| last.duration);
        let found = self.uses.iter().position(|known| same(known.duration, duration) && same(known.before, before));
        let place = found.unwrap_or_else(|| {
            let number = self.uses.iter().find(|known| same(known.duration, duration)).map(|known| known.number);
            let number = number.unwrap_or_else(|| {
                if known == Known::Before {
                    known = Known::New;
                }
                self.distinct += 1;
                self.distinct - 1
            });
            self.uses.push(Use { duration, before, number, next: 0 });
            self.uses.len() - 1
        });
        if let Some(last) = self.uses.get_mut(self.last) {
            last.next = place;
        }
        self.last = place;
        (self.uses[place].number, known)
    }
}

/// Whether two durations have the same bits.
#[inline(always)]
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits()
}
