//! Forces where one factor of a derivative is zero and another one infinite: far from a step that is written with exponentials,
//! and at the root of a sum whose items are masked. The force is zero there.

use integrator_core::prelude::*;

/// Potentials of `x` and `y` with a parameter, points at which they are, and the force at each.
macro_rules! limits {
    (|$x:ident, $y:ident, $mask:ident| $($system:ident: $energy:expr, [$([$($at:expr),*] => $force:expr),+];)+) => {
        $(
            struct $system {
                mask: f64,
            }

            #[hamiltonian]
            impl $system {
                fn kinetic(&self, p: [f64; 2]) -> f64 { 0.5 * (p[0] * p[0] + p[1] * p[1]) }
                fn potential(&self, [$x, $y]: [f64; 2]) -> f64 {
                    let $mask = self.mask;
                    let _ = ($x, $y, $mask);
                    let energy = $energy;
                    energy
                }
            }
        )+

        #[test]
        fn a_force_is_zero_where_a_factor_is_exactly_zero() {
            $($({
                let [x, y, mask]: [f64; 3] = [$($at),*];
                let mut run = $system { mask }.run_with(Euler, Phase::new([x, y], [0.0; 2]), 1.0).expect("a run");
                run.advance(1).unwrap_or_else(|error| panic!("{} at {x}: {error}", stringify!($system)));
                let expected: [f64; 2] = $force;
                assert_eq!(run.state().p, expected, "{} at {x}, {y}, {mask}", stringify!($system));
                let members = [0.5, 1.0, 0.9].map(|near| ($system { mask }, Phase::new([x * near, y], [0.0; 2])));
                let mut swarm = Ensemble::new(Euler, members, 1.0).expect("members");
                swarm.advance(1).expect("finite states");
                assert_eq!(swarm.state(1).map(|state| state.p), Some(expected), "{} at {x}, {y}, {mask} in lanes", stringify!($system));
            })+)+
        }

        /// Where neither is, the force is the gradient of the function.
        #[test]
        fn a_force_beside_a_limit_is_the_gradient() {
            for q in [[0.4, -0.7], [1.3, 0.2], [30.0, 0.9], [-30.0, 0.9]] {
                $({
                    let error = integrator_core::check::gradient_error(&$system { mask: 0.8 }, Phase::new(q, [0.0; 2]), 0.0);
                    // The tolerance of certificates: 32 roundings for each coordinate and one more.
                    let tolerance = 128.0 * f64::EPSILON;
                    assert!(matches!(error, Ok(error) if error < tolerance), "{} at {q:?}: {error:?}", stringify!($system));
                })+
            }
        }
    };
}

