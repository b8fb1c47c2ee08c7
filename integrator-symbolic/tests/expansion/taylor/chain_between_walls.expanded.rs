#[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
const _: () = {
    /// Coefficients of an order.
    #[derive(::core::clone::Clone, ::core::marker::Copy)]
    pub struct Iteration1Order<Scalar: runtime::Real> {
        shared_0: Scalar,
    }
    /// What an iteration of a loop keeps.
    pub struct Iteration1<Scalar: runtime::Real> {
        kept: [Iteration1Order<Scalar>; runtime::COEFFICIENTS],
    }
    impl<Scalar: runtime::Real> ::core::default::Default for Iteration1<Scalar> {
        fn default() -> Self {
            Self {
                kept: [Iteration1Order {
                    shared_0: Scalar::of(0.0),
                }; runtime::COEFFICIENTS],
            }
        }
    }
    /// Coefficients of an order.
    #[derive(::core::clone::Clone, ::core::marker::Copy)]
    pub struct TapeOrder<Scalar: runtime::Real> {
        shared_2: Scalar,
        shared_3: Scalar,
    }
    /// The coefficients that recurrences read.
    pub struct Tape<Scalar: runtime::Real> {
        kept: [TapeOrder<Scalar>; runtime::COEFFICIENTS],
        inverse_mass: runtime::InverseMass<Scalar>,
        iterations_1: runtime::Iterations<
            Scalar,
            Iteration1<runtime::Wide<Scalar>>,
            2,
            0,
            2,
            1,
            2,
        >,
    }
    impl<Scalar: runtime::Real> ::core::default::Default for Tape<Scalar> {
        fn default() -> Self {
            Self {
                kept: [TapeOrder {
                    shared_2: Scalar::of(0.0),
                    shared_3: Scalar::of(0.0),
                }; runtime::COEFFICIENTS],
                inverse_mass: ::core::default::Default::default(),
                iterations_1: ::core::default::Default::default(),
            }
        }
    }
    #[automatically_derived]
    impl runtime::Recurrences for Chain {
        type Tape<Scalar: runtime::Real> = Tape<Scalar>;
        const ROLLED: bool = true;
        const INTERLEAVED: bool = true;
        const ORDERS_PER_CALL: usize = 2;
        #[cfg_attr(not(debug_assertions), inline(always))]
        fn order<Scalar: runtime::Real>(
            _parameters: &Self::Parameters<Scalar>,
            _length: usize,
            q: &mut runtime::Coefficients<'_, Scalar>,
            p: &mut runtime::Coefficients<'_, Scalar>,
            tape: &mut Self::Tape<Scalar>,
            order: usize,
            _time: Scalar,
        ) {
            let layout = q.layout();
            let index_0 = layout.index(0, 0);
            let index_1 = layout.index(31, 0);
            if order == 0 {
                if tape.inverse_mass.is_empty() {
                    q[1].fill(Scalar::of(-0.0));
                    for k in 0..32 {
                        q[order + 1][layout.index(k, 0)] += Scalar::of(1.0);
                    }
                    tape.inverse_mass = runtime::InverseMass::of(&q[1]);
                }
                tape.inverse_mass.first_order(q, p);
            }
            for order in [order, order + 1] {
                p[order + 1].fill(Scalar::of(-0.0));
                let mut rest_of_shared_2 = Scalar::of(0.0);
                let mut rest_of_shared_3 = Scalar::of(0.0);
                let mut rest_of_shared_4 = Scalar::of(0.0);
                let mut rest_of_shared_5 = Scalar::of(0.0);
                if order > 0 && order % 2 == 0 {
                    let middle = order / 2;
                    rest_of_shared_2 = Scalar::of(0.5) * q[middle][index_1]
                        * q[middle][index_1];
                    rest_of_shared_3 = Scalar::of(0.5) * q[middle][index_0]
                        * q[middle][index_0];
                    rest_of_shared_4 = tape.kept[middle].shared_2 * q[middle][index_1];
                    rest_of_shared_5 = tape.kept[middle].shared_3 * q[middle][index_0];
                }
                for low in (1..order.div_ceil(2)).rev() {
                    let high = order - low;
                    rest_of_shared_2 = q[low][index_1]
                        .fma(q[high][index_1], rest_of_shared_2);
                    rest_of_shared_3 = q[low][index_0]
                        .fma(q[high][index_0], rest_of_shared_3);
                    rest_of_shared_4 = tape
                        .kept[low]
                        .shared_2
                        .fma(
                            q[high][index_1],
                            tape
                                .kept[high]
                                .shared_2
                                .fma(q[low][index_1], rest_of_shared_4),
                        );
                    rest_of_shared_5 = tape
                        .kept[low]
                        .shared_3
                        .fma(
                            q[high][index_0],
                            tape
                                .kept[high]
                                .shared_3
                                .fma(q[low][index_0], rest_of_shared_5),
                        );
                }
                let shared_2 = if order == 0 {
                    q[order][index_1] * q[order][index_1]
                } else {
                    Scalar::of(2.0)
                        * q[0][index_1].fma(q[order][index_1], rest_of_shared_2)
                };
                tape.kept[order].shared_2 = shared_2;
                let shared_3 = if order == 0 {
                    q[order][index_0] * q[order][index_0]
                } else {
                    Scalar::of(2.0)
                        * q[0][index_0].fma(q[order][index_0], rest_of_shared_3)
                };
                tape.kept[order].shared_3 = shared_3;
                let shared_4 = if order == 0 {
                    (shared_2 * q[order][index_1])
                } else {
                    tape.kept[0]
                        .shared_2
                        .fma(
                            q[order][index_1],
                            shared_2.fma(q[0][index_1], rest_of_shared_4),
                        )
                };
                let shared_5 = if order == 0 {
                    (shared_3 * q[order][index_0])
                } else {
                    tape.kept[0]
                        .shared_3
                        .fma(
                            q[order][index_0],
                            shared_3.fma(q[0][index_0], rest_of_shared_5),
                        )
                };
                p[order + 1][index_0] += -shared_5;
                p[order + 1][index_1] += -shared_4;
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn iteration_1<Scalar: runtime::Real, Wide: runtime::Row<Scalar>>(
                iteration: &mut Iteration1<Wide>,
                reads: [[Wide; 2]; 2],
                []: [Wide; 0],
                []: [Wide; 0],
                order: usize,
            ) -> [[Wide; 2]; 1] {
                let mut results = [[Wide::of(0.0); 2]; 1];
                let mut rest_of_shared_1 = [Wide::of(0.0); 2];
                if order > 0 {
                    let middle = order / 2;
                    rest_of_shared_1[0] = Wide::of(0.5) * iteration.kept[middle].shared_0
                        * iteration.kept[middle].shared_0;
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
                }
                for at in 0..2 {
                    let order = order + at;
                    let read_0 = reads[0][at];
                    let read_1 = reads[1][at];
                    if at == 1 && order > 1 {
                        let (low, high) = (1, order - 1);
                        rest_of_shared_1[1] = iteration
                            .kept[low]
                            .shared_0
                            .fma(iteration.kept[high].shared_0, rest_of_shared_1[1]);
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
                    results[0][at] = shared_1;
                }
                results
            }
            if order == 0 && tape.iterations_1.is_empty() {
                for i in 1..32 {
                    tape.iterations_1
                        .push(
                            [layout.index(i, 0), layout.index(i - 1, 0)],
                            [],
                            [layout.index(i, 0), layout.index(i - 1, 0)],
                        );
                }
                tape.iterations_1
                    .build(
                        layout,
                        [
                            runtime::Target::momentum(0).negated(),
                            runtime::Target::momentum(0),
                        ],
                    );
            }
            for (block, results) in tape.iterations_1.blocks() {
                let [read_0] = block.read(0, q, order);
                let [read_1] = block.read(1, q, order);
                *results = iteration_1::<
                    Scalar,
                    runtime::Wide<Scalar>,
                >(&mut block.kept, [read_0, read_1], block.constants, [], order);
            }
            tape.iterations_1.add_to_momenta(p, order + 1);
            tape.inverse_mass.next_order(q, p, order + 1);
            tape.inverse_mass.next_order(q, p, order + 2);
        }
    }
};
