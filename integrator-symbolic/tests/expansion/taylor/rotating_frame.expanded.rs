#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    /// Coefficients of an order.
    #[derive(::core::clone::Clone, ::core::marker::Copy)]
    pub struct TapeOrder<Scalar: runtime::Real> {
        shared_0: Scalar,
        shared_2: Scalar,
        shared_1: Scalar,
        shared_4: Scalar,
    }
    /// The coefficients that recurrences read.
    pub struct Tape<Scalar: runtime::Real> {
        rates_0: [Scalar; runtime::COEFFICIENTS],
        pairs_0: [Scalar::Pair; runtime::COEFFICIENTS],
        pairs_1: [Scalar::Pair; runtime::COEFFICIENTS],
        pairs_2: [Scalar::Pair; runtime::COEFFICIENTS],
        kept: [TapeOrder<Scalar>; runtime::COEFFICIENTS],
    }
    impl<Scalar: runtime::Real> ::core::default::Default for Tape<Scalar> {
        fn default() -> Self {
            Self {
                rates_0: [Scalar::of(0.0); runtime::COEFFICIENTS],
                pairs_0: [runtime::twice(Scalar::of(0.0)); runtime::COEFFICIENTS],
                pairs_1: [runtime::twice(Scalar::of(0.0)); runtime::COEFFICIENTS],
                pairs_2: [runtime::twice(Scalar::of(0.0)); runtime::COEFFICIENTS],
                kept: [TapeOrder {
                    shared_0: Scalar::of(0.0),
                    shared_2: Scalar::of(0.0),
                    shared_1: Scalar::of(0.0),
                    shared_4: Scalar::of(0.0),
                }; runtime::COEFFICIENTS],
            }
        }
    }
    #[automatically_derived]
    impl runtime::Recurrences for Frame {
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
            let mut derivative_0 = Scalar::of(-0.0);
            let mut derivative_1 = Scalar::of(-0.0);
            let mut derivative_2 = Scalar::of(-0.0);
            let mut derivative_3 = Scalar::of(-0.0);
            let mut rest_of_shared_0 = Scalar::of(0.0);
            let mut early_of_shared_2_and_shared_1 = runtime::twice(Scalar::of(0.0));
            let mut late_of_shared_2_and_shared_1 = runtime::twice(Scalar::of(0.0));
            let mut halves_of_shared_3 = runtime::twice(Scalar::of(0.0));
            let mut halves_of_shared_5 = runtime::twice(Scalar::of(0.0));
            if order > 0 && order % 2 == 0 {
                let middle = order / 2;
                rest_of_shared_0 = Scalar::of(0.5) * q[middle][0] * q[middle][0];
                halves_of_shared_3 = runtime::twice(Scalar::of(0.5))
                    * tape.pairs_1[middle] * tape.pairs_1[middle].swap();
                halves_of_shared_5 = runtime::twice(Scalar::of(0.5))
                    * tape.pairs_2[middle] * tape.pairs_2[middle].swap();
                if middle > 1 {
                    late_of_shared_2_and_shared_1 = runtime::twice(tape.rates_0[middle])
                        .fma(tape.pairs_0[middle], late_of_shared_2_and_shared_1);
                }
            }
            for low in (1..order.div_ceil(2)).rev() {
                let high = order - low;
                rest_of_shared_0 = q[low][0].fma(q[high][0], rest_of_shared_0);
            }
            for low in (1..order.div_ceil(2)).rev() {
                let high = order - low;
                early_of_shared_2_and_shared_1 = runtime::twice(tape.rates_0[high])
                    .fma(tape.pairs_0[low], early_of_shared_2_and_shared_1);
            }
            for low in (2..order.div_ceil(2)).rev() {
                let high = order - low;
                late_of_shared_2_and_shared_1 = runtime::twice(tape.rates_0[low])
                    .fma(tape.pairs_0[high], late_of_shared_2_and_shared_1);
            }
            for low in (1..order.div_ceil(2)).rev() {
                let high = order - low;
                halves_of_shared_3 = tape
                    .pairs_1[low]
                    .fma(tape.pairs_1[high].swap(), halves_of_shared_3);
            }
            for low in (1..order.div_ceil(2)).rev() {
                let high = order - low;
                halves_of_shared_5 = tape
                    .pairs_2[low]
                    .fma(tape.pairs_2[high].swap(), halves_of_shared_5);
            }
            let [rest_of_shared_2, rest_of_shared_1] = (early_of_shared_2_and_shared_1
                + late_of_shared_2_and_shared_1)
                .parts();
            let rest_of_shared_3 = halves_of_shared_3.total();
            let rest_of_shared_5 = halves_of_shared_5.total();
            let shared_0 = if order == 0 {
                q[order][0] * q[order][0]
            } else {
                Scalar::of(2.0) * q[0][0].fma(q[order][0], rest_of_shared_0)
            };
            tape.kept[order].shared_0 = shared_0;
            let shared_2 = match order {
                0 => p[order][1].sin(),
                1 => {
                    runtime::div_by_order(tape.kept[0].shared_1, order)
                        * tape.rates_0[order]
                }
                _ => {
                    tape.rates_0[order]
                        .fma(
                            runtime::div_by_order(tape.kept[0].shared_1, order),
                            runtime::div_by_order(tape.rates_0[1], order)
                                .fma(
                                    tape.kept[order - 1].shared_1,
                                    runtime::div_by_order(rest_of_shared_2, order),
                                ),
                        )
                }
            };
            tape.kept[order].shared_2 = shared_2;
            tape.pairs_1[order] = runtime::pair(
                tape.kept[order].shared_0,
                tape.kept[order].shared_2,
            );
            let shared_1 = match order {
                0 => p[order][1].cos(),
                1 => {
                    runtime::div_by_order(tape.kept[0].shared_2, order)
                        * (-tape.rates_0[order])
                }
                _ => {
                    (-tape.rates_0[order])
                        .fma(
                            runtime::div_by_order(tape.kept[0].shared_2, order),
                            runtime::div_by_order((-tape.rates_0[1]), order)
                                .fma(
                                    tape.kept[order - 1].shared_2,
                                    runtime::div_by_order((-rest_of_shared_1), order),
                                ),
                        )
                }
            };
            tape.kept[order].shared_1 = shared_1;
            tape.pairs_0[order] = runtime::pair(
                tape.kept[order].shared_1,
                tape.kept[order].shared_2,
            );
            let shared_3 = if order == 0 {
                (shared_0 * shared_2)
            } else {
                tape.kept[0]
                    .shared_0
                    .fma(shared_2, shared_0.fma(tape.kept[0].shared_2, rest_of_shared_3))
            };
            let shared_4 = Scalar::of(2.0) * q[order][0];
            tape.kept[order].shared_4 = shared_4;
            tape.pairs_2[order] = runtime::pair(
                tape.kept[order].shared_4,
                tape.kept[order].shared_1,
            );
            let shared_5 = if order == 0 {
                (shared_4 * shared_1)
            } else {
                tape.kept[0]
                    .shared_4
                    .fma(shared_1, shared_4.fma(tape.kept[0].shared_1, rest_of_shared_5))
            };
            derivative_0 += parameters.rate.fma(q[order][1], p[order][0]);
            derivative_1 += p[order][1] - parameters.rate.fma(q[order][0], shared_3);
            derivative_2 += -(-parameters.rate).fma(p[order][1], shared_5);
            derivative_3 += -(parameters.rate * p[order][0]);
            q[order + 1][0] = q.integral(derivative_0, order + 1);
            q[order + 1][1] = q.integral(derivative_1, order + 1);
            p[order + 1][0] = p.integral(derivative_2, order + 1);
            tape.rates_0[order + 1] = p.integral(derivative_3, 1);
            p[order + 1][1] = p.integral(derivative_3, order + 1);
        }
    }
};
