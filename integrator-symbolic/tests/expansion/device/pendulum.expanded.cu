struct System {
    static constexpr int COORDINATES = 1;
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
        motion.p[0].fma(-(step * motion.parameters.prepared_1), sin(motion.q[0].value()));
    }

    template <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool backwards) {
    }

    template <class R> DEVICE static void hessian(Motion<R, Plain<R>>& motion, double at) {
        R gradient[1] = {};
        gradient[0] = fma(-(motion.parameters.prepared_1 * motion.p[0].value()), cos(motion.q[0].value()), gradient[0]);
        for (int i = 0; i < 1; ++i) {
            motion.p[i] = Plain<R>{gradient[i]};
        }
    }
};
