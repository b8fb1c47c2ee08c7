struct System {
    static constexpr int COORDINATES = 4;
    static constexpr int CONSTANTS = 37;
    static constexpr int PARTS = 2;
    static constexpr bool PAIRED = false;
    static constexpr bool BENDS = true;

    template <class R> struct Parameters {
        long long site;
        long long count;
        R prepared_1[16];
        long long partner[16];
        R prepared_4;
        long long path_2;
        R prepared_5;
        template <class Source> DEVICE explicit Parameters(const Source& number) {
            site = (long long)number(0);
            count = (long long)number(1);
            for (int i0 = 0; i0 < 16; ++i0) {
                prepared_1[i0] = R(number(2 + i0));
            }
            for (int i0 = 0; i0 < 16; ++i0) {
                partner[i0] = (long long)number(18 + i0);
            }
            prepared_4 = R(number(34));
            path_2 = (long long)number(35);
            prepared_5 = R(number(36));
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

    template <class R, class K> DEVICE static void drift(Motion<R, K>& motion, double duration, double at) {
        const R step = R(duration);
        for (long long k = 0; k < 4; ++k) {
            motion.q[k].fma(step, motion.p[k].value());
        }
    }

    template <class R, class K> DEVICE static void kick(Motion<R, K>& motion, double duration, double at) {
        const R step = R(-duration);
        {
            R gradient[4] = {};
            const R shared_0 = motion.q[motion.parameters.site].value();
            for (long long i = 0; i < motion.parameters.count; ++i) {
                const R shared_1 = motion.parameters.prepared_1[i] * (motion.q[i].value() - motion.q[motion.parameters.partner[i]].value());
                gradient[i] += shared_1;
                gradient[motion.parameters.partner[i]] -= shared_1;
            }
            gradient[motion.parameters.site] = fma(motion.parameters.prepared_4, shared_0 * shared_0 * shared_0, gradient[motion.parameters.site]);
            gradient[motion.parameters.path_2] -= sin(motion.q[motion.parameters.path_2].value());
            for (int i = 0; i < 4; ++i) {
                motion.p[i].fma(step, gradient[i]);
            }
        }
    }

    template <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool backwards) {
    }

    template <class R> DEVICE static void hessian(Motion<R, Plain<R>>& motion, double at) {
        R gradient[4] = {};
        const R shared_0 = motion.q[motion.parameters.site].value();
        for (long long i = 0; i < motion.parameters.count; ++i) {
            const R shared_1 = motion.parameters.prepared_1[i] * (motion.p[i].value() - motion.p[motion.parameters.partner[i]].value());
            gradient[i] += shared_1;
            gradient[motion.parameters.partner[i]] -= shared_1;
        }
        gradient[motion.parameters.site] = fma(motion.parameters.prepared_5 * motion.p[motion.parameters.site].value(), shared_0 * shared_0, gradient[motion.parameters.site]);
        gradient[motion.parameters.path_2] = fma(-cos(motion.q[motion.parameters.path_2].value()), motion.p[motion.parameters.path_2].value(), gradient[motion.parameters.path_2]);
        for (int i = 0; i < 4; ++i) {
            motion.p[i] = Plain<R>{gradient[i]};
        }
    }
};
