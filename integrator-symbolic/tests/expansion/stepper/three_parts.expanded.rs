#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    const _: () = runtime::admits::<Yoshida4>(3usize);
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `1 / mass`
        prepared_0: Scalar,
        /// `2 rate`
        prepared_1: Scalar,
        /// `rate`
        rate: Scalar,
        /// `depth`
        depth: Scalar,
        /// `stiffness`
        prepared_4: Scalar,
        /// `1 / (2 mass)`
        prepared_5: Scalar,
        /// `stiffness / 2`
        prepared_6: Scalar,
    }
    impl Parameters<f64> {
        fn prepared_0(&self) -> &f64 {
            &self.prepared_0
        }
        fn prepared_1(&self) -> &f64 {
            &self.prepared_1
        }
        fn rate(&self) -> &f64 {
            &self.rate
        }
        fn depth(&self) -> &f64 {
            &self.depth
        }
        fn prepared_4(&self) -> &f64 {
            &self.prepared_4
        }
        fn prepared_5(&self) -> &f64 {
            &self.prepared_5
        }
        fn prepared_6(&self) -> &f64 {
            &self.prepared_6
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                prepared_0: runtime::in_lanes(members, Parameters::prepared_0),
                prepared_1: runtime::in_lanes(members, Parameters::prepared_1),
                rate: runtime::in_lanes(members, Parameters::rate),
                depth: runtime::in_lanes(members, Parameters::depth),
                prepared_4: runtime::in_lanes(members, Parameters::prepared_4),
                prepared_5: runtime::in_lanes(members, Parameters::prepared_5),
                prepared_6: runtime::in_lanes(members, Parameters::prepared_6),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("1 / mass", &[], &single.prepared_0),
                    runtime::not_finite("2 rate", &[], &single.prepared_1),
                    runtime::not_finite("rate", &[], &single.rate),
                    runtime::not_finite("depth", &[], &single.depth),
                    runtime::not_finite("stiffness", &[], &single.prepared_4),
                    runtime::not_finite("1 / (2 mass)", &[], &single.prepared_5),
                    runtime::not_finite("stiffness / 2", &[], &single.prepared_6),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.prepared_0);
            digest.add(&single.prepared_1);
            digest.add(&single.rate);
            digest.add(&single.depth);
            digest.add(&single.prepared_4);
            digest.add(&single.prepared_5);
            digest.add(&single.prepared_6);
        }
    }
    /// The equations of motion, derived from `kinetic`, `twist` and `potential`:
    ///
    /// ```text
    /// dq[0]/dt = p[0] / mass
    /// dq[1]/dt = p[1] / mass + rate q[0]^2
    /// dp[0]/dt = -2 rate p[1] q[0] + depth sin(q[0])
    /// dp[1]/dt = -stiffness q[1]
    /// ```
    ///
    /// Each part has an exact flow.
    #[automatically_derived]
    impl runtime::Hamiltonian for Twisted {
        type Compose = Yoshida4;
        const EQUATIONS: &'static [&'static str] = &[
            "kinetic = (p[0]^2 + p[1]^2) / (2 mass)",
            "twist = rate q[0]^2 p[1]",
            "potential = stiffness q[1]^2 / 2 + depth cos(q[0])",
            "dq[0]/dt = p[0] / mass",
            "dq[1]/dt = p[1] / mass + rate q[0]^2",
            "dp[0]/dt = -2 rate p[1] q[0] + depth sin(q[0])",
            "dp[1]/dt = -stiffness q[1]",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_many_parts(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Twisted {
        type Coords = [f64; 2];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const PARTS: &'static [&'static str] = &["kinetic", "twist", "potential"];
        const SEPARABLE: bool = false;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 5653969787755138603;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: 2.0 / (2.0 * self.mass),
                prepared_1: 2.0 * self.rate,
                rate: self.rate,
                depth: self.depth,
                prepared_4: 2.0 * (0.5 * self.stiffness),
                prepared_5: 1.0 / (2.0 * self.mass),
                prepared_6: 0.5 * self.stiffness,
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            let shared_0 = step * motion.parameters.prepared_0;
            motion.q[0].scale_add(shared_0, motion.p[0].value());
            motion.q[1].scale_add(shared_0, motion.p[1].value());
        }
        #[inline(always)]
        fn middle<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
            _backwards: bool,
        ) {
            let step = Scalar::of(duration);
            let q0 = motion.q[0].value();
            motion
                .p[0]
                .fma(
                    -(step * motion.parameters.prepared_1).scale(motion.p[1].value()),
                    q0,
                );
            motion.q[1].fma((step * motion.parameters.rate).scale(q0), q0);
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
                .scale_add(-(step * motion.parameters.depth), motion.q[0].value().sin());
            motion
                .p[1]
                .scale_add(step * motion.parameters.prepared_4, motion.q[1].value());
        }
        #[inline(always)]
        fn along_field<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
            moved: runtime::MovedBy<'_, Self, Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            let p1 = motion.p[1].value();
            let q0 = motion.q[0].value();
            moved
                .p[0]
                .scale_add(
                    -step,
                    (-motion.parameters.depth)
                        .scale_add(q0.sin(), motion.parameters.prepared_1.scale(p1) * q0),
                );
            moved
                .p[1]
                .scale_add(-(step * motion.parameters.prepared_4), motion.q[1].value());
            moved
                .q[0]
                .scale_add(step * motion.parameters.prepared_0, motion.p[0].value());
            moved
                .q[1]
                .scale_add(
                    step,
                    motion
                        .parameters
                        .prepared_0
                        .scale_add(p1, motion.parameters.rate.scale(q0) * q0),
                );
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            motion.parameters.prepared_5.scale(p1.square_add(p0.square()))
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            (motion.parameters.rate.scale(q0) * q0)
                .fma(
                    motion.p[1].value(),
                    motion
                        .parameters
                        .prepared_6
                        .scale(q1)
                        .fma(q1, motion.parameters.depth.scale(q0.cos())),
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
                potential: Self::twist(self, *q, *p) + Self::potential(self, *q),
            }
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Twisted {}
};
