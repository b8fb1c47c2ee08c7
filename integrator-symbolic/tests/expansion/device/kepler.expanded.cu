struct System {
    static constexpr int COORDINATES = 3;
    static constexpr int CONSTANTS = 2;
    static constexpr int PARTS = 2;
    static constexpr bool PAIRED = false;
    static constexpr bool BENDS = true;

    template <class R> struct Parameters {
        R prepared_0;
        R prepared_1;
        template <class Source> DEVICE explicit Parameters(const Source& number) {
            prepared_0 = R(number(0));
            prepared_1 = R(number(1));
        }
    };

    template <class R, class K> struct Motion {
        K q[3];
        K p[3];
        Parameters<R> parameters;
        DEVICE explicit Motion(const Parameters<R>& parameters) : parameters(parameters) {}
        DEVICE K& position(int i) { return q[i]; }
        DEVICE K& momentum(int i) { return p[i]; }
    };

    template <class R, class K> DEVICE static void drift(Motion<R, K>& motion, double duration, double at) {
        const R step = R(duration);
        for (long long k = 0; k < 3; ++k) {
            motion.q[k].fma(step, motion.p[k].value());
        }
    }

    template <class R, class K> DEVICE static void kick(Motion<R, K>& motion, double duration, double at) {
        const R step = R(-duration);
        R sum_0 = R(0.0);
        for (long long k = 0; k < 3; ++k) {
            const R q_k = motion.q[k].value();
            sum_0 = fma(q_k, q_k, sum_0);
        }
        const R shared_0 = div_pow_3_2(step * motion.parameters.prepared_0, sum_0);
        for (long long k = 0; k < 3; ++k) {
            const R q_k = motion.q[k].value();
            motion.p[k].fma(-shared_0, q_k);
        }
    }

    template <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool backwards) {
    }

    template <class R> DEVICE static void hessian(Motion<R, Plain<R>>& motion, double at) {
        R gradient[3] = {};
        R sum_0 = R(0.0);
        R sum_1 = R(0.0);
        for (long long k = 0; k < 3; ++k) {
            const R p_k = motion.p[k].value();
            const R q_k = motion.q[k].value();
            sum_1 = fma(p_k, q_k, sum_1);
            sum_0 = fma(q_k, q_k, sum_0);
        }
        const R shared_0 = R(1.0) / sum_0;
        const R shared_1 = sqrt(shared_0);
        const R shared_2 = motion.parameters.prepared_0 * (shared_0 * shared_1);
        const R shared_3 = motion.parameters.prepared_1 * sum_1 * (shared_0 * shared_0 * shared_1);
        for (long long k = 0; k < 3; ++k) {
            const R p_k = motion.p[k].value();
            const R q_k = motion.q[k].value();
            gradient[k] += fma(-shared_2, p_k, shared_3 * q_k);
        }
        for (int i = 0; i < 3; ++i) {
            motion.p[i] = Plain<R>{gradient[i]};
        }
    }
};
