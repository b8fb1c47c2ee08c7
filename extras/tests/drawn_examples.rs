//! The examples that draw, in short runs: each has a number that is known from elsewhere, and its picture.

#[path = "../../examples/fput_recurrence/chain.rs"]
mod chain;
#[path = "../../examples/fput_recurrence/picture.rs"]
mod chain_picture;
#[path = "../../examples/heat_conduction/picture.rs"]
mod conduction_picture;
#[path = "../../examples/heat_conduction/conductor.rs"]
mod conductor;
#[path = "support/drawn.rs"]
mod drawn;
#[path = "../../examples/driven_pendulum/pendulum.rs"]
#[allow(dead_code, reason = "tests/examples_friction.rs looks for the doublings")]
mod driven;
#[path = "../../examples/driven_pendulum/picture.rs"]
mod driven_picture;
#[path = "../../examples/duffing/oscillator.rs"]
#[allow(dead_code, reason = "tests/examples_friction.rs measures the exponents")]
mod duffing;
#[path = "../../examples/duffing/picture.rs"]
mod duffing_picture;
#[path = "../../examples/lennard_jones/liquid.rs"]
mod liquid;
#[path = "../../examples/lennard_jones/observables.rs"]
mod liquid_observables;
#[path = "../../examples/lennard_jones/picture.rs"]
mod liquid_picture;
#[path = "../../examples/polymer_melt/melt.rs"]
#[allow(dead_code, reason = "the example melts the crystal and compares times")]
mod melt;
#[path = "../../examples/polymer_melt/picture.rs"]
mod melt_picture;
#[path = "../../examples/toda_soliton/ring.rs"]
mod ring;
#[path = "../../examples/toda_soliton/picture.rs"]
mod ring_picture;
#[path = "../../examples/henon_heiles_section/section.rs"]
mod section;
#[path = "../../examples/henon_heiles_section/picture.rs"]
mod section_picture;
#[path = "../../examples/spring_pendulum/pendulum.rs"]
#[allow(dead_code, reason = "the example also measures periods")]
mod spring;
#[path = "../../examples/spring_pendulum/picture.rs"]
mod spring_picture;
#[path = "../../examples/ensemble_separatrix/swarm.rs"]
mod swarm;
#[path = "../../examples/ensemble_separatrix/picture.rs"]
mod swarm_picture;
#[path = "../../examples/paul_trap/trap.rs"]
mod trap;
#[path = "../../examples/paul_trap/picture.rs"]
mod trap_picture;

use drawn::drawn;
use integrator_core::prelude::*;
use section_picture::Section;

/// Below an energy of about 0.11 there is hardly an orbit that is not regular, and at the energy of escape hardly one
/// that is (Hénon and Heiles 1964).
#[test]
fn order_gives_way_to_chaos_in_the_galaxy() {
    let section = |name: &'static str, energy: f64| {
        let orbits: Vec<_> = section::starts(energy, 5)
            .into_iter()
            .map(|start| section::orbit(energy, start, 150).expect("finite states"))
            .collect();
        assert!(orbits.len() > 12, "{} starts", orbits.len());
        assert!(orbits.iter().all(|orbit| orbit.energy_error < 1e-8 && orbit.points.len() == 151));
        Section { name, energy, orbits }
    };
    let sections = [section("1/12", 1.0 / 12.0), section("1/6", 1.0 / 6.0)];
    let [low, at_escape] = [0, 1].map(|i| sections[i].regular());
    assert!(low == 1.0 && at_escape < 0.25, "{low} and {at_escape} of the sections are regular");
    let words = ["Energy 1/12", "100 % of the section", "Energy 1/6", "p_y"];
    let text = drawn("sections", &section_picture::picture(&sections), &words);
    assert_eq!(text.matches("<image").count(), 2, "the points of a section are one bitmap");
}

/// No orbit leaves what its energy allows.
#[test]
fn sections_have_a_border() {
    let energy = 0.125;
    let border = section::border(energy);
    // On it, all energy is in y: p_y²/2 + y²/2 - y³/3.
    assert!(border.iter().all(|(y, py)| (py * py / 2.0 + y * y / 2.0 - y.powi(3) / 3.0 - energy).abs() < 1e-12));
    let highest = border.iter().map(|(_, py)| *py).fold(0.0, f64::max);
    assert!((highest - 0.5).abs() < 1e-3, "p_y reaches √(2E) = 0.5, not {highest}");
}

