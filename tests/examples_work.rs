//! The examples that do real work, in short runs: each has a number that is known from elsewhere.

#[path = "../examples/trojan/asteroid.rs"]
mod asteroid;
#[path = "../examples/chaos_map/belt.rs"]
mod belt;
#[path = "../examples/pythagorean/bodies.rs"]
mod bodies;
#[path = "../examples/fit_pendulum/fit.rs"]
mod fit;
#[path = "../examples/chaos_map/galaxy.rs"]
mod galaxy;
#[path = "../examples/chaos_map/grid.rs"]
mod grid;
#[path = "../examples/halley/comet.rs"]
#[allow(dead_code, reason = "the pictures of the example read more of it")]
mod halley;
#[path = "../examples/jupiter_moons/moons.rs"]
#[allow(dead_code, reason = "the example compares methods")]
mod jupiter_moons;
#[path = "../examples/polymer_melt/melt.rs"]
#[allow(dead_code, reason = "the example melts the crystal and compares times")]
mod melt;
#[path = "../examples/penning_trap/trap.rs"]
mod penning_trap;
#[path = "../examples/wisdom_holman/planets.rs"]
mod planets;
#[path = "../examples/fundamental_frequencies/secular.rs"]
mod secular;
#[path = "../examples/spring_pendulum/pendulum.rs"]
mod spring_pendulum;
#[path = "../examples/coupled_oscillators/star.rs"]
mod star;
#[path = "../examples/storage_ring/ring.rs"]
mod storage_ring;
#[path = "../examples/study/sweep.rs"]
mod sweep;
#[path = "../examples/transit_times/planets.rs"]
mod transits;

use integrator_core::prelude::*;
use planets::system;
use std::{fs, io::Read as _, ops::ControlFlow, path::Path};

/// In 300,000 years, the fastest frequencies of perihelia and nodes are resolved. The others need the ten million years of the
/// example.
#[test]
fn the_perihelion_and_the_node_of_saturn_turn_as_published() {
    let (found, years) = secular::fundamental(990).expect("frequencies");
    assert!((years - 3e5).abs() < 1e3, "{years}");
    for number in [1, 4] {
        let ((name, found), (_, published)) = (found[number], secular::PUBLISHED[number]);
        assert!((found / published - 1.0).abs() < 0.01, "{name}: {found}, not {published}");
    }
}

/// About half of the section is regular at the energy 1/8 (Hénon and Heiles 1964, figure 7), and asteroids are chaotic near
/// Jupiter (Wisdom 1980), but for those that resonances protect.
#[test]
fn maps_show_where_orbits_are_chaotic() {
    let grid = grid::Grid { along: (-0.45, 0.75), up: (-0.5, 0.5), columns: 14, rows: 14 };
    let mut rows = 0;
    let mut goes_on = || {
        rows += 1;
        true
    };
    let section = grid.rows(|places| galaxy::megno(places.iter().copied()), &mut goes_on).expect("starts");
    let share = grid::regular(&section);
    assert!((0.35..0.6).contains(&share), "{share} of the section are regular");
    assert!(section[0][0].is_nan() && rows == 14, "the corner has too much energy");
    // In the main belt; between resonances near Jupiter; in that of the Hilda group.
    let [.., hilda, _] = belt::resonances();
    let belt = belt::megno([(2.3, 0.1), (3.7, 0.4), (hilda, 0.3)].into_iter()).expect("starts");
    assert!(belt[0] < 2.5 && belt[1] > 4.0 && belt[2] < 2.5, "{belt:?}");
}

