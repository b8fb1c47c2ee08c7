//! Certification: all checks in one, with a certificate or the shortfalls as the result.

use crate::{
    check::{
        CheckError,
        certificate::{Certificate, SecondPart, Tolerances},
        measurable::{Measurable, Measured},
        oracle::exact::Steps,
        property::{
            agreement::{Visited, agreement},
            drive::turns,
            energies::{Differentiable, Energies, gradient_tolerance},
            energy::EnergyDrift,
            flow_laws::{Broken, FlowErrors, flow_errors},
            gradient::error_at,
            invariants::{InvariantDrift, Strayed, bracket, scale},
            jumps::Jump,
            local_order::{OrderAlong, UNITS, order_along},
            order::{Order, needed_along, order_of, path},
            reversibility::RoundTrip,
            smallness::{SMALL, size_of_second_part},
            symplecticity::Defect,
        },
        shortfall::{CertifyError, Shortfall},
        start::{IntoStart, Start},
        statistics::{
            path::{PARTS, Path},
            points::{begin, flat_start, numbers},
        },
    },
    hamiltonian::Hamiltonian,
    scalar::tolerance::{largest, ratio, within},
    state::precision::Precision,
    system::{Shaped, dissipation::Dissipation, user_energies::Values},
    trajectory::method::Method,
};

/// The smallest number of steps of a round trip each way.
const ROUND_TRIP: u64 = 16;

/// The number of steps over which the energy is followed.
const ENERGY_STEPS: u64 = 8192;

/// The smallest number of units, where the order is searched for, in the time that four steps follow to a tenth.
/// Their halves are the coarsest steps.
const FOLLOWING: f64 = 3.0;

/// The largest number of pieces of an orbit that are examined: all of them, unless steps follow the motion by a
/// fortieth only.
const MOST_PIECES: u64 = 4096;

/// The factor by which steps are finer in a second search for the order, down to the step of the run.
const FINER: f64 = 8.0;

/// The number of pieces in this search for a state of few coordinates. Larger states have fewer pieces in proportion, because
/// each of them takes longer.
const MOST_FINE: u64 = 128;
const FEW_COORDINATES: u64 = 8;

/// The names of the checks of the flows, as `T(p)` and `V(q)` have them and as other parts do.
const GRADIENT: &str = "the gradient";
const FLOWS: &str = "the flows of the parts";

/// Over this many steps, `H` may turn at most as often by its explicit time.
const DRIVE_STEPS: u64 = 16;

/// The time over which gradients are taken, in steps, if no order suggests a better one.
const GRADIENT_SPAN: f64 = 64.0;

/// Verifies by measurement that `method` integrates `system` from `start` with step `h` as it claims.
///
/// A certificate confirms that
///
/// - one step is symplectic;
/// - errors decrease with the claimed order;
/// - a composition that claims symmetry is reversible;
/// - the energy has no drift, or no jumps if `H` depends on time;
/// - steps are shorter than half the period of a drive, if `H` depends on time;
/// - the second part of `H` is small, if the composition claims
///   [`GENERALISED_ORDERS`](crate::Scheme::GENERALISED_ORDERS);
/// - the flows are those of the energies, for each named part ([`FlowErrors`]);
/// - the Poisson bracket of `H` and each function with `#[invariant]` vanishes;
/// - generated energies and invariants agree with the user's own functions.
///
/// The bounds follow from the rounding errors of the scalar type. The energy is judged by the fraction of its deviation that
/// is a trend; derivatives of the user's functions by the accuracy of finite differences. The certificate warns if the step
/// is at least half the stability limit of the composition.
///
/// Small systems take milliseconds. The cost is proportional to the number of coordinates times the cost of the forces.
///
/// # Errors
/// - [`CertifyError::Run`]: the start or the step is invalid, as for [`Hamiltonian::run`].
/// - [`CertifyError::Friction`]: the system has friction.
/// - [`CertifyError::Refused`]: a property does not hold or cannot be measured. The error contains all measurements.
///
/// ```
/// use integrator_core::prelude::*;
///
/// struct Pendulum {
///     length: f64,
/// }
///
/// #[hamiltonian]
/// impl Pendulum {
///     fn kinetic(&self, p: [f64; 1]) -> f64 {
///         p[0].powi(2) / (2.0 * self.length.powi(2))
///     }
///     fn potential(&self, q: [f64; 1]) -> f64 {
///         -9.81 * self.length * q[0].cos()
///     }
/// }
///
/// let certificate = certify(&Pendulum { length: 0.5 }, Yoshida4, Phase::new([2.0], [0.0]), 0.01)?;
/// println!("{certificate}");
/// assert!(certificate.symplectic_defect < 1e-14);
/// # Ok::<(), integrator_core::check::CertifyError>(())
/// ```
pub fn certify<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
) -> Result<Certificate, CertifyError> {
    if !matches!(H::DISSIPATION, Dissipation::None) {
        return Err(CertifyError::Friction);
    }
    let start = start.into_start();
    let begun = begin::<H, X, K>(system, method, &start, h)?;
    let energies = Energies::new(system, &begun.phase);
    let steps = Steps::new(system, method, &begun.phase);
    let measured = Measured::<H, X, K> { system, method, start: &start, h, energies, steps };
    certificate(&Subject { measured: &measured, start: flat_start(&begun), h })
}