/// Fermi, Pasta, Ulam and Tsingou's 157 periods, with their step; fewer without its error. Zabusky's estimate for small
/// steps and long waves, `0.44 N^(3/2) / √α`, is 159.
#[test]
fn the_energy_of_the_chain_comes_back() {
    let chain = chain::Chain { alpha: chain::ALPHA };
    let found = |run: Run<chain::Sites>, interval: u64| {
        let (samples, energy_error) = chain::mode_shares::<3>(run, interval, 170.0, |_| true).expect("finite states");
        let (periods, share) = chain::recurrence(&samples).expect("samples");
        assert!(samples.iter().all(|(_, shares)| shares.iter().sum::<f64>() < 1.02), "more than all of the energy");
        (samples, (periods, share), energy_error)
    };
    let theirs = chain.run_with(VelocityVerlet, chain::start(), chain::THEIR_STEP).expect("a start");
    let (theirs, (periods, share), _) = found(theirs, 32);
    assert!((periods - 157.0).abs() < 1.0 && share > 0.97, "{share} after {periods} periods");
    let (samples, (periods, share), energy_error) = found(chain.run(chain::start(), 0.5).expect("a start"), 32);
    assert!((periods - 146.4).abs() < 0.5 && share > 0.98, "{share} after {periods} periods");
    assert!(energy_error < 1e-8, "the energy changes by {energy_error:e}");
    let theirs: Vec<_> = theirs.into_iter().map(|(time, [first, ..])| (time, [first])).collect();
    let picture = chain_picture::picture(&samples, &theirs, (periods, share));
    let text = drawn("chain", &picture, &["mode 3", "original step", "after 146", "share of the energy"]);
    // Each curve and its place in the legend; dashes are lines of their own.
    assert!(text.matches("<polyline").count() >= 6, "three modes");
    assert_eq!(chain::recurrence(&samples[..samples.len() / 2]), None, "no energy has come back by then");
}

#[test]
fn the_soliton_passes_around_the_ring() {
    let soliton = ring::Soliton { sites: 64, kappa: 1.0 };
    assert!((soliton.speed() - 1.0_f64.sinh()).abs() < 1e-15);
    let distance = |steps: u64, t: f64| {
        let start = soliton.state(0.0);
        let mut run = soliton.ring().run(Phase::compensated(start.q, start.p), t / steps as f64).expect("a start");
        run.advance(steps).expect("finite states");
        soliton.distance(&ring::values(&run.state()), run.time())
    };
    // The composition has order 6: half the step, 64 times as near.
    let [coarse, fine] = [128, 256].map(|steps| distance(steps, soliton.period())[0]);
    assert!(coarse < 1e-5 && (coarse / fine).log2() > 5.5, "{coarse:e}, {fine:e}");
    // In the middle of the second period, where the ring closes, positions agree as well.
    let [momenta, positions] = distance(768, 1.5 * soliton.period());
    assert!(momenta < 1e-9 && positions < 1e-9, "{momenta:e}, {positions:e}");
    let samples =
        [0.0, 0.5, 1.0].map(|periods| (periods * soliton.period(), soliton.state(periods * soliton.period())));
    let picture = ring_picture::picture(&soliton, &samples, &[(1.0, [coarse, coarse]), (1.5, [momenta, positions])]);
    let text = drawn("ring", &picture, &["Toda", "site", "after 2 periods", "distance"]);
    assert_eq!(
        text.matches("<circle").count(),
        3 * 64 + 2,
        "a dot for each site at each time, and the distances of momenta"
    );
}

