struct System {
    static constexpr int COORDINATES = 6;
    static constexpr int CONSTANTS = 6;
    static constexpr int PARTS = 2;
    static constexpr bool PAIRED = false;
    static constexpr bool BENDS = false;

    template <class R> struct Parameters {
        R weight[3];
        R coupled;
        R edge;
        R prepared_3;
        template <class Source> DEVICE explicit Parameters(const Source& number) {
            for (int i0 = 0; i0 < 3; ++i0) {
                weight[i0] = R(number(0 + i0));
            }
            coupled = R(number(3));
            edge = R(number(4));
            prepared_3 = R(number(5));
        }
    };

    template <class R, class K> struct Motion {
        K q[3][2];
        K p[3][2];
        Parameters<R> parameters;
        DEVICE explicit Motion(const Parameters<R>& parameters) : parameters(parameters) {}
        DEVICE K& position(int i) { return q[i / 2][i % 2]; }
        DEVICE K& momentum(int i) { return p[i / 2][i % 2]; }
    };

    template <class R, class K> DEVICE static void drift(Motion<R, K>& motion, double duration, double at) {
        const R step = R(duration);
        for (long long i = 0; i < 3; ++i) {
            const R p_i_0 = motion.p[i][0].value();
            motion.q[i][0].add(step * p_i_0 / sqrt(fma(p_i_0, p_i_0, R(1.0))));
            motion.q[i][1].fma(step * motion.parameters.weight[i], motion.p[i][1].value());
        }
    }

    template <class R, class K> DEVICE static void kick(Motion<R, K>& motion, double duration, double at) {
        const R step = R(-duration);
        const R time = R(at);
        {
            R gradient[3][2] = {};
            const R shared_2 = cos(time);
            const bool condition_1 = (R(0.0) < motion.parameters.coupled);
            for (long long i = 0; i < 3; ++i) {
                const R q_i_0 = motion.q[i][0].value();
                const R shared_0 = abs(q_i_0);
                const bool condition_0 = (motion.parameters.edge < shared_0);
                if (condition_0) {
                    const R shared_1 = shared_0 - motion.parameters.edge;
                    gradient[i][0] = fma(motion.parameters.prepared_3 * (shared_1 * shared_1), signum(q_i_0), gradient[i][0]);
                }
                if (condition_1) {
                    gradient[i][0] = fma(R(0.1), motion.q[((i + 1) % 3)][1].value(), gradient[i][0]);
                    gradient[((i + 1) % 3)][1] = fma(R(0.1), q_i_0, gradient[((i + 1) % 3)][1]);
                }
                if (!condition_0) {
                    const R q_i_1 = motion.q[i][1].value();
                    gradient[i][1] = fma(R(2.0) * exp(-(q_i_1 * q_i_1)) * shared_2, q_i_1, gradient[i][1]);
                }
            }
            for (int i = 0; i < 3; ++i) {
                for (int d = 0; d < 2; ++d) {
                    motion.p[i][d].fma(step, gradient[i][d]);
                }
            }
        }
    }

    template <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool backwards) {
    }
};