/// The certificate of a subject.
fn certificate(subject: &Subject<'_>) -> Result<Certificate, CertifyError> {
    let facts = subject.measured.stepper().facts();
    let autonomous = subject.measured.stepper().autonomous();
    let mut findings = Findings::default();

    let defect = findings.judge("symplecticity", subject.measured.defect(), |defect| {
        let &Defect { size: defect, tolerance } = defect;
        (!within(defect, tolerance)).then_some(Shortfall::Symplecticity { defect, tolerance })
    });
    if !facts.symplectic {
        findings.0.push(Shortfall::NotSymplectic { method: facts.name });
    }
    let order = findings.judge("the order", subject.order(), |order| {
        let (observed, claimed) = (order.slope, facts.order);
        (!order.reaches(claimed)).then_some(Shortfall::Order { observed, claimed })
    });
    let held = order.is_some_and(|order| order.reaches(facts.order));
    // Where no order could be measured, the reason is reported already.
    let course = order.map(|order| subject.order_along_orbit(order.followed));
    // An order that shows nowhere is not lost, and is reported already, too.
    let loss = course.and_then(|course| course.loss).filter(|loss| held || loss.time != subject.start.time);
    findings.0.extend(loss.map(|loss| Shortfall::OrderLost {
        time: loss.time,
        observed: loss.order,
        claimed: facts.order,
    }));
    let trip = findings.judge("reversibility", subject.round_trip(order), |trip| {
        let &RoundTrip { distance, tolerance } = trip;
        let returned = !facts.symmetric || within(distance, tolerance);
        (!returned).then_some(Shortfall::Reversibility { distance, tolerance })
    });
    let energy = autonomous.then(|| {
        findings.judge("the energy", subject.energy(order), |drift| {
            let shortfall = if drift.is_lost() { Shortfall::EnergyLost } else { Shortfall::EnergyDrift };
            (!drift.may_stay()).then(|| shortfall(*drift))
        })
    });
    let energy = energy.flatten();
    if !autonomous {
        // An energy that is conserved shows its jumps itself.
        findings.judge("jumps of the energies", subject.measured.jump(subject.h, ENERGY_STEPS), |jump| {
            jump.as_ref().map(|jump| subject.energy_jumps(jump))
        });
    }
    let finer = energy.filter(|drift| !within(drift.deviation, drift.rounding)).and_then(|drift| {
        findings.judge("the energy in finer steps", subject.finer_energy(&drift), |finer| {
            (held && drift.may_stay() && !drift.shrinks_to(finer, needed_of_energy(facts.order))).then(|| {
                Shortfall::EnergyNotExplained { drift: Box::new(drift), finer: Box::new(*finer), order: facts.order }
            })
        })
    });
    let states = subject.states(order);
    let gradient_tolerance = gradient_tolerance(subject.start.phase.q.len());
    if !autonomous {
        findings.0.extend(subject.drive(states.as_deref().unwrap_or_default()));
    }
    let is_separable = subject.measured.stated().energies().is_separable();
    let start = [(subject.start.phase.clone(), subject.start.time)];
    // If no step size works, the error at the start is the reason.
    let visited = states.as_deref().unwrap_or(&start);
    let (gradient, flows) = if is_separable || subject.measured.stated().energies().in_one_piece() {
        let gradient = findings.judge(GRADIENT, subject.gradient(visited), |error| {
            let (error, tolerance) = (*error, gradient_tolerance);
            (!within(error, tolerance)).then_some(Shortfall::Gradient { error, tolerance })
        });
        (gradient, None)
    } else {
        (None, findings.judge_flows(subject.flows(visited)))
    };
    let agreement = match states.as_ref().map(|states| agreement(subject.measured.stated(), states)) {
        Ok(Ok(outcome)) => findings.judge("the agreement with your own functions", outcome, |_| None),
        Ok(Err(disagreements)) => {
            findings.0.extend(disagreements.into_iter().map(Shortfall::of));
            None
        }
        Err(reason) => findings.judge("the agreement with your own functions", Err(reason.clone()), |_| None),
    };

    let orders = facts.generalised_orders;
    let second_part = (!orders.is_empty())
        .then(|| size_of_second_part(subject.measured.stated().energies(), visited))
        .flatten()
        .map(|size| SecondPart { size, orders });
    findings.0.extend(second_part.filter(|part| !within(part.size, SMALL)).map(Shortfall::NotSmall));

    let invariants = match &states {
        Ok(states) => findings.judge("the invariants", subject.invariants(states), |_| None).unwrap_or_default(),
        // Why there are none is reported already.
        Err(_) => Vec::new(),
    };
    findings.0.extend(invariants.iter().filter(|drift| !drift.is_conserved()).cloned().map(Shortfall::NotInvariant));

    // The limit is that of an oscillator that is split into T and V, or the resonance of inner steps.
    let stability = facts
        .stability_limit
        .filter(|_| is_separable || facts.innermost.is_some())
        .and_then(|limit| findings.judge("the stability", subject.measured.stability(limit), |_| None));

    let certificate = Certificate {
        system: subject.measured.system(),
        composition: facts.name,
        step: subject.h,
        time: subject.start.time,
        claimed_order: facts.order,
        symmetric: facts.symmetric,
        autonomous,
        symplectic_defect: defect.as_ref().map_or(f64::NAN, |defect| defect.size),
        observed_order: order.map_or(f64::NAN, |order| order.slope),
        order,
        order_until: course.map_or(f64::NAN, |course| course.until),
        reversibility: trip.as_ref().map_or(f64::NAN, |trip| trip.distance),
        energy_drift: energy,
        finer_energy_drift: finer,
        gradient_error: gradient.unwrap_or(f64::NAN),
        flows,
        agreement,
        second_part,
        invariants,
        stability,
        tolerances: Tolerances {
            symplectic_defect: defect.map_or(f64::NAN, |defect| defect.tolerance),
            reversibility: trip.map_or(f64::NAN, |trip| trip.tolerance),
            gradient_error: gradient_tolerance,
        },
    };
    findings.conclude(certificate)
}

