#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters;
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters {
        type Single = Parameters;
        #[inline(always)]
        fn gather(_members: &[&Self::Single]) -> Self {
            Parameters
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[0]/dt = p[0]
    /// dq[1]/dt = p[1]
    /// dp[0]/dt = -q[0] (1 + 2 q[1])
    /// dp[1]/dt = -q[1] - q[0]^2 + q[1]^2
    /// ```
    ///
    /// `T` is quadratic in the momenta, with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for HenonHeiles {
        type Compose = runtime::Verlet;
        const EQUATIONS: &'static [&'static str] = &[
            "T = (p[0]^2 + p[1]^2) / 2",
            "V = (q[0]^2 + q[1]^2) / 2 + q[1] q[0]^2 - q[1]^3 / 3",
            "dq[0]/dt = p[0]",
            "dq[1]/dt = p[1]",
            "dp[0]/dt = -q[0] (1 + 2 q[1])",
            "dp[1]/dt = -q[1] - q[0]^2 + q[1]^2",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for HenonHeiles {
        type Coords = [f64; 2];
        type Parameters<Scalar: runtime::Real> = Parameters;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters,
        >;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 14255250820355731464;
        fn parameters(&self, _length: usize) -> Parameters {
            Parameters
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            motion.q[0].scale_add(step, motion.p[0].value());
            motion.q[1].scale_add(step, motion.p[1].value());
        }
        #[inline(always)]
        fn kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            motion.p[0].fma((step * Scalar::of(2.0)).scale(q0), q1 + Scalar::of(0.5));
            motion.p[1].scale_add(step, q1 + q1.square_from(q0.square()));
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
            moved.q[1].scale_add(step, motion.p[1].value());
        }
        #[inline(always)]
        fn along_force<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
            moved: runtime::MovedBy<'_, Self, Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            moved.p[0].fma((step * Scalar::of(2.0)).scale(q0), q1 + Scalar::of(0.5));
            moved.p[1].scale_add(step, q1 + q1.square_from(q0.square()));
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            Scalar::of(0.5).scale(p1.square_add(p0.square()))
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            let shared_0 = q0.square();
            let shared_1 = q1.square();
            Scalar::of(-0.3333333333333333)
                .scale_add(
                    shared_1 * q1,
                    q1.fma(shared_0, Scalar::of(0.5).scale(shared_0 + shared_1)),
                )
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
    impl runtime::QuadraticKinetic for HenonHeiles {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = [Scalar::of(0.0); 2];
            let p1 = motion.p[1].value();
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            let shared_0 = Scalar::of(2.0).scale(p1);
            let shared_1 = Scalar::of(2.0).scale(motion.p[0].value());
            gradient[0] += shared_0.fma(q0, shared_1 * (q1 + Scalar::of(0.5)));
            gradient[1] += (-shared_0).fma(q1, shared_1.fma(q0, p1));
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
    impl runtime::TimeTransformed for HenonHeiles {
        #[inline(always)]
        fn kinetic_plus<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
            more: Scalar,
        ) -> Scalar {
            let time = more;
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            Scalar::of(0.5).scale_add(p1.square_add(p0.square()), time)
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
            motion.q[1].fma(step, motion.p[1].value());
        }
        #[inline(always)]
        fn logarithmic_kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) -> Scalar {
            let step = -duration;
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            let shared_0 = q0.square();
            let shared_1 = q1.square();
            let shared_2 = Scalar::of(-0.3333333333333333)
                .scale_add(
                    shared_1 * q1,
                    q1.fma(shared_0, Scalar::of(0.5).scale(shared_0 + shared_1)),
                );
            let shared_3 = Scalar::of(1.0) / shared_2;
            let shared_4 = q1 * shared_3;
            motion
                .p[0]
                .fma(
                    -(Scalar::of(2.0).scale(step) * q0),
                    Scalar::of(0.5).scale_add(shared_3, shared_4),
                );
            motion
                .p[1]
                .fma(step, (-shared_0).fma(shared_3, shared_1 * shared_3) - shared_4);
            shared_2
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for HenonHeiles {}
};