/// What is found is off by as much as its standard error says, and the noise is found as well.
#[test]
fn the_length_of_a_pendulum_follows_from_a_noisy_series() {
    let (hidden, count, series) = (fit::Unknown::new(1.0, 1.2, 0.5), 100, 40_u64);
    let mut squares = 0.0;
    for seed in 0..series {
        let mut random = fastrand::Rng::with_seed(seed);
        // The sum of twelve numbers between 0 and 1 is nearly normal, with a variance of one.
        let normal = || (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
        let seen = fit::series(hidden, count, normal).expect("finite states");
        let found = fit::fit(&seen, fit::Unknown::new(1.02, 1.1, 0.3)).expect("finite states");
        let (length, error) = found.length();
        squares += ((length - 1.0) / error).powi(2);
        assert!(error < 3e-3 && found.iterations < 10, "± {error:e} after {} iterations", found.iterations);
        // The mean of a hundred squares of normal numbers varies by the root of 2/100; four times that.
        assert!((found.residual / fit::NOISE - 1.0).abs() < 0.3, "{}", found.residual);
        let (period, _) = found.small_period();
        // 2π √(1/9.81), to four standard errors of half that of the length.
        assert!((period - 2.006_066_680_710_647).abs() < 4.0 * error, "{period}");
    }
    // The mean of 40 squares of normal numbers varies by the root of 2/40; four times that. A length by which a derivative was
    // wrong would not be found, and an error that is twice as large would have a mean of a quarter.
    let mean = squares / series as f64;
    assert!((mean - 1.0).abs() < 0.9 && mean > 0.3, "lengths are off by {mean} of their variances");
}

/// The ideal trap is solved exactly, whatever the step; the octupole shifts the axial frequency by `3/4 C₄ A²` to first
/// order, and by less than twice the square of that in the next one.
#[test]
fn a_particle_in_a_penning_trap_has_the_frequencies_of_the_literature() {
    let ideal = penning_trap::Trap { cyclotron: 1.0, axial: 0.0137, octupole: 0.0 };
    let radii = [0.02, 0.05];
    let mut run = ideal.run(ideal.start(radii, 0.1), 4.0).expect("a run");
    run.advance(20_000).expect("finite states");
    let exact = ideal.orbit(radii, run.time());
    for (q, exact) in run.state().q.into_iter().zip(exact) {
        // An angle of 8e4 is rounded by 1e-11, here and in the closed form.
        assert!((q - exact).abs() < 1e-12, "{q} and {exact}");
    }
    let real = penning_trap::Trap { octupole: 1e-3, ..ideal };
    for amplitude in [0.2, 0.8] {
        let start = real.start([0.0, 0.0], amplitude);
        let frequency = penning_trap::axial_frequency(&real, start, 4.0, 20_000).expect("finite states");
        let (shift, first_order) = (frequency / real.axial - 1.0, 0.75 * real.octupole * amplitude * amplitude);
        assert!((shift - first_order).abs() < 2.0 * first_order * first_order + 1e-10, "{shift} and {first_order}");
    }
}

/// Elements are solved exactly, so that small oscillations have the tune of the textbook's matrices.
#[test]
fn a_storage_ring_has_the_tune_of_its_matrices_and_loses_large_amplitudes() {
    let cell = storage_ring::Cell { quadrupole: 0.5, gradient: 0.6, drift: 2.0, sextupole: 0.4 };
    for (axis, expected) in cell.phase_advances().into_iter().enumerate() {
        let advance = storage_ring::tracked_advance(&cell, axis).expect("finite states");
        assert!((advance - expected).abs() < 1e-9, "{advance} and {expected}");
    }
    let survives = |x: f64| cell.survives(Phase::new([x, 1e-3], [0.0; 2]), 2_000, 10.0).expect("a start");
    assert_eq!((survives(0.01), survives(0.05)), (2_000, 2_000));
    assert!(survives(5.0) < 100);
}

/// Steps of 244 days arrive within 1e-10 of the reference; `T + V` misses it by ten thousand times that with as many forces.
#[test]
fn planets_need_few_steps_with_kepler_orbits() {
    let (system, start) = system::measured().expect("the table of the examples");
    let [separable, _] = planets::end(&system, BlanesMoanSrkn14, start, 4096 * 8 / 14).expect("a run");
    let [by_kepler, _] = planets::end(&planets::Planets(system), Aba1064, start, 4096).expect("a run");
    assert!(by_kepler < 1e-10, "{by_kepler:e}");
    assert!(separable > 1e-6, "{separable:e}");
}

/// Observed were 20.18 April 1910 and 9.46 February 1986; the jets of the comet, which are worth four days a revolution, and
/// the inner planets are missing.
#[test]
fn halleys_comet_comes_when_it_was_seen() {
    let (system, start) = halley::start().expect("the table of the examples");
    let days = halley::perihelia(&system, start, [2_410_000.0, halley::BEGIN + 100.0]).expect("finite states");
    let [last, before] = days[..] else { panic!("two perihelia: {days:?}") };
    let known = |year| halley::KNOWN.iter().find(|(of, _)| *of == year).expect("a year").1;
    assert!((last - known(1986)).abs() < 1.0, "{last}");
    assert!((before - known(1910)).abs() < 4.0, "{before}");
}

/// Szebehely and Peters (1967): the closest approach is 4e-4 near t = 15.8299; at the end mass 3 leaves and the others are a
/// binary.
#[test]
fn the_pythagorean_problem_ends_as_published() {
    let (distance, time) = bodies::closest_approach(0.1).expect("finite states");
    assert!((4e-4..4.3e-4).contains(&distance) && (time - 15.8299).abs() < 1e-3, "{distance:e} at {time}");
    let [(coarse, _), (fine, change)] = [0.1, 0.07].map(|h| bodies::end(h).expect("finite states"));
    assert!(change.abs() < 1e-11, "{change:e}");
    let q = fine.state().q;
    let [near, far] = [bodies::distance(&q, 1, 2), bodies::distance(&q, 0, 1)];
    assert!(near < 1.0 && far > 25.0, "{near} and {far}");
    // Roundings grow by ten million on the way.
    let apart = (coarse.state().q[0][0].value - q[0][0].value).abs();
    assert!(apart < 1e-4, "{apart:e}");
}

/// The linear theory of the triangle's corner has 147.4 years for Jupiter (Danby 1962).
#[test]
fn a_trojan_goes_to_and_fro_in_147_years() {
    let years = asteroid::YEAR / asteroid::slow_frequency();
    assert!((years - 147.4).abs() < 0.1, "{years}");
    let run = asteroid::Asteroid.run(asteroid::start(0.1), 0.1).expect("a start");
    let angles = run.samples(10).take(1600).map(|sample| asteroid::ahead(sample.expect("finite states").state.q));
    let angles: Vec<f64> = angles.collect();
    let mean = angles.iter().sum::<f64>() / angles.len() as f64;
    assert!(angles.iter().all(|angle| angle.abs() < 0.11), "it stays near the corner");
    let angles: Vec<f64> = angles.into_iter().map(|angle| angle - mean).collect();
    let found = asteroid::strongest(&angles, 1.0, asteroid::slow_frequency());
    // A window over twenty periods tells frequencies apart to a small part of one in twenty.
    assert!((found / asteroid::slow_frequency() - 1.0).abs() < 1e-3, "{found}");
}

/// What is composed is of third degree, so that the error falls with the size of the orbit; that of `T + V` stays.
#[test]
fn solved_oscillators_leave_an_error_of_the_coupling_alone() {
    use star::{Oscillators, Star, energy_change};
    let changes = |size: f64| {
        let by_parts = energy_change(&Oscillators, Verlet, size, 0.2).expect("finite states");
        [energy_change(&Star, Verlet, size, 0.2).expect("finite states"), by_parts]
    };
    let ([plain, parts], [small_plain, small_parts]) = (changes(0.3), changes(0.003));
    assert!(parts < 0.3 * plain && small_plain > 0.3 * plain, "{parts} {plain} {small_plain}");
    assert!((parts / small_parts / 100.0 - 1.0).abs() < 0.1, "{parts} {small_parts}");
    let long = energy_change(&Oscillators, Aba864, 0.03, 0.2).expect("finite states");
    assert!(long < 1e-11, "{long}");
}

/// A study that is stopped after each piece, and begins a piece again, writes the files of one that never was.
#[test]
fn a_study_resumes_where_it_was_stopped() {
    let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/data/study");
    let folder = std::env::temp_dir().join(format!("study-{}", std::process::id()));
    let [at_once, by_pieces] = ["at_once", "by_pieces"].map(|name| folder.join(name));
    let outcomes = sweep::sweep(&from, &at_once, |_| ControlFlow::Continue(())).expect("a study").expect("not stopped");
    let (mut stops, mut again) = (0, None);
    while again.is_none() {
        again = sweep::sweep(&from, &by_pieces, |_| ControlFlow::Break(())).expect("a study");
        stops += 1;
        if stops == 1 {
            // Killed before the checkpoint was written.
            fs::remove_file(by_pieces.join("orbit_0.6_0.run")).expect("a checkpoint");
        }
    }
    // Each piece of nine orbits, one of them twice, and the call that finds nothing left.
    assert_eq!((stops, again.as_ref()), (9 * 4 + 2, Some(&outcomes)));
    // A sixth-order step of 0.02, where orbits take about five.
    assert!(outcomes.iter().all(|outcome| outcome.error.abs() < 1e-8), "{outcomes:?}");
    let files = fs::read_dir(&at_once).expect("a folder").map(|entry| entry.expect("an entry").path());
    let mut arrays = 0;
    for path in files.filter(|path| path.extension().is_some_and(|of| of == "npz")) {
        let other = by_pieces.join(path.file_name().expect("a name"));
        let [one, other] = [&path, &other].map(|path| positions(path));
        assert_eq!(one, other);
        // 251 samples with the start of the orbit, 250 without, behind the head of the array.
        let first = path.to_string_lossy().ends_with("_0.npz");
        assert_eq!(one.len() - 128, (250 + usize::from(first)) * 2 * size_of::<f64>());
        arrays += 1;
    }
    assert_eq!(arrays, 9 * 4);
    fs::remove_dir_all(folder).expect("a folder");
}

/// The array of positions, as bytes.
fn positions(path: &Path) -> Vec<u8> {
    let mut archive = zip::ZipArchive::new(fs::File::open(path).expect("a file")).expect("an archive");
    let mut bytes = Vec::new();
    archive.by_name("q.npy").expect("an array").read_to_end(&mut bytes).expect("bytes");
    bytes
}

/// Small swings have the frequency of a rod that is as long as the loaded spring; swings of 90 degrees have the period of Gauss,
/// and an excess of first order. The step resonates with a force that varies with the length of the spring at half its period.
#[test]
fn a_stiff_spring_swings_like_a_rod_and_resonates_with_outer_steps() {
    use spring_pendulum::{Pendulum, error_at, excess_of_a_right_angle, period, rigid_period};
    let right_angle = std::f64::consts::FRAC_PI_2;
    // Γ(1/4)² / √π, with Γ(1/4) = 3.625609908221908.
    assert!((rigid_period(right_angle) - 7.416_298_709_205_487).abs() < 1e-14, "{}", rigid_period(right_angle));
    let spring = |frequency| Pendulum { frequency, band: 0.0 };
    let (angle, frequency) = (0.01_f64, 10.0_f64);
    let small = period(&spring(frequency), angle, 0.01, 3).expect("finite states");
    let loaded = std::f64::consts::TAU * (1.0 + frequency.powi(-2)).sqrt();
    // A rod takes longer by θ²/16 at an angle θ, and steps of the frequency 1 are off by h²/24.
    let later = angle.powi(2) / 16.0 + 1e-4 / 24.0;
    assert!((small / loaded - 1.0).abs() < 2.0 * later, "{small} and {loaded}");
    let frequency = 40.0_f64;
    let found = period(&spring(frequency), right_angle, 0.1 / frequency, 2).expect("finite states");
    let excess = (found - rigid_period(right_angle)) * frequency.powi(2);
    // The next order is smaller by about 1/ω², and the step is off by 0.01/24 of the excess: twenty times both together.
    assert!((excess / excess_of_a_right_angle() - 1.0).abs() < 0.02, "{excess}");
    let error =
        |band, halves| error_at(&Pendulum { frequency: 30.0, band }, 0.5, halves, 200.0).expect("finite states");
    let [beside, at_half_a_period] = [0.9, 0.995].map(|halves| error(4.0, halves));
    assert!(at_half_a_period > 100.0 * beside, "{at_half_a_period} and {beside}");
    let [beside, at_half_a_period] = [0.9, 0.995].map(|halves| error(0.0, halves));
    assert!(at_half_a_period < 2.0 * beside, "{at_half_a_period} and {beside}");
    let [beside, at_a_period] = [0.9, 2.0].map(|halves| error(0.0, halves));
    assert!(at_a_period > 100.0 * beside, "{at_a_period} and {beside}");
}

/// The fastest mode of a straight chain with free ends has a known frequency. In many chains, inner steps save 7/8 of the evaluations
/// of pairs at nearly the error of Verlet's method.
#[test]
fn bonds_of_a_melt_are_as_fast_as_a_chain_and_take_inner_steps() {
    use std::f64::consts::PI;
    let (chain, mut start) = melt::crystal(10, 10);
    let mode: [f64; 10] = std::array::from_fn(|bead| (0.9 * PI * (bead as f64 + 0.5)).cos());
    start.p = mode.map(|along| [10.0 * along, 0.0, 0.0]).to_vec();
    let amplitude = |q: &[[f64; 3]]| mode.iter().zip(q).map(|(along, q)| along * q[0]).sum::<f64>();
    let begin = amplitude(&start.q);
    let run = melt::Melt(chain).run(start, 1e-4).expect("a start");
    let passages = run.crossings(10_000, Direction::Rising, |state, _| amplitude(&state.q) - begin).take(11);
    let times: Vec<f64> = passages.map(|passage| passage.expect("finite states").time).collect();
    let frequency = 20.0 * PI / (times[10] - times[0]);
    // ω = 2 √k cos(π/2n). Lennard-Jones forces of neighbours at rest add 313 to the stiffness of 1e5, and steps of h ω = 0.06 add
    // (h ω)²/24: together 0.17 % of ω. Two times that.
    let known = 2.0 * melt::STIFFNESS.sqrt() * (PI / 20.0).cos();
    assert!((frequency / known - 1.0).abs() < 3.5e-3, "{frequency} and {known}");

    let (chains, start) = melt::crystal(6, 200);
    let (plain, nested) = (melt::Melt(chains.clone()), melt::NestedMelt(chains));
    let verlet = melt::cost(&plain, Verlet, &start, 5e-4, 0.02).expect("finite states");
    let with_inner_steps = melt::cost(&nested, Verlet.nested(8), &start, 4e-3, 0.02).expect("finite states");
    assert!(with_inner_steps.error < 3.0 * verlet.error, "{} and {}", with_inner_steps.error, verlet.error);
    let mut run = nested.run(start, 4e-3).expect("a start");
    run.advance(3).expect("finite states");
    assert_eq!(run.evaluations_of_parts()[..2], [("pairs", 3), ("bonds", 27)]);
}

/// The moons of Jupiter have their observed periods, and Laplace's angle stays at 180 degrees.
#[test]
fn moons_of_jupiter_have_their_periods_and_the_resonance_of_laplace() {
    let (masses, start) = jupiter_moons::start().expect("the table of the examples");
    let moons = jupiter_moons::Moons(masses);
    let jupiter_moons::Course { periods, laplace: [least, _, largest] } =
        jupiter_moons::course(&moons, start, 0.25, 500.0).expect("finite states");
    for (found, observed) in periods.into_iter().zip(jupiter_moons::PERIODS) {
        // Osculating longitudes swing by half a degree, and each moon moves by more than 29 × 360 degrees.
        assert!((found / observed - 1.0).abs() < 5e-5, "{found} and {observed}");
    }
    // The free libration has an amplitude of 0.07 degrees (Lieske 1998); three osculating longitudes swing by less than a degree.
    assert!(least > 179.0 && largest < 181.0, "{least} to {largest}");
}

/// The gradient of the misses of transit times is the limit of differences, by an initial coordinate and by a mass.
#[test]
fn misses_of_transit_times_have_their_gradient() {
    let orbit = |period: f64, longitude, mass: f64| transits::Orbit {
        longitude,
        period,
        eccentricity: [0.01, -0.02],
        mass: mass.ln(),
    };
    let orbits = [orbit(10.0, 1.1, 2e-5), orbit(15.7, 3.0, 3e-5), orbit(24.9, 5.2, 2e-5), orbit(38.9, 0.4, 4e-5)];
    let (system, start) = transits::start(&orbits);
    let found = transits::transits(&system, start, 2_600).expect("transits");
    // Periods are changed by about the mass of a neighbour.
    assert_eq!(found.iter().filter(|transit| transit.planet == 0).count(), 5);
    let late: Vec<_> =
        found.iter().map(|transit| transits::Transit { time: transit.time + 1e-3, ..*transit }).collect();
    let value = |masses: [f64; 4], q: f64| {
        let mut moved = start;
        moved.q[2][1] += q;
        transits::misses(&transits::System::of(masses), moved, &late, 1e-3).expect("misses")
    };
    let (gradient, by_masses) = value(system.masses(), 0.0);
    // All measured times are late by one error, up to those of samples: two seconds, squared.
    assert!((gradient.value / found.len() as f64 - 1.0).abs() < 0.1, "{}", gradient.value);
    let moved = |by: f64| {
        let mut masses = system.masses();
        masses[2] += by;
        value(masses, 0.0).0.value
    };
    for (name, slope, difference) in [
        ("a mass", by_masses[2], (moved(1e-10) - moved(-1e-10)) / 2e-10),
        ("a position", gradient.start.q[2][1], {
            let at = |by| value(system.masses(), by).0.value;
            (at(1e-10) - at(-1e-10)) / 2e-10
        }),
    ] {
        // Values of about a hundred are rounded in their last digits after 2,600 steps: 1e-12 by the width and by slopes of 1e5.
        assert!((slope / difference - 1.0).abs() < 1e-4, "{name}: {slope} and {difference}");
    }
}
