//! Errors of runs and ensembles.

use alloc::{
    borrow::ToOwned,
    boxed::Box,
    format,
    string::{String, ToString},
    vec::Vec,
};

/// Implements `Debug` like `Display`, since `unwrap`, `expect` and a `main` that returns an error print `Debug`.
macro_rules! debug_as_display {
    ($($error:ty),* $(,)?) => {
        $(impl core::fmt::Debug for $error {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                core::fmt::Display::fmt(self, f)
            }
        })*
    };
}
pub(crate) use debug_as_display;

/// A number in a message, with an exponent if it is below 1e-5 or at least 1e6. Width, sign and digits are those of the
/// format.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Number(pub(crate) f64);

impl core::fmt::Display for Number {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self(number) = *self;
        match number == 0.0 || !number.is_finite() || (1e-5..1e6).contains(&number.abs()) {
            true => core::fmt::Display::fmt(&number, f),
            false => core::fmt::LowerExp::fmt(&number, f),
        }
    }
}

debug_as_display!(Error, VectorFault, Unsolved, NotFinite, Misread, Divergence, Lost);

/// The reason why a run could not start or continue. `Display` prints what is wrong, where, and what to do.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The step is zero or not finite.
    #[error("the step h has to be finite and not zero, but it is {h}\nnote: negative steps run backwards", h = Number(*h))]
    Step {
        /// The requested step.
        h: f64,
    },
    /// A coordinate of the initial state is not finite.
    #[error(
        "the initial state is not finite: {coordinate}[{index}] is {value} (index into the flattened coordinates)",
        value = Number(*value)
    )]
    Start {
        /// `q` or `p`.
        coordinate: &'static str,
        /// The index of the coordinate in the flattened coordinates.
        index: usize,
        /// The value of the coordinate.
        value: f64,
    },
    /// The initial state lacks coordinates that the functions of the system read by a number, such as `q[3]`, also in loops
    /// that have no iteration.
    #[error(
        "the functions of the system read the coordinate with index {}, but the initial state has only {length}\nhelp: start with \
         at least {least}",
        least.saturating_sub(1)
    )]
    FewCoordinates {
        /// The smallest number of coordinates, points or planes that the system can start with.
        least: usize,
        /// The number of coordinates, points or planes of the initial state.
        length: usize,
    },
    /// The functions of the system read flat coordinates as points, and the initial state has a part of a point.
    #[error(
        "the functions of the system read points with {components} components each, and the initial state has {length} \
         coordinates\nhelp: start with a multiple of {components}"
    )]
    PartialPoint {
        /// The number of components of a point.
        components: usize,
        /// The number of coordinates of the initial state.
        length: usize,
    },
    /// A force or a velocity at the initial state is not finite, because a constant that depends on parameters is not.
    #[error(
        "the equations of motion are not finite at the initial state: {}\nhelp: check these parameters of the system",
        listed(constants)
    )]
    Parameters {
        /// The constants that are not finite; of an array, the first such element.
        constants: Vec<NotFinite>,
    },
    /// The parameters have fewer masses than bodies, so that Jacobi coordinates cannot be computed.
    #[error("Jacobi coordinates of {bodies} bodies require {bodies} masses, but there are {masses}")]
    FewMasses {
        /// The number of masses.
        masses: usize,
        /// The number of bodies.
        bodies: usize,
    },
    /// A mass is unusable for Jacobi coordinates.
    #[error("the mass of body {body} is {mass}: {reason}", mass = Number(*mass))]
    Mass {
        /// The index of the body, from 0.
        body: usize,
        /// The mass of the body.
        mass: f64,
        /// The reason why the mass is unusable.
        reason: &'static str,
    },
    /// The kinetic or potential energy of the start, or that of a named part, is not finite.
    ///
    /// Examples are a pole, and a logarithm or a root of a negative number.
    #[error(
        "`{function}` is {value} at the initial state (t = {time})\nhelp: start where the energy is finite, or check the \
         parameters of the system",
        value = Number(*value), time = Number(*time)
    )]
    Energy {
        /// `kinetic` or `potential`; where parts of H have names, that of the first one, or of the other one.
        function: &'static str,
        /// The value of the energy.
        value: f64,
        /// The time at the start.
        time: f64,
    },
    /// The generated code disagrees with the user's function.
    ///
    /// Builds with debug assertions check this at the start of runs of at most 4096 coordinates.
    #[error(transparent)]
    Misread(#[from] Misread),
    /// The grid spacing of a reversible start is not a power of two.
    #[error(
        "the grid spacing of {coordinate}[{index}] is {spacing}, which is not a power of two\nhelp: write, for example, \
         `1.0 / (1_u64 << 40) as f64`"
    )]
    Grid {
        /// `q` or `p`.
        coordinate: &'static str,
        /// The index of the coordinate in the flattened coordinates.
        index: usize,
        /// The requested spacing.
        spacing: f64,
    },
    /// A coordinate of a reversible start is outside the range of its grid.
    #[error(
        "{coordinate}[{index}] is {value}, outside of ±{limit}, the range of a grid with the spacing {spacing}\nhelp: \
         choose a coarser grid, or units in which the coordinates are smaller",
        value = Number(*value), spacing = Number(*spacing), limit = Number(*limit)
    )]
    GridRange {
        /// `q` or `p`.
        coordinate: &'static str,
        /// The index of the coordinate in the flattened coordinates.
        index: usize,
        /// The value of the coordinate.
        value: f64,
        /// The spacing of the grid.
        spacing: f64,
        /// 2^51 spacings.
        limit: f64,
    },
    /// A reversible start with a composition that is not its own inverse at `-h`.
    #[error(
        "{composition} is not symmetric, so steps by -h do not undo its steps\nhelp: use a symmetric composition, such \
         as `Verlet` or `Yoshida4`, or write `Phase::new`\nnote: a reversible initial state requires a symmetric \
         composition"
    )]
    NotSymmetric {
        /// The name of the composition.
        composition: &'static str,
    },
    /// A reversible start and a method with friction, which contracts the grid.
    #[error(
        "a reversible initial state does not support friction\nhelp: write `Phase::new`\nnote: friction maps several \
         points of the grid to one"
    )]
    FrictionOnGrid,
    /// A system with friction and a method that does not apply it.
    #[error(
        "{method} does not apply the friction of this system\nhelp: use a composition with the letter `O`, such as `Baoab`, \
         or leave out `#[friction]`"
    )]
    NoFriction {
        /// The name of the method.
        method: &'static str,
    },
    /// Steps of a system with a temperature that apply friction for a negative duration.
    #[error(
        "{method} would apply friction with noise for a negative duration, with the step {h}\nhelp: use a positive step and a \
         composition with positive `O`, such as `Baoab`"
    )]
    NoiseBackwards {
        /// The name of the method.
        method: &'static str,
        /// The step.
        h: f64,
    },
    /// A rate of friction or a temperature is negative or not finite.
    #[error("`{function}({index})` is {value}\nhelp: return a number that is finite and not negative")]
    Rate {
        /// `friction` or `temperature`.
        function: &'static str,
        /// The argument.
        index: usize,
        /// The value.
        value: f64,
    },
    /// Heat is to be measured, and the system has no temperature.
    #[error(
        "the system has no temperature, so its steps exchange no heat\nhelp: add `#[temperature]` next to `#[friction]`"
    )]
    NoTemperature,
    /// Metropolis steps that would not have the canonical distribution.
    #[error("Metropolis steps require {requirement}\nhelp: {help}")]
    NotMetropolised {
        /// What is missing.
        requirement: &'static str,
        /// What to write instead.
        help: &'static str,
    },
    /// A system with a temperature whose momenta have no masses of their own.
    #[error(
        "the velocity of coordinate {coordinate} is not its momentum over a positive mass\nhelp: a temperature requires \
         T = Σ p²/(2m)"
    )]
    MassOfNoise {
        /// The number of the coordinate.
        coordinate: usize,
    },
    /// The numbers of positions and momenta of a start differ. The type of the coordinates does not fix them.
    #[error("the initial state has {positions} positions but {momenta} momenta")]
    Length {
        /// The number of positions.
        positions: usize,
        /// The number of momenta.
        momenta: usize,
    },
    /// The time of a start, or a requested time, is not finite.
    #[error("the time {time} is not finite", time = Number(*time))]
    Time {
        /// The requested time.
        time: f64,
    },
    /// The step is so short that adding it does not change the time.
    #[error(
        "the step h = {h} is too short at t = {time}, where t + h rounds to t\nhelp: start the clock closer to 0, or \
         choose another unit of time",
        h = Number(*h), time = Number(*time)
    )]
    Clock {
        /// The step.
        h: f64,
        /// The time that it does not change.
        time: f64,
    },
    /// The system has no `#[invariant]` of this name.
    #[error("the system has no invariant `{name}`\n{}", those_known(known))]
    NoInvariant {
        /// The requested name.
        name: String,
        /// The names of all invariants.
        known: &'static [&'static str],
    },
    /// The sampling interval is zero.
    #[error("the interval between samples is 0\nhelp: write at least one step, or an interval of time other than 0")]
    SampleInterval,
    /// The sampling interval is not finite, or has another sign than the step.
    #[error("the interval between samples is {}, {}", Number(*interval), interval_for(*interval, *h))]
    Interval {
        /// The requested interval.
        interval: f64,
        /// The step of the run.
        h: f64,
    },
    /// The function of a crossing is not finite at a state of the run.
    #[error(
        "the function of the crossing is {value} at t = {time}\nnote: it has to be finite along the whole orbit",
        time = Number(*time), value = Number(*value)
    )]
    Crossing {
        /// The time of that state.
        time: f64,
        /// The value of the function.
        value: f64,
    },
    /// The energy error of a run exceeds the bound of its watch.
    #[error(
        "the energy after step {step} (t = {time}) is {energy}, but it was {before} at the start of the watch: it \
         deviates by more than {bound} of |T| + |V|\nhelp: use a smaller step\nnote: the run stays at the state before \
         this step",
        time = Number(*time), energy = Number(*energy), before = Number(*before), bound = Number(*bound)
    )]
    EnergyStrayed {
        /// The step that was not taken.
        step: u64,
        /// The time at the end of that step.
        time: f64,
        /// The energy there.
        energy: f64,
        /// The energy when the watch began.
        before: f64,
        /// The bound, relative to the sizes of `T` and `V` when the watch began, or to those of the first part and of all others
        /// together.
        bound: f64,
    },
    /// The energy is not finite along an orbit, although the forces are.
    #[error(
        "the energy is {energy} at t = {time}, although the forces are finite\nhelp: use a smaller step\nnote: a step \
         led out of the domain of H",
        time = Number(*time), energy = Number(*energy)
    )]
    NoEnergy {
        /// The time.
        time: f64,
        /// The energy there.
        energy: f64,
    },
    /// The bound of a watch is not positive.
    #[error(
        "the bound on the energy deviation has to be positive, but it is {bound}\nhelp: write, for example, \
         `watch_energy(1e-3)`\nnote: the bound is relative to |T| + |V|",
        bound = Number(*bound)
    )]
    WatchBound {
        /// The requested bound.
        bound: f64,
    },
    /// The energy cannot be watched, because it is not conserved.
    #[error("the energy cannot be watched, since H depends on time and does not conserve it")]
    NotConserved,
    /// A state that was changed between two steps has another number of coordinates than before.
    #[error("the changed state has {after} positions, but the run has {before}")]
    Resized {
        /// The number of positions before the change.
        before: usize,
        /// The number of positions after the change.
        after: usize,
    },
    /// The number of steps exceeds `u64::MAX`.
    #[error("the run has taken {done} steps, and {asked} more exceed the largest step count, {}", u64::MAX)]
    Steps {
        /// The number of steps taken.
        done: u64,
        /// The number of additional steps requested.
        asked: u64,
    },
    /// The state diverged.
    #[error(transparent)]
    Diverged(#[from] Divergence),
    /// A method could not compute a step. The run stays at the last state.
    #[error(
        "{method} failed in step {step} (from t = {time}): {reason}\nnote: the run stays at the state before this step"
    )]
    NotSolved {
        /// The name of the method.
        method: &'static str,
        /// The step that was not taken.
        step: u64,
        /// The time at the beginning of that step.
        time: f64,
        /// The reason.
        reason: Unsolved,
    },
    /// The exponent of a time transformation is zero or not finite.
    #[error(
        "the exponent of `Power` has to be finite and not zero, but it is {exponent}\nhelp: write, for example, 0.5",
        exponent = Number(*exponent)
    )]
    Exponent {
        /// The requested exponent.
        exponent: f64,
    },
    /// The number of inner steps is zero.
    #[error("the number of inner steps is 0\nhelp: write, for example, `Verlet.nested(8)`")]
    InnerSteps,
    /// A run cannot go back to a time before its last step.
    #[error(
        "the run is at t = {present}, and its steps lead away from t = {time}\nhelp: integrate with steps of `-h`",
        time = Number(*time), present = Number(*present)
    )]
    Passed {
        /// The requested time.
        time: f64,
        /// The time at the end of the last step.
        present: f64,
    },
    /// The state of a run that shows a time within a step cannot be changed.
    #[error(
        "the state at t = {time} cannot be changed, since it is within the step from t = {present}\nhelp: start a run \
         from this state with `at_time({time})`, or change the state by `on_crossing`\nnote: states can be changed at \
         the ends of steps"
    )]
    WithinStep {
        /// The time that is shown.
        time: f64,
        /// The time at the end of the last whole step.
        present: f64,
    },
    /// The tolerance of an adaptive method is not a positive number.
    #[error(
        "the tolerance of {method} has to be positive and finite, but it is {tolerance}\nhelp: write, for example, 1e-9",
        tolerance = Number(*tolerance)
    )]
    Tolerance {
        /// The name of the method.
        method: &'static str,
        /// The requested tolerance.
        tolerance: f64,
    },
    /// A state or a method without a tangent map.
    #[error("deviation vectors are not available: {reason}")]
    NoTangent {
        /// The reason, and an alternative.
        reason: &'static str,
    },
    /// The number of deviation vectors is zero, or larger than the dimension of phase space.
    #[error("there are {count} deviation vectors, but a tangent requires 1 to {most}, twice the number of positions")]
    VectorCount {
        /// The number of vectors.
        count: usize,
        /// The largest number of vectors.
        most: usize,
    },
    /// A deviation vector is invalid or diverged.
    #[error("deviation vector {vector} {fault}")]
    Vector {
        /// The index of the vector, from 0.
        vector: usize,
        /// The fault of the vector.
        fault: VectorFault,
    },
    /// A gradient cannot be computed.
    #[error("the gradient is not available: {reason}")]
    NoGradient {
        /// The reason, and an alternative.
        reason: &'static str,
    },
    /// The derivatives that a function returned for its gradient are invalid.
    #[error("the derivative of the function with respect to the state after step {step} {fault}")]
    Loss {
        /// The number of steps up to the state.
        step: u64,
        /// The fault of the derivatives.
        fault: VectorFault,
    },
    /// The way back of a gradient did not end at the initial state.
    #[error(
        "the way back ended at a relative distance of {error:.1e} from the initial state, so that the gradient is not that of \
         the run\nhelp: take fewer steps, or start from `Phase::reversible(q, p, grid)`\nnote: the orbit is chaotic, and \
         rounding errors grow with its deviations"
    )]
    WayBack {
        /// The relative distance.
        error: f64,
    },
    /// The ensemble has no members.
    #[error("an ensemble requires at least one member")]
    NoMembers,
    /// A member of an ensemble is invalid.
    #[error("member {member}: {error}")]
    Member {
        /// The index of the member, from 0.
        member: usize,
        /// The reason.
        error: Box<Error>,
    },
    /// Several, but not all, members of an ensemble are invalid.
    #[error("{} of {count} members are invalid ({}); {}", members.len(), numbers_of(members), first_of(members))]
    Members {
        /// The indices of these members in ascending order, each with the reason.
        members: Vec<(usize, Error)>,
        /// The number of members.
        count: usize,
    },
    /// Members of an ensemble failed.
    #[error(transparent)]
    Lost(#[from] Lost),
    /// The energy errors of members of an ensemble exceed the bound of its watch.
    ///
    /// These members stay at the step before; all others have taken their steps.
    #[error(
        "{} exceeded the bound on their energy, or diverged ({}); the others continued; {}",
        count_of(members),
        numbers_of(members),
        first_of(members)
    )]
    Strayed {
        /// The members that stopped, in ascending order, each with [`Error::EnergyStrayed`], or with
        /// [`Error::Diverged`] if it diverged in the same call.
        members: Vec<(usize, Error)>,
    },
}

