//! Invalid input: errors and no panics.

use integrator_bench::problems::{HenonHeiles, Kepler, Pendulum};
use integrator_core::{Coords, check, prelude::*};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Extreme, infinite and NaN values.
const NUMBERS: [f64; 14] = [
    0.0,
    -0.0,
    1.0,
    -1.5,
    5e-324,
    1e-310,
    f64::MIN_POSITIVE,
    1e-150,
    1e150,
    f64::MAX,
    f64::MIN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

/// Sites with a number known at run time.
struct Row;

#[hamiltonian]
impl Row {
    fn kinetic(&self, p: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += p[i] * p[i] / 2.0;
        }
        energy
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            energy += q[i].powi(4) / 4.0;
        }
        for i in 1..q.len() {
            energy += (q[i] - q[i - 1]).powi(2) / 2.0;
        }
        energy
    }
}

/// Returns how many of `rounds` rounds of calls panic.
pub(crate) fn panics(rounds: u64) -> u64 {
    let mut numbers = Numbers(0x9e37_79b9_7f4a_7c15);
    let round = |numbers: &mut Numbers| {
        let h = numbers.next();
        let pair = |numbers: &mut Numbers| [numbers.next(), numbers.next()];
        let pendulum = Pendulum { mass: numbers.next(), length: numbers.next(), gravity: numbers.next() };
        let (q, p) = (pair(numbers), pair(numbers));
        let single = |x: [f64; 2]| x.map(|x| x as f32);
        calls(&pendulum, Phase::new([q[0]], [p[0]]), h, numbers);
        calls(&Kepler, Phase::new(q, p), h, numbers);
        calls(&HenonHeiles, Phase::compensated(q, p), h, numbers);
        calls(&Kepler, Phase::new(single(q), single(p)), h, numbers);
        calls(&HenonHeiles, Phase::reversible(q, p, numbers.next()), h, numbers);
        let sites = |numbers: &mut Numbers| -> Vec<f64> { (0..numbers.below(4)).map(|_| numbers.next()).collect() };
        calls(&Row, Phase::new(sites(numbers), sites(numbers)), h, numbers);
        let members = (0..numbers.below(20)).map(|_| (Kepler, Phase::new(pair(numbers), pair(numbers))));
        if let Ok(mut swarm) = Ensemble::new(Yoshida4, members.collect::<Vec<_>>(), h) {
            // The error lists failed members; which ones they are does not matter here.
            let _ = swarm.advance(numbers.below(3000));
            swarm.states().for_each(drop);
            let _ = (swarm.energy(7), swarm.state(usize::MAX));
            if swarm.steps() > 0 {
                let _ = swarm.advance(u64::MAX);
            }
        }
    };
    (0..rounds).filter(|_| catch_unwind(AssertUnwindSafe(|| round(&mut numbers))).is_err()).count() as u64
}

/// Calls the methods of a run and the checks. Results are ignored, because only panics count.
fn calls<H, C>(system: &H, start: Phase<C>, h: f64, numbers: &mut Numbers)
where
    H: Hamiltonian,
    H::Coords: Coords<With<C::Leaf> = C>,
    C: Coords,
{
    let _ = check::stability::<H, _, C::Leaf>(system, Verlet, &start, h);
    let _ = check::gradient_error::<H, C::Leaf>(system, start.clone(), numbers.next());
    let _ = check::symplectic_defect::<H, _, C::Leaf>(system, Yoshida4, start.clone(), h);
    let Ok(run) = system.run_with::<C::Leaf, _>(Yoshida4, start, h) else { return };
    let mut run = run.at_time(numbers.next());
    for steps in [0, 1, numbers.below(2000)] {
        let _ = run.advance(steps);
        let _ = (run.time(), run.state(), run.energy(), format!("{run:?}"));
    }
    if run.steps() > 0 {
        let _ = run.advance(u64::MAX);
    }
    let mut bytes = run.checkpoint();
    let _ = Run::<C>::resume_with(system, Yoshida4, &bytes);
    bytes.truncate(numbers.below(1 + bytes.len() as u64) as usize);
    let _ = Run::<C>::resume_with(system, Yoshida4, &bytes);
    for sample in run.samples(numbers.below(3)).take(3) {
        let _ = sample.map(|sample| sample.energy());
    }
}

/// Random numbers (Marsaglia 2003).
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, limit: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        if limit == 0 { 0 } else { (self.0 >> 11) % limit }
    }

    /// Returns one of the [`NUMBERS`], a number between -1 and 1, or a number with random bits.
    fn next(&mut self) -> f64 {
        match self.below(3) {
            0 => NUMBERS[self.below(NUMBERS.len() as u64) as usize],
            1 => self.below(2000) as f64 / 1000.0 - 1.0,
            _ => f64::from_bits(self.0),
        }
    }
}
