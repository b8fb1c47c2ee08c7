//! A composition as an array of numbers with the step folded in, for hand-written steppers.

use integrator_core::{Lead, Scheme, Stage};

/// The two flows of a hand-written stepper, each for a given duration.
pub(crate) trait HandWritten {
    fn drift(&mut self, t: f64);
    fn kick(&mut self, t: f64);
    /// A drift and then a kick.
    #[inline(always)]
    fn row(&mut self, [drift, kick]: [f64; 2]) {
        self.drift(drift);
        self.kick(kick);
    }
}

/// The stages of a composition, multiplied by the step.
pub struct Plan {
    kick_first: bool,
    opening: [f64; 2],
    cycle: Vec<[f64; 2]>,
    closing: f64,
}

impl Plan {
    /// Returns the plan of a composition. Stages are merged across steps, as in a run.
    pub fn of<X: Scheme>(h: f64) -> Self {
        let stages = X::STAGES;
        let kick_first = stages.lead == Lead::Kick;
        let row = |stage: &Stage| {
            if kick_first { [h * stage.kick, h * stage.drift] } else { [h * stage.drift, h * stage.kick] }
        };
        Self {
            kick_first,
            opening: row(&stages.opening),
            cycle: stages.cycle.iter().map(row).collect(),
            closing: row(&stages.closing)[0],
        }
    }

    /// Returns the opening half drift of Verlet, the kick and the drift of the loop, and the closing drift.
    ///
    /// # Panics
    /// If the composition is not `Verlet`.
    pub(crate) fn verlet(&self) -> [f64; 4] {
        let [[drift, kick]] = self.cycle[..] else { panic!("one kick per step") };
        assert!(!self.kick_first, "drift, kick, drift");
        [self.opening[0], kick, drift, self.closing]
    }

    /// Returns the first row, the rows of a cycle, and the closing drift.
    ///
    /// # Panics
    /// If the composition begins with a kick.
    pub(crate) fn drifts_first(&self) -> ([f64; 2], &[[f64; 2]], f64) {
        assert!(!self.kick_first, "a drift, then a kick");
        (self.opening, &self.cycle, self.closing)
    }

    /// Takes `steps` steps, at least one.
    #[inline(always)]
    pub(crate) fn march(&self, by_hand: &mut impl HandWritten, steps: u64) {
        if self.kick_first {
            self.march_leading(&mut Swapped(by_hand), steps);
        } else {
            self.march_leading(by_hand, steps);
        }
    }

    /// Takes the steps of a composition that begins with a drift.
    #[inline(always)]
    fn march_leading(&self, by_hand: &mut impl HandWritten, steps: u64) {
        by_hand.row(self.opening);
        for row in &self.cycle[1..] {
            by_hand.row(*row);
        }
        if let [only] = self.cycle[..] {
            for _ in 1..steps {
                by_hand.row(only);
            }
        } else {
            for _ in 1..steps {
                for row in &self.cycle {
                    by_hand.row(*row);
                }
            }
        }
        by_hand.drift(self.closing);
    }
}

/// A stepper with drift and kick exchanged.
struct Swapped<'t, T>(&'t mut T);

impl<T: HandWritten> HandWritten for Swapped<'_, T> {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        self.0.kick(t);
    }
    #[inline(always)]
    fn kick(&mut self, t: f64) {
        self.0.drift(t);
    }
}
