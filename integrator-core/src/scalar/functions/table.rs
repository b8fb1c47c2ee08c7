//! The table of elementary functions. Traits, their implementations and tests are written from it.
//!
//! A row names the arguments and then gives, in this order:
//!
//! - `value`: the names in libm for `f64` and `f32`, or an expression where `std` has no function of that name;
//! - `slope` (one argument): value and derivative at a number of `F`, or `dual` (two arguments): the function of two duals;
//! - `bounds`: an interval that contains all values on intervals;
//! - `kernel`, if there is one in this folder: its name and its error in units of the last place, the kernel that is
//!   faster and has an error of up to four, correctly rounded and exact references, and points at which tests compare.

/// Calls back with the names, with all rows (`rows of`), or with the names of fast kernels (`fast ones of`).
macro_rules! elementary_functions {
    (rows of $reader:ident! { $($context:tt)* }) => {
        $crate::scalar::functions::elementary_functions! { @to [$reader!] [{ $($context)* }] }
    };
    (fast ones of $callback:ident!) => {
        $crate::scalar::functions::elementary_functions! {
            @to [$crate::scalar::functions::elementary_functions!] [@fast $callback]
        }
    };
    (
        @names $callback:ident [$($context:tt)*]
        $($kind:ident { $($name:ident $arguments:tt $facts:tt)* })*
    ) => {
        $callback! { $($context)* $($kind: $($name)*;)* }
    };
    (
        @fast $callback:ident
        $($kind:ident { $($name:ident $arguments:tt {
            value: $value:tt; $form:ident: $derivative:expr; bounds: $bounds:expr;
            $(kernel: $kernel:ident within $ulps:literal, $(fast $fast:ident,)? of $($more:tt)*)?
        })* })*
    ) => {
        $callback! { $($kind: $($($($fast $name)?)?)*;)* }
    };
    (@to [$($reader:tt)*] [$($context:tt)*]) => {
        $($reader)* {
            $($context)*
            unary {
                sqrt(x) {
                    value: (libm sqrt sqrtf);
                    slope: { let value = x.sqrt(); (value, F::of(0.5) / value) };
                    bounds: x.increasing(Real::sqrt, POSITIVE, POSITIVE);
                }
                cbrt(x) {
                    value: (libm cbrt cbrtf);
                    slope: { let value = x.cbrt(); (value, F::of(1.0) / (F::of(3.0) * value * value)) };
                    bounds: x.increasing(Real::cbrt, ALL, ALL);
                    kernel: cbrt within 1.0, fast fast_cbrt, of pxfm::f_cbrt, CubicRoot::cbrt, at [
                        Points::Even(-8.0, 8.0), Points::Powers(-1080.0, 1024.0), Points::Powers(-130.0, 128.0)
                    ];
                }
                exp(x) {
                    value: (libm exp expf);
                    slope: { let value = x.exp(); (value, value) };
                    bounds: x.increasing(Real::exp, ALL, POSITIVE);
                    kernel: exp within 1.0, fast fast_exp, of pxfm::f_exp, Big::exp, at [
                        Points::Even(-1.0, 1.0), Points::Even(-760.0, 720.0), Points::Even(-110.0, 90.0),
                        Points::Powers(-60.0, 9.0)
                    ];
                }
                exp2(x) {
                    value: (libm exp2 exp2f);
                    slope: { let value = x.exp2(); (value, F::of(LN_2) * value) };
                    bounds: x.increasing(Real::exp2, ALL, POSITIVE);
                }
                exp_m1(x) {
                    value: (libm expm1 expm1f);
                    slope: (x.exp_m1(), x.exp());
                    bounds: x.increasing(Real::exp_m1, ALL, ALL);
                }
                ln(x) {
                    value: (libm log logf);
                    slope: (x.ln(), F::of(1.0) / x);
                    bounds: x.increasing(Real::ln, POSITIVE, ALL);
                    kernel: ln within 1.0, fast fast_ln, of pxfm::f_log, Big::ln, at [
                        Points::Even(0.5, 2.0), Points::Even(0.999, 1.001), Points::Sizes(-1080.0, 1024.0)
                    ];
                }
                ln_1p(x) {
                    value: (libm log1p log1pf);
                    slope: (x.ln_1p(), F::of(1.0) / (F::of(1.0) + x));
                    bounds: x.increasing(Real::ln_1p, [-1.0, f64::INFINITY], ALL);
                    kernel: ln_1p within 1.0, fast fast_ln_1p, of pxfm::f_log1p, Big::ln_1p, at [
                        Points::Even(-0.999, 9.0), Points::Even(-0.001, 0.001), Points::Sizes(-1080.0, 1024.0)
                    ];
                }
                log2(x) {
                    value: (libm log2 log2f);
                    slope: (x.log2(), F::of(1.0) / (F::of(LN_2) * x));
                    bounds: x.increasing(Real::log2, POSITIVE, ALL);
                }
                log10(x) {
                    value: (libm log10 log10f);
                    slope: (x.log10(), F::of(1.0) / (F::of(LN_10) * x));
                    bounds: x.increasing(Real::log10, POSITIVE, ALL);
                }
                sin(x) {
                    value: (libm sin sinf);
                    slope: x.sin_cos();
                    bounds: x.wave(<f64 as Real>::sin);
                    kernel: sin within 1.0, fast fast_sin, of pxfm::f_sin, Big::sin, at [
                        Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters
                    ];
                }
                cos(x) {
                    value: (libm cos cosf);
                    slope: { let (sine, cosine) = x.sin_cos(); (cosine, -sine) };
                    bounds: x.wave(<f64 as Real>::cos);
                    kernel: cos within 1.0, fast fast_cos, of pxfm::f_cos, Big::cos, at [
                        Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters
                    ];
                }
                tan(x) {
                    value: (libm tan tanf);
                    slope: { let value = x.tan(); (value, value.fma(value, F::of(1.0))) };
                    bounds: x.tangent();
                    kernel: tan within 2.0, fast fast_tan, of pxfm::f_tan, Big::tan, at [
                        Points::Even(-1.7e6, 1.7e6), Points::Powers(-60.0, 24.0), Points::Quarters
                    ];
                }
                asin(x) {
                    value: (libm asin asinf);
                    slope: (x.asin(), F::of(1.0) / ((F::of(1.0) - x) * (F::of(1.0) + x)).sqrt());
                    bounds: x.increasing(Real::asin, UNIT, ALL);
                    kernel: asin within 1.0, fast fast_asin, of pxfm::f_asin, Big::asin, at [
                        Points::Even(-1.0, 1.0), Points::Powers(-60.0, 0.0)
                    ];
                }
                acos(x) {
                    value: (libm acos acosf);
                    slope: (x.acos(), F::of(-1.0) / ((F::of(1.0) - x) * (F::of(1.0) + x)).sqrt());
                    bounds: (-x).increasing(|x| <f64 as Real>::acos(-x), UNIT, ALL);
                    kernel: acos within 1.0, fast fast_acos, of pxfm::f_acos, Big::acos, at [
                        Points::Even(-1.0, 1.0), Points::Even(0.999, 1.0), Points::Powers(-60.0, 0.0)
                    ];
                }
                atan(x) {
                    value: (libm atan atanf);
                    slope: (x.atan(), F::of(1.0) / x.fma(x, F::of(1.0)));
                    bounds: x.increasing(Real::atan, ALL, ALL);
                    kernel: atan within 1.0, fast fast_atan, of pxfm::f_atan, Big::atan, at [
                        Points::Even(-1.0, 1.0), Points::Even(-4.0, 4.0), Points::Powers(-60.0, 70.0)
                    ];
                }
                sinh(x) {
                    value: (libm sinh sinhf);
                    slope: (x.sinh(), x.cosh());
                    bounds: x.increasing(Real::sinh, ALL, ALL);
                }
                cosh(x) {
                    value: (libm cosh coshf);
                    slope: (x.cosh(), x.sinh());
                    bounds: x.magnitudes().increasing(Real::cosh, ALL, POSITIVE);
                }
                tanh(x) {
                    value: (libm tanh tanhf);
                    // sinh / cosh is inf / inf from 711 on; 1 - tanh² has no such end.
                    slope: { let value = x.tanh(); (value, F::of(1.0) - value * value) };
                    bounds: x.increasing(Real::tanh, ALL, ALL);
                    kernel: tanh within 2.0, fast fast_tanh, of pxfm::f_tanh, Big::tanh, at [
                        Points::Even(-1.0, 1.0), Points::Even(-22.0, 22.0), Points::Powers(-60.0, 9.0)
                    ];
                }
                asinh(x) {
                    value: (libm asinh asinhf);
                    slope: (x.asinh(), F::of(1.0) / x.hypot(F::of(1.0)));
                    bounds: x.increasing(Real::asinh, ALL, ALL);
                }
                acosh(x) {
                    value: (libm acosh acoshf);
                    slope: (x.acosh(), F::of(1.0) / ((x - F::of(1.0)) * (x + F::of(1.0))).sqrt());
                    bounds: x.increasing(Real::acosh, [1.0, f64::INFINITY], POSITIVE);
                }
                atanh(x) {
                    value: (libm atanh atanhf);
                    slope: (x.atanh(), F::of(1.0) / ((F::of(1.0) - x) * (F::of(1.0) + x)));
                    bounds: x.increasing(Real::atanh, UNIT, ALL);
                }
                abs(x) {
                    value: (Self::abs(x));
                    slope: (x.abs(), x.signum());
                    bounds: x.magnitudes();
                }
                // Steps have the slope zero wherever they have one.
                signum(x) {
                    value: (Self::signum(x));
                    slope: (x.signum(), F::of(0.0));
                    bounds: if x.contains(0.0) { Interval::new(-1.0, 1.0) } else { x.whole(<f64 as Real>::signum) };
                }
                floor(x) {
                    value: (libm floor floorf);
                    slope: (x.floor(), F::of(0.0));
                    bounds: x.whole(Real::floor);
                }
                ceil(x) {
                    value: (libm ceil ceilf);
                    slope: (x.ceil(), F::of(0.0));
                    bounds: x.whole(Real::ceil);
                }
                trunc(x) {
                    value: (libm trunc truncf);
                    slope: (x.trunc(), F::of(0.0));
                    bounds: x.whole(Real::trunc);
                }
                round(x) {
                    value: (libm round roundf);
                    slope: (x.round(), F::of(0.0));
                    bounds: x.whole(Real::round);
                }
                round_ties_even(x) {
                    value: (libm rint rintf);
                    slope: (x.round_ties_even(), F::of(0.0));
                    bounds: x.whole(Real::round_ties_even);
                }
            }
            binary {
                // d(xʸ) = y·x^(y-1) dx + xʸ·ln x dy; a constant exponent must not meet the logarithm of a negative base.
                powf(x, y) {
                    value: (libm pow powf);
                    dual: {
                        let (base, exponent, zero) = (x.value, y.value, F::of(0.0));
                        let value = base.powf(exponent);
                        let by_base = exponent * base.powf(exponent - F::of(1.0));
                        let by_base = F::select(exponent.equal(zero), zero, by_base);
                        if y.is_constant() {
                            return dual!(value, direction => product(by_base, x.along[direction]));
                        }
                        let by_exponent = value * base.ln();
                        dual!(value, direction => by_base.fma(x.along[direction], product(by_exponent, y.along[direction])))
                    };
                    bounds: x.power(y);
                    kernel: powf within 2.0, of pxfm::f_pow, |x: &Big, y: &Big| x.powf(y), at [
                        Points::Pairs(&Points::Sizes(-4.0, 4.0), &Points::Even(-30.0, 30.0)),
                        Points::Pairs(&Points::Sizes(-120.0, 120.0), &Points::Even(-9.0, 9.0)),
                        Points::Pairs(&Points::Sizes(-0.01, 0.01), &Points::Powers(0.0, 17.0))
                    ];
                }
                // d atan2(y, x) = (x dy - y dx) / (x² + y²), divided by the hypotenuse twice so that no square overflows.
                atan2(y, x) {
                    value: (libm atan2 atan2f);
                    dual: {
                        let radius = y.value.hypot(x.value);
                        let slopes = (x.value / radius / radius, -(y.value / radius / radius));
                        Self::chain_of_two(y, x, y.value.atan2(x.value), slopes.0, slopes.1)
                    };
                    bounds: y.angle(x);
                    kernel: atan2 within 1.0, fast fast_atan2, of pxfm::f_atan2, Big::atan2, at [
                        Points::Pairs(&Points::Even(-1.0, 1.0), &Points::Even(-1.0, 1.0)),
                        Points::Pairs(&Points::Powers(-60.0, 60.0), &Points::Powers(-20.0, 20.0))
                    ];
                }
                hypot(x, y) {
                    value: (libm hypot hypotf);
                    dual: {
                        let radius = x.value.hypot(y.value);
                        Self::chain_of_two(x, y, radius, x.value / radius, y.value / radius)
                    };
                    bounds: {
                        let (x, y) = (x.magnitudes(), y.magnitudes());
                        Interval::of_function(Real::hypot(x.low, y.low), Real::hypot(x.high, y.high), POSITIVE)
                    };
                }
                // As in std, a NaN gives way to the other argument; the derivatives go with the value.
                min(x, y) {
                    value: (Self::min(x, y));
                    dual: {
                        let is_x = x.value.less_or_equal(y.value).or(y.value.equal(y.value).not());
                        Self::select_along(x.value.min(y.value), is_x, x, y)
                    };
                    bounds: Interval::new(f64::min(x.low, y.low), f64::min(x.high, y.high));
                }
                max(x, y) {
                    value: (Self::max(x, y));
                    dual: {
                        let is_x = y.value.less_or_equal(x.value).or(y.value.equal(y.value).not());
                        Self::select_along(x.value.max(y.value), is_x, x, y)
                    };
                    bounds: Interval::new(f64::max(x.low, y.low), f64::max(x.high, y.high));
                }
                // x - n y, with the whole number n that stays the same nearby.
                remainder(x, y) {
                    value: (libm fmod fmodf, std x % y);
                    dual: {
                        let whole = (x.value / y.value).trunc();
                        dual!(x.value.remainder(y.value), direction => {
                            x.along[direction] - product(whole, y.along[direction])
                        })
                    };
                    bounds: x.modulo(y);
                    kernel: remainder within 0.0, of std::ops::Rem::rem, |x: &Big, y: &Big| x % y, at [
                        Points::Pairs(&Points::Even(-8.0, 8.0), &Points::Even(-3.0, 3.0)),
                        Points::Pairs(&Points::Powers(-60.0, 60.0), &Points::Powers(-4.0, 4.0)),
                        Points::Pairs(&Points::Sizes(-120.0, 120.0), &Points::Sizes(-120.0, 120.0))
                    ];
                }
            }
        }
    };
    ($callback:ident! { $($context:tt)* }) => {
        $crate::scalar::functions::elementary_functions! {
            @to [$crate::scalar::functions::elementary_functions!] [@names $callback [$($context)*]]
        }
    };
}
pub(crate) use elementary_functions;