/// Returns what is wrong with an interval of time between samples, with a remedy.
fn interval_for(interval: f64, h: f64) -> String {
    match interval.is_finite() {
        true => format!(
            "but the steps of this run are {}, in the opposite direction\nhelp: write `samples_at({})`",
            Number(h),
            Number(-interval)
        ),
        false => format!(
            "which is not finite\nhelp: write a multiple of the step, such as `samples_at({})`",
            Number(10.0 * h)
        ),
    }
}

/// The number of members, as a noun.
fn count_of<T>(members: &[T]) -> String {
    match members.len() {
        1 => "1 member".to_owned(),
        count => format!("{count} members"),
    }
}

/// The indices of members, the first ones of many.
fn numbers_of<T>(members: &[(usize, T)]) -> String {
    let names: Vec<String> = members.iter().take(8).map(|(member, _)| member.to_string()).collect();
    let more = if members.len() > names.len() { ", ..." } else { "" };
    format!("{}{more}", names.join(", "))
}

/// The first member, with its error.
fn first_of<T: core::fmt::Display>(members: &[(usize, T)]) -> String {
    members.first().map(|(member, reason)| format!("member {member}: {reason}")).unwrap_or_default()
}

/// The fault of a deviation vector.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum VectorFault {
    /// The vector has another number of components than the state.
    #[error("has {} positions and {} momenta, but the state has {positions} of each", lengths[0], lengths[1])]
    Length {
        /// The numbers of positions and of momenta of the vector.
        lengths: [usize; 2],
        /// The number of positions of the state.
        positions: usize,
    },
    /// A component is infinite or NaN.
    #[error("is not finite")]
    NotFinite,
    /// The vector is zero.
    #[error("is zero and has no direction")]
    Zero,
    /// The vector diverged although the state is finite.
    #[error(
        "is not finite after step {step} (t = {time})\nnote: H has no second derivative there, or the vector exceeds the \
         range of its precision\nnote: the run stays at the state before this step",
        time = Number(*time)
    )]
    Lost {
        /// The step that was not taken.
        step: u64,
        /// The time at the end of that step.
        time: f64,
    },
}

