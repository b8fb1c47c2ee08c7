#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `amplitude`
        amplitude: Scalar,
        /// `omega`
        omega: Scalar,
    }
    impl Parameters<f64> {
        fn amplitude(&self) -> &f64 {
            &self.amplitude
        }
        fn omega(&self) -> &f64 {
            &self.omega
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                amplitude: runtime::in_lanes(members, Parameters::amplitude),
                omega: runtime::in_lanes(members, Parameters::omega),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("amplitude", &[], &single.amplitude),
                    runtime::not_finite("omega", &[], &single.omega),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.amplitude);
            digest.add(&single.omega);
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[0]/dt = p[0] / sqrt(1 + p[0]^2)
    /// dp[0]/dt = -q[0] + amplitude cos(omega t)
    /// ```
    ///
    /// `T` is not quadratic in the momenta with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for Driven {
        type Compose = runtime::Verlet;
        const EQUATIONS: &'static [&'static str] = &[
            "T = sqrt(1 + p[0]^2)",
            "V = -amplitude q[0] cos(omega t) + q[0]^2 / 2",
            "dq[0]/dt = p[0] / sqrt(1 + p[0]^2)",
            "dp[0]/dt = -q[0] + amplitude cos(omega t)",
        ];
    }
    #[automatically_derived]
    impl runtime::System for Driven {
        type Coords = [f64; 1];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const AUTONOMOUS: bool = false;
        const FINGERPRINT: u64 = 709413572954614763;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                amplitude: self.amplitude,
                omega: self.omega,
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            let p0 = motion.p[0].value();
            motion.q[0].add(step.scale(p0) / p0.square_add(Scalar::of(1.0)).sqrt());
        }
        #[inline(always)]
        fn kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            time: f64,
        ) {
            let time = Scalar::of(time);
            let step = Scalar::of(-duration);
            motion
                .p[0]
                .scale_add(
                    step,
                    (-motion.parameters.amplitude)
                        .scale_add(
                            motion.parameters.omega.scale(time).cos(),
                            motion.q[0].value(),
                        ),
                );
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let p0 = motion.p[0].value();
            p0.square_add(Scalar::of(1.0)).sqrt()
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            time: f64,
        ) -> Scalar {
            let time = Scalar::of(time);
            let q0 = motion.q[0].value();
            (-motion.parameters.amplitude.scale(q0))
                .fma(
                    motion.parameters.omega.scale(time).cos(),
                    Scalar::of(0.5).scale(q0.square()),
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
                potential: Self::potential(self, *q, time),
            }
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Driven {}
};
