#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `-pull / 2`
        prepared_0: Scalar,
        /// `3 twist / 2`
        prepared_1: Scalar,
        /// `-3 pull / 4`
        prepared_2: Scalar,
        /// `3.75 twist`
        prepared_3: Scalar,
        /// `-pull`
        prepared_4: Scalar,
        /// `twist`
        twist: Scalar,
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
        fn prepared_3(&self) -> &f64 {
            &self.prepared_3
        }
        fn prepared_4(&self) -> &f64 {
            &self.prepared_4
        }
        fn twist(&self) -> &f64 {
            &self.twist
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
                prepared_3: runtime::in_lanes(members, Parameters::prepared_3),
                prepared_4: runtime::in_lanes(members, Parameters::prepared_4),
                twist: runtime::in_lanes(members, Parameters::twist),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("-pull / 2", &[], &single.prepared_0),
                    runtime::not_finite("3 twist / 2", &[], &single.prepared_1),
                    runtime::not_finite("-3 pull / 4", &[], &single.prepared_2),
                    runtime::not_finite("3.75 twist", &[], &single.prepared_3),
                    runtime::not_finite("-pull", &[], &single.prepared_4),
                    runtime::not_finite("twist", &[], &single.twist),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.prepared_0);
            digest.add(&single.prepared_1);
            digest.add(&single.prepared_2);
            digest.add(&single.prepared_3);
            digest.add(&single.prepared_4);
            digest.add(&single.twist);
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[0]/dt = p[0]
    /// dq[1]/dt = p[1]
    /// dp[0]/dt = -q[0] (3 twist / r^2 + pull) / r^3
    /// dp[1]/dt = -q[1] (3 twist / r^2 + pull) / r^3
    /// where r = sqrt(q[0]^2 + q[1]^2)
    /// ```
    ///
    /// `T` is quadratic in the momenta, with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for Comet {
        type Compose = runtime::Verlet;
        const EQUATIONS: &'static [&'static str] = &[
            "T = (p[0]^2 + p[1]^2) / 2",
            "V = -twist / (q[0]^2 + q[1]^2)^(3/2) - pull / sqrt(q[0]^2 + q[1]^2)",
            "dq[0]/dt = p[0]",
            "dq[1]/dt = p[1]",
            "dp[0]/dt = -q[0] (3 twist / r^2 + pull) / r^3",
            "dp[1]/dt = -q[1] (3 twist / r^2 + pull) / r^3",
            "where r = sqrt(q[0]^2 + q[1]^2)",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Comet {
        type Coords = [f64; 2];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 15789509430609174222;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: 0.5 * (-self.pull),
                prepared_1: 1.5 * self.twist,
                prepared_2: 0.75 * (-self.pull),
                prepared_3: 3.75 * self.twist,
                prepared_4: -self.pull,
                twist: self.twist,
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
            let shared_0 = step * Scalar::of(2.0);
            let shared_1 = Scalar::of(1.0) / q1.square_add(q0.square());
            let shared_2 = shared_1 * shared_1.sqrt()
                * motion
                    .parameters
                    .prepared_1
                    .scale_add(shared_1, -motion.parameters.prepared_0);
            motion.p[0].fma(shared_0.scale(q0), shared_2);
            motion.p[1].fma(shared_0.scale(q1), shared_2);
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
            let shared_0 = step * Scalar::of(2.0);
            let shared_1 = Scalar::of(1.0) / q1.square_add(q0.square());
            let shared_2 = shared_1 * shared_1.sqrt()
                * motion
                    .parameters
                    .prepared_1
                    .scale_add(shared_1, -motion.parameters.prepared_0);
            moved.p[0].fma(shared_0.scale(q0), shared_2);
            moved.p[1].fma(shared_0.scale(q1), shared_2);
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
            let shared_0 = Scalar::of(1.0) / q1.square_add(q0.square());
            shared_0.sqrt()
                * (-motion.parameters.twist)
                    .scale_add(shared_0, motion.parameters.prepared_4)
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
    impl runtime::QuadraticKinetic for Comet {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = [Scalar::of(0.0); 2];
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            let shared_0 = Scalar::of(2.0).scale(motion.p[1].value());
            let shared_1 = Scalar::of(2.0).scale(motion.p[0].value());
            let shared_2 = Scalar::of(1.0) / q1.square_add(q0.square());
            let shared_3 = shared_2.sqrt();
            let shared_4 = shared_2.square();
            let shared_5 = shared_4 * shared_3;
            let shared_6 = shared_0.fma(q1, shared_1 * q0);
            let shared_7 = (-motion.parameters.prepared_0)
                .scale_add(
                    shared_2 * shared_3,
                    motion.parameters.prepared_1.scale(shared_5),
                );
            let shared_8 = (-motion.parameters.prepared_3.scale(shared_6))
                .fma(
                    shared_4 * shared_2 * shared_3,
                    motion.parameters.prepared_2.scale(shared_6) * shared_5,
                );
            gradient[0] += Scalar::of(2.0).scale(q0).fma(shared_8, shared_1 * shared_7);
            gradient[1] += Scalar::of(2.0).scale(q1).fma(shared_8, shared_0 * shared_7);
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
    impl runtime::TimeTransformed for Comet {
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
            let shared_0 = Scalar::of(2.0).scale(step);
            let shared_1 = Scalar::of(1.0) / q1.square_add(q0.square());
            let shared_2 = shared_1.sqrt();
            let shared_3 = shared_1 * shared_2;
            let shared_4 = Scalar::of(1.0)
                / (-motion.parameters.twist)
                    .scale_add(shared_3, motion.parameters.prepared_4.scale(shared_2));
            let shared_5 = (-motion.parameters.prepared_1.scale(shared_4))
                .fma(
                    shared_1.square() * shared_2,
                    motion.parameters.prepared_0.scale(shared_4) * shared_3,
                );
            motion.p[0].fma(shared_0 * q0, shared_5);
            motion.p[1].fma(shared_0 * q1, shared_5);
            shared_2
                * (-motion.parameters.twist)
                    .scale_add(shared_1, motion.parameters.prepared_4)
        }
    }
    #[automatically_derived]
    impl runtime::Rated for Comet {
        const LINEAR_VELOCITY: bool = true;
        #[inline(always)]
        fn rate_of<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            Scalar::of(1.0) / q1.square_add(q0.square())
        }
        fn stated_rate(&self, q: &Self::Coords) -> f64 {
            Self::rate(self, *q)
        }
        #[inline(always)]
        fn kick_by_rate<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) {
            let step = -duration;
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            let shared_0 = Scalar::of(2.0).scale(step);
            let shared_1 = q1.square_add(q0.square());
            let shared_2 = Scalar::of(1.0) / shared_1.square();
            motion.p[0].fma(-(shared_0 * q0), shared_2);
            motion.p[1].fma(-(shared_0 * q1), shared_2);
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Comet {}
};
