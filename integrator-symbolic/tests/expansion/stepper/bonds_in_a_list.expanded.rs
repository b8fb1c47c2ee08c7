#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        prepared_0: usize,
        /// `stiffness[k]`
        prepared_1: runtime::SharedTable<Scalar>,
        /// `reach`
        reach: Scalar,
        prepared_3: runtime::SharedTable<usize>,
        prepared_4: runtime::SharedTable<usize>,
        prepared_5: usize,
        held: runtime::SharedTable<usize>,
        /// `stiffness[k] / 2`
        prepared_7: runtime::SharedTable<Scalar>,
    }
    impl Parameters<f64> {
        fn prepared_1(&self) -> &runtime::SharedTable<f64> {
            &self.prepared_1
        }
        fn reach(&self) -> &f64 {
            &self.reach
        }
        fn prepared_7(&self) -> &runtime::SharedTable<f64> {
            &self.prepared_7
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                prepared_0: ::core::clone::Clone::clone(&members[0].prepared_0),
                prepared_1: runtime::in_lanes(members, Parameters::prepared_1),
                reach: runtime::in_lanes(members, Parameters::reach),
                prepared_3: ::core::clone::Clone::clone(&members[0].prepared_3),
                prepared_4: ::core::clone::Clone::clone(&members[0].prepared_4),
                prepared_5: ::core::clone::Clone::clone(&members[0].prepared_5),
                held: ::core::clone::Clone::clone(&members[0].held),
                prepared_7: runtime::in_lanes(members, Parameters::prepared_7),
            }
        }
        #[inline]
        fn alike(a: &Self::Single, b: &Self::Single) -> bool {
            a.prepared_0 == b.prepared_0 && a.prepared_1.len() == b.prepared_1.len()
                && a.prepared_3 == b.prepared_3 && a.prepared_4 == b.prepared_4
                && a.prepared_5 == b.prepared_5 && a.held == b.held
                && a.prepared_7.len() == b.prepared_7.len()
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("stiffness[k]", &["k"], &single.prepared_1),
                    runtime::not_finite("reach", &[], &single.reach),
                    runtime::not_finite("stiffness[k] / 2", &["k"], &single.prepared_7),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.prepared_0);
            digest.add(&single.prepared_1);
            digest.add(&single.reach);
            digest.add(&single.prepared_3);
            digest.add(&single.prepared_4);
            digest.add(&single.prepared_5);
            digest.add(&single.held);
            digest.add(&single.prepared_7);
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[k][0]/dt = p[k][0]   for k in 0..n
    /// dq[k][1]/dt = p[k][1]   for k in 0..n
    /// dp[bonds[k].0][0]/dt += {-u2_k if u1_k < reach, else 0}   for k in 0..bonds.len()
    /// dp[bonds[k].1][0]/dt += {u2_k if u1_k < reach, else 0}   for k in 0..bonds.len()
    /// dp[bonds[k].0][1]/dt += {-u3_k if u1_k < reach, else 0}   for k in 0..bonds.len()
    /// dp[bonds[k].1][1]/dt += {u3_k if u1_k < reach, else 0}   for k in 0..bonds.len()
    /// dp[held[k]][1]/dt += sin(q[held[k]][1])   for k in 0..held.len()
    /// where u1_k = hypot(q[bonds[k].0][0] - q[bonds[k].1][0], q[bonds[k].0][1] - q[bonds[k].1][1])
    /// where u2_k = stiffness[k] (u1_k - 1) (q[bonds[k].0][0] - q[bonds[k].1][0]) / u1_k
    /// where u3_k = stiffness[k] (u1_k - 1) (q[bonds[k].0][1] - q[bonds[k].1][1]) / u1_k
    /// ```
    ///
    /// `T` is quadratic in the momenta, with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for Network {
        type Compose = runtime::Verlet;
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Network {
        type Coords = runtime::Vec<[f64; 2]>;
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 14744438705857641148;
        const WIDE: bool = true;
        const LARGE_FLOWS: bool = true;
        const LAYOUT: &'static [&'static str] = &["plain", "terms"];
        const ENERGIES_IN_LANES: bool = true;
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: self.bonds.len(),
                prepared_1: runtime::table(
                    (self.bonds.len()),
                    &|k: usize| 2.0 * (0.5 * self.stiffness[k]),
                ),
                reach: self.reach,
                prepared_3: runtime::table(
                    (self.bonds.len()),
                    &|k: usize| self.bonds[k].0,
                ),
                prepared_4: runtime::table(
                    (self.bonds.len()),
                    &|k: usize| self.bonds[k].1,
                ),
                prepared_5: self.held.len(),
                held: runtime::table((self.held.len()), &|k: usize| self.held[k]),
                prepared_7: runtime::table(
                    (self.bonds.len()),
                    &|k: usize| 0.5 * self.stiffness[k],
                ),
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            {
                let motion = &mut runtime::in_place(
                    &mut motion.q,
                    &mut motion.p,
                    &motion.parameters,
                );
                for k in 0..motion.q.len() {
                    motion.q[k][0].scale_add(step, motion.p[k][0].value());
                    motion.q[k][1].scale_add(step, motion.p[k][1].value());
                }
            }
        }
        #[inline(always)]
        fn kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            let mut gradient = runtime::repeated(motion.q.len(), [Scalar::of(0.0); 2]);
            {
                struct Iteration;
                impl runtime::Term<2, 1, 1, 4, 2> for Iteration {
                    const READS: [runtime::Read; 2] = [
                        runtime::Read { part: 0, list: 0 },
                        runtime::Read { part: 0, list: 1 },
                    ];
                    const ADDENDS: &'static [runtime::Addend] = &[
                        runtime::Addend {
                            list: 0,
                            component: 0,
                            value: 0,
                            negative: false,
                        },
                        runtime::Addend {
                            list: 1,
                            component: 0,
                            value: 1,
                            negative: true,
                        },
                        runtime::Addend {
                            list: 0,
                            component: 1,
                            value: 2,
                            negative: false,
                        },
                        runtime::Addend {
                            list: 1,
                            component: 1,
                            value: 3,
                            negative: true,
                        },
                    ];
                    #[inline(always)]
                    fn values<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
                        [[read_0_0,
                        read_0_1,
                        ],
                        [read_1_0,
                        read_1_1,
                        ],
                        ]: [[Wide; 2]; 2],
                        [constant_0,
                        ]: [Wide; 1],
                        [common_0,
                        ]: [Wide; 1],
                    ) -> [Wide; 4] {
                        let mut values = [Wide::of(0.0); 4];
                        let shared_0 = read_0_0 - read_1_0;
                        let shared_1 = read_0_1 - read_1_1;
                        let shared_2 = shared_0.hypot(shared_1);
                        let condition_0 = shared_2.less(common_0);
                        if condition_0.any() {
                            let shared_3 = constant_0.scale(shared_2 + Wide::of(-1.0));
                            let shared_4 = Wide::of(1.0) / shared_2;
                            let shared_5 = shared_3 * (shared_0 * shared_4);
                            let shared_6 = shared_3 * (shared_1 * shared_4);
                            values[0] = Wide::select(
                                condition_0,
                                shared_5,
                                Wide::of(0.0),
                            );
                            values[1] = Wide::select(
                                condition_0,
                                shared_5,
                                Wide::of(0.0),
                            );
                            values[2] = Wide::select(
                                condition_0,
                                shared_6,
                                Wide::of(0.0),
                            );
                            values[3] = Wide::select(
                                condition_0,
                                shared_6,
                                Wide::of(0.0),
                            );
                        }
                        values
                    }
                }
                runtime::Terms {
                    range: 0..motion.parameters.prepared_0,
                    lists: [
                        &motion.parameters.prepared_3[..],
                        &motion.parameters.prepared_4[..],
                    ],
                    parts: [&motion.q[..]],
                    constants: [&motion.parameters.prepared_1[..]],
                    common: [motion.parameters.reach],
                }
                    .add_to::<Iteration, _, _>(&mut gradient[..]);
            }
            {
                struct Iteration;
                impl runtime::Term<1, 0, 0, 1, 2> for Iteration {
                    const READS: [runtime::Read; 1] = [
                        runtime::Read { part: 0, list: 0 },
                    ];
                    const ADDENDS: &'static [runtime::Addend] = &[
                        runtime::Addend {
                            list: 0,
                            component: 1,
                            value: 0,
                            negative: true,
                        },
                    ];
                    #[inline(always)]
                    fn values<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
                        [[_,
                        read_0_1,
                        ],
                        ]: [[Wide; 2]; 1],
                        []: [Wide; 0],
                        []: [Wide; 0],
                    ) -> [Wide; 1] {
                        let mut values = [Wide::of(0.0); 1];
                        values[0] = read_0_1.sin();
                        values
                    }
                }
                runtime::Terms {
                    range: 0..motion.parameters.prepared_5,
                    lists: [&motion.parameters.held[..]],
                    parts: [&motion.q[..]],
                    constants: [],
                    common: [],
                }
                    .add_to::<Iteration, _, _>(&mut gradient[..]);
            }
            for (slot, gradient) in ::core::iter::zip(motion.p.iter_mut(), &gradient) {
                for (slot, gradient) in ::core::iter::zip(slot, gradient) {
                    (*slot).scale_add(step, *gradient);
                }
            }
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let [sum_0] = {
                struct Iteration;
                impl runtime::Iteration<1, 0, 0, 1, 0, 2> for Iteration {
                    const READS: [runtime::Near; 1] = [
                        runtime::Near {
                            part: 0,
                            offset: 0,
                        },
                    ];
                    #[inline(always)]
                    fn next<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
                        [[p_k_0,
                        p_k_1,
                        ],
                        ]: [[Wide; 2]; 1],
                        []: [Wide; 0],
                        []: [Wide; 0],
                        [mut sum_0,
                        ]: [Wide; 1],
                        []: [[Wide; 2]; 0],
                    ) -> ([Wide; 1], [[Wide; 2]; 0]) {
                        sum_0 += p_k_1.square_add(p_k_0.square());
                        ([sum_0], [])
                    }
                }
                runtime::Loop {
                    range: 0..motion.q.len(),
                    parts: [&motion.p[..]],
                    constants: [],
                    common: [],
                }
                    .run::<Iteration, _, _, _>(&mut [])
            };
            Scalar::of(0.5).scale(sum_0)
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let mut sum_1 = Scalar::of(0.0);
            for k in 0..motion.parameters.prepared_0 {
                let shared_0 = (motion.q[motion.parameters.prepared_3[k]][0].value()
                    - motion.q[motion.parameters.prepared_4[k]][0].value())
                    .hypot(
                        motion.q[motion.parameters.prepared_3[k]][1].value()
                            - motion.q[motion.parameters.prepared_4[k]][1].value(),
                    );
                let condition_0 = shared_0.less(motion.parameters.reach);
                if condition_0.any() {
                    let shared_1 = shared_0 + Scalar::of(-1.0);
                    sum_1 = Scalar::select(
                        condition_0,
                        motion
                            .parameters
                            .prepared_7[k]
                            .scale_add(shared_1.square(), sum_1),
                        sum_1,
                    );
                }
            }
            let mut sum_0 = Scalar::of(0.0);
            for k in 0..motion.parameters.prepared_5 {
                sum_0 += motion.q[motion.parameters.held[k]][1].value().cos();
            }
            sum_1 + sum_0
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
    impl runtime::QuadraticKinetic for Network {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = runtime::repeated(motion.q.len(), [Scalar::of(0.0); 2]);
            {
                struct Iteration;
                impl runtime::Term<4, 1, 1, 4, 2> for Iteration {
                    const READS: [runtime::Read; 4] = [
                        runtime::Read { part: 0, list: 0 },
                        runtime::Read { part: 0, list: 1 },
                        runtime::Read { part: 1, list: 0 },
                        runtime::Read { part: 1, list: 1 },
                    ];
                    const ADDENDS: &'static [runtime::Addend] = &[
                        runtime::Addend {
                            list: 0,
                            component: 0,
                            value: 0,
                            negative: false,
                        },
                        runtime::Addend {
                            list: 1,
                            component: 0,
                            value: 1,
                            negative: true,
                        },
                        runtime::Addend {
                            list: 0,
                            component: 1,
                            value: 2,
                            negative: false,
                        },
                        runtime::Addend {
                            list: 1,
                            component: 1,
                            value: 3,
                            negative: true,
                        },
                    ];
                    #[inline(always)]
                    fn values<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
                        [[read_0_0,
                        read_0_1,
                        ],
                        [read_1_0,
                        read_1_1,
                        ],
                        [read_2_0,
                        read_2_1,
                        ],
                        [read_3_0,
                        read_3_1,
                        ],
                        ]: [[Wide; 2]; 4],
                        [constant_0,
                        ]: [Wide; 1],
                        [common_0,
                        ]: [Wide; 1],
                    ) -> [Wide; 4] {
                        let mut values = [Wide::of(0.0); 4];
                        let shared_0 = read_0_0 - read_1_0;
                        let shared_1 = read_0_1 - read_1_1;
                        let shared_2 = shared_0.hypot(shared_1);
                        let condition_0 = shared_2.less(common_0);
                        if condition_0.any() {
                            let shared_3 = constant_0.scale(shared_2 + Wide::of(-1.0));
                            let shared_4 = Wide::of(1.0) / shared_2;
                            let shared_5 = shared_0 * shared_4;
                            let shared_6 = shared_1 * shared_4;
                            let shared_7 = read_2_1 - read_3_1;
                            let shared_8 = read_2_0 - read_3_0;
                            let shared_9 = shared_3 * shared_7;
                            let shared_10 = shared_3 * shared_8;
                            let shared_11 = (-shared_10
                                .fma(shared_0, shared_9 * shared_1))
                                .fma(
                                    shared_4.square(),
                                    constant_0
                                        .scale(shared_5.fma(shared_8, shared_6 * shared_7)),
                                );
                            let shared_12 = shared_5
                                .fma(shared_11, shared_10 * shared_4);
                            let shared_13 = shared_6.fma(shared_11, shared_9 * shared_4);
                            values[0] = Wide::select(
                                condition_0,
                                shared_12,
                                Wide::of(0.0),
                            );
                            values[1] = Wide::select(
                                condition_0,
                                shared_12,
                                Wide::of(0.0),
                            );
                            values[2] = Wide::select(
                                condition_0,
                                shared_13,
                                Wide::of(0.0),
                            );
                            values[3] = Wide::select(
                                condition_0,
                                shared_13,
                                Wide::of(0.0),
                            );
                        }
                        values
                    }
                }
                runtime::Terms {
                    range: 0..motion.parameters.prepared_0,
                    lists: [
                        &motion.parameters.prepared_3[..],
                        &motion.parameters.prepared_4[..],
                    ],
                    parts: [&motion.q[..], &motion.p[..]],
                    constants: [&motion.parameters.prepared_1[..]],
                    common: [motion.parameters.reach],
                }
                    .add_to::<Iteration, _, _>(&mut gradient[..]);
            }
            {
                struct Iteration;
                impl runtime::Term<2, 0, 0, 1, 2> for Iteration {
                    const READS: [runtime::Read; 2] = [
                        runtime::Read { part: 0, list: 0 },
                        runtime::Read { part: 1, list: 0 },
                    ];
                    const ADDENDS: &'static [runtime::Addend] = &[
                        runtime::Addend {
                            list: 0,
                            component: 1,
                            value: 0,
                            negative: true,
                        },
                    ];
                    #[inline(always)]
                    fn values<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
                        [[_,
                        read_0_1,
                        ],
                        [_,
                        read_1_1,
                        ],
                        ]: [[Wide; 2]; 2],
                        []: [Wide; 0],
                        []: [Wide; 0],
                    ) -> [Wide; 1] {
                        let mut values = [Wide::of(0.0); 1];
                        values[0] = read_0_1.cos() * read_1_1;
                        values
                    }
                }
                runtime::Terms {
                    range: 0..motion.parameters.prepared_5,
                    lists: [&motion.parameters.held[..]],
                    parts: [&motion.q[..], &motion.p[..]],
                    constants: [],
                    common: [],
                }
                    .add_to::<Iteration, _, _>(&mut gradient[..]);
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
            ::core::mem::swap(&mut force.q, &mut bent.p);
            <Self as runtime::System>::drift::<Scalar, f64>(&mut force, 1.0, time);
            bent.p = force.q;
            <Self as runtime::QuadraticKinetic>::hessian::<Scalar>(&mut bent, time);
            motion.push(Scalar::of(-2.0 * gradient), &bent);
        }
    }
    #[automatically_derived]
    impl runtime::TimeTransformed for Network {
        #[inline(always)]
        fn kinetic_plus<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
            more: Scalar,
        ) -> Scalar {
            let time = more;
            let mut sum_0 = Scalar::of(0.0);
            for k in 0..motion.q.len() {
                let p_k_0 = motion.p[k][0].value();
                let p_k_1 = motion.p[k][1].value();
                sum_0 += p_k_1.square_add(p_k_0.square());
            }
            Scalar::of(0.5).scale_add(sum_0, time)
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
                    motion.q[k][0].fma(step, motion.p[k][0].value());
                    motion.q[k][1].fma(step, motion.p[k][1].value());
                }
            }
        }
        #[inline(always)]
        fn logarithmic_kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) -> Scalar {
            let step = -duration;
            let mut gradient = runtime::repeated(motion.q.len(), [Scalar::of(0.0); 2]);
            let energy = {
                let mut sum_1 = Scalar::of(0.0);
                for k in 0..motion.parameters.prepared_0 {
                    let shared_0 = motion.q[motion.parameters.prepared_3[k]][0].value()
                        - motion.q[motion.parameters.prepared_4[k]][0].value();
                    let shared_1 = motion.q[motion.parameters.prepared_3[k]][1].value()
                        - motion.q[motion.parameters.prepared_4[k]][1].value();
                    let shared_2 = shared_0.hypot(shared_1);
                    let condition_0 = shared_2.less(motion.parameters.reach);
                    if condition_0.any() {
                        let shared_3 = shared_2 + Scalar::of(-1.0);
                        let shared_7 = motion.parameters.prepared_1[k].scale(shared_3);
                        let shared_8 = Scalar::of(1.0) / shared_2;
                        let shared_9 = shared_7 * (shared_0 * shared_8);
                        let shared_10 = shared_7 * (shared_1 * shared_8);
                        gradient[motion.parameters.prepared_3[k]][0] = Scalar::select(
                            condition_0,
                            gradient[motion.parameters.prepared_3[k]][0] + shared_9,
                            gradient[motion.parameters.prepared_3[k]][0],
                        );
                        gradient[motion.parameters.prepared_4[k]][0] = Scalar::select(
                            condition_0,
                            gradient[motion.parameters.prepared_4[k]][0] - shared_9,
                            gradient[motion.parameters.prepared_4[k]][0],
                        );
                        gradient[motion.parameters.prepared_3[k]][1] = Scalar::select(
                            condition_0,
                            gradient[motion.parameters.prepared_3[k]][1] + shared_10,
                            gradient[motion.parameters.prepared_3[k]][1],
                        );
                        gradient[motion.parameters.prepared_4[k]][1] = Scalar::select(
                            condition_0,
                            gradient[motion.parameters.prepared_4[k]][1] - shared_10,
                            gradient[motion.parameters.prepared_4[k]][1],
                        );
                        sum_1 = Scalar::select(
                            condition_0,
                            motion
                                .parameters
                                .prepared_7[k]
                                .scale_add(shared_3.square(), sum_1),
                            sum_1,
                        );
                    }
                }
                let mut sum_0 = Scalar::of(0.0);
                for k in 0..motion.parameters.prepared_5 {
                    let shared_4 = motion.q[motion.parameters.held[k]][1].value();
                    let (shared_6, shared_5) = shared_4.sin_cos();
                    gradient[motion.parameters.held[k]][1] -= shared_6;
                    sum_0 += shared_5;
                }
                sum_1 + sum_0
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
    impl runtime::ParameterDerivatives for Network {}
};
