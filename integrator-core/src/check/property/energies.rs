//! The energies of a system and their flows, for checks: values, derivatives by duals, bounds on roundings.

use crate::{
    check::{
        flow::{Flow, moved},
        statistics::points::{coordinate, origin},
    },
    hamiltonian::Hamiltonian,
    methods::implicit::field::{Constants, Pair, field},
    scalar::{bounded::Bounded, dual::Dual, real::Real},
    state::{
        coords::Coords,
        flat::{Flat, shaped},
        phase::Phase,
    },
    system::{
        motion::{Motion, Prepared},
        user_energies::bounded_energy,
    },
};

/// The tolerance of a component of a gradient over `coordinates` coordinates: a sum of as many terms,
/// each of some operations and elementary functions of up to 4 ulp, evaluated twice, as code and through duals, whose
/// chain rule rounds a few times more.
pub(crate) fn gradient_tolerance(coordinates: usize) -> f64 {
    32.0 * (coordinates + 1) as f64 * f64::EPSILON
}

/// One of the two energies. The gradient of `T` or of `V` is by the half of the coordinates that it reads, and moves the
/// other half.
pub(crate) use crate::system::user_energies::Function as Part;

/// The energies of a system and their flows, whatever the shape of its coordinates: in one lane, or along a tangent in
/// the second one of duals.
pub(crate) trait Differentiable {
    /// Whether the energies are `T(p)` and `V(q)`.
    fn is_separable(&self) -> bool;

    /// Whether H has no parts: all of its energy is then the first of the two, and its field moves both halves.
    fn in_one_piece(&self) -> bool;

    /// An energy, and a bound on its rounding.
    fn bounded_energy(&self, part: Part, point: &Flat, time: f64) -> [f64; 2];

    /// An energy, or its derivative along a tangent.
    fn energy(&self, part: Part, point: &Flat, tangent: Option<&Flat>, time: f64) -> f64;

    /// The derivative of an energy along a tangent, and a bound on its rounding.
    fn bounded_slope(&self, part: Part, point: &Flat, tangent: &Flat, time: f64) -> [f64; 2];

    /// The names of what the user says is conserved.
    fn invariants(&self) -> &'static [&'static str];

    /// An invariant, or its derivative along a tangent.
    fn invariant(&self, number: usize, point: &Flat, tangent: Option<&Flat>) -> f64;

    /// The gradient of `T` or of `V`, or the derivative of that along a tangent.
    fn flow(&self, part: Part, point: &Flat, tangent: Option<&Flat>, time: f64) -> Vec<f64>;

    /// The derivative of one half of the vector field along a tangent, as a gradient, if the last part of H takes inner steps.
    fn bent_field(&self, part: Part, point: &Flat, tangent: &Flat, time: f64) -> Option<Vec<f64>>;

    /// Bounds on the rounding of the components of the gradient of `T` or of `V`.
    fn flow_rounding(&self, part: Part, point: &Flat, time: f64) -> Vec<f64>;
}

/// The point with the coordinates alone that the gradient of an energy reads, and zeros for the others.
pub(crate) fn read_by(system: &dyn Differentiable, part: Part, point: &Flat) -> Flat {
    let still = origin(point);
    match part {
        _ if system.in_one_piece() => point.clone(),
        Part::Kinetic => Phase { q: still.q, p: point.p.clone() },
        Part::Potential => Phase { q: point.q.clone(), p: still.p },
    }
}

/// The energies of a system with its parameters, and a point in the shape of its coordinates.
pub(crate) struct Energies<'s, H: Hamiltonian> {
    pub(crate) system: &'s H,
    pub(crate) parameters: H::Parameters<f64>,
    pub(crate) shape: &'s Phase<H::Coords>,
}

impl<'s, H: Hamiltonian> Energies<'s, H> {
    pub(crate) fn new(system: &'s H, shape: &'s Phase<H::Coords>) -> Self {
        Self { system, parameters: system.parameters(shape.q.length()), shape }
    }
}