/// The numbers are Mathieu's: where the characteristic curves `a₀(q)` and `b₁(-q)` meet the axis and one another.
#[test]
fn the_trap_confines_where_mathieu_predicts() {
    let edge = trap::edge().expect("finite states");
    // A step is off by (h·ω)⁴, here 1e-4, with the small factor of its composition.
    assert!((edge - 0.908_046_333_7).abs() < 1e-7, "{edge}");
    let near_the_tip = [(0.2365, 0.706), (0.2375, 0.706), (0.0, 0.3), (0.1, 0.3), (-0.1, 0.3), (0.0, 1.0)];
    let traps = near_the_tip.map(|(a, q)| trap::PaulTrap { a, q });
    let traces = trap::traces(traps).expect("finite states");
    let held: Vec<bool> = traces.iter().copied().map(trap::holds).collect();
    assert_eq!(held, [true, false, true, false, false, false]);
    let orbit = |name, trap| trap_picture::Orbit { name, trap, points: trap::orbit(trap, 20).expect("finite states") };
    let orbits = [orbit("Inside", traps[2]), orbit("Outside", traps[5])];
    let greatest = |which: usize| orbits[which].points.iter().map(|(_, x)| x.abs()).fold(0.0, f64::max);
    assert!(greatest(0) < 2.0 && greatest(1) > 1e3, "{} and {}", greatest(0), greatest(1));
    let all: Vec<_> = traps.into_iter().zip(traces).collect();
    let words = ["0.9080463", "Inside: a = 0, q = 0.3", "Outside: a = 0, q = 1", "alternating voltage"];
    drawn("trap", &trap_picture::picture(&all, &orbits, edge), &words);
}

#[test]
fn the_area_of_a_swarm_is_conserved_and_no_member_crosses_the_separatrix() {
    let (border, inside) = (4_000, 1_000);
    let starts: Vec<_> = swarm::disc(border, inside).collect();
    let mut pendulums =
        Ensemble::new(BlanesMoanSrkn6, starts.iter().map(|start| (swarm::Pendulum, *start)), 0.125).expect("starts");
    pendulums.advance(32).expect("finite states");
    let states: Vec<_> = pendulums.states().collect();
    let before = swarm::area(&starts[..border]);
    // A polygon of n corners in a circle has less than its area by a part of (2π/n)²/6, here 4e-7.
    assert!((before / (std::f64::consts::PI * swarm::RADIUS.powi(2)) - 1.0).abs() < 1e-6, "{before}");
    // The longest sides have grown by a factor of ten by then, and what they cut off by a hundred.
    let after = swarm::area(&states[..border]);
    assert!((after / before - 1.0).abs() < 4e-5, "{after} for {before}");
    let of_energy = |(a, b)| (swarm::energy(a) - swarm::energy(b)).abs();
    let change = starts.iter().zip(&states).map(of_energy).fold(0.0, f64::max);
    assert!(change < 1e-6, "{change:e}");
    assert_eq!(swarm::changed_sides(&starts, &states, change), 0);
    let over = starts.iter().filter(|start| swarm::energy(start) > swarm::SEPARATRIX).count();
    assert!(over > 1_500 && over < 3_500, "{over} of 5,000 turn over");
    assert!(states.iter().all(|state| swarm::wrapped(state.q[0]).abs() <= std::f64::consts::PI));
    let charts = vec![swarm_picture::chart(0.0, &starts, &starts), swarm_picture::chart(4.0, &starts, &states)];
    let words = ["t = 0", "t = 4", "angle", "momentum", "the area stays"];
    let text = drawn("swarm", &swarm_picture::picture(charts, "the area stays"), &words);
    assert_eq!(text.matches("<image").count(), 2, "the points of a time are one bitmap");
}

