//! The examples that do real work, in short runs: each has a number that is known from elsewhere.

use integrator_core::prelude::*;

#[path = "../examples/fput_recurrence/chain.rs"]
mod chain;
#[path = "../examples/toda_soliton/ring.rs"]
mod ring;
#[path = "../examples/henon_heiles_section/section.rs"]
mod section;
#[path = "../examples/paul_trap/trap.rs"]
mod trap;

/// Below an energy of about 0.11 there is hardly an orbit that is not regular, and at the energy of escape hardly one that
/// is (Hénon and Heiles 1964).
#[test]
fn order_gives_way_to_chaos_in_the_galaxy() {
    let share = |energy: f64| {
        let orbits: Vec<_> = section::starts(energy, 5)
            .into_iter()
            .map(|start| section::orbit(energy, start, 150).expect("finite states"))
            .collect();
        assert!(orbits.len() > 12, "{} starts", orbits.len());
        assert!(orbits.iter().all(|orbit| orbit.energy_error < 1e-8 && orbit.points.len() == 151));
        orbits.iter().filter(|orbit| orbit.regular).count() as f64 / orbits.len() as f64
    };
    assert_eq!(share(1.0 / 12.0), 1.0);
    let at_escape = share(1.0 / 6.0);
    assert!(at_escape < 0.25, "{at_escape} of the section at the energy of escape");
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
        let (looks, energy_error) = chain::looks::<3>(run, interval, 170.0, |_| true).expect("finite states");
        let (periods, share) = chain::recurrence(&looks).expect("looks");
        assert!(looks.iter().all(|(_, shares)| shares.iter().sum::<f64>() < 1.02), "more than all of the energy");
        (periods, share, energy_error)
    };
    let theirs = chain.run_with(VelocityVerlet, chain::start(), chain::THEIR_STEP).expect("a start");
    let (periods, share, _) = found(theirs, 32);
    assert!((periods - 157.0).abs() < 1.0 && share > 0.97, "{share} after {periods} periods");
    let (periods, share, energy_error) = found(chain.run(chain::start(), 0.5).expect("a start"), 32);
    assert!((periods - 146.4).abs() < 0.5 && share > 0.98, "{share} after {periods} periods");
    assert!(energy_error < 1e-8, "the energy changes by {energy_error:e}");
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
    let [coarse, fine] = [128, 256].map(|steps| distance(steps, soliton.turn())[0]);
    assert!(coarse < 1e-5 && (coarse / fine).log2() > 5.5, "{coarse:e}, {fine:e}");
    // In the middle of the second turn, where the ring closes, positions agree as well.
    let [momenta, positions] = distance(768, 1.5 * soliton.turn());
    assert!(momenta < 1e-9 && positions < 1e-9, "{momenta:e}, {positions:e}");
}

/// The numbers are Mathieu's: where the characteristic curves `a₀(q)` and `b₁(-q)` meet the axis and one another.
#[test]
fn the_trap_holds_where_mathieu_says() {
    let edge = trap::edge().expect("finite states");
    // A step is off by (h·ω)⁴, here 1e-4, with the small factor of its composition.
    assert!((edge - 0.908_046_333_7).abs() < 1e-7, "{edge}");
    let near_the_tip = [(0.2365, 0.706), (0.2375, 0.706), (0.0, 0.3), (0.1, 0.3), (-0.1, 0.3), (0.0, 1.0)];
    let traces = trap::traces(near_the_tip.map(|(a, q)| trap::PaulTrap { a, q })).expect("finite states");
    let held: Vec<bool> = traces.into_iter().map(trap::holds).collect();
    assert_eq!(held, [true, false, true, false, false, false]);
}