limits! {
    |x, y, mask|
    WoodsSaxon: -50.0 / (1.0 + ((x - 6.0) / 0.6).exp()),
        [[429.5, 0.0, 1.0] => [0.0; 2], [500.0, 0.0, 1.0] => [0.0; 2], [1e300, 0.0, 1.0] => [0.0; 2]];
    Softplus: (1.0 + x.exp()).ln() + y, [[709.5, 2.0, 1.0] => [-1.0, -1.0]];
    SoftplusOfTwo: (mask * x.exp() + 3.0 * (-y).exp()).ln(), [[400.0, -400.0, 1.0] => [-0.25, 0.75]];
    LogarithmOfCosine: 2.0 * (0.5 * x).cosh().ln(), [[1400.0, 0.0, 1.0] => [-1.0, 0.0], [-1400.0, 0.0, 1.0] => [1.0, 0.0]];
    SoftSign: x / (1.0 + x * x).sqrt(), [[1e200, 0.0, 1.0] => [0.0; 2], [-1e200, 0.0, 1.0] => [0.0; 2]];
    SquareOfSecant: -1.0 / x.cosh().powi(2), [[800.0, 0.0, 1.0] => [0.0; 2], [-800.0, 0.0, 1.0] => [0.0; 2]];
    Secant: -1.0 / x.cosh(), [[800.0, 0.0, 1.0] => [0.0; 2], [-800.0, 0.0, 1.0] => [0.0; 2]];
    RootOfSecant: 1.0 / (3.0 + x.sinh().powi(2)).sqrt(), [[800.0, 0.0, 1.0] => [0.0; 2], [-800.0, 0.0, 1.0] => [0.0; 2]];
    TwoWells: 1.0 / (1.0 + x.exp()) + mask / (2.0 + x.exp2() * 3.0), [[2000.0, 0.0, 1.0] => [0.0; 2]];
    Kink: 4.0 * x.exp().atan(), [[800.0, 0.0, 1.0] => [0.0; 2]];
    DoubleExponential: (-x.exp()).exp(), [[800.0, 0.0, 1.0] => [0.0; 2]];
    Ramp: y * x.exp().atan() + y, [[800.0, 0.5, 1.0] => [0.0, -1.0 - std::f64::consts::FRAC_PI_2]];
    BondOrder: x * (1.0 + (mask * y * y).powf(0.78)).powf(-0.64), [[2.0, 0.3, 0.0] => [-1.0, 0.0], [2.0, 0.0, 1.0] => [-1.0, 0.0]];
    CutOff: x + ((1.0 - y.abs()).max(0.0) * y * y).powf(0.78), [[2.0, 3.0, 0.0] => [-1.0, 0.0]];
    EmbeddedAtom: x - ((1.0 - y.abs()).max(0.0).powi(2)).sqrt(), [[2.0, 3.0, 0.0] => [-1.0, 0.0]];
    Density: x - (mask * (x * x + 1.0)).sqrt(), [[2.0, 0.3, 0.0] => [-1.0, 0.0]];
    CubicRoot: x + (mask * y * y * y).cbrt(), [[2.0, 0.3, 0.0] => [-1.0, 0.0]];
    AnyPower: x + (mask * y * y).powf(0.5 * mask + 0.7), [[2.0, 0.3, 0.0] => [-1.0, 0.0]];
    // A root times itself has no slope at zero, wherever its factors stand.
    SquareBehind: { let r = (x * x + y * y).sqrt(); mask * r * r + x }, [[0.0, 0.0, 1.0] => [-1.0, 0.0]];
    CubeBehind: { let r = (x * x + y * y).sqrt(); mask * r * r * r + x }, [[0.0, 0.0, 1.0] => [-1.0, 0.0]];
    CubeAround: { let r = x.hypot(y); r * mask * r * (1.0 + x) * r + x }, [[0.0, 0.0, 1.0] => [-1.0, 0.0]];
    TwoProducts: { let r = (x * x + y * y).sqrt(); (mask * r) * (r * x.cos()) + x }, [[0.0, 0.0, 1.0] => [-1.0, 0.0]];
    TwoLongProducts: { let r = x.hypot(y); (2.0 + x) * (r * y.cos()) * (x.cos() * (r * mask)) + x }, [[0.0, 0.0, 1.0] => [-1.0, 0.0]];
    PowerOfProduct: { let r = (x * x + y * y).sqrt(); (r * (mask + x)).powi(3) + x }, [[0.0, 0.0, 1.0] => [-1.0, 0.0]];
    ProductWithItself: { let r = x.hypot(y); let s = r * (mask + x); s * s + x }, [[0.0, 0.0, 1.0] => [-1.0, 0.0]];
    RootAndRadicand: { let r2 = x * x + y * y; mask * r2.sqrt() * (1.0 + x) * r2 + x }, [[0.0, 0.0, 1.0] => [-1.0, 0.0]];
    DistanceAndSquare: mask * (x * x + y * y) * (1.0 + x) * y.hypot(x) + x, [[0.0, 0.0, 1.0] => [-1.0, 0.0]];
    Quotients: { let r = (x * x + y * y).sqrt(); mask * r * x.cos() * r / (2.0 + x * x) / 3.0 * r + x }, [[0.0, 0.0, 1.0] => [-1.0, 0.0]];
    QuotientBetween: { let r = x.hypot(y); mask * r / 3.0 * r / (1.0 + x * x) + x }, [[0.0, 0.0, 1.0] => [-1.0, 0.0]];
    NegativeFactors: { let r = (x * x + y * y).sqrt(); x - r * (-mask) * -(r * 1.5) }, [[0.0, 0.0, 1.0] => [-1.0, 0.0]];
    CosineOfRoot: x.abs().sqrt().cos() + y, [[0.0, 0.3, 1.0] => [0.5, -1.0]];
}

/// A square in a divisor overflows at half of where the exponential does, and its derivative a little before.
#[test]
fn deviation_vectors_have_values_at_every_distance_from_a_step() {
    macro_rules! at_every_distance {
        ($($system:ident)*) => {$(
            for (tenth, side) in (0..8_000).flat_map(|tenth| [(tenth, 1.0), (tenth, -1.0)]) {
                let x = side * 0.1 * f64::from(tenth);
                let start = Phase::new([x, 0.5], [0.0; 2]);
                // The energy of a logarithm is infinite where its exponential is.
                let Ok(mut tangent) = $system { mask: 1.0 }.tangent(Euler, start, [Phase::new([1.0, 0.0], [0.0; 2])], 1.0) else {
                    assert!(!$system { mask: 1.0 }.potential(start.q).is_finite(), "{} at {x}", stringify!($system));
                    continue;
                };
                tangent.advance(1).unwrap_or_else(|error| panic!("{} at {x}: {error}", stringify!($system)));
                assert!(tangent.vectors()[0].p[0].is_finite(), "{} at {x}", stringify!($system));
            }
        )*};
    }
    at_every_distance! { WoodsSaxon SquareOfSecant Softplus LogarithmOfCosine Kink }
}

#[test]
fn a_force_is_zero_far_from_a_step_in_single_precision() {
    let wells = [WoodsSaxon { mask: 1.0 }.run(Phase::new([400.0_f32, 0.0], [0.0; 2]), 0.5)];
    for well in wells {
        let mut run = well.expect("a run");
        run.advance(1).expect("finite states");
        assert_eq!(run.state().p, [0.0_f32; 2]);
    }
}
