#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `1 / (mass length^2)`
        prepared_0: Scalar,
        /// `k overtones[k] sqrt(length + k)`
        prepared_1: runtime::SharedTable<Scalar>,
        prepared_2: usize,
        /// `mass gravity length`
        prepared_3: Scalar,
        /// `k^2 overtones[k] sqrt(length + k)`
        prepared_4: runtime::SharedTable<Scalar>,
        /// `1 / (2 mass length^2)`
        prepared_5: Scalar,
        /// `overtones[k] sqrt(length + k)`
        prepared_6: runtime::SharedTable<Scalar>,
        /// `1 / (2 mass^2 length^2)`
        prepared_7: Scalar,
        /// `1 / (mass length^3)`
        prepared_8: Scalar,
        /// `overtones[k] / (2 sqrt(length + k))`
        prepared_9: runtime::SharedTable<Scalar>,
        /// `gravity length`
        prepared_10: Scalar,
        /// `mass gravity`
        prepared_11: Scalar,
    }
    impl Parameters<f64> {
        fn prepared_0(&self) -> &f64 {
            &self.prepared_0
        }
        fn prepared_1(&self) -> &runtime::SharedTable<f64> {
            &self.prepared_1
        }
        fn prepared_3(&self) -> &f64 {
            &self.prepared_3
        }
        fn prepared_4(&self) -> &runtime::SharedTable<f64> {
            &self.prepared_4
        }
        fn prepared_5(&self) -> &f64 {
            &self.prepared_5
        }
        fn prepared_6(&self) -> &runtime::SharedTable<f64> {
            &self.prepared_6
        }
        fn prepared_7(&self) -> &f64 {
            &self.prepared_7
        }
        fn prepared_8(&self) -> &f64 {
            &self.prepared_8
        }
        fn prepared_9(&self) -> &runtime::SharedTable<f64> {
            &self.prepared_9
        }
        fn prepared_10(&self) -> &f64 {
            &self.prepared_10
        }
        fn prepared_11(&self) -> &f64 {
            &self.prepared_11
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                prepared_0: runtime::in_lanes(members, Parameters::prepared_0),
                prepared_1: runtime::in_lanes(members, Parameters::prepared_1),
                prepared_2: ::core::clone::Clone::clone(&members[0].prepared_2),
                prepared_3: runtime::in_lanes(members, Parameters::prepared_3),
                prepared_4: runtime::in_lanes(members, Parameters::prepared_4),
                prepared_5: runtime::in_lanes(members, Parameters::prepared_5),
                prepared_6: runtime::in_lanes(members, Parameters::prepared_6),
                prepared_7: runtime::in_lanes(members, Parameters::prepared_7),
                prepared_8: runtime::in_lanes(members, Parameters::prepared_8),
                prepared_9: runtime::in_lanes(members, Parameters::prepared_9),
                prepared_10: runtime::in_lanes(members, Parameters::prepared_10),
                prepared_11: runtime::in_lanes(members, Parameters::prepared_11),
            }
        }
        #[inline]
        fn alike(a: &Self::Single, b: &Self::Single) -> bool {
            a.prepared_1.len() == b.prepared_1.len() && a.prepared_2 == b.prepared_2
                && a.prepared_4.len() == b.prepared_4.len()
                && a.prepared_6.len() == b.prepared_6.len()
                && a.prepared_9.len() == b.prepared_9.len()
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("1 / (mass length^2)", &[], &single.prepared_0),
                    runtime::not_finite(
                        "k overtones[k] sqrt(length + k)",
                        &["k"],
                        &single.prepared_1,
                    ),
                    runtime::not_finite("mass gravity length", &[], &single.prepared_3),
                    runtime::not_finite(
                        "k^2 overtones[k] sqrt(length + k)",
                        &["k"],
                        &single.prepared_4,
                    ),
                    runtime::not_finite(
                        "1 / (2 mass length^2)",
                        &[],
                        &single.prepared_5,
                    ),
                    runtime::not_finite(
                        "overtones[k] sqrt(length + k)",
                        &["k"],
                        &single.prepared_6,
                    ),
                    runtime::not_finite(
                        "1 / (2 mass^2 length^2)",
                        &[],
                        &single.prepared_7,
                    ),
                    runtime::not_finite("1 / (mass length^3)", &[], &single.prepared_8),
                    runtime::not_finite(
                        "overtones[k] / (2 sqrt(length + k))",
                        &["k"],
                        &single.prepared_9,
                    ),
                    runtime::not_finite("gravity length", &[], &single.prepared_10),
                    runtime::not_finite("mass gravity", &[], &single.prepared_11),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.prepared_0);
            digest.add(&single.prepared_1);
            digest.add(&single.prepared_2);
            digest.add(&single.prepared_3);
            digest.add(&single.prepared_4);
            digest.add(&single.prepared_5);
            digest.add(&single.prepared_6);
            digest.add(&single.prepared_7);
            digest.add(&single.prepared_8);
            digest.add(&single.prepared_9);
            digest.add(&single.prepared_10);
            digest.add(&single.prepared_11);
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[0]/dt = p[0] / (mass length^2)
    /// dp[0]/dt = Σ_{k in 0..overtones.len()} k overtones[k] sin(k q[0]) sqrt(length + k) - mass gravity length sin(q[0])
    /// ```
    ///
    /// `T` is quadratic in the momenta, with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for Pendulum {
        type Compose = runtime::Verlet;
        const EQUATIONS: &'static [&'static str] = &[
            "T = p[0]^2 / (2 mass length^2)",
            "V = Σ_{k in 0..overtones.len()} overtones[k] cos(k q[0]) sqrt(length + k) - mass gravity length cos(q[0])",
            "dq[0]/dt = p[0] / (mass length^2)",
            "dp[0]/dt = Σ_{k in 0..overtones.len()} k overtones[k] sin(k q[0]) sqrt(length + k) - mass gravity length sin(q[0])",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Pendulum {
        type Coords = [f64; 1];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 5290808694649245244;
        fn parameters(&self, length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: 2.0 / (2.0 * self.mass * (self.length * self.length)),
                prepared_1: runtime::table(
                    (self.overtones.len()),
                    &|k: usize| {
                        (k as f64) * self.overtones[k]
                            * (self.length + (k as f64)).sqrt()
                    },
                ),
                prepared_2: self.overtones.len(),
                prepared_3: self.mass * self.gravity * self.length,
                prepared_4: runtime::table(
                    (self.overtones.len()),
                    &|k: usize| {
                        (k as f64) * (k as f64) * self.overtones[k]
                            * (self.length + (k as f64)).sqrt()
                    },
                ),
                prepared_5: 1.0 / (2.0 * self.mass * (self.length * self.length)),
                prepared_6: runtime::table(
                    (self.overtones.len()),
                    &|k: usize| self.overtones[k] * (self.length + (k as f64)).sqrt(),
                ),
                prepared_7: {
                    let shared_0 = self.length * self.length;
                    let shared_1 = 2.0 * self.mass * shared_0;
                    2.0 / (shared_1 * shared_1) * shared_0
                },
                prepared_8: {
                    let shared_0 = 2.0 * self.mass * (self.length * self.length);
                    4.0 / (shared_0 * shared_0) * (self.length * self.mass)
                },
                prepared_9: runtime::table(
                    (self.overtones.len()),
                    &|k: usize| {
                        0.5 / (self.length + (k as f64)).sqrt() * self.overtones[k]
                    },
                ),
                prepared_10: self.gravity * self.length,
                prepared_11: self.mass * self.gravity,
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            motion
                .q[0]
                .scale_add(step * motion.parameters.prepared_0, motion.p[0].value());
        }
        #[inline(always)]
        fn kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            let q0 = motion.q[0].value();
            let mut sum_0 = Scalar::of(0.0);
            for k in 0..motion.parameters.prepared_2 {
                sum_0 = motion
                    .parameters
                    .prepared_1[k]
                    .scale_add(Scalar::of(k as f64).scale(q0).sin(), sum_0);
            }
            motion
                .p[0]
                .scale_add(
                    step,
                    motion.parameters.prepared_3.scale_add(q0.sin(), -sum_0),
                );
        }
        const HAS_FIELD: bool = true;
        #[inline(always)]
        fn along_velocity<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
            moved: runtime::MovedBy<'_, Self, Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            moved
                .q[0]
                .scale_add(step * motion.parameters.prepared_0, motion.p[0].value());
        }
        #[inline(always)]
        fn along_force<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
            moved: runtime::MovedBy<'_, Self, Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            let q0 = motion.q[0].value();
            let mut sum_0 = Scalar::of(0.0);
            for k in 0..motion.parameters.prepared_2 {
                sum_0 = motion
                    .parameters
                    .prepared_1[k]
                    .scale_add(Scalar::of(k as f64).scale(q0).sin(), sum_0);
            }
            moved
                .p[0]
                .scale_add(
                    step,
                    motion.parameters.prepared_3.scale_add(q0.sin(), -sum_0),
                );
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let p0 = motion.p[0].value();
            motion.parameters.prepared_5.scale(p0.square())
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            let mut sum_0 = Scalar::of(0.0);
            for k in 0..motion.parameters.prepared_2 {
                sum_0 = motion
                    .parameters
                    .prepared_6[k]
                    .scale_add(Scalar::of(k as f64).scale(q0).cos(), sum_0);
            }
            (-motion.parameters.prepared_3).scale_add(q0.cos(), sum_0)
        }
        fn stated(
            &self,
            q: &Self::Coords,
            p: &Self::Coords,
            time: f64,
        ) -> runtime::StatedEnergy {
            runtime::StatedEnergy::Separate {
                kinetic: Self::kinetic(self, *p),
                potential: Self::potential(self, *q),
            }
        }
    }
    #[automatically_derived]
    impl runtime::QuadraticKinetic for Pendulum {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = [Scalar::of(0.0); 1];
            let p0 = motion.p[0].value();
            let q0 = motion.q[0].value();
            let mut sum_0 = Scalar::of(0.0);
            for k in 0..motion.parameters.prepared_2 {
                sum_0 = motion
                    .parameters
                    .prepared_4[k]
                    .scale(p0)
                    .fma(Scalar::of(k as f64).scale(q0).cos(), sum_0);
            }
            gradient[0] += motion.parameters.prepared_3.scale(p0).fma(q0.cos(), -sum_0);
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
            ::core::mem::swap(&mut force.q, &mut bent.p);
            <Self as runtime::System>::drift::<Scalar, f64>(&mut force, 1.0, time);
            bent.p = force.q;
            <Self as runtime::QuadraticKinetic>::hessian::<Scalar>(&mut bent, time);
            motion.push(Scalar::of(-2.0 * gradient), &bent);
        }
    }
    #[automatically_derived]
    impl runtime::TimeTransformed for Pendulum {
        #[inline(always)]
        fn kinetic_plus<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
            more: Scalar,
        ) -> Scalar {
            let time = more;
            let p0 = motion.p[0].value();
            motion.parameters.prepared_5.scale_add(p0.square(), time)
        }
        #[inline(always)]
        fn potential_of<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
        ) -> Scalar {
            <Self as runtime::System>::potential::<Scalar, Leaf>(motion, 0.0)
        }
        #[inline(always)]
        fn kick_for<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) {
            let mut force = motion.at_rest();
            <Self as runtime::System>::kick::<Scalar, f64>(&mut force, 1.0, 0.0);
            motion.push(duration, &force);
        }
        #[inline(always)]
        fn drift_for<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) {
            let step = duration;
            motion
                .q[0]
                .fma(motion.parameters.prepared_0.scale(step), motion.p[0].value());
        }
        #[inline(always)]
        fn logarithmic_kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) -> Scalar {
            let step = -duration;
            let q0 = motion.q[0].value();
            let (shared_3, shared_0) = q0.sin_cos();
            let mut sum_0 = Scalar::of(0.0);
            for k in 0..motion.parameters.prepared_2 {
                let shared_1 = Scalar::of(k as f64).scale(q0);
                sum_0 = motion.parameters.prepared_6[k].scale_add(shared_1.cos(), sum_0);
            }
            let shared_2 = (-motion.parameters.prepared_3).scale_add(shared_0, sum_0);
            let shared_4 = Scalar::of(1.0) / shared_2;
            let mut sum_1 = Scalar::of(0.0);
            for k in 0..motion.parameters.prepared_2 {
                let shared_1 = Scalar::of(k as f64).scale(q0);
                sum_1 = motion
                    .parameters
                    .prepared_1[k]
                    .scale(shared_4)
                    .fma(shared_1.sin(), sum_1);
            }
            motion
                .p[0]
                .fma(
                    step,
                    (-motion.parameters.prepared_3.scale(shared_4)).fma(shared_3, sum_1),
                );
            shared_2
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Pendulum {
        const SENSITIVE: &'static [&'static str] = &["mass", "length"];
        fn parameter_slopes(&self, length: usize, parameter: usize) -> Parameters<f64> {
            match parameter {
                0 => {
                    Parameters {
                        prepared_0: {
                            let shared_0 = self.length * self.length;
                            let shared_1 = 2.0 * self.mass * shared_0;
                            -(4.0 / (shared_1 * shared_1) * shared_0)
                        },
                        prepared_1: runtime::table(
                            (self.overtones.len()),
                            &|k: usize| 0.0,
                        ),
                        prepared_2: self.overtones.len(),
                        prepared_3: self.gravity * self.length,
                        prepared_4: runtime::table(
                            (self.overtones.len()),
                            &|k: usize| 0.0,
                        ),
                        prepared_5: {
                            let shared_0 = self.length * self.length;
                            let shared_1 = 2.0 * self.mass * shared_0;
                            -(2.0 / (shared_1 * shared_1) * shared_0)
                        },
                        prepared_6: runtime::table(
                            (self.overtones.len()),
                            &|k: usize| 0.0,
                        ),
                        prepared_7: {
                            let shared_0 = self.length * self.length;
                            let shared_1 = 2.0 * self.mass * shared_0;
                            -(8.0 / (shared_1 * shared_1 * shared_1) * shared_0
                                * shared_0)
                        },
                        prepared_8: {
                            let shared_0 = self.length * self.length;
                            let shared_1 = 1.0 / (2.0 * self.mass * shared_0);
                            let shared_2 = shared_1 * shared_1;
                            4.0 * self.length * shared_2
                                - 16.0 * (shared_2 * shared_1) * shared_0
                                    * (self.length * self.mass)
                        },
                        prepared_9: runtime::table(
                            (self.overtones.len()),
                            &|k: usize| 0.0,
                        ),
                        prepared_10: 0.0,
                        prepared_11: self.gravity,
                    }
                }
                1 => {
                    Parameters {
                        prepared_0: {
                            let shared_0 = 2.0 * self.mass * (self.length * self.length);
                            -(8.0 / (shared_0 * shared_0) * (self.length * self.mass))
                        },
                        prepared_1: runtime::table(
                            (self.overtones.len()),
                            &|k: usize| {
                                0.5 / (self.length + (k as f64)).sqrt()
                                    * ((k as f64) * self.overtones[k])
                            },
                        ),
                        prepared_2: self.overtones.len(),
                        prepared_3: self.mass * self.gravity,
                        prepared_4: runtime::table(
                            (self.overtones.len()),
                            &|k: usize| {
                                0.5 / (self.length + (k as f64)).sqrt()
                                    * ((k as f64) * (k as f64) * self.overtones[k])
                            },
                        ),
                        prepared_5: {
                            let shared_0 = 2.0 * self.mass * (self.length * self.length);
                            -(4.0 / (shared_0 * shared_0) * (self.length * self.mass))
                        },
                        prepared_6: runtime::table(
                            (self.overtones.len()),
                            &|k: usize| {
                                0.5 / (self.length + (k as f64)).sqrt() * self.overtones[k]
                            },
                        ),
                        prepared_7: {
                            let shared_0 = self.length * self.length;
                            let shared_1 = 1.0 / (2.0 * self.mass * shared_0);
                            let shared_2 = shared_1 * shared_1;
                            4.0 * self.length * shared_2
                                - 16.0 * (shared_2 * shared_1) * (self.length * self.mass)
                                    * shared_0
                        },
                        prepared_8: {
                            let shared_0 = self.length * self.mass;
                            let shared_1 = 1.0
                                / (2.0 * self.mass * (self.length * self.length));
                            let shared_2 = shared_1 * shared_1;
                            4.0 * self.mass * shared_2
                                - 32.0 * (shared_2 * shared_1) * shared_0 * shared_0
                        },
                        prepared_9: runtime::table(
                            (self.overtones.len()),
                            &|k: usize| {
                                let shared_0 = self.length + (k as f64);
                                -(0.25 / (shared_0 * shared_0.sqrt()) * self.overtones[k])
                            },
                        ),
                        prepared_10: self.gravity,
                        prepared_11: 0.0,
                    }
                }
                _ => {
                    Parameters {
                        prepared_0: 0.0,
                        prepared_1: runtime::table(
                            (self.overtones.len()),
                            &|k: usize| 0.0,
                        ),
                        prepared_2: self.overtones.len(),
                        prepared_3: 0.0,
                        prepared_4: runtime::table(
                            (self.overtones.len()),
                            &|k: usize| 0.0,
                        ),
                        prepared_5: 0.0,
                        prepared_6: runtime::table(
                            (self.overtones.len()),
                            &|k: usize| 0.0,
                        ),
                        prepared_7: 0.0,
                        prepared_8: 0.0,
                        prepared_9: runtime::table(
                            (self.overtones.len()),
                            &|k: usize| 0.0,
                        ),
                        prepared_10: 0.0,
                        prepared_11: 0.0,
                    }
                }
            }
        }
        const ENERGIES_HAVE_SLOPES: bool = true;
        #[inline(always)]
        fn add_slopes_of_kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
            slopes: &mut [Scalar],
        ) {
            let step = Scalar::of(duration);
            let p0 = motion.p[0].value();
            let shared_0 = p0.square();
            slopes[0] = step
                .scale_add(-motion.parameters.prepared_7.scale(shared_0), slopes[0]);
            slopes[1] = step
                .scale_add(-motion.parameters.prepared_8.scale(shared_0), slopes[1]);
        }
        #[inline(always)]
        fn add_slopes_of_potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
            slopes: &mut [Scalar],
        ) {
            let step = Scalar::of(duration);
            let q0 = motion.q[0].value();
            let shared_0 = q0.cos();
            let mut sum_0 = Scalar::of(0.0);
            for k in 0..motion.parameters.prepared_2 {
                sum_0 = motion
                    .parameters
                    .prepared_9[k]
                    .scale_add(Scalar::of(k as f64).scale(q0).cos(), sum_0);
            }
            slopes[0] = step
                .scale_add(-motion.parameters.prepared_10.scale(shared_0), slopes[0]);
            slopes[1] = step
                .scale_add(
                    (-motion.parameters.prepared_11).scale_add(shared_0, sum_0),
                    slopes[1],
                );
        }
    }
    #[automatically_derived]
    impl runtime::Sensitive for Pendulum {}
};
