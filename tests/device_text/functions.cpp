// Every elementary function of a list of numbers, in double and in single precision.

namespace integrator {

#define UNARY(F) F(abs) F(acos) F(asin) F(atan) F(cbrt) F(ceil) F(cos) F(exp) F(floor) F(ln) F(ln_1p) F(round) F(round_ties_even)     \
    F(signum) F(sin) F(sqrt) F(tan) F(tanh) F(trunc) F(fast_acos) F(fast_asin) F(fast_atan) F(fast_cbrt) F(fast_cos)          \
    F(fast_exp) F(fast_ln) F(fast_ln_1p) F(fast_sin) F(fast_tan) F(fast_tanh)
#define BINARY(F) F(atan2) F(fast_atan2) F(max) F(min) F(powf) F(remainder)

template <class R> static void write_values(R x, R y) {
    std::vector<double> values;
#define ONE_ARGUMENT(name) values.push_back(double(name(x)));
#define TWO_ARGUMENTS(name) values.push_back(double(name(x, y)));
    UNARY(ONE_ARGUMENT)
    BINARY(TWO_ARGUMENTS)
    R sine, cosine;
    sin_cos(x, sine, cosine);
    values.push_back(double(sine));
    values.push_back(double(cosine));
    write_numbers(values);
}

static int functions() {
    std::vector<double> numbers(2);
    while (read_numbers(numbers)) {
        write_values<double>(numbers[0], numbers[1]);
        write_values<float>(float(numbers[0]), float(numbers[1]));
    }
    return 0;
}

}  // namespace integrator

