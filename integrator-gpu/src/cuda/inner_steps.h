// Inner steps, as in integrator-core/src/composition/inner_steps.rs: the last part of a system is integrated by a composition of
// its own.

namespace integrator {

// The durations of inner steps, as in integrator-core/src/composition/inner_durations.rs.
struct InnerDurations {
    double each, corrected, count;

    DEVICE InnerDurations(double duration, double steps, bool are_exact)
        : each(duration / steps), corrected(each), count(0.0) {
        const double least_normal = 2.2250738585072014e-308, size = each < 0.0 ? -each : each;
        if (!are_exact || !(least_normal <= size && size - size == 0.0)) return;
        const double product = each * steps, lost = fma(each, steps, -product), rest = (duration - product) - lost;
        const long long bits = __double_as_longlong(each);
        corrected = __longlong_as_double((rest > 0.0) == (each > 0.0) ? bits + 1 : bits - 1);
        count = rest / (corrected - each);
    }
    // In Rust the count is rounded down.
    DEVICE double of_step(long long step) const { return 0 < step && double(step) <= count ? corrected : each; }
};

// Takes the inner steps of a level that integrate its parts for `duration`. The rows of levels are behind each other: one with the
// number of stages in a cycle, whether kicks come first and whether steps are completed one by one; then the stages.
//
// Every flow stands here once: flows of other levels are inlined in these.
template <class Inner, class K, class Motion>
DEVICE void inner_steps(Motion& motion, int level, long long steps, double duration, double time) {
    const Stage* first = motion.parameters.INNER;
    for (; level > 0; --level) first += 3 + int(first->drift);
    const int cycle = int(first->drift);
    const bool leads_with_kick = first->kick != 0.0, is_whole = first->drift_time != 0.0;
    const Stage &opening = first[1], &closing = first[2];
    const InnerDurations durations(duration, double(steps), K::COMPENSATED);
#pragma unroll 1
    for (long long step = 0; step < steps; ++step) {
        const double h = durations.of_step(step), at = time + durations.each * double(step);
        const bool opens = is_whole || step == 0, closes = is_whole || step + 1 == steps;
        const int flows = 2 * cycle + (closes && (leads_with_kick ? closing.kick : closing.drift) != 0.0 ? 1 : 0);
#pragma unroll 1
        for (int flow = 0; flow < flows; ++flow) {
            const int row = flow / 2;
            const Stage& stage = row == cycle ? closing : row == 0 && opens ? opening : first[3 + row];
            const bool kicks = (flow % 2 == 0) == leads_with_kick;
            if (kicks) {
                Inner::kick(motion, h * stage.kick, at + h * stage.kick_time);
            } else {
                Inner::drift(motion, h * stage.drift, at + h * stage.drift_time);
            }
            const double between = h * (flow % 2 == 0 ? stage.within : stage.behind);
            if (Inner::PARTS > 2 && row < cycle && between != 0.0) {
                const double reached = stage.kick_time + (leads_with_kick && !kicks ? stage.drift : 0.0);
                Inner::middle(motion, between, at + h * reached, kicks);
            }
        }
    }
}

}  // namespace integrator
