//! Points of phase space as checks see them: in `f64`, and as flat vectors.

use crate::{
    check::start::Start,
    error::Error,
    hamiltonian::Hamiltonian,
    scalar::tolerance::{largest, ratio},
    state::{
        coords::Coords,
        flat::{Flat, flat},
        phase::Phase,
        precision::Precision,
    },
    system::Shaped,
    trajectory::{admissible::admissible, method::Method, run::Run},
};

/// The values of a point, whatever its leaves carry beside.
pub(crate) fn plain<H: Hamiltonian, K: Precision>(point: &Phase<Shaped<H, K>>) -> Phase<H::Coords> {
    Phase { q: point.q.map(|leaf| leaf.to_f64()), p: point.p.map(|leaf| leaf.to_f64()) }
}

/// A start without its shape.
pub(crate) fn flat_start<C: Coords>(start: &Start<C>) -> Start<Vec<f64>> {
    Start { phase: flat(&start.phase), time: start.time }
}

/// The values of a start, if a run may begin there.
pub(crate) fn begin<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: &Start<Shaped<H, K>>,
    h: f64,
) -> Result<Start<H::Coords>, Error> {
    if !start.time.is_finite() {
        return Err(Error::Time { time: start.time });
    }
    admissible(&start.phase, h)?;
    let start = plain::<H, K>(&start.phase).at_time(start.time);
    run::<H, X, f64>(system, method, &start, h)?;
    Ok(start)
}

/// A run from a start and its time.
pub(crate) fn run<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: &Start<Shaped<H, K>>,
    h: f64,
) -> Result<Run<Shaped<H, K>>, Error> {
    let Start { phase, time } = start.clone();
    let mut run = Run::start::<H, X, K>(system, method, phase, h)?.at_time(time);
    run.check_start()?;
    Ok(run)
}

/// The size of one rounding, relative to the largest position or to the largest momentum of some points.
pub(crate) fn resolution<C: Coords>(points: &[&Phase<C>]) -> f64 {
    let (mut q, mut p) = (Grain::default(), Grain::default());
    for point in points {
        q.see(point.q.flat());
        p.see(point.p.flat());
    }
    C::Leaf::EPSILON.max(q.resolution()).max(p.resolution())
}

/// The coarsest spacing of some coordinates that lie on grids, and the largest of them.
#[derive(Default)]
struct Grain {
    spacing: f64,
    size: f64,
}

impl Grain {
    fn see<K: Precision>(&mut self, leaves: &[K]) {
        for leaf in leaves {
            self.see_one(leaf.to_f64(), leaf.spacing());
        }
    }

    fn see_one(&mut self, value: f64, spacing: Option<f64>) {
        self.size = largest([self.size, value]);
        self.spacing = largest([self.spacing, spacing.unwrap_or(0.0)]);
    }

    fn resolution(&self) -> f64 {
        ratio(self.spacing, self.size)
    }
}

/// The origin, in the shape of `point`.
pub(crate) fn origin<C: Coords<Leaf = f64>>(point: &Phase<C>) -> Phase<C> {
    let mut origin = point.clone();
    origin.q.flat_mut().fill(0.0);
    origin.p.flat_mut().fill(0.0);
    origin
}

/// One number of a point, positions counted first.
pub(crate) fn coordinate(point: &mut Flat, index: usize) -> &mut f64 {
    let n = point.q.len();
    if index < n { &mut point.q[index] } else { &mut point.p[index - n] }
}

/// All numbers of a point, positions first.
pub(crate) fn numbers(point: &Flat) -> impl Iterator<Item = f64> {
    point.q.iter().chain(&point.p).copied()
}
