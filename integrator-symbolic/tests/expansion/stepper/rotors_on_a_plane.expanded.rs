#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `2 inertia[i][j]`
        prepared_0: runtime::SharedTable<[Scalar; 64]>,
        /// `along[j]`
        along: [Scalar; 64],
        /// `across[i]`
        across: runtime::SharedTable<Scalar>,
    }
    impl Parameters<f64> {
        fn prepared_0(&self) -> &runtime::SharedTable<[f64; 64]> {
            &self.prepared_0
        }
        fn along(&self) -> &[f64; 64] {
            &self.along
        }
        fn across(&self) -> &runtime::SharedTable<f64> {
            &self.across
        }
    }
    impl<Scalar: runtime::Real> runtime::Prepared<Scalar> for Parameters<Scalar> {
        type Single = Parameters<f64>;
        #[inline(always)]
        fn gather(members: &[&Self::Single]) -> Self {
            Parameters {
                prepared_0: runtime::in_lanes(members, Parameters::prepared_0),
                along: runtime::in_lanes(members, Parameters::along),
                across: runtime::in_lanes(members, Parameters::across),
            }
        }
        #[inline]
        fn alike(a: &Self::Single, b: &Self::Single) -> bool {
            a.prepared_0.len() == b.prepared_0.len() && a.across.len() == b.across.len()
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite(
                        "2 inertia[i][j]",
                        &["i", "j"],
                        &single.prepared_0,
                    ),
                    runtime::not_finite("along[j]", &["j"], &single.along),
                    runtime::not_finite("across[i]", &["i"], &single.across),
                ],
            )
        }
        fn digest(single: &Self::Single, digest: &mut runtime::Digest) {
            digest.add(&single.prepared_0);
            digest.add(&single.along);
            digest.add(&single.across);
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[i][j]/dt = p[i][j] / inertia[i][j]   for i in 0..n, j in 0..64
    /// dp[i][(j + 1) % 64]/dt += -along[j] sin(q[i][(j + 1) % 64] - q[i][j])   for i in 0..n, j in 0..64
    /// dp[i][j]/dt += along[j] sin(q[i][(j + 1) % 64] - q[i][j])   for i in 0..n, j in 0..64
    /// dp[i + 1][j]/dt += -across[i] sin(q[i + 1][j] - q[i][j])   for i in 0..n - 1, j in 0..64
    /// dp[i][j]/dt += across[i] sin(q[i + 1][j] - q[i][j])   for i in 0..n - 1, j in 0..64
    /// ```
    ///
    /// `T` is quadratic in the momenta, with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for Rotors {
        type Compose = runtime::Verlet;
        const EQUATIONS: &'static [&'static str] = &[
            "T = Σ_{i in 0..n} Σ_{j in 0..64} p[i][j]^2 / (2 inertia[i][j])",
            "V = -Σ_{i in 0..n} Σ_{j in 0..64} along[j] cos(q[i][(j + 1) % 64] - q[i][j]) - Σ_{i in 0..n - 1} Σ_{j in 0..64} across[i] cos(q[i + 1][j] - q[i][j])",
            "dq[i][j]/dt = p[i][j] / inertia[i][j]   for i in 0..n, j in 0..64",
            "dp[i][(j + 1) % 64]/dt += -along[j] sin(q[i][(j + 1) % 64] - q[i][j])   for i in 0..n, j in 0..64",
            "dp[i][j]/dt += along[j] sin(q[i][(j + 1) % 64] - q[i][j])   for i in 0..n, j in 0..64",
            "dp[i + 1][j]/dt += -across[i] sin(q[i + 1][j] - q[i][j])   for i in 0..n - 1, j in 0..64",
            "dp[i][j]/dt += across[i] sin(q[i + 1][j] - q[i][j])   for i in 0..n - 1, j in 0..64",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Rotors {
        type Coords = runtime::Vec<[f64; 64]>;
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 255818126161148724;
        const WIDE: bool = true;
        const STENCIL_RADII: ::core::option::Option<runtime::StencilRadii> = ::core::option::Option::Some(
            runtime::StencilRadii::of::<Self>(),
        );
        const LAYOUT: &'static [&'static str] = &["plane", "plane"];
        const ENERGIES_IN_LANES: bool = true;
        fn parameters(&self, length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: runtime::table(
                    length,
                    &|i: usize| ::core::array::from_fn(|j: usize| {
                        (2.0 * self.inertia[i][j])
                    }),
                ),
                along: ::core::array::from_fn(|j: usize| self.along[j]),
                across: runtime::table(
                    length.saturating_sub(1),
                    &|i: usize| self.across[i],
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
    impl runtime::QuadraticKinetic for Rotors {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = runtime::repeated(motion.q.len(), [Scalar::of(0.0); 64]);
            for i in 0..motion.q.len() {
                for j in 0..64 {
                    let shared_0 = motion
                        .parameters
                        .along[j]
                        .scale(
                            motion.p[i][(j + 1) % 64].value() - motion.p[i][j].value(),
                        )
                        * (motion.q[i][(j + 1) % 64].value() - motion.q[i][j].value())
                            .cos();
                    gradient[i][(j + 1) % 64] += shared_0;
                    gradient[i][j] -= shared_0;
                }
            }
            for i in 0..motion.q.len().saturating_sub(1) {
                for j in 0..64 {
                    let shared_1 = motion
                        .parameters
                        .across[i]
                        .scale(motion.p[i + 1][j].value() - motion.p[i][j].value())
                        * (motion.q[i + 1][j].value() - motion.q[i][j].value()).cos();
                    gradient[i + 1][j] += shared_1;
                    gradient[i][j] -= shared_1;
                }
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
    impl runtime::TimeTransformed for Rotors {
        #[inline(always)]
        fn kinetic_plus<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
            more: Scalar,
        ) -> Scalar {
            let time = more;
            let mut sum_1 = Scalar::of(0.0);
            for i in 0..motion.q.len() {
                let mut sum_0 = Scalar::of(0.0);
                for j in 0..64 {
                    let p_i_j = motion.p[i][j].value();
                    sum_0 += p_i_j.square() / motion.parameters.prepared_0[i][j];
                }
                sum_1 += sum_0;
            }
            sum_1 + time
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
                for i in 0..motion.q.len() {
                    for j in 0..64 {
                        motion
                            .q[i][j]
                            .fma(
                                (Scalar::of(2.0) / motion.parameters.prepared_0[i][j])
                                    .scale(step),
                                motion.p[i][j].value(),
                            );
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
            let mut gradient = runtime::repeated(motion.q.len(), [Scalar::of(0.0); 64]);
            let energy = {
                let mut sum_1 = Scalar::of(0.0);
                for i in 0..motion.q.len() {
                    let mut sum_0 = Scalar::of(0.0);
                    for j in 0..64 {
                        let shared_0 = motion.q[i][(j + 1) % 64].value()
                            - motion.q[i][j].value();
                        let (shared_6, shared_1) = shared_0.sin_cos();
                        let shared_7 = motion.parameters.along[j].scale(shared_6);
                        gradient[i][(j + 1) % 64] += shared_7;
                        gradient[i][j] -= shared_7;
                        sum_0 = motion.parameters.along[j].scale_add(shared_1, sum_0);
                    }
                    sum_1 += sum_0;
                }
                let mut sum_3 = Scalar::of(0.0);
                for i in 0..motion.q.len().saturating_sub(1) {
                    let mut sum_2 = Scalar::of(0.0);
                    for j in 0..64 {
                        let shared_2 = motion.q[i + 1][j].value()
                            - motion.q[i][j].value();
                        let (shared_4, shared_3) = shared_2.sin_cos();
                        let shared_5 = motion.parameters.across[i].scale(shared_4);
                        gradient[i + 1][j] += shared_5;
                        gradient[i][j] -= shared_5;
                        sum_2 = motion.parameters.across[i].scale_add(shared_3, sum_2);
                    }
                    sum_3 += sum_2;
                }
                -(sum_1 + sum_3)
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
    /// What every site computes from its neighbourhood, for itself and for the sites ahead.
    #[automatically_derived]
    impl runtime::Stencil<runtime::Drift> for Rotors {
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
        #[inline(always)]
        fn contributions<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
            window: &runtime::Window<Scalar, Wide>,
            parameters: &Self::Parameters<Scalar>,
            _time: f64,
        ) -> [Wide; 1] {
            let contribution_0_0 = (Wide::of(2.0)
                / window.table_of_rows(&parameters.prepared_0, 0, 0))
                .scale(window.at(0));
            [contribution_0_0]
        }
    }
    /// What every site computes from its neighbourhood, for itself and for the sites ahead.
    #[automatically_derived]
    impl runtime::Stencil<runtime::Kick> for Rotors {
        type Contributions<Wide: ::core::marker::Copy> = [Wide; 3];
        const BOUNDARY: runtime::Boundary = runtime::Boundary {
            first: 0,
            last: 0,
            forward: 1,
            behind: 0,
            ahead: 1,
            periodic: true,
        };
        const ROW_BOUNDARY: ::core::option::Option<runtime::Boundary> = ::core::option::Option::Some(runtime::Boundary {
            first: 0,
            last: 1,
            forward: 1,
            behind: 0,
            ahead: 1,
            periodic: false,
        });
        #[inline(always)]
        fn contributions<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
            window: &runtime::Window<Scalar, Wide>,
            parameters: &Self::Parameters<Scalar>,
            _time: f64,
        ) -> [Wide; 3] {
            let q_i_j = window.at(0);
            let shared_0 = window
                .table(&parameters.along, 0)
                .scale((window.at(1) - q_i_j).sin());
            let shared_1 = window
                .table_over_rows(&parameters.across, 0)
                .scale((window.below(0) - q_i_j).sin());
            let contribution_0_0 = -shared_0;
            let contribution_0_0 = contribution_0_0
                + window.row_masked(0..window.rows().saturating_sub(1), -shared_1);
            let contribution_0_1 = shared_0;
            let contribution_1_0 = window
                .row_masked(0..window.rows().saturating_sub(1), shared_1);
            [contribution_0_0, contribution_0_1, contribution_1_0]
        }
    }
    /// What every site computes from its neighbourhood, for itself and for the sites ahead.
    #[automatically_derived]
    impl runtime::Stencil<runtime::KineticEnergy> for Rotors {
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
        #[inline(always)]
        fn contributions<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
            window: &runtime::Window<Scalar, Wide>,
            parameters: &Self::Parameters<Scalar>,
            _time: f64,
        ) -> [Wide; 1] {
            let p_i_j = window.at(0);
            let contribution_0_0 = p_i_j.square()
                / window.table_of_rows(&parameters.prepared_0, 0, 0);
            [contribution_0_0]
        }
    }
    /// What every site computes from its neighbourhood, for itself and for the sites ahead.
    #[automatically_derived]
    impl runtime::Stencil<runtime::PotentialEnergy> for Rotors {
        type Contributions<Wide: ::core::marker::Copy> = [Wide; 1];
        const BOUNDARY: runtime::Boundary = runtime::Boundary {
            first: 0,
            last: 0,
            forward: 0,
            behind: 0,
            ahead: 1,
            periodic: true,
        };
        const ROW_BOUNDARY: ::core::option::Option<runtime::Boundary> = ::core::option::Option::Some(runtime::Boundary {
            first: 0,
            last: 1,
            forward: 0,
            behind: 0,
            ahead: 1,
            periodic: false,
        });
        #[inline(always)]
        fn contributions<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
            window: &runtime::Window<Scalar, Wide>,
            parameters: &Self::Parameters<Scalar>,
            _time: f64,
        ) -> [Wide; 1] {
            let q_i_j = window.at(0);
            let contribution_0_0 = -window
                .table(&parameters.along, 0)
                .scale((window.at(1) - q_i_j).cos());
            let contribution_0_0 = contribution_0_0
                + window
                    .row_masked(
                        0..window.rows().saturating_sub(1),
                        -window
                            .table_over_rows(&parameters.across, 0)
                            .scale((window.below(0) - q_i_j).cos()),
                    );
            [contribution_0_0]
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Rotors {}
};
