#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `rate`
        rate: Scalar,
        /// `stiffness`
        prepared_1: Scalar,
        /// `stiffness / 2`
        prepared_2: Scalar,
    }
    impl Parameters<f64> {
        fn rate(&self) -> &f64 {
            &self.rate
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
                rate: runtime::in_lanes(members, Parameters::rate),
                prepared_1: runtime::in_lanes(members, Parameters::prepared_1),
                prepared_2: runtime::in_lanes(members, Parameters::prepared_2),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("rate", &[], &single.rate),
                    runtime::not_finite("stiffness", &[], &single.prepared_1),
                    runtime::not_finite("stiffness / 2", &[], &single.prepared_2),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.rate);
            digest.add(&single.prepared_1);
            digest.add(&single.prepared_2);
        }
    }
    /// The equations of motion, derived from `twist` and `potential`:
    ///
    /// ```text
    /// dq[1]/dt = p[1] (1 + 2 rate sin(q[0]))
    /// dp[0]/dt = -stiffness q[0] - rate p[1]^2 cos(q[0])
    /// dp[1]/dt = -stiffness q[1]
    /// ```
    ///
    /// Each part has an exact flow.
    #[automatically_derived]
    impl runtime::Hamiltonian for Twist {
        type Compose = Yoshida4;
        const EQUATIONS: &'static [&'static str] = &[
            "twist = rate p[1]^2 sin(q[0]) + p[1]^2 / 2",
            "potential = stiffness (q[0]^2 + q[1]^2) / 2",
            "dq[1]/dt = p[1] (1 + 2 rate sin(q[0]))",
            "dp[0]/dt = -stiffness q[0] - rate p[1]^2 cos(q[0])",
            "dp[1]/dt = -stiffness q[1]",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_two_parts(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Twist {
        type Coords = [f64; 2];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const PARTS: &'static [&'static str] = &["twist", "potential"];
        const SEPARABLE: bool = false;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 12074394202590048555;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                rate: self.rate,
                prepared_1: 2.0 * (0.5 * self.stiffness),
                prepared_2: 0.5 * self.stiffness,
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            let q0 = motion.q[0].value();
            let (shared_0, shared_1) = q0.sin_cos();
            let p1 = motion.p[1].value();
            motion
                .p[0]
                .fma(-(step * motion.parameters.rate).scale(p1.square()), shared_1);
            motion
                .q[1]
                .fma(
                    (step * Scalar::of(2.0)).scale(p1),
                    motion.parameters.rate.scale_add(shared_0, Scalar::of(0.5)),
                );
        }
        #[inline(always)]
        fn kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            let shared_0 = step * motion.parameters.prepared_1;
            motion.p[0].scale_add(shared_0, motion.q[0].value());
            motion.p[1].scale_add(shared_0, motion.q[1].value());
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
            let (shared_0, shared_1) = q0.sin_cos();
            let p1 = motion.p[1].value();
            moved
                .p[0]
                .scale_add(
                    -step,
                    motion
                        .parameters
                        .rate
                        .scale(p1.square())
                        .fma(shared_1, motion.parameters.prepared_1.scale(q0)),
                );
            moved
                .p[1]
                .scale_add(-(step * motion.parameters.prepared_1), motion.q[1].value());
            moved
                .q[1]
                .fma(
                    (step * Scalar::of(2.0)).scale(p1),
                    motion.parameters.rate.scale_add(shared_0, Scalar::of(0.5)),
                );
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let p1 = motion.p[1].value();
            let shared_0 = p1.square();
            Scalar::of(0.5)
                .scale_add(
                    shared_0,
                    motion.parameters.rate.scale(motion.q[0].value().sin()) * shared_0,
                )
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            motion.parameters.prepared_2.scale(q1.square_add(q0.square()))
        }
        fn stated(
            &self,
            q: &Self::Coords,
            p: &Self::Coords,
            time: f64,
        ) -> runtime::StatedEnergy {
            runtime::StatedEnergy::Separate {
                kinetic: Self::twist(self, *q, *p),
                potential: Self::potential(self, *q),
            }
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Twist {}
};
