//! The check of generated energies against the user's own functions.
//!
//! In: a system and a state. Out: whether both are the same up to rounding. Always true: neither is derived from the
//! other, so that a misread text is detected here, however well its energy and its forces agree.

#[cfg(debug_assertions)]
use crate::{
    error::Error,
    state::{
        coords::Coords,
        flat::{flat, shaped},
        precision::Precision,
    },
    system::Shaped,
};
use crate::{
    error::Misread,
    scalar::{bounded::Bounded, real::Real},
    state::{flat::Flat, phase::Phase},
    system::{StatedEnergy, System, energy::part_names, motion::Motion},
};

/// The number of roundings of the user's function for each one of the generated code: where one adds in a loop, the
/// other may multiply, or read a constant that is prepared once per run. A misread text is off by far more.
const ROUNDINGS: f64 = 1024.0;

/// The number of neighbours of a state that the scatter of a function is estimated from, and their largest distance, in
/// roundings.
const NEIGHBOURS: u64 = 8;
const NEARBY: f64 = 256.0;

/// The largest system whose every run is checked at the start: a sum over the pairs of this number of coordinates takes a
/// second where code is not optimised.
#[cfg(debug_assertions)]
const SMALL: usize = 4096;

/// One of the two functions that a Hamiltonian is made of: the one of the momenta, or the one of the positions. If its
/// parts have names, these are the first part, and the sum of all others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Function {
    Kinetic,
    Potential,
}

impl Function {
    pub(crate) const BOTH: [Self; 2] = [Self::Kinetic, Self::Potential];

    /// Returns the generated energy that stands for it.
    pub(crate) fn energy<H: System, R: Real>(self, motion: &H::Motion<R, f64>, time: f64) -> R {
        match self {
            Self::Kinetic => H::kinetic::<R, f64>(motion, time),
            Self::Potential => H::potential::<R, f64>(motion, time),
        }
    }

    /// The user's function that it is, or is a part of.
    fn name<H: System>(self, is_whole: bool) -> &'static str {
        let [first, second] = part_names(H::PARTS);
        match self {
            _ if is_whole => "hamiltonian",
            Self::Kinetic => first,
            Self::Potential => second,
        }
    }
}

/// Whether the user's function and the generated code are the same at a state; `false` where rounding may have made
/// anything of the latter.
///
/// A number that is not finite in one of them must not be finite in the other: rewrites are exact for finite numbers,
/// and may turn infinity into NaN.
///
/// # Errors
/// [`Misread`], where rounding does not explain the difference.
pub(crate) fn hold(state: &Flat, time: f64, values: &dyn Fn(&Flat) -> Values) -> Result<bool, Misread> {
    let Values { stated, generated, rounding: error, name, .. } = values(state);
    // Subnormal energies count as zero.
    let mut rounding = ROUNDINGS * error + f64::MIN_POSITIVE;
    let agree = |rounding: f64| match [stated, generated].map(f64::is_finite) {
        [true, true] => Real::abs(stated - generated) <= rounding,
        [stated, generated] => stated == generated,
    };
    if error == f64::INFINITY {
        return Ok(false);
    }
    if !agree(rounding) {
        rounding += scatter(state, values);
    }
    if agree(rounding) {
        return Ok(true);
    }
    let (q, p) = (state.q.clone(), state.p.clone());
    Err(Misread { function: name, stated, generated, rounding, time, q, p })
}

/// The values of both at a state, and a bound on the rounding of the generated code.
pub(crate) struct Values {
    pub(crate) stated: f64,
    pub(crate) generated: f64,
    pub(crate) rounding: f64,
    /// The user's function.
    pub(crate) name: &'static str,
}

/// The values of a function; where the user wrote all of `H` in one, those of all of `H`, which changes with the coordinates of
/// either part as that part does.
pub(crate) fn values<H: System>(
    function: Function,
    system: &H,
    parameters: &H::Parameters<f64>,
    state: &Phase<H::Coords>,
    time: f64,
) -> Values {
    let stated = system.stated(&state.q, &state.p, time);
    let name = function.name::<H>(matches!(stated, StatedEnergy::Whole(_)));
    values_of((function, name), stated, &|function| bounded_energy::<H>(function, parameters, state, time))
}

/// The value of the generated code, and a bound on its rounding.
pub(crate) fn bounded_energy<H: System>(
    function: Function,
    parameters: &H::Parameters<f64>,
    state: &Phase<H::Coords>,
    time: f64,
) -> [f64; 2] {
    let motion = H::Motion::<Bounded, f64>::load(&[parameters; 2], &[state; 2]);
    let energy = function.energy::<H, Bounded>(&motion, time);
    [energy.lane(0), energy.lane(1)]
}

/// The values that the user states and that the generated code computes, the latter with a bound on its rounding.
fn values_of(
    (function, name): (Function, &'static str),
    stated: StatedEnergy,
    generated: &dyn Fn(Function) -> [f64; 2],
) -> Values {
    let (stated, [generated, rounding]) = match (stated, function) {
        (StatedEnergy::Separate { kinetic, .. }, Function::Kinetic) => (kinetic, generated(function)),
        (StatedEnergy::Separate { potential, .. }, Function::Potential) => (potential, generated(function)),
        (StatedEnergy::Whole(stated), _) => {
            let [[kinetic, of_kinetic], [potential, of_potential]] = Function::BOTH.map(generated);
            let sum = kinetic + potential;
            (stated, [sum, of_kinetic + of_potential + f64::EPSILON * sum.abs()])
        }
    };
    Values { stated, generated, rounding, name }
}

/// The scatter of the difference of both next to a state. The rounding of prepared numbers that nearly cancel in the
/// function differs from neighbour to neighbour; the error of a misread text does not.
fn scatter(state: &Flat, values: &dyn Fn(&Flat) -> Values) -> f64 {
    let mut digits = Digits::default();
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for _ in 0..NEIGHBOURS {
        let mut near = state.clone();
        for number in near.q.iter_mut().chain(&mut near.p) {
            *number *= 1.0 + NEARBY * f64::EPSILON * digits.next();
        }
        let Values { stated, generated, .. } = values(&near);
        (least, most) = (f64::min(least, stated - generated), f64::max(most, stated - generated));
    }
    if least <= most { 2.0 * (most - least) } else { 0.0 }
}

/// Numbers between -1 and 1 that look random and are the same in every run (Knuth's linear congruence).
pub(crate) struct Digits(u64);

impl Default for Digits {
    fn default() -> Self {
        Self(0x9E37_79B9_7F4A_7C15)
    }
}

impl Digits {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Holds the generated energies against the user's functions where a run starts, in builds with debug assertions. The
/// time is that of the clock when the run is made, since a run that is moved by `at_time` no longer has its system.
///
/// # Errors
/// [`Error::Misread`]
#[cfg(debug_assertions)]
pub(crate) fn hold_at_start<H: System, K: Precision>(
    system: &H,
    parameters: &H::Parameters<f64>,
    start: &Phase<Shaped<H, K>>,
    time: f64,
) -> Result<(), Error> {
    if start.q.flat().len() <= SMALL {
        let shape = Phase { q: start.q.map(|leaf| leaf.to_f64()), p: start.p.map(|leaf| leaf.to_f64()) };
        for function in Function::BOTH {
            let values = |state: &Flat| values(function, system, parameters, &shaped(&shape, state), time);
            hold(&flat(&shape), time, &values)?;
        }
    }
    Ok(())
}