/// The power of the step with which the deviation of the energy has to shrink. It is the largest of a long run, in
/// steps as coarse as the user's, whose leading error need not prevail; that of a potential that jumps does not shrink
/// at all.
fn needed_of_energy(claimed: u32) -> f64 {
    f64::from(claimed) / 2.0
}

/// The shortfalls so far.
#[derive(Default)]
struct Findings(Vec<Shortfall>);

impl Findings {
    /// Keeps a measurement, and records a shortfall if it fails or could not be made.
    fn judge<T>(
        &mut self,
        check: &'static str,
        outcome: Result<T, CheckError>,
        verdict: impl FnOnce(&T) -> Option<Shortfall>,
    ) -> Option<T> {
        match outcome {
            Ok(measured) => {
                self.0.extend(verdict(&measured));
                Some(measured)
            }
            Err(reason) => {
                self.0.push(Shortfall::Unmeasured { check, reason });
                None
            }
        }
    }

    /// Keeps the errors of the flows of parts, and records the first offence against each law.
    fn judge_flows(&mut self, outcome: Result<(FlowErrors, Vec<Shortfall>), CheckError>) -> Option<FlowErrors> {
        let (errors, broken) = self.judge(FLOWS, outcome, |_| None)?;
        self.0.extend(broken);
        Some(errors)
    }

