//! The textbook leapfrog: positions at whole steps and momenta at half steps.

use crate::walk::{Place, Recipe};
use integrator_core::{__private::Real, Described, Facts, Unsolved};

/// The staggered leapfrog: `q += h ∂T/∂p` with momenta at the middle of the step, then `p -= h ∂V/∂q` with positions at
/// its end.
///
/// The run starts with a half kick. Before each output, another half kick synchronises the momenta with the positions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StaggeredLeapfrog;

impl Described for StaggeredLeapfrog {
    fn facts(self) -> Facts {
        facts! {
        name: "StaggeredLeapfrog",
        order: 2,
        symmetric: true,
        symplectic: true,
        forces: Some(1),
        stability_limit: Some(2.0),
        roundings: 4 }
    }
}

impl Recipe for StaggeredLeapfrog {
    /// The momenta half a step ahead; nothing before the first step.
    type Memory<R: Real> = Option<Vec<R>>;

    fn increment<R: Real>(self, memory: &mut Option<Vec<R>>, from: &Place<'_, R>) -> Result<Vec<R>, Unsolved> {
        let Place { field, y, time, h, .. } = *from;
        let (q, p) = y.split_at(y.len() / 2);
        let kicked = |p: &[R], force: &[R], duration: f64| -> Vec<R> {
            p.iter().zip(force).map(|(p, f)| R::of(duration).fma(*f, *p)).collect()
        };
        let ahead = match memory.take() {
            Some(ahead) => ahead,
            None => kicked(p, &field.force(y, time), h / 2.0),
        };
        let middle: Vec<R> = q.iter().chain(&ahead).copied().collect();
        let corrections: Vec<R> = field.velocity(&middle, time + h / 2.0).into_iter().map(|v| R::of(h) * v).collect();
        let end: Vec<R> = q.iter().zip(&corrections).map(|(q, d)| *q + *d).chain(ahead.iter().copied()).collect();
        let force = field.force(&end, time + h);
        let shown = kicked(&ahead, &force, h / 2.0);
        let increment = corrections.into_iter().chain(shown.iter().zip(p).map(|(shown, p)| *shown - *p)).collect();
        *memory = Some(kicked(&ahead, &force, h));
        Ok(increment)
    }
}
