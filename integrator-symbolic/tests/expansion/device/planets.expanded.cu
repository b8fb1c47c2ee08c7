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
    static constexpr bool CENTRAL = true;
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

    template <class R, class K> DEVICE static R pull(Motion<R, K>& motion, int i, int j, double at) {
        const R q_i_0 = motion.q[i][0].value();
        const R q_i_1 = motion.q[i][1].value();
        const R q_i_2 = motion.q[i][2].value();
        const R shared_0 = q_i_0 - motion.q[j][0].value();
        const R shared_1 = q_i_1 - motion.q[j][1].value();
        const R shared_2 = q_i_2 - motion.q[j][2].value();
        const R shared_3 = fma(shared_2, shared_2, fma(shared_1, shared_1, shared_0 * shared_0));
        return div_pow_3_2(motion.parameters.prepared_1[i] * motion.parameters.mass[j], shared_3);
    }

    template <class R, class K> DEVICE static void kick(Motion<R, K>& motion, double duration, double at) {
        Pairs<System, R, K>::kick(motion, duration, at);
    }

    template <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool backwards) {
    }

    template <class R> DEVICE static void hessian(Motion<R, Plain<R>>& motion, double at) {
        R gradient[6][3] = {};
        for (long long i = 0; i < 6; ++i) {
            const R q_i_0 = motion.q[i][0].value();
            const R q_i_1 = motion.q[i][1].value();
            const R q_i_2 = motion.q[i][2].value();
            const R p_i_0 = motion.p[i][0].value();
            const R p_i_1 = motion.p[i][1].value();
            const R p_i_2 = motion.p[i][2].value();
            R sum_0 = R(0.0);
            R sum_1 = R(0.0);
            R sum_2 = R(0.0);
            for (long long j = 0; j < i; ++j) {
                const R shared_0 = q_i_0 - motion.q[j][0].value();
                const R shared_1 = q_i_1 - motion.q[j][1].value();
                const R shared_2 = q_i_2 - motion.q[j][2].value();
                const R shared_3 = p_i_0 - motion.p[j][0].value();
                const R shared_4 = p_i_1 - motion.p[j][1].value();
                const R shared_5 = p_i_2 - motion.p[j][2].value();
                const R shared_6 = R(1.0) / fma(shared_2, shared_2, fma(shared_1, shared_1, shared_0 * shared_0));
                const R shared_7 = sqrt(shared_6);
                const R shared_8 = motion.parameters.prepared_1[i] * motion.parameters.mass_2[j] * (shared_6 * shared_7);
                const R shared_9 = motion.parameters.prepared_4[i] * motion.parameters.mass_2[j] * fma(shared_2, shared_5, fma(shared_1, shared_4, shared_0 * shared_3)) * (shared_6 * shared_6 * shared_7);
                const R shared_10 = fma(-shared_9, shared_2, shared_8 * shared_5);
                const R shared_11 = fma(-shared_9, shared_1, shared_8 * shared_4);
                const R shared_12 = fma(-shared_9, shared_0, shared_8 * shared_3);
                gradient[j][0] -= shared_12;
                gradient[j][1] -= shared_11;
                gradient[j][2] -= shared_10;
                sum_2 += shared_12;
                sum_1 += shared_11;
                sum_0 += shared_10;
            }
            gradient[i][0] += sum_2;
            gradient[i][1] += sum_1;
            gradient[i][2] += sum_0;
        }
        for (int i = 0; i < 6; ++i) {
            for (int d = 0; d < 3; ++d) {
                motion.p[i][d] = Plain<R>{gradient[i][d]};
            }
        }
    }
};
