// The kicks of bodies that act on each other in pairs, which are summed in the order of
// integrator-core/src/layout/bodies/pair_sums.rs: rotation `by` pairs each body with the one that is so many further on.

namespace integrator {

template <class System, class R, class K> struct Pairs {
    typedef typename System::template Motion<R, K> Motion;
    static constexpr int BODIES = System::BODIES, DIMENSION = System::COORDINATES / BODIES;
    typedef R Point[DIMENSION];

    DEVICE static R position(Motion& motion, int body, int d) { return motion.position(body * DIMENSION + d).value(); }

    // What body `j` does to body `i`, as the gradient of their energy.
    DEVICE static void force(Motion& motion, int i, int j, double at, Point& gradient) {
        if constexpr (System::CENTRAL) {
            const R radial = System::pull(motion, i, j, at);
            for (int d = 0; d < DIMENSION; ++d) gradient[d] = radial * (position(motion, i, d) - position(motion, j, d));
        } else {
            for (int d = 0; d < DIMENSION; ++d) gradient[d] = R(0.0);
            System::force(motion, i, j, at, gradient);
        }
    }

    // Where action is reaction, rotations by up to half of the bodies suffice; of an even number of them, the rotation by half
    // meets every pair twice, once from either side.
    DEVICE static void kick(Motion& motion, double duration, double at) {
        Point sum[BODIES] = {};
        if constexpr (System::ALONE) {
            for (int i = 0; i < BODIES; ++i) System::force_alone(motion, i, at, sum[i]);
        }
        for (int by = 1; System::RECIPROCAL ? 2 * by <= BODIES : by < BODIES; ++by) {
            Point forces[BODIES];
            for (int i = 0; i < BODIES; ++i) force(motion, i, (i + by) % BODIES, at, forces[i]);
            for (int i = 0; i < BODIES; ++i) {
                for (int d = 0; d < DIMENSION; ++d) {
                    R addend = forces[i][d];
                    if (System::RECIPROCAL && 2 * by != BODIES) addend = addend - forces[(i + BODIES - by) % BODIES][d];
                    sum[i][d] = System::ALONE || by > 1 ? sum[i][d] + addend : addend;
                }
            }
        }
        const R step = R(-duration);
        for (int i = 0; i < BODIES; ++i) {
            for (int d = 0; d < DIMENSION; ++d) {
                motion.momentum(i * DIMENSION + d).fma(step, sum[i][d]);
            }
        }
    }
};

}  // namespace integrator
