//! Lines of sites that fill vectors: several vectors at once beside the loops of lists, and members in lanes beside runs.

use crate::runs::FINE;
use integrator_core::{Coords, Ensemble, prelude::*, taylor::Taylor};

/// The number of sites: three vectors.
const SITES: usize = 24;

/// Where a site begins: neighbours are far apart.
fn site(i: usize) -> f64 {
    (i * 29 % 37) as f64 / 64.0 - 0.25
}

/// All digits of the coordinates.
fn bits<C: Coords<Leaf = f64>>(state: &Phase<C>) -> Vec<u64> {
    [&state.q, &state.p].into_iter().flat_map(|part| part.flat()).map(|x| x.to_bits()).collect()
}

/// Declares lines of 24 sites and lists of as many, with tests that hold them against each other. Each row is a name, the
/// names of the state, the energies, and by how many roundings coordinates of order one may differ at the end.
macro_rules! lines {
    ($($name:ident($self:ident, $q:ident, $p:ident) { $($kinetic:tt)* } { $($potential:tt)* } $roundings:expr;)*) => {$(
        mod $name {
            use super::*;

            #[derive(Clone, Copy)]
            struct Line { masses: [f64; SITES] }

            #[hamiltonian(taylor)]
            #[allow(unused_variables, clippy::needless_range_loop, reason = "a row reads what it needs, in the language of H")]
            impl Line {
                fn kinetic(&$self, $p: [f64; 24]) -> f64 { $($kinetic)* }
                fn potential(&$self, $q: [f64; 24]) -> f64 { $($potential)* }
            }

            #[allow(dead_code, reason = "a row reads what it needs")]
            struct List { masses: [f64; SITES] }

            #[hamiltonian(taylor)]
            #[allow(unused_variables, clippy::needless_range_loop, reason = "a row reads what it needs, in the language of H")]
            impl List {
                fn kinetic(&$self, $p: &[f64]) -> f64 { $($kinetic)* }
                fn potential(&$self, $q: &[f64]) -> f64 { $($potential)* }
            }

            fn line(member: usize) -> Line {
                Line { masses: std::array::from_fn(|i| 1.0 + (i + member) as f64 / 16.0) }
            }

            fn start(member: usize) -> Phase<[f64; SITES]> {
                Phase::new(std::array::from_fn(|i| site(i + member)), std::array::from_fn(|i| site(2 * i + member)))
            }

            #[test]
            fn a_line_is_the_list() {
                let (system, begin) = (line(0), start(0));
                let mut run = system.run_with(Taylor::tolerance(FINE), begin.clone(), 0.25).expect("a start");
                let list = List { masses: system.masses };
                let begin = Phase::new(begin.q.to_vec(), begin.p.to_vec());
                let mut other = list.run_with(Taylor::tolerance(FINE), begin, 0.25).expect("a start");
                run.advance(4).expect("finite states");
                other.advance(4).expect("finite states");
                let (state, other) = (run.state(), other.state());
                if $roundings == 0.0 {
                    assert_eq!(bits(&state), bits(&other));
                }
                let pairs = [(&state.q, &other.q), (&state.p, &other.p)];
                for (i, (a, b)) in pairs.into_iter().flat_map(|(a, b)| a.iter().zip(b)).enumerate() {
                    assert!((a - b).abs() <= $roundings * f64::EPSILON, "{i}: {a:e} and {b:e}");
                }
            }

            #[test]
            fn a_member_is_as_if_alone() {
                let members = (0..11).map(|member| (line(member), start(member)));
                let mut swarm = Ensemble::new(Taylor::tolerance(FINE), members, 0.125).expect("an ensemble");
                swarm.advance(3).expect("finite states");
                for (member, state) in swarm.states().enumerate() {
                    let alone = line(member).run_with(Taylor::tolerance(FINE), start(member), 0.125);
                    let mut alone = alone.expect("a start");
                    alone.advance(3).expect("finite states");
                    assert_eq!(bits(&state), bits(&alone.state()), "member {member}");
                }
            }
        }
    )*};
}

lines! {
    // A site gets two addends, whose sum does not depend on their order.
    between_walls(self, q, p)
        { let mut t = 0.0; for i in 0..p.len() { t += p[i] * p[i] / (2.0 * self.masses[i]); } t }
        {
            let bond = |r: f64| r * r / 2.0 + r.powi(3) / 12.0;
            let mut v = bond(q[0]) + bond(-q[q.len() - 1]);
            for i in 0..q.len() - 1 {
                v += bond(q[i + 1] - q[i]);
            }
            v
        } 0.0;
    with_ends(self, q, p)
        { let mut t = 0.0; for i in 0..p.len() { t += p[i] * p[i] / 2.0; } t }
        { let mut v = 0.0; for i in 1..q.len() { v += (q[i] - q[i - 1]).exp(); } v } 0.0;
    from_a_wall(self, q, p)
        { let mut t = 0.0; for i in 0..p.len() { t += p[i] * p[i] / 2.0; } t }
        { let mut v = q[0].cosh(); for i in 1..q.len() { v += (q[i] - q[i - 1]).cosh(); } v } 0.0;
    ring(self, q, p)
        { let mut t = 0.0; for i in 0..p.len() { t += p[i] * p[i] / (2.0 * self.masses[i]); } t }
        { let mut v = 0.0; for i in 0..q.len() { v += (q[(i + 1) % q.len()] - q[i]).powi(4) / 4.0; } v } 0.0;
    // Here it gets three, whose roundings grow with the distance of neighbouring motions, by e² at most.
    // What a branch adds is an addend of its own in a list.
    with_stops(self, q, p)
        { let mut t = 0.0; for i in 0..p.len() { t += p[i] * p[i] / 2.0; } t }
        {
            let mut v = 0.0;
            for i in 1..q.len() {
                let r = q[i] - q[i - 1];
                v += r * r / 2.0 + if r < 0.0 { r.powi(4) } else { 0.0 };
            }
            v
        } 64.0;
    sine_gordon(self, q, p)
        { let mut t = 0.0; for i in 0..p.len() { t += p[i] * p[i] / (2.0 * self.masses[i]); } t }
        {
            let mut v = 0.0;
            for i in 0..q.len() {
                v += (q[(i + 1) % q.len()] - q[i]).powi(2) / 2.0 - q[i].cos();
            }
            v
        } 64.0;
    phi_to_the_fourth(self, q, p)
        { let mut t = 0.0; for i in 0..p.len() { t += p[i] * p[i] / 2.0; } t }
        {
            let mut v = 0.0;
            for i in 0..q.len() {
                v += q[i].powi(4) / 4.0 - q[i] * q[i] / 2.0;
            }
            for i in 1..q.len() {
                v += (q[i] - q[i - 1]).powi(2) / 2.0;
            }
            v
        } 64.0;
}