#[test]
fn argon_keeps_its_energy_and_its_neighbours() {
    let mut argon = liquid::Liquid::crystal(3, 94.4, &mut fastrand::Rng::with_seed(1964)).expect("a good start");
    let start = argon.state();
    assert_eq!(start.q.len(), 108);
    assert!((argon.temperature() - 94.4).abs() < 1e-9);
    for _ in 0..15 {
        argon.heat_to(94.4).expect("finite states");
        argon.advance(20).expect("finite states");
    }
    let (energy, mut samples, mut squares) = (argon.energy(), Vec::new(), Vec::new());
    let mut distances = liquid_observables::Distances::new(&argon.argon, 18.0, 80);
    for sample in 1..=10 {
        argon.advance(20).expect("finite states");
        let state = argon.state();
        distances.add(&state);
        // Verlet's error is a few 1e-4 of the depth of the well, 120 K, for the smooth energy that this is.
        let (change, square) = (argon.energy() - energy, liquid_observables::mean_square(&start, &state));
        assert!(change.abs() < 0.12, "the energy per atom changes by {change:e} K");
        let time = 20.0 * liquid::STEP * f64::from(sample);
        squares.push((time, square));
        samples.push(liquid_picture::Measurement { time, square, change, temperature: argon.temperature() });
    }
    let temperature = samples.iter().map(|sample| sample.temperature).sum::<f64>() / 10.0;
    // Fluctuations of 108 atoms: √(2/3N) of it, less what the potential takes, and some more while it settles.
    assert!((72.0..118.0).contains(&temperature), "{temperature}");
    let distribution = distances.distribution();
    let (place, height) = liquid_observables::peak(&distribution).expect("distances");
    assert!((3.5..3.9).contains(&place) && (2.3..3.6).contains(&height), "{height} at {place}");
    let diffusion = liquid_observables::diffusion(&squares);
    // A third of Rahman's 0.243 Å²/ps to three times it: there are few atoms and little time.
    assert!((0.08..0.73).contains(&diffusion), "{diffusion}");
    let momentum: f64 = argon.state().p.iter().flatten().sum();
    assert!(momentum.abs() < 1e-9, "{momentum:e}");
    let picture = liquid_picture::picture(&distribution, (place, height), diffusion, &samples);
    drawn(
        "liquid",
        &picture,
        &["Radial distribution function", "Mean square displacement", "distance r in Å", "Temperature"],
    );
}

/// Squares that grow by `6 D t` from wherever they begin.
#[test]
fn diffusion_is_a_sixth_of_a_slope() {
    let squares: Vec<_> = (0..9).map(|i| (f64::from(i), 0.7 + 6.0 * 0.25 * f64::from(i))).collect();
    assert!((liquid_observables::diffusion(&squares) - 0.25).abs() < 1e-14);
}

/// A pair across the border of the box feels its nearest image; force and energy end at the cutoff without a jump.
#[test]
fn argon_has_no_walls_and_no_jumps() {
    let argon = liquid::Argon { side: 20.4, cutoff: 8.5 };
    let pair = |apart: f64| argon.potential(&[[0.5, 1.0, 1.0], [0.5 + apart, 1.0, 1.0]]) / liquid::BOLTZMANN;
    for apart in [3.4, 3.8, 6.8, 8.49] {
        // Any number of boxes away, beyond one and a half as well.
        for image in [20.4 - apart, 20.4 + apart, 40.8 - apart, 204.0 + apart, apart - 204.0] {
            assert!((pair(apart) - pair(image)).abs() < 1e-7, "{apart}: {} and {}", pair(apart), pair(image));
        }
    }
    assert_eq!(pair(8.6), 0.0);
    // The second derivative is all that is left: about 0.5 · 0.5 K/Å² · (3e-3 Å)².
    assert!(pair(8.497).abs() < 1e-4, "{:e}", pair(8.497));
    assert!((pair(3.8) + 120.0).abs() < 12.0, "the depth of the well is about 120 K, not {}", pair(3.8));
}

/// Eight inner steps have a larger error at the same innermost step, but not by much: they save most of the time.
#[test]
fn the_cost_of_a_melt_is_drawn() {
    let (chains, start) = melt::crystal(6, 200);
    let (plain, nested) = (melt::Melt(chains.clone()), melt::NestedMelt(chains));
    let point = |cost: melt::Cost| (1e3 * cost.seconds, cost.error);
    let verlet = [2.5e-4, 5e-4].map(|h| point(melt::cost(&plain, Verlet, &start, h, 0.04).expect("finite states")));
    let eight =
        [2e-3, 4e-3].map(|h| point(melt::cost(&nested, Verlet.nested(8), &start, h, 0.04).expect("finite states")));
    for [(_, fine), (_, coarse)] in [verlet, eight] {
        // Both are of second order.
        assert!((2.0..8.0).contains(&(coarse / fine)), "{coarse} and {fine}");
    }
    let words =
        ["A polymer melt with stiff bonds", "eight inner steps take 2.5 times less time", "milliseconds on one core"];
    drawn("melt", &melt_picture::picture(verlet.to_vec(), eight.to_vec(), 2.5), &words);
}

