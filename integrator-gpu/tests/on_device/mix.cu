// What a device can do at most in a mix of operations in double precision: FUSED multiply-adds (sums and products take as long),
// QUOTIENTS and ROOTS in each round, none of which waits for another of its kind in the same round.
extern "C" __global__ void mix(long long rounds, double factor, double* to) {
    const long long thread = blockIdx.x * (long long)blockDim.x + threadIdx.x;
    double sums[8], quotients[2] = {factor, factor + 1.0}, roots[2] = {factor, factor + 2.0};
    for (int i = 0; i < 8; ++i) sums[i] = double(thread + i);
    for (long long round = 0; round < rounds; ++round) {
#pragma unroll
        for (int i = 0; i < FUSED; ++i) sums[i % 8] = __fma_rn(sums[i % 8], factor, factor);
#pragma unroll
        for (int i = 0; i < QUOTIENTS; ++i) quotients[i % 2] = __ddiv_rn(1.0, quotients[i % 2]);
#pragma unroll
        for (int i = 0; i < ROOTS; ++i) roots[i % 2] = __dsqrt_rn(roots[i % 2]);
    }
    double sum = quotients[0] + quotients[1] + roots[0] + roots[1];
    for (int i = 0; i < 8; ++i) sum += sums[i];
    to[thread] = sum;
}
