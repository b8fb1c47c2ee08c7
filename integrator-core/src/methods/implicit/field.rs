//! The vector fields that implicit methods integrate: that of a Hamiltonian, as written or from its flows of `T` and `V`, or
//! [another one](Field) of its system.

use crate::{
    scalar::real::Real,
    state::{coords::Coords, phase::Phase},
    system::{
        System,
        motion::{Motion, Moved, Read},
    },
};
use alloc::vec::Vec;

/// Numbers in the shape of the positions or the momenta of `H`.
pub type Half<H, R> = <<H as System>::Coords as Coords>::Slots<R>;

/// Positions and momenta, or what the field is there: velocities and forces.
pub struct Pair<H: System, R: Real> {
    pub(crate) q: Half<H, R>,
    pub(crate) p: Half<H, R>,
}

impl<H: System, R: Real> Clone for Pair<H, R> {
    #[inline(always)]
    fn clone(&self) -> Self {
        Self { q: self.q.clone(), p: self.p.clone() }
    }
}

impl<H: System, R: Real> Pair<H, R> {
    /// Both halves as lists.
    #[inline(always)]
    pub(crate) fn halves(&self) -> [&[R]; 2] {
        [H::Coords::slots(&self.q), H::Coords::slots(&self.p)]
    }

    /// Both halves as mutable lists.
    #[inline(always)]
    pub(crate) fn halves_mut(&mut self) -> [&mut [R]; 2] {
        [H::Coords::slots_mut(&mut self.q), H::Coords::slots_mut(&mut self.p)]
    }

    /// Zeros, this number of them in each half.
    #[inline(always)]
    pub(crate) fn zero(count: usize) -> Self {
        let zeros = || H::Coords::slots_from(count, |_| R::of(0.0));
        Self { q: zeros(), p: zeros() }
    }
}

/// The constants that the field has, for all lanes and for each.
pub struct Constants<'m, H: System, R: Real> {
    pub(crate) gathered: &'m H::Parameters<R>,
    pub(crate) of_lanes: &'m [H::Parameters<f64>],
    /// A point in the shape of the coordinates.
    pub(crate) shape: &'m Phase<H::Coords>,
    /// The middle of the current step.
    pub(crate) middle: f64,
}

/// The independent variable of a vector field.
pub trait Variable: Copy + Send + Sync + 'static {
    /// Whether it is a fictitious time, so that the time is part of the motion.
    const IS_FICTITIOUS: bool;
}

/// A vector field that implicit methods integrate.
pub trait Field<H: System>: Variable {
    /// Whether it may be evaluated for all stages of a step at once.
    const MAY_BE_TOGETHER: bool;
    /// The field at a point. In a fictitious time, it depends on the momentum that is conjugate to the time.
    fn at<R: Real>(constants: &Constants<'_, H, R>, conjugate: R, point: &Pair<H, R>, time: f64) -> Pair<H, R>;
    /// Adds the field as written, at a point.
    fn add<R: Real>(parameters: &H::Parameters<R>, conjugate: R, point: &Pair<H, R>, field: &mut Pair<H, R>, time: f64);
    /// Whether velocities depend on momenta alone, and forces on positions alone.
    const HAS_HALVES: bool = false;
    /// One half of the field at a point: velocities, or forces.
    #[inline(always)]
    fn half_at<R: Real>(
        constants: &Constants<'_, H, R>,
        conjugate: R,
        half: usize,
        point: &Pair<H, R>,
        time: f64,
    ) -> Half<H, R> {
        let Pair { q, p } = Self::at(constants, conjugate, point, time);
        if half == 0 { q } else { p }
    }
    /// Adds one half of the field as written, at a point.
    #[inline(always)]
    fn add_half<R: Real>(
        parameters: &H::Parameters<R>,
        conjugate: R,
        _half: usize,
        point: &Pair<H, R>,
        field: &mut Pair<H, R>,
        time: f64,
    ) {
        Self::add(parameters, conjugate, point, field, time);
    }
    /// The momentum that is conjugate to the time, for the motion that begins at a point.
    fn conjugate<R: Real>(parameters: &H::Parameters<R>, point: &Pair<H, R>) -> R;
    /// The fictitious time for a unit of time at a point.
    fn rate<R: Real>(parameters: &H::Parameters<R>, point: &Pair<H, R>) -> R;
}

/// The field of H, in the time.
#[derive(Clone, Copy)]
pub struct OfTime;

impl Variable for OfTime {
    const IS_FICTITIOUS: bool = false;
}

impl<H: System> Field<H> for OfTime {
    const MAY_BE_TOGETHER: bool = H::AUTONOMOUS && H::HAS_FIELD;
    const HAS_HALVES: bool = H::SEPARABLE;

