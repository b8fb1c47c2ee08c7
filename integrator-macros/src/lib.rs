//! The procedural macros of `integrator-core`. `integrator-symbolic` implements them.
//!
//! Use them through `integrator_core`, which re-exports both and provides the items that the generated code calls.
#![forbid(unsafe_code)]

use proc_macro::TokenStream;

/// Generates the stepper of a Hamiltonian given as plain functions: `H = T(p) + V(q)`, or other parts with exact flows.
///
/// ```
/// use integrator_core::prelude::*;
///
/// struct HenonHeiles {
///     coupling: f64,
/// }
///
/// #[hamiltonian(compose = Yoshida4)]
/// impl HenonHeiles {
///     fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
///         0.5 * (px * px + py * py)
///     }
///     fn potential(&self, [x, y]: [f64; 2]) -> f64 {
///         0.5 * (x * x + y * y) + self.coupling * (x * x * y - y.powi(3) / 3.0)
///     }
/// }
///
/// # fn main() -> Result<(), Error> {
/// let system = HenonHeiles { coupling: 1.0 };
/// let mut run = system.run(Phase::new([0.1, 0.0], [0.0, 0.5]), 0.05)?;
/// run.advance(1_000)?;
/// assert!((run.energy() - 0.13).abs() < 1e-6);
/// assert_eq!(system.potential([0.0, 0.0]), 0.0); // the functions stay callable
/// # Ok(())
/// # }
/// ```
///
/// The impl stays unchanged. The macro adds an implementation of the trait `Hamiltonian` for the type. It contains the
/// exact flows of `T` and of `V`, from symbolically derived gradients, and both energies. The documentation of that
/// implementation shows the derived equations of motion.
///
/// # Arguments
///
/// - `compose = Yoshida4` sets the composition that `run` uses: a path to any composition that can integrate this
///   Hamiltonian. The default is `Verlet`.
/// - `compose = V(1/2) T(1) V(1/2)` declares a composition in place, as in `composition!`. Its order is proved for this
///   Hamiltonian.
/// - `split = kepler + interaction` names the parts of `H`. Each is a function of this name with an exact flow. The
///   order is that of the letters A, B, C; see [Parts](#parts).
/// - `split = kepler + (jump + interaction)` makes one part of the parts in parentheses. A composition integrates it as
///   a symmetric pair.
/// - `coordinates = jacobi(self.masses)`, with `split = kepler + interaction`, integrates attracting bodies in Jacobi
///   coordinates. The positions are `[[f64; D]; N]`.
///   - The coordinates are built from these masses, from the inside out. The heaviest body comes first if it outweighs
///     all bodies before it together.
///   - `potential` must be a sum over pairs, with terms `-G m[i] m[j] / r` of the distance `r` of two bodies.
///   - States stay in the coordinates of the functions.
/// - `split = none` leaves `H` unsplit, as `hamiltonian(&self, q, p)` with arbitrary terms. It is for methods that use
///   the whole vector field, such as `compose = GaussLegendre4`. The default is `ImplicitMidpoint`.
/// - `split = symmetric(omega = 20.0)` evolves two copies of the state, each with the same `H`, by compositions.
///   `omega` is the strength of the coupling between the copies.
/// - `functions = fast` allows errors up to 4 ulp instead of 1 or 2 in `sin`, `cos`, `tan`, `exp`, `ln`, `tanh`,
///   `asin`, `acos`, `atan`, `atan2` and `cbrt`. They are faster by a fifth to a half; other functions do not change.
///   `functions = precise` is the default.
/// - `taylor` generates recurrences for the Taylor coefficients of the motion as well, for runs with `taylor::Taylor`
///   at errors near the rounding. They are those of the whole `H`, for every splitting.
/// - `sensitive(mass, length)` names fields for `sensitivities`: derivatives of the final state with respect to
///   parameters.
///   - Each field is a number.
///   - Expressions of these fields may use arithmetic, methods of `f64`, `let`, `if` and helper methods of the impl.
///   - It is not available in Jacobi coordinates, for two copies of the state, or for solved parts that contain these
///     fields.
/// - `gpu` generates the flows as C++ for devices as well, for the crate `integrator-gpu`. If a flow is not supported
///   there, the compile error names the reason.
/// - `gpu(functions = native)` uses the elementary functions of the device. It is faster and supports all functions,
///   but runs are not bitwise identical to those on a processor.
/// - `crate = path` is the path of `integrator_core`, if it is not `::integrator_core`.
///
/// Every other composition can be passed to `run_with`. The implicit methods `ImplicitMidpoint`, `GaussLegendre4` and
/// `GaussLegendre6` can be passed for every splitting.
///
/// # Coordinates
///
/// `kinetic` takes `&self` and the momenta, `potential` takes `&self` and the positions; both return `f64`. Both use
/// the same type of coordinates:
///
/// | type | start |
/// |---|---|
/// | `[f64; N]` | arrays of numbers |
/// | `[[f64; D]; N]` | arrays of `N` points in `D` dimensions |
/// | `[[[f64; L]; M]; N]` | arrays of `N` planes of sites: `M` rows of `L` sites |
/// | `&[f64]`, `&[[f64; D]]`, `&[[[f64; L]; M]]` | `Vec`s of a length known at run time |
///
/// Arrays are passed by value or by reference, or destructured by a pattern: `[x, y]: [f64; 2]`. `N` and `D` may be
/// constants, or parameters of a generic type.
///
/// `T(p)` is arbitrary. If it is `½ pᵀ M⁻¹ p` with a constant `M`, the type also implements `QuadraticKinetic`, which
/// allows the compositions that need it. The macro decides this symbolically.
///
/// # Parts
///
/// One function `hamiltonian(&self, q, p)` may contain all of `H`; its terms are sorted into `T(p)` and `V(q)`. With
/// `split = a + b`, the functions `a` and `b` are the parts instead. Each takes `q`, `p`, or both. The macro finds the
/// exact flow of a part from its formula:
///
/// - a function of `p` alone or of `q` alone;
/// - a quadratic form in both;
/// - Kepler orbits;
/// - a shear, which contains no coordinate together with its conjugate.
///
/// `split = quadratic + rest` sorts the terms of `hamiltonian` into a quadratic form and the remaining terms. Any other
/// part needs a hand-written flow, a method with `#[flow(a)]`:
///
/// ```
/// use integrator_core::prelude::*;
///
/// #[derive(Clone)]
/// struct Turning {
///     frequency: f64,
/// }
///
/// #[hamiltonian(split = oscillator + rest, compose = Aba864)]
/// impl Turning {
///     fn oscillator(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
///         0.5 * self.frequency * (q[0] * q[0] + p[0] * p[0])
///     }
///     #[flow(oscillator)]
///     fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {
///         let (sine, cosine) = (self.frequency * duration).sin_cos();
///         (q[0], p[0]) = (cosine * q[0] + sine * p[0], cosine * p[0] - sine * q[0]);
///     }
///     fn rest(&self, q: [f64; 1]) -> f64 {
///         0.01 * q[0].powi(4)
///     }
/// }
///
/// # fn main() -> Result<(), Error> {
/// let mut run = Turning { frequency: 2.0 }.run(Phase::new([1.0], [0.0]), 0.25)?;
/// let energy = run.energy();
/// run.advance(1_000)?;
/// assert!((run.energy() - energy).abs() < 1e-7);
/// # Ok(())
/// # }
/// ```
///
/// # Invariants
///
/// `#[invariant]` declares that the motion conserves a function of `q` and `p`. The function may contain the same
/// expressions as `H`.
///
/// - `run.invariant("angular_momentum")` and `sample.invariant(..)` return its value.
/// - Files of samples have a column for it.
/// - `certify` fails if its Poisson bracket with `H` does not vanish along the orbit.
///
/// ```
/// use integrator_core::prelude::*;
///
/// /// A star in a flattened galaxy, of the cylindrical radius R = hypot(x, y).
/// struct Galaxy {
///     flattening: f64,
/// }
///
/// #[hamiltonian]
/// impl Galaxy {
///     fn kinetic(&self, p: [f64; 3]) -> f64 {
///         (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 2.0
///     }
///     fn potential(&self, [x, y, z]: [f64; 3]) -> f64 {
///         0.5 * (0.01 + x * x + y * y + (z / self.flattening).powi(2)).ln()
///     }
///     #[invariant]
///     fn about_the_axis(&self, q: [f64; 3], p: [f64; 3]) -> f64 {
///         q[0] * p[1] - q[1] * p[0]
///     }
/// }
///
/// # fn main() -> Result<(), Error> {
/// let galaxy = Galaxy { flattening: 0.8 };
/// let mut run = galaxy.run(Phase::new([1.0, 0.0, 0.1], [0.0, 0.9, 0.2]), 0.01)?;
/// run.advance(10_000)?;
/// assert!((run.invariant("about_the_axis")? - 0.9).abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
///
/// # What the functions may contain
///
/// - `+ - * /`, numbers, constants, `let` with shadowing, blocks, tuples and arrays of values.
/// - The methods of `f64`, also as `f64::sin(x)`: `sqrt`, `cbrt`, `powi`, `powf`, `recip`, `exp`, `exp2`, `exp_m1`,
///   `ln`, `ln_1p`, `log`, `log2`, `log10`, `sin`, `cos`, `sin_cos`, `tan`, `asin`, `acos`, `atan`, `atan2`, `sinh`,
///   `cosh`, `tanh`, `asinh`, `acosh`, `atanh`, `hypot`, `abs`, `signum`, `min`, `max`, `floor`, `ceil`, `round`,
///   `round_ties_even`, `trunc`, `fract`, `rem_euclid` and `%`, `mul_add`, `to_radians`, `to_degrees`.
/// - Helper methods of the same impl, without recursion.
/// - Sums in `let mut` variables, by `+=` and `-=` in `for` loops, which may be nested. Loops run over ranges of
///   integers, over coordinates, or over lists of parameters such as `for &(i, j) in &self.bonds`. `continue` skips an
///   iteration. They stay loops in the generated code, for every length.
/// - Iterator chains that end in `sum`, or in a `fold` that is a sum. They may use `iter`, `map`, `filter`,
///   `enumerate`, `zip`, `rev`, `skip`, `take`, `step_by`, `windows` and `chunks_exact`.
/// - `if` with comparisons of coordinates, joined by `&&`, `||` and `!`. Each branch is differentiated separately, and
///   only the branch that is taken is computed. You decide whether the energy is smooth where branches meet.
/// - Assertions, which do not change the derivative.
///
/// An expression without coordinates may be any Rust code: fields and methods of `self`, calls, `match`. It is
/// evaluated once per run, unchanged.
///
/// ```
/// use integrator_core::prelude::*;
///
/// /// Particles on a line: any number of them, held by springs between some, repelled by all that come close.
/// struct Cluster {
///     masses: Vec<f64>,
///     springs: Vec<(usize, usize)>,
///     stiffness: f64,
///     reach: f64,
/// }
///
/// #[hamiltonian]
/// impl Cluster {
///     fn kinetic(&self, p: &[f64]) -> f64 {
///         p.iter().zip(&self.masses).map(|(p, mass)| p * p / (2.0 * mass)).sum()
///     }
///     fn potential(&self, q: &[f64]) -> f64 {
///         let mut energy = 0.0;
///         for &(i, j) in &self.springs {
///             energy += 0.5 * self.stiffness * (q[i] - q[j]).powi(2);
///         }
///         for i in 0..q.len() {
///             for j in 0..i {
///                 energy += self.repulsion((q[i] - q[j]).powi(2));
///             }
///         }
///         energy
///     }
///     fn repulsion(&self, square: f64) -> f64 {
///         let inside = self.reach.powi(2) - square;
///         if inside > 0.0 { inside.powi(3) } else { 0.0 }
///     }
/// }
///
/// # fn main() -> Result<(), Error> {
/// let springs = vec![(0, 1), (1, 2)];
/// let cluster = Cluster { masses: vec![1.0, 2.0, 1.0], springs, stiffness: 3.0, reach: 0.5 };
/// let mut run = cluster.run(Phase::new(vec![0.0, 0.3, 1.0], vec![0.1, 0.0, -0.1]), 0.01)?;
/// let energy = run.energy();
/// run.advance(1_000)?;
/// assert!((run.energy() - energy).abs() < 1e-3 * energy);
/// # Ok(())
/// # }
/// ```
///
/// # Time
///
/// A last argument `t: f64` in either function makes the Hamiltonian depend on time. Within a step, the clock of `V`
/// advances with the drifts and the clock of `T` with the kicks, which keeps the order.
///
/// ```
/// use integrator_core::prelude::*;
///
/// struct Driven {
///     frequency: f64,
/// }
///
/// #[hamiltonian(compose = V(1/2) T(1) V(1/2))]
/// impl Driven {
///     fn kinetic(&self, p: [f64; 1]) -> f64 {
///         0.5 * p[0].powi(2)
///     }
///     fn potential(&self, q: [f64; 1], t: f64) -> f64 {
///         -q[0] * (self.frequency * t).cos()
///     }
/// }
///
/// # fn main() -> Result<(), Error> {
/// let mut run = Driven { frequency: 2.0 }.run(Phase::new([0.0], [0.0]), 0.001)?;
/// run.advance(1_000)?;
/// // q'' = cos 2t from rest: q = (1 - cos 2t) / 4
/// assert!((run.state().q[0] - (1.0 - 2.0_f64.cos()) / 4.0).abs() < 1e-6);
/// # Ok(())
/// # }
/// ```
///
/// # Errors
///
/// All mistakes are reported together, each at its token. If a Hamiltonian is not `T(p) + V(q)`, the error is at the
/// product that mixes both:
///
/// ```compile_fail
/// use integrator_core::prelude::*;
///
/// struct Magnetic;
///
/// #[hamiltonian]
/// impl Magnetic {
///     fn kinetic(&self, p: [f64; 2], q: [f64; 2]) -> f64 {
///         0.5 * ((p[0] + q[1]).powi(2) + p[1].powi(2))
///     }
///     fn potential(&self, q: [f64; 2]) -> f64 {
///         0.5 * q[0].powi(2)
///     }
/// }
/// ```
#[proc_macro_attribute]
pub fn hamiltonian(arguments: TokenStream, item: TokenStream) -> TokenStream {
    integrator_symbolic::hamiltonian(arguments.into(), item.into()).into()
}

