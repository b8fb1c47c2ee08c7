#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `masses[k_2]`
        masses: runtime::SharedTable<Scalar>,
        /// `softening`
        softening: Scalar,
        prepared_2: usize,
        /// `masses[i]`
        masses_2: runtime::SharedTable<Scalar>,
        /// `masses[j]`
        masses_3: runtime::SharedTable<Scalar>,
        /// `masses[i] / 2`
        prepared_5: runtime::SharedTable<Scalar>,
    }
    impl Parameters<f64> {
        fn masses(&self) -> &runtime::SharedTable<f64> {
            &self.masses
        }
        fn softening(&self) -> &f64 {
            &self.softening
        }
        fn masses_2(&self) -> &runtime::SharedTable<f64> {
            &self.masses_2
        }
        fn masses_3(&self) -> &runtime::SharedTable<f64> {
            &self.masses_3
        }
        fn prepared_5(&self) -> &runtime::SharedTable<f64> {
            &self.prepared_5
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                masses: runtime::in_lanes(members, Parameters::masses),
                softening: runtime::in_lanes(members, Parameters::softening),
                prepared_2: ::core::clone::Clone::clone(&members[0].prepared_2),
                masses_2: runtime::in_lanes(members, Parameters::masses_2),
                masses_3: runtime::in_lanes(members, Parameters::masses_3),
                prepared_5: runtime::in_lanes(members, Parameters::prepared_5),
            }
        }
        #[inline]
        fn alike(a: &Self::Single, b: &Self::Single) -> bool {
            a.masses.len() == b.masses.len() && a.prepared_2 == b.prepared_2
                && a.masses_2.len() == b.masses_2.len()
                && a.masses_3.len() == b.masses_3.len()
                && a.prepared_5.len() == b.prepared_5.len()
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("masses[k_2]", &["k_2"], &single.masses),
                    runtime::not_finite("softening", &[], &single.softening),
                    runtime::not_finite("masses[i]", &["i"], &single.masses_2),
                    runtime::not_finite("masses[j]", &["j"], &single.masses_3),
                    runtime::not_finite("masses[i] / 2", &["i"], &single.prepared_5),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.masses);
            digest.add(&single.softening);
            digest.add(&single.prepared_2);
            digest.add(&single.masses_2);
            digest.add(&single.masses_3);
            digest.add(&single.prepared_5);
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[k]/dt = p[k]   for k in 0..n
    /// dp[(3 * i) + k]/dt += masses[i] masses[j] (q[(3 * j) + k] - q[(3 * i) + k]) / r_ij^3   for i in 0..masses.len(), j in 0..i, k in 0..3, if 0 < i
    /// dp[(3 * j) + k]/dt += masses[i] masses[j] (q[(3 * i) + k] - q[(3 * j) + k]) / r_ij^3   for i in 0..masses.len(), j in 0..i, k in 0..3, if 0 < i
    /// where r_ij = sqrt(Σ_{k in 0..3} (q[(3 * i) + k] - q[(3 * j) + k])^2 + softening)
    /// ```
    ///
    /// `T` is quadratic in the momenta, with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for Cluster {
        type Compose = runtime::Verlet;
        const EQUATIONS: &'static [&'static str] = &[
            "T = Σ_{k in 0..n} p[k]^2 / 2",
            "V = -Σ_{i in 0..masses.len()} {Σ_{j in 0..i} masses[i] masses[j] / sqrt(Σ_{k in 0..3} (q[(3 * i) + k] - q[(3 * j) + k])^2 + softening) if 0 < i, else 0}",
            "dq[k]/dt = p[k]   for k in 0..n",
            "dp[(3 * i) + k]/dt += masses[i] masses[j] (q[(3 * j) + k] - q[(3 * i) + k]) / r_ij^3   for i in 0..masses.len(), j in 0..i, k in 0..3, if 0 < i",
            "dp[(3 * j) + k]/dt += masses[i] masses[j] (q[(3 * i) + k] - q[(3 * j) + k]) / r_ij^3   for i in 0..masses.len(), j in 0..i, k in 0..3, if 0 < i",
            "where r_ij = sqrt(Σ_{k in 0..3} (q[(3 * i) + k] - q[(3 * j) + k])^2 + softening)",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Cluster {
        type Coords = runtime::Vec<f64>;
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::ManyRows<
            Scalar,
            Leaf,
            Parameters<Scalar>,
            3,
            1,
        >;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 2711415008788260759;
        const WIDE: bool = true;
        const LAYOUT: &'static [&'static str] = &["pairs", "pairs"];
        const ENERGIES_IN_LANES: bool = true;
        fn admissible(
            &self,
            length: usize,
        ) -> ::core::result::Result<(), runtime::Error> {
            runtime::are_points(3, (self.masses.len()) * 3, length)
        }
        fn parameters(&self, length: usize) -> Parameters<f64> {
            Parameters {
                masses: runtime::table(
                    length / 3,
                    &|k_2: usize| {
                        (if k_2 < self.masses.len() { self.masses[k_2] } else { 0.0 })
                    },
                ),
                softening: self.softening,
                prepared_2: self.masses.len(),
                masses_2: runtime::table(
                    (self.masses.len()),
                    &|i: usize| self.masses[i],
                ),
                masses_3: runtime::table(
                    (self.masses.len()).saturating_sub(1),
                    &|j: usize| self.masses[j],
                ),
                prepared_5: runtime::table(
                    (self.masses.len()),
                    &|i: usize| 0.5 * self.masses[i],
                ),
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
            time: f64,
        ) -> Scalar {
            motion.kinetic::<Self>(time)
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            time: f64,
        ) -> Scalar {
            motion.potential::<Self>(time)
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
    impl runtime::ManyBody<3, 1> for Cluster {
        const SOME_STAY: bool = true;
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
            q_k_2: &mut [Leaf; 3],
            p_k_2: [Wide; 3],
            constants_k_2: [Wide; 1],
            step: Wide,
            _time: f64,
        ) {
            for k_3 in 0..3 {
                q_k_2[k_3].scale_add(step, p_k_2[k_3]);
            }
        }
        #[inline(always)]
        fn pair<Scalar: runtime::Real, Wide: runtime::Row<Scalar>>(
            parameters: &Self::Parameters<Scalar>,
            q_i: [Wide; 3],
            q_j: [Wide; 3],
            constants_i: [Wide; 1],
            constants_j: [Wide; 1],
            _time: f64,
        ) -> Self::Force<Wide> {
            let radial = {
                let masses_of_i = constants_i[0];
                let masses_of_j = constants_j[0];
                let shared_0 = q_i[0] - q_j[0];
                let shared_1 = q_i[1] - q_j[1];
                let shared_2 = q_i[2] - q_j[2];
                let shared_3 = (shared_2
                    .square_add(shared_1.square_add(shared_0.square()))
                    + Wide::splat(parameters.softening))
                    .sqrt();
                masses_of_i * masses_of_j / shared_3.square() / shared_3
            };
            [radial]
        }
        #[inline(always)]
        fn energy<Scalar: runtime::Real, Wide: runtime::Row<Scalar>>(
            parameters: &Self::Parameters<Scalar>,
            q_i: [Wide; 3],
            q_j: [Wide; 3],
            constants_i: [Wide; 1],
            constants_j: [Wide; 1],
            _time: f64,
        ) -> Wide {
            let masses_of_i = constants_i[0];
            let masses_of_j = constants_j[0];
            let shared_0 = q_i[0] - q_j[0];
            let shared_1 = q_i[1] - q_j[1];
            let shared_2 = q_i[2] - q_j[2];
            -(masses_of_i * masses_of_j)
                .div_sqrt(
                    shared_2.square_add(shared_1.square_add(shared_0.square()))
                        + Wide::splat(parameters.softening),
                )
        }
    }
    impl runtime::BodyConstants<1> for Parameters<f64> {
        #[inline]
        fn body_constants(&self, k_2: usize) -> [f64; 1] {
            [self.masses[k_2]]
        }
        #[inline]
        fn acting(&self, bodies: usize) -> usize {
            ::core::cmp::Ord::min(self.prepared_2, bodies)
        }
    }
    #[automatically_derived]
    impl runtime::QuadraticKinetic for Cluster {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let bodies = motion;
            let motion = &mut bodies.plain::<Self::Coords>();
            let mut gradient = runtime::repeated(motion.q.len(), Scalar::of(0.0));
            for i in 0..motion.parameters.prepared_2 {
                let condition_0 = <Scalar::Mask as runtime::Mask>::of((0) < (i));
                if condition_0.any() {
                    for j in 0..i {
                        let shared_3 = motion.parameters.masses_2[i]
                            * motion.parameters.masses_3[j];
                        let mut sum_0 = Scalar::of(0.0);
                        let mut sum_1 = Scalar::of(0.0);
                        for k in 0..3 {
                            let shared_0 = motion.q[(3 * i) + k].value();
                            let shared_1 = motion.q[(3 * j) + k].value();
                            let shared_2 = shared_0 - shared_1;
                            let shared_4 = motion.p[(3 * i) + k].value();
                            let shared_5 = motion.p[(3 * j) + k].value();
                            let shared_6 = shared_4 - shared_5;
                            sum_1 = shared_2.square_add(sum_1);
                            sum_0 = shared_2.fma(shared_6, sum_0);
                        }
                        let shared_7 = sum_1 + motion.parameters.softening;
                        let shared_8 = Scalar::of(1.0) / shared_7.sqrt();
                        let shared_9 = shared_8.square();
                        let shared_10 = Scalar::of(1.0) / shared_7;
                        let shared_11 = shared_10.sqrt();
                        let shared_12 = shared_3.scale(shared_9) * shared_11;
                        let shared_13 = (shared_3.scale(shared_11) * sum_0
                            * (shared_9 * shared_8))
                            .fma(
                                shared_11,
                                (motion.parameters.prepared_5[i]
                                    * motion.parameters.masses_3[j])
                                    .scale(shared_9) * sum_0 * (shared_10 * shared_11),
                            );
                        for k in 0..3 {
                            let shared_0 = motion.q[(3 * i) + k].value();
                            let shared_1 = motion.q[(3 * j) + k].value();
                            let shared_2 = shared_0 - shared_1;
                            let shared_4 = motion.p[(3 * i) + k].value();
                            let shared_5 = motion.p[(3 * j) + k].value();
                            let shared_6 = shared_4 - shared_5;
                            let shared_14 = (-Scalar::of(2.0).scale(shared_2))
                                .fma(shared_13, shared_12 * shared_6);
                            gradient[(3 * i) + k] = Scalar::select(
                                condition_0,
                                gradient[(3 * i) + k] + shared_14,
                                gradient[(3 * i) + k],
                            );
                            gradient[(3 * j) + k] = Scalar::select(
                                condition_0,
                                gradient[(3 * j) + k] - shared_14,
                                gradient[(3 * j) + k],
                            );
                        }
                    }
                }
            }
            for (slot, gradient) in ::core::iter::zip(motion.p.iter_mut(), &gradient) {
                (*slot) = *gradient;
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
    impl runtime::TimeTransformed for Cluster {
        #[inline(always)]
        fn kinetic_plus<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
            more: Scalar,
        ) -> Scalar {
            let time = more;
            let mut sum_0 = Scalar::of(0.0);
            for k in 0..motion.q.len() {
                let p_k = motion.p[k].value();
                sum_0 = Scalar::of(0.5).scale_add(p_k.square(), sum_0);
            }
            sum_0 + time
        }
        #[inline(always)]
        fn potential_of<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
        ) -> Scalar {
            let mut sum_2 = Scalar::of(0.0);
            for i in 0..motion.parameters.prepared_2 {
                let condition_0 = <Scalar::Mask as runtime::Mask>::of((0) < (i));
                if condition_0.any() {
                    let mut sum_1 = Scalar::of(0.0);
                    for j in 0..i {
                        let mut sum_0 = Scalar::of(0.0);
                        for k in 0..3 {
                            let shared_0 = motion.q[(3 * i) + k].value()
                                - motion.q[(3 * j) + k].value();
                            sum_0 = shared_0.square_add(sum_0);
                        }
                        sum_1
                            += motion.parameters.masses_2[i]
                                * motion.parameters.masses_3[j]
                                / (sum_0 + motion.parameters.softening).sqrt();
                    }
                    sum_2 = Scalar::select(condition_0, sum_2 + sum_1, sum_2);
                }
            }
            -sum_2
        }
        #[inline(always)]
        fn kick_for<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) {
            let step = -duration;
            let mut gradient = runtime::repeated(motion.q.len(), Scalar::of(0.0));
            for i in 0..motion.parameters.prepared_2 {
                let condition_0 = <Scalar::Mask as runtime::Mask>::of((0) < (i));
                if condition_0.any() {
                    for j in 0..i {
                        let mut sum_0 = Scalar::of(0.0);
                        for k in 0..3 {
                            let shared_0 = motion.q[(3 * i) + k].value();
                            let shared_1 = motion.q[(3 * j) + k].value();
                            let shared_2 = shared_0 - shared_1;
                            sum_0 = shared_2.square_add(sum_0);
                        }
                        let shared_3 = (sum_0 + motion.parameters.softening).sqrt();
                        let shared_4 = motion.parameters.masses_2[i]
                            * motion.parameters.masses_3[j] / shared_3.square()
                            / shared_3;
                        for k in 0..3 {
                            let shared_0 = motion.q[(3 * i) + k].value();
                            let shared_1 = motion.q[(3 * j) + k].value();
                            let shared_2 = shared_0 - shared_1;
                            let shared_5 = shared_4 * shared_2;
                            gradient[(3 * i) + k] = Scalar::select(
                                condition_0,
                                gradient[(3 * i) + k] + shared_5,
                                gradient[(3 * i) + k],
                            );
                            gradient[(3 * j) + k] = Scalar::select(
                                condition_0,
                                gradient[(3 * j) + k] - shared_5,
                                gradient[(3 * j) + k],
                            );
                        }
                    }
                }
            }
            for (slot, gradient) in ::core::iter::zip(motion.p.iter_mut(), &gradient) {
                (*slot).fma(step, *gradient);
            }
        }
        #[inline(always)]
        fn drift_for<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) {
            let step = duration;
            {
                let motion = &mut runtime::in_place(
                    &mut motion.q,
                    &mut motion.p,
                    &motion.parameters,
                );
                for k in 0..motion.q.len() {
                    motion.q[k].fma(step, motion.p[k].value());
                }
            }
        }
        #[inline(always)]
        fn logarithmic_kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) -> Scalar {
            let step = -duration;
            let mut gradient = runtime::repeated(motion.q.len(), Scalar::of(0.0));
            let energy = {
                let mut sum_2 = Scalar::of(0.0);
                for i in 0..motion.parameters.prepared_2 {
                    let condition_0 = <Scalar::Mask as runtime::Mask>::of((0) < (i));
                    if condition_0.any() {
                        let mut sum_1 = Scalar::of(0.0);
                        for j in 0..i {
                            let shared_3 = motion.parameters.masses_2[i]
                                * motion.parameters.masses_3[j];
                            let mut sum_0 = Scalar::of(0.0);
                            for k in 0..3 {
                                let shared_0 = motion.q[(3 * i) + k].value();
                                let shared_1 = motion.q[(3 * j) + k].value();
                                let shared_2 = shared_0 - shared_1;
                                sum_0 = shared_2.square_add(sum_0);
                            }
                            let shared_4 = (sum_0 + motion.parameters.softening).sqrt();
                            let shared_5 = shared_3 / shared_4.square() / shared_4;
                            for k in 0..3 {
                                let shared_0 = motion.q[(3 * i) + k].value();
                                let shared_1 = motion.q[(3 * j) + k].value();
                                let shared_2 = shared_0 - shared_1;
                                let shared_6 = shared_5 * shared_2;
                                gradient[(3 * i) + k] = Scalar::select(
                                    condition_0,
                                    gradient[(3 * i) + k] + shared_6,
                                    gradient[(3 * i) + k],
                                );
                                gradient[(3 * j) + k] = Scalar::select(
                                    condition_0,
                                    gradient[(3 * j) + k] - shared_6,
                                    gradient[(3 * j) + k],
                                );
                            }
                            sum_1 += shared_3 / shared_4;
                        }
                        sum_2 = Scalar::select(condition_0, sum_2 + sum_1, sum_2);
                    }
                }
                -sum_2
            };
            let step = step / -energy;
            for (slot, gradient) in ::core::iter::zip(motion.p.iter_mut(), &gradient) {
                (*slot).fma(step, *gradient);
            }
            energy
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Cluster {}
};
