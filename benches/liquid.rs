//! Benchmarks liquid argon in a periodic box, from a thousand atoms on: `cargo bench -p integrator-bench --bench liquid`.
//!
//! The generated stepper recognises the cutoff. It is compared with hand-written neighbour lists for AVX-512. Times are per
//! atom and step, lists included; rates count the pairs within the cutoff at this density. The last lines are times divided by
//! those of the hand-written lists in the same rounds (`ratio_<scene>_to_hand=`), and the gain from a second thread. `--large`
//! adds a million atoms. The picture shows the times against the number of atoms, and `docs/performance.md` the results.

#[cfg(target_arch = "x86_64")]
use integrator_bench::by_hand::liquid::Liquid;
use integrator_bench::{
    problems::ArgonInBox,
    race::{Racer, race},
    starts::{DENSITY, liquid},
    table::{Table, folder},
};
use integrator_core::prelude::*;
use integrator_plot::{Axis, Chart};
use std::{error::Error, f64::consts::PI};

/// Number of rounds; odd, so that the median is the time of one round.
const ROUNDS: usize = 7;
const STEP: f64 = 0.004;
/// Number of pairs within the cutoff, per atom.
const PAIRS: f64 = 0.5 * DENSITY * 4.0 / 3.0 * PI * ArgonInBox::CUTOFF * ArgonInBox::CUTOFF * ArgonInBox::CUTOFF;

fn main() -> Result<(), Box<dyn Error>> {
    let head = ["scene", "unit", "generated", "by hand", "to hand", "2 threads", "pairs/s"];
    let (mut table, mut lines) = (Table::new("liquid", &head), Vec::new());
    let large = std::env::args().any(|argument| argument == "--large");
    let scenes = [
        ("argon_1372", 7),
        ("argon_4000", 10),
        ("argon_10976", 14),
        ("argon_32000", 20),
        ("argon_87808", 28),
        ("argon_256000", 40),
        ("argon_1000188", 63),
    ];
    let (mut generated, mut written) = (Vec::new(), Vec::new());
    for (name, cells) in scenes.into_iter().take(if large { 7 } else { 6 }) {
        let (system, start) = liquid(cells);
        let atoms = start.q.len();
        let steps = (1_000_000 / atoms as u64).max(15);
        let mut run = system.run_with(Verlet, start, STEP)?.with_threads(1);
        // Lets the crystal melt a little.
        run.advance(100)?;
        let [mut one, mut two] = [run.clone(), run.clone().with_threads(2)];
        #[cfg(target_arch = "x86_64")]
        let state = run.state();
        let mut ours = run;
        #[cfg(target_arch = "x86_64")]
        let mut by_hand = Liquid::new(&state.q, &state.p, system.side, ArgonInBox::CUTOFF);
        let mut racers = vec![
            Racer::new("one thread", || one.advance(steps).expect("finite states")).in_threads(),
            Racer::new("two threads", || two.advance(steps).expect("finite states")).in_threads(),
            Racer::new("generated", || ours.advance(steps).expect("finite states")),
        ];
        #[cfg(target_arch = "x86_64")]
        if let Some(by_hand) = &mut by_hand {
            racers.push(Racer::new("by hand", || by_hand.advance(steps, STEP)));
        }
        let times = race(ROUNDS, (atoms as u64 * steps) as f64, racers);
        let has_hand = times.names().len() > 3;
        let [hand, ratio] = if has_hand { [times.median(3), times.ratio(2, 3)] } else { [f64::NAN; 2] };
        let [ns, threads] = [times.median(2), times.ratio(0, 1)];
        table.row([name, "ns/atom/step"], &[ns, hand, ratio, threads, PAIRS / ns * 1e9]);
        generated.push((atoms as f64, ns));
        written.push((atoms as f64, hand));
        lines.push(format!("ratio_{name}_to_hand={ratio:.3}"));
        lines.push(format!("speedup_{name}_two_threads={threads:.3}"));
    }
    table.write()?;
    written.retain(|(_, ns)| ns.is_finite());
    let chart = Chart::new("Liquid argon with a cutoff of 2.5 σ")
        .claim("The time per atom and step grows slowly with the number of atoms")
        .along(Axis::logarithmic("atoms"))
        .up(Axis::linear("ns per atom and step").between(0.0, 200.0))
        .with_names_at_ends();
    chart.line("generated", generated).line("hand-written", written).dashed().save(folder().join("liquid.svg"))?;
    lines.iter().for_each(|line| println!("{line}"));
    Ok(())
}
