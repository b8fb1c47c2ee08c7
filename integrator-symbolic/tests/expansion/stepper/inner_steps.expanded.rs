#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    const _: () = runtime::admits_nested::<Yoshida4>();
    const _: () = runtime::admits_nested::<runtime::Verlet>();
    const _: () = runtime::admits_inner::<BlanesMoan4>(2);
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `depth`
        depth: Scalar,
        /// `stiffness`
        prepared_1: Scalar,
        /// The number of inner steps.
        inner_steps: usize,
        /// The number of inner steps.
        inner_steps_2: usize,
        /// `stiffness / 2`
        prepared_4: Scalar,
    }
    impl Parameters<f64> {
        fn depth(&self) -> &f64 {
            &self.depth
        }
        fn prepared_1(&self) -> &f64 {
            &self.prepared_1
        }
        fn prepared_4(&self) -> &f64 {
            &self.prepared_4
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                depth: runtime::in_lanes(members, Parameters::depth),
                prepared_1: runtime::in_lanes(members, Parameters::prepared_1),
                inner_steps: ::core::clone::Clone::clone(&members[0].inner_steps),
                inner_steps_2: ::core::clone::Clone::clone(&members[0].inner_steps_2),
                prepared_4: runtime::in_lanes(members, Parameters::prepared_4),
            }
        }
        #[inline]
        fn alike(a: &Self::Single, b: &Self::Single) -> bool {
            a.inner_steps == b.inner_steps && a.inner_steps_2 == b.inner_steps_2
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("depth", &[], &single.depth),
                    runtime::not_finite("stiffness", &[], &single.prepared_1),
                    runtime::not_finite("stiffness / 2", &[], &single.prepared_4),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.depth);
            digest.add(&single.prepared_1);
            digest.add(&single.inner_steps);
            digest.add(&single.inner_steps_2);
            digest.add(&single.prepared_4);
        }
    }
    /// The equations of motion, derived from `far`, `near`, `bonds` and `kinetic`:
    ///
    /// ```text
    /// dq[0]/dt = p[0]
    /// dp[0]/dt = -stiffness q[0] - 4 q[0]^3 + depth sin(q[0])
    /// ```
    ///
    /// Each part has an exact flow. Those in parentheses are one part of a composition, which takes inner steps.
    #[automatically_derived]
    impl runtime::Hamiltonian for Nested {
        type Compose = Yoshida4;
        const EQUATIONS: &'static [&'static str] = &[
            "far = depth cos(q[0])",
            "near = q[0]^4",
            "bonds = stiffness q[0]^2 / 2",
            "kinetic = p[0]^2 / 2",
            "dq[0]/dt = p[0]",
            "dp[0]/dt = -stiffness q[0] - 4 q[0]^3 + depth sin(q[0])",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_nested(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Nested {
        type Coords = [f64; 1];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const PARTS: &'static [&'static str] = &["far", "near", "bonds", "kinetic"];
        const SEPARABLE: bool = false;
        const NESTED: &'static [runtime::InnerSteps] = &[
            runtime::InnerSteps::of::<runtime::Verlet>(2, &["near", "bonds", "kinetic"]),
            runtime::InnerSteps::of::<BlanesMoan4>(8, &["bonds", "kinetic"]),
        ];
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 14634394044610115344;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                depth: self.depth,
                prepared_1: 2.0 * (0.5 * self.stiffness),
                inner_steps: 2,
                inner_steps_2: 8,
                prepared_4: 0.5 * self.stiffness,
            }
        }
        fn set_inner_steps(parameters: &mut Self::Parameters<f64>, steps: usize) {
            parameters.inner_steps = steps;
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            motion
                .p[0]
                .scale_add(-(step * motion.parameters.depth), motion.q[0].value().sin());
        }
        #[inline(always)]
        fn middle<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            time: f64,
            backwards: bool,
        ) {
            if backwards {
                <Self as runtime::Nested<
                    1,
                >>::inner_middle::<Scalar, Leaf>(motion, duration, time, true);
                <Self as runtime::Nested<
                    1,
                >>::inner_drift::<Scalar, Leaf>(motion, duration, time);
                <Self as runtime::Nested<
                    0,
                >>::inner_drift::<Scalar, Leaf>(motion, duration, time);
            } else {
                <Self as runtime::Nested<
                    0,
                >>::inner_drift::<Scalar, Leaf>(motion, duration, time);
                <Self as runtime::Nested<
                    1,
                >>::inner_drift::<Scalar, Leaf>(motion, duration, time);
                <Self as runtime::Nested<
                    1,
                >>::inner_middle::<Scalar, Leaf>(motion, duration, time, false);
            }
        }
        #[inline(always)]
        fn last<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            time: f64,
        ) {
            <Self as runtime::Nested<
                1,
            >>::inner_kick::<Scalar, Leaf>(motion, duration, time);
        }
        #[inline(always)]
        fn kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            time: f64,
        ) {
            runtime::inner_steps::<
                Self,
                0,
                Scalar,
                Leaf,
                1,
            >(::core::array::from_mut(motion), duration, time);
        }
        #[inline(always)]
        fn kick_together<
            Scalar: runtime::Real,
            Leaf: runtime::Precision,
            const MOTIONS: usize,
        >(
            motions: &mut [Self::Motion<Scalar, Leaf>; MOTIONS],
            duration: f64,
            time: f64,
        ) {
            runtime::inner_steps::<
                Self,
                0,
                Scalar,
                Leaf,
                MOTIONS,
            >(motions, duration, time);
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
            moved
                .p[0]
                .scale_add(
                    -step,
                    (-motion.parameters.depth)
                        .scale_add(
                            q0.sin(),
                            Scalar::of(4.0)
                                .scale_add(
                                    q0.square() * q0,
                                    motion.parameters.prepared_1.scale(q0),
                                ),
                        ),
                );
            moved.q[0].scale_add(step, motion.p[0].value());
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            motion.parameters.depth.scale(motion.q[0].value().cos())
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            let p0 = motion.p[0].value();
            let shared_0 = q0.square();
            Scalar::of(0.5)
                .scale_add(
                    p0.square(),
                    motion.parameters.prepared_4.scale(q0).fma(q0, shared_0.square()),
                )
        }
        fn stated(
            &self,
            q: &Self::Coords,
            p: &Self::Coords,
            time: f64,
        ) -> runtime::StatedEnergy {
            runtime::StatedEnergy::Separate {
                kinetic: Self::far(self, *q),
                potential: Self::near(self, *q) + Self::bonds(self, *q)
                    + Self::kinetic(self, *p),
            }
        }
    }
    #[automatically_derived]
    impl runtime::Nested<0> for Nested {
        type Inner = runtime::Verlet;
        #[inline(always)]
        fn steps<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
        ) -> usize {
            motion.parameters.inner_steps
        }
        #[inline(always)]
        fn inner_drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            let q0 = motion.q[0].value();
            motion.p[0].scale_add(step * Scalar::of(4.0), q0.square() * q0);
        }
        #[inline(always)]
        fn inner_kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            time: f64,
        ) {
            runtime::inner_steps::<
                Self,
                1,
                Scalar,
                Leaf,
                1,
            >(::core::array::from_mut(motion), duration, time);
        }
        #[inline(always)]
        fn inner_kick_together<
            Scalar: runtime::Real,
            Leaf: runtime::Precision,
            const MOTIONS: usize,
        >(
            motions: &mut [Self::Motion<Scalar, Leaf>; MOTIONS],
            duration: f64,
            time: f64,
        ) {
            runtime::inner_steps::<
                Self,
                1,
                Scalar,
                Leaf,
                MOTIONS,
            >(motions, duration, time);
        }
    }
    #[automatically_derived]
    impl runtime::Nested<1> for Nested {
        type Inner = BlanesMoan4;
        #[inline(always)]
        fn steps<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
        ) -> usize {
            motion.parameters.inner_steps_2
        }
        #[inline(always)]
        fn inner_drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            motion
                .p[0]
                .scale_add(step * motion.parameters.prepared_1, motion.q[0].value());
        }
        #[inline(always)]
        fn inner_kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            motion.q[0].scale_add(step, motion.p[0].value());
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Nested {}
};
