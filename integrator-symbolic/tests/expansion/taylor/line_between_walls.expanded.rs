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
    /// The coefficients that recurrences read.
    pub struct Tape<Scalar: runtime::Real> {
        inverse_mass: runtime::InverseMass<Scalar>,
        iterations_1: runtime::Line<
            Scalar,
            Iteration1<runtime::Bundle<Scalar>>,
            Iteration1<runtime::Wide<Scalar>>,
            1,
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
    impl runtime::Recurrences for Chain {
        type Tape<Scalar: runtime::Real> = Tape<Scalar>;
        const ROLLED: bool = true;
        const INTERLEAVED: bool = true;
        const ORDERS_PER_CALL: usize = 2;
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
            let layout = q.layout();
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
            const ENDS: runtime::Ends = runtime::Ends::Open {
                first_at_rest: true,
            };
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn iteration_1<Scalar: runtime::Real, Wide: runtime::Real>(
                iteration: &mut Iteration1<Wide>,
                reads: [[Wide; 2]; 2],
                []: [Wide; 0],
                [common_0,
                ]: [Wide; 1],
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
                    let shared_2 = common_0.fma(shared_1, shared_0);
                    results[0][at] = shared_2;
                }
                results
            }
            if tape.iterations_1.is_empty() {
                tape.iterations_1.build(layout, ENDS);
            }
            let mut few = runtime::Few::<Scalar, 1, 2, 5>::zero();
            for number in tape.iterations_1.singles(layout, ENDS) {
                let vectors = tape.iterations_1.single(number, layout, ENDS);
                let read_0 = vectors.next(q, order, ENDS);
                let read_1 = vectors.own(q, order);
                let results = iteration_1::<
                    Scalar,
                    _,
                >(
                    vectors.kept,
                    [read_0, read_1],
                    [],
                    [runtime::splat(parameters.alpha)],
                    order,
                );
                vectors.store(&mut few, results);
            }
            for number in tape.iterations_1.bundles(layout, ENDS) {
                let vectors = tape.iterations_1.bundle(number);
                let read_0 = vectors.next(q, order, ENDS);
                let read_1 = vectors.own(q, order);
                let results = iteration_1::<
                    Scalar,
                    _,
                >(
                    vectors.kept,
                    [read_0, read_1],
                    [],
                    [runtime::splat(parameters.alpha)],
                    order,
                );
                vectors.store(&mut few, results);
            }
            let sites = tape.iterations_1.computed(&few, layout, ENDS);
            let inverse_masses = tape.inverse_mass.of_all(layout);
            for vector in sites.vectors() {
                let before = sites.before(vector);
                let own = sites.own(vector);
                for at in 0..2 {
                    inverse_masses
                        .next_order_of(
                            vector,
                            own[0][at] - before[0][at],
                            q,
                            p,
                            order + at + 1,
                        );
                }
            }
        }
    }
};
