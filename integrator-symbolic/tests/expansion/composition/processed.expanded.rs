/// Order 1 for every `T` (proved), not symmetric, 1 force evaluation a step. Stable up to `h ω = 2.000`, leading error 2.5e-1.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::default::Default,
    ::core::cmp::PartialEq,
    ::core::cmp::Eq,
    ::core::hash::Hash,
)]
struct Shifted;
#[allow(
    clippy::approx_constant,
    reason = "the order conditions, not known constants, choose the coefficients"
)]
impl ::integrator_core::__private::Scheme for Shifted {
    const NAME: &'static str = "Shifted";
    const CITATION: &'static str = "";
    const ORDER: u32 = 1;
    const SYMMETRIC: bool = false;
    const CLASS: ::integrator_core::__private::Class = ::integrator_core::__private::Class::General;
    const FORCE_EVALUATIONS: usize = 1;
    const GRADIENT_EVALUATIONS: usize = 0;
    const STABILITY_LIMIT: f64 = 2.0;
    const LEADING_ERROR: ::core::option::Option<f64> = ::core::option::Option::Some(
        0.25,
    );
    const STAGES: ::integrator_core::__private::Stages = ::integrator_core::__private::Stages {
        lead: ::integrator_core::__private::Lead::Drift,
        opening: ::integrator_core::__private::Stage {
            drift: 0.5,
            kick: 1.0,
            gradient: 0.0,
            drift_time: 0.25,
            kick_time: 1.0,
            middle: [0.5, 0.5],
        },
        cycle: &[
            ::integrator_core::__private::Stage {
                drift: 1.0,
                kick: 1.0,
                gradient: 0.0,
                drift_time: 0.25,
                kick_time: 1.0,
                middle: [0.5, 0.5],
            },
        ],
        closing: ::integrator_core::__private::Stage {
            drift: 0.5,
            kick: 0.0,
            gradient: 0.0,
            drift_time: 1.25,
            kick_time: 0.0,
            middle: [0.0, 0.0],
        },
    };
    const PROCESSOR: ::integrator_core::__private::Processor = ::integrator_core::__private::Processor {
        before: ::integrator_core::__private::Rows {
            lead: ::integrator_core::__private::Lead::Kick,
            rows: &[
                ::integrator_core::__private::Stage {
                    drift: 0.5,
                    kick: 0.25,
                    gradient: 0.0,
                    drift_time: 0.25,
                    kick_time: 0.0,
                    middle: [0.0, 0.0],
                },
            ],
        },
        after: ::integrator_core::__private::Rows {
            lead: ::integrator_core::__private::Lead::Drift,
            rows: &[
                ::integrator_core::__private::Stage {
                    drift: -0.5,
                    kick: -0.25,
                    gradient: 0.0,
                    drift_time: 1.25,
                    kick_time: 1.0,
                    middle: [0.0, 0.0],
                },
            ],
        },
    };
}
impl<
    __System: ::integrator_core::__private::System,
> ::integrator_core::__private::Composition<__System> for Shifted {}
