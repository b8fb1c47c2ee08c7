//! Methods with step-size control by a tolerance, from the crate `differential-equations`.
//!
//! That crate has all three for plain vectors and accepts a Jacobian. `ode_solvers` has no stiff method, and diffsol
//! requires equations in its own matrix types.

use crate::{
    field::{Field, Generated},
    walk::{Place, Recipe},
};
use differential_equations::{
    error::Error as Failure,
    linalg::Matrix,
    prelude::{BackwardDifferentiationFormula, ExplicitRungeKutta, IVP, ODE, Solution},
};
use integrator_core::{
    __private::{Real, System},
    Coords, Described, Error, Facts, Phase, Unsolved,
};
use nalgebra::DMatrix;

/// A field as that crate sees it: the lanes of a state one after the other. A dual is integrated with its tangent, by
/// the variational equation. Numbers are plain here, so that the crate's methods are compiled with this one and not with each
/// system.
trait Flat {
    fn derivative(&self, time: f64, y: &[f64]) -> Vec<f64>;
    /// The Jacobian in a lane.
    fn jacobian(&self, time: f64, y: &[f64]) -> DMatrix<f64>;
}

/// All lanes as one list.
fn flat<R: Real>(y: &[R]) -> Vec<f64> {
    let mut flat = Vec::with_capacity(R::LANES * y.len());
    for lane in 0..R::LANES {
        flat.extend(y.iter().map(|y| y.lane(lane)));
    }
    flat
}

/// The numbers whose lanes these are.
fn lanes<R: Real>(flat: &[f64]) -> Vec<R> {
    let count = flat.len() / R::LANES;
    (0..count).map(|i| R::state(&|lane| flat[lane * count + i])).collect()
}

struct Lanes<'f, R>(&'f dyn Field<R>);

impl<R: Real> Flat for Lanes<'_, R> {
    fn derivative(&self, time: f64, y: &[f64]) -> Vec<f64> {
        flat(&self.0.derivative(&lanes::<R>(y), time))
    }
    fn jacobian(&self, time: f64, y: &[f64]) -> DMatrix<f64> {
        self.0.jacobian(&y[..y.len() / R::LANES], time)
    }
}

impl ODE<f64, Vec<f64>> for &dyn Flat {
    fn diff(&self, time: f64, y: &Vec<f64>, derivative: &mut Vec<f64>) {
        *derivative = self.derivative(time, y);
    }

    /// The Jacobian in every lane. How the tangents of a dual depend on its value is left out: Newton's iteration, for
    /// which the matrix is wanted, finds the same end with a matrix that is nearly right.
    fn jacobian(&self, time: f64, y: &Vec<f64>, to: &mut Matrix<f64>) {
        let jacobian = Flat::jacobian(*self, time, y);
        let count = jacobian.nrows();
        for row in 0..y.len() {
            for column in 0..y.len() {
                let same = row / count == column / count;
                to[(row, column)] = if same { jacobian[(row % count, column % count)] } else { 0.0 };
            }
        }
    }
}

/// A function that integrates from the beginning of a span to its end by one of these methods, with tolerances.
type Solve = fn(&dyn Flat, [f64; 2], Vec<f64>, Tolerances) -> Result<Solution<f64, Vec<f64>>, Failure<f64, Vec<f64>>>;

/// The tolerance of a step: relative, and absolute for each number of the state.
struct Tolerances {
    relative: f64,
    absolute: Vec<f64>,
}

/// Returns the increment of a step.
fn increment<R: Real>(from: &Place<'_, R>, tolerance: f64, solve: Solve) -> Result<Vec<R>, Unsolved> {
    let start = flat(from.y);
    if from.h == 0.0 {
        return Ok(from.derivative().into_iter().map(|slope| R::of(0.0) * slope).collect());
    }
    let span = [from.time, from.time + from.h];
    let tolerances = Tolerances { relative: tolerance, absolute: vec![tolerance; start.len()] };
    let solution = solve(&Lanes(from.field), span, start.clone(), tolerances).map_err(unsolved)?;
    let Some(end) = solution.y.last() else { return Err(Unsolved::Adaptive("no end was returned".to_owned())) };
    let moved: Vec<f64> = end.iter().zip(&start).map(|(end, start)| end - start).collect();
    Ok(lanes(&moved))
}