/// The reason why a method could not compute a step.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Unsolved {
    /// Newton's iteration for an implicit step did not converge.
    #[error(
        "Newton's method did not converge for h = {h}: after {iterations} iterations, its update is {update:.1e} of the \
         state\nhelp: use a smaller step\nnote: at the beginning of the step, fixed-point iteration multiplies an error by \
         about {contraction:.1e}, which is proportional to h",
        h = Number(*h)
    )]
    Newton {
        /// The step.
        h: f64,
        /// The factor by which fixed-point iteration multiplies an error, from the derivatives at the beginning of the step. It
        /// may be larger within the step.
        contraction: f64,
        /// The number of iterations.
        iterations: u32,
        /// The last update, relative to the largest coordinate.
        update: f64,
    },
    /// The fixed-point iteration for an implicit step did not converge, and the library was built without the feature
    /// `check`, which brings Newton's.
    #[error(
        "the fixed-point iteration did not converge for h = {h}: after {iterations} iterations, its update is \
         {update:.1e} of the state\nhelp: use a smaller step, or enable the feature `check`, which provides Newton's \
         method",
        h = Number(*h)
    )]
    Contraction {
        /// The step.
        h: f64,
        /// The number of iterations.
        iterations: u32,
        /// The last update, relative to the largest coordinate.
        update: f64,
    },
    /// The motion comes near a singularity, and the steps of the Taylor method are too short for the clock.
    #[error(
        "the solution is singular near t = {time}, where steps of {reach:.1e} do not change the time",
        time = Number(*time)
    )]
    Singular {
        /// The approximate time of the singularity.
        time: f64,
        /// The length of the last step.
        reach: f64,
    },
    /// The crossings of the edges of a formula could not be separated; steps of the Taylor method have to end at them.
    #[error(
        "after t = {time}, the conditions of the Hamiltonian change too often for the Taylor method, or cannot be \
         bounded\nhelp: use a composition, or write the conditions without functions that are singular there"
    )]
    Edges {
        /// The time of the last step's beginning.
        time: f64,
    },
    /// The force jumps at an edge, so that the deviation vectors of a motion across it are unknown.
    #[error(
        "the force jumps at t = {time}, where a condition of the Hamiltonian changes\nhelp: make the force continuous \
         there\nnote: neighbouring orbits cross the jump at different times, which the derivative of a step does not \
         contain"
    )]
    Jump {
        /// The time of the crossing.
        time: f64,
    },
    /// The orbit of a Kepler part could not be followed.
    #[error(
        "the Kepler orbit of body {body} could not be computed for a time of {duration} from the distance \
         {distance:.3e}\nhelp: use a smaller step\nnote: the body meets the centre, or rounding leaves no digit of its \
         time or position",
        duration = Number(*duration)
    )]
    Kepler {
        /// The index of the body, from 0.
        body: usize,
        /// The distance of the body from the centre before the flow.
        distance: f64,
        /// The duration of the flow.
        duration: f64,
    },
    /// A time transformation left its domain.
    #[error(
        "this time transformation requires V < 0 along the whole orbit, but -V, or T - H(start) in its place, is \
         {value}\nhelp: subtract a constant in `potential`, or use a smaller step if V is far from zero\nnote: -V and T \
         - H(start) are equal up to the errors of the steps",
        value = Number(*value)
    )]
    Domain {
        /// The energy that is not positive.
        value: f64,
    },
    /// The rate of a time transformation is not positive.
    #[error(
        "`rate`, or the variable that follows it along the orbit, is {value}\nhelp: write a `rate` that is positive \
         everywhere",
        value = Number(*value)
    )]
    Rate {
        /// The rate.
        value: f64,
    },
    /// A step of a time transformation leapt over an edge of the domain, or is far too long.
    #[error(
        "the step is too long for a time transformation: T - H(start) is {followed}, but -V is {value}\nhelp: use a \
         smaller step, or subtract a constant in `potential` so that V stays far from zero\nnote: the two are equal up \
         to the errors of the steps",
        followed = Number(*followed), value = Number(*value)
    )]
    EnergiesApart {
        /// `T - H(start)` after a kick.
        followed: f64,
        /// `-V` at the kick.
        value: f64,
    },
    /// A step of [`Paced`](crate::Paced) leapt over an edge of the domain, or is far too long.
    #[error(
        "the step is too long for the time transformation: `rate` is {value}, but the variable that follows it is \
         {followed}\nhelp: use a smaller step, or a `rate` that varies less\nnote: the two are equal up to the errors of \
         the steps",
        followed = Number(*followed), value = Number(*value)
    )]
    RatesApart {
        /// The variable that follows the rate, after a kick.
        followed: f64,
        /// The rate at the kick.
        value: f64,
    },
    /// An adaptive method found no steps within its tolerance.
    #[error("no steps within the tolerance were found: {0}")]
    Adaptive(String),
}

