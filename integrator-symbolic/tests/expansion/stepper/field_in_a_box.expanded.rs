#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `field[k][k_2][k_3]`
        field: runtime::SharedTable<[[Scalar; 32]; 16]>,
    }
    impl Parameters<f64> {
        fn field(&self) -> &runtime::SharedTable<[[f64; 32]; 16]> {
            &self.field
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                field: runtime::in_lanes(members, Parameters::field),
            }
        }
        #[inline]
        fn alike(a: &Self::Single, b: &Self::Single) -> bool {
            a.field.len() == b.field.len()
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite(
                        "field[k][k_2][k_3]",
                        &["k", "k_2", "k_3"],
                        &single.field,
                    ),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.field);
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[k][k_2][k_3]/dt = p[k][k_2][k_3]   for k in 0..n, k_2 in 0..16, k_3 in 0..32
    /// dp[(k + 1) % n][k_2][k_3]/dt += q[k][k_2][k_3] - q[(k + 1) % n][k_2][k_3]   for k in 0..n, k_2 in 0..16, k_3 in 0..32
    /// dp[k][k_2][k_3]/dt += q[(k + 1) % n][k_2][k_3] - q[k][k_2][k_3] - field[k][k_2][k_3]   for k in 0..n, k_2 in 0..16, k_3 in 0..32
    /// dp[k][k_2][i]/dt += q[k][k_2][i - 1] - q[k][k_2][i]   for k in 0..n, k_2 in 0..16, i in 1..32
    /// dp[k][k_2][i - 1]/dt += q[k][k_2][i] - q[k][k_2][i - 1]   for k in 0..n, k_2 in 0..16, i in 1..32
    /// ```
    ///
    /// `T` is quadratic in the momenta, with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for Field {
        type Compose = runtime::Verlet;
        const EQUATIONS: &'static [&'static str] = &[
            "T = Σ_{k in 0..n} Σ_{k_2 in 0..16} Σ_{k_3 in 0..32} p[k][k_2][k_3]^2 / 2",
            "V = Σ_{k in 0..n} Σ_{k_2 in 0..16} (Σ_{k_3 in 0..32} (field[k][k_2][k_3] q[k][k_2][k_3] + (q[(k + 1) % n][k_2][k_3] - q[k][k_2][k_3])^2 / 2) + Σ_{i in 1..32} (q[k][k_2][i] - q[k][k_2][i - 1])^2 / 2)",
            "dq[k][k_2][k_3]/dt = p[k][k_2][k_3]   for k in 0..n, k_2 in 0..16, k_3 in 0..32",
            "dp[(k + 1) % n][k_2][k_3]/dt += q[k][k_2][k_3] - q[(k + 1) % n][k_2][k_3]   for k in 0..n, k_2 in 0..16, k_3 in 0..32",
            "dp[k][k_2][k_3]/dt += q[(k + 1) % n][k_2][k_3] - q[k][k_2][k_3] - field[k][k_2][k_3]   for k in 0..n, k_2 in 0..16, k_3 in 0..32",
            "dp[k][k_2][i]/dt += q[k][k_2][i - 1] - q[k][k_2][i]   for k in 0..n, k_2 in 0..16, i in 1..32",
            "dp[k][k_2][i - 1]/dt += q[k][k_2][i] - q[k][k_2][i - 1]   for k in 0..n, k_2 in 0..16, i in 1..32",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Field {
        type Coords = runtime::Vec<[[f64; 32]; 16]>;
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 14843664097722905913;
        const WIDE: bool = true;
        const STENCIL_RADII: ::core::option::Option<runtime::StencilRadii> = ::core::option::Option::Some(
            runtime::StencilRadii::of::<Self>(),
        );
        const LAYOUT: &'static [&'static str] = &["volume", "volume"];
        const ENERGIES_IN_LANES: bool = true;
        fn parameters(&self, length: usize) -> Parameters<f64> {
            Parameters {
                field: runtime::table(
                    length,
                    &|k: usize| ::core::array::from_fn(|k_2: usize| ::core::array::from_fn(|
                        k_3: usize|
                    self.field[k][k_2][k_3])),
                ),
            }
        }
        #[inline(always)]
        fn drift<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            time: f64,
        ) {
            motion.drift_layers::<Self>(duration, time);
        }
        #[inline(always)]
        fn kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
            duration: f64,
            time: f64,
        ) {
            motion.kick_layers::<Self>(duration, time);
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            time: f64,
        ) -> Scalar {
            motion.kinetic_of_layers::<Self>(time)
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            time: f64,
        ) -> Scalar {
            motion.potential_of_layers::<Self>(time)
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
        #[inline(always)]
        fn sites<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut Self::Motion<Scalar, Leaf>,
        ) -> ::core::option::Option<
            runtime::Sites<'_, Scalar, Leaf, Self::Parameters<Scalar>>,
        > {
            motion.layers::<Self>()
        }
        #[inline(always)]
        fn apply_to_sites<Scalar: runtime::Real, Leaf: runtime::Precision>(
            lattice: runtime::MovedSites<'_, Scalar, Leaf, Self::Parameters<Scalar>>,
            flow: &runtime::Flow,
            sites: ::core::ops::Range<usize>,
        ) {
            lattice.apply_to_layers::<Self>(flow, sites);
        }
    }
    #[automatically_derived]
    impl runtime::QuadraticKinetic for Field {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = runtime::repeated(
                motion.q.len(),
                [[Scalar::of(0.0); 32]; 16],
            );
            for k in 0..motion.q.len() {
                for k_2 in 0..16 {
                    for k_3 in 0..32 {
                        let shared_1 = motion
                            .p[(k + 1) % motion.q.len()][k_2][k_3]
                            .value() - motion.p[k][k_2][k_3].value();
                        gradient[(k + 1) % motion.q.len()][k_2][k_3] += shared_1;
                        gradient[k][k_2][k_3] -= shared_1;
                    }
                    for i in 1..32 {
                        let shared_0 = motion.p[k][k_2][i].value()
                            - motion.p[k][k_2][i - 1].value();
                        gradient[k][k_2][i] += shared_0;
                        gradient[k][k_2][i - 1] -= shared_0;
                    }
                }
            }
            for (slot, gradient) in ::core::iter::zip(motion.p.iter_mut(), &gradient) {
                for (slot, gradient) in ::core::iter::zip(slot, gradient) {
                    for (slot, gradient) in ::core::iter::zip(slot, gradient) {
                        (*slot) = *gradient;
                    }
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
    impl runtime::TimeTransformed for Field {
        #[inline(always)]
        fn kinetic_plus<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
            more: Scalar,
        ) -> Scalar {
            let time = more;
            let mut sum_2 = Scalar::of(0.0);
            for k in 0..motion.q.len() {
                let mut sum_1 = Scalar::of(0.0);
                for k_2 in 0..16 {
                    let mut sum_0 = Scalar::of(0.0);
                    for k_3 in 0..32 {
                        let p_k_k_2_k_3 = motion.p[k][k_2][k_3].value();
                        sum_0 = Scalar::of(0.5).scale_add(p_k_k_2_k_3.square(), sum_0);
                    }
                    sum_1 += sum_0;
                }
                sum_2 += sum_1;
            }
            sum_2 + time
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
                    for k_2 in 0..16 {
                        for k_3 in 0..32 {
                            motion
                                .q[k][k_2][k_3]
                                .fma(step, motion.p[k][k_2][k_3].value());
                        }
                    }
                }
            }
        }
        #[inline(always)]
        fn logarithmic_kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) -> Scalar {
            let step = -duration;
            let mut gradient = runtime::repeated(
                motion.q.len(),
                [[Scalar::of(0.0); 32]; 16],
            );
            let energy = {
                let mut sum_3 = Scalar::of(0.0);
                for k in 0..motion.q.len() {
                    let mut sum_2 = Scalar::of(0.0);
                    for k_2 in 0..16 {
                        let mut sum_0 = Scalar::of(0.0);
                        for k_3 in 0..32 {
                            let q_k_k_2_k_3 = motion.q[k][k_2][k_3].value();
                            let shared_0 = motion
                                .q[(k + 1) % motion.q.len()][k_2][k_3]
                                .value() - q_k_k_2_k_3;
                            gradient[(k + 1) % motion.q.len()][k_2][k_3] += shared_0;
                            gradient[k][k_2][k_3]
                                += motion.parameters.field[k][k_2][k_3] - shared_0;
                            sum_0
                                += motion
                                    .parameters
                                    .field[k][k_2][k_3]
                                    .scale_add(
                                        q_k_k_2_k_3,
                                        Scalar::of(0.5).scale(shared_0.square()),
                                    );
                        }
                        let mut sum_1 = Scalar::of(0.0);
                        for i in 1..32 {
                            let shared_1 = motion.q[k][k_2][i].value()
                                - motion.q[k][k_2][i - 1].value();
                            gradient[k][k_2][i] += shared_1;
                            gradient[k][k_2][i - 1] -= shared_1;
                            sum_1 = Scalar::of(0.5).scale_add(shared_1.square(), sum_1);
                        }
                        sum_2 += sum_0 + sum_1;
                    }
                    sum_3 += sum_2;
                }
                sum_3
            };
            let step = step / -energy;
            for (slot, gradient) in ::core::iter::zip(motion.p.iter_mut(), &gradient) {
                for (slot, gradient) in ::core::iter::zip(slot, gradient) {
                    for (slot, gradient) in ::core::iter::zip(slot, gradient) {
                        (*slot).fma(step, *gradient);
                    }
                }
            }
            energy
        }
    }
    /// What every site computes from its neighbourhood, for itself and for the sites ahead.
    #[automatically_derived]
    impl runtime::Stencil<runtime::Drift> for Field {
        type Contributions<Wide: ::core::marker::Copy> = [Wide; 1];
        const BOUNDARY: runtime::Boundary = runtime::Boundary {
            first: 0,
            last: 0,
            forward: 0,
            behind: 0,
            ahead: 0,
            periodic: false,
        };
        const ROW_BOUNDARY: ::core::option::Option<runtime::Boundary> = ::core::option::Option::Some(runtime::Boundary {
            first: 0,
            last: 0,
            forward: 0,
            behind: 0,
            ahead: 0,
            periodic: false,
        });
        const PLANE_BOUNDARY: ::core::option::Option<runtime::Boundary> = ::core::option::Option::Some(runtime::Boundary {
            first: 0,
            last: 0,
            forward: 0,
            behind: 0,
            ahead: 0,
            periodic: false,
        });
        #[inline(always)]
        fn contributions<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
            window: &runtime::Window<Scalar, Wide>,
            _parameters: &Self::Parameters<Scalar>,
            _time: f64,
        ) -> [Wide; 1] {
            let contribution_0_0_0 = window.at(0);
            [contribution_0_0_0]
        }
    }
    /// What every site computes from its neighbourhood, for itself and for the sites ahead.
    #[automatically_derived]
    impl runtime::Stencil<runtime::Kick> for Field {
        type Contributions<Wide: ::core::marker::Copy> = [Wide; 2];
        const BOUNDARY: runtime::Boundary = runtime::Boundary {
            first: 0,
            last: 1,
            forward: 1,
            behind: 0,
            ahead: 1,
            periodic: false,
        };
        const ROW_BOUNDARY: ::core::option::Option<runtime::Boundary> = ::core::option::Option::Some(runtime::Boundary {
            first: 0,
            last: 0,
            forward: 0,
            behind: 0,
            ahead: 0,
            periodic: false,
        });
        const PLANE_BOUNDARY: ::core::option::Option<runtime::Boundary> = ::core::option::Option::Some(runtime::Boundary {
            first: 0,
            last: 0,
            forward: 0,
            behind: 1,
            ahead: 1,
            periodic: true,
        });
        #[inline(always)]
        fn contributions<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
            window: &runtime::Window<Scalar, Wide>,
            parameters: &Self::Parameters<Scalar>,
            _time: f64,
        ) -> [Wide; 2] {
            let q_k_k_2_k_3 = window.at(0);
            let shared_0 = window.at(1) - q_k_k_2_k_3;
            let contribution_0_0_0 = q_k_k_2_k_3 - window.previous_plane(0)
                + (window.table_of_planes(&parameters.field, [0, 0], 0)
                    - (window.next_plane(0) - q_k_k_2_k_3));
            let contribution_0_0_0 = contribution_0_0_0
                + window.masked(0..31, -shared_0);
            let contribution_0_0_1 = window.masked(0..31, shared_0);
            [contribution_0_0_0, contribution_0_0_1]
        }
    }
    /// What every site computes from its neighbourhood, for itself and for the sites ahead.
    #[automatically_derived]
    impl runtime::Stencil<runtime::KineticEnergy> for Field {
        type Contributions<Wide: ::core::marker::Copy> = [Wide; 1];
        const BOUNDARY: runtime::Boundary = runtime::Boundary {
            first: 0,
            last: 0,
            forward: 0,
            behind: 0,
            ahead: 0,
            periodic: false,
        };
        const ROW_BOUNDARY: ::core::option::Option<runtime::Boundary> = ::core::option::Option::Some(runtime::Boundary {
            first: 0,
            last: 0,
            forward: 0,
            behind: 0,
            ahead: 0,
            periodic: false,
        });
        const PLANE_BOUNDARY: ::core::option::Option<runtime::Boundary> = ::core::option::Option::Some(runtime::Boundary {
            first: 0,
            last: 0,
            forward: 0,
            behind: 0,
            ahead: 0,
            periodic: false,
        });
        #[inline(always)]
        fn contributions<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
            window: &runtime::Window<Scalar, Wide>,
            _parameters: &Self::Parameters<Scalar>,
            _time: f64,
        ) -> [Wide; 1] {
            let p_k_k_2_k_3 = window.at(0);
            let contribution_0_0_0 = Wide::of(0.5).scale(p_k_k_2_k_3.square());
            [contribution_0_0_0]
        }
    }
    /// What every site computes from its neighbourhood, for itself and for the sites ahead.
    #[automatically_derived]
    impl runtime::Stencil<runtime::PotentialEnergy> for Field {
        type Contributions<Wide: ::core::marker::Copy> = [Wide; 1];
        const BOUNDARY: runtime::Boundary = runtime::Boundary {
            first: 1,
            last: 0,
            forward: 0,
            behind: 1,
            ahead: 0,
            periodic: false,
        };
        const ROW_BOUNDARY: ::core::option::Option<runtime::Boundary> = ::core::option::Option::Some(runtime::Boundary {
            first: 0,
            last: 0,
            forward: 0,
            behind: 0,
            ahead: 0,
            periodic: false,
        });
        const PLANE_BOUNDARY: ::core::option::Option<runtime::Boundary> = ::core::option::Option::Some(runtime::Boundary {
            first: 0,
            last: 0,
            forward: 0,
            behind: 0,
            ahead: 1,
            periodic: true,
        });
        #[inline(always)]
        fn contributions<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
            window: &runtime::Window<Scalar, Wide>,
            parameters: &Self::Parameters<Scalar>,
            _time: f64,
        ) -> [Wide; 1] {
            let q_k_k_2_k_3 = window.at(0);
            let shared_0 = window.next_plane(0) - q_k_k_2_k_3;
            let shared_1 = q_k_k_2_k_3 - window.at(-1);
            let contribution_0_0_0 = window
                .table_of_planes(&parameters.field, [0, 0], 0)
                .scale_add(q_k_k_2_k_3, Wide::of(0.5).scale(shared_0.square()));
            let contribution_0_0_0 = contribution_0_0_0
                + window.masked(1..32, Wide::of(0.5).scale(shared_1.square()));
            [contribution_0_0_0]
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Field {}
};