/// Returns the times and states at the ends of the steps over a span from time 0.
fn steps<H: System>(
    system: &H,
    start: &Phase<H::Coords>,
    span: f64,
    absolute: Vec<f64>,
    solve: Solve,
) -> Result<Vec<(f64, Vec<f64>)>, Unsolved> {
    let parameters = system.parameters(start.q.length());
    let field = Generated::<H> { parameters: &parameters, shape: start, middle: span / 2.0, evaluations: 0.into() };
    let numbers = [start.q.flat(), start.p.flat()].concat();
    let tolerances = Tolerances { relative: 0.0, absolute };
    let solution = solve(&Lanes::<f64>(&field), [0.0, span], numbers, tolerances).map_err(unsolved)?;
    Ok(solution.t.into_iter().zip(solution.y).collect())
}

/// The reason of the crate, without the state, which the error of the run contains.
fn unsolved(failure: Failure<f64, Vec<f64>>) -> Unsolved {
    Unsolved::Adaptive(match failure {
        Failure::BadInput { msg } => msg,
        Failure::MaxSteps { t, .. } => format!("too many steps up to t = {t}"),
        Failure::StepSize { t, .. } => format!("the steps become too small at t = {t}"),
        Failure::Stiffness { t, .. } => format!("the equations are stiff at t = {t}"),
        Failure::LinearAlgebra { t, msg, .. } => format!("{msg} at t = {t}"),
        _ => "for an unknown reason".to_owned(),
    })
}

macro_rules! adaptive {
    ($($(#[$doc:meta])* $name:ident: order $order:literal, $method:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name {
            /// The error tolerance of a step: absolute for coordinates below one, relative for larger ones.
            pub tolerance: f64,
        }

        impl Described for $name {
            fn facts(self) -> Facts {
                facts! {
                    name: stringify!($name),
                    order: $order,
                    adaptive: true,
                    roundings: 16 }
            }
            fn admissible(self) -> Result<(), Error> {
                let tolerance = self.tolerance;
                match tolerance.is_finite() && tolerance > 0.0 {
                    true => Ok(()),
                    false => Err(Error::Tolerance { method: stringify!($name), tolerance }),
                }
            }
        }

        impl Recipe for $name {
            type Memory<R: Real> = ();

            fn increment<R: Real>(self, _: &mut (), from: &Place<'_, R>) -> Result<Vec<R>, Unsolved> {
                increment(from, self.tolerance, Self::SOLVE)
            }
        }

        impl $name {
            /// Returns the times and states at the ends of the steps that the method chooses over a span from time 0, beginning
            /// with the start. States are lists of positions, then momenta. The tolerance is that of errors in these units, one
            /// for each number of a state.
            ///
            /// # Errors
            /// The method does not reach the end of the span.
            pub fn steps<H: System>(
                self,
                system: &H,
                start: &Phase<H::Coords>,
                span: f64,
                units: &[f64],
            ) -> Result<Vec<(f64, Vec<f64>)>, Unsolved> {
                let absolute = units.iter().map(|unit| self.tolerance * unit).collect();
                steps(system, start, span, absolute, Self::SOLVE)
            }

            const SOLVE: Solve = |field, [begin, end], start, Tolerances { relative, absolute }| {
                let method = $method.rtol(relative).atol(absolute).max_steps(MOST);
                IVP::ode(&field, begin, end, start).method(method).solve()
            };
        }
    )*};
}

/// More steps of its own than this within one step of the run are taken for an error.
const MOST: usize = 1_000_000;

adaptive! {
    /// The embedded pair of orders 5 and 4 of Dormand and Prince (1980), DOPRI5.
    DormandPrince5: order 5, ExplicitRungeKutta::dopri5();
    /// The method of order 8 of Dormand and Prince with the error estimate of Hairer, Nørsett and Wanner (1993), DOP853.
    DormandPrince8: order 8, ExplicitRungeKutta::dop853();
    /// Backward differentiation formulas of orders 1 to 5 with step-size control by the tolerance, for stiff systems
    /// (Gear 1971).
    ///
    /// They damp fast oscillations. Each step of the run restarts at order 1, so it should be long.
    Bdf: order 1, BackwardDifferentiationFormula::adaptive();
}
