#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    const _: fn() = || {
        fn takes_whole<Method: runtime::TakesWhole>() {}
        takes_whole::<GaussLegendre<8>>();
    };
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `2 mass`
        prepared_0: Scalar,
    }
    impl Parameters<f64> {
        fn prepared_0(&self) -> &f64 {
            &self.prepared_0
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                prepared_0: runtime::in_lanes(members, Parameters::prepared_0),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [runtime::not_finite("2 mass", &[], &single.prepared_0)],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.prepared_0);
        }
    }
    /// The equations of motion, derived from `hamiltonian`:
    ///
    /// ```text
    /// dq[0]/dt = -p[0] / (1 - 2 mass / q[1])
    /// dq[1]/dt = p[1] (1 - 2 mass / q[1])
    /// dq[2]/dt = p[2] / q[1]^2
    /// dp[1]/dt = p[2]^2 / q[1]^3 - mass (p[0]^2 / (1 - 2 mass / q[1])^2 + p[1]^2) / q[1]^2
    /// ```
    ///
    /// H is in one piece, for methods that take the whole of its field.
    #[automatically_derived]
    impl runtime::Hamiltonian for Geodesic {
        type Compose = GaussLegendre<8>;
        const EQUATIONS: &'static [&'static str] = &[
            "H = (p[1]^2 (1 - 2 mass / q[1]) - p[0]^2 / (1 - 2 mass / q[1]) + p[2]^2 / q[1]^2) / 2",
            "dq[0]/dt = -p[0] / (1 - 2 mass / q[1])",
            "dq[1]/dt = p[1] (1 - 2 mass / q[1])",
            "dq[2]/dt = p[2] / q[1]^2",
            "dp[1]/dt = p[2]^2 / q[1]^3 - mass (p[0]^2 / (1 - 2 mass / q[1])^2 + p[1]^2) / q[1]^2",
        ];
        fn visit_compositions(_visitor: &mut impl runtime::Visitor<Self>) {}
    }
    #[automatically_derived]
    impl runtime::System for Geodesic {
        type Coords = [f64; 3];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const PARTS: &'static [&'static str] = &[];
        const SEPARABLE: bool = false;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 7926376877099657028;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: 2.0 * self.mass,
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            _motion: &mut Self::Motion<Scalar, Leaf>,
            _duration: f64,
            _time: f64,
        ) {}
        #[inline(always)]
        fn kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            _motion: &mut Self::Motion<Scalar, Leaf>,
            _duration: f64,
            _time: f64,
        ) {}
        #[inline(always)]
        fn along_field<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
            moved: runtime::MovedBy<'_, Self, Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            let p2 = motion.p[2].value();
            let shared_0 = Scalar::of(1.0) / motion.q[1].value();
            let shared_1 = (-motion.parameters.prepared_0)
                .scale_add(shared_0, Scalar::of(1.0));
            let shared_2 = shared_0.square();
            let shared_3 = Scalar::of(1.0) / shared_1;
            moved
                .p[1]
                .scale_add(
                    -step,
                    (-p2.square())
                        .fma(
                            shared_2 * shared_0,
                            motion
                                .parameters
                                .prepared_0
                                .scale(
                                    Scalar::of(0.5)
                                        .scale_add(
                                            p1.square(),
                                            Scalar::of(0.5).scale(p0.square()) * shared_3.square(),
                                        ),
                                ) * shared_2,
                        ),
                );
            moved.q[0].fma(-step.scale(p0), shared_3);
            moved.q[1].fma(step.scale(p1), shared_1);
            moved.q[2].fma(step.scale(p2), shared_2);
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            let p2 = motion.p[2].value();
            let shared_0 = Scalar::of(1.0) / motion.q[1].value();
            let shared_1 = (-motion.parameters.prepared_0)
                .scale_add(shared_0, Scalar::of(1.0));
            Scalar::of(0.5)
                .scale(
                    p2.square().fma(shared_0.square(), p1 * shared_1 * p1)
                        - p0.square() / shared_1,
                )
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            _motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            Scalar::of(0.0)
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
    impl runtime::RatedField for Geodesic {
        #[inline(always)]
        fn energy_at<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
        ) -> Scalar {
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            let p2 = motion.p[2].value();
            let shared_0 = Scalar::of(1.0) / motion.q[1].value();
            let shared_1 = (-motion.parameters.prepared_0)
                .scale_add(shared_0, Scalar::of(1.0));
            Scalar::of(0.5)
                .scale(
                    p2.square().fma(shared_0.square(), p1 * shared_1 * p1)
                        - p0.square() / shared_1,
                )
        }
        #[inline(always)]
        fn rate_at<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
        ) -> Scalar {
            let q1 = motion.q[1].value();
            Scalar::of(1.0).div_pow_3_2(q1)
        }
        fn stated_rate(&self, q: &Self::Coords) -> f64 {
            Self::rate(self, *q)
        }
        #[inline(always)]
        fn along_rated_field<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
            moved: runtime::MovedBy<'_, Self, Scalar, Leaf>,
            conjugate: Scalar,
        ) {
            let (step, time) = (Scalar::of(1.0), conjugate);
            let q1 = motion.q[1].value();
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            let p2 = motion.p[2].value();
            let shared_0 = q1.sqrt();
            let shared_1 = Scalar::of(1.0) / q1;
            let shared_2 = (-motion.parameters.prepared_0)
                .scale_add(shared_1, Scalar::of(1.0));
            let shared_3 = p2.square();
            let shared_4 = shared_1.square();
            let shared_5 = p0.square();
            let shared_6 = Scalar::of(1.0) / shared_2;
            let shared_7 = p1.square();
            let shared_8 = q1 * shared_0;
            moved
                .p[1]
                .scale_add(
                    -step,
                    motion
                        .parameters
                        .prepared_0
                        .scale(shared_4)
                        .fma(
                            Scalar::of(0.5)
                                .scale(shared_8)
                                .fma(
                                    shared_7,
                                    Scalar::of(0.5).scale(shared_5) * shared_8
                                        * shared_6.square(),
                                ),
                            (-(shared_3 * shared_8))
                                .fma(
                                    shared_4 * shared_1,
                                    Scalar::of(1.5).scale(shared_0)
                                        * Scalar::of(0.5)
                                            .scale_add(
                                                (-shared_5)
                                                    .fma(shared_6, shared_2.fma(shared_7, shared_3 * shared_4)),
                                                time,
                                            ),
                                ),
                        ),
                );
            moved.q[0].fma(-(step.scale(p0) * shared_6), shared_8);
            moved.q[1].fma(step.scale(p1) * shared_2, shared_8);
            moved.q[2].fma(step.scale(p2) * shared_4, shared_8);
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Geodesic {}
};