    #[inline(always)]
    fn at<R: Real>(constants: &Constants<'_, H, R>, _: R, point: &Pair<H, R>, time: f64) -> Pair<H, R> {
        if const { H::HAS_FIELD } { written(constants, point, time) } else { of_flows(constants, point, time) }
    }
    #[inline(always)]
    fn add<R: Real>(parameters: &H::Parameters<R>, _: R, point: &Pair<H, R>, field: &mut Pair<H, R>, time: f64) {
        add_field::<H, R>(parameters, point, field, time);
    }
    #[inline(always)]
    fn half_at<R: Real>(
        constants: &Constants<'_, H, R>,
        _: R,
        half: usize,
        point: &Pair<H, R>,
        time: f64,
    ) -> Half<H, R> {
        if const { H::HAS_FIELD } {
            let mut field = Pair::zero(H::Coords::slots(&point.q).len());
            add_half_of_field::<H, R>(constants.gathered, half, point, &mut field, time);
            let Pair { q, p } = field;
            return if half == 0 { q } else { p };
        }
        if half == 0 { velocities(constants, point, time) } else { forces(constants, point, time) }
    }
    #[inline(always)]
    fn add_half<R: Real>(
        parameters: &H::Parameters<R>,
        _: R,
        half: usize,
        point: &Pair<H, R>,
        field: &mut Pair<H, R>,
        time: f64,
    ) {
        add_half_of_field::<H, R>(parameters, half, point, field, time);
    }
    #[inline(always)]
    fn conjugate<R: Real>(_: &H::Parameters<R>, _: &Pair<H, R>) -> R {
        R::of(0.0)
    }
    #[inline(always)]
    fn rate<R: Real>(_: &H::Parameters<R>, _: &Pair<H, R>) -> R {
        R::of(1.0)
    }
}

/// The field at a point: that of the flows where H is `T + V`.
#[cfg(feature = "check")]
#[inline(always)]
pub(crate) fn field<H: System, R: Real>(constants: &Constants<'_, H, R>, point: &Pair<H, R>, time: f64) -> Pair<H, R> {
    if const { H::SEPARABLE } { of_flows(constants, point, time) } else { written(constants, point, time) }
}

/// The field of H as written.
#[inline(always)]
fn written<H: System, R: Real>(constants: &Constants<'_, H, R>, point: &Pair<H, R>, time: f64) -> Pair<H, R> {
    let mut field = Pair::zero(H::Coords::slots(&point.q).len());
    add_field::<H, R>(constants.gathered, point, &mut field, time);
    field
}

/// Adds the field of H as written, at a point.
#[inline(always)]
fn add_field<H: System, R: Real>(
    parameters: &H::Parameters<R>,
    Pair { q, p }: &Pair<H, R>,
    field: &mut Pair<H, R>,
    time: f64,
) {
    let moved = Moved { q: &mut field.q, p: &mut field.p };
    // What moves zeros by a unit of time is not rounded.
    H::along_field::<R, f64>(Read { q, p, parameters }, moved, 1.0, time);
}

/// Adds one half of the field of `T + V` as written, at a point.
#[inline(always)]
fn add_half_of_field<H: System, R: Real>(
    parameters: &H::Parameters<R>,
    half: usize,
    Pair { q, p }: &Pair<H, R>,
    field: &mut Pair<H, R>,
    time: f64,
) {
    let (point, moved) = (Read { q, p, parameters }, Moved { q: &mut field.q, p: &mut field.p });
    if half == 0 {
        H::along_velocity::<R, f64>(point, moved, 1.0, time);
    } else {
        H::along_force::<R, f64>(point, moved, 1.0, time);
    }
}

/// The field of `T + V` by its flows.
#[inline(always)]
fn of_flows<H: System, R: Real>(constants: &Constants<'_, H, R>, point: &Pair<H, R>, time: f64) -> Pair<H, R> {
    Pair { q: velocities(constants, point, time), p: forces(constants, point, time) }
}

/// The velocities of `T + V`: a drift moves positions from zero by them.
#[inline(always)]
fn velocities<H: System, R: Real>(
    constants: &Constants<'_, H, R>,
    Pair { p, .. }: &Pair<H, R>,
    time: f64,
) -> Half<H, R> {
    let mut drifted = loaded::<H, R>(constants, [None, Some(p)]);
    H::drift::<R, f64>(&mut drifted, 1.0, time);
    stored::<H, R>(constants, &drifted, |point| &point.q)
}

/// The forces of `T + V`: a kick moves momenta from zero by them.
#[inline(always)]
fn forces<H: System, R: Real>(constants: &Constants<'_, H, R>, Pair { q, .. }: &Pair<H, R>, time: f64) -> Half<H, R> {
    let mut kicked = loaded::<H, R>(constants, [Some(q), None]);
    H::kick::<R, f64>(&mut kicked, 1.0, time);
    stored::<H, R>(constants, &kicked, |point| &point.p)
}

/// A motion in the layout of the flows, with one half at these numbers and the other at zero.
fn loaded<H: System, R: Real>(
    Constants { of_lanes, shape, middle, .. }: &Constants<'_, H, R>,
    [q, p]: [Option<&Half<H, R>>; 2],
) -> H::Motion<R, f64> {
    let fill = |leaves: &mut H::Coords, half: Option<&Half<H, R>>, lane: usize| {
        for (k, leaf) in leaves.flat_mut().iter_mut().enumerate() {
            *leaf = half.map_or(0.0, |half| H::Coords::slots(half)[k].lane(lane));
        }
    };
    let mut points: Vec<Phase<H::Coords>> = (0..R::LANES).map(|_| (*shape).clone()).collect();
    for (lane, point) in points.iter_mut().enumerate() {
        fill(&mut point.q, q, lane);
        fill(&mut point.p, p, lane);
    }
    let states: Vec<_> = points.iter().collect();
    let constants: Vec<_> = of_lanes.iter().collect();
    let mut motion = H::Motion::<R, f64>::load(&constants, &states);
    H::begin_step::<R, f64>(&mut motion, *middle);
    motion
}

/// One half of the state of a motion.
fn stored<H: System, R: Real>(
    constants: &Constants<'_, H, R>,
    motion: &H::Motion<R, f64>,
    half: fn(&Phase<H::Coords>) -> &H::Coords,
) -> Half<H, R> {
    let mut points: Vec<Phase<H::Coords>> = (0..R::LANES).map(|_| constants.shape.clone()).collect();
    for (lane, point) in points.iter_mut().enumerate() {
        motion.store(lane, point);
    }
    let count = half(constants.shape).flat().len();
    H::Coords::slots_from(count, |k| R::state(&|lane| half(&points[lane]).flat()[k]))
}
