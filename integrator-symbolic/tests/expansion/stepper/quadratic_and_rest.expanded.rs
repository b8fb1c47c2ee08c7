#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `stiffness`
        prepared_0: Scalar,
        /// `2 lambda`
        prepared_1: Scalar,
        /// `lambda`
        lambda: Scalar,
        /// `stiffness / 2`
        prepared_3: Scalar,
    }
    impl Parameters<f64> {
        fn prepared_0(&self) -> &f64 {
            &self.prepared_0
        }
        fn prepared_1(&self) -> &f64 {
            &self.prepared_1
        }
        fn lambda(&self) -> &f64 {
            &self.lambda
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
                prepared_0: runtime::in_lanes(members, Parameters::prepared_0),
                prepared_1: runtime::in_lanes(members, Parameters::prepared_1),
                lambda: runtime::in_lanes(members, Parameters::lambda),
                prepared_3: runtime::in_lanes(members, Parameters::prepared_3),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("stiffness", &[], &single.prepared_0),
                    runtime::not_finite("2 lambda", &[], &single.prepared_1),
                    runtime::not_finite("lambda", &[], &single.lambda),
                    runtime::not_finite("stiffness / 2", &[], &single.prepared_3),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.prepared_0);
            digest.add(&single.prepared_1);
            digest.add(&single.lambda);
            digest.add(&single.prepared_3);
        }
    }
    /// The equations of motion, derived from `harmonic` and `anharmonic`:
    ///
    /// ```text
    /// dq[0]/dt = p[0]
    /// dq[1]/dt = p[1]
    /// dp[0]/dt = -q[0] (2 lambda q[1] + stiffness)
    /// dp[1]/dt = -stiffness q[1] + lambda q[1]^2 - lambda q[0]^2
    /// ```
    ///
    /// Each part has an exact flow.
    #[automatically_derived]
    impl runtime::Hamiltonian for HenonHeiles {
        type Compose = Aba864;
        const EQUATIONS: &'static [&'static str] = &[
            "harmonic = (p[0]^2 + p[1]^2) / 2 + stiffness (q[0]^2 + q[1]^2) / 2",
            "anharmonic = lambda q[1] (q[0]^2 - q[1]^2 / 3)",
            "dq[0]/dt = p[0]",
            "dq[1]/dt = p[1]",
            "dp[0]/dt = -q[0] (2 lambda q[1] + stiffness)",
            "dp[1]/dt = -stiffness q[1] + lambda q[1]^2 - lambda q[0]^2",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_two_parts_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for HenonHeiles {
        type Coords = [f64; 2];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Solving<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
            runtime::Quadratic<Scalar, 0, true>,
        >;
        const PARTS: &'static [&'static str] = &["harmonic", "anharmonic"];
        const SEPARABLE: bool = false;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 13861830976177082455;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: 2.0 * (0.5 * self.stiffness),
                prepared_1: 2.0 * self.lambda,
                lambda: self.lambda,
                prepared_3: 0.5 * self.stiffness,
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
            motion.p[0].fma((step * motion.parameters.prepared_1).scale(q1), q0);
            motion
                .p[1]
                .scale_add(
                    step,
                    motion
                        .parameters
                        .lambda
                        .scale_add(
                            q0.square(),
                            (-motion.parameters.lambda).scale(q1.square()),
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
            moved
                .p[0]
                .fma(
                    -(step * Scalar::of(2.0)).scale(q0),
                    motion.parameters.lambda.scale_add(q1, motion.parameters.prepared_3),
                );
            moved
                .p[1]
                .scale_add(
                    -step,
                    motion
                        .parameters
                        .prepared_0
                        .scale_add(
                            q1,
                            motion
                                .parameters
                                .lambda
                                .scale_add(
                                    q0.square(),
                                    (-motion.parameters.lambda).scale(q1.square()),
                                ),
                        ),
                );
            moved.q[0].scale_add(step, motion.p[0].value());
            moved.q[1].scale_add(step, motion.p[1].value());
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            motion
                .parameters
                .prepared_3
                .scale_add(
                    q1.square_add(q0.square()),
                    Scalar::of(0.5).scale(p1.square_add(p0.square())),
                )
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            motion
                .parameters
                .lambda
                .scale(
                    Scalar::of(-0.3333333333333333)
                        .scale_add(q1.square() * q1, q1 * q0.square()),
                )
        }
        fn stated(
            &self,
            q: &Self::Coords,
            p: &Self::Coords,
            time: f64,
        ) -> runtime::StatedEnergy {
            runtime::StatedEnergy::Separate {
                kinetic: Self::harmonic(self, *q, *p),
                potential: Self::anharmonic(self, *q),
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
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            let shared_0 = motion.parameters.prepared_1.scale(motion.q[1].value());
            let shared_1 = motion.parameters.prepared_1.scale(motion.q[0].value());
            gradient[0] += shared_1.fma(p1, shared_0 * p0);
            gradient[1] += (-shared_0).fma(p1, shared_1 * p0);
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
        fn derivatives(parameters: &Self, _length: usize, form: &mut runtime::Form) {
            use runtime::Real as _;
            form.qq([0], [0], parameters.prepared_0);
            form.qq([1], [1], parameters.prepared_0);
            form.pp([0], [0], f64::of(1.0));
            form.pp([1], [1], f64::of(1.0));
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for HenonHeiles {}
};
