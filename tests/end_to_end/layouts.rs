//! What a run says of the layouts of its flows.

use integrator_core::prelude::*;

struct Liquid {
    cutoff: f64,
}

#[hamiltonian(layout = lists)]
impl Liquid {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let square: f64 = (0..3).map(|k| (q[i][k] - q[j][k]).powi(2)).sum();
                if square < self.cutoff.powi(2) {
                    energy += (self.cutoff.powi(2) - square).powi(3);
                }
            }
        }
        energy
    }
}

/// The first bodies act on each other; their coordinates are flat.
struct First {
    n: usize,
}

#[hamiltonian(layout = lists)]
impl First {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..self.n {
            for j in 0..i {
                let square: f64 = (0..2).map(|k| (q[2 * i + k] - q[2 * j + k]).powi(2)).sum();
                if square < 4.0 {
                    energy += (4.0 - square).powi(3);
                }
            }
        }
        energy
    }
}

struct Coupled;

#[hamiltonian(split = oscillator + pairs + motion, layout = pairs)]
impl Coupled {
    fn oscillator(&self, q: &[f64], p: &[f64]) -> f64 {
        (0..q.len()).map(|i| p[i] * p[i] + q[i] * q[i]).sum()
    }
    fn pairs(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                energy += (q[i] - q[j]).cos();
            }
        }
        energy
    }
    fn motion(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.1 * p * p).sum()
    }
}

fn points(count: usize) -> Phase<Vec<[f64; 3]>> {
    let place = |i: usize| [i % 8, i / 8 % 8, i / 64].map(|k| k as f64);
    Phase::new((0..count).map(place).collect(), vec![[0.0; 3]; count])
}

#[test]
fn lists_are_used_from_384_bodies_on() -> Result<(), Error> {
    for (count, is_listed) in [(2, false), (383, false), (384, true), (600, true)] {
        let layout = Liquid { cutoff: 1.5 }.run(points(count), 0.01)?.layout();
        assert_eq!((layout.drift(), layout.kick(), layout.is_listed()), ("pairs", "lists", is_listed), "{count}");
        let few = if is_listed { "" } else { " (too few bodies: pairs)" };
        assert_eq!(layout.to_string(), format!("kinetic: pairs, potential: lists{few}"));
    }
    // The bodies that act count, not the numbers of the state.
    for (n, is_listed) in [(383, false), (384, true)] {
        let start = Phase::new((0..2000).map(f64::from).collect::<Vec<_>>(), vec![0.0; 2000]);
        assert_eq!(First { n }.run(start, 0.01)?.layout().is_listed(), is_listed, "{n}");
    }
    Ok(())
}

#[test]
fn members_and_parts_have_layouts() -> Result<(), Error> {
    for (counts, is_listed) in [([400, 500], true), ([400, 300], false)] {
        let members = counts.map(|count| (Liquid { cutoff: 1.5 }, points(count)));
        let ensemble = Ensemble::new(Verlet, members, 0.01)?;
        let layout = ensemble.run_of(0).expect("a member").layout();
        assert_eq!((layout.kick(), layout.is_listed()), ("lists", is_listed));
    }
    let layout = Coupled.run(Phase::new(vec![0.1; 100], vec![0.0; 100]), 0.01)?.layout();
    assert_eq!(layout.to_string(), "oscillator: plain, pairs: pairs, motion: plain");
    assert_eq!((layout.drift(), layout.kick(), layout.is_listed()), ("plain", "plain", false));
    let parts: Vec<_> = layout.parts().collect();
    assert_eq!(parts, [("oscillator", "plain"), ("pairs", "pairs"), ("motion", "plain")]);
    Ok(())
}