/// A constant that depends on parameters only and is not finite.
#[derive(Clone, PartialEq, thiserror::Error)]
#[error("`{formula}` is {value}{}", self.place(), value = Number(*value))]
pub struct NotFinite {
    /// The formula of the constant, as in `kinetic` and `potential`, without `self`.
    pub formula: &'static str,
    /// The indices of the element, with their names and values, if a loop has one constant for each iteration.
    pub indices: Vec<(&'static str, usize)>,
    /// The value of the constant.
    pub value: f64,
}

impl NotFinite {
    fn place(&self) -> String {
        let each: Vec<String> = self.indices.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        if each.is_empty() { String::new() } else { format!(" for {}", each.join(", ")) }
    }
}

fn those_known(known: &[&str]) -> String {
    match known {
        [] => "help: put `#[invariant]` on a function of q and p in its impl".to_owned(),
        known => format!("note: its invariants are {}", known.join(", ")),
    }
}

fn listed(constants: &[NotFinite]) -> String {
    constants.iter().map(NotFinite::to_string).collect::<Vec<_>>().join("; ")
}

/// A difference between the value of a function of the user and that of the generated code.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[error(
    "`{function}` returns {stated}, but the generated code computes {generated} (t = {time}, {})\nhelp: please report \
     this function as a bug of `#[hamiltonian]`, and write it in another form until it is fixed\nnote: rounding explains \
     a difference of {rounding:.1e}",
    self.place(), stated = Number(*stated), generated = Number(*generated), time = Number(*time)
)]
pub struct Misread {
    /// `kinetic`, `potential` or `hamiltonian`, or the name of a part of H.
    pub function: &'static str,
    /// The value of the function.
    pub stated: f64,
    /// The value of the generated code.
    pub generated: f64,
    /// The largest difference that rounding can cause.
    pub rounding: f64,
    /// The time at this state.
    pub time: f64,
    /// The positions, flattened.
    pub q: Vec<f64>,
    /// The momenta, flattened.
    pub p: Vec<f64>,
}

