struct System {
    static constexpr int COORDINATES = 2;
    static constexpr int CONSTANTS = 4;
    static constexpr int PARTS = 3;
    static constexpr bool PAIRED = false;
    static constexpr bool BENDS = false;

    template <class R> struct Parameters {
        R prepared_0;
        R rate;
        R depth;
        R prepared_3;
        template <class Source> DEVICE explicit Parameters(const Source& number) {
            prepared_0 = R(number(0));
            rate = R(number(1));
            depth = R(number(2));
            prepared_3 = R(number(3));
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
        const R p1 = motion.p[1].value();
        const R q0 = motion.q[0].value();
        motion.p[0].fma(-step, fma(motion.parameters.rate * p1, q0, motion.parameters.rate * q0 * p1));
        motion.q[1].fma(step * motion.parameters.rate * q0, q0);
    }

    template <class R, class K> DEVICE static void kick(Motion<R, K>& motion, double duration, double at) {
        const R step = R(-duration);
        motion.p[0].fma(-(step * motion.parameters.depth), sin(motion.q[0].value()));
        motion.p[1].fma(step * motion.parameters.prepared_3, motion.q[1].value());
    }

    template <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool backwards) {
        middle_1(motion, duration, at);
    }
};
