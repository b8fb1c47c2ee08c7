/// Order 4 for `T` quadratic in `p` (proved), symmetric, 2 force evaluations (1 with its gradient) a step. Stable up to `h ω = 3.464`, leading error 1.0e-3.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::default::Default,
    ::core::cmp::PartialEq,
    ::core::cmp::Eq,
    ::core::hash::Hash,
)]
pub struct Chin4A;
#[allow(
    clippy::approx_constant,
    reason = "the order conditions, not known constants, choose the coefficients"
)]
impl ::integrator_core::__private::Scheme for Chin4A {
    const NAME: &'static str = "Chin4A";
    const CITATION: &'static str = "";
    const ORDER: u32 = 4;
    const SYMMETRIC: bool = true;
    const CLASS: ::integrator_core::__private::Class = ::integrator_core::__private::Class::QuadraticKinetic;
    const FORCE_EVALUATIONS: usize = 2;
    const GRADIENT_EVALUATIONS: usize = 1;
    const STABILITY_LIMIT: f64 = 3.4641016215;
    const LEADING_ERROR: ::core::option::Option<f64> = ::core::option::Option::Some(
        0.0010221945447138712,
    );
    const STAGES: ::integrator_core::__private::Stages = ::integrator_core::__private::Stages {
        lead: ::integrator_core::__private::Lead::Kick,
        opening: ::integrator_core::__private::Stage {
            drift: 0.5,
            kick: 0.16666666666666666,
            gradient: 0.0,
            drift_time: 0.16666666666666666,
            kick_time: 0.0,
            middle: [0.16666666666666666, 0.3333333333333333],
        },
        cycle: &[
            ::integrator_core::__private::Stage {
                drift: 0.5,
                kick: 0.3333333333333333,
                gradient: 0.0,
                drift_time: 0.16666666666666666,
                kick_time: 0.0,
                middle: [0.16666666666666666, 0.3333333333333333],
            },
            ::integrator_core::__private::Stage {
                drift: 0.5,
                kick: 0.6666666666666666,
                gradient: -0.013888888888888888,
                drift_time: 0.8333333333333334,
                kick_time: 0.5,
                middle: [0.3333333333333333, 0.16666666666666666],
            },
        ],
        closing: ::integrator_core::__private::Stage {
            drift: 0.0,
            kick: 0.16666666666666666,
            gradient: 0.0,
            drift_time: 0.0,
            kick_time: 1.0,
            middle: [0.0, 0.0],
        },
    };
}
impl<
    __System: ::integrator_core::__private::QuadraticKinetic,
> ::integrator_core::__private::Composition<__System> for Chin4A {
    #[inline(always)]
    fn kick(
        flows: &mut impl ::integrator_core::__private::Flows<__System>,
        stage: &::integrator_core::__private::Stage,
        h: f64,
        time: f64,
    ) {
        if stage.gradient != 0.0 {
            flows
                .gradient_kick(
                    h * stage.kick,
                    h * h * h * stage.gradient,
                    time + h * stage.kick_time,
                );
        } else {
            flows.kick(h * stage.kick, time + h * stage.kick_time);
        }
    }
}
