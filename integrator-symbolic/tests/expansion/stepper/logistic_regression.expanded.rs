#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        prepared_0: usize,
        /// `covariates[row][k]`
        covariates: runtime::SharedTable<runtime::SharedTable<Scalar>>,
        /// `outcomes[row]`
        outcomes: runtime::SharedTable<Scalar>,
    }
    impl Parameters<f64> {
        fn covariates(&self) -> &runtime::SharedTable<runtime::SharedTable<f64>> {
            &self.covariates
        }
        fn outcomes(&self) -> &runtime::SharedTable<f64> {
            &self.outcomes
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                prepared_0: ::core::clone::Clone::clone(&members[0].prepared_0),
                covariates: runtime::in_lanes(members, Parameters::covariates),
                outcomes: runtime::in_lanes(members, Parameters::outcomes),
            }
        }
        #[inline]
        fn alike(a: &Self::Single, b: &Self::Single) -> bool {
            a.prepared_0 == b.prepared_0 && a.covariates.len() == b.covariates.len()
                && a.outcomes.len() == b.outcomes.len()
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite(
                        "covariates[row][k]",
                        &["row", "k"],
                        &single.covariates,
                    ),
                    runtime::not_finite("outcomes[row]", &["row"], &single.outcomes),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.prepared_0);
            digest.add(&single.covariates);
            digest.add(&single.outcomes);
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[k]/dt = p[k]   for k in 0..n
    /// dp[0]/dt += Σ_{row in 0..outcomes.len()} (outcomes[row] - 1 / (1 + min(exp(-q[0] - Σ_{k in 0..n - 1} covariates[row][k] q[k + 1]), 2^896)))
    /// dp[k + 1]/dt += covariates[row][k] (outcomes[row] - 1 / (1 + min(exp(-q[0] - Σ_{k in 0..n - 1} covariates[row][k] q[k + 1]), 2^896)))   for row in 0..outcomes.len(), k in 0..n - 1
    /// ```
    ///
    /// `T` is quadratic in the momenta, with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for Regression {
        type Compose = McLachlan2;
        const EQUATIONS: &'static [&'static str] = &[
            "T = Σ_{k in 0..n} p[k]^2 / 2",
            "V = Σ_{row in 0..outcomes.len()} (-outcomes[row] (q[0] + Σ_{k in 0..n - 1} covariates[row][k] q[k + 1]) + ln_1p(exp(q[0] + Σ_{k in 0..n - 1} covariates[row][k] q[k + 1])))",
            "dq[k]/dt = p[k]   for k in 0..n",
            "dp[0]/dt += Σ_{row in 0..outcomes.len()} (outcomes[row] - 1 / (1 + min(exp(-q[0] - Σ_{k in 0..n - 1} covariates[row][k] q[k + 1]), 2^896)))",
            "dp[k + 1]/dt += covariates[row][k] (outcomes[row] - 1 / (1 + min(exp(-q[0] - Σ_{k in 0..n - 1} covariates[row][k] q[k + 1]), 2^896)))   for row in 0..outcomes.len(), k in 0..n - 1",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Regression {
        type Coords = runtime::Vec<f64>;
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 17047453406997080154;
        const LARGE_FLOWS: bool = true;
        const LAYOUT: &'static [&'static str] = &["line", "lanes"];
        const ENERGIES_IN_LANES: bool = true;
        fn admissible(
            &self,
            length: usize,
        ) -> ::core::result::Result<(), runtime::Error> {
            runtime::are_at_least(1, length)
        }
        fn parameters(&self, length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: self.outcomes.len(),
                covariates: runtime::table(
                    (self.outcomes.len()),
                    &|row: usize| runtime::table(
                        length.saturating_sub(1),
                        &|k: usize| self.covariates[row][k],
                    ),
                ),
                outcomes: runtime::table(
                    (self.outcomes.len()),
                    &|row: usize| self.outcomes[row],
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
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            let mut gradient = runtime::repeated(motion.q.len(), Scalar::of(0.0));
            let q0 = motion.q[0].value();
            let mut kept = [
                runtime::repeated(motion.parameters.prepared_0, Scalar::of(0.0)),
            ];
            runtime::inner_products(
                &motion.parameters.covariates[..],
                0..motion.q.len().saturating_sub(1),
                1,
                motion.q.as_chunks::<1>().0,
                &mut kept[0],
            );
            let mut results = [
                runtime::repeated(motion.parameters.prepared_0, Scalar::of(0.0)),
            ];
            let [sum_1] = {
                struct Iteration;
                impl runtime::Iteration<0, 2, 1, 1, 1, 1> for Iteration {
                    const READS: [runtime::Near; 0] = [];
                    #[inline(always)]
                    fn next<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
                        []: [[Wide; 1]; 0],
                        [constant_0,
                        sum_0,
                        ]: [Wide; 2],
                        [q0,
                        ]: [Wide; 1],
                        [mut sum_1,
                        ]: [Wide; 1],
                        [mut gradient,
                        ]: [[Wide; 1]; 1],
                    ) -> ([Wide; 1], [[Wide; 1]; 1]) {
                        let shared_0 = Wide::of(1.0)
                            / ((-(q0 + sum_0)).exp().min(Wide::huge()) + Wide::of(1.0))
                            - constant_0;
                        sum_1 += shared_0;
                        gradient[0] = shared_0;
                        ([sum_1], [gradient])
                    }
                }
                runtime::Loop {
                    range: 0..motion.parameters.prepared_0,
                    parts: [motion.q.as_chunks::<1>().0],
                    constants: [&motion.parameters.outcomes[..], &kept[0][..]],
                    common: [q0],
                }
                    .run_apart::<
                        Iteration,
                        _,
                        _,
                        _,
                    >(
                        &mut {
                            let [results_0] = &mut results;
                            [results_0.as_chunks_mut::<1>().0]
                        },
                    )
            };
            runtime::add_multiples_of_rows(
                &motion.parameters.covariates[..],
                0..motion.q.len().saturating_sub(1),
                1,
                &results[0],
                gradient.as_chunks_mut::<1>().0,
            );
            gradient[0] += sum_1;
            for (slot, gradient) in ::core::iter::zip(motion.p.iter_mut(), &gradient) {
                (*slot).scale_add(step, *gradient);
            }
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let [sum_0] = {
                struct Iteration;
                impl runtime::Iteration<1, 0, 0, 1, 0, 1> for Iteration {
                    const READS: [runtime::Near; 1] = [
                        runtime::Near {
                            part: 0,
                            offset: 0,
                        },
                    ];
                    #[inline(always)]
                    fn next<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
                        [[p_k,
                        ],
                        ]: [[Wide; 1]; 1],
                        []: [Wide; 0],
                        []: [Wide; 0],
                        [mut sum_0,
                        ]: [Wide; 1],
                        []: [[Wide; 1]; 0],
                    ) -> ([Wide; 1], [[Wide; 1]; 0]) {
                        sum_0 = Wide::of(0.5).scale_add(p_k.square(), sum_0);
                        ([sum_0], [])
                    }
                }
                runtime::Loop {
                    range: 0..motion.q.len(),
                    parts: [motion.p.as_chunks::<1>().0],
                    constants: [],
                    common: [],
                }
                    .run::<Iteration, _, _, _>(&mut [])
            };
            sum_0
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            let mut kept = [
                runtime::repeated(motion.parameters.prepared_0, Scalar::of(0.0)),
            ];
            runtime::inner_products(
                &motion.parameters.covariates[..],
                0..motion.q.len().saturating_sub(1),
                1,
                motion.q.as_chunks::<1>().0,
                &mut kept[0],
            );
            let [sum_1] = {
                struct Iteration;
                impl runtime::Iteration<0, 2, 1, 1, 0, 1> for Iteration {
                    const READS: [runtime::Near; 0] = [];
                    #[inline(always)]
                    fn next<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
                        []: [[Wide; 1]; 0],
                        [constant_0,
                        sum_0,
                        ]: [Wide; 2],
                        [q0,
                        ]: [Wide; 1],
                        [mut sum_1,
                        ]: [Wide; 1],
                        []: [[Wide; 1]; 0],
                    ) -> ([Wide; 1], [[Wide; 1]; 0]) {
                        let shared_0 = q0 + sum_0;
                        sum_1
                            += (-constant_0).scale_add(shared_0, shared_0.exp().ln_1p());
                        ([sum_1], [])
                    }
                }
                runtime::Loop {
                    range: 0..motion.parameters.prepared_0,
                    parts: [motion.q.as_chunks::<1>().0],
                    constants: [&motion.parameters.outcomes[..], &kept[0][..]],
                    common: [q0],
                }
                    .run::<Iteration, _, _, _>(&mut [])
            };
            sum_1
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
    impl runtime::QuadraticKinetic for Regression {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = runtime::repeated(motion.q.len(), Scalar::of(0.0));
            let q0 = motion.q[0].value();
            let condition_0 = <Scalar::Mask as runtime::Mask>::of(
                (0) < (motion.q.len().saturating_sub(1)),
            );
            let condition_1 = <Scalar::Mask as runtime::Mask>::of(
                    (0) < (motion.parameters.prepared_0),
                )
                .and(condition_0);
            if condition_1.any() {
                let mut sum_2 = Scalar::of(0.0);
                if condition_0.any() {
                    for row in 0..motion.parameters.prepared_0 {
                        let mut sum_0 = Scalar::of(0.0);
                        for k in 0..motion.q.len().saturating_sub(1) {
                            let shared_0 = motion.q[k + 1].value();
                            let shared_1 = motion
                                .parameters
                                .covariates[row][k]
                                .scale(shared_0);
                            sum_0 += shared_1;
                        }
                        let shared_2 = q0 + sum_0;
                        let shared_3 = (-shared_2).exp();
                        let shared_4 = shared_3.min(Scalar::huge());
                        let shared_5 = shared_4 + Scalar::of(1.0);
                        let shared_8 = shared_5.square();
                        let condition_2 = Scalar::huge().less(shared_8);
                        let mut choice_0 = Scalar::of(0.0);
                        if condition_2.not().any() {
                            let shared_9 = Scalar::of(1.0) / shared_8;
                            let [sum_1] = {
                                struct Iteration;
                                impl runtime::Iteration<1, 1, 0, 1, 0, 1> for Iteration {
                                    const READS: [runtime::Near; 1] = [
                                        runtime::Near {
                                            part: 0,
                                            offset: 1,
                                        },
                                    ];
                                    #[inline(always)]
                                    fn next<
                                        Scalar: runtime::Real,
                                        Wide: runtime::Block<Scalar>,
                                    >(
                                        [[shared_6,
                                        ],
                                        ]: [[Wide; 1]; 1],
                                        [constant_0,
                                        ]: [Wide; 1],
                                        []: [Wide; 0],
                                        [mut sum_1,
                                        ]: [Wide; 1],
                                        []: [[Wide; 1]; 0],
                                    ) -> ([Wide; 1], [[Wide; 1]; 0]) {
                                        let shared_7 = constant_0.scale(shared_6);
                                        sum_1 += shared_7;
                                        ([sum_1], [])
                                    }
                                }
                                runtime::Loop {
                                    range: 0..motion.q.len().saturating_sub(1),
                                    parts: [motion.p.as_chunks::<1>().0],
                                    constants: [&motion.parameters.covariates[row][..]],
                                    common: [],
                                }
                                    .run::<Iteration, _, _, _>(&mut [])
                            };
                            let shared_10 = sum_1 * shared_9;
                            let shared_11 = shared_10 * shared_3;
                            choice_0 = Scalar::select(
                                condition_2.not(),
                                -shared_11,
                                choice_0,
                            );
                        }
                        sum_2 = Scalar::select(condition_0, sum_2 - choice_0, sum_2);
                    }
                }
                gradient[0] = Scalar::select(
                    condition_1,
                    gradient[0] + sum_2,
                    gradient[0],
                );
            }
            let mut sum_3 = Scalar::of(0.0);
            for row in 0..motion.parameters.prepared_0 {
                let mut sum_0 = Scalar::of(0.0);
                for k in 0..motion.q.len().saturating_sub(1) {
                    let shared_0 = motion.q[k + 1].value();
                    let shared_1 = motion.parameters.covariates[row][k].scale(shared_0);
                    sum_0 += shared_1;
                }
                let shared_2 = q0 + sum_0;
                let shared_3 = (-shared_2).exp();
                let shared_4 = shared_3.min(Scalar::huge());
                let shared_5 = shared_4 + Scalar::of(1.0);
                let shared_8 = shared_5.square();
                let condition_2 = Scalar::huge().less(shared_8);
                if condition_0.any() {
                    let mut choice_0 = Scalar::of(0.0);
                    if condition_2.not().any() {
                        let shared_9 = Scalar::of(1.0) / shared_8;
                        let [sum_1] = {
                            struct Iteration;
                            impl runtime::Iteration<1, 1, 0, 1, 0, 1> for Iteration {
                                const READS: [runtime::Near; 1] = [
                                    runtime::Near {
                                        part: 0,
                                        offset: 1,
                                    },
                                ];
                                #[inline(always)]
                                fn next<
                                    Scalar: runtime::Real,
                                    Wide: runtime::Block<Scalar>,
                                >(
                                    [[shared_6,
                                    ],
                                    ]: [[Wide; 1]; 1],
                                    [constant_0,
                                    ]: [Wide; 1],
                                    []: [Wide; 0],
                                    [mut sum_1,
                                    ]: [Wide; 1],
                                    []: [[Wide; 1]; 0],
                                ) -> ([Wide; 1], [[Wide; 1]; 0]) {
                                    let shared_7 = constant_0.scale(shared_6);
                                    sum_1 += shared_7;
                                    ([sum_1], [])
                                }
                            }
                            runtime::Loop {
                                range: 0..motion.q.len().saturating_sub(1),
                                parts: [motion.p.as_chunks::<1>().0],
                                constants: [&motion.parameters.covariates[row][..]],
                                common: [],
                            }
                                .run::<Iteration, _, _, _>(&mut [])
                        };
                        let shared_10 = sum_1 * shared_9;
                        let shared_11 = shared_10 * shared_3;
                        choice_0 = Scalar::select(
                            condition_2.not(),
                            -shared_11,
                            choice_0,
                        );
                    }
                    for k in 0..motion.q.len().saturating_sub(1) {
                        gradient[k + 1] = Scalar::select(
                            condition_0,
                            (-motion.parameters.covariates[row][k])
                                .scale_add(choice_0, gradient[k + 1]),
                            gradient[k + 1],
                        );
                    }
                }
                let mut choice_1 = Scalar::of(0.0);
                if condition_2.not().any() {
                    let shared_9 = Scalar::of(1.0) / shared_8;
                    let shared_12 = motion.p[0].value() * shared_9 * shared_3;
                    sum_3 = Scalar::select(condition_2.not(), sum_3 - shared_12, sum_3);
                    choice_1 = Scalar::select(condition_2.not(), -shared_12, choice_1);
                }
                {
                    struct Iteration;
                    impl runtime::Iteration<0, 1, 1, 0, 1, 1> for Iteration {
                        const READS: [runtime::Near; 0] = [];
                        const TARGET: isize = 1;
                        #[inline(always)]
                        fn next<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
                            []: [[Wide; 1]; 0],
                            [constant_0,
                            ]: [Wide; 1],
                            [choice_1,
                            ]: [Wide; 1],
                            []: [Wide; 0],
                            [mut gradient,
                            ]: [[Wide; 1]; 1],
                        ) -> ([Wide; 0], [[Wide; 1]; 1]) {
                            gradient[0] = (-constant_0).scale_add(choice_1, gradient[0]);
                            ([], [gradient])
                        }
                    }
                    runtime::Loop {
                        range: 0..motion.q.len().saturating_sub(1),
                        parts: [motion.q.as_chunks::<1>().0],
                        constants: [&motion.parameters.covariates[row][..]],
                        common: [choice_1],
                    }
                        .run::<Iteration, _, _, _>(gradient.as_chunks_mut::<1>().0);
                }
            }
            gradient[0] -= sum_3;
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
    impl runtime::TimeTransformed for Regression {
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
                let q0 = motion.q[0].value();
                let mut kept = [
                    runtime::repeated(motion.parameters.prepared_0, Scalar::of(0.0)),
                ];
                runtime::inner_products(
                    &motion.parameters.covariates[..],
                    0..motion.q.len().saturating_sub(1),
                    1,
                    motion.q.as_chunks::<1>().0,
                    &mut kept[0],
                );
                let mut results = [
                    runtime::repeated(motion.parameters.prepared_0, Scalar::of(0.0)),
                ];
                let [sum_2, sum_1] = {
                    struct Iteration;
                    impl runtime::Iteration<0, 2, 1, 2, 1, 1> for Iteration {
                        const READS: [runtime::Near; 0] = [];
                        #[inline(always)]
                        fn next<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
                            []: [[Wide; 1]; 0],
                            [constant_0,
                            sum_0,
                            ]: [Wide; 2],
                            [q0,
                            ]: [Wide; 1],
                            [mut sum_2,
                            mut sum_1,
                            ]: [Wide; 2],
                            [mut gradient,
                            ]: [[Wide; 1]; 1],
                        ) -> ([Wide; 2], [[Wide; 1]; 1]) {
                            let shared_0 = q0 + sum_0;
                            let shared_1 = Wide::of(1.0)
                                / ((-shared_0).exp().min(Wide::huge()) + Wide::of(1.0))
                                - constant_0;
                            sum_2 += shared_1;
                            sum_1
                                += (-constant_0)
                                    .scale_add(shared_0, shared_0.exp().ln_1p());
                            gradient[0] = shared_1;
                            ([sum_2, sum_1], [gradient])
                        }
                    }
                    runtime::Loop {
                        range: 0..motion.parameters.prepared_0,
                        parts: [motion.q.as_chunks::<1>().0],
                        constants: [&motion.parameters.outcomes[..], &kept[0][..]],
                        common: [q0],
                    }
                        .run_apart::<
                            Iteration,
                            _,
                            _,
                            _,
                        >(
                            &mut {
                                let [results_0] = &mut results;
                                [results_0.as_chunks_mut::<1>().0]
                            },
                        )
                };
                runtime::add_multiples_of_rows(
                    &motion.parameters.covariates[..],
                    0..motion.q.len().saturating_sub(1),
                    1,
                    &results[0],
                    gradient.as_chunks_mut::<1>().0,
                );
                gradient[0] += sum_2;
                sum_1
            };
            let step = step / -energy;
            for (slot, gradient) in ::core::iter::zip(motion.p.iter_mut(), &gradient) {
                (*slot).fma(step, *gradient);
            }
            energy
        }
    }
    /// What every site computes from its neighbourhood, for itself and for the sites ahead.
    #[automatically_derived]
    impl runtime::Stencil<runtime::Drift> for Regression {
        type Contributions<Wide: ::core::marker::Copy> = [Wide; 1];
        const BOUNDARY: runtime::Boundary = runtime::Boundary {
            first: 0,
            last: 0,
            forward: 0,
            behind: 0,
            ahead: 0,
            periodic: false,
        };
        #[inline(always)]
        fn contributions<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
            window: &runtime::Window<Scalar, Wide>,
            _parameters: &Self::Parameters<Scalar>,
            _time: f64,
        ) -> [Wide; 1] {
            let contribution_0 = window.at(0);
            [contribution_0]
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Regression {}
};
