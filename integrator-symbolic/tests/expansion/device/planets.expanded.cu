struct System {
    static constexpr int COORDINATES = 18;
    static constexpr int CONSTANTS = 29;
    static constexpr int PARTS = 2;
    static constexpr bool PAIRED = false;
    static constexpr bool BENDS = true;

    template <class R> struct Parameters {
        R prepared_0[6];
        R prepared_1[6];
        R mass[6];
        R mass_2[5];
        R prepared_4[6];
        template <class Source> DEVICE explicit Parameters(const Source& number) {
            for (int i0 = 0; i0 < 6; ++i0) {
                prepared_0[i0] = R(number(0 + i0));
            }
            for (int i0 = 0; i0 < 6; ++i0) {
                prepared_1[i0] = R(number(6 + i0));
            }
            for (int i0 = 0; i0 < 6; ++i0) {
                mass[i0] = R(number(12 + i0));
            }
            for (int i0 = 0; i0 < 5; ++i0) {
                mass_2[i0] = R(number(18 + i0));
            }
            for (int i0 = 0; i0 < 6; ++i0) {
                prepared_4[i0] = R(number(23 + i0));
            }
        }
    };

    template <class R, class K> struct Motion {
        K q[6][3];
        K p[6][3];
        Parameters<R> parameters;
        DEVICE explicit Motion(const Parameters<R>& parameters) : parameters(parameters) {}
        DEVICE K& position(int i) { return q[i / 3][i % 3]; }
        DEVICE K& momentum(int i) { return p[i / 3][i % 3]; }
    };

    static constexpr int BODIES = 6;
    static constexpr bool CENTRAL = false;
    static constexpr bool RECIPROCAL = true;
    static constexpr bool ALONE = false;

    template <class R, class K> DEVICE static void drift(Motion<R, K>& motion, double duration, double at) {
        const R step = R(duration);
        for (long long i = 0; i < 6; ++i) {
            const R shared_0 = step * motion.parameters.prepared_0[i];
            for (long long d = 0; d < 3; ++d) {
                motion.q[i][d].fma(shared_0, motion.p[i][d].value());
            }
        }
    }

    template <class R, class K> DEVICE static void force(Motion<R, K>& motion, int i, int j, double at, R (&gradient)[3]) {
        R sum_0 = R(0.0);
        for (long long d = 0; d < 3; ++d) {
            const R q_i_d = motion.q[i][d].value();
            const R q_j_d = motion.q[j][d].value();
            const R shared_0 = q_i_d - q_j_d;
            sum_0 = fma(shared_0, shared_0, sum_0);
        }
        const R shared_1 = div_pow_3_2(motion.parameters.prepared_1[i] * motion.parameters.mass[j], sum_0);
        for (long long d = 0; d < 3; ++d) {
            const R q_i_d = motion.q[i][d].value();
            const R q_j_d = motion.q[j][d].value();
            const R shared_0 = q_i_d - q_j_d;
            gradient[d] = shared_1 * shared_0;
        }
    }

    template <class R, class K> DEVICE static void kick(Motion<R, K>& motion, double duration, double at) {
        Pairs<System, R, K>::kick(motion, duration, at);
    }

    template <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool backwards) {
    }

    template <class R> DEVICE static void hessian(Motion<R, Plain<R>>& motion, double at) {
        R gradient[6][3] = {};
        for (long long i = 0; i < 6; ++i) {
            for (long long j = 0; j < i; ++j) {
                R sum_0 = R(0.0);
                R sum_1 = R(0.0);
                for (long long d = 0; d < 3; ++d) {
                    const R q_i_d = motion.q[i][d].value();
                    const R q_j_d = motion.q[j][d].value();
                    const R shared_0 = q_i_d - q_j_d;
                    const R p_i_d = motion.p[i][d].value();
                    const R p_j_d = motion.p[j][d].value();
                    const R shared_1 = p_i_d - p_j_d;
                    sum_1 = fma(shared_0, shared_1, sum_1);
                    sum_0 = fma(shared_0, shared_0, sum_0);
                }
                const R shared_2 = R(1.0) / sum_0;
                const R shared_3 = sqrt(shared_2);
                const R shared_4 = motion.parameters.prepared_1[i] * motion.parameters.mass_2[j] * (shared_2 * shared_3);
                const R shared_5 = motion.parameters.prepared_4[i] * motion.parameters.mass_2[j] * sum_1 * (shared_2 * shared_2 * shared_3);
                for (long long d = 0; d < 3; ++d) {
                    const R q_i_d = motion.q[i][d].value();
                    const R q_j_d = motion.q[j][d].value();
                    const R shared_0 = q_i_d - q_j_d;
                    const R p_i_d = motion.p[i][d].value();
                    const R p_j_d = motion.p[j][d].value();
                    const R shared_1 = p_i_d - p_j_d;
                    const R shared_6 = fma(-shared_5, shared_0, shared_4 * shared_1);
                    gradient[i][d] += shared_6;
                    gradient[j][d] -= shared_6;
                }
            }
        }
        for (int i = 0; i < 6; ++i) {
            for (int d = 0; d < 3; ++d) {
                motion.p[i][d] = Plain<R>{gradient[i][d]};
            }
        }
    }
};
