// A program around the kernels: it reads launches, each with what it works on, and writes what comes of them.

namespace integrator {

typedef void (*Advance)(const Launch&, const Stage*, const double*, const double*, double*, unsigned long long*);
typedef void (*Show)(const Launch&, const Stage*, const double*, const double*, double*, const unsigned long long*);

struct Kernels {
    int coordinates, constants, parts;
    Advance advance;
    Show show;
};

template <class System, class Composition, class R, class K> static Kernels kernels() {
    typedef Member<System, Composition, R, K> Of;
    return {2 * System::COORDINATES * K::PARTS, System::CONSTANTS, K::PARTS, Of::advance, Of::show};
}

// Those of a system in double and in single precision and compensated.
template <class System, class Composition> static void add_system(std::vector<Kernels>& to) {
    to.push_back(kernels<System, Composition, double, Plain<double>>());
    to.push_back(kernels<System, Composition, float, Plain<float>>());
    to.push_back(kernels<System, Composition, double, Compensated<double>>());
}

template <class T> static bool read_numbers(std::vector<T>& to) {
    return to.empty() || std::fread(to.data(), sizeof(T), to.size(), stdin) == to.size();
}
template <class T> static void write_numbers(const std::vector<T>& from) {
    std::fwrite(from.data(), sizeof(T), from.size(), stdout);
}

static int serve(const std::vector<Kernels>& all) {
    unsigned long long number;
    while (std::fread(&number, sizeof number, 1, stdin) == 1) {
        Launch launch;
        if (number >= all.size() || std::fread(&launch, sizeof launch, 1, stdin) != 1) return 1;
        const Kernels& of = all[number];
        const size_t members = size_t(launch.members);
        std::vector<Stage> stages(2 + launch.cycle + std::abs(launch.before) + std::abs(launch.after) + launch.inner);
        std::vector<double> constants(of.constants * members), state(of.coordinates * members), shown(state.size());
        std::vector<unsigned long long> lost(members + 1);
        if (!read_numbers(stages) || !read_numbers(constants) || !read_numbers(state) || !read_numbers(lost)) return 1;
        std::vector<double> next(state.size());
        for (size_t member = 0; member < members; ++member) {
            blockIdx.x = unsigned(member);
            of.advance(launch, stages.data(), constants.data(), state.data(), next.data(), lost.data());
        }
        launch.done += launch.steps;
        for (size_t member = 0; member < members; ++member) {
            blockIdx.x = unsigned(member);
            of.show(launch, stages.data(), constants.data(), next.data(), shown.data(), lost.data());
        }
        write_numbers(next);
        write_numbers(shown);
        write_numbers(lost);
    }
    return 0;
}

}  // namespace integrator
