struct System {
    static constexpr int COORDINATES = 2;
    static constexpr int CONSTANTS = 5;
    static constexpr int PARTS = 3;
    static constexpr bool PAIRED = false;
    static constexpr bool BENDS = false;

    template <class R> struct Parameters {
        R prepared_0;
        R prepared_1;
        R rate;
        R depth;
        R prepared_4;
        template <class Source> DEVICE explicit Parameters(const Source& number) {
            prepared_0 = R(number(0));
            prepared_1 = R(number(1));
            rate = R(number(2));
            depth = R(number(3));
            prepared_4 = R(number(4));
        }
    };

    template <class R, class K> struct Motion {
        K q[2];
        K p[2];
        Parameters<R> parameters;
        DEVICE explicit Motion(const Parameters<R>& parameters) : parameters(parameters) {}
        DEVICE K& position(int i) { return q[i]; }
        DEVICE K& momentum(int i) { return p[i]; }
    };

    template <class R, class K> DEVICE static void drift(Motion<R, K>& motion, double duration, double at) {
        const R step = R(duration);
        const R shared_0 = step * motion.parameters.prepared_0;
        motion.q[0].fma(shared_0, motion.p[0].value());
        motion.q[1].fma(shared_0, motion.p[1].value());
    }

    template <class R, class K> DEVICE static void middle_1(Motion<R, K>& motion, double duration, double at) {
        const R step = R(duration);
        const R q0 = motion.q[0].value();
        motion.p[0].fma(-(step * motion.parameters.prepared_1 * motion.p[1].value()), q0);
        motion.q[1].fma(step * motion.parameters.rate * q0, q0);
    }

    template <class R, class K> DEVICE static void kick(Motion<R, K>& motion, double duration, double at) {
        const R step = R(-duration);
        motion.p[0].fma(-(step * motion.parameters.depth), sin(motion.q[0].value()));
        motion.p[1].fma(step * motion.parameters.prepared_4, motion.q[1].value());
    }

    template <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool backwards) {
        middle_1(motion, duration, at);
    }
};
