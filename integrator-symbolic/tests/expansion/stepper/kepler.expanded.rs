#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `-mu`
        prepared_0: Scalar,
        /// `-3 mu`
        prepared_1: Scalar,
    }
    impl Parameters<f64> {
        fn prepared_0(&self) -> &f64 {
            &self.prepared_0
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
                prepared_0: runtime::in_lanes(members, Parameters::prepared_0),
                prepared_1: runtime::in_lanes(members, Parameters::prepared_1),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("-mu", &[], &single.prepared_0),
                    runtime::not_finite("-3 mu", &[], &single.prepared_1),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.prepared_0);
            digest.add(&single.prepared_1);
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[0]/dt = p[0]
    /// dq[1]/dt = p[1]
    /// dp[0]/dt = -mu q[0] / r^3
    /// dp[1]/dt = -mu q[1] / r^3
    /// where r = sqrt(q[0]^2 + q[1]^2)
    /// ```
    ///
    /// `T` is quadratic in the momenta, with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for Kepler {
        type Compose = runtime::Verlet;
        const EQUATIONS: &'static [&'static str] = &[
            "T = (p[0]^2 + p[1]^2) / 2",
            "V = -mu / sqrt(q[0]^2 + q[1]^2)",
            "dq[0]/dt = p[0]",
            "dq[1]/dt = p[1]",
            "dp[0]/dt = -mu q[0] / r^3",
            "dp[1]/dt = -mu q[1] / r^3",
            "where r = sqrt(q[0]^2 + q[1]^2)",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Kepler {
        type Coords = [f64; 2];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 16941470662577749677;
        const WIDE: bool = true;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: -self.mu,
                prepared_1: 3.0 * (-self.mu),
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
            let shared_0 = q1.square_add(q0.square());
            let shared_1 = (step * motion.parameters.prepared_0).div_pow_3_2(shared_0);
            motion.p[0].fma(-shared_1, q0);
            motion.p[1].fma(-shared_1, q1);
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
            let shared_0 = q1.square_add(q0.square());
            let shared_1 = (step * motion.parameters.prepared_0).div_pow_3_2(shared_0);
            moved.p[0].fma(-shared_1, q0);
            moved.p[1].fma(-shared_1, q1);
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
            motion.parameters.prepared_0 / q1.square_add(q0.square()).sqrt()
        }
        fn stated(
            &self,
            q: &Self::Coords,
            p: &Self::Coords,
            time: f64,
        ) -> runtime::StatedEnergy {
            runtime::StatedEnergy::Separate {
                kinetic: Self::kinetic(self, p),
                potential: Self::potential(self, q),
            }
        }
    }
    #[automatically_derived]
    impl runtime::QuadraticKinetic for Kepler {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = [Scalar::of(0.0); 2];
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            let shared_0 = Scalar::of(1.0) / q1.square_add(q0.square());
            let shared_1 = shared_0.sqrt();
            let shared_2 = motion.parameters.prepared_0.scale(shared_0 * shared_1);
            let shared_3 = motion.parameters.prepared_1.scale(p1.fma(q1, p0 * q0))
                * (shared_0.square() * shared_1);
            gradient[0] += (-shared_2).fma(p0, shared_3 * q0);
            gradient[1] += (-shared_2).fma(p1, shared_3 * q1);
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
    impl runtime::TimeTransformed for Kepler {
        const KEEPS_SIGN: bool = true;
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
            let shared_0 = Scalar::of(1.0) / q1.square_add(q0.square());
            motion.p[0].fma(step * q0, shared_0);
            motion.p[1].fma(step * q1, shared_0);
            motion.parameters.prepared_0
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Kepler {}
};
