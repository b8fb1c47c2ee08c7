struct System {
    static constexpr int COORDINATES = 1;
    static constexpr int CONSTANTS = 3;
    static constexpr int PARTS = 2;
    static constexpr bool PAIRED = false;
    static constexpr bool BENDS = true;

    template <class R> struct Parameters {
        R prepared_0;
        R weight;
        R spring;
        template <class Source> DEVICE explicit Parameters(const Source& number) {
            prepared_0 = R(number(0));
            weight = R(number(1));
            spring = R(number(2));
        }
    };

    template <class R, class K> struct Motion {
        K q[1];
        K p[1];
        Parameters<R> parameters;
        DEVICE explicit Motion(const Parameters<R>& parameters) : parameters(parameters) {}
        DEVICE K& position(int i) { return q[i]; }
        DEVICE K& momentum(int i) { return p[i]; }
    };

    template <class R, class K> DEVICE static void drift(Motion<R, K>& motion, double duration, double at) {
        const R step = R(duration);
        motion.q[0].fma(step * motion.parameters.prepared_0, motion.p[0].value());
    }

    template <class R, class K> DEVICE static void kick(Motion<R, K>& motion, double duration, double at) {
        const R step = R(-duration);
        const R q0 = motion.q[0].value();
        R shared_0, shared_2;
        library_sin_cos(q0, shared_0, shared_2);
        const R shared_1 = shared_0 + R(1.0);
        const R shared_3 = library_cosh(q0);
        const R shared_4 = shared_3 * shared_3;
        const bool condition_0 = (huge<R>() < shared_4);
        R choice_0 = R(0.0);
        if (!condition_0) {
            choice_0 = R(1.0) / shared_4;
        }
        motion.p[0].fma(step, fma(motion.parameters.weight * abs(shared_2) / shared_1, shared_2, fma(-(motion.parameters.weight * library_ln(shared_1) * signum(shared_2)), shared_0, fma(motion.parameters.spring, library_sinh(q0), -choice_0))));
    }

    template <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool backwards) {
    }

    template <class R> DEVICE static void hessian(Motion<R, Plain<R>>& motion, double at) {
        R gradient[1] = {};
        const R p0 = motion.p[0].value();
        const R q0 = motion.q[0].value();
        R shared_0, shared_2;
        library_sin_cos(q0, shared_0, shared_2);
        const R shared_1 = shared_0 + R(1.0);
        const R shared_3 = abs(shared_2);
        const R shared_4 = library_cosh(q0);
        const R shared_5 = signum(shared_2);
        const R shared_6 = shared_4 * shared_4;
        const bool condition_0 = (huge<R>() < shared_6);
        const R shared_7 = R(1.0) / shared_1;
        const R shared_8 = motion.parameters.weight * p0;
        const R shared_9 = shared_8 * shared_2;
        if (!condition_0) {
            gradient[0] += R(2.0) * p0 * library_sinh(q0) / (shared_6 * shared_4);
        }
        gradient[0] += fma(-shared_2, fma(shared_8 * shared_0 * shared_5, shared_7, fma(shared_8 * library_ln(shared_1), shared_5, shared_9 * shared_3 * (shared_7 * shared_7))), fma(-shared_0, fma(shared_9 * shared_5, shared_7, shared_8 * shared_3 * shared_7), motion.parameters.spring * p0 * shared_4));
        for (int i = 0; i < 1; ++i) {
            motion.p[i] = Plain<R>{gradient[i]};
        }
    }
};