impl Misread {
    /// The coordinates that the function depends on, the first ones of many.
    fn place(&self) -> String {
        let place = |name: &str, numbers: &[f64]| match numbers.get(..8).filter(|first| first.len() < numbers.len()) {
            Some(first) => format!("{name} begins with {first:?}"),
            None => format!("{name} = {numbers:?}"),
        };
        match self.function {
            "kinetic" => place("p", &self.p),
            "potential" => place("q", &self.q),
            _ => format!("{}, {}", place("q", &self.q), place("p", &self.p)),
        }
    }
}

/// The step in which a run diverged or left the range of its grid. The run stays at the last good state.
#[derive(Clone, PartialEq, thiserror::Error)]
#[error("{}", self.text())]
pub struct Divergence {
    /// The first step whose state is not finite.
    pub step: u64,
    /// The time at the end of that step.
    pub time: f64,
    /// The limit of coordinates: infinity, or the range of the grid of a reversible state.
    pub limit: f64,
    /// The first coordinate beyond the limit after that step: `q` or `p`, and its index in the flattened coordinates.
    ///
    /// `None` if it is unknown.
    pub coordinate: Option<(&'static str, usize)>,
    /// The positions one step earlier, flattened.
    pub q: Vec<f64>,
    /// The momenta one step earlier, flattened.
    pub p: Vec<f64>,
}

/// The number of positions, and of momenta, that the message of a divergence shows.
const SHOWN: usize = 4;

impl Divergence {
    /// Returns this error, at the time of the last finite state if the time is part of the state.
    pub(crate) fn at_own_time(self, time: Option<f64>) -> Self {
        Self { time: time.unwrap_or(self.time), ..self }
    }

