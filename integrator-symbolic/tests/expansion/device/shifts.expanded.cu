struct System {
    static constexpr int COORDINATES = 2;
    static constexpr int CONSTANTS = 3;
    static constexpr int PARTS = 3;
    static constexpr bool PAIRED = false;
    static constexpr bool BENDS = false;

    template <class R> struct Parameters {
        R number_;
        R prepared_1;
        R prepared_2;
        template <class Source> DEVICE explicit Parameters(const Source& number) {
            number_ = R(number(0));
            prepared_1 = R(number(1));
            prepared_2 = R(number(2));
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
        const R time = R(at);
        {
            const R step = R(-1.0);
            const R shared_0 = sin(fma(motion.parameters.number_, motion.q[0].value(), -motion.q[1].value()) - time);
            motion.p[0].fma(step * R(0.7), shared_0);
            motion.p[1].fma(-(step * motion.parameters.prepared_1), shared_0);
        }
        {
            const R step = R(duration);
            motion.q[0].fma(step, motion.p[0].value());
        }
        {
            const R step = R(1.0);
            const R shared_0 = sin(fma(motion.parameters.number_, motion.q[0].value(), -motion.q[1].value()) - time);
            motion.p[0].fma(step * R(0.7), shared_0);
            motion.p[1].fma(-(step * motion.parameters.prepared_1), shared_0);
        }
    }

    template <class R, class K> DEVICE static void middle_1(Motion<R, K>& motion, double duration, double at) {
        {
            const R step = R(-1.0);
            const R q1 = motion.q[1].value();
            motion.p[1].fma(-(step * motion.q[0].value() * q1), q1);
            motion.p[0].fma(step * motion.parameters.prepared_2, q1 * q1 * q1);
        }
        {
            const R step = R(duration);
            motion.q[1].fma(step, motion.p[1].value());
        }
        {
            const R step = R(1.0);
            const R q1 = motion.q[1].value();
            motion.p[1].fma(-(step * motion.q[0].value() * q1), q1);
            motion.p[0].fma(step * motion.parameters.prepared_2, q1 * q1 * q1);
        }
    }

    template <class R, class K> DEVICE static void kick(Motion<R, K>& motion, double duration, double at) {
        const R step = R(-duration);
        motion.p[0].fma(step, motion.q[0].value());
        motion.p[1].fma(step, motion.q[1].value());
    }

    template <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool backwards) {
        middle_1(motion, duration, at);
    }
};
