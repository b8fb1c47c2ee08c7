#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    const _: () = runtime::admits::<Yoshida4>(3usize);
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `coupling`
        coupling: Scalar,
        /// `depth`
        depth: Scalar,
    }
    impl Parameters<f64> {
        fn coupling(&self) -> &f64 {
            &self.coupling
        }
        fn depth(&self) -> &f64 {
            &self.depth
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                coupling: runtime::in_lanes(members, Parameters::coupling),
                depth: runtime::in_lanes(members, Parameters::depth),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("coupling", &[], &single.coupling),
                    runtime::not_finite("depth", &[], &single.depth),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.coupling);
            digest.add(&single.depth);
        }
    }
    /// The equations of motion, derived from `hamiltonian`:
    ///
    /// ```text
    /// dq[0]/dt = p[0] (q[0]^2 + depth)
    /// dq[1]/dt = p[1]
    /// dp[0]/dt = -q[0] (1 + p[0]^2)
    /// dp[1]/dt = -sin(q[1])
    /// ```
    ///
    /// Two copies of the state are coupled, each of which moves by what H says of the other.
    #[automatically_derived]
    impl runtime::Hamiltonian for Mixed {
        type Compose = Yoshida4;
        const EQUATIONS: &'static [&'static str] = &[
            "H = p[1]^2 / 2 + (q[0]^2 + depth) (1 + p[0]^2) / 2 - cos(q[1])",
            "dq[0]/dt = p[0] (q[0]^2 + depth)",
            "dq[1]/dt = p[1]",
            "dp[0]/dt = -q[0] (1 + p[0]^2)",
            "dp[1]/dt = -sin(q[1])",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_many_parts(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Mixed {
        type Coords = [f64; 2];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Doubled<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const PARTS: &'static [&'static str] = &[
            "hamiltonian",
            "hamiltonian of the copy",
            "coupling",
        ];
        const SEPARABLE: bool = false;
        const COPIES: bool = true;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 5147515971429084762;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                coupling: self.coupling,
                depth: self.depth,
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let (read, moved) = motion.first();
            Self::along_field::<_, Leaf>(read, moved, duration, 0.0);
        }
        #[inline(always)]
        fn middle<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
            _backwards: bool,
        ) {
            let (read, moved) = motion.second();
            Self::along_field::<_, Leaf>(read, moved, duration, 0.0);
        }
        #[inline(always)]
        fn kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let coupling = motion.parameters.coupling;
            motion.rotate(coupling, duration);
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
            let p0 = motion.p[0].value();
            moved.p[0].fma(-step.scale(q0), p0.square_add(Scalar::of(1.0)));
            moved.p[1].scale_add(-step, motion.q[1].value().sin());
            moved.q[0].fma(step.scale(q0.square_add(motion.parameters.depth)), p0);
            moved.q[1].scale_add(step, motion.p[1].value());
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            let p0 = motion.p[0].value();
            let p1 = motion.p[1].value();
            Scalar::of(0.5)
                .scale_add(
                    p1.square(),
                    Scalar::of(0.5).scale(q0.square_add(motion.parameters.depth))
                        * p0.square_add(Scalar::of(1.0)),
                ) - motion.q[1].value().cos()
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
    impl runtime::ParameterDerivatives for Mixed {}
};