/// Gravity resonates at a whole period of the spring, and the rubber band also at half of it.
#[test]
fn the_resonance_of_a_spring_is_drawn() {
    let curve = |band: f64| -> spring_picture::Curve {
        let pendulum = spring::Pendulum { frequency: 30.0, band };
        let error = |halves: f64| spring::error_at(&pendulum, 0.5, halves, 100.0).expect("finite states");
        [0.5, 0.995, 1.5, 2.0, 2.6].map(|halves| (halves, error(halves))).to_vec()
    };
    let [gravity, with_band] = [0.0, 4.0].map(curve);
    assert!(gravity[3].1 == spring::LARGEST && gravity[1].1 < gravity[2].1, "{gravity:?}");
    assert!(with_band[3].1 == spring::LARGEST && with_band[1].1 > 10.0 * with_band[2].1, "{with_band:?}");
    let words = ["Resonance of outer steps with a stiff spring", "gravity and rubber band", "gravity alone"];
    drawn("spring", &spring_picture::picture([gravity, with_band]), &words);
}

/// The period of the drive becomes two of them between the first two doublings, and four after that.
#[test]
fn doublings_of_a_period_are_drawn() {
    let values = |torque: f64| {
        let points = driven::diagram(&[torque], 300, 8).expect("finite states");
        let mut values: Vec<f64> = points.iter().map(|(_, p)| *p).collect();
        values.sort_by(f64::total_cmp);
        // After 300 periods the motion has settled to less than 1e-6, and branches are a thousand times as far apart.
        values.dedup_by(|a, b| (*a - *b).abs() < 1e-4);
        values.len()
    };
    assert_eq!([1.06, 1.075, 1.081].map(values), [1, 2, 4]);
    let diagram = driven::diagram(&[1.06, 1.07, 1.08], 200, 8).expect("finite states");
    let attractor = driven::section(1.5, 20, 100).expect("finite states");
    // The angular velocity has less than the torque of the drive and of gravity over the friction.
    assert!(attractor.iter().all(|(angle, p)| angle.abs() <= std::f64::consts::PI && p.abs() < 5.0));
    let picture = driven_picture::picture(&diagram, &[1.0664, 1.0793, 1.0821], 4.669, 1.5, &attractor);
    let words = ["Cascade of doublings", "Strange attractor at a torque of 1.5", "4.6690", "angular velocity"];
    let text = drawn("doublings", &picture, &words);
    assert_eq!(text.matches("<image").count(), 2, "the points of a panel are one bitmap");
}

/// All members end on one attractor, within the bound of the energy.
#[test]
fn the_attractor_of_duffing_is_drawn() {
    let points = duffing::section(duffing::Duffing { drive: 0.5 }, 100, 10, 5).expect("finite states");
    assert_eq!(points.len(), 500);
    assert!(points.iter().all(|(x, v)| x.abs() < 2.0 && v.abs() < 2.0));
    let words = ["Strange attractor", "A part of it", "exponent 0.107, dimension 1.26"];
    let text = drawn("duffing", &duffing_picture::picture(&points, 0.107, 1.263), &words);
    assert_eq!(text.matches("<image").count(), 2, "the points of a panel are one bitmap");
}

/// A chain of pinned sites is hotter at the hot bath, and a harmonic one has a curve in closed form.
#[test]
fn the_conduction_of_heat_is_drawn() {
    let springs = conductor::Chain { sites: 8, pinning: 0.0, rate: 1.0, baths: [1.5, 0.5] };
    let pinned = conductor::Chain { pinning: 1.0, ..springs };
    let [without, with] =
        [springs, pinned].map(|chain| conductor::stationary(chain, 16, 500, 200).expect("finite states"));
    let [first, last] = [&with.temperatures[0], &with.temperatures[7]];
    assert!(first.value - last.value > 4.0 * first.error.hypot(last.error), "{first:?} and {last:?}");
    let (current, temperatures) = conductor::harmonic(springs);
    assert!(without.current.value > 0.0 && current > 0.0);
    let words = ["Fourier's law", "harmonic, closed form", "with pinning", "place in the chain"];
    let text = drawn("conduction", &conduction_picture::picture(&without, &temperatures, &with), &words);
    assert_eq!(text.matches("<circle").count(), 2 * 8 + 2, "a dot for each site, and two in the legend");
}
