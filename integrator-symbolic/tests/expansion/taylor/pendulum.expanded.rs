#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    /// Coefficients of an order.
    #[derive(::core::clone::Clone, ::core::marker::Copy)]
    pub struct TapeOrder<Scalar: runtime::Real> {
        shared_1: Scalar,
        shared_0: Scalar,
    }
    /// The coefficients that recurrences read.
    pub struct Tape<Scalar: runtime::Real> {
        rates_0: [Scalar; runtime::COEFFICIENTS],
        pairs_0: [Scalar::Pair; runtime::COEFFICIENTS],
        kept: [TapeOrder<Scalar>; runtime::COEFFICIENTS],
    }
    impl<Scalar: runtime::Real> ::core::default::Default for Tape<Scalar> {
        fn default() -> Self {
            Self {
                rates_0: [Scalar::of(0.0); runtime::COEFFICIENTS],
                pairs_0: [runtime::twice(Scalar::of(0.0)); runtime::COEFFICIENTS],
                kept: [TapeOrder {
                    shared_1: Scalar::of(0.0),
                    shared_0: Scalar::of(0.0),
                }; runtime::COEFFICIENTS],
            }
        }
    }
    #[automatically_derived]
    impl runtime::Recurrences for Pendulum {
        type Tape<Scalar: runtime::Real> = Tape<Scalar>;
        const ROLLED: bool = false;
        const INTERLEAVED: bool = false;
        const ORDERS_PER_CALL: usize = 1;
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn order<Scalar: runtime::Real>(
            parameters: &Self::Parameters<Scalar>,
            _length: usize,
            q: &mut runtime::Coefficients<'_, Scalar>,
            p: &mut runtime::Coefficients<'_, Scalar>,
            tape: &mut Self::Tape<Scalar>,
            order: usize,
            _time: Scalar,
        ) {
            use runtime::Pair as _;
            if order == 0 {
                q[1][0] = q.integral(parameters.prepared_0 * p[0][0], 1);
                tape.rates_0[1] = q[1][0];
            }
            let mut derivative_0 = Scalar::of(-0.0);
            let mut early_of_shared_1_and_shared_0 = runtime::twice(Scalar::of(0.0));
            let mut late_of_shared_1_and_shared_0 = runtime::twice(Scalar::of(0.0));
            if order > 0 && order % 2 == 0 {
                let middle = order / 2;
                if middle > 1 {
                    late_of_shared_1_and_shared_0 = runtime::twice(tape.rates_0[middle])
                        .fma(tape.pairs_0[middle], late_of_shared_1_and_shared_0);
                }
            }
            for low in (1..order.div_ceil(2)).rev() {
                let high = order - low;
                early_of_shared_1_and_shared_0 = runtime::twice(tape.rates_0[high])
                    .fma(tape.pairs_0[low], early_of_shared_1_and_shared_0);
            }
            for low in (2..order.div_ceil(2)).rev() {
                let high = order - low;
                late_of_shared_1_and_shared_0 = runtime::twice(tape.rates_0[low])
                    .fma(tape.pairs_0[high], late_of_shared_1_and_shared_0);
            }
            let [rest_of_shared_1, rest_of_shared_0] = (early_of_shared_1_and_shared_0
                + late_of_shared_1_and_shared_0)
                .parts();
            let shared_1 = match order {
                0 => q[order][0].sin(),
                1 => {
                    runtime::div_by_order(tape.kept[0].shared_0, order)
                        * tape.rates_0[order]
                }
                _ => {
                    tape.rates_0[order]
                        .fma(
                            runtime::div_by_order(tape.kept[0].shared_0, order),
                            runtime::div_by_order(tape.rates_0[1], order)
                                .fma(
                                    tape.kept[order - 1].shared_0,
                                    runtime::div_by_order(rest_of_shared_1, order),
                                ),
                        )
                }
            };
            tape.kept[order].shared_1 = shared_1;
            let shared_0 = match order {
                0 => q[order][0].cos(),
                1 => {
                    runtime::div_by_order(tape.kept[0].shared_1, order)
                        * (-tape.rates_0[order])
                }
                _ => {
                    (-tape.rates_0[order])
                        .fma(
                            runtime::div_by_order(tape.kept[0].shared_1, order),
                            runtime::div_by_order((-tape.rates_0[1]), order)
                                .fma(
                                    tape.kept[order - 1].shared_1,
                                    runtime::div_by_order((-rest_of_shared_0), order),
                                ),
                        )
                }
            };
            tape.kept[order].shared_0 = shared_0;
            tape.pairs_0[order] = runtime::pair(
                tape.kept[order].shared_0,
                tape.kept[order].shared_1,
            );
            derivative_0 += parameters.prepared_1 * shared_1;
            p[order + 1][0] = p.integral(derivative_0, order + 1);
            tape.rates_0[order + 2] = q
                .rate(parameters.prepared_0 * derivative_0, order + 1);
            q[order + 2][0] = runtime::div_by_order(tape.rates_0[order + 2], order + 2);
        }
    }
};