    fn conclude(mut self, certificate: Certificate) -> Result<Certificate, CertifyError> {
        // Without a finite derivative there is no motion, and nothing else that was measured of it means anything.
        let is_cause = |shortfall: &Shortfall| {
            matches!(shortfall, Shortfall::Unmeasured { check: GRADIENT | FLOWS, reason: CheckError::NotFinite { .. } })
        };
        if self.0.iter().any(is_cause) {
            self.0.retain(|shortfall| is_cause(shortfall) || matches!(shortfall, Shortfall::Misread(_)));
        }
        // A run that fails explains the other shortfalls.
        self.0.sort_by_key(|shortfall| !matches!(shortfall, Shortfall::Unmeasured { reason: CheckError::Run(_), .. }));
        if self.0.is_empty() {
            Ok(certificate)
        } else {
            Err(CertifyError::Refused { certificate: Box::new(certificate), shortfalls: self.0 })
        }
    }
}

/// The subject of a certificate: a stepper, a start and a step.
struct Subject<'s> {
    measured: &'s dyn Measurable,
    start: Start<Vec<f64>>,
    h: f64,
}

impl Subject<'_> {
    fn order(&self) -> Result<Order, CheckError> {
        order_of(self.measured.stepper(), self.start.clone(), self.h)
    }

    /// Whether the order holds along the orbit, as far as the energy is followed and as far as the order was tried.
    ///
    /// A unit is the step of the run, halved or doubled until some of them follow the motion where the order was tried.
    /// Where the Hamiltonian reads the time, which may switch something at one of the steps, it is not doubled.
    fn order_along_orbit(&self, followed: f64) -> OrderAlong {
        let stepper = self.measured.stepper();
        let autonomous = stepper.autonomous();
        let mut unit = self.h;
        let longest = 1.01 * followed.abs() / FOLLOWING;
        while within(2.0 * unit, longest) && autonomous {
            unit *= 2.0;
        }
        while !within(unit, longest) {
            unit /= 2.0;
        }
        let span = ENERGY_STEPS as f64 * self.h.abs();
        let span = if autonomous { span.max(followed.abs()) } else { span };
        let piece = unit * UNITS as f64;
        let pieces = ((span / piece.abs()).ceil() as u64).min(MOST_PIECES);
        let needed = needed_along(stepper.facts().order);
        let measured = (stepper, self.measured.stated().energies() as &dyn Differentiable);
        let along = order_along(measured, needed, &self.start, (piece, pieces));
        if along.loss.is_some() || within(unit, self.h.abs()) {
            return along;
        }
        // In finer steps, the error of a missing derivative exceeds those that shrink faster. At sudden turns of a motion,
        // high orders are seen in steps that are finer still.
        let piece = (unit / FINER).abs().max(self.h.abs()).copysign(self.h) * UNITS as f64;
        let coordinates = self.start.phase.q.len() as u64;
        let pieces = (MOST_FINE * FEW_COORDINATES / coordinates.max(FEW_COORDINATES)).max(1);
        let fine = order_along(measured, needed.min(needed_along(4)), &self.start, (piece, pieces));
        if fine.loss.is_some() { fine } else { along }
    }

    /// A round trip over the span of the order, in the coarsest steps that show it, or in steps of `h` where they are
    /// longer. Coming back does not depend on the step where a composition is symmetric; where it is not, it misses by
    /// its own error, which fine steps would hide in the rounding.
    fn round_trip(&self, order: Option<Order>) -> Result<RoundTrip, CheckError> {
        let (h, steps) = order.map_or((self.h, ROUND_TRIP), |order| {
            let h = order.coarsest.max(self.h.abs());
            (h.copysign(self.h), ((order.span.abs() / h).round() as u64).max(ROUND_TRIP))
        });
        self.measured.round_trip(h, steps)
    }

    /// The drift of the energy in steps of `h`. If it has a trend, this may be the flank of an oscillation that the run
    /// is too short to see the end of: then longer steps decide, up to the coarsest one that follows the motion. A true
    /// trend is one at every step.
    fn energy(&self, order: Option<Order>) -> Result<EnergyDrift, CheckError> {
        let course = |h| self.measured.energy_drift(h, ENERGY_STEPS);
        let drift = course(self.h)?;
        let coarsest = order.map_or(0.0, |order| (order.span / PARTS as f64).abs());
        let mut h = 2.0 * self.h;
        while !drift.is_bounded() && within(h, coarsest) {
            match course(h) {
                Ok(longer) if longer.is_bounded() => return Ok(longer),
                _ => h *= 2.0,
            }
        }
        Ok(drift)
    }

    /// The drift of the energy over the same time in steps of half the length.
    fn finer_energy(&self, drift: &EnergyDrift) -> Result<EnergyDrift, CheckError> {
        let (h, steps) = (drift.step / 2.0, 2 * drift.steps);
        self.measured.energy_drift(h, steps)
    }

    /// The shortfall that a jump is.
    fn energy_jumps(&self, Jump { part, by, time, state }: &Jump) -> Shortfall {
        let (by, time) = (*by, *time);
        let Values { name: function, .. } = self.measured.stated().values(*part, state, time);
        Shortfall::EnergyJumps { function, by, time, state: numbers(state).collect() }
    }

    /// The start and states along the path, each with its time: at the start alone, momenta are often zero, and where
    /// they are zero a wrong factor in their gradient does not show.
    fn states(&self, order: Option<Order>) -> Result<Vec<Visited>, CheckError> {
        let (span, step) = order.map_or((GRADIENT_SPAN * self.h, self.h), |order| (order.span, order.coarsest));
        let steps = (span / step).abs().round() as u64 / PARTS;
        let Path { start, ends } = path(self.measured.stepper(), &self.start, span, steps)?;
        let times = (0..).map(|part| self.start.time + span * f64::from(part) / PARTS as f64);
        Ok([start].into_iter().chain(ends).zip(times).collect())
    }

    /// A shortfall if `H` turns more than once per step by its explicit time, at one of these states.
    fn drive(&self, states: &[Visited]) -> Option<Shortfall> {
        let (energies, span) = (self.measured.stated().energies(), DRIVE_STEPS as f64 * self.h);
        let turns = states.iter().map(|(state, time)| turns(energies, state, *time, span)).max()?;
        let (half, step) = (span.abs() / turns as f64, self.h);
        (turns > DRIVE_STEPS).then_some(Shortfall::DriveNotResolved { half, step })
    }

    /// The errors of the flows of parts at some states, and for each part the first offence against each law.
    fn flows(&self, states: &[Visited]) -> Result<(FlowErrors, Vec<Shortfall>), CheckError> {
        let mut most = FlowErrors::default();
        let mut broken: Vec<Shortfall> = Vec::new();
        for (state, time) in states {
            self.measured.begin(state, *time)?;
            let (errors, offences) = flow_errors(self.measured.stated().energies(), state, *time, self.h)?;
            most = most.and(errors);
            for Broken { part, law, error, tolerance, duration } in offences {
                let is_same = |other: &Shortfall| matches!(other, Shortfall::Flow { part: of, law: by, .. } if *of == part && *by == law);
                if !broken.iter().any(is_same) {
                    let (time, state) = (*time, numbers(state).collect());
                    broken.push(Shortfall::Flow { part, law, error, tolerance, duration, time, state });
                }
            }
        }
        Ok((most, broken))
    }

    /// Measures each invariant: its bracket at some states, and its deviation in a run.
    fn invariants(&self, states: &[Visited]) -> Result<Vec<InvariantDrift>, CheckError> {
        let system = self.measured.stated().energies();
        let Strayed { deviations, steps, rounding } = self.measured.strayed(self.h, ENERGY_STEPS)?;
        let drift = |(number, (name, deviation)): (usize, (&&'static str, f64))| {
            let brackets = states.iter().map(|(state, time)| bracket(system, number, state, *time));
            let bracket = largest(brackets.collect::<Result<Vec<_>, _>>()?);
            let scale = largest(states.iter().map(|(state, _)| scale(system, number, state)));
            Ok(InvariantDrift { name, bracket, deviation: ratio(deviation, scale), rounding, steps })
        };
        system.invariants().iter().zip(deviations).enumerate().map(drift).collect()
    }

    /// The largest error of a gradient at some states.
    fn gradient(&self, states: &[Visited]) -> Result<f64, CheckError> {
        let errors = states.iter().map(|(state, time)| {
            self.measured.begin(state, *time)?;
            error_at(self.measured.stated().energies(), state, *time)
        });
        Ok(largest(errors.collect::<Result<Vec<_>, _>>()?))
    }
}
