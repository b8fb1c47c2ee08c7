// In the place of the elementary functions of devices those of the maths library, whose bits the interpreter has as well.

#define DEVICE __device__ __forceinline__

namespace integrator {

#define INTEGRATOR_FUNCTION(name, of) DEVICE double name(double x) { return of(x); }
INTEGRATOR_FUNCTION(sqrt, ::sqrt)
INTEGRATOR_FUNCTION(abs, ::fabs)
INTEGRATOR_FUNCTION(acos, ::acos)
INTEGRATOR_FUNCTION(asin, ::asin)
INTEGRATOR_FUNCTION(atan, ::atan)
INTEGRATOR_FUNCTION(cbrt, ::cbrt)
INTEGRATOR_FUNCTION(ceil, ::ceil)
INTEGRATOR_FUNCTION(cos, ::cos)
INTEGRATOR_FUNCTION(exp, ::exp)
INTEGRATOR_FUNCTION(floor, ::floor)
INTEGRATOR_FUNCTION(ln, ::log)
INTEGRATOR_FUNCTION(ln_1p, ::log1p)
INTEGRATOR_FUNCTION(round, ::round)
INTEGRATOR_FUNCTION(round_ties_even, ::rint)
INTEGRATOR_FUNCTION(sin, ::sin)
INTEGRATOR_FUNCTION(tan, ::tan)
INTEGRATOR_FUNCTION(tanh, ::tanh)
INTEGRATOR_FUNCTION(trunc, ::trunc)
DEVICE double fma(double a, double b, double c) { return __fma_rn(a, b, c); }
DEVICE double atan2(double y, double x) { return ::atan2(y, x); }
DEVICE double powf(double x, double y) { return ::pow(x, y); }
DEVICE double remainder(double a, double b) { return ::fmod(a, b); }
DEVICE double signum(double x) { return x != x ? x : ::copysign(1.0, x); }
DEVICE double max(double a, double b) { return a != a ? b : (b > a ? b : a); }
DEVICE double min(double a, double b) { return a != a ? b : (b < a ? b : a); }
DEVICE double div_pow_3_2(double n, double x) { return n / (x * ::sqrt(x)); }
DEVICE void sin_cos(double x, double& sine, double& cosine) {
    sine = ::sin(x);
    cosine = ::cos(x);
}
template <class R> DEVICE R not_a_number() { return R(0.0) / R(0.0); }
template <class R> DEVICE R least() { return R(sizeof(R) == sizeof(double) ? 0x1p-511 : 0x1p-63); }
template <class R> DEVICE R huge() { return R(sizeof(R) == sizeof(double) ? 0x1p+896 : 0x1p+112); }
template <class R> DEVICE R infinity() { return R(1.0) / R(0.0); }
template <class R> DEVICE R fast_two_sum(R large, R small, R& lost) {
    const R sum = large + small;
    lost = small - (sum - large);
    return sum;
}

}  // namespace integrator
