#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    use ::integrator_core::__private::{self as runtime, Mask as _, Slot as _};
    /// What depends on parameters alone, evaluated once per run.
    #[derive(::core::clone::Clone)]
    pub struct Parameters<Scalar> {
        /// `beta`
        prepared_0: Scalar,
        /// `alpha`
        prepared_1: Scalar,
        /// `3 beta`
        prepared_2: Scalar,
        /// `2 alpha`
        prepared_3: Scalar,
        /// `alpha / 3`
        prepared_4: Scalar,
        /// `beta / 4`
        prepared_5: Scalar,
    }
    impl Parameters<f64> {
        fn prepared_0(&self) -> &f64 {
            &self.prepared_0
        }
        fn prepared_1(&self) -> &f64 {
            &self.prepared_1
        }
        fn prepared_2(&self) -> &f64 {
            &self.prepared_2
        }
        fn prepared_3(&self) -> &f64 {
            &self.prepared_3
        }
        fn prepared_4(&self) -> &f64 {
            &self.prepared_4
        }
        fn prepared_5(&self) -> &f64 {
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
                prepared_3: runtime::in_lanes(members, Parameters::prepared_3),
                prepared_4: runtime::in_lanes(members, Parameters::prepared_4),
                prepared_5: runtime::in_lanes(members, Parameters::prepared_5),
            }
        }
        fn not_finite(single: &Self::Single) -> runtime::Vec<runtime::NotFinite> {
            runtime::all_found(
                &mut [
                    runtime::not_finite("beta", &[], &single.prepared_0),
                    runtime::not_finite("alpha", &[], &single.prepared_1),
                    runtime::not_finite("3 beta", &[], &single.prepared_2),
                    runtime::not_finite("2 alpha", &[], &single.prepared_3),
                    runtime::not_finite("alpha / 3", &[], &single.prepared_4),
                    runtime::not_finite("beta / 4", &[], &single.prepared_5),
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
        }
    }
    /// The equations of motion, derived from `kinetic` and `potential`:
    ///
    /// ```text
    /// dq[i]/dt = p[i]   for i in 0..32
    /// dp[0]/dt += -q[0] - alpha q[0]^2 - beta q[0]^3
    /// dp[31]/dt += -q[31] + alpha q[31]^2 - beta q[31]^3
    /// dp[i + 1]/dt += q[i] - q[i + 1] - alpha (q[i + 1] - q[i])^2 - beta (q[i + 1] - q[i])^3   for i in 0..31
    /// dp[i]/dt += q[i + 1] - q[i] + alpha (q[i + 1] - q[i])^2 + beta (q[i + 1] - q[i])^3   for i in 0..31
    /// ```
    ///
    /// `T` is quadratic in the momenta, with a constant mass matrix.
    #[automatically_derived]
    impl runtime::Hamiltonian for Chain {
        type Compose = runtime::Verlet;
        const EQUATIONS: &'static [&'static str] = &[
            "T = Σ_{i in 0..32} p[i]^2 / 2",
            "V = q[0]^2 / 2 + q[31]^2 / 2 + alpha q[0]^3 / 3 - alpha q[31]^3 / 3 + beta q[0]^4 / 4 + beta q[31]^4 / 4 + Σ_{i in 0..31} ((q[i + 1] - q[i])^2 / 2 + alpha (q[i + 1] - q[i])^3 / 3 + beta (q[i + 1] - q[i])^4 / 4)",
            "dq[i]/dt = p[i]   for i in 0..32",
            "dp[0]/dt += -q[0] - alpha q[0]^2 - beta q[0]^3",
            "dp[31]/dt += -q[31] + alpha q[31]^2 - beta q[31]^3",
            "dp[i + 1]/dt += q[i] - q[i + 1] - alpha (q[i + 1] - q[i])^2 - beta (q[i + 1] - q[i])^3   for i in 0..31",
            "dp[i]/dt += q[i + 1] - q[i] + alpha (q[i + 1] - q[i])^2 + beta (q[i + 1] - q[i])^3   for i in 0..31",
        ];
        fn visit_compositions(visitor: &mut impl runtime::Visitor<Self>) {
            runtime::visit_quadratic(visitor);
        }
    }
    #[automatically_derived]
    impl runtime::System for Chain {
        type Coords = [f64; 32];
        type Parameters<Scalar: runtime::Real> = Parameters<Scalar>;
        type Motion<Scalar: runtime::Real, Leaf: runtime::Precision> = runtime::Plain<
            Scalar,
            runtime::Shaped<Self, Leaf>,
            Parameters<Scalar>,
        >;
        const AUTONOMOUS: bool = true;
        const FINGERPRINT: u64 = 14642489755830203488;
        const WIDE: bool = true;
        const STENCIL_RADII: ::core::option::Option<runtime::StencilRadii> = ::core::option::Option::Some(
            runtime::StencilRadii::of::<Self>(),
        );
        const LAYOUT: &'static [&'static str] = &["line", "line"];
        fn parameters(&self, _length: usize) -> Parameters<f64> {
            Parameters {
                prepared_0: 4.0 * (self.beta / 4.0),
                prepared_1: 3.0 * (self.alpha / 3.0),
                prepared_2: 12.0 * (self.beta / 4.0),
                prepared_3: 6.0 * (self.alpha / 3.0),
                prepared_4: self.alpha / 3.0,
                prepared_5: self.beta / 4.0,
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
        const HAS_FIELD: bool = true;
        #[inline(always)]
        fn along_velocity<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
            moved: runtime::MovedBy<'_, Self, Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(duration);
            for i in 0..32 {
                moved.q[i].scale_add(step, motion.p[i].value());
            }
        }
        #[inline(always)]
        fn along_force<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: runtime::ReadBy<'_, Self, Scalar, Leaf>,
            moved: runtime::MovedBy<'_, Self, Scalar, Leaf>,
            duration: f64,
            _time: f64,
        ) {
            let step = Scalar::of(-duration);
            let mut gradient = [Scalar::of(0.0); 32];
            let q0 = motion.q[0].value();
            let q31 = motion.q[31].value();
            let shared_1 = q0.square();
            let shared_2 = q31.square();
            for i in 0..31 {
                let shared_0 = motion.q[i + 1].value() - motion.q[i].value();
                let shared_3 = shared_0.square();
                let shared_4 = shared_0
                    + motion
                        .parameters
                        .prepared_1
                        .scale_add(
                            shared_3,
                            motion.parameters.prepared_0.scale(shared_3 * shared_0),
                        );
                gradient[i + 1] += shared_4;
                gradient[i] -= shared_4;
            }
            gradient[0]
                += q0
                    + motion
                        .parameters
                        .prepared_1
                        .scale_add(
                            shared_1,
                            motion.parameters.prepared_0.scale(shared_1 * q0),
                        );
            gradient[31]
                += q31
                    + (-motion.parameters.prepared_1)
                        .scale_add(
                            shared_2,
                            motion.parameters.prepared_0.scale(shared_2 * q31),
                        );
            for (slot, gradient) in ::core::iter::zip(moved.p.iter_mut(), &gradient) {
                (*slot).scale_add(step, *gradient);
            }
        }
        #[inline(always)]
        fn kinetic<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let mut sum_0 = Scalar::of(0.0);
            for i in 0..32 {
                let p_i = motion.p[i].value();
                sum_0 = Scalar::of(0.5).scale_add(p_i.square(), sum_0);
            }
            sum_0
        }
        #[inline(always)]
        fn potential<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &Self::Motion<Scalar, Leaf>,
            _time: f64,
        ) -> Scalar {
            let q0 = motion.q[0].value();
            let q31 = motion.q[31].value();
            let shared_1 = q0.square();
            let shared_2 = q31.square();
            let mut sum_0 = Scalar::of(0.0);
            for i in 0..31 {
                let shared_0 = motion.q[i + 1].value() - motion.q[i].value();
                let shared_3 = shared_0.square();
                sum_0
                    += motion
                        .parameters
                        .prepared_5
                        .scale_add(
                            shared_3.square(),
                            motion
                                .parameters
                                .prepared_4
                                .scale_add(
                                    shared_3 * shared_0,
                                    Scalar::of(0.5).scale(shared_3),
                                ),
                        );
            }
            motion
                .parameters
                .prepared_5
                .scale_add(
                    shared_1.square(),
                    motion
                        .parameters
                        .prepared_4
                        .scale_add(shared_1 * q0, Scalar::of(0.5).scale(shared_1)),
                )
                + motion
                    .parameters
                    .prepared_5
                    .scale_add(
                        shared_2.square(),
                        (-motion.parameters.prepared_4)
                            .scale_add(shared_2 * q31, Scalar::of(0.5).scale(shared_2)),
                    ) + sum_0
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
            ::core::option::Option::Some(motion.sites())
        }
        #[inline(always)]
        fn apply_to_sites<Scalar: runtime::Real, Leaf: runtime::Precision>(
            lattice: runtime::MovedSites<'_, Scalar, Leaf, Self::Parameters<Scalar>>,
            flow: &runtime::Flow,
            sites: ::core::ops::Range<usize>,
        ) {
            lattice.apply::<Self>(flow, sites);
        }
    }
    #[automatically_derived]
    impl runtime::QuadraticKinetic for Chain {
        #[inline(always)]
        fn hessian<Scalar: runtime::Real>(
            motion: &mut Self::Motion<Scalar, f64>,
            _time: f64,
        ) {
            let mut gradient = [Scalar::of(0.0); 32];
            let q0 = motion.q[0].value();
            let q31 = motion.q[31].value();
            let p0 = motion.p[0].value();
            let p31 = motion.p[31].value();
            for i in 0..31 {
                let shared_0 = motion.q[i + 1].value() - motion.q[i].value();
                let shared_1 = motion.p[i + 1].value() - motion.p[i].value();
                let shared_2 = motion
                    .parameters
                    .prepared_3
                    .scale(shared_1)
                    .fma(
                        shared_0,
                        motion
                            .parameters
                            .prepared_2
                            .scale(shared_1)
                            .fma(shared_0.square(), shared_1),
                    );
                gradient[i + 1] += shared_2;
                gradient[i] -= shared_2;
            }
            gradient[0]
                += motion
                    .parameters
                    .prepared_3
                    .scale(p0)
                    .fma(
                        q0,
                        motion.parameters.prepared_2.scale(p0).fma(q0.square(), p0),
                    );
            gradient[31]
                += (-motion.parameters.prepared_3.scale(p31))
                    .fma(
                        q31,
                        motion.parameters.prepared_2.scale(p31).fma(q31.square(), p31),
                    );
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
    impl runtime::TimeTransformed for Chain {
        #[inline(always)]
        fn kinetic_plus<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &runtime::PlainMotion<Self, Scalar, Leaf>,
            more: Scalar,
        ) -> Scalar {
            let time = more;
            let mut sum_0 = Scalar::of(0.0);
            for i in 0..32 {
                let p_i = motion.p[i].value();
                sum_0 = Scalar::of(0.5).scale_add(p_i.square(), sum_0);
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
            for i in 0..32 {
                motion.q[i].fma(step, motion.p[i].value());
            }
        }
        #[inline(always)]
        fn logarithmic_kick<Scalar: runtime::Real, Leaf: runtime::Precision>(
            motion: &mut runtime::PlainMotion<Self, Scalar, Leaf>,
            duration: Scalar,
        ) -> Scalar {
            let step = -duration;
            let mut gradient = [Scalar::of(0.0); 32];
            let energy = {
                let q0 = motion.q[0].value();
                let q31 = motion.q[31].value();
                let shared_1 = q0.square();
                let shared_2 = q31.square();
                let shared_4 = shared_1 * q0;
                let shared_5 = shared_2 * q31;
                let mut sum_0 = Scalar::of(0.0);
                for i in 0..31 {
                    let shared_0 = motion.q[i + 1].value() - motion.q[i].value();
                    let shared_3 = shared_0.square();
                    let shared_6 = shared_3 * shared_0;
                    let shared_7 = shared_0
                        + motion
                            .parameters
                            .prepared_1
                            .scale_add(
                                shared_3,
                                motion.parameters.prepared_0.scale(shared_6),
                            );
                    gradient[i + 1] += shared_7;
                    gradient[i] -= shared_7;
                    sum_0
                        += motion
                            .parameters
                            .prepared_5
                            .scale_add(
                                shared_3.square(),
                                motion
                                    .parameters
                                    .prepared_4
                                    .scale_add(shared_6, Scalar::of(0.5).scale(shared_3)),
                            );
                }
                gradient[0]
                    += q0
                        + motion
                            .parameters
                            .prepared_1
                            .scale_add(
                                shared_1,
                                motion.parameters.prepared_0.scale(shared_4),
                            );
                gradient[31]
                    += q31
                        + (-motion.parameters.prepared_1)
                            .scale_add(
                                shared_2,
                                motion.parameters.prepared_0.scale(shared_5),
                            );
                motion
                    .parameters
                    .prepared_5
                    .scale_add(
                        shared_1.square(),
                        motion
                            .parameters
                            .prepared_4
                            .scale_add(shared_4, Scalar::of(0.5).scale(shared_1)),
                    )
                    + motion
                        .parameters
                        .prepared_5
                        .scale_add(
                            shared_2.square(),
                            (-motion.parameters.prepared_4)
                                .scale_add(shared_5, Scalar::of(0.5).scale(shared_2)),
                        ) + sum_0
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
    impl runtime::Stencil<runtime::Drift> for Chain {
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
    /// What every site computes from its neighbourhood, for itself and for the sites ahead.
    #[automatically_derived]
    impl runtime::Stencil<runtime::Kick> for Chain {
        type Contributions<Wide: ::core::marker::Copy> = [Wide; 2];
        const BOUNDARY: runtime::Boundary = runtime::Boundary {
            first: 1,
            last: 1,
            forward: 1,
            behind: 0,
            ahead: 1,
            periodic: false,
        };
        #[inline(always)]
        fn contributions<Scalar: runtime::Real, Wide: runtime::Block<Scalar>>(
            window: &runtime::Window<Scalar, Wide>,
            parameters: &Self::Parameters<Scalar>,
            _time: f64,
        ) -> [Wide; 2] {
            let q_i = window.at(0);
            let shared_0 = window.at(1) - q_i;
            let shared_1 = q_i.square();
            let shared_2 = Wide::splat(parameters.prepared_0).scale(shared_1 * q_i);
            let shared_3 = Wide::splat(parameters.prepared_1).scale(shared_1);
            let shared_4 = shared_0.square();
            let shared_5 = shared_0
                + Wide::splat(parameters.prepared_1)
                    .scale_add(
                        shared_4,
                        Wide::splat(parameters.prepared_0).scale(shared_4 * shared_0),
                    );
            let contribution_0 = window.masked(0..31, -shared_5);
            let contribution_0 = window
                .masked_add(0..1, contribution_0, q_i + (shared_2 + shared_3));
            let contribution_0 = window
                .masked_add(31..32, contribution_0, q_i + (shared_2 - shared_3));
            let contribution_1 = window.masked(0..31, shared_5);
            [contribution_0, contribution_1]
        }
    }
    #[automatically_derived]
    impl runtime::ParameterDerivatives for Chain {}
};
