//! Work–precision curves of the other crates, each used as its documentation says, and without output while timed.

use crate::fields::{Case, Field};
use differential_equations::{
    methods::SymplecticIntegrator,
    prelude::{ControlFlag, ExplicitRungeKutta, IVP, Interpolation, ODE, Solout, Solution},
};
use integrator_bench::precision::Curve;
use nalgebra::SVector;
use ode_solvers::{Dop853, OutputType};
use std::{hint::black_box, ops::ControlFlow};
use utsuroi::{DynamicalSystem, State, Tolerances};

/// Number of energy samples per run.
const LOOKS: u64 = 256;

/// The largest energy error so far, and the final positions.
struct Look<'c, F, const D: usize> {
    case: &'c Case<F, D>,
    energy: f64,
    end: [f64; D],
}

impl<'c, F: Field<D>, const D: usize> Look<'c, F, D> {
    fn new(case: &'c Case<F, D>) -> Self {
        Self { case, energy: 0.0, end: case.q }
    }
    fn at(&mut self, q: &[f64; D], v: &[f64; D]) {
        self.energy = self.energy.max(self.case.energy_error(q, v));
        self.end = *q;
    }
    fn at_flat(&mut self, y: &[f64]) {
        let (q, v) = y.split_at(D);
        self.at(q.try_into().expect("positions"), v.try_into().expect("velocities"));
    }
    /// Returns the energy error and the error at the end, or `None` if one of them is not finite.
    fn errors(&self) -> Option<[f64; 2]> {
        let errors = [self.energy, self.case.global_error(&self.end)];
        errors.iter().all(|error| error.is_finite()).then_some(errors)
    }
}

/// Measures all methods of all peers on a problem with `N` = 2 `D` coordinates. `evaluations` is the number of force
/// evaluations with the longest steps.
pub fn curves<F: Field<D>, const D: usize, const N: usize>(case: &Case<F, D>, evaluations: u64) -> Vec<Curve> {
    type Run<'r, F, const D: usize> = dyn Fn(u64, Option<&mut Look<F, D>>) + 'r;
    type Solve<'r, F, const D: usize> = dyn Fn(f64, Option<&mut Look<F, D>>) + 'r;
    let fixed = |name: &str, forces: u64, run: &Run<F, D>| {
        let steps = |level: u32| (evaluations / forces).next_power_of_two() << level;
        let errors = |level| {
            let mut look = Look::new(case);
            run(steps(level), Some(&mut look));
            look.errors()
        };
        Curve::measure(name.to_owned(), false, 0..14, errors, |level| run(steps(level), None))
    };
    let adaptive = |name: &str, solve: &Solve<F, D>| {
        let tolerance = |level: u32| 10.0_f64.powf(-3.0 - f64::from(level));
        let errors = |level| {
            let mut look = Look::new(case);
            solve(tolerance(level), Some(&mut look));
            look.errors()
        };
        Curve::measure(name.to_owned(), false, 0..12, errors, |level| solve(tolerance(level), None))
    };
    let system = Flat::<_, D, N>(case);
    let ivp = || IVP::ode(&system, 0.0, case.span, system.start());
    macro_rules! utsuroi {
        ($method:ident) => {
            &|steps, look| utsuroi_steps(case, steps, look, |t, y, h| utsuroi::$method.step(&system, t, y, h))
        };
    }
    macro_rules! differential_equations {
        ($method:ident) => {
            &|steps, look| {
                let method = SymplecticIntegrator::$method(case.span / steps as f64).max_steps(usize::MAX);
                black_box(ivp().method(method).solout(Watch::new(steps, look)).solve().is_ok());
            }
        };
    }
    vec![
        fixed("utsuroi StormerVerlet", 2, utsuroi!(StormerVerlet)),
        fixed("utsuroi Yoshida4", 6, utsuroi!(Yoshida4)),
        fixed("utsuroi Yoshida6", 14, utsuroi!(Yoshida6)),
        fixed("utsuroi Yoshida8", 30, utsuroi!(Yoshida8)),
        adaptive("utsuroi Dop853", &|tolerance, look| utsuroi_dop853(&system, tolerance, look)),
        fixed("differential-equations velocity_verlet", 2, differential_equations!(velocity_verlet)),
        fixed("differential-equations ruth_forest", 8, differential_equations!(ruth_forest)),
        adaptive("differential-equations dop853", &|tolerance, look| {
            let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(usize::MAX);
            black_box(ivp().method(method).solout(Watch::new(LOOKS, look)).solve().is_ok());
        }),
        adaptive("ode_solvers Dop853", &|tolerance, look| ode_solvers_dop853(&system, tolerance, look)),
    ]
}

/// Wraps a case for the traits of the other crates.
struct Flat<'c, F, const D: usize, const N: usize>(&'c Case<F, D>);

impl<F, const D: usize, const N: usize> Clone for Flat<'_, F, D, N> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<F, const D: usize, const N: usize> Copy for Flat<'_, F, D, N> {}

