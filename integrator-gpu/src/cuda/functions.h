// Elementary functions with the bits of the Rust kernels in integrator-core/src/scalar/functions on a machine with fused
// multiply-add: the same operations in the same order, with the same constants. What the kernels leave to the maths
// library, arguments that hardly occur, is left to that of CUDA here, which may round otherwise.
//
// Compiled without contraction (-fmad=false, -ffp-contract=off): every fused multiply-add is written.

#define DEVICE __device__ __forceinline__

namespace integrator {

DEVICE double fma(double a, double b, double c) { return __fma_rn(a, b, c); }
DEVICE float fma(float a, float b, float c) { return __fmaf_rn(a, b, c); }
DEVICE double sqrt(double x) { return __dsqrt_rn(x); }
DEVICE float sqrt(float x) { return __fsqrt_rn(x); }

// The patterns of numbers.
template <class R> struct Pattern;
template <> struct Pattern<double> {
    typedef unsigned long long Word;
    DEVICE static Word of(double x) { return (Word)__double_as_longlong(x); }
    DEVICE static double number(Word word) { return __longlong_as_double((long long)word); }
};
template <> struct Pattern<float> {
    typedef unsigned int Word;
    DEVICE static Word of(float x) { return __float_as_uint(x); }
    DEVICE static float number(Word word) { return __uint_as_float(word); }
};

template <class R> DEVICE typename Pattern<R>::Word bits(R x) { return Pattern<R>::of(x); }
template <class R> DEVICE R pattern(unsigned long long word) {
    return Pattern<R>::number((typename Pattern<R>::Word)word);
}
template <class R> DEVICE R bits_and(R a, R b) { return pattern<R>(bits(a) & bits(b)); }
template <class R> DEVICE R bits_xor(R a, R b) { return pattern<R>(bits(a) ^ bits(b)); }
template <class R> DEVICE R bits_add(R a, R b) { return pattern<R>((unsigned long long)bits(a) + bits(b)); }
template <class R> DEVICE R bits_left(R a, int by) { return pattern<R>((unsigned long long)bits(a) << by); }
template <class R> DEVICE R bits_right(R a, int by) { return pattern<R>(bits(a) >> by); }
template <class R> DEVICE bool is_odd(R a) { return bits(a) & 1; }
template <class R> DEVICE R sign(R x) { return bits_and(x, R(-0.0)); }
template <class R> DEVICE R pattern_less(unsigned long long word, R x) {
    return bits_add(bits_xor(x, pattern<R>(~0ull)), pattern<R>(word + 1));
}
template <class R> DEVICE R abs(R x) { return bits_xor(x, sign(x)); }
template <class R> DEVICE R not_a_number() { return R(0.0) / R(0.0); }
template <class R> DEVICE R infinity() { return R(1.0) / R(0.0); }

// Error-free transformations, and the beginnings of polynomials.
template <class R> DEVICE R two_sum(R a, R b, R& lost) {
    const R sum = a + b, of_b = sum - a;
    lost = (a - (sum - of_b)) + (b - of_b);
    return sum;
}
template <class R> DEVICE R fast_two_sum(R large, R small, R& lost) {
    const R sum = large + small;
    lost = small - (sum - large);
    return sum;
}
template <class R> DEVICE R two_product(R a, R b, R& lost) {
    const R product = a * b;
    lost = fma(a, b, -product);
    return product;
}
template <class R> DEVICE R less_product(R c, R a, R b) { return fma(-a, b, c); }
template <class R> DEVICE R linear(R x, double a, double b) { return fma(x, R(b), R(a)); }
template <class R> DEVICE R cubic(R x, R square, double a, double b, double c, double d) {
    return fma(square, linear(x, c, d), linear(x, a, b));
}
template <class R> DEVICE R quotient(R a, R error_of_a, R b, R error_of_b) {
    const R quotient = a / b;
    R left = error_of_a - quotient * error_of_b;
    left = left + fma(-quotient, b, a);
    return quotient + left / b;
}

// The constants of one format.
template <class R> struct Format;
template <> struct Format<double> {
    static constexpr double MAGIC = 6755399441055744.0;
    static constexpr double QUARTER = 1.5707963267948966, SECOND_QUARTER = 6.123233995384610e-17;
    static constexpr double THIRD_QUARTER = 3.5215598651832e-27;
    static constexpr double FARTHEST_ANGLE = 1647099.0;
    static constexpr int SIGN = 63, EXPONENT = 52, UNUSED = 32;
    static constexpr double LEADING_SINE = 0.1666666666666663, LEADING_COSINE = -0.5;
    static constexpr double LN_2 = 0.6931471805598903, SECOND_LN_2 = 5.497923018708371e-14;
    static constexpr double FARTHEST_POWER = 708.0, LOWEST_POWER = -746.0, HIGHEST_POWER = 710.0, SATURATED = 20.0;
    static constexpr unsigned long long ROOT = 0x3fe6a09e667f3bcd, ONE = 0x3ff0000000000000;
    static constexpr unsigned long long INTEGER = 0x4330000000000000;
    static constexpr double LEAST = 2.2250738585072014e-308, GREATEST = 1.7976931348623157e308;
    static constexpr double QUARTER_ERROR = 6.123233995736766e-17, NEAR = 1e-140, FAR = 1e140;
    static constexpr unsigned long long RECIPROCAL = 0x7fde624dd2f1a9fb, HALF_RECIPROCAL_ROOT = 0x5fd6eb851eb851eb;
    static constexpr double ESTIMATE = 6004800933347021.0;
    static constexpr unsigned long long HALF_ROUNDED = 1ull << 35, ROUNDED = ~0ull << 36;
    static constexpr double LEAST_ROOT = 0x1p-511, HUGE_ONE = 0x1p+896;
    static constexpr double TWO_THIRDS = 2.0 / 3.0, SECOND_TWO_THIRDS = 3.700743415417188e-17;
};
template <> struct Format<float> {
    static constexpr double MAGIC = 12582912.0;
    static constexpr double QUARTER = 1.570796251296997, SECOND_QUARTER = 7.549533620476723e-8;
    static constexpr double THIRD_QUARTER = 2.5633440682570896e-12;
    static constexpr double FARTHEST_ANGLE = 3216.0;
    static constexpr int SIGN = 31, EXPONENT = 23, UNUSED = 9;
    static constexpr double LEADING_SINE = 0.16666653752326965, LEADING_COSINE = -0.5;
    static constexpr double LN_2 = 0.693145751953125, SECOND_LN_2 = 1.428606765330187e-6;
    static constexpr double FARTHEST_POWER = 87.0, LOWEST_POWER = -104.0, HIGHEST_POWER = 89.0, SATURATED = 10.0;
    static constexpr unsigned long long ROOT = 0x3f3504f3, ONE = 0x3f800000, INTEGER = 0x4b000000;
    static constexpr double LEAST = 1.17549435082228750797e-38, GREATEST = 3.4028234663852886e38;
    static constexpr double QUARTER_ERROR = -4.371138828673793e-8, NEAR = 1e-13, FAR = 1e13;
    static constexpr unsigned long long RECIPROCAL = 0x7ef3126e, HALF_RECIPROCAL_ROOT = 0x5eb75c28;
    static constexpr double ESTIMATE = 13958053.0;
    static constexpr unsigned long long HALF_ROUNDED = 1ull << 15, ROUNDED = ~0ull << 16;
    static constexpr double LEAST_ROOT = 0x1p-63, HUGE_ONE = 0x1p+112;
    static constexpr double TWO_THIRDS = 0.6666666865348816, SECOND_TWO_THIRDS = -1.9868215517249155e-8;
};

template <class R> DEVICE R least() { return R(Format<R>::LEAST_ROOT); }
template <class R> DEVICE R huge() { return R(Format<R>::HUGE_ONE); }

constexpr double PI_HALF = 1.5707963267948966, TWO_OVER_PI = 0.6366197723675814, ONE_OVER_PI = 0.3183098861837907;
constexpr double LOG2_E = 1.4426950408889634;

// The maths library, for what the kernels leave to it, and for texts that ask for the functions of the device.
#define INTEGRATOR_LIBRARY(name, of_double, of_single)                        \
    DEVICE double library_##name(double x) { return ::of_double(x); }         \
    DEVICE float library_##name(float x) { return ::of_single(x); }
INTEGRATOR_LIBRARY(sin, sin, sinf)
INTEGRATOR_LIBRARY(cos, cos, cosf)
INTEGRATOR_LIBRARY(tan, tan, tanf)
INTEGRATOR_LIBRARY(ln, log, logf)
INTEGRATOR_LIBRARY(cbrt, cbrt, cbrtf)
INTEGRATOR_LIBRARY(floor, floor, floorf)
INTEGRATOR_LIBRARY(ceil, ceil, ceilf)
INTEGRATOR_LIBRARY(trunc, trunc, truncf)
INTEGRATOR_LIBRARY(round, round, roundf)
INTEGRATOR_LIBRARY(round_ties_even, rint, rintf)
INTEGRATOR_LIBRARY(acos, acos, acosf)
INTEGRATOR_LIBRARY(acosh, acosh, acoshf)
INTEGRATOR_LIBRARY(asin, asin, asinf)
INTEGRATOR_LIBRARY(asinh, asinh, asinhf)
INTEGRATOR_LIBRARY(atan, atan, atanf)
INTEGRATOR_LIBRARY(atanh, atanh, atanhf)
INTEGRATOR_LIBRARY(cosh, cosh, coshf)
INTEGRATOR_LIBRARY(exp, exp, expf)
INTEGRATOR_LIBRARY(exp2, exp2, exp2f)
INTEGRATOR_LIBRARY(exp_m1, expm1, expm1f)
INTEGRATOR_LIBRARY(ln_1p, log1p, log1pf)
INTEGRATOR_LIBRARY(log10, log10, log10f)
INTEGRATOR_LIBRARY(log2, log2, log2f)
INTEGRATOR_LIBRARY(sinh, sinh, sinhf)
INTEGRATOR_LIBRARY(tanh, tanh, tanhf)
#define INTEGRATOR_LIBRARY_OF_TWO(name, of_double, of_single)                           \
    DEVICE double library_##name(double x, double y) { return ::of_double(x, y); }      \
    DEVICE float library_##name(float x, float y) { return ::of_single(x, y); }
INTEGRATOR_LIBRARY_OF_TWO(powf, pow, powf)
INTEGRATOR_LIBRARY_OF_TWO(atan2, atan2, atan2f)
INTEGRATOR_LIBRARY_OF_TWO(hypot, hypot, hypotf)
template <class R> DEVICE void library_sin_cos(R x, R& sine, R& cosine) {
    sine = library_sin(x);
    cosine = library_cos(x);
}

// Functions that are exact.
template <class R> DEVICE R floor(R x) { return library_floor(x); }
template <class R> DEVICE R ceil(R x) { return library_ceil(x); }
template <class R> DEVICE R trunc(R x) { return library_trunc(x); }
template <class R> DEVICE R round(R x) { return library_round(x); }
template <class R> DEVICE R round_ties_even(R x) { return library_round_ties_even(x); }
template <class R> DEVICE R signum(R x) { return x != x ? x : bits_xor(R(1.0), sign(x)); }
template <class R> DEVICE R max(R a, R b) { return a != a ? b : (b > a ? b : a); }
template <class R> DEVICE R min(R a, R b) { return a != a ? b : (b < a ? b : a); }
DEVICE double remainder(double a, double b) { return ::fmod(a, b); }
DEVICE float remainder(float a, float b) { return ::fmodf(a, b); }
template <class R> DEVICE R div_pow_3_2(R n, R x) { return n / (x * sqrt(x)); }

// Sine and cosine.
template <class R> struct Reduced {
    R quarters, r, excess;
};
template <class R> DEVICE Reduced<R> reduce(R x) {
    typedef Format<R> F;
    const R quarters = fma(x, R(TWO_OVER_PI), R(F::MAGIC));
    const R n = quarters - R(F::MAGIC);
    const R close = fma(n, R(-F::QUARTER), x);
    const R second = n * R(F::SECOND_QUARTER);
    const R r = close - second;
    const Reduced<R> reduced = {quarters, r, fma(n, R(F::THIRD_QUARTER), (r - close) + second)};
    return reduced;
}
template <class R> DEVICE R coefficient(bool odd, double sine, double cosine) { return odd ? R(cosine) : R(sine); }
// The rows of sine and cosine. A device loads a row in fewer instructions than it chooses between pairs of constants.
alignas(16) __device__ const double TAILS[2][6] = {
    {-8.33333333332184e-3, 1.9841269829358506e-4, -2.755731353850646e-6, 2.5050734389334848e-8, -1.5895433419339094e-10,
     0.0},
    {4.1666666666666595e-2, -1.3888888888873342e-3, 2.480158728900208e-5, -2.755731421703767e-7, 2.087570539550263e-9,
     -1.1358749186300807e-11}};
DEVICE double tail(bool odd, double z, double inner, double excess) {
    const double* row = TAILS[odd];
    const double first = fma(z, row[1], row[0]), second = fma(z, row[3], row[2]), third = fma(z, row[5], row[4]);
    const double zz = z * z;
    return fma(inner * zz, fma(zz, third, second), fma(inner, first, excess));
}
DEVICE float tail(bool odd, float z, float inner, float excess) {
    typedef float R;
    const R first = fma(z, coefficient<R>(odd, 1.9507890101522207e-4, -1.3887305976822972e-3),
                        coefficient<R>(odd, -8.332106284797192e-3, 4.166664555668831e-2));
    const R third = coefficient<R>(odd, 0.0, 2.4431650672367074e-5);
    return fma(inner * (z * z), third, fma(inner, first, excess));
}
template <class R> DEVICE R sin_or_cos(bool odd, const Reduced<R>& reduced, R& error) {
    const R r = reduced.r, z = r * r;
    const R inner = odd ? r : r * z, outer = odd ? r : R(-1.0);
    const R rest = tail(odd, z, inner * z, reduced.excess);
    const R sum = fma(inner, coefficient<R>(odd, Format<R>::LEADING_SINE, Format<R>::LEADING_COSINE), rest);
    const R base = odd ? R(1.0) : r;
    const R value = fma(outer, sum, base);
    error = fma(outer, sum, base - value);
    return value;
}
template <class R> DEVICE R rounded_sin_or_cos(bool odd, const Reduced<R>& reduced) {
    R error;
    return sin_or_cos(odd, reduced, error);
}
template <class R> DEVICE R with_sign_of(R value, R quarters) {
    return bits_xor(value, sign(bits_left(quarters, Format<R>::SIGN - 1)));
}
template <class R> DEVICE bool is_near(R x) { return abs(x) <= R(Format<R>::FARTHEST_ANGLE); }
template <class R> DEVICE R sin(R x) {
    const Reduced<R> reduced = reduce(x);
    const R value = rounded_sin_or_cos(is_odd(reduced.quarters), reduced);
    return is_near(x) ? with_sign_of(value, reduced.quarters) : library_sin(x);
}
template <class R> DEVICE R cos(R x) {
    const Reduced<R> reduced = reduce(x);
    const R ahead = reduced.quarters + R(1.0);
    const R value = rounded_sin_or_cos(is_odd(ahead), reduced);
    return is_near(x) ? with_sign_of(value, ahead) : library_cos(x);
}
template <class R> DEVICE void sin_cos(R x, R& sine, R& cosine) {
    const Reduced<R> reduced = reduce(x);
    const R of_rest = rounded_sin_or_cos(false, reduced), other = rounded_sin_or_cos(true, reduced);
    const bool odd = is_odd(reduced.quarters);
    const R ahead = reduced.quarters + R(1.0);
    sine = is_near(x) ? with_sign_of(odd ? other : of_rest, reduced.quarters) : library_sin(x);
    cosine = is_near(x) ? with_sign_of(odd ? of_rest : other, ahead) : library_cos(x);
}
template <class R> DEVICE R tan(R x) {
    const Reduced<R> reduced = reduce(x);
    R error_of_sine, error_of_cosine;
    const R sine = sin_or_cos(false, reduced, error_of_sine), cosine = sin_or_cos(true, reduced, error_of_cosine);
    const bool odd = is_odd(reduced.quarters);
    R value = odd ? quotient(cosine, error_of_cosine, -sine, -error_of_sine)
                  : quotient(sine, error_of_sine, cosine, error_of_cosine);
    value = x == R(0.0) ? x : value;
    return is_near(x) ? value : library_tan(x);
}

// The exponential function and what is made of it.
DEVICE double exp_series(double r) {
    const double first = fma(r, 1.6666666666666682e-1, 0.5);
    const double second = fma(r, 8.333333333317048e-3, 4.1666666666666095e-2);
    const double third = fma(r, 1.9841269896355147e-4, 1.388888888911545e-3);
    const double fourth = fma(r, 2.7557234895094167e-6, 2.4801586926862226e-5);
    const double fifth = fma(r, 2.511202508659449e-8, 2.7557581733498507e-7);
    const double square = r * r, fourth_power = square * square;
    const double low = fma(square, second, first), middle = fma(square, fourth, third);
    const double high = fma(square, 2.0826641405953808e-9, fifth);
    return fma(fourth_power, fma(fourth_power, high, middle), low);
}
DEVICE float exp_series(float r) {
    const float first = fma(r, float(1.66665181517601e-1), float(4.999999403953552e-1));
    const float second = fma(r, float(8.36899969726801e-3), float(4.166842997074127e-2));
    const float square = r * r;
    return fma(square, fma(square, float(1.3812925899401307e-3), second), first);
}
DEVICE double short_exp_series(double r) {
    const double square = r * r;
    const double low = cubic(r, square, 0.49999999999998324, 0.1666666666661156, 0.04166666666813599, 0.008333333370868718);
    const double high =
        cubic(r, square, 0.0013888888516320624, 0.000198411852379135, 2.4801931654192963e-5, 2.76349901138659e-6);
    const double fourth = square * square;
    return fma(fourth, fma(fourth, 2.747681050877795e-7, high), low);
}
DEVICE float short_exp_series(float r) {
    return cubic(r, r * r, 0.499992311000824, 0.16667114198207855, 0.041890114545822144, 0.00831256341189146);
}
template <class R> DEVICE R exp_parts(R x, R small, R& less_one, R& error) {
    typedef Format<R> F;
    const R magic = R(F::MAGIC), pattern = fma(x, R(LOG2_E), magic), n = pattern - magic;
    const R close = fma(n, R(-F::LN_2), x);
    const R second = n * R(F::SECOND_LN_2) - small;
    const R r = close - second, excess = (r - close) + second;
    less_one = fast_two_sum(r, fma(r * r, exp_series(r), -excess), error);
    return pattern;
}
template <class R> DEVICE R short_exp_parts(R x, R& r) {
    typedef Format<R> F;
    const R magic = R(F::MAGIC), pattern = fma(x, R(LOG2_E), magic), n = pattern - magic;
    r = fma(n, R(-F::SECOND_LN_2), fma(n, R(-F::LN_2), x));
    return pattern;
}
template <class R> DEVICE R raised(R n, R less_one) { return bits_add(R(1.0) + less_one, bits_left(n, Format<R>::EXPONENT)); }
template <class R> DEVICE R far_exp(R x) {
    typedef Format<R> F;
    x = x < R(F::LOWEST_POWER) ? R(F::LOWEST_POWER) : x;
    x = R(F::HIGHEST_POWER) < x ? R(F::HIGHEST_POWER) : x;
    R less_one, error;
    const R n = exp_parts(x, R(0.0), less_one, error), one = R(1.0);
    const R first = bits_add(one, bits_left(bits_right(n, 1), F::EXPONENT));
    const R second = bits_add(one, bits_left(bits_right(n + one, 1), F::EXPONENT));
    return fma(first, less_one, first) * second;
}
template <class R> DEVICE R exp(R x) {
    if (!(abs(x) <= R(Format<R>::FARTHEST_POWER))) return far_exp(x);
    R less_one, error;
    const R n = exp_parts(x, R(0.0), less_one, error);
    return raised(n, less_one);
}
template <class R> DEVICE R fast_exp(R x) {
    if (!(abs(x) <= R(Format<R>::FARTHEST_POWER))) return far_exp(x);
    R r;
    const R n = short_exp_parts(x, r);
    return raised(n, fma(r * r, short_exp_series(r), r));
}
template <class R> DEVICE R saturated(R size) { return R(Format<R>::SATURATED) < size ? R(Format<R>::SATURATED) : size; }
template <class R> DEVICE R fast_tanh(R x) {
    const R size = saturated(abs(x));
    R r;
    const R n = short_exp_parts(size + size, r);
    const R less_one = fma(r * r, exp_series(r), r);
    const R power = bits_add(R(1.0), bits_left(n, Format<R>::EXPONENT));
    const R risen = fma(power, less_one, power - R(1.0));
    return bits_xor(risen / (risen + R(2.0)), sign(x));
}
template <class R> DEVICE R tanh(R x) {
    const R size = saturated(abs(x));
    R less_one, error, lost;
    const R n = exp_parts(size + size, R(0.0), less_one, error);
    const R power = bits_add(R(1.0), bits_left(n, Format<R>::EXPONENT));
    const R whole = power - R(1.0), risen = fma(power, less_one, whole);
    error = fma(power, error, fma(power, less_one, whole - risen));
    const R divisor = fast_two_sum(R(2.0), risen, lost);
    return bits_xor(quotient(risen, error, divisor, lost + error), sign(x));
}

// The natural logarithm.
DEVICE double ln_series(double z) {
    const double first = fma(z, 3.999999999941706e-1, 6.666666666666734e-1);
    const double second = fma(z, 2.2222198621895553e-1, 2.8571428741889754e-1);
    const double third = fma(z, 1.531411057196961e-1, 1.818356189470896e-1);
    const double square = z * z;
    return fma(square, fma(square, fma(square, 1.479536844409115e-1, third), second), first);
}
DEVICE float ln_series(float z) {
    return fma(z, fma(z, float(2.987070083618164e-1), float(3.997758626937866e-1)), float(6.666677594184875e-1));
}
DEVICE double short_ln_series(double z) {
    const double square = z * z;
    const double low = cubic(z, square, 0.666666666665875, 0.4000000005213253, 0.28571417151786177, 0.2222337018720763);
    return fma(square * square, linear(z, 0.18123688771644667, 0.16819290921493804), low);
}
DEVICE float short_ln_series(float z) { return ln_series(z); }
template <class R> DEVICE R split(R x, R& f) {
    typedef Format<R> F;
    const R moved = bits_add(x, pattern<R>(F::ONE - F::ROOT));
    const R exponent = bits_add(bits_right(moved, F::EXPONENT), pattern<R>(F::INTEGER));
    const double bias = double(F::ONE >> F::EXPONENT);
    f = bits_add(bits_and(moved, pattern<R>((1ull << F::EXPONENT) - 1)), pattern<R>(F::ROOT)) - R(1.0);
    return exponent - R(double(1ull << F::EXPONENT) + bias);
}
template <class R> DEVICE bool is_normal(R x) { return R(Format<R>::LEAST) <= x && x <= R(Format<R>::GREATEST); }
template <class R> DEVICE R ln_joined(R k, R f, R lost) {
    typedef Format<R> F;
    const R s = f / (f + R(2.0)), z = s * s, half_square = R(0.5) * f * f;
    const R small = fma(s, fma(z, ln_series(z), half_square), fma(k, R(F::SECOND_LN_2), lost));
    return fma(k, R(F::LN_2), f - (half_square - small));
}
template <class R> DEVICE R fast_ln_joined(R k, R f, R lost) {
    typedef Format<R> F;
    const R s = f / (f + R(2.0)), z = s * s;
    const R slope = fma(z, short_ln_series(z), R(2.0));
    return fma(k, R(F::LN_2), fma(s, slope, fma(k, R(F::SECOND_LN_2), lost)));
}
template <class R> DEVICE R ln(R x) {
    if (!is_normal(x)) return library_ln(x);
    R f;
    const R k = split(x, f);
    return ln_joined(k, f, R(0.0));
}
template <class R> DEVICE R fast_ln(R x) {
    if (!is_normal(x)) return library_ln(x);
    R f;
    const R k = split(x, f);
    return fast_ln_joined(k, f, R(0.0));
}
template <class R> DEVICE R split_1p(R x, R& f, R& lost) {
    typedef Format<R> F;
    R rest, large;
    const R sum = two_sum(R(1.0), x, rest), k = split(sum, large);
    f = fast_two_sum(large, rest * bits_add(R(1.0), bits_left(R(F::MAGIC) - k, F::EXPONENT)), lost);
    return k;
}
template <class R> DEVICE bool is_fast_1p(R x) {
    typedef Format<R> F;
    return R(-1.0) < x && x <= R(0.25 * double(F::GREATEST)) && !(x == R(0.0));
}
template <class R> DEVICE R ln_1p(R x) {
    if (!is_fast_1p(x)) return x == R(0.0) ? x : library_ln_1p(x);
    R f, lost;
    const R k = split_1p(x, f, lost);
    return ln_joined(k, f, lost);
}
template <class R> DEVICE R fast_ln_1p(R x) {
    if (!is_fast_1p(x)) return x == R(0.0) ? x : library_ln_1p(x);
    R f, lost;
    const R k = split_1p(x, f, lost);
    return fast_ln_joined(k, f, lost);
}

// Powers.
DEVICE double power_series(double z) {
    const double square = z * z;
    const double low = cubic(z, square, 0.4000000000000225, 0.2857142857010215, 0.22222222519481782, 0.18181784404242035);
    const double high = fma(square, 0.1319599914961811, linear(z, 0.15386755685975956, 0.13256854622784087));
    return fma(square * square, high, low);
}
DEVICE float power_series(float z) {
    return fma(z * z, float(0.23419889748397827), linear(z, 0.400001525878906250, 0.2854708433151245));
}
template <class R> DEVICE R long_ln(R x, R& error) {
    typedef Format<R> F;
    R f, lost;
    const R k = split(x, f), divisor = fast_two_sum(R(2.0), f, lost), reciprocal = R(1.0) / divisor, s = f * reciprocal;
    const R small_s = (less_product(f, s, divisor) - s * lost) * reciprocal;
    const R z = two_product(s, s, lost), small_z = fma(s + s, small_s, lost);
    const R two_thirds = R(F::TWO_THIRDS), slope = two_product(two_thirds, z, lost);
    const R series = fma(z * z, power_series(z), lost);
    const R small_slope = fma(z, R(F::SECOND_TWO_THIRDS), fma(two_thirds, small_z, series));
    const R term = two_product(s, slope, lost), small_term = fma(s, small_slope, fma(small_s, slope, lost));
    const R mantissa = fast_two_sum(s + s, term, lost), small_mantissa = lost + (small_s + small_s + small_term);
    const R value = fast_two_sum(k * R(F::LN_2), mantissa, lost);
    return fast_two_sum(value, lost + fma(k, R(F::SECOND_LN_2), small_mantissa), error);
}
template <class R> DEVICE R powf(R x, R y) {
    R small, lost, less_one, error;
    const R logarithm = long_ln(x, small), exponent = two_product(y, logarithm, lost);
    const R n = exp_parts(exponent, fma(y, small, lost), less_one, error);
    return is_normal(x) && abs(exponent) <= R(Format<R>::FARTHEST_POWER) ? raised(n, less_one) : library_powf(x, y);
}

// The cube root.
template <class R> DEVICE R reciprocal_cube_root(R size) {
    typedef Format<R> F;
    const R number = bits_add(bits_right(size, F::UNUSED), pattern<R>(F::INTEGER));
    const R p = bits_left(fma(number, R(-1.0 / 3.0), R(F::ESTIMATE)), F::UNUSED);
    const R e = fma(-(size * p * p), p, R(1.0));
    return p * cubic(e, e * e, 0.9999980149511796, 0.3333284057472376, 0.22373825326181598, 0.17456240108790902);
}
template <class R> DEVICE R cbrt(R x) {
    const R size = abs(x);
    if (!is_normal(size)) return library_cbrt(x);
    const R p = reciprocal_cube_root(size), root = size * p * p;
    const R y = bits_and(bits_add(root, pattern<R>(Format<R>::HALF_ROUNDED)), pattern<R>(Format<R>::ROUNDED));
    const R e = fma(-root, p, R(1.0));
    const R delta = (size - y * y * y) * (p * p * p) * (R(1.0) + fma(e, e, e));
    const R terms = fma(delta, linear(delta, 2.0 / 9.0, 14.0 / 81.0), R(1.0 / 3.0));
    return bits_xor(fma(y * delta, terms, y), sign(x));
}
template <class R> DEVICE R fast_cbrt(R x) {
    const R size = abs(x);
    if (!is_normal(size)) return library_cbrt(x);
    const R p = reciprocal_cube_root(size), root = size * p * p, e = fma(-root, p, R(1.0));
    return bits_xor(fma(root * e, linear(e, 2.0 / 3.0, 5.0 / 9.0), root), sign(x));
}

// The arc tangent.
DEVICE double atan_series(double z) {
    const double square = z * z, fourth = square * square;
    const double low = cubic(z, square, -0.0833333333333307, 0.1999999999995175, -0.14285714282588172, 0.1111111100734411);
    const double second = cubic(z, square, -0.09090907007825227, 0.07692279889087363, -0.06666404423703398, 0.05880529804937575);
    const double third = cubic(z, square, -0.052535267489496086, 0.04722348209426935, -0.042192431066084404, 0.03664314959777206);
    const double fifth = cubic(z, square, -0.029905730336280873, 0.021987056150293827, -0.013902555924551727, 0.007197867569850056);
    const double high = cubic(z, square, -0.0028855987374620798, 0.0008315551904459261, -0.00015221007352423667, 1.3229883507193876e-5);
    const double upper = fma(fourth, fma(fourth, high, fifth), third);
    return fma(fourth, fma(fourth, upper, second), low);
}
DEVICE float atan_series(float z) {
    const float first = linear(z, -0.08333328366279602, 0.1999971568584442);
    const float second = linear(z, -0.14280343055725098, 0.11061233282089233);
    const float third = linear(z, -0.08821462094783783, 0.06763648986816406);
    const float fourth = linear(z, -0.04498325660824776, 0.02277761697769165);
    const float fifth = linear(z, -0.007425365969538689, 0.0011345258681103587);
    const float square = z * z, high = fma(square, fma(square, fifth, fourth), third);
    return fma(square, fma(square, high, second), first);
}
DEVICE double short_atan_series(double z) {
    const double square = z * z, fourth = square * square;
    const double low = cubic(z, square, -0.3333333333332516, 0.1999999999877289, -0.1428571422066166, 0.11111109346238335);
    const double second = cubic(z, square, -0.09090880199591539, 0.07691994260955516, -0.0666427376893585, 0.05868954889971198);
    const double third = cubic(z, square, -0.05206476367754889, 0.045765907881848714, -0.038710594025388304, 0.03019050050491337);
    const double fifth = cubic(z, square, -0.02062120219711368, 0.011664659907040275, -0.00513664187585291, 0.0016277040785878953);
    const double high = linear(z, -0.00032709142256297024, 3.1114489287646776e-5);
    const double upper = fma(fourth, fma(fourth, high, fifth), third);
    return fma(fourth, fma(fourth, upper, second), low);
}
DEVICE float short_atan_series(float z) {
    const float square = z * z;
    const float low = cubic(z, square, -0.33333152532577515, 0.19993767142295837, -0.14211003482341766, 0.10665781795978546);
    const float high = cubic(z, square, -0.07551701366901398, 0.043205369263887405, -0.01636366732418537, 0.002919561229646206);
    return fma(square * square, high, low);
}
template <class R> DEVICE R octant(R small, R big, R& rest) {
    const R t = small / big, z = t * t, slope = fma(z, R(-0.5), R(1.0)), cube = t * z;
    R lost;
    const R angle = fast_two_sum(t, cube * R(-0.25), lost);
    const R lost_by_quotient = less_product(small, t, big) * pattern_less(Format<R>::RECIPROCAL, big);
    rest = fma(cube, atan_series(z), fma(lost_by_quotient, slope, lost));
    return angle;
}
template <class R> DEVICE R short_octant(R small, R big) {
    const R t = small / big, z = t * t;
    return fma(t * z, short_atan_series(z), t);
}
template <class R> DEVICE R add_quarters(R quarters, R angle, R rest) {
    R lost;
    const R sum = fast_two_sum(quarters * R(PI_HALF), angle, lost);
    return sum + (lost + fma(quarters, R(Format<R>::QUARTER_ERROR), rest));
}
template <class R> DEVICE R quarters_of(R x, bool steep, R& flip) {
    flip = bits_xor(sign(x), steep ? R(-0.0) : R(0.0));
    return steep ? R(1.0) : (x < R(0.0) ? R(2.0) : R(0.0));
}
template <class R> DEVICE R atan(R x) {
    const R farthest = R(Format<R>::FAR), height = farthest < abs(x) ? farthest : abs(x), one = R(1.0);
    const bool steep = one < height;
    R rest, flip;
    const R angle = octant(steep ? one : height, steep ? height : one, rest), quarters = quarters_of(one, steep, flip);
    return bits_xor(add_quarters(quarters, bits_xor(angle, flip), bits_xor(rest, flip)), sign(x));
}
template <class R> DEVICE R fast_atan(R x) {
    const R height = abs(x), one = R(1.0);
    const bool steep = one < height;
    R flip;
    const R quarters = quarters_of(one, steep, flip);
    const R angle = bits_xor(short_octant(steep ? one : height, steep ? height : one), flip);
    return bits_xor(fma(quarters, R(PI_HALF), angle), sign(x));
}
template <class R> DEVICE bool is_moderate(R small, R big) {
    const R least = R(Format<R>::NEAR), greatest = R(Format<R>::FAR);
    return least < big && big < greatest && (least < small || small == R(0.0));
}
template <class R> DEVICE R atan2(R y, R x) {
    const bool steep = abs(x) < abs(y);
    const R small = steep ? abs(x) : abs(y), big = steep ? abs(y) : abs(x);
    R rest, flip;
    const R angle = octant(small, big, rest), quarters = quarters_of(x, steep, flip);
    const R value = bits_xor(add_quarters(quarters, bits_xor(angle, flip), bits_xor(rest, flip)), sign(y));
    return is_moderate(small, big) ? value : library_atan2(y, x);
}
template <class R> DEVICE R fast_atan2(R y, R x) {
    const bool steep = abs(x) < abs(y);
    const R small = steep ? abs(x) : abs(y), big = steep ? abs(y) : abs(x);
    R flip;
    const R quarters = quarters_of(x, steep, flip), angle = bits_xor(short_octant(small, big), flip);
    const R value = bits_xor(fma(quarters, R(PI_HALF), angle), sign(y));
    return is_moderate(small, big) ? value : library_atan2(y, x);
}

// Arc sine and arc cosine.
DEVICE double asin_series(double z) {
    const double square = z * z, fourth = square * square;
    const double low = cubic(z, square, 0.16666666666665408, 0.07500000000337151, 0.04464285682820696, 0.03038195914223581);
    const double middle = cubic(z, square, 0.022371757919274385, 0.01735970679828208, 0.013885214910178937, 0.012169349145107615);
    const double high = cubic(z, square, 0.006527370699893542, 0.019529945124960466, -0.01622692741293149, 0.03191412890115125);
    return fma(fourth, fma(fourth, high, middle), low);
}
DEVICE float asin_series(float z) {
    const float first = linear(z, 0.16666752099990845, 0.074953094124794);
    const float second = linear(z, 0.04546915367245674, 0.024184737354516983);
    const float square = z * z;
    return fma(square, fma(square, float(0.04215841367840767), second), first);
}
DEVICE double short_asin_series(double z) {
    const double square = z * z, fourth = square * square;
    const double low = cubic(z, square, 0.16666666666683483, 0.074999999961697, 0.044642860171094284, 0.030381825341309097);
    const double middle = cubic(z, square, 0.022374870907222486, 0.01731414771260662, 0.014322158358251687, 0.009381757505445329);
    const double high = fma(square, 0.031519536949629695, linear(z, 0.018251755266547973, -0.011701102053666698));
    return fma(fourth, fma(fourth, high, middle), low);
}
DEVICE float short_asin_series(float z) {
    return cubic(z, z * z, 0.16665580868721008, 0.07540515065193176, 0.0400359183549881, 0.04995141923427582);
}
template <class R> DEVICE bool arc_sine_parts(R size, R& s, R& rest) {
    const R half = R(0.5);
    const bool outer = half < size;
    const R z = outer ? half * (R(1.0) - size) : size * size, root = sqrt(z);
    const R lost = less_product(z, root, root) * pattern_less(Format<R>::HALF_RECIPROCAL_ROOT, bits_right(z, 1));
    s = outer ? root : size;
    rest = fma(s * z, asin_series(z), outer ? lost : R(0.0));
    return outer;
}
template <class R> DEVICE bool short_arc_sine_parts(R size, R& angle) {
    const R half = R(0.5);
    const bool outer = half < size;
    const R z = outer ? fma(-half, size, half) : size * size, s = outer ? sqrt(z) : size;
    angle = fma(s * z, short_asin_series(z), s);
    return outer;
}
template <class R> DEVICE R quarters_of_sine(bool outer, R& factor) {
    factor = outer ? R(-2.0) : R(1.0);
    return outer ? R(1.0) : R(0.0);
}
template <class R> DEVICE R quarters_of_cosine(R x, bool outer, R& factor) {
    factor = bits_xor(outer ? R(2.0) : R(-1.0), sign(x));
    return outer ? (x < R(0.0) ? R(2.0) : R(0.0)) : R(1.0);
}
template <class R> DEVICE R asin(R x) {
    R s, rest, factor;
    const bool outer = arc_sine_parts(abs(x), s, rest);
    const R quarters = quarters_of_sine(outer, factor);
    return bits_xor(add_quarters(quarters, factor * s, factor * rest), sign(x));
}
template <class R> DEVICE R acos(R x) {
    R s, rest, factor;
    const bool outer = arc_sine_parts(abs(x), s, rest);
    const R quarters = quarters_of_cosine(x, outer, factor);
    return add_quarters(quarters, factor * s, factor * rest);
}
template <class R> DEVICE R fast_asin(R x) {
    R angle, factor;
    const bool outer = short_arc_sine_parts(abs(x), angle);
    const R quarters = quarters_of_sine(outer, factor);
    return bits_xor(fma(factor, angle, quarters * R(PI_HALF)), sign(x));
}
template <class R> DEVICE R fast_acos(R x) {
    R angle, factor;
    const bool outer = short_arc_sine_parts(abs(x), angle);
    const R quarters = quarters_of_cosine(x, outer, factor);
    return fma(factor, angle, quarters * R(PI_HALF));
}

// The faster sine, cosine and tangent.
DEVICE double fast_sine_series(double z) {
    const double first = fma(z, 8.333333333285543e-3, -1.6666666666666186e-1);
    const double second = fma(z, 2.7557316600590947e-6, -1.9841269825056611e-4);
    const double third = fma(z, 1.6048095470501906e-10, -2.5051880276083904e-8);
    const double zz = z * z;
    return fma(zz * zz, fma(zz, -7.373345299943309e-13, third), fma(zz, second, first));
}
DEVICE float fast_sine_series(float z) {
    const float first = fma(z, float(8.33306834101677e-3), float(-1.6666659712791443e-1));
    const float second = fma(z, float(2.6057766717713093e-6), float(-1.9809664809145033e-4));
    return fma(z * z, second, first);
}
template <class R> DEVICE R short_rest(R x, R n, double quarters, R& near) {
    typedef Format<R> F;
    near = fma(n, R(-quarters * F::SECOND_QUARTER), fma(n, R(-quarters * F::QUARTER), x));
    return fma(n, R(-quarters * F::THIRD_QUARTER), near);
}
template <class R> DEVICE R sine_of_half_turns(R x, R n) {
    R near;
    const R r = short_rest(x, n, 2.0, near), z = near * near;
    return r * fma(z, fast_sine_series(z), R(1.0));
}
template <class R> DEVICE R fast_sin(R x) {
    const R magic = R(Format<R>::MAGIC), half_turns = fma(x, R(ONE_OVER_PI), magic);
    const R value = bits_xor(sine_of_half_turns(x, half_turns - magic), bits_left(half_turns, Format<R>::SIGN));
    return is_near(x) ? value : library_sin(x);
}
template <class R> DEVICE R fast_cos(R x) {
    const R magic = R(Format<R>::MAGIC), half_turns = fma(x, R(ONE_OVER_PI), R(-0.5)) + magic;
    const R value = -sine_of_half_turns(x, (half_turns - magic) + R(0.5));
    return is_near(x) ? bits_xor(value, bits_left(half_turns, Format<R>::SIGN)) : library_cos(x);
}
DEVICE double above(double z, double square) {
    return cubic(z, square, -0.13725490196078433, 0.00392156862745098, -2.8729440494146376e-5, 2.901963686277412e-8);
}
DEVICE double below(double z, double square) {
    return cubic(z, square, -0.47058823529411764, 0.027450980392156862, -0.00040221216691804925, 1.3058836588248353e-6);
}
DEVICE float above(float z, float) { return linear(z, -1.0 / 9.0, 1.0 / 945.0); }
DEVICE float below(float z, float) { return linear(z, -4.0 / 9.0, 1.0 / 63.0); }
template <class R> DEVICE R fast_tan(R x) {
    const R magic = R(Format<R>::MAGIC), quarters = fma(x, R(TWO_OVER_PI), magic);
    R near;
    const R r = short_rest(x, quarters - magic, 1.0, near), z = r * r;
    const R height = r * fma(z, above(z, z * z), R(1.0)), width = fma(z, below(z, z * z), R(1.0));
    const bool odd = is_odd(quarters);
    const R value = (odd ? -width : height) / (odd ? height : width);
    return is_near(x) ? value : library_tan(x);
}

}  // namespace integrator
