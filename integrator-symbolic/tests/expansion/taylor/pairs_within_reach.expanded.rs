#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    /// Coefficients of an order.
    #[derive(::core::clone::Clone, ::core::marker::Copy)]
    pub struct Iteration1Order<Scalar: runtime::Real> {
        shared_0: Scalar,
        shared_2: Scalar,
        shared_4: Scalar,
        shared_5: Scalar,
        shared_6: Scalar,
        shared_7: Scalar,
        shared_8: Scalar,
        shared_9: Scalar,
        shared_10: Scalar,
    }
    /// What an iteration of a loop keeps.
    pub struct Iteration1<Scalar: runtime::Real> {
        condition_0: Scalar::Mask,
        over_shared_5: Scalar,
        over_shared_9: Scalar,
        kept: [Iteration1Order<Scalar>; runtime::COEFFICIENTS],
    }
    impl<Scalar: runtime::Real> ::core::default::Default for Iteration1<Scalar> {
        fn default() -> Self {
            Self {
                condition_0: <Scalar::Mask as runtime::Mask>::of(false),
                over_shared_5: Scalar::of(0.0),
                over_shared_9: Scalar::of(0.0),
                kept: [Iteration1Order {
                    shared_0: Scalar::of(0.0),
                    shared_2: Scalar::of(0.0),
                    shared_4: Scalar::of(0.0),
                    shared_5: Scalar::of(0.0),
                    shared_6: Scalar::of(0.0),
                    shared_7: Scalar::of(0.0),
                    shared_8: Scalar::of(0.0),
                    shared_9: Scalar::of(0.0),
                    shared_10: Scalar::of(0.0),
                }; runtime::COEFFICIENTS],
            }
        }
    }
    /// The coefficients that recurrences read.
    pub struct Tape<Scalar: runtime::Real> {
        inverse_mass: runtime::InverseMass<Scalar>,
        iterations_1: runtime::Iterations<
            Scalar,
            Iteration1<runtime::Wide<Scalar>>,
            2,
            0,
            4,
            4,
            2,
        >,
    }
    impl<Scalar: runtime::Real> ::core::default::Default for Tape<Scalar> {
        fn default() -> Self {
            Self {
                inverse_mass: ::core::default::Default::default(),
                iterations_1: ::core::default::Default::default(),
            }
        }
    }
    #[automatically_derived]
    impl runtime::Recurrences for Cluster {
        type Tape<Scalar: runtime::Real> = Tape<Scalar>;
        const ROLLED: bool = true;
        const INTERLEAVED: bool = false;
        const ORDERS_PER_CALL: usize = 2;
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn order<Scalar: runtime::Real>(
            parameters: &Self::Parameters<Scalar>,
            length: usize,
            q: &mut runtime::Coefficients<'_, Scalar>,
            p: &mut runtime::Coefficients<'_, Scalar>,
            tape: &mut Self::Tape<Scalar>,
            order: usize,
            time: Scalar,
        ) {
            let stride = q.stride();
            let layout = q.layout();
            if order == 0 {
                if tape.inverse_mass.is_empty() {
                    q[1].fill(Scalar::of(-0.0));
                    for k in 0..length {
                        q[order + 1][k] += Scalar::of(1.0);
                        q[order + 1][stride + k] += Scalar::of(1.0);
                    }
                    tape.inverse_mass = runtime::InverseMass::of(&q[1]);
                }
                tape.inverse_mass.first_order(q, p);
            }
            for order in [order, order + 1] {
                p[order + 1].fill(Scalar::of(-0.0));
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn iteration_1<Scalar: runtime::Real, Wide: runtime::Row<Scalar>>(
                iteration: &mut Iteration1<Wide>,
                reads: [[Wide; 2]; 4],
                []: [Wide; 0],
                [common_0,
                ]: [Wide; 1],
                order: usize,
                step: [Wide; 2],
            ) -> [[Wide; 2]; 4] {
                let mut results = [[Wide::of(0.0); 2]; 4];
                let mut rest_of_shared_1 = [Wide::of(0.0); 2];
                let mut rest_of_shared_3 = [Wide::of(0.0); 2];
                if order > 0 {
                    let middle = order / 2;
                    rest_of_shared_1[0] = Wide::of(0.5) * iteration.kept[middle].shared_0
                        * iteration.kept[middle].shared_0;
                    rest_of_shared_3[0] = Wide::of(0.5) * iteration.kept[middle].shared_2
                        * iteration.kept[middle].shared_2;
                }
                for low in (1..order / 2).rev() {
                    let (next, high) = (low + 1, order - low);
                    rest_of_shared_1[0] = iteration
                        .kept[low]
                        .shared_0
                        .fma(iteration.kept[high].shared_0, rest_of_shared_1[0]);
                    rest_of_shared_1[1] = iteration
                        .kept[next]
                        .shared_0
                        .fma(iteration.kept[high].shared_0, rest_of_shared_1[1]);
                    rest_of_shared_3[0] = iteration
                        .kept[low]
                        .shared_2
                        .fma(iteration.kept[high].shared_2, rest_of_shared_3[0]);
                    rest_of_shared_3[1] = iteration
                        .kept[next]
                        .shared_2
                        .fma(iteration.kept[high].shared_2, rest_of_shared_3[1]);
                }
                for at in 0..2 {
                    let order = order + at;
                    let step = step[at];
                    let read_0 = reads[0][at];
                    let read_1 = reads[1][at];
                    let read_2 = reads[2][at];
                    let read_3 = reads[3][at];
                    if at == 1 && order > 1 {
                        let (low, high) = (1, order - 1);
                        rest_of_shared_1[1] = iteration
                            .kept[low]
                            .shared_0
                            .fma(iteration.kept[high].shared_0, rest_of_shared_1[1]);
                        rest_of_shared_3[1] = iteration
                            .kept[low]
                            .shared_2
                            .fma(iteration.kept[high].shared_2, rest_of_shared_3[1]);
                    }
                    let shared_0 = read_0 - read_1;
                    iteration.kept[order].shared_0 = shared_0;
                    let shared_1 = if order == 0 {
                        shared_0 * shared_0
                    } else {
                        Wide::of(2.0)
                            * iteration
                                .kept[0]
                                .shared_0
                                .fma(shared_0, rest_of_shared_1[at])
                    };
                    let shared_2 = read_2 - read_3;
                    iteration.kept[order].shared_2 = shared_2;
                    let shared_3 = if order == 0 {
                        shared_2 * shared_2
                    } else {
                        Wide::of(2.0)
                            * iteration
                                .kept[0]
                                .shared_2
                                .fma(shared_2, rest_of_shared_3[at])
                    };
                    let shared_4 = shared_1 + shared_3;
                    iteration.kept[order].shared_4 = shared_4;
                    if order == 0 {
                        iteration.condition_0 = shared_4.less(common_0);
                    }
                    let condition_0 = iteration.condition_0;
                    let mut choice_0 = Wide::of(0.0);
                    let mut choice_1 = Wide::of(0.0);
                    if condition_0.any() {
                        let mut rest_of_shared_5 = Wide::of(0.0);
                        let mut rest_of_shared_9 = Wide::of(0.0);
                        let mut rest_of_shared_11 = Wide::of(0.0);
                        let mut rest_of_shared_12 = Wide::of(0.0);
                        if order > 0 && order % 2 == 0 {
                            let middle = order / 2;
                            rest_of_shared_5 = (runtime::power_weight::<
                                Wide,
                            >(-4.0, middle, order) * iteration.kept[middle].shared_4)
                                .fma(iteration.kept[middle].shared_5, rest_of_shared_5);
                            rest_of_shared_9 = (runtime::power_weight::<
                                Wide,
                            >(-1.0, middle, order) * iteration.kept[middle].shared_8)
                                .fma(iteration.kept[middle].shared_9, rest_of_shared_9);
                            rest_of_shared_11 = iteration.kept[middle].shared_6
                                * iteration.kept[middle].shared_10;
                            rest_of_shared_12 = iteration.kept[middle].shared_7
                                * iteration.kept[middle].shared_10;
                        }
                        for low in (1..order.div_ceil(2)).rev() {
                            let high = order - low;
                            rest_of_shared_5 = (runtime::power_weight::<
                                Wide,
                            >(-4.0, low, order) * iteration.kept[low].shared_4)
                                .fma(iteration.kept[high].shared_5, rest_of_shared_5);
                            rest_of_shared_5 = (runtime::power_weight::<
                                Wide,
                            >(-4.0, high, order) * iteration.kept[high].shared_4)
                                .fma(iteration.kept[low].shared_5, rest_of_shared_5);
                            rest_of_shared_9 = (runtime::power_weight::<
                                Wide,
                            >(-1.0, low, order) * iteration.kept[low].shared_8)
                                .fma(iteration.kept[high].shared_9, rest_of_shared_9);
                            rest_of_shared_9 = (runtime::power_weight::<
                                Wide,
                            >(-1.0, high, order) * iteration.kept[high].shared_8)
                                .fma(iteration.kept[low].shared_9, rest_of_shared_9);
                            rest_of_shared_11 = iteration
                                .kept[low]
                                .shared_6
                                .fma(
                                    iteration.kept[high].shared_10,
                                    iteration
                                        .kept[high]
                                        .shared_6
                                        .fma(iteration.kept[low].shared_10, rest_of_shared_11),
                                );
                            rest_of_shared_12 = iteration
                                .kept[low]
                                .shared_7
                                .fma(
                                    iteration.kept[high].shared_10,
                                    iteration
                                        .kept[high]
                                        .shared_7
                                        .fma(iteration.kept[low].shared_10, rest_of_shared_12),
                                );
                        }
                        let shared_5 = if order == 0 {
                            iteration.over_shared_5 = Wide::of(1.0) / shared_4;
                            runtime::half_power(shared_4, -8)
                        } else {
                            shared_4
                                .fma(
                                    Wide::of(-4.0) * iteration.kept[0].shared_5
                                        * iteration.over_shared_5,
                                    runtime::div_by_order(
                                        rest_of_shared_5 * iteration.over_shared_5,
                                        order,
                                    ),
                                )
                        };
                        iteration.kept[order].shared_5 = shared_5;
                        let shared_6 = Wide::of(2.0) * shared_2;
                        iteration.kept[order].shared_6 = shared_6;
                        let shared_7 = Wide::of(2.0) * shared_0;
                        iteration.kept[order].shared_7 = shared_7;
                        let shared_8 = shared_4 + step;
                        iteration.kept[order].shared_8 = shared_8;
                        let shared_9 = if order == 0 {
                            iteration.over_shared_9 = Wide::of(1.0) / shared_8;
                            runtime::half_power(shared_8, -2)
                        } else {
                            shared_8
                                .fma(
                                    Wide::of(-1.0) * iteration.kept[0].shared_9
                                        * iteration.over_shared_9,
                                    runtime::div_by_order(
                                        rest_of_shared_9 * iteration.over_shared_9,
                                        order,
                                    ),
                                )
                        };
                        iteration.kept[order].shared_9 = shared_9;
                        let shared_10 = Wide::of(3.0).fma(shared_5, shared_9);
                        iteration.kept[order].shared_10 = shared_10;
                        let shared_11 = if order == 0 {
                            (shared_6 * shared_10)
                        } else {
                            iteration
                                .kept[0]
                                .shared_6
                                .fma(
                                    shared_10,
                                    shared_6.fma(iteration.kept[0].shared_10, rest_of_shared_11),
                                )
                        };
                        let shared_12 = if order == 0 {
                            (shared_7 * shared_10)
                        } else {
                            iteration
                                .kept[0]
                                .shared_7
                                .fma(
                                    shared_10,
                                    shared_7.fma(iteration.kept[0].shared_10, rest_of_shared_12),
                                )
                        };
                        results[0][at] = Wide::select(
                            condition_0,
                            shared_12,
                            Wide::of(0.0),
                        );
                        results[1][at] = Wide::select(
                            condition_0,
                            shared_11,
                            Wide::of(0.0),
                        );
                        choice_1 = Wide::select(condition_0, -shared_12, choice_1);
                        choice_0 = Wide::select(condition_0, -shared_11, choice_0);
                    }
                    results[2][at] = choice_1;
                    results[3][at] = choice_0;
                }
                results
            }
            let times = [order, order + 1]
                .map(|order| runtime::time_coefficients(order, time, q.unit()));
            if order == 0 && tape.iterations_1.is_empty() {
                for k in 0..length {
                    for j in 0..k {
                        tape.iterations_1
                            .push([k, j], [], [j, stride + j, k, stride + k]);
                    }
                }
                tape.iterations_1
                    .build(
                        layout,
                        [
                            runtime::Target::momentum(0).negated(),
                            runtime::Target::momentum(1).negated(),
                            runtime::Target::momentum(2).negated(),
                            runtime::Target::momentum(3).negated(),
                        ],
                    );
            }
            for (block, results) in tape.iterations_1.blocks() {
                let [read_0, read_2] = block.read(0, q, order);
                let [read_1, read_3] = block.read(1, q, order);
                *results = iteration_1::<
                    Scalar,
                    runtime::Wide<Scalar>,
                >(
                    &mut block.kept,
                    [read_0, read_1, read_2, read_3],
                    block.constants,
                    [runtime::splat(parameters.reach)],
                    order,
                    [runtime::splat(times[0].0), runtime::splat(times[1].0)],
                );
            }
            tape.iterations_1.add_to_momenta(p, order + 1);
            tape.inverse_mass.next_order(q, p, order + 1);
            tape.inverse_mass.next_order(q, p, order + 2);
        }
        const HAS_EDGES: bool = true;
        fn edges<Scalar: runtime::Real>(
            parameters: &Self::Parameters<Scalar>,
            length: usize,
            q: &runtime::Coefficients<'_, Scalar>,
            _p: &runtime::Coefficients<'_, Scalar>,
            _time: Scalar,
            watch: &mut dyn runtime::Watch<Scalar>,
        ) {
            let stride = q.stride();
            for k in 0..length {
                let q_k_0 = q[0][k];
                let q_k_1 = q[0][stride + k];
                for j in 0..k {
                    let shared_0 = q_k_0 - q[0][j];
                    let shared_1 = q_k_1 - q[0][stride + j];
                    let condition_0 = {
                        watch
                            .less(
                                shared_0.square() + shared_1.square(),
                                parameters.reach,
                            )
                    };
                }
            }
        }
    }
};
