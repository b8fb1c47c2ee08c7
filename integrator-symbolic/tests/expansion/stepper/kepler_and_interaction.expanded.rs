#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `1 / mass[i]`
        prepared_0: [Scalar; 5],
        /// `pull mass[i]`
        prepared_1: [Scalar; 5],
        /// `gravity mass[i]`
        prepared_2: [Scalar; 5],
        /// `mass[j]`
        mass: [Scalar; 4],
        /// `3 gravity mass[i]`
        prepared_4: [Scalar; 5],
        /// `1 / (2 mass[i])`
        prepared_5: [Scalar; 5],
    }
    impl Parameters<f64> {
        fn prepared_0(&self) -> &[f64; 5] {
            &self.prepared_0
        }
        fn prepared_1(&self) -> &[f64; 5] {
            &self.prepared_1
        }
        fn prepared_2(&self) -> &[f64; 5] {
            &self.prepared_2
        }
        fn mass(&self) -> &[f64; 4] {
            &self.mass
        }
        fn prepared_4(&self) -> &[f64; 5] {
            &self.prepared_4
        }
        fn prepared_5(&self) -> &[f64; 5] {
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
                prepared_2: runtime::in_lanes(members, Parameters::prepared_2),
                mass: runtime::in_lanes(members, Parameters::mass),
                prepared_4: runtime::in_lanes(members, Parameters::prepared_4),
                prepared_5: runtime::in_lanes(members, Parameters::prepared_5),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("1 / mass[i]", &["i"], &single.prepared_0),
                    runtime::not_finite("pull mass[i]", &["i"], &single.prepared_1),
                    runtime::not_finite("gravity mass[i]", &["i"], &single.prepared_2),
                    runtime::not_finite("mass[j]", &["j"], &single.mass),
                    runtime::not_finite("3 gravity mass[i]", &["i"], &single.prepared_4),
                    runtime::not_finite("1 / (2 mass[i])", &["i"], &single.prepared_5),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.prepared_0);
            digest.add(&single.prepared_1);
            digest.add(&single.prepared_2);
            digest.add(&single.mass);
            digest.add(&single.prepared_4);
            digest.add(&single.prepared_5);
        }
    }
    /// The equations of motion, derived from `kepler` and `interaction`:
    ///
    /// ```text
    /// dq[i][k]/dt = p[i][k] / mass[i]   for i in 0..5, k in 0..3
    /// dp[i][0]/dt += -pull mass[i] q[i][0] / r_i^3 + Σ_{j in 0..i} gravity mass[i] mass[j] (q[j][0] - q[i][0]) / r_ij^3   for i in 0..5
    /// dp[i][1]/dt += -pull mass[i] q[i][1] / r_i^3 + Σ_{j in 0..i} gravity mass[i] mass[j] (q[j][1] - q[i][1]) / r_ij^3   for i in 0..5
    /// dp[i][2]/dt += -pull mass[i] q[i][2] / r_i^3 + Σ_{j in 0..i} gravity mass[i] mass[j] (q[j][2] - q[i][2]) / r_ij^3   for i in 0..5
    /// dp[j][0]/dt += gravity mass[i] mass[j] (q[i][0] - q[j][0]) / r_ij^3   for i in 0..5, j in 0..i
    /// dp[j][1]/dt += gravity mass[i] mass[j] (q[i][1] - q[j][1]) / r_ij^3   for i in 0..5, j in 0..i
    /// dp[j][2]/dt += gravity mass[i] mass[j] (q[i][2] - q[j][2]) / r_ij^3   for i in 0..5, j in 0..i
    /// where r_i = sqrt(q[i][0]^2 + q[i][1]^2 + q[i][2]^2)
    /// where r_ij = sqrt((q[i][0] - q[j][0])^2 + (q[i][1] - q[j][1])^2 + (q[i][2] - q[j][2])^2)
    /// ```
    ///
    /// Each part has an exact flow.
    #[automatically_derived]
    impl runtime::Hamiltonian for Planets {
        type Compose = Aba1064;
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_two_parts_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Planets {
        type Coords = [[f64; 3]; 5];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Solving<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
            runtime::Kepler,
        >;
        const PARTS: &'static [&'static str] = &["kepler", "interaction"];
        const SEPARABLE: bool = false;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 2835648426565933545;
        const WIDE: bool = true;
        const LARGE_FLOWS: bool = true;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: ::core::array::from_fn(|i: usize| 1.0 / self.mass[i]),
                prepared_1: ::core::array::from_fn(|i: usize| self.pull * self.mass[i]),
                prepared_2: ::core::array::from_fn(|i: usize| {
                    self.gravity * self.mass[i]
                }),
                mass: ::core::array::from_fn(|j: usize| self.mass[j]),
                prepared_4: ::core::array::from_fn(|i: usize| {
                    3.0 * (self.gravity * self.mass[i])
                }),
                prepared_5: ::core::array::from_fn(|i: usize| 0.5 / self.mass[i]),
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let solver = &mut motion.solvers;
            solver
                .flow(
                    [&mut motion.q[..], &mut motion.p[..]],
                    &motion.parameters.prepared_0[..],
                    &motion.parameters.prepared_1[..],
                    duration,
                );
        }
        #[inline(always)]
        fn kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            let mut gradient = [[Scalar::of(0.0); 3]; 5];
            for i in 0..5 {
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
                    let shared_4 = (motion.parameters.prepared_2[i]
                        * motion.parameters.mass[j])
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
                    (*slot).scale_add(step, *gradient);
                }
            }
        }
        #[inline(always)]
        fn along_field<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
            moved: runtime::MovedBy<'_, Self, Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            {
                let mut gradient = [[Scalar::of(0.0); 3]; 5];
                for i in 0..5 {
                    for k in 0..3 {
                        gradient[i][k] = motion
                            .parameters
                            .prepared_0[i]
                            .scale_add(motion.p[i][k].value(), gradient[i][k]);
                    }
                }
                for (slot, gradient) in ::core::iter::zip(
                    moved.q.iter_mut(),
                    &gradient,
                ) {
                    for (slot, gradient) in ::core::iter::zip(slot, gradient) {
                        (*slot).scale_add(step, *gradient);
                    }
                }
            }
            {
                let mut gradient = [[Scalar::of(0.0); 3]; 5];
                for i in 0..5 {
                    let q_i_0 = motion.q[i][0].value();
                    let q_i_1 = motion.q[i][1].value();
                    let q_i_2 = motion.q[i][2].value();
                    let shared_8 = q_i_2.square_add(q_i_1.square_add(q_i_0.square()));
                    let shared_9 = motion.parameters.prepared_1[i].div_pow_3_2(shared_8);
                    let mut sum_0 = Scalar::of(0.0);
                    let mut sum_1 = Scalar::of(0.0);
                    let mut sum_2 = Scalar::of(0.0);
                    for j in 0..i {
                        let shared_0 = q_i_0 - motion.q[j][0].value();
                        let shared_1 = q_i_1 - motion.q[j][1].value();
                        let shared_2 = q_i_2 - motion.q[j][2].value();
                        let shared_3 = shared_2
                            .square_add(shared_1.square_add(shared_0.square()));
                        let shared_4 = (motion.parameters.prepared_2[i]
                            * motion.parameters.mass[j])
                            .div_pow_3_2(shared_3);
                        let shared_5 = shared_4 * shared_2;
                        let shared_6 = shared_4 * shared_1;
                        let shared_7 = shared_4 * shared_0;
                        gradient[j][0] += shared_7;
                        gradient[j][1] += shared_6;
                        gradient[j][2] += shared_5;
                        sum_2 += shared_7;
                        sum_1 += shared_6;
                        sum_0 += shared_5;
                    }
                    gradient[i][0] -= shared_9.fma(q_i_0, sum_2);
                    gradient[i][1] -= shared_9.fma(q_i_1, sum_1);
                    gradient[i][2] -= shared_9.fma(q_i_2, sum_0);
                }
                for (slot, gradient) in ::core::iter::zip(
                    moved.p.iter_mut(),
                    &gradient,
                ) {
                    for (slot, gradient) in ::core::iter::zip(slot, gradient) {
                        (*slot).scale_add(step, *gradient);
                    }
                }
            }
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let mut sum_1 = Scalar::of(0.0);
            for i in 0..5 {
                let q_i_0 = motion.q[i][0].value();
                let q_i_1 = motion.q[i][1].value();
                let q_i_2 = motion.q[i][2].value();
                let mut sum_0 = Scalar::of(0.0);
                for k in 0..3 {
                    let p_i_k = motion.p[i][k].value();
                    sum_0 = p_i_k.square_add(sum_0);
                }
                sum_1
                    += motion
                        .parameters
                        .prepared_5[i]
                        .scale_add(
                            sum_0,
                            -(motion.parameters.prepared_1[i]
                                / q_i_2.square_add(q_i_1.square_add(q_i_0.square())).sqrt()),
                        );
            }
            sum_1
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let mut sum_1 = Scalar::of(0.0);
            for i in 0..5 {
                let q_i_0 = motion.q[i][0].value();
                let q_i_1 = motion.q[i][1].value();
                let q_i_2 = motion.q[i][2].value();
                let mut sum_0 = Scalar::of(0.0);
                for j in 0..i {
                    let shared_0 = q_i_0 - motion.q[j][0].value();
                    let shared_1 = q_i_1 - motion.q[j][1].value();
                    let shared_2 = q_i_2 - motion.q[j][2].value();
                    sum_0
                        += motion.parameters.prepared_2[i] * motion.parameters.mass[j]
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
                kinetic: Self::kepler(self, *q, *p),
                potential: Self::interaction(self, *q),
            }
        }
    }
    #[automatically_derived]
    impl runtime::QuadraticKinetic for Planets {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = [[Scalar::of(0.0); 3]; 5];
            for i in 0..5 {
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
                    let shared_8 = (motion.parameters.prepared_2[i]
                        * motion.parameters.mass[j])
                        .scale(shared_6 * shared_7);
                    let shared_9 = (motion.parameters.prepared_4[i]
                        * motion.parameters.mass[j])
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
            ::core::mem::swap(&mut force.q, &mut force.p);
            bent.p = {
                let motion = &mut force;
                let mut gradient = [[Scalar::of(0.0); 3]; 5];
                for i in 0..5 {
                    for k in 0..3 {
                        gradient[i][k] = motion
                            .parameters
                            .prepared_0[i]
                            .scale_add(motion.q[i][k].value(), gradient[i][k]);
                    }
                }
                for (slot, gradient) in ::core::iter::zip(
                    motion.p.iter_mut(),
                    &gradient,
                ) {
                    for (slot, gradient) in ::core::iter::zip(slot, gradient) {
                        (*slot) = *gradient;
                    }
                }
                force.p
            };
            <Self as runtime::QuadraticKinetic>::hessian::<Scalar>(&mut bent, time);
            motion.push(Scalar::of(-2.0 * gradient), &bent);
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Planets {}
};
