// A program around the flows of many systems: it reads which flow of which system, its constants, a state, a duration and
// a time, and writes the state that the flow leaves.

struct Numbers {
    std::vector<double> read;
    // No flow that takes inner steps is called.
    const integrator::Stage* inner = nullptr;
    double operator()(int place) const { return read[place]; }
};

typedef void (*Flow)();
struct Flows {
    Flow all[3];
};

static Numbers numbers(size_t count) {
    Numbers numbers{std::vector<double>(count)};
    if (count != 0 && std::fread(numbers.read.data(), sizeof(double), count, stdin) != count) std::exit(1);
    return numbers;
}

template <class System, int which> static void flow() {
    typedef typename System::template Motion<double, integrator::Plain<double>> Motion;
    constexpr int count = System::COORDINATES;
    const typename System::template Parameters<double> parameters(numbers(System::CONSTANTS));
    const Numbers state = numbers(2 * count), times = numbers(2);
    Motion motion(parameters);
    for (int i = 0; i < count; ++i) {
        motion.position(i).number = state(i);
        motion.momentum(i).number = state(count + i);
    }
    if constexpr (which == 0) System::drift(motion, times(0), times(1));
    if constexpr (which == 1) System::kick(motion, times(0), times(1));
    if constexpr (which == 2 && System::BENDS) System::hessian(motion, times(1));
    for (int i = 0; i < 2 * count; ++i) {
        const double number = i < count ? motion.position(i).number : motion.momentum(i - count).number;
        std::fwrite(&number, sizeof number, 1, stdout);
    }
}

template <class System> static void add(std::vector<Flows>& to) {
    to.push_back({{flow<System, 0>, flow<System, 1>, flow<System, 2>}});
}

static int serve(const std::vector<Flows>& all) {
    unsigned long long which[2];
    while (std::fread(which, sizeof which, 1, stdin) == 1) {
        if (which[0] >= all.size() || which[1] >= 3) return 1;
        all[which[0]].all[which[1]]();
    }
    return 0;
}
