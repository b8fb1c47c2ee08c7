//! The procedural macros of `integrator-core`: each calls `integrator-symbolic`, where the work is done.
//!
//! Use them through `integrator_core`, which re-exports both and is what the generated code calls.
#![forbid(unsafe_code)]

use proc_macro::TokenStream;

/// Writes the stepper of a Hamiltonian given as plain functions: `H = T(p) + V(q)`, or other parts with exact flows.
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
/// The impl stays as it was written. Behind it, the trait `Hamiltonian` is implemented for the type: the exact flows of
/// `T` and of `V`, from gradients that are derived symbolically, and both energies. The derived equations of motion
/// stand in the documentation of that implementation.
///
/// # Arguments
///
/// | argument | meaning |
/// |---|---|
/// | `compose = Yoshida4` | the composition that `run` uses; a path to any that may integrate this Hamiltonian |
/// | `compose = V(1/2) T(1) V(1/2)` | a sequence in place, as in `composition!`, proved for this Hamiltonian |
/// | `coordinates = jacobi(self.masses)` | with `split = kepler + interaction`: bodies `[[f64; D]; N]` that attract each other move in Jacobi coordinates, made with their masses, from the inside out; the heaviest body leads if it outweighs all before it together; `potential` has to be a sum over pairs with terms `-G m[i] m[j] / r` of the distance `r` of two bodies. States stay in the coordinates of the functions |
/// | `split = kepler + interaction` | the parts of `H`, each a function of this name with a flow that is known exactly, in the order of the letters A, B, C; see [Parts](#parts) |
/// | `split = kepler + (jump + interaction)` | the same, where the parts in parentheses are one part, which a composition takes as a symmetric pair |
/// | `split = none` | `H` stays in one piece, `hamiltonian(&self, q, p)`, whatever it mixes: for methods that take the whole of its field, `compose = GaussLegendre4`; without `compose` it is `ImplicitMidpoint` |
/// | `split = symmetric(omega = 20.0)` | the same `H` of each of two copies of the state, coupled as tightly as you say, for compositions |
/// | `functions = fast` | `sin`, `cos`, `tan`, `exp`, `ln`, `tanh`, `asin`, `acos`, `atan`, `atan2` and `cbrt` within 4 ulp instead of 1 or 2, which takes a fifth to a half of their time off; other functions stay as they are; `functions = precise` names the default |
/// | `taylor` | recurrences for the Taylor coefficients of the motion are written as well, for runs with `taylor::Taylor` at errors near the rounding; of the whole of `H`, whatever it splits into |
/// | `sensitive(mass, length)` | derivatives of the end of a run by these fields of the system, each a number, for `sensitivities`; what is made of them in the functions has to be arithmetic, methods of `f64`, `let`, `if` or helper methods of the impl. Not in Jacobi coordinates, of two copies, or of parts that are solved with these fields |
/// | `gpu` | the flows are written as C++ for devices as well, for the crate `integrator-gpu`; an error says why where they cannot be |
/// | `gpu(functions = native)` | the same with the elementary functions of the device: faster, all of them there, and with other bits than on a processor |
/// | `crate = path` | where `integrator_core` is, if it is not `::integrator_core` |
///
/// Without `compose` it is `Verlet`. Any other composition can be passed to `run_with`, and so can the implicit methods
/// `ImplicitMidpoint`, `GaussLegendre4` and `GaussLegendre6`, whatever `H` splits into.
///
/// # Coordinates
///
/// `kinetic` takes `&self` and the momenta, `potential` takes `&self` and the positions; both return `f64`. The type of
/// the coordinates is the same in both:
///
/// | type | the start is made of |
/// |---|---|
/// | `[f64; N]` | arrays of numbers |
/// | `[[f64; D]; N]` | arrays of `N` points in `D` dimensions |
/// | `[[[f64; L]; M]; N]` | arrays of `N` planes of sites: `M` rows of `L` sites |
/// | `&[f64]`, `&[[f64; D]]`, `&[[[f64; L]; M]]` | `Vec`s, of a length that is known at run time |
///
/// Arrays are taken by value or by reference, or apart by a pattern: `[x, y]: [f64; 2]`. `N` and `D` may be constants,
/// or parameters of a generic type.
///
/// Any `T(p)` is integrated. Where it is `½ pᵀ M⁻¹ p` with a constant `M`, which is decided symbolically, the type also
/// implements `QuadraticKinetic`, and the compositions that need it are allowed.
///
/// # Parts
///
/// All of `H` may stand in one function, `hamiltonian(&self, q, p)`, whose terms are sorted into `T(p)` and `V(q)`. With
/// `split = a + b` the functions `a` and `b` are the parts instead; each takes `q`, `p`, or both. The exact flow of a
/// part is found by its formula: a function of `p` alone or of `q` alone, a quadratic form in both, Kepler orbits, or a
/// shear, which reads no coordinate together with its conjugate. `split = quadratic + rest` sorts the terms of
/// `hamiltonian` into a quadratic form and what is left. Any other part needs a flow of your own, by
/// `#[flow(a)]` on a method:
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
/// `#[invariant]` on a function of `q` and `p` says that the motion conserves it: `run.invariant("angular_momentum")` and
/// `sample.invariant(..)` tell its value, files of samples have a column of it, and `certify` refuses a system whose `H`
/// does not conserve it: its Poisson bracket with `H` has to vanish along the orbit. The language is that of `H`.
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
/// - `+ - * /`, numbers, constants, `let` with shadowing, blocks, tuples and arrays of values;
/// - the methods of `f64`: `sqrt`, `cbrt`, `powi`, `powf`, `recip`, `exp`, `exp2`, `exp_m1`, `ln`, `ln_1p`, `log`,
///   `log2`, `log10`, `sin`, `cos`, `sin_cos`, `tan`, `asin`, `acos`, `atan`, `atan2`, `sinh`, `cosh`, `tanh`, `asinh`,
///   `acosh`, `atanh`, `hypot`, `abs`, `signum`, `min`, `max`, `floor`, `ceil`, `round`, `round_ties_even`, `trunc`, `fract`, `rem_euclid`
///   and `%`, `mul_add`, `to_radians`, `to_degrees`, also as
///   `f64::sin(x)`;
/// - helper methods of the same impl, without recursion;
/// - sums in `let mut` variables, by `+=` and `-=` in `for` loops, nested or not: over ranges of integers, over
///   coordinates, over lists of parameters such as `for &(i, j) in &self.bonds`, with `continue` where an iteration
///   adds nothing. They stay loops in the generated code, whatever their length;
/// - iterator chains that end in `sum` or in a `fold` that is a sum, of `iter`, `map`, `filter`, `enumerate`, `zip`,
///   `rev`, `skip`, `take`, `step_by`, `windows` and `chunks_exact`;
/// - `if` with comparisons of coordinates, joined by `&&`, `||` and `!`. Each side is differentiated on its own, and
///   the side that is not taken is not computed. Whether the energy is smooth where they meet is up to you;
/// - assertions, which mean nothing to the derivative.
///
/// An expression that reads no coordinate may be any Rust: fields and methods of `self`, calls, `match`. It is
/// evaluated once per run, as it stands.
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
/// A last argument `t: f64` in either function makes the Hamiltonian depend on time. Inside a step the clock of `V`
/// advances with the drifts, and the clock of `T` with the kicks, so that the order is kept.
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
/// All mistakes are reported at once, each at the token at fault. A Hamiltonian that is not `T(p) + V(q)` is refused at
/// the product that mixes both:
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
/// Each declaration becomes a unit struct that implements `Scheme`, with the facts about it, and `Composition` for
/// every Hamiltonian that it may integrate. What was proved is appended to its documentation.
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
/// Coefficients are written with numbers, `+ - * /`, parentheses, `sqrt(x)`, `cbrt(x)` and `root(n, x)`, and are
/// evaluated to 31 digits. One drift, one kick or one weight may be `_`: what the others leave of the step.
///
/// # Errors
///
/// A sequence whose drifts or kicks do not sum to 1 is refused, and so is a claim that does not hold; the message has
/// the order that was proved, the first condition that is violated, and by how much. A declared order that holds only
/// for a `T` quadratic in `p` declares a composition for such systems alone.
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
