#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `1 / (mass length^2)`
        prepared_0: Scalar,
        /// `-mass gravity length`
        prepared_1: Scalar,
        /// `1 / (2 mass length^2)`
        prepared_2: Scalar,
    }
    impl Parameters<f64> {
        fn prepared_0(&self) -> &f64 {
            &self.prepared_0
        }
        fn prepared_1(&self) -> &f64 {
            &self.prepared_1
        }
        fn prepared_2(&self) -> &f64 {
            &self.prepared_2
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                prepared_0: runtime::in_lanes(members, Parameters::prepared_0),
                prepared_1: runtime::in_lanes(members, Parameters::prepared_1),
                prepared_2: runtime::in_lanes(members, Parameters::prepared_2),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("1 / (mass length^2)", &[], &single.prepared_0),
                    runtime::not_finite("-mass gravity length", &[], &single.prepared_1),
                    runtime::not_finite("1 / (2 mass length^2)", &[], &single.prepared_2),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.prepared_0);
            digest.add(&single.prepared_1);
            digest.add(&single.prepared_2);
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[0]/dt = p[0] / (mass length^2)
    /// dp[0]/dt = -mass gravity length sin(q[0])
    /// ```
    ///
    /// `T` is quadratic in the momenta, with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for Pendulum {
        type Compose = Yoshida4;
        const EQUATIONS: &'static [&'static str] = &[
            "T = p[0]^2 / (2 mass length^2)",
            "V = -mass gravity length cos(q[0])",
            "dq[0]/dt = p[0] / (mass length^2)",
            "dp[0]/dt = -mass gravity length sin(q[0])",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Pendulum {
        type Coords = [f64; 1];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 16774634022678824561;
        fn parameters(&self, length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: 2.0 / (2.0 * self.mass * self.length.powi(2)),
                prepared_1: -self.mass * self.gravity * self.length,
                prepared_2: 1.0 / (2.0 * self.mass * self.length.powi(2)),
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            motion
                .q[0]
                .scale_add(step * motion.parameters.prepared_0, motion.p[0].value());
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
                .scale_add(
                    -(step * motion.parameters.prepared_1),
                    motion.q[0].value().sin(),
                );
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
            moved
                .q[0]
                .scale_add(step * motion.parameters.prepared_0, motion.p[0].value());
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
                .scale_add(
                    -(step * motion.parameters.prepared_1),
                    motion.q[0].value().sin(),
                );
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let p0 = motion.p[0].value();
            motion.parameters.prepared_2.scale(p0.square())
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            motion.parameters.prepared_1.scale(motion.q[0].value().cos())
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
    impl runtime::QuadraticKinetic for Pendulum {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = [Scalar::of(0.0); 1];
            gradient[0] = (-motion.parameters.prepared_1.scale(motion.p[0].value()))
                .fma(motion.q[0].value().cos(), gradient[0]);
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
    impl runtime::TimeTransformed for Pendulum {
        #[inline(always)]
        fn kinetic_plus<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
            more: Scalar,
        ) -> Scalar {
            let time = more;
            let p0 = motion.p[0].value();
            motion.parameters.prepared_2.scale_add(p0.square(), time)
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
            motion
                .q[0]
                .fma(motion.parameters.prepared_0.scale(step), motion.p[0].value());
        }
        #[inline(always)]
        fn logarithmic_kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) -> Scalar {
            let step = -duration;
            let q0 = motion.q[0].value();
            let (shared_1, shared_0) = q0.sin_cos();
            motion.p[0].add(step * shared_1 / shared_0);
            motion.parameters.prepared_1.scale(shared_0)
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Pendulum {}
};