impl<H: Hamiltonian> Differentiable for Energies<'_, H> {
    fn is_separable(&self) -> bool {
        H::SEPARABLE
    }

    fn in_one_piece(&self) -> bool {
        H::PARTS.is_empty()
    }

    fn bounded_energy(&self, part: Part, point: &Flat, time: f64) -> [f64; 2] {
        bounded_energy::<H>(part, &self.parameters, &shaped(self.shape, point), time)
    }

    fn energy(&self, part: Part, point: &Flat, tangent: Option<&Flat>, time: f64) -> f64 {
        let point = shaped(self.shape, point);
        match tangent {
            None => energy::<H, f64>(&self.parameters, part, [&point, &point], time).lane(0),
            Some(tangent) => {
                let tangent = shaped(self.shape, tangent);
                energy::<H, Dual>(&self.parameters, part, [&point, &tangent], time).lane(1)
            }
        }
    }

    fn bounded_slope(&self, part: Part, point: &Flat, tangent: &Flat, time: f64) -> [f64; 2] {
        let [point, tangent] = [point, tangent].map(|numbers| shaped(self.shape, numbers));
        // The value and the tangent, then the bounds on both.
        let lanes = [&point, &tangent, &point, &tangent];
        let motion = H::Motion::<Dual<Bounded>, f64>::load(&[&self.parameters; 4], &lanes);
        let energy = part.energy::<H, Dual<Bounded>>(&motion, time);
        [energy.lane(1), energy.lane(3)]
    }

    fn invariants(&self) -> &'static [&'static str] {
        H::INVARIANTS
    }

    fn invariant(&self, number: usize, point: &Flat, tangent: Option<&Flat>) -> f64 {
        if const { H::INVARIANTS.is_empty() } {
            return f64::NAN;
        }
        let point = shaped(self.shape, point);
        match tangent {
            None => H::invariant::<f64, f64>(&H::Motion::load(&[&self.parameters], &[&point]), number),
            Some(tangent) => {
                let lanes = [&point, &shaped(self.shape, tangent)];
                H::invariant::<Dual, f64>(&H::Motion::load(&[&self.parameters; 2], &lanes), number).lane(1)
            }
        }
    }

    fn flow(&self, part: Part, point: &Flat, tangent: Option<&Flat>, time: f64) -> Vec<f64> {
        let point = shaped(self.shape, point);
        match tangent {
            None => flow::<H, f64>(&self.parameters, part, [&point, &point], time, 0),
            Some(tangent) => {
                let tangent = shaped(self.shape, tangent);
                flow::<H, Dual>(&self.parameters, part, [&point, &tangent], time, 1)
            }
        }
    }

    fn bent_field(&self, part: Part, point: &Flat, tangent: &Flat, time: f64) -> Option<Vec<f64>> {
        if const { H::NESTED.is_empty() } {
            return None;
        }
        let [point, tangent] = [point, tangent].map(|numbers| shaped(self.shape, numbers));
        Some(half_of_field::<H, Dual>(&self.parameters, part, &[&point, &tangent], time, 1))
    }

    fn flow_rounding(&self, part: Part, point: &Flat, time: f64) -> Vec<f64> {
        let point = shaped(self.shape, point);
        let bounds = flow::<H, Bounded>(&self.parameters, part, [&point, &point], time, 1);
        bounds.into_iter().map(f64::abs).collect()
    }
}

/// An energy at a point, with a tangent in the second lane if there is one.
fn energy<H: Hamiltonian, R: Real>(
    parameters: &H::Parameters<f64>,
    part: Part,
    lanes: [&Phase<H::Coords>; 2],
    time: f64,
) -> R {
    part.energy::<H, R>(&H::Motion::<R, f64>::load(&[parameters; 2], &lanes), time)
}

/// One lane of the gradient of an energy at a point, with a tangent in the second lane if there is one: what the flow
/// of unit duration adds to the half that is moved, from zero.
pub(crate) fn flow<H: Hamiltonian, R: Real>(
    parameters: &H::Parameters<f64>,
    part: Part,
    lanes: [&Phase<H::Coords>; 2],
    time: f64,
    lane: usize,
) -> Vec<f64> {
    if const { H::PARTS.is_empty() } {
        return half_of_field::<H, R>(parameters, part, &lanes[..R::LANES], time, lane);
    }
    let flow = if part == Part::Kinetic { Flow::First } else { Flow::Last };
    let motion = moved::<H, R>(parameters, &[(flow, 1.0)], lanes, time);
    let mut moved = lanes[0].clone();
    motion.store(lane, &mut moved);
    if part == Part::Kinetic { moved.q.flat().to_vec() } else { negated(moved.p.flat()) }
}

/// One half of a field that moves positions and momenta together, as a gradient.
fn half_of_field<H: Hamiltonian, R: Real>(
    parameters: &H::Parameters<f64>,
    part: Part,
    lanes: &[&Phase<H::Coords>],
    time: f64,
    lane: usize,
) -> Vec<f64> {
    let mut gathered = H::Parameters::<R>::gather(&vec![parameters; lanes.len()]);
    gathered.begin_step(time);
    let constants = Constants { gathered: &gathered, of_lanes: &[], shape: lanes[0], middle: time };
    let point = Pair { q: H::Coords::pack(lanes, |point| &point.q), p: H::Coords::pack(lanes, |point| &point.p) };
    let Pair { q: velocity, p: force } = field::<H, R>(&constants, &point, time);
    let lane = |slots: &<H::Coords as Coords>::Slots<R>| -> Vec<f64> {
        H::Coords::slots(slots).iter().map(|slot| slot.lane(lane)).collect()
    };
    match part {
        Part::Kinetic => lane(&velocity),
        Part::Potential => negated(&lane(&force)),
    }
}

fn negated(numbers: &[f64]) -> Vec<f64> {
    numbers.iter().map(|number| -number).collect()
}

/// The derivatives of an energy by all coordinates, positions first, by duals.
pub(crate) fn slopes(system: &(impl Differentiable + ?Sized), part: Part, point: &Flat, time: f64) -> Vec<f64> {
    let still = origin(point);
    let slope = |index: usize| {
        let mut along = still.clone();
        *coordinate(&mut along, index) = 1.0;
        system.energy(part, point, Some(&along), time)
    };
    (0..2 * point.q.len()).map(slope).collect()
}
