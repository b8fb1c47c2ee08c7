//! Reversed runs: bitwise exact on a grid, up to rounding in floating point.

use integrator_bench::problems::HenonHeiles;
use integrator_core::{Coords, Visitor, prelude::*};

/// 2^-44, which allows coordinates up to 128.
const GRID: f64 = 1.0 / (1_u64 << 44) as f64;

/// Result of a run forwards and backwards.
pub(crate) struct Return {
    pub(crate) composition: &'static str,
    /// Number of bits of coordinates on the grid that differ from the initial state.
    pub(crate) bits_lost: u32,
    /// Largest change of a coordinate in floating point.
    pub(crate) distance: f64,
}

/// Runs all symmetric compositions, `steps` steps in each direction, on a regular orbit.
pub(crate) fn returns(steps: u64) -> Result<Vec<Return>, Error> {
    let mut each = Each { steps, returns: Ok(Vec::new()) };
    HenonHeiles::visit_compositions(&mut each);
    each.returns
}

struct Each {
    steps: u64,
    returns: Result<Vec<Return>, Error>,
}

impl Visitor<HenonHeiles> for Each {
    fn visit<X: Composition<HenonHeiles>>(&mut self, composition: X) {
        if X::SYMMETRIC
            && let Ok(returns) = &mut self.returns
        {
            match there_and_back(composition, self.steps) {
                Ok(found) => returns.push(found),
                Err(error) => self.returns = Err(error),
            }
        }
    }
}

fn there_and_back<X: Composition<HenonHeiles>>(composition: X, steps: u64) -> Result<Return, Error> {
    const H: f64 = 0.1;
    let (q, p) = ([0.0, 0.1], [0.3, 0.05]);
    let exact = Phase::reversible(q, p, GRID);
    let mut there = HenonHeiles.run_with(composition, exact, H)?;
    there.advance(steps)?;
    let mut back = HenonHeiles.run_with(composition, there.state(), -H)?;
    back.advance(steps)?;
    let differing = |one: Fixed<f64>, other: Fixed<f64>| (one.value().to_bits() ^ other.value().to_bits()).count_ones();
    let end = back.state();
    let bits_lost = numbers(&exact).zip(numbers(&end)).map(|(one, other)| differing(one, other)).sum();

    let plain = Phase::new(q, p);
    let mut there = HenonHeiles.run_with(composition, plain, H)?;
    there.advance(steps)?;
    let mut back = HenonHeiles.run_with(composition, there.state(), -H)?;
    back.advance(steps)?;
    let end = back.state();
    let distance = numbers(&plain).zip(numbers(&end)).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
    Ok(Return { composition: X::NAME, bits_lost, distance })
}

fn numbers<C: Coords>(state: &Phase<C>) -> impl Iterator<Item = C::Leaf> {
    state.q.flat().iter().chain(state.p.flat()).copied()
}
