struct System {
    static constexpr int COORDINATES = 4;
    static constexpr int CONSTANTS = 19;
    static constexpr int PARTS = 2;
    static constexpr bool PAIRED = false;
    static constexpr bool BENDS = true;

    template <class R> struct Parameters {
        R prepared_1[4];
        R charge[4];
        R prepared_2[4];
        R prepared_4[4];
        R charge_2[3];
        template <class Source> DEVICE explicit Parameters(const Source& number) {
            for (int i0 = 0; i0 < 4; ++i0) {
                prepared_1[i0] = R(number(0 + i0));
            }
            for (int i0 = 0; i0 < 4; ++i0) {
                charge[i0] = R(number(4 + i0));
            }
            for (int i0 = 0; i0 < 4; ++i0) {
                prepared_2[i0] = R(number(8 + i0));
            }
            for (int i0 = 0; i0 < 4; ++i0) {
                prepared_4[i0] = R(number(12 + i0));
            }
            for (int i0 = 0; i0 < 3; ++i0) {
                charge_2[i0] = R(number(16 + i0));
            }
        }
    };

    template <class R, class K> struct Motion {
        K q[4];
        K p[4];
        Parameters<R> parameters;
        DEVICE explicit Motion(const Parameters<R>& parameters) : parameters(parameters) {}
        DEVICE K& position(int i) { return q[i]; }
        DEVICE K& momentum(int i) { return p[i]; }
    };

    static constexpr int BODIES = 4;
    static constexpr bool CENTRAL = false;
    static constexpr bool RECIPROCAL = false;
    static constexpr bool ALONE = true;

    template <class R, class K> DEVICE static void drift(Motion<R, K>& motion, double duration, double at) {
        const R step = R(duration);
        for (long long k = 0; k < 4; ++k) {
            motion.q[k].fma(step, motion.p[k].value());
        }
    }

    template <class R, class K> DEVICE static void force(Motion<R, K>& motion, int k, int j, double at, R (&gradient)[1]) {
        const R q_k = motion.q[k].value();
        const R q_j = motion.q[j].value();
        const R shared_0 = q_k - q_j;
        const R shared_1 = fma(shared_0, shared_0, R(1.0));
        gradient[0] = fma(-(motion.parameters.prepared_1[k] * motion.parameters.charge[j] / (shared_1 * shared_1)), shared_0, q_j * cos(q_k * q_j));
    }

    template <class R, class K> DEVICE static void force_alone(Motion<R, K>& motion, int k, double at, R (&gradient)[1]) {
        const R time = R(at);
        const R shared_0 = cos(time);
        gradient[0] = motion.parameters.prepared_2[k] * motion.q[k].value() * shared_0;
    }

    template <class R, class K> DEVICE static void kick(Motion<R, K>& motion, double duration, double at) {
        Pairs<System, R, K>::kick(motion, duration, at);
    }

    template <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool backwards) {
    }

    template <class R> DEVICE static void hessian(Motion<R, Plain<R>>& motion, double at) {
        const R time = R(at);
        R gradient[4] = {};
        const R shared_0 = cos(time);
        for (long long k = 0; k < 4; ++k) {
            const R p_k = motion.p[k].value();
            const R q_k = motion.q[k].value();
            R sum_0 = R(0.0);
            R sum_1 = R(0.0);
            R sum_2 = R(0.0);
            for (long long j = 0; j < k; ++j) {
                const R q_j = motion.q[j].value();
                const R shared_1 = q_k - q_j;
                const R shared_2 = q_k * q_j;
                R shared_3, shared_4;
                sin_cos(shared_2, shared_3, shared_4);
                const R p_j = motion.p[j].value();
                const R shared_5 = p_j - p_k;
                const R shared_6 = shared_3 * fma(p_k, q_j, q_k * p_j);
                const R shared_7 = R(1.0) / fma(shared_1, shared_1, R(1.0));
                const R shared_8 = shared_7 * shared_7;
                const R shared_9 = fma(-(motion.parameters.prepared_4[k] * motion.parameters.charge_2[j] * shared_1 * shared_5 * (shared_8 * shared_7)), shared_1, motion.parameters.prepared_1[k] * motion.parameters.charge_2[j] * shared_8 * shared_5);
                gradient[j] += fma(-shared_6, q_k, p_k * shared_4) - shared_9;
                sum_2 += shared_9;
                sum_1 = fma(shared_6, q_j, sum_1);
                sum_0 = fma(shared_4, p_j, sum_0);
            }
            gradient[k] += fma(motion.parameters.prepared_2[k] * p_k, shared_0, sum_0) - sum_1 + sum_2;
        }
        for (int i = 0; i < 4; ++i) {
            motion.p[i] = Plain<R>{gradient[i]};
        }
    }
};
