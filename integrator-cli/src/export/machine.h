
@kernels|/* Elementary functions, with the same operations as the Rust kernels. */
@bits|static inline uint64_t NAME_bits(double x) { uint64_t word; memcpy(&word, &x, sizeof word); return word; }
@bits|static inline double NAME_pattern(uint64_t word) { double x; memcpy(&x, &word, sizeof x); return x; }
@reduced|typedef struct { double quarters, r, excess; } NAME_reduced;
@sums|/* A sum over iterations in the order of a vectorised loop: in groups of eight, iteration n adds to partial sum n modulo 16. */
@sums|typedef struct { double partial[16], rest; long long from, grouped; } NAME_partial_sums;
@sums|static inline NAME_partial_sums NAME_partial_sums_of(long long from, long long to) {
@sums|    NAME_partial_sums sums = {{0}, 0.0, from, from < to ? (to - from) / 8 * 8 : 0};
@sums|    return sums;
@sums|}
@sums|static inline double *NAME_partial_sum(NAME_partial_sums *sums, long long i) {
@sums|    return i - sums->from < sums->grouped ? &sums->partial[(i - sums->from) % 16] : &sums->rest;
@sums|}
@sums|static inline double NAME_total_of(NAME_partial_sums *sums) {
@sums|    if (sums->grouped == 0) return sums->rest;
@sums|    for (int half = 8; half > 0; half /= 2) {
@sums|        for (int n = 0; n < half; ++n) sums->partial[n] = sums->partial[n] + sums->partial[n + half];
@sums|    }
@sums|    return sums->partial[0] + sums->rest;
@sums|}
