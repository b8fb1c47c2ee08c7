struct System {
    static constexpr int COORDINATES = 16;
    static constexpr int CONSTANTS = 48;
    static constexpr int PARTS = 2;
    static constexpr bool PAIRED = false;
    static constexpr bool BENDS = true;

    template <class R> struct Parameters {
        R prepared_0[16];
        R alpha[16];
        R prepared_2[16];
        template <class Source> DEVICE explicit Parameters(const Source& number) {
            for (int i0 = 0; i0 < 16; ++i0) {
                prepared_0[i0] = R(number(0 + i0));
            }
            for (int i0 = 0; i0 < 16; ++i0) {
                alpha[i0] = R(number(16 + i0));
            }
            for (int i0 = 0; i0 < 16; ++i0) {
                prepared_2[i0] = R(number(32 + i0));
            }
        }
    };

    template <class R, class K> struct Motion {
        K q[16];
        K p[16];
        Parameters<R> parameters;
        DEVICE explicit Motion(const Parameters<R>& parameters) : parameters(parameters) {}
        DEVICE K& position(int i) { return q[i]; }
        DEVICE K& momentum(int i) { return p[i]; }
    };

    template <class R, class K> DEVICE static void drift_of_site(Motion<R, K>& motion, long long i, double at, R (&contribution)[1]) {
        contribution[0] = element_of(motion.parameters.prepared_0, i) * motion.p[i].value();
    }

    template <class R, class K> DEVICE static void drift(Motion<R, K>& motion, double duration, double at) {
        const R step = R(duration);
        for (long long site = 0; site < 16; ++site) {
            R own[1] = {};
            drift_of_site(motion, site, at, own);
            R sum = own[0];
            motion.q[site].fma(step, sum);
        }
    }

    template <class R, class K> DEVICE static void kick_of_site(Motion<R, K>& motion, long long i, double at, R (&contribution)[2]) {
        const R shared_0 = motion.q[(i + 1) % 16].value() - motion.q[i].value();
        const R shared_1 = fma(element_of(motion.parameters.alpha, i), shared_0 * shared_0, shared_0);
        contribution[0] = -shared_1;
        contribution[1] = shared_1;
    }

    template <class R, class K> DEVICE static void kick(Motion<R, K>& motion, double duration, double at) {
        const R step = R(-duration);
        R carried[1][2] = {};
        for (int behind = 1; behind <= 1; ++behind) {
            kick_of_site(motion, 16 - behind, at, carried[behind - 1]);
        }
        for (long long site = 0; site < 16; ++site) {
            R own[2] = {};
            kick_of_site(motion, site, at, own);
            R sum = own[0];
            sum = sum + carried[0][1];
            motion.p[site].fma(step, sum);
            for (int k = 0; k < 2; ++k) {
                carried[0][k] = own[k];
            }
        }
    }

    template <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool backwards) {
    }

    template <class R> DEVICE static void hessian(Motion<R, Plain<R>>& motion, double at) {
        R gradient[16] = {};
        for (long long i = 0; i < 16; ++i) {
            const R shared_0 = motion.p[((i + 1) % 16)].value() - motion.p[i].value();
            const R shared_1 = fma(motion.parameters.prepared_2[i] * shared_0, motion.q[((i + 1) % 16)].value() - motion.q[i].value(), shared_0);
            gradient[((i + 1) % 16)] += shared_1;
            gradient[i] -= shared_1;
        }
        for (int i = 0; i < 16; ++i) {
            motion.p[i] = Plain<R>{gradient[i]};
        }
    }
};