/// Declares compositions of drifts and kicks and proves their order.
///
/// ```
/// use integrator_core::prelude::*;
///
/// composition! {
///     /// Drift, kick, drift.
///     pub struct Leapfrog: order 2, symmetric = T(1/2) V(1) T(1/2);
///
///     /// Three leapfrogs, the middle one backwards.
///     pub struct Jump: order 4, symmetric, citation "Yoshida 1990" = triple_jump(Leapfrog);
///
///     /// The same from its coefficients; `_` is what the others leave of the step.
///     pub struct Spelled: order 4, symmetric
///         = symmetric(1/(2 - cbrt(2)), _; Leapfrog);
///
///     /// No claim: the order is inferred.
///     pub struct Found = V(7/24) T(2/3) V(3/4) T(-2/3) V(-1/24) T(1);
/// }
///
/// assert_eq!((Leapfrog::ORDER, Jump::ORDER, Spelled::ORDER, Found::ORDER), (2, 4, 4, 3));
/// assert_eq!(Jump::STAGES, Spelled::STAGES);
/// ```
///
/// Each declaration becomes a unit struct. It implements `Scheme`, with the properties of the composition, and
/// `Composition` for every Hamiltonian that it can integrate. The proved properties are appended to its documentation.
///
/// # Grammar
///
/// ```text
/// [crate = path;]
/// [/// docs] [pub] struct Name [: claim, ...] = sequence;
///
/// claim     order 4 | symmetric | citation "..."
/// sequence  one or more of the following, in order of application
///   T(a)                       drift: q moves for a·h
///   V(b)                       kick: p moves for b·h
///   V(b, c)                    kick with b·V + c·h²·|∇V|², for quadratic T
///   Name                       a composition declared above, or Euler, EulerAdjoint, Verlet, VelocityVerlet
///   triple_jump(sequence)      over g, 1 - 2g, g of the step; two orders above its symmetric base
///   suzuki(sequence)           over g, g, 1 - 4g, g, g of the step; two orders above its symmetric base
///   adjoint(sequence)          read backwards
///   symmetric(sequence)        continued to a palindrome about its last stage
///   symmetric(w, ..., w; sequence)   steps over the weights w, continued to a palindrome about the last one
///   compose(sequence, sequence, ...) each over an equal part of the step
///   compose(w, ..., w; sequence)     steps over the weights w
///   processed(sequence; sequence)    a processor, applied once and undone for output, and its kernel
/// ```
///
/// Coefficients consist of numbers, `+ - * /`, parentheses, `sqrt(x)`, `cbrt(x)` and `root(n, x)`, and are evaluated to
/// 31 digits. One drift, kick or weight may be `_`: the remainder of the step.
///
/// # Errors
///
/// It is an error if drifts or kicks do not sum to 1, or if a claim is false. The message contains the proved order,
/// the first violated condition, and the size of the violation. If a declared order is valid only for `T` quadratic in
/// `p`, the composition is for such systems only.
///
/// ```compile_fail
/// integrator_core::composition! {
///     pub struct Overclaimed: order 4 = T(1/2) V(1) T(1/2);
/// }
/// ```
#[proc_macro]
pub fn composition(declarations: TokenStream) -> TokenStream {
    integrator_symbolic::composition(declarations.into()).into()
}
