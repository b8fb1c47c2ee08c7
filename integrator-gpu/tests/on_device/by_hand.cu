// What somebody writes for a device who wants pendulums by Yoshida's method of fourth order and nothing else: CUDA's own sine,
// the last drift of a step merged with the first one of the next, everything in registers.
extern "C" __global__ void pendulums(long long members, long long steps, double h, const double* velocity, const double* pull,
                                     double* q, double* p) {
    const long long member = blockIdx.x * (long long)blockDim.x + threadIdx.x;
    if (member >= members) return;
    const double outer = 1.3512071919596578, inner = -1.7024143839193153;
    const double drift = h * velocity[member], kick = h * pull[member];
    const double end = 0.5 * outer * drift, between = 0.5 * (outer + inner) * drift;
    double x = q[member], y = p[member];
    x += end * y;
    for (long long step = 0; step < steps; ++step) {
        y -= outer * kick * sin(x);
        x += between * y;
        y -= inner * kick * sin(x);
        x += between * y;
        y -= outer * kick * sin(x);
        x += 2.0 * end * y;
    }
    q[member] = x - end * y;
    p[member] = y;
}
