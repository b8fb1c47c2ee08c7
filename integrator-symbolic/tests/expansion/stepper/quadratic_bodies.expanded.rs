#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `rate`
        rate: Scalar,
        /// `PUSH`
        prepared_1: Scalar,
        /// `1 / mass[i]`
        prepared_2: runtime::SharedTable<Scalar>,
        prepared_3: usize,
        /// `1 / (2 mass[i])`
        prepared_4: runtime::SharedTable<Scalar>,
    }
    impl Parameters<f64> {
        fn rate(&self) -> &f64 {
            &self.rate
        }
        fn prepared_1(&self) -> &f64 {
            &self.prepared_1
        }
        fn prepared_2(&self) -> &runtime::SharedTable<f64> {
            &self.prepared_2
        }
        fn prepared_4(&self) -> &runtime::SharedTable<f64> {
            &self.prepared_4
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                rate: runtime::in_lanes(members, Parameters::rate),
                prepared_1: runtime::in_lanes(members, Parameters::prepared_1),
                prepared_2: runtime::in_lanes(members, Parameters::prepared_2),
                prepared_3: ::core::clone::Clone::clone(&members[0].prepared_3),
                prepared_4: runtime::in_lanes(members, Parameters::prepared_4),
            }
        }
        #[inline]
        fn alike(a: &Self::Single, b: &Self::Single) -> bool {
            a.prepared_2.len() == b.prepared_2.len() && a.prepared_3 == b.prepared_3
                && a.prepared_4.len() == b.prepared_4.len()
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("rate", &[], &single.rate),
                    runtime::not_finite("PUSH", &[], &single.prepared_1),
                    runtime::not_finite("1 / mass[i]", &["i"], &single.prepared_2),
                    runtime::not_finite("1 / (2 mass[i])", &["i"], &single.prepared_4),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.rate);
            digest.add(&single.prepared_1);
            digest.add(&single.prepared_2);
            digest.add(&single.prepared_3);
            digest.add(&single.prepared_4);
        }
    }
    /// The equations of motion, derived from `turning` and `potential`:
    ///
    /// ```text
    /// dq[i][0]/dt = rate q[i][1] + p[i][0] / mass[i]   for i in 0..N
    /// dq[i][1]/dt = p[i][1] / mass[i] - rate q[i][0]   for i in 0..N
    /// dp[i][0]/dt = rate p[i][1] - 4 q[i][0] (q[i][0]^2 + q[i][1]^2) - PUSH   for i in 0..N
    /// dp[i][1]/dt = -rate p[i][0] - 4 q[i][1] (q[i][0]^2 + q[i][1]^2)   for i in 0..N
    /// ```
    ///
    /// Each part has an exact flow.
    #[automatically_derived]
    impl<const N: usize> runtime::Hamiltonian for Frame<N> {
        type Compose = Yoshida4;
        const EQUATIONS: &'static [&'static str] = &[
            "turning = Σ_{i in 0..N} (PUSH q[i][0] + (p[i][0]^2 + p[i][1]^2) / (2 mass[i]) + rate (q[i][1] p[i][0] - q[i][0] p[i][1]))",
            "potential = Σ_{i in 0..N} (q[i][0]^2 + q[i][1]^2)^2",
            "dq[i][0]/dt = rate q[i][1] + p[i][0] / mass[i]   for i in 0..N",
            "dq[i][1]/dt = p[i][1] / mass[i] - rate q[i][0]   for i in 0..N",
            "dp[i][0]/dt = rate p[i][1] - 4 q[i][0] (q[i][0]^2 + q[i][1]^2) - PUSH   for i in 0..N",
            "dp[i][1]/dt = -rate p[i][0] - 4 q[i][1] (q[i][0]^2 + q[i][1]^2)   for i in 0..N",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_two_parts_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl<const N: usize> runtime::System for Frame<N> {
        type Coords = [[f64; 2]; { N }];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Solving<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
            runtime::Quadratic<Scalar, 0, false>,
        >;
        const PARTS: &'static [&'static str] = &["turning", "potential"];
        const SEPARABLE: bool = false;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 84300288213867386;
        const LARGE_FLOWS: bool = true;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                rate: self.rate,
                prepared_1: Self::PUSH,
                prepared_2: runtime::table(N, &|i: usize| 2.0 / (2.0 * self.mass[i])),
                prepared_3: N,
                prepared_4: runtime::table(N, &|i: usize| 1.0 / (2.0 * self.mass[i])),
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
            let shared_0 = step * Scalar::of(4.0);
            for i in 0..N {
                let q_i_0 = motion.q[i][0].value();
                let q_i_1 = motion.q[i][1].value();
                let shared_1 = q_i_1.square_add(q_i_0.square());
                motion.p[i][0].fma(shared_0.scale(q_i_0), shared_1);
                motion.p[i][1].fma(shared_0.scale(q_i_1), shared_1);
            }
        }
        #[inline(always)]
        fn along_field<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
            moved: runtime::MovedBy<'_, Self, Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            for i in 0..N {
                let q_i_0 = motion.q[i][0].value();
                let q_i_1 = motion.q[i][1].value();
                let p_i_0 = motion.p[i][0].value();
                let p_i_1 = motion.p[i][1].value();
                let shared_0 = q_i_1.square_add(q_i_0.square());
                moved
                    .p[i][0]
                    .scale_add(
                        -step,
                        (-motion.parameters.rate)
                            .scale_add(
                                p_i_1,
                                Scalar::of(4.0)
                                    .scale(q_i_0)
                                    .fma(shared_0, Scalar::of(Self::PUSH)),
                            ),
                    );
                moved
                    .p[i][1]
                    .scale_add(
                        -step,
                        motion
                            .parameters
                            .rate
                            .scale_add(p_i_0, Scalar::of(4.0).scale(q_i_1) * shared_0),
                    );
                moved
                    .q[i][0]
                    .scale_add(
                        step,
                        motion
                            .parameters
                            .prepared_2[i]
                            .scale_add(p_i_0, motion.parameters.rate.scale(q_i_1)),
                    );
                moved
                    .q[i][1]
                    .scale_add(
                        step,
                        (-motion.parameters.rate)
                            .scale_add(
                                q_i_0,
                                motion.parameters.prepared_2[i].scale(p_i_1),
                            ),
                    );
            }
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let mut sum_0 = Scalar::of(0.0);
            for i in 0..N {
                let q_i_0 = motion.q[i][0].value();
                let p_i_0 = motion.p[i][0].value();
                let p_i_1 = motion.p[i][1].value();
                sum_0
                    += Scalar::of(Self::PUSH)
                        .scale_add(
                            q_i_0,
                            motion
                                .parameters
                                .rate
                                .scale_add(
                                    (-q_i_0).fma(p_i_1, motion.q[i][1].value() * p_i_0),
                                    motion
                                        .parameters
                                        .prepared_4[i]
                                        .scale(p_i_1.square_add(p_i_0.square())),
                                ),
                        );
            }
            sum_0
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let mut sum_0 = Scalar::of(0.0);
            for i in 0..N {
                let q_i_0 = motion.q[i][0].value();
                let q_i_1 = motion.q[i][1].value();
                let shared_0 = q_i_1.square_add(q_i_0.square());
                sum_0 = shared_0.square_add(sum_0);
            }
            sum_0
        }
        fn stated(
            &self,
            q: &Self::Coords,
            p: &Self::Coords,
            time: f64,
        ) -> runtime::StatedEnergy {
            runtime::StatedEnergy::Separate {
                kinetic: Self::turning(self, *q, *p),
                potential: Self::potential(self, *q),
            }
        }
    }
    #[automatically_derived]
    impl<const N: usize> runtime::QuadraticKinetic for Frame<N> {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = [[Scalar::of(0.0); 2]; N];
            for i in 0..N {
                let q_i_0 = motion.q[i][0].value();
                let q_i_1 = motion.q[i][1].value();
                let p_i_0 = motion.p[i][0].value();
                let p_i_1 = motion.p[i][1].value();
                let shared_0 = q_i_1.square_add(q_i_0.square());
                let shared_1 = Scalar::of(4.0)
                    .scale(q_i_1)
                    .fma(p_i_1, Scalar::of(4.0).scale(q_i_0) * p_i_0);
                gradient[i][0]
                    += Scalar::of(2.0)
                        .scale(q_i_0)
                        .fma(shared_1, Scalar::of(4.0).scale(p_i_0) * shared_0);
                gradient[i][1]
                    += Scalar::of(2.0)
                        .scale(q_i_1)
                        .fma(shared_1, Scalar::of(4.0).scale(p_i_1) * shared_0);
            }
            for (slot, gradient) in ::core::iter::zip(motion.p.iter_mut(), &gradient) {
                for (slot, gradient) in ::core::iter::zip(slot, gradient) {
                    (*slot) = *gradient;
                }
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
                let mut gradient = [[Scalar::of(0.0); 2]; N];
                for i in 0..N {
                    gradient[i][0] = motion
                        .parameters
                        .prepared_2[i]
                        .scale_add(motion.q[i][0].value(), gradient[i][0]);
                    gradient[i][1] = motion
                        .parameters
                        .prepared_2[i]
                        .scale_add(motion.q[i][1].value(), gradient[i][1]);
                }
                for (slot, gradient) in ::core::iter::zip(
                    motion.p.iter_mut(),
                    &gradient,
                ) {
                    for (slot, gradient) in ::core::iter::zip(slot, gradient) {
                        (*slot) = *gradient;
                    }
                }
                force.p
            };
            <Self as runtime::QuadraticKinetic>::hessian::<Scalar>(&mut bent, time);
            motion.push(Scalar::of(-2.0 * gradient), &bent);
        }
    }
    impl runtime::QuadraticPart<0> for Parameters<f64> {
        fn components(_parameters: &Self) -> usize {
            2
        }
        fn derivatives(parameters: &Self, _length: usize, form: &mut runtime::Form) {
            for i in 0..parameters.prepared_3 {
                form.qp([i, 0], [i, 1], -parameters.rate);
                form.q([i, 0], parameters.prepared_1);
                form.qp([i, 1], [i, 0], parameters.rate);
                form.pp([i, 0], [i, 0], parameters.prepared_2[i]);
                form.pp([i, 1], [i, 1], parameters.prepared_2[i]);
            }
        }
    }
    #[automatically_derived]
    impl<const N: usize> runtime::ParameterDerivatives for Frame<N> {}
};
