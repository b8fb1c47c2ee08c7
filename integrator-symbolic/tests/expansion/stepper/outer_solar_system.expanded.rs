#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `1 / mass[i]`
        prepared_0: [Scalar; 6],
        /// `gravity mass[i]`
        prepared_1: [Scalar; 6],
        /// `mass[i]`
        mass: [Scalar; 6],
        /// `mass[j]`
        mass_2: [Scalar; 5],
        /// `3 gravity mass[i]`
        prepared_4: [Scalar; 6],
        /// `1 / (2 mass[i])`
        prepared_5: [Scalar; 6],
    }
    impl Parameters<f64> {
        fn prepared_0(&self) -> &[f64; 6] {
            &self.prepared_0
        }
        fn prepared_1(&self) -> &[f64; 6] {
            &self.prepared_1
        }
        fn mass(&self) -> &[f64; 6] {
            &self.mass
        }
        fn mass_2(&self) -> &[f64; 5] {
            &self.mass_2
        }
        fn prepared_4(&self) -> &[f64; 6] {
            &self.prepared_4
        }
        fn prepared_5(&self) -> &[f64; 6] {
            &self.prepared_5
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                prepared_0: runtime::in_lanes(members, Parameters::prepared_0),
                prepared_1: runtime::in_lanes(members, Parameters::prepared_1),
                mass: runtime::in_lanes(members, Parameters::mass),
                mass_2: runtime::in_lanes(members, Parameters::mass_2),
                prepared_4: runtime::in_lanes(members, Parameters::prepared_4),
                prepared_5: runtime::in_lanes(members, Parameters::prepared_5),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("1 / mass[i]", &["i"], &single.prepared_0),
                    runtime::not_finite("gravity mass[i]", &["i"], &single.prepared_1),
                    runtime::not_finite("mass[i]", &["i"], &single.mass),
                    runtime::not_finite("mass[j]", &["j"], &single.mass_2),
                    runtime::not_finite("3 gravity mass[i]", &["i"], &single.prepared_4),
                    runtime::not_finite("1 / (2 mass[i])", &["i"], &single.prepared_5),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.prepared_0);
            digest.add(&single.prepared_1);
            digest.add(&single.mass);
            digest.add(&single.mass_2);
            digest.add(&single.prepared_4);
            digest.add(&single.prepared_5);
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[i][d]/dt = p[i][d] / mass[i]   for i in 0..6, d in 0..3
    /// dp[i][d]/dt += gravity mass[i] mass[j] (q[j][d] - q[i][d]) / r_ij^3   for i in 0..6, j in 0..i, d in 0..3
    /// dp[j][d]/dt += gravity mass[i] mass[j] (q[i][d] - q[j][d]) / r_ij^3   for i in 0..6, j in 0..i, d in 0..3
    /// where r_ij = sqrt(Σ_{d in 0..3} (q[i][d] - q[j][d])^2)
    /// ```
    ///
    /// `T` is quadratic in the momenta, with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for Solar {
        type Compose = Yoshida4;
        const EQUATIONS: &'static [&'static str] = &[
            "T = Σ_{i in 0..6} Σ_{d in 0..3} p[i][d]^2 / (2 mass[i])",
            "V = -Σ_{i in 0..6} Σ_{j in 0..i} gravity mass[i] mass[j] / sqrt(Σ_{d in 0..3} (q[i][d] - q[j][d])^2)",
            "dq[i][d]/dt = p[i][d] / mass[i]   for i in 0..6, d in 0..3",
            "dp[i][d]/dt += gravity mass[i] mass[j] (q[j][d] - q[i][d]) / r_ij^3   for i in 0..6, j in 0..i, d in 0..3",
            "dp[j][d]/dt += gravity mass[i] mass[j] (q[i][d] - q[j][d]) / r_ij^3   for i in 0..6, j in 0..i, d in 0..3",
            "where r_ij = sqrt(Σ_{d in 0..3} (q[i][d] - q[j][d])^2)",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Solar {
        type Coords = [[f64; 3]; 6];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::OneRow<
            Scalar,
            Leaf,
            Parameters<Scalar>,
            6,
            3,
            3,
        >;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 10573598181573161531;
        const WIDE: bool = true;
        const LAYOUT: &'static [&'static str] = &["row", "row"];
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: ::core::array::from_fn(|i: usize| {
                    2.0 / (2.0 * self.mass[i])
                }),
                prepared_1: ::core::array::from_fn(|i: usize| {
                    self.gravity * self.mass[i]
                }),
                mass: ::core::array::from_fn(|i: usize| self.mass[i]),
                mass_2: ::core::array::from_fn(|j: usize| self.mass[j]),
                prepared_4: ::core::array::from_fn(|i: usize| {
                    3.0 * (self.gravity * self.mass[i])
                }),
                prepared_5: ::core::array::from_fn(|i: usize| 1.0 / (2.0 * self.mass[i])),
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            time: f64,
        ) {
            motion.drift::<Self>(duration, time);
        }
        #[inline(always)]
        fn kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            time: f64,
        ) {
            motion.kick::<Self>(duration, time);
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let motion = &motion.plain::<Self::Coords>();
            let mut sum_1 = Scalar::of(0.0);
            for i in 0..6 {
                let mut sum_0 = Scalar::of(0.0);
                for d in 0..3 {
                    let p_i_d = motion.p[i][d].value();
                    sum_0 = motion
                        .parameters
                        .prepared_5[i]
                        .scale_add(p_i_d.square(), sum_0);
                }
                sum_1 += sum_0;
            }
            sum_1
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let motion = &motion.plain::<Self::Coords>();
            let mut sum_1 = Scalar::of(0.0);
            for i in 0..6 {
                let q_i_0 = motion.q[i][0].value();
                let q_i_1 = motion.q[i][1].value();
                let q_i_2 = motion.q[i][2].value();
                let mut sum_0 = Scalar::of(0.0);
                for j in 0..i {
                    let shared_0 = q_i_0 - motion.q[j][0].value();
                    let shared_1 = q_i_1 - motion.q[j][1].value();
                    let shared_2 = q_i_2 - motion.q[j][2].value();
                    sum_0
                        += motion.parameters.prepared_1[i] * motion.parameters.mass_2[j]
                            / shared_2
                                .square_add(shared_1.square_add(shared_0.square()))
                                .sqrt();
                }
                sum_1 += sum_0;
            }
            -sum_1
        }
        fn stated(
            &self,
            q: &Self::Coords,
            p: &Self::Coords,
            time: f64,
        ) -> runtime::StatedEnergy {
            runtime::StatedEnergy::Separate {
                kinetic: Self::kinetic(self, p),
                potential: Self::potential(self, q),
            }
        }
    }
    #[automatically_derived]
    impl runtime::ManyBody<3, 3> for Solar {
        const RECIPROCAL: bool = true;
        const CENTRAL: bool = true;
        type Force<Wide: ::core::marker::Copy> = [Wide; 1];
        #[inline(always)]
        fn drift_body<
            Scalar: runtime::Real,
            Wide: runtime::Row<Scalar>,
            Leaf: runtime::Slot<Wide>,
        >(
            _parameters: &Self::Parameters<Scalar>,
            q_i: &mut [Leaf; 3],
            p_i: [Wide; 3],
            constants_i: [Wide; 3],
            step: Wide,
            _time: f64,
        ) {
            let prepared_0_of_i = constants_i[0];
            let shared_0 = step * prepared_0_of_i;
            for d in 0..3 {
                q_i[d].scale_add(shared_0, p_i[d]);
            }
        }
        #[inline(always)]
        fn pair<Scalar: runtime::Real, Wide: runtime::Row<Scalar>>(
            _parameters: &Self::Parameters<Scalar>,
            q_i: [Wide; 3],
            q_j: [Wide; 3],
            constants_i: [Wide; 3],
            constants_j: [Wide; 3],
            _time: f64,
        ) -> Self::Force<Wide> {
            let radial = {
                let prepared_1_of_i = constants_i[1];
                let mass_of_j = constants_j[2];
                let shared_0 = q_i[0] - q_j[0];
                let shared_1 = q_i[1] - q_j[1];
                let shared_2 = q_i[2] - q_j[2];
                let shared_3 = shared_2
                    .square_add(shared_1.square_add(shared_0.square()));
                (prepared_1_of_i * mass_of_j).div_pow_3_2(shared_3)
            };
            [radial]
        }
    }
    impl runtime::BodyConstants<3> for Parameters<f64> {
        #[inline]
        fn body_constants(&self, i: usize) -> [f64; 3] {
            [self.prepared_0[i], self.prepared_1[i], self.mass[i]]
        }
    }
    #[automatically_derived]
    impl runtime::QuadraticKinetic for Solar {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let bodies = motion;
            let motion = &mut bodies.plain::<Self::Coords>();
            let mut gradient = [[Scalar::of(0.0); 3]; 6];
            for i in 0..6 {
                let q_i_0 = motion.q[i][0].value();
                let q_i_1 = motion.q[i][1].value();
                let q_i_2 = motion.q[i][2].value();
                let p_i_0 = motion.p[i][0].value();
                let p_i_1 = motion.p[i][1].value();
                let p_i_2 = motion.p[i][2].value();
                let mut sum_0 = Scalar::of(0.0);
                let mut sum_1 = Scalar::of(0.0);
                let mut sum_2 = Scalar::of(0.0);
                for j in 0..i {
                    let shared_0 = q_i_0 - motion.q[j][0].value();
                    let shared_1 = q_i_1 - motion.q[j][1].value();
                    let shared_2 = q_i_2 - motion.q[j][2].value();
                    let shared_3 = p_i_0 - motion.p[j][0].value();
                    let shared_4 = p_i_1 - motion.p[j][1].value();
                    let shared_5 = p_i_2 - motion.p[j][2].value();
                    let shared_6 = Scalar::of(1.0)
                        / shared_2.square_add(shared_1.square_add(shared_0.square()));
                    let shared_7 = shared_6.sqrt();
                    let shared_8 = (motion.parameters.prepared_1[i]
                        * motion.parameters.mass_2[j])
                        .scale(shared_6 * shared_7);
                    let shared_9 = (motion.parameters.prepared_4[i]
                        * motion.parameters.mass_2[j])
                        .scale(
                            shared_2
                                .fma(shared_5, shared_1.fma(shared_4, shared_0 * shared_3)),
                        ) * (shared_6.square() * shared_7);
                    let shared_10 = (-shared_9).fma(shared_2, shared_8 * shared_5);
                    let shared_11 = (-shared_9).fma(shared_1, shared_8 * shared_4);
                    let shared_12 = (-shared_9).fma(shared_0, shared_8 * shared_3);
                    gradient[j][0] -= shared_12;
                    gradient[j][1] -= shared_11;
                    gradient[j][2] -= shared_10;
                    sum_2 += shared_12;
                    sum_1 += shared_11;
                    sum_0 += shared_10;
                }
                gradient[i][0] += sum_2;
                gradient[i][1] += sum_1;
                gradient[i][2] += sum_0;
            }
            for (slot, gradient) in ::core::iter::zip(motion.p.iter_mut(), &gradient) {
                for (slot, gradient) in ::core::iter::zip(slot, gradient) {
                    (*slot) = *gradient;
                }
            }
            bodies.set_momenta(motion);
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
    impl runtime::TimeTransformed for Solar {
        #[inline(always)]
        fn kinetic_plus<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
            more: Scalar,
        ) -> Scalar {
            let time = more;
            let mut sum_1 = Scalar::of(0.0);
            for i in 0..6 {
                let mut sum_0 = Scalar::of(0.0);
                for d in 0..3 {
                    let p_i_d = motion.p[i][d].value();
                    sum_0 = motion
                        .parameters
                        .prepared_5[i]
                        .scale_add(p_i_d.square(), sum_0);
                }
                sum_1 += sum_0;
            }
            sum_1 + time
        }
        #[inline(always)]
        fn potential_of<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
        ) -> Scalar {
            let mut sum_1 = Scalar::of(0.0);
            for i in 0..6 {
                let q_i_0 = motion.q[i][0].value();
                let q_i_1 = motion.q[i][1].value();
                let q_i_2 = motion.q[i][2].value();
                let mut sum_0 = Scalar::of(0.0);
                for j in 0..i {
                    let shared_0 = q_i_0 - motion.q[j][0].value();
                    let shared_1 = q_i_1 - motion.q[j][1].value();
                    let shared_2 = q_i_2 - motion.q[j][2].value();
                    sum_0
                        += motion.parameters.prepared_1[i] * motion.parameters.mass_2[j]
                            / shared_2
                                .square_add(shared_1.square_add(shared_0.square()))
                                .sqrt();
                }
                sum_1 += sum_0;
            }
            -sum_1
        }
        #[inline(always)]
        fn kick_for<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) {
            let step = -duration;
            let mut gradient = [[Scalar::of(0.0); 3]; 6];
            for i in 0..6 {
                let q_i_0 = motion.q[i][0].value();
                let q_i_1 = motion.q[i][1].value();
                let q_i_2 = motion.q[i][2].value();
                let mut sum_0 = Scalar::of(0.0);
                let mut sum_1 = Scalar::of(0.0);
                let mut sum_2 = Scalar::of(0.0);
                for j in 0..i {
                    let shared_0 = q_i_0 - motion.q[j][0].value();
                    let shared_1 = q_i_1 - motion.q[j][1].value();
                    let shared_2 = q_i_2 - motion.q[j][2].value();
                    let shared_3 = shared_2
                        .square_add(shared_1.square_add(shared_0.square()));
                    let shared_4 = (motion.parameters.prepared_1[i]
                        * motion.parameters.mass_2[j])
                        .div_pow_3_2(shared_3);
                    let shared_5 = shared_4 * shared_2;
                    let shared_6 = shared_4 * shared_1;
                    let shared_7 = shared_4 * shared_0;
                    gradient[j][0] -= shared_7;
                    gradient[j][1] -= shared_6;
                    gradient[j][2] -= shared_5;
                    sum_2 += shared_7;
                    sum_1 += shared_6;
                    sum_0 += shared_5;
                }
                gradient[i][0] += sum_2;
                gradient[i][1] += sum_1;
                gradient[i][2] += sum_0;
            }
            for (slot, gradient) in ::core::iter::zip(motion.p.iter_mut(), &gradient) {
                for (slot, gradient) in ::core::iter::zip(slot, gradient) {
                    (*slot).fma(step, *gradient);
                }
            }
        }
        #[inline(always)]
        fn drift_for<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) {
            let step = duration;
            for i in 0..6 {
                let shared_0 = motion.parameters.prepared_0[i].scale(step);
                for d in 0..3 {
                    motion.q[i][d].fma(shared_0, motion.p[i][d].value());
                }
            }
        }
        #[inline(always)]
        fn logarithmic_kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) -> Scalar {
            let step = -duration;
            let mut gradient = [[Scalar::of(0.0); 3]; 6];
            let energy = {
                let mut sum_1 = Scalar::of(0.0);
                for i in 0..6 {
                    let q_i_0 = motion.q[i][0].value();
                    let q_i_1 = motion.q[i][1].value();
                    let q_i_2 = motion.q[i][2].value();
                    let mut sum_0 = Scalar::of(0.0);
                    let mut sum_2 = Scalar::of(0.0);
                    let mut sum_3 = Scalar::of(0.0);
                    let mut sum_4 = Scalar::of(0.0);
                    for j in 0..i {
                        let shared_0 = motion.parameters.prepared_1[i]
                            * motion.parameters.mass_2[j];
                        let shared_1 = q_i_0 - motion.q[j][0].value();
                        let shared_2 = q_i_1 - motion.q[j][1].value();
                        let shared_3 = q_i_2 - motion.q[j][2].value();
                        let shared_4 = shared_3
                            .square_add(shared_2.square_add(shared_1.square()));
                        let shared_5 = shared_4.sqrt();
                        let shared_6 = shared_0 / (shared_4 * shared_5);
                        let shared_7 = shared_6 * shared_3;
                        let shared_8 = shared_6 * shared_2;
                        let shared_9 = shared_6 * shared_1;
                        gradient[j][0] -= shared_9;
                        gradient[j][1] -= shared_8;
                        gradient[j][2] -= shared_7;
                        sum_4 += shared_9;
                        sum_3 += shared_8;
                        sum_2 += shared_7;
                        sum_0 += shared_0 / shared_5;
                    }
                    gradient[i][0] += sum_4;
                    gradient[i][1] += sum_3;
                    gradient[i][2] += sum_2;
                    sum_1 += sum_0;
                }
                -sum_1
            };
            let step = step / -energy;
            for (slot, gradient) in ::core::iter::zip(motion.p.iter_mut(), &gradient) {
                for (slot, gradient) in ::core::iter::zip(slot, gradient) {
                    (*slot).fma(step, *gradient);
                }
            }
            energy
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Solar {}
};