impl<F: Field<D>, const D: usize, const N: usize> Flat<'_, F, D, N> {
    /// Returns positions, then velocities.
    fn start(&self) -> [f64; N] {
        std::array::from_fn(|i| if i < D { self.0.q[i] } else { self.0.v[i - D] })
    }
    #[inline]
    fn derivative(&self, y: &[f64], dy: &mut [f64]) {
        dy[..D].copy_from_slice(&y[D..]);
        dy[D..].copy_from_slice(&self.0.field.acceleration(y[..D].try_into().expect("positions")));
    }
}

impl<F: Field<D>, const D: usize, const N: usize> DynamicalSystem for Flat<'_, F, D, N> {
    type State = State<D, 2>;
    #[inline]
    fn derivatives(&self, _: f64, state: &State<D, 2>) -> State<D, 2> {
        let acceleration = self.0.field.acceleration(&state.y().data.0[0]);
        State::from_derivative(*state.dy(), acceleration.into())
    }
}

impl<F: Field<D>, const D: usize, const N: usize> ODE<f64, [f64; N]> for Flat<'_, F, D, N> {
    #[inline]
    fn diff(&self, _: f64, y: &[f64; N], dy: &mut [f64; N]) {
        self.derivative(y, dy);
    }
}

impl<F: Field<D>, const D: usize, const N: usize> ode_solvers::System<f64, SVector<f64, N>> for Flat<'_, F, D, N> {
    #[inline]
    fn system(&self, _: f64, y: &SVector<f64, N>, dy: &mut SVector<f64, N>) {
        self.derivative(y.as_slice(), dy.as_mut_slice());
    }
}

fn look_at<F: Field<D>, const D: usize>(look: &mut Look<F, D>, state: &State<D, 2>) {
    look.at(&state.y().data.0[0], &state.dy().data.0[0]);
}

fn utsuroi_steps<F: Field<D>, const D: usize>(
    case: &Case<F, D>,
    steps: u64,
    mut look: Option<&mut Look<F, D>>,
    step: impl Fn(f64, &State<D, 2>, f64) -> State<D, 2>,
) {
    let h = case.span / steps as f64;
    let every = (steps / LOOKS).max(1);
    let mut state = State::<D, 2>::new(case.q.into(), case.v.into());
    for done in 0..steps {
        state = step(done as f64 * h, &state, h);
        if let Some(look) = &mut look
            && (done + 1).is_multiple_of(every)
        {
            look_at(look, &state);
        }
    }
    black_box(state);
}

fn utsuroi_dop853<F: Field<D>, const D: usize, const N: usize>(
    system: &Flat<F, D, N>,
    tolerance: f64,
    mut look: Option<&mut Look<F, D>>,
) {
    let case = system.0;
    let start = State::<D, 2>::new(case.q.into(), case.v.into());
    let tolerances = Tolerances { atol: tolerance, rtol: tolerance };
    let mut stepper = utsuroi::Dop853.stepper(system, start, 0.0, case.span * 1e-5, tolerances);
    let seen = |_: f64, state: &State<D, 2>| {
        if let Some(look) = &mut look {
            look_at(look, state);
        }
    };
    black_box(stepper.advance_to(case.span, seen, |_, _| ControlFlow::<()>::Continue(())).is_ok());
}

/// Output callback for `differential-equations`.
struct Watch<'l, 'c, F, const D: usize> {
    look: Option<&'l mut Look<'c, F, D>>,
    every: u64,
    seen: u64,
}

impl<'l, 'c, F, const D: usize> Watch<'l, 'c, F, D> {
    fn new(steps: u64, look: Option<&'l mut Look<'c, F, D>>) -> Self {
        Self { look, every: (steps / LOOKS).max(1), seen: 0 }
    }
}

impl<F: Field<D>, const D: usize, const N: usize> Solout<f64, [f64; N]> for Watch<'_, '_, F, D> {
    fn solout<I: Interpolation<f64, [f64; N]> + ?Sized>(
        &mut self,
        t: f64,
        _: f64,
        y: &[f64; N],
        _: &[f64; N],
        _: &mut I,
        _: &mut Solution<f64, [f64; N]>,
    ) -> ControlFlag<f64, [f64; N]> {
        if let Some(look) = &mut self.look {
            self.seen += 1;
            if self.seen.is_multiple_of(self.every) || t >= look.case.span {
                look.at_flat(y);
            }
        }
        ControlFlag::Continue
    }
}

fn ode_solvers_dop853<F: Field<D>, const D: usize, const N: usize>(
    system: &Flat<F, D, N>,
    tolerance: f64,
    look: Option<&mut Look<F, D>>,
) {
    let (span, start) = (system.0.span, system.start().into());
    // Default parameters, except for the limit on the number of steps and the output, which stores the steps
    // themselves.
    let (safety, beta, least, most) = (0.9, 0.0, 0.333, 6.0);
    let (first, steps, stiffness) = (0.0, u32::MAX, u32::MAX);
    let mut solver = Dop853::from_param(
        *system,
        0.0,
        span,
        span,
        start,
        tolerance,
        tolerance,
        safety,
        beta,
        least,
        most,
        span,
        first,
        steps,
        stiffness,
        OutputType::Sparse,
    );
    let solved = solver.integrate().is_ok();
    if let Some(look) = look.filter(|_| solved) {
        solver.y_out().iter().for_each(|y| look.at_flat(y.as_slice()));
    }
    black_box(solver.y_out().last().copied());
}
