#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    const _: fn() = || {
        fn takes_whole<Method: runtime::TakesWhole>() {}
        takes_whole::<GaussLegendre4>();
    };
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `2 gravity`
        prepared_0: Scalar,
        /// `gravity`
        gravity: Scalar,
    }
    impl Parameters<f64> {
        fn prepared_0(&self) -> &f64 {
            &self.prepared_0
        }
        fn gravity(&self) -> &f64 {
            &self.gravity
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                prepared_0: runtime::in_lanes(members, Parameters::prepared_0),
                gravity: runtime::in_lanes(members, Parameters::gravity),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("2 gravity", &[], &single.prepared_0),
                    runtime::not_finite("gravity", &[], &single.gravity),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.prepared_0);
            digest.add(&single.gravity);
        }
    }
    /// The equations of motion, derived from `hamiltonian`:
    ///
    /// ```text
    /// dq[0]/dt = p[0] / r^2 - p[1] u1
    /// dq[1]/dt = 2 p[1] / r^2 - p[0] u1
    /// dp[0]/dt = -2 gravity sin(q[0]) - u2
    /// dp[1]/dt = u2 - gravity sin(q[1])
    /// where r = sqrt(1 + sin(q[0] - q[1])^2)
    /// where u1 = cos(q[0] - q[1]) / r^2
    /// where u2 = p[0] p[1] sin(q[0] - q[1]) / r^2 - sin(q[0] - q[1]) cos(q[0] - q[1]) (p[0]^2 + 2 p[1]^2 - 2 p[0] p[1] cos(q[0] - q[1])) / r^4
    /// ```
    ///
    /// H is in one piece, for methods that take the whole of its field.
    #[automatically_derived]
    impl runtime::Hamiltonian for DoublePendulum {
        type Compose = GaussLegendre4;
        const EQUATIONS: &'static [&'static str] = &[
            "H = (p[0]^2 / 2 + p[1]^2 - p[0] p[1] cos(q[0] - q[1])) / (1 + sin(q[0] - q[1])^2) - gravity (2 cos(q[0]) + cos(q[1]))",
            "dq[0]/dt = p[0] / r^2 - p[1] u1",
            "dq[1]/dt = 2 p[1] / r^2 - p[0] u1",
            "dp[0]/dt = -2 gravity sin(q[0]) - u2",
            "dp[1]/dt = u2 - gravity sin(q[1])",
            "where r = sqrt(1 + sin(q[0] - q[1])^2)",
            "where u1 = cos(q[0] - q[1]) / r^2",
            "where u2 = p[0] p[1] sin(q[0] - q[1]) / r^2 - sin(q[0] - q[1]) cos(q[0] - q[1]) (p[0]^2 + 2 p[1]^2 - 2 p[0] p[1] cos(q[0] - q[1])) / r^4",
        ];
        fn visit_compositions(_visitor: &mut impl runtime::Visitor<Self>) {}
    }
    #[automatically_derived]
    impl runtime::System for DoublePendulum {
        type Coords = [f64; 2];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const PARTS: &'static [&'static str] = &[];
        const SEPARABLE: bool = false;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 7359589503523027644;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: 2.0 * self.gravity,
                gravity: self.gravity,
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
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            let shared_0 = q0 - q1;
            let (shared_1, shared_2) = shared_0.sin_cos();
            let shared_3 = Scalar::of(1.0) / shared_1.square_add(Scalar::of(1.0));
            let shared_4 = shared_2 * shared_3;
            let shared_5 = (-((-(Scalar::of(2.0).scale(p0) * p1))
                .fma(shared_2, Scalar::of(2.0).scale_add(p1.square(), p0.square()))
                * shared_3.square() * shared_1))
                .fma(shared_2, p0 * p1 * shared_3 * shared_1);
            moved
                .p[0]
                .scale_add(
                    -step,
                    motion.parameters.prepared_0.scale_add(q0.sin(), shared_5),
                );
            moved
                .p[1]
                .scale_add(
                    -step,
                    motion.parameters.gravity.scale_add(q1.sin(), -shared_5),
                );
            moved.q[0].scale_add(step, (-shared_4).fma(p1, p0 * shared_3));
            moved
                .q[1]
                .scale_add(
                    step,
                    (-shared_4).fma(p0, Scalar::of(2.0).scale(p1) * shared_3),
                );
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
            let shared_0 = q0 - q1;
            let (shared_1, shared_2) = shared_0.sin_cos();
            (-motion.parameters.gravity)
                .scale_add(
                    Scalar::of(2.0).scale_add(q0.cos(), q1.cos()),
                    Scalar::of(0.5)
                        .scale(
                            (-(Scalar::of(2.0).scale(p0) * p1))
                                .fma(
                                    shared_2,
                                    Scalar::of(2.0).scale_add(p1.square(), p0.square()),
                                ),
                        ) / shared_1.square_add(Scalar::of(1.0)),
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
    impl runtime::ParameterDerivatives for DoublePendulum {}
};
