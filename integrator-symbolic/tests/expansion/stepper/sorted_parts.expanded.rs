#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `mass`
        mass: Scalar,
        /// `1 - mass`
        prepared_1: Scalar,
        /// `mass / 2`
        prepared_2: Scalar,
        /// `(1 - mass) / 2`
        prepared_3: Scalar,
    }
    impl Parameters<f64> {
        fn mass(&self) -> &f64 {
            &self.mass
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
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                mass: runtime::in_lanes(members, Parameters::mass),
                prepared_1: runtime::in_lanes(members, Parameters::prepared_1),
                prepared_2: runtime::in_lanes(members, Parameters::prepared_2),
                prepared_3: runtime::in_lanes(members, Parameters::prepared_3),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("mass", &[], &single.mass),
                    runtime::not_finite("1 - mass", &[], &single.prepared_1),
                    runtime::not_finite("mass / 2", &[], &single.prepared_2),
                    runtime::not_finite("(1 - mass) / 2", &[], &single.prepared_3),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.mass);
            digest.add(&single.prepared_1);
            digest.add(&single.prepared_2);
            digest.add(&single.prepared_3);
        }
    }
    /// The equations of motion, derived from `hamiltonian`:
    ///
    /// ```text
    /// dq[0]/dt = q[1] + p[0]
    /// dq[1]/dt = p[1] - q[0]
    /// dp[0]/dt = p[1] - mass (q[0] + mass - 1) / s^3 - (1 - mass) (q[0] + mass) / r^3
    /// dp[1]/dt = -p[0] - q[1] (mass / s^3 + (1 - mass) / r^3)
    /// where r = sqrt((q[0] + mass)^2 + q[1]^2)
    /// where s = sqrt(q[1]^2 + (q[0] + mass - 1)^2)
    /// ```
    ///
    /// Each part has an exact flow.
    #[automatically_derived]
    impl runtime::Hamiltonian for RestrictedThreeBody {
        type Compose = Aba864;
        const EQUATIONS: &'static [&'static str] = &[
            "quadratic = (p[0]^2 + p[1]^2) / 2 + q[1] p[0] - q[0] p[1]",
            "rest = -(1 - mass) / sqrt((q[0] + mass)^2 + q[1]^2) - mass / sqrt(q[1]^2 + (q[0] + mass - 1)^2)",
            "dq[0]/dt = q[1] + p[0]",
            "dq[1]/dt = p[1] - q[0]",
            "dp[0]/dt = p[1] - mass (q[0] + mass - 1) / s^3 - (1 - mass) (q[0] + mass) / r^3",
            "dp[1]/dt = -p[0] - q[1] (mass / s^3 + (1 - mass) / r^3)",
            "where r = sqrt((q[0] + mass)^2 + q[1]^2)",
            "where s = sqrt(q[1]^2 + (q[0] + mass - 1)^2)",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_two_parts_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for RestrictedThreeBody {
        type Coords = [f64; 2];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Solving<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
            runtime::Quadratic<Scalar, 0, false>,
        >;
        const PARTS: &'static [&'static str] = &["quadratic", "rest"];
        const SEPARABLE: bool = false;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 14705761833495096216;
        const WIDE: bool = true;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                mass: self.mass,
                prepared_1: (1.0 - self.mass),
                prepared_2: 0.5 * self.mass,
                prepared_3: 0.5 * (1.0 - self.mass),
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let solver = &mut motion.solvers;
            solver
                .flow::<
                    runtime::Shaped<Self, Leaf>,
                >(duration, &mut motion.q, &mut motion.p);
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
            let shared_0 = q0 + motion.parameters.mass;
            let shared_1 = motion.parameters.mass + (q0 + Scalar::of(-1.0));
            let shared_2 = q1.square();
            let shared_3 = shared_0.square_add(shared_2);
            let shared_4 = shared_1.square_add(shared_2);
            let shared_5 = Scalar::of(1.0).div_pow_3_2(shared_4);
            let shared_6 = Scalar::of(1.0).div_pow_3_2(shared_3);
            motion
                .p[0]
                .scale_add(
                    step,
                    motion
                        .parameters
                        .prepared_1
                        .scale(shared_6)
                        .fma(shared_0, motion.parameters.mass.scale(shared_5) * shared_1),
                );
            motion
                .p[1]
                .fma(
                    (step * Scalar::of(2.0)).scale(q1),
                    motion
                        .parameters
                        .prepared_3
                        .scale_add(
                            shared_6,
                            motion.parameters.prepared_2.scale(shared_5),
                        ),
                );
        }
        #[inline(always)]
        fn along_field<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
            moved: runtime::MovedBy<'_, Self, Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            let shared_0 = q0 + motion.parameters.mass;
            let shared_1 = motion.parameters.mass + (q0 + Scalar::of(-1.0));
            let shared_2 = q1.square();
            let shared_3 = shared_0.square_add(shared_2);
            let shared_4 = shared_1.square_add(shared_2);
            let shared_5 = Scalar::of(1.0).div_pow_3_2(shared_4);
            let shared_6 = Scalar::of(1.0).div_pow_3_2(shared_3);
            moved
                .p[0]
                .scale_add(
                    -step,
                    motion
                        .parameters
                        .prepared_1
                        .scale(shared_6)
                        .fma(shared_0, motion.parameters.mass.scale(shared_5) * shared_1)
                        - p1,
                );
            moved
                .p[1]
                .scale_add(
                    -step,
                    Scalar::of(2.0)
                        .scale(q1)
                        .fma(
                            motion
                                .parameters
                                .prepared_3
                                .scale_add(
                                    shared_6,
                                    motion.parameters.prepared_2.scale(shared_5),
                                ),
                            p0,
                        ),
                );
            moved.q[0].scale_add(step, q1 + p0);
            moved.q[1].scale_add(step, p1 - q0);
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            (-motion.q[0].value())
                .fma(
                    p1,
                    motion
                        .q[1]
                        .value()
                        .fma(p0, Scalar::of(0.5).scale(p1.square_add(p0.square()))),
                )
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            let shared_0 = q0 + motion.parameters.mass;
            let shared_1 = motion.parameters.mass + (q0 + Scalar::of(-1.0));
            let shared_2 = q1.square();
            -(motion.parameters.prepared_1 / shared_0.square_add(shared_2).sqrt()
                + motion.parameters.mass / shared_1.square_add(shared_2).sqrt())
        }
        fn stated(
            &self,
            q: &Self::Coords,
            p: &Self::Coords,
            time: f64,
        ) -> runtime::StatedEnergy {
            runtime::StatedEnergy::Whole(Self::hamiltonian(self, *q, *p))
        }
    }
    #[automatically_derived]
    impl runtime::QuadraticKinetic for RestrictedThreeBody {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = [Scalar::of(0.0); 2];
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            let shared_0 = q0 + motion.parameters.mass;
            let shared_1 = motion.parameters.mass + (q0 + Scalar::of(-1.0));
            let shared_2 = q1.square();
            let shared_3 = motion.parameters.prepared_1.scale(p0);
            let shared_4 = shared_3
                .fma(shared_0, motion.parameters.prepared_1.scale(q1) * p1);
            let shared_5 = motion.parameters.mass.scale(p0);
            let shared_6 = shared_5.fma(shared_1, motion.parameters.mass.scale(q1) * p1);
            let shared_7 = Scalar::of(1.0) / shared_1.square_add(shared_2);
            let shared_8 = shared_7.sqrt();
            let shared_9 = shared_7 * shared_8;
            let shared_10 = Scalar::of(1.0) / shared_0.square_add(shared_2);
            let shared_11 = shared_10.sqrt();
            let shared_12 = shared_10 * shared_11;
            let shared_13 = shared_10.square() * shared_11;
            let shared_14 = shared_7.square() * shared_8;
            gradient[0]
                += (-(Scalar::of(3.0).scale(shared_0) * shared_4))
                    .fma(
                        shared_13,
                        shared_3
                            .fma(
                                shared_12,
                                (-(Scalar::of(3.0).scale(shared_1) * shared_6))
                                    .fma(shared_14, shared_5 * shared_9),
                            ),
                    );
            gradient[1]
                += (-Scalar::of(2.0).scale(q1))
                    .fma(
                        Scalar::of(1.5)
                            .scale(shared_6)
                            .fma(shared_14, Scalar::of(1.5).scale(shared_4) * shared_13),
                        Scalar::of(2.0).scale(p1)
                            * motion
                                .parameters
                                .prepared_3
                                .scale_add(
                                    shared_12,
                                    motion.parameters.prepared_2.scale(shared_9),
                                ),
                    );
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
            ::core::mem::swap(&mut force.q, &mut force.p);
            bent.p = {
                let motion = &mut force;
                let mut gradient = [Scalar::of(0.0); 2];
                gradient[0] += motion.q[0].value();
                gradient[1] += motion.q[1].value();
                for (slot, gradient) in ::core::iter::zip(
                    motion.p.iter_mut(),
                    &gradient,
                ) {
                    (*slot) = *gradient;
                }
                force.p
            };
            <Self as runtime::QuadraticKinetic>::hessian::<Scalar>(&mut bent, time);
            motion.push(Scalar::of(-2.0 * gradient), &bent);
        }
    }
    impl runtime::QuadraticPart<0> for Parameters<f64> {
        fn derivatives(_parameters: &Self, _length: usize, form: &mut runtime::Form) {
            use runtime::Real as _;
            form.qp([0], [1], f64::of(-1.0));
            form.qp([1], [0], f64::of(1.0));
            form.pp([0], [0], f64::of(1.0));
            form.pp([1], [1], f64::of(1.0));
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for RestrictedThreeBody {}
};
