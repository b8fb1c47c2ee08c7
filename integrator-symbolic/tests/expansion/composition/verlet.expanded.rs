/// Strang's splitting.
///
/// Order 2 for every `T` (proved), symmetric, 1 force evaluation a step. Stable up to `h ω = 2.000`, leading error 9.3e-2.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::default::Default,
    ::core::cmp::PartialEq,
    ::core::cmp::Eq,
    ::core::hash::Hash,
)]
pub struct Verlet;
#[allow(
    clippy::approx_constant,
    reason = "the order conditions, not known constants, choose the coefficients"
)]
impl ::integrator_core::__private::Scheme for Verlet {
    const NAME: &'static str = "Verlet";
    const CITATION: &'static str = "";
    const ORDER: u32 = 2;
    const SYMMETRIC: bool = true;
    const CLASS: ::integrator_core::__private::Class = ::integrator_core::__private::Class::General;
    const FORCE_EVALUATIONS: usize = 1;
    const GRADIENT_EVALUATIONS: usize = 0;
    const STABILITY_LIMIT: f64 = 2.0;
    const LEADING_ERROR: ::core::option::Option<f64> = ::core::option::Option::Some(
        0.09316949906249124,
    );
    const STAGES: ::integrator_core::__private::Stages = ::integrator_core::__private::Stages {
        lead: ::integrator_core::__private::Lead::Drift,
        opening: ::integrator_core::__private::Stage {
            drift: 0.5,
            kick: 1.0,
            gradient: 0.0,
            drift_time: 0.0,
            kick_time: 0.5,
            middle: [0.5, 0.5],
        },
        cycle: &[
            ::integrator_core::__private::Stage {
                drift: 1.0,
                kick: 1.0,
                gradient: 0.0,
                drift_time: 0.0,
                kick_time: 0.5,
                middle: [0.5, 0.5],
            },
        ],
        closing: ::integrator_core::__private::Stage {
            drift: 0.5,
            kick: 0.0,
            gradient: 0.0,
            drift_time: 1.0,
            kick_time: 0.0,
            middle: [0.0, 0.0],
        },
    };
}
impl<
    __System: ::integrator_core::__private::System,
> ::integrator_core::__private::Composition<__System> for Verlet {}
