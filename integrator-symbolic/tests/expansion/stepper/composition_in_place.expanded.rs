#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    #[derive(
        ::core::clone::Clone,
        ::core::marker::Copy,
        ::core::fmt::Debug,
        ::core::default::Default,
        ::core::cmp::PartialEq,
        ::core::cmp::Eq,
        ::core::hash::Hash,
    )]
    pub struct InPlace;
    #[allow(
        clippy::approx_constant,
        reason = "the order conditions, not known constants, choose the coefficients"
    )]
    impl ::integrator_core::__private::Scheme for InPlace {
        const NAME: &'static str = "V(1/2) T(1) V(1/2)";
        const CITATION: &'static str = "";
        const ORDER: u32 = 2;
        const SYMMETRIC: bool = true;
        const CLASS: ::integrator_core::__private::Class = ::integrator_core::__private::Class::QuadraticKinetic;
        const FORCE_EVALUATIONS: usize = 1;
        const GRADIENT_EVALUATIONS: usize = 0;
        const STABILITY_LIMIT: f64 = 2.0;
        const LEADING_ERROR: ::core::option::Option<f64> = ::core::option::Option::Some(
            0.09316949906249124,
        );
        const STAGES: ::integrator_core::__private::Stages = ::integrator_core::__private::Stages {
            lead: ::integrator_core::__private::Lead::Kick,
            opening: ::integrator_core::__private::Stage {
                drift: 1.0,
                kick: 0.5,
                gradient: 0.0,
                drift_time: 0.5,
                kick_time: 0.0,
                middle: [0.5, 0.5],
            },
            cycle: &[
                ::integrator_core::__private::Stage {
                    drift: 1.0,
                    kick: 1.0,
                    gradient: 0.0,
                    drift_time: 0.5,
                    kick_time: 0.0,
                    middle: [0.5, 0.5],
                },
            ],
            closing: ::integrator_core::__private::Stage {
                drift: 0.0,
                kick: 0.5,
                gradient: 0.0,
                drift_time: 0.0,
                kick_time: 1.0,
                middle: [0.0, 0.0],
            },
        };
    }
    impl<
        __System: ::integrator_core::__private::QuadraticKinetic,
    > ::integrator_core::__private::Composition<__System> for InPlace {}
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `stiffness`
        stiffness: Scalar,
        /// `stiffness / 2`
        prepared_1: Scalar,
    }
    impl Parameters<f64> {
        fn stiffness(&self) -> &f64 {
            &self.stiffness
        }
        fn prepared_1(&self) -> &f64 {
            &self.prepared_1
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                stiffness: runtime::in_lanes(members, Parameters::stiffness),
                prepared_1: runtime::in_lanes(members, Parameters::prepared_1),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("stiffness", &[], &single.stiffness),
                    runtime::not_finite("stiffness / 2", &[], &single.prepared_1),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.stiffness);
            digest.add(&single.prepared_1);
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[0]/dt = p[0]
    /// dp[0]/dt = -stiffness q[0]
    /// ```
    ///
    /// `T` is quadratic in the momenta, with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for Oscillator {
        type Compose = InPlace;
        const EQUATIONS: &'static [&'static str] = &[
            "T = p[0]^2 / 2",
            "V = stiffness q[0]^2 / 2",
            "dq[0]/dt = p[0]",
            "dp[0]/dt = -stiffness q[0]",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Oscillator {
        type Coords = [f64; 1];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 8344281942497229442;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                stiffness: self.stiffness,
                prepared_1: 0.5 * self.stiffness,
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            motion.q[0].scale_add(step, motion.p[0].value());
        }
        #[inline(always)]
        fn kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            motion
                .p[0]
                .scale_add(step * motion.parameters.stiffness, motion.q[0].value());
        }
        const HAS_FIELD: bool = true;
        #[inline(always)]
        fn along_velocity<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
            moved: runtime::MovedBy<'_, Self, Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            moved.q[0].scale_add(step, motion.p[0].value());
        }
        #[inline(always)]
        fn along_force<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
            moved: runtime::MovedBy<'_, Self, Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            moved
                .p[0]
                .scale_add(step * motion.parameters.stiffness, motion.q[0].value());
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let p0 = motion.p[0].value();
            Scalar::of(0.5).scale(p0.square())
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            motion.parameters.prepared_1.scale(q0) * q0
        }
        fn stated(
            &self,
            q: &Self::Coords,
            p: &Self::Coords,
            time: f64,
        ) -> runtime::StatedEnergy {
            runtime::StatedEnergy::Separate {
                kinetic: Self::kinetic(self, *p),
                potential: Self::potential(self, *q),
            }
        }
    }
    #[automatically_derived]
    impl runtime::QuadraticKinetic for Oscillator {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = [Scalar::of(0.0); 1];
            gradient[0] = motion
                .parameters
                .stiffness
                .scale_add(motion.p[0].value(), gradient[0]);
            for (slot, gradient) in ::core::iter::zip(motion.p.iter_mut(), &gradient) {
                (*slot) = *gradient;
            }
        }
        #[inline(always)]
        fn gradient_kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            gradient: f64,
            time: f64,
        ) {
            let mut force = motion.at_rest();
            <Self as runtime::System>::kick::<Scalar, f64>(&mut force, -1.0, time);
            motion.push(Scalar::of(-duration), &force);
            let mut bent = motion.at_rest();
            ::core::mem::swap(&mut force.q, &mut bent.p);
            <Self as runtime::System>::drift::<Scalar, f64>(&mut force, 1.0, time);
            bent.p = force.q;
            <Self as runtime::QuadraticKinetic>::hessian::<Scalar>(&mut bent, time);
            motion.push(Scalar::of(-2.0 * gradient), &bent);
        }
    }
    #[automatically_derived]
    impl runtime::TimeTransformed for Oscillator {
        #[inline(always)]
        fn kinetic_plus<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
            more: Scalar,
        ) -> Scalar {
            let time = more;
            let p0 = motion.p[0].value();
            Scalar::of(0.5).scale_add(p0.square(), time)
        }
        #[inline(always)]
        fn potential_of<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
        ) -> Scalar {
            <Self as runtime::System>::potential::<Scalar, Leaf>(motion, 0.0)
        }
        #[inline(always)]
        fn kick_for<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) {
            let mut force = motion.at_rest();
            <Self as runtime::System>::kick::<Scalar, f64>(&mut force, 1.0, 0.0);
            motion.push(duration, &force);
        }
        #[inline(always)]
        fn drift_for<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) {
            let step = duration;
            motion.q[0].fma(step, motion.p[0].value());
        }
        #[inline(always)]
        fn logarithmic_kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) -> Scalar {
            let step = -duration;
            let q0 = motion.q[0].value();
            motion.p[0].add(-(Scalar::of(2.0).scale(step) / q0));
            motion.parameters.prepared_1.scale(q0) * q0
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Oscillator {}
};
