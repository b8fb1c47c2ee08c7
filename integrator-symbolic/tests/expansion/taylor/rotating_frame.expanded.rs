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
        kept: [TapeOrder<Scalar>; runtime::COEFFICIENTS],
    }
    impl<Scalar: runtime::Real> ::core::default::Default for Tape<Scalar> {
        fn default() -> Self {
            Self {
                rates_0: [Scalar::of(0.0); runtime::COEFFICIENTS],
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
            let mut derivative_0 = Scalar::of(-0.0);
            let mut derivative_1 = Scalar::of(-0.0);
            let mut derivative_2 = Scalar::of(-0.0);
            let mut derivative_3 = Scalar::of(-0.0);
            let mut rest_of_shared_0 = Scalar::of(0.0);
            let mut early_of_shared_2 = Scalar::of(0.0);
            let mut rest_of_shared_2 = Scalar::of(0.0);
            let mut early_of_shared_1 = Scalar::of(0.0);
            let mut rest_of_shared_1 = Scalar::of(0.0);
            let mut rest_of_shared_3 = Scalar::of(0.0);
            let mut rest_of_shared_5 = Scalar::of(0.0);
            if order > 0 && order % 2 == 0 {
                let middle = order / 2;
                rest_of_shared_0 = Scalar::of(0.5) * q[middle][0] * q[middle][0];
                rest_of_shared_3 = tape.kept[middle].shared_0
                    * tape.kept[middle].shared_2;
                rest_of_shared_5 = tape.kept[middle].shared_4
                    * tape.kept[middle].shared_1;
                if middle > 1 {
                    rest_of_shared_2 = tape
                        .rates_0[middle]
                        .fma(tape.kept[middle].shared_1, rest_of_shared_2);
                    rest_of_shared_1 = tape
                        .rates_0[middle]
                        .fma(tape.kept[middle].shared_2, rest_of_shared_1);
                }
            }
            for low in (1..order.div_ceil(2)).rev() {
                let high = order - low;
                rest_of_shared_0 = q[low][0].fma(q[high][0], rest_of_shared_0);
            }
            for low in (1..order.div_ceil(2)).rev() {
                let high = order - low;
                early_of_shared_2 = tape
                    .rates_0[high]
                    .fma(tape.kept[low].shared_1, early_of_shared_2);
            }
            for low in (2..order.div_ceil(2)).rev() {
                let high = order - low;
                rest_of_shared_2 = tape
                    .rates_0[low]
                    .fma(tape.kept[high].shared_1, rest_of_shared_2);
            }
            for low in (1..order.div_ceil(2)).rev() {
                let high = order - low;
                early_of_shared_1 = tape
                    .rates_0[high]
                    .fma(tape.kept[low].shared_2, early_of_shared_1);
            }
            for low in (2..order.div_ceil(2)).rev() {
                let high = order - low;
                rest_of_shared_1 = tape
                    .rates_0[low]
                    .fma(tape.kept[high].shared_2, rest_of_shared_1);
            }
            for low in (1..order.div_ceil(2)).rev() {
                let high = order - low;
                rest_of_shared_3 = tape
                    .kept[low]
                    .shared_0
                    .fma(
                        tape.kept[high].shared_2,
                        tape
                            .kept[high]
                            .shared_0
                            .fma(tape.kept[low].shared_2, rest_of_shared_3),
                    );
            }
            for low in (1..order.div_ceil(2)).rev() {
                let high = order - low;
                rest_of_shared_5 = tape
                    .kept[low]
                    .shared_4
                    .fma(
                        tape.kept[high].shared_1,
                        tape
                            .kept[high]
                            .shared_4
                            .fma(tape.kept[low].shared_1, rest_of_shared_5),
                    );
            }
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
                                    runtime::div_by_order(
                                        (early_of_shared_2 + rest_of_shared_2),
                                        order,
                                    ),
                                ),
                        )
                }
            };
            tape.kept[order].shared_2 = shared_2;
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
                                    runtime::div_by_order(
                                        (-(early_of_shared_1 + rest_of_shared_1)),
                                        order,
                                    ),
                                ),
                        )
                }
            };
            tape.kept[order].shared_1 = shared_1;
            let shared_3 = if order == 0 {
                (shared_0 * shared_2)
            } else {
                tape.kept[0]
                    .shared_0
                    .fma(shared_2, shared_0.fma(tape.kept[0].shared_2, rest_of_shared_3))
            };
            let shared_4 = Scalar::of(2.0) * q[order][0];
            tape.kept[order].shared_4 = shared_4;
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
            q[order + 1][0] = runtime::div_by_order(derivative_0, order + 1);
            q[order + 1][1] = runtime::div_by_order(derivative_1, order + 1);
            p[order + 1][0] = runtime::div_by_order(derivative_2, order + 1);
            tape.rates_0[order + 1] = derivative_3;
            p[order + 1][1] = runtime::div_by_order(derivative_3, order + 1);
        }
    }
};
