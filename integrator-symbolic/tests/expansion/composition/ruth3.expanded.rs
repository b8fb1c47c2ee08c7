/// Order 3 for every `T` (proved), not symmetric, 3 force evaluations a step. Stable up to `h ω = 2.507`, leading error 1.5e-2.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::default::Default,
    ::core::cmp::PartialEq,
    ::core::cmp::Eq,
    ::core::hash::Hash,
)]
struct Ruth3;
#[allow(
    clippy::approx_constant,
    reason = "the order conditions, not known constants, choose the coefficients"
)]
impl my::runtime::__private::Scheme for Ruth3 {
    const NAME: &'static str = "Ruth3";
    const CITATION: &'static str = "";
    const ORDER: u32 = 3;
    const SYMMETRIC: bool = false;
    const CLASS: my::runtime::__private::Class = my::runtime::__private::Class::General;
    const FORCE_EVALUATIONS: usize = 3;
    const GRADIENT_EVALUATIONS: usize = 0;
    const STABILITY_LIMIT: f64 = 2.507481171;
    const LEADING_ERROR: ::core::option::Option<f64> = ::core::option::Option::Some(
        0.014800142157172468,
    );
    const STAGES: my::runtime::__private::Stages = my::runtime::__private::Stages {
        lead: my::runtime::__private::Lead::Kick,
        opening: my::runtime::__private::Stage {
            drift: 0.6666666666666666,
            kick: 0.2916666666666667,
            gradient: 0.0,
            drift_time: 0.2916666666666667,
            kick_time: 0.0,
            middle: [0.2916666666666667, 0.375],
        },
        cycle: &[
            my::runtime::__private::Stage {
                drift: 0.6666666666666666,
                kick: 0.2916666666666667,
                gradient: 0.0,
                drift_time: 0.2916666666666667,
                kick_time: 0.0,
                middle: [0.2916666666666667, 0.375],
            },
            my::runtime::__private::Stage {
                drift: -0.6666666666666666,
                kick: 0.75,
                gradient: 0.0,
                drift_time: 1.0416666666666667,
                kick_time: 0.6666666666666666,
                middle: [0.375, -1.0416666666666667],
            },
            my::runtime::__private::Stage {
                drift: 1.0,
                kick: -0.041666666666666664,
                gradient: 0.0,
                drift_time: 1.0,
                kick_time: 0.0,
                middle: [1.0, 0.0],
            },
        ],
        closing: my::runtime::__private::Stage::NONE,
    };
}
impl<
    __System: my::runtime::__private::System,
> my::runtime::__private::Composition<__System> for Ruth3 {}
