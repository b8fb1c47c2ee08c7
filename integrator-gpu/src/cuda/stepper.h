// The loop over the steps of a composition, as in integrator-core/src/composition and trajectory/step_loop.rs: one member
// per thread, its state in registers, its numbers one array for each coordinate and each constant.

namespace integrator {

// How a coordinate is kept.
template <class R> struct Plain {
    R number;
    static constexpr int PARTS = 1;
    static constexpr bool COMPENSATED = false;
    DEVICE R value() const { return number; }
    DEVICE void add(R d) { number = number + d; }
    DEVICE void fma(R a, R b) { number = integrator::fma(a, b, number); }
    DEVICE double part(int) const { return double(number); }
    DEVICE void set(int, double part) { number = R(part); }
};
template <class R> struct Compensated {
    R number, carried;
    static constexpr int PARTS = 2;
    static constexpr bool COMPENSATED = true;
    DEVICE R value() const { return number; }
    DEVICE void add(R d) { number = fast_two_sum(number, d + carried, carried); }
    DEVICE void fma(R a, R b) { number = fast_two_sum(number, integrator::fma(a, b, carried), carried); }
    DEVICE double part(int part) const { return double(part == 0 ? number : carried); }
    DEVICE void set(int part, double value) { (part == 0 ? number : carried) = R(value); }
};

// An element of a table over the sites of a line; zero where it has none.
template <class T, int LENGTH> DEVICE T element_of(const T (&table)[LENGTH], long long at) {
    return at < LENGTH ? table[at] : T(0);
}

// A sum over the iterations of a loop in the order of integrator-core/src/layout/loops.rs: in groups of eight, iteration `n`
// adds to partial sum `n` modulo 16; the rest has a sum of its own; partial sums are added in pairs, and then the rest.
template <class R> struct PartialSums {
    static constexpr int COUNT = 16, GROUP = 8;
    R partial[COUNT] = {}, rest = R(0.0);
    long long from, grouped;
    DEVICE PartialSums(long long from, long long to) : from(from), grouped(from < to ? (to - from) / GROUP * GROUP : 0) {}
    DEVICE R& at(long long i) { return i - from < grouped ? partial[(i - from) % COUNT] : rest; }
    DEVICE R total() {
        if (grouped == 0) return rest;
        for (int half = COUNT / 2; half > 0; half /= 2) {
            for (int n = 0; n < half; ++n) partial[n] = partial[n] + partial[n + half];
        }
        return partial[0] + rest;
    }
};

// As `Stage` in Rust.
struct Stage {
    double drift, kick, gradient, drift_time, kick_time, within, behind;
};

// By how much the first flow of a kind is longer in some cycles of a compensated run.
struct Correction {
    double longer;
    unsigned long long frequency;
};

// A launch: from `done` steps on so many more, with the stages of a composition behind each other: opening, closing,
// those of a cycle, those before and behind a processed one, and `inner` rows of inner compositions.
struct Launch {
    double t0, h;
    long long members;
    unsigned long long done, steps;
    int leads_with_kick, cycle, before, after, is_whole, inner;
    Correction drift, kick, middle;
};

// What is known of a composition when a kernel is compiled: of any one, nothing. A kernel of one alone has the stages of a
// step behind each other, without a question which flow leads, and computes before the first step what is the same in all.
struct AnyComposition {
    static constexpr int CYCLE = 0;
    static constexpr bool LEADS_WITH_KICK = false, HAS_GRADIENTS = true, HAS_PROCESSOR = true, MAY_BE_WHOLE = true;
};

template <class System, class Composition, class R, class K> struct Stepper {
    typedef typename System::template Motion<R, K> Motion;
    typedef typename System::template Motion<R, Plain<R>> Numbers;
    static constexpr int COORDINATES = System::COORDINATES;
    static constexpr bool BENDS = System::BENDS && Composition::HAS_GRADIENTS;
    // Stages of many coordinates stay in a loop: their instructions would not fit into the cache of instructions.
    static constexpr int STAGES_AT_A_TIME = Composition::CYCLE * COORDINATES <= 64 && Composition::CYCLE > 1 ? Composition::CYCLE : 1;

    const Launch& launch;
    const Stage* stages;
    Motion& motion;
    double longer_drift, longer_kick, longer_middle;

    DEVICE Stepper(const Launch& launch, const Stage* stages, Motion& motion)
        : launch(launch), stages(stages), motion(motion), longer_drift(0.0), longer_kick(0.0), longer_middle(0.0) {}

    DEVICE int cycle_length() const { return Composition::CYCLE == 0 ? launch.cycle : Composition::CYCLE; }
    DEVICE bool leads_with_kick() const {
        return Composition::CYCLE == 0 ? launch.leads_with_kick != 0 : Composition::LEADS_WITH_KICK;
    }

    DEVICE static double corrected(double duration, double& longer) {
        if constexpr (!K::COMPENSATED) return duration;
        const double now = longer;
        longer = 0.0;
        return duration + now;
    }
    DEVICE void drift(double duration, double time) { System::drift(motion, corrected(duration, longer_drift), time); }
    DEVICE void flow_of_kick(double duration, double time) {
        System::kick(motion, corrected(duration, longer_kick), time);
    }
    DEVICE void middle(double duration, double time, bool backwards) {
        System::middle(motion, corrected(duration, longer_middle), time, backwards);
    }
    DEVICE void moving_middle(double duration, double time, bool backwards) {
        if (duration != 0.0) middle(duration, time, backwards);
    }

    // The exact flow of duration V + gradient |grad V|^2, put together from flows of a motion that starts at rest.
    DEVICE void gradient_kick(double duration, double gradient, double time) {
        duration = corrected(duration, longer_kick);
        Numbers force(motion.parameters), bent(motion.parameters);
        for (int i = 0; i < COORDINATES; ++i) {
            bent.position(i).number = force.position(i).number = motion.position(i).value();
            force.momentum(i).number = R(0.0);
        }
        System::kick(force, -1.0, time);
        push(R(-duration), force);
        for (int i = 0; i < COORDINATES; ++i) force.position(i).number = R(0.0);
        System::drift(force, 1.0, time);
        for (int i = 0; i < COORDINATES; ++i) bent.momentum(i) = force.position(i);
        bend(bent, time);
        push(R(-2.0 * gradient), bent);
    }
    DEVICE static void bend(Numbers& bent, double time) {
        if constexpr (System::BENDS) System::hessian(bent, time);
    }
    DEVICE void push(R factor, Numbers& other) {
        for (int i = 0; i < COORDINATES; ++i) motion.momentum(i).fma(factor, other.momentum(i).number);
    }

    DEVICE void kick(const Stage& stage, double time) {
        const double h = launch.h, duration = h * stage.kick, at = time + h * stage.kick_time;
        if (BENDS && stage.gradient != 0.0) {
            gradient_kick(duration, h * h * h * stage.gradient, at);
        } else if (System::PAIRED) {
            middle(duration / 2.0, at, false);
            flow_of_kick(duration, at);
            middle(duration / 2.0, at, true);
        } else {
            flow_of_kick(duration, at);
        }
    }
    DEVICE void stage(const Stage& stage, double time) {
        const double h = launch.h;
        constexpr bool many = System::PARTS > 2 && !System::PAIRED;
        const double before = time + h * stage.kick_time, after = time + h * (stage.kick_time + stage.drift);
        if (leads_with_kick()) {
            kick(stage, time);
            if (many) moving_middle(h * stage.within, before, true);
        }
        drift(h * stage.drift, time + h * stage.drift_time);
        if (leads_with_kick()) {
            if (many) moving_middle(h * stage.behind, after, false);
        } else {
            if (many) moving_middle(h * stage.within, before, false);
            kick(stage, time);
            if (many) moving_middle(h * stage.behind, before, true);
        }
    }
    // The stages of a processor, in which what is zero is left out. They lead with their own kind of flow, which is that of
    // the composition or stands in the sign of their number.
    DEVICE void processor(const Stage* rows, int count, double time) {
        if constexpr (!Composition::HAS_PROCESSOR) return;
        const bool leads_with_kick = count < 0;
        for (int row = 0; row < (count < 0 ? -count : count); ++row) {
            const Stage& stage = rows[row];
            const bool kicks = stage.kick != 0.0 || stage.gradient != 0.0;
            if (kicks && leads_with_kick) kick(stage, time);
            if (stage.drift != 0.0) drift(launch.h * stage.drift, time + launch.h * stage.drift_time);
            if (kicks && !leads_with_kick) kick(stage, time);
        }
    }

    DEVICE double at(unsigned long long step) const { return launch.t0 + double(step) * launch.h; }
    DEVICE const Stage* cycle() const { return stages + 2; }
    DEVICE const Stage* before() const { return cycle() + cycle_length(); }
    DEVICE const Stage* after() const { return before() + (launch.before < 0 ? -launch.before : launch.before); }

    DEVICE static double passes(const Correction& correction, unsigned long long cycle) {
        return cycle * correction.frequency < correction.frequency ? correction.longer : 0.0;
    }
    // Steps from `done` to `end`; between steps the state stays just before the end of the last one.
    DEVICE void steps(unsigned long long done, unsigned long long end) {
        if constexpr (Composition::MAY_BE_WHOLE) {
            if (launch.is_whole) return whole_steps(done, end);
        }
        if (done == 0 && end > 0) {
            open(0);
            done = 1;
        }
        for (; done < end; ++done) {
            lengthen(done);
#pragma unroll STAGES_AT_A_TIME
            for (int row = 0; row < cycle_length(); ++row) stage(cycle()[row], at(done));
            longer_drift = longer_kick = longer_middle = 0.0;
        }
    }
    // Steps that are completed one by one.
    DEVICE void whole_steps(unsigned long long done, unsigned long long end) {
        for (; done < end; ++done) {
            close(done);
            lengthen(done);
            open(done);
            longer_drift = longer_kick = longer_middle = 0.0;
        }
    }
    DEVICE void lengthen(unsigned long long cycle) {
        if (K::COMPENSATED) {
            longer_drift = passes(launch.drift, cycle);
            longer_kick = passes(launch.kick, cycle);
            longer_middle = passes(launch.middle, cycle);
        }
    }
    // From a completed step to just before the end of the next one.
    DEVICE void open(unsigned long long step) {
        processor(before(), launch.before, at(step));
        stage(stages[0], at(step));
        for (int row = 1; row < cycle_length(); ++row) stage(cycle()[row], at(step));
    }
    // Completes the step under way, and undoes the processor.
    DEVICE void close(unsigned long long done) {
        if (done == 0) return;
        const Stage& closing = stages[1];
        const double h = launch.h, time = at(done - 1);
        if (leads_with_kick()) {
            if (closing.kick != 0.0 || closing.gradient != 0.0) kick(closing, time);
        } else if (closing.drift != 0.0) {
            drift(h * closing.drift, time + h * closing.drift_time);
        }
        processor(after(), launch.after, time);
    }
};

// The numbers of one member, of which those of all members are one array for each.
struct Column {
    const double* first;
    long long members;
    // The stages of inner compositions, which are the same for all members.
    const Stage* inner;
    DEVICE double operator()(int row) const { return first[row * members]; }
};

template <class System, class Composition, class R, class K> struct Member {
    typedef typename System::template Motion<R, K> Motion;
    typedef typename System::template Parameters<R> Parameters;

    // Compositions over inner steps have no processor.
    DEVICE static const Stage* inner(const Launch& launch, const Stage* stages) { return stages + 2 + launch.cycle; }
    DEVICE static void load(Motion& motion, const double* from, long long members) {
        for (int part = 0; part < K::PARTS; ++part) {
            for (int i = 0; i < System::COORDINATES; ++i) {
                motion.position(i).set(part, from[((2 * part) * System::COORDINATES + i) * members]);
                motion.momentum(i).set(part, from[((2 * part + 1) * System::COORDINATES + i) * members]);
            }
        }
    }
    DEVICE static void store(Motion& motion, double* to, long long members) {
        for (int part = 0; part < K::PARTS; ++part) {
            for (int i = 0; i < System::COORDINATES; ++i) {
                to[((2 * part) * System::COORDINATES + i) * members] = motion.position(i).part(part);
                to[((2 * part + 1) * System::COORDINATES + i) * members] = motion.momentum(i).part(part);
            }
        }
    }
    DEVICE static bool is_finite(Motion& motion) {
        bool finite = true;
        for (int i = 0; i < System::COORDINATES; ++i) {
            const R q = motion.position(i).value(), p = motion.momentum(i).value();
            finite = finite && q - q == R(0.0) && p - p == R(0.0);
        }
        return finite;
    }

    // Takes steps. Whoever leaves the finite numbers is taken back to the last finite step, which is noted, one more than
    // its number, and stays there; that there is somebody stands behind the notes on all.
    DEVICE static void advance(const Launch& launch, const Stage* stages, const double* constants, const double* from,
                               double* to, unsigned long long* lost) {
        const long long member = blockIdx.x * (long long)blockDim.x + threadIdx.x;
        if (member >= launch.members) return;
        Motion motion(Parameters(Column{constants + member, launch.members, inner(launch, stages)}));
        load(motion, from + member, launch.members);
        if (lost[member] == 0) {
            const unsigned long long end = launch.done + launch.steps;
            Stepper<System, Composition, R, K>(launch, stages, motion).steps(launch.done, end);
            if (!is_finite(motion)) {
                load(motion, from + member, launch.members);
                for (unsigned long long step = launch.done; step < end; ++step) {
                    const Motion last = motion;
                    Stepper<System, Composition, R, K>(launch, stages, motion).steps(step, step + 1);
                    if (!is_finite(motion)) {
                        motion = last;
                        lost[member] = step + 1;
                        lost[launch.members] = 1;
                        break;
                    }
                }
            }
        }
        store(motion, to + member, launch.members);
    }

    // Completes the step under way, of whoever is lost the last finite one.
    DEVICE static void show(const Launch& launch, const Stage* stages, const double* constants, const double* from,
                            double* to, const unsigned long long* lost) {
        const long long member = blockIdx.x * (long long)blockDim.x + threadIdx.x;
        if (member >= launch.members) return;
        Motion motion(Parameters(Column{constants + member, launch.members, inner(launch, stages)}));
        load(motion, from + member, launch.members);
        Stepper<System, Composition, R, K>(launch, stages, motion).close(lost[member] == 0 ? launch.done : lost[member] - 1);
        store(motion, to + member, launch.members);
    }
};

}  // namespace integrator
