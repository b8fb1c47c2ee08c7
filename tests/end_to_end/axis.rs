//! Forces at a distance of zero, where a formula is singular and its energy is smooth.

use integrator_core::prelude::*;

/// Potentials of the distance from an axis and from the origin, each with its negative gradient on the axis at a height `z`.
macro_rules! on_axis {
    (|$x:ident, $y:ident, $z:ident| $($system:ident: $energy:expr, $force:expr;)+) => {
        $(
            struct $system;

            #[hamiltonian]
            impl $system {
                fn kinetic(&self, p: [f64; 3]) -> f64 { 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) }
                fn potential(&self, [$x, $y, $z]: [f64; 3]) -> f64 {
                    let energy = $energy;
                    energy
                }
            }
        )+

        #[test]
        fn a_force_on_the_axis_is_along_it() {
            for $z in [0.7_f64, -1.9] {
                $({
                    let start = Phase::new([0.0, 0.0, $z], [0.0; 3]);
                    let mut run = $system.run_with(Euler, start, 0.5).expect("a run");
                    run.advance(1).unwrap_or_else(|error| panic!("{}: {error}", stringify!($system)));
                    let [x, y, along] = run.state().p;
                    let expected: f64 = 0.5 * $force;
                    // A few roundings of numbers below 16.
                    let tolerance = 64.0 * f64::EPSILON * expected.abs().max(1.0);
                    assert_eq!([x, y], [0.0; 2], "{} at {}", stringify!($system), $z);
                    assert!((along - expected).abs() <= tolerance, "{}: {along}, {expected}", stringify!($system));
                })+
            }
        }

        /// Away from the axis, where nothing is singular, each is the gradient of its function.
        #[test]
        fn a_force_beside_the_axis_is_the_gradient() {
            for q in [[0.3, -0.4, 0.7], [1e-9, 2e-9, -1.3], [-1.1, 0.0, 0.2]] {
                $({
                    let error = integrator_core::check::gradient_error(&$system, Phase::new(q, [0.0; 3]), 0.0);
                    // The tolerance of certificates: 32 roundings for each coordinate and one more.
                    let tolerance = 128.0 * f64::EPSILON;
                    assert!(matches!(error, Ok(error) if error < tolerance), "{} at {q:?}: {error:?}", stringify!($system));
                })+
            }
        }
    };
}

on_axis! {
    |x, y, z|
    SquareOfHypot: -1.0 / (x.hypot(y) * x.hypot(y) + z * z).sqrt(), -z.signum() / (z * z);
    CubeOfHypot: x.hypot(y).powi(3) + z * z, -2.0 * z;
    Chain: x.hypot(y).hypot(z), -z.signum();
    ChainFromTheOrigin: 1.0 / z.hypot(x.hypot(y)), z.signum() / (z * z);
    SquareOfChain: x.hypot(y).hypot(z).powi(4), -4.0 * z * z * z;
    RootInHypot: (x * x + y * y).sqrt().hypot(z), -z.signum();
    CosineOfRoot: 1.0 - (x * x + y * y).sqrt().cos() + z, -1.0 + 0.0 * z;
    CosineOfHypot: 1.0 - x.hypot(y).cos() + z * z, -2.0 * z;
    HyperbolicCosine: x.hypot(y).cosh() - z, 1.0 + 0.0 * z;
}