    fn text(&self) -> String {
        let Self { step, q, p, .. } = self;
        let (time, limit) = (Number(self.time), Number(self.limit));
        let (fault, last, remedy) = if self.limit.is_finite() {
            (
                format!("has a coordinate outside of ±{limit}, the range of its grid"),
                "last state within it",
                "coarser grid",
            )
        } else {
            ("is not finite".to_owned(), "last finite state", "smaller step")
        };
        let first = self.coordinate.map(|(name, index)| format!(", first in {name}[{index}]")).unwrap_or_default();
        let (q, p) = (self.near("q", q), self.near("p", p));
        format!(
            "the state after step {step} (t = {time}) {fault}{first}\nhelp: use a {remedy}, or check the forces near the \
             {last}\nnote: the run stays at this state, {q}, {p}"
        )
    }

    /// The coordinates next to the one that failed, few enough for a message.
    fn near(&self, name: &str, numbers: &[f64]) -> String {
        if numbers.len() <= SHOWN {
            return format!("{name} = {numbers:?}");
        }
        let index = self.coordinate.map_or(0, |(_, index)| index);
        let start = index.saturating_sub(1).min(numbers.len() - SHOWN);
        let end = start + SHOWN;
        format!("{name}[{start}..{end}] = {:?} of {}", &numbers[start..end], numbers.len())
    }
}

/// The members of an ensemble that failed: they diverged, or the method could not compute their next step.
///
/// They stay at their last finite state; all others have taken their steps.
#[derive(Clone, PartialEq, thiserror::Error)]
#[error("{}", self.text())]
pub struct Lost {
    /// The members that failed in these steps, in ascending order, each with the step in which it failed.
    pub members: Vec<(usize, Divergence)>,
}

impl Lost {
    fn text(&self) -> String {
        let (count, numbers, first) = (count_of(&self.members), numbers_of(&self.members), first_of(&self.members));
        let first = if first.is_empty() { first } else { format!("; {first}") };
        format!("{count} failed ({numbers}); the others continued{first}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No message has a row of zeros, whatever number it shows.
    #[test]
    fn numbers_of_any_size_are_short_and_read_back() {
        let mut numbers =
            Vec::from([0.0, 1.0, -0.5, 1e-5, 9.9e-6, 999_999.5, 1e6, f64::MAX, f64::MIN_POSITIVE, 5e-324]);
        numbers.extend((-320..308).map(|exponent| 1.694573084669179 * 10.0_f64.powi(exponent)));
        for number in numbers.into_iter().flat_map(|number| [number, -number]) {
            let columns = format!("{:>13.6}", Number(number));
            assert!(columns.len() <= 14 && (number.abs() < 1e-300 || !columns.ends_with("0.000000")), "{columns}");
            let text = Number(number).to_string();
            assert_eq!(text.parse::<f64>().map(f64::to_bits), Ok(number.to_bits()), "{text}");
            assert!(text.len() <= 24 && !text.contains("000000"), "{text}");
            let errors = [
                Error::Step { h: number },
                Error::Time { time: number },
                Error::Energy { function: "potential", value: number, time: number },
                Error::Clock { h: number, time: number },
                Error::Crossing { time: number, value: number },
                Error::EnergyStrayed { step: 1, time: number, energy: number, before: number, bound: number },
                Error::Passed { time: number, present: number },
                Error::Interval { interval: number, h: number },
            ];
            let diverged =
                Divergence { step: 1, time: number, limit: number, coordinate: None, q: Vec::new(), p: Vec::new() };
            for text in errors.iter().map(Error::to_string).chain([diverged.to_string()]) {
                assert!(!text.contains("000000"), "{text}");
            }
        }
    }
}
