struct System {
    static constexpr int COORDINATES = 12;
    static constexpr int CONSTANTS = 22;
    static constexpr int PARTS = 2;
    static constexpr bool PAIRED = false;
    static constexpr bool BENDS = true;

    template <class R> struct Parameters {
        R stiffness[11];
        R prepared_1[11];
        template <class Source> DEVICE explicit Parameters(const Source& number) {
            for (int i0 = 0; i0 < 11; ++i0) {
                stiffness[i0] = R(number(0 + i0));
            }
            for (int i0 = 0; i0 < 11; ++i0) {
                prepared_1[i0] = R(number(11 + i0));
            }
        }
    };

    template <class R, class K> struct Motion {
        K q[12];
        K p[12];
        Parameters<R> parameters;
        DEVICE explicit Motion(const Parameters<R>& parameters) : parameters(parameters) {}
        DEVICE K& position(int i) { return q[i]; }
        DEVICE K& momentum(int i) { return p[i]; }
    };

    template <class R, class K> DEVICE static void drift_of_site(Motion<R, K>& motion, long long k, double at, R (&contribution)[1]) {
        contribution[0] = motion.p[k].value();
    }

    template <class R, class K> DEVICE static void drift(Motion<R, K>& motion, double duration, double at) {
        const R step = R(duration);
        for (long long site = 0; site < 12; ++site) {
            R own[1] = {};
            drift_of_site(motion, site, at, own);
            R sum = own[0];
            motion.q[site].fma(step, sum);
        }
    }

    template <class R, class K> DEVICE static void kick_of_site(Motion<R, K>& motion, long long k, double at, R (&contribution)[3]) {
        const R time = R(at);
        const R shared_0 = R(0.25) * fma(R(0.2), cos(time), R(1.0));
        const R q_k = motion.q[k].value();
        const R shared_1 = (k + 1 < 12 ? motion.q[k + 1].value() : R(0.0)) - q_k;
        const R shared_2 = shared_0 * ((k + 2 < 12 ? motion.q[k + 2].value() : R(0.0)) - q_k);
        const R shared_3 = element_of(motion.parameters.stiffness, k) * (shared_1 * shared_1 * shared_1);
        contribution[0] = (0 <= k && k < 11 ? -shared_3 : R(0.0));
        contribution[0] = contribution[0] + (0 <= k && k < 10 ? -shared_2 : R(0.0));
        if (0 <= k && k < 1) contribution[0] = contribution[0] + (R(2.0) * q_k);
        if (11 <= k && k < 12) contribution[0] = contribution[0] + (R(4.0) * (q_k * q_k * q_k));
        contribution[1] = (0 <= k && k < 11 ? shared_3 : R(0.0));
        contribution[2] = (0 <= k && k < 10 ? shared_2 : R(0.0));
    }

    template <class R, class K> DEVICE static void kick(Motion<R, K>& motion, double duration, double at) {
        const R step = R(-duration);
        R carried[2][3] = {};
        for (long long site = 0; site < 12; ++site) {
            R own[3] = {};
            kick_of_site(motion, site, at, own);
            R sum = own[0];
            sum = sum + carried[0][1];
            sum = sum + carried[1][2];
            motion.p[site].fma(step, sum);
            for (int k = 0; k < 3; ++k) {
                carried[1][k] = carried[0][k];
            }
            for (int k = 0; k < 3; ++k) {
                carried[0][k] = own[k];
            }
        }
    }

    template <class R, class K> DEVICE static void middle(Motion<R, K>& motion, double duration, double at, bool backwards) {
    }

    template <class R> DEVICE static void hessian(Motion<R, Plain<R>>& motion, double at) {
        const R time = R(at);
        R gradient[12] = {};
        const R q11 = motion.q[11].value();
        const R shared_1 = R(0.25) * fma(R(0.2), cos(time), R(1.0));
        for (long long i = 0; i < 11; ++i) {
            const R shared_0 = motion.q[(i + 1)].value() - motion.q[i].value();
            const R shared_3 = motion.parameters.prepared_1[i] * (motion.p[(i + 1)].value() - motion.p[i].value()) * (shared_0 * shared_0);
            gradient[(i + 1)] += shared_3;
            gradient[i] -= shared_3;
        }
        for (long long i = 0; i < 10; ++i) {
            const R shared_2 = shared_1 * (motion.p[(i + 2)].value() - motion.p[i].value());
            gradient[(i + 2)] += shared_2;
            gradient[i] -= shared_2;
        }
        gradient[0] = fma(R(2.0), motion.p[0].value(), gradient[0]);
        gradient[11] = fma(R(12.0) * (q11 * q11), motion.p[11].value(), gradient[11]);
        for (int i = 0; i < 12; ++i) {
            motion.p[i] = Plain<R>{gradient[i]};
        }
    }
};
