#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    const _: () = runtime::admits::<Yoshida4>(3usize);
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `number`
        number: Scalar,
        /// `field`
        field: Scalar,
        /// `field / number`
        prepared_2: Scalar,
        /// `1 / mass`
        prepared_3: Scalar,
        /// `charge`
        charge: Scalar,
        /// `charge / 3`
        prepared_5: Scalar,
        /// `charge / mass`
        prepared_6: Scalar,
        /// `number field / mass`
        prepared_7: Scalar,
        /// `field / mass`
        prepared_8: Scalar,
        /// `1 / (2 mass)`
        prepared_9: Scalar,
    }
    impl Parameters<f64> {
        fn number(&self) -> &f64 {
            &self.number
        }
        fn field(&self) -> &f64 {
            &self.field
        }
        fn prepared_2(&self) -> &f64 {
            &self.prepared_2
        }
        fn prepared_3(&self) -> &f64 {
            &self.prepared_3
        }
        fn charge(&self) -> &f64 {
            &self.charge
        }
        fn prepared_5(&self) -> &f64 {
            &self.prepared_5
        }
        fn prepared_6(&self) -> &f64 {
            &self.prepared_6
        }
        fn prepared_7(&self) -> &f64 {
            &self.prepared_7
        }
        fn prepared_8(&self) -> &f64 {
            &self.prepared_8
        }
        fn prepared_9(&self) -> &f64 {
            &self.prepared_9
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                number: runtime::in_lanes(members, Parameters::number),
                field: runtime::in_lanes(members, Parameters::field),
                prepared_2: runtime::in_lanes(members, Parameters::prepared_2),
                prepared_3: runtime::in_lanes(members, Parameters::prepared_3),
                charge: runtime::in_lanes(members, Parameters::charge),
                prepared_5: runtime::in_lanes(members, Parameters::prepared_5),
                prepared_6: runtime::in_lanes(members, Parameters::prepared_6),
                prepared_7: runtime::in_lanes(members, Parameters::prepared_7),
                prepared_8: runtime::in_lanes(members, Parameters::prepared_8),
                prepared_9: runtime::in_lanes(members, Parameters::prepared_9),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("number", &[], &single.number),
                    runtime::not_finite("field", &[], &single.field),
                    runtime::not_finite("field / number", &[], &single.prepared_2),
                    runtime::not_finite("1 / mass", &[], &single.prepared_3),
                    runtime::not_finite("charge", &[], &single.charge),
                    runtime::not_finite("charge / 3", &[], &single.prepared_5),
                    runtime::not_finite("charge / mass", &[], &single.prepared_6),
                    runtime::not_finite("number field / mass", &[], &single.prepared_7),
                    runtime::not_finite("field / mass", &[], &single.prepared_8),
                    runtime::not_finite("1 / (2 mass)", &[], &single.prepared_9),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.number);
            digest.add(&single.field);
            digest.add(&single.prepared_2);
            digest.add(&single.prepared_3);
            digest.add(&single.charge);
            digest.add(&single.prepared_5);
            digest.add(&single.prepared_6);
            digest.add(&single.prepared_7);
            digest.add(&single.prepared_8);
            digest.add(&single.prepared_9);
        }
    }
    /// The equations of motion, derived from `along_x`, `along_y` and `well`:
    ///
    /// ```text
    /// dq[0]/dt = u1 / mass
    /// dq[1]/dt = -u2 / mass
    /// dp[0]/dt = -q[0] - charge q[1]^2 u2 / mass + number field u1 cos(number q[0] - q[1]) / mass
    /// dp[1]/dt = -q[1] (1 + 2 charge q[0] u2 / mass) - field u1 cos(number q[0] - q[1]) / mass
    /// where u1 = p[0] - field sin(number q[0] - q[1])
    /// where u2 = -p[1] + charge q[0] q[1]^2
    /// ```
    ///
    /// Each part has an exact flow.
    #[automatically_derived]
    impl runtime::Hamiltonian for Charge {
        type Compose = Yoshida4;
        const EQUATIONS: &'static [&'static str] = &[
            "along_x = (p[0] - field sin(number q[0] - q[1]))^2 / (2 mass)",
            "along_y = (-p[1] + charge q[0] q[1]^2)^2 / (2 mass)",
            "well = (q[1]^2 + q[0]^2) / 2",
            "dq[0]/dt = u1 / mass",
            "dq[1]/dt = -u2 / mass",
            "dp[0]/dt = -q[0] - charge q[1]^2 u2 / mass + number field u1 cos(number q[0] - q[1]) / mass",
            "dp[1]/dt = -q[1] (1 + 2 charge q[0] u2 / mass) - field u1 cos(number q[0] - q[1]) / mass",
            "where u1 = p[0] - field sin(number q[0] - q[1])",
            "where u2 = -p[1] + charge q[0] q[1]^2",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_many_parts(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Charge {
        type Coords = [f64; 2];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const PARTS: &'static [&'static str] = &["along_x", "along_y", "well"];
        const SEPARABLE: bool = false;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 8713124585364525073;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                number: self.number,
                field: self.field,
                prepared_2: self.field / self.number,
                prepared_3: 2.0 / (2.0 * self.mass),
                charge: self.charge,
                prepared_5: self.charge / 3.0,
                prepared_6: 2.0 * self.charge / (2.0 * self.mass),
                prepared_7: 2.0 * self.number * self.field / (2.0 * self.mass),
                prepared_8: 2.0 * self.field / (2.0 * self.mass),
                prepared_9: 1.0 / (2.0 * self.mass),
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            {
                let step = Scalar::of(-1.0);
                let shared_0 = motion
                    .parameters
                    .number
                    .scale_add(motion.q[0].value(), -motion.q[1].value())
                    .sin();
                motion.p[0].scale_add(step * motion.parameters.field, shared_0);
                motion.p[1].scale_add(-(step * motion.parameters.prepared_2), shared_0);
            }
            {
                let step = Scalar::of(duration);
                motion
                    .q[0]
                    .scale_add(step * motion.parameters.prepared_3, motion.p[0].value());
            }
            let step = Scalar::of(1.0);
            let shared_0 = motion
                .parameters
                .number
                .scale_add(motion.q[0].value(), -motion.q[1].value())
                .sin();
            motion.p[0].scale_add(step * motion.parameters.field, shared_0);
            motion.p[1].scale_add(-(step * motion.parameters.prepared_2), shared_0);
        }
        #[inline(always)]
        fn middle<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
            _backwards: bool,
        ) {
            {
                let step = Scalar::of(-1.0);
                let q1 = motion.q[1].value();
                let shared_0 = q1.square();
                motion
                    .p[1]
                    .fma(
                        (step * motion.parameters.charge).scale(motion.q[0].value()),
                        shared_0,
                    );
                motion
                    .p[0]
                    .scale_add(step * motion.parameters.prepared_5, shared_0 * q1);
            }
            {
                let step = Scalar::of(duration);
                motion
                    .q[1]
                    .scale_add(step * motion.parameters.prepared_3, motion.p[1].value());
            }
            let step = Scalar::of(1.0);
            let q1 = motion.q[1].value();
            let shared_0 = q1.square();
            motion
                .p[1]
                .fma(
                    (step * motion.parameters.charge).scale(motion.q[0].value()),
                    shared_0,
                );
            motion.p[0].scale_add(step * motion.parameters.prepared_5, shared_0 * q1);
        }
        #[inline(always)]
        fn kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            motion.p[0].scale_add(step, motion.q[0].value());
            motion.p[1].scale_add(step, motion.q[1].value());
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
            let shared_0 = motion.parameters.number.scale_add(q0, -q1);
            let (shared_1, shared_3) = shared_0.sin_cos();
            let shared_2 = (-motion.parameters.field)
                .scale_add(shared_1, motion.p[0].value());
            let shared_4 = motion.parameters.charge.scale(q0);
            let shared_5 = step * motion.parameters.prepared_3;
            let shared_6 = q1.square();
            let shared_7 = shared_4.fma(shared_6, -motion.p[1].value());
            moved
                .p[0]
                .scale_add(
                    -step,
                    (-motion.parameters.prepared_7.scale(shared_2))
                        .fma(
                            shared_3,
                            motion
                                .parameters
                                .prepared_6
                                .scale(shared_7)
                                .fma(shared_6, q0),
                        ),
                );
            moved
                .p[1]
                .scale_add(
                    -step,
                    motion
                        .parameters
                        .prepared_8
                        .scale(shared_2)
                        .fma(
                            shared_3,
                            Scalar::of(2.0).scale(q1)
                                * motion
                                    .parameters
                                    .prepared_3
                                    .scale(shared_7)
                                    .fma(shared_4, Scalar::of(0.5)),
                        ),
                );
            moved.q[0].scale_add(shared_5, shared_2);
            moved.q[1].scale_add(-shared_5, shared_7);
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let shared_0 = (-motion.parameters.field)
                .scale_add(
                    motion
                        .parameters
                        .number
                        .scale_add(motion.q[0].value(), -motion.q[1].value())
                        .sin(),
                    motion.p[0].value(),
                );
            motion.parameters.prepared_9.scale(shared_0.square())
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            let q1 = motion.q[1].value();
            let shared_0 = q1.square();
            let shared_1 = motion
                .parameters
                .charge
                .scale(q0)
                .fma(shared_0, -motion.p[1].value());
            Scalar::of(0.5)
                .scale_add(
                    q0.square_add(shared_0),
                    motion.parameters.prepared_9.scale(shared_1.square()),
                )
        }
        fn stated(
            &self,
            q: &Self::Coords,
            p: &Self::Coords,
            time: f64,
        ) -> runtime::StatedEnergy {
            runtime::StatedEnergy::Separate {
                kinetic: Self::along_x(self, *q, *p),
                potential: Self::along_y(self, *q, *p) + Self::well(self, *q),
            }
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Charge {}
};
