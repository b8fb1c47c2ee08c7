//! Pairs among the first bodies of a system, whose number is a parameter, and pairs of bodies with flat coordinates: both have
//! the bits of pairs among as many points.

use integrator_core::{System, prelude::*};
use std::any::type_name;

/// No multiples of the lanes; lists of neighbours are made of the first of them.
const ACTING: usize = 397;
const ALL: usize = 411;
const STEP: f64 = 0.01;
const STEPS: u64 = 20;

#[derive(Clone)]
struct Liquid {
    /// How many bodies act, as a number and as the length of lists.
    acting: usize,
    charges: Vec<f64>,
    types: Vec<usize>,
    molecules: Vec<usize>,
    reaches: Vec<[f64; 2]>,
    cutoff: f64,
    softening: f64,
}

fn liquid(acting: usize) -> Liquid {
    Liquid {
        acting,
        charges: (0..acting).map(|i| 1.0 + 0.5 * (1.3 * i as f64).sin()).collect(),
        types: (0..acting).map(|i| i * 5 % 7 % 2).collect(),
        molecules: (0..acting).map(|i| i / 3).collect(),
        reaches: vec![[0.8, 1.1], [1.1, 1.4]],
        cutoff: 2.2,
        softening: 0.3,
    }
}

fn points(bodies: usize) -> Phase<Vec<[f64; 3]>> {
    let site = |i: usize| [i % 8, i / 8 % 8, i / 64].map(|site| 1.1 * site as f64);
    let spread = |i: usize, d: usize, size: f64| size * ((7 * i + 3 * d) as f64).sin();
    let q = (0..bodies).map(|i| [0, 1, 2].map(|d| site(i)[d] + spread(i, d, 0.2))).collect();
    Phase::new(q, (0..bodies).map(|i| [0, 1, 2].map(|d| spread(i, d + 1, 0.1))).collect())
}

fn flat(points: &Phase<Vec<[f64; 3]>>) -> Phase<Vec<f64>> {
    Phase::new(points.q.concat(), points.p.concat())
}

fn first(points: &Phase<Vec<[f64; 3]>>, bodies: usize) -> Phase<Vec<[f64; 3]>> {
    Phase::new(points.q[..bodies].to_vec(), points.p[..bodies].to_vec())
}

macro_rules! system {
    ($name:ident, $coordinates:ty, |$self:ident, $p:ident| $kinetic:expr, |$q:ident| $potential:expr $(, $($helper:tt)*)?) => {
        #[derive(Clone)]
        struct $name(Liquid);

        #[hamiltonian]
        impl $name {
            fn kinetic(&$self, $p: $coordinates) -> f64 {
                $kinetic
            }
            fn potential(&$self, $q: $coordinates) -> f64 {
                $potential
            }
            $($($helper)*)?
        }
    };
}

macro_rules! liquid {
    ($($system:tt)*) => {
        system! {
            $($system)*,
        /// The energy of a pair with the square `r2` of the distance.
        fn of_pair(&self, i: usize, j: usize, r2: f64) -> f64 {
            let square = self.0.cutoff * self.0.cutoff;
            if r2 < square && self.0.molecules[i] != self.0.molecules[j] {
                let reach = self.0.reaches[self.0.types[i]][self.0.types[j]];
                reach * self.0.charges[i] * self.0.charges[j] * (square - r2).powi(3)
            } else {
                0.0
            }
        }
        }
    };
}

liquid!(Points, &[[f64; 3]], |self, p| p.iter().flatten().map(|p| 0.5 * p * p).sum(), |q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for j in 0..i {
            let r2: f64 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum();
            v += self.of_pair(i, j, r2);
        }
    }
    v
});
liquid!(FirstPoints, &[[f64; 3]], |self, p| p.iter().flatten().map(|p| 0.5 * p * p).sum(), |q| {
    let mut v = 0.0;
    for i in 0..self.0.acting {
        for j in 0..i {
            let r2: f64 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum();
            v += self.of_pair(i, j, r2);
        }
    }
    v
});
liquid!(Flat, &[f64], |self, p| p.iter().map(|p| 0.5 * p * p).sum(), |q| {
    let mut v = 0.0;
    for i in 0..q.len() / 3 {
        for j in 0..i {
            let r2: f64 = (0..3).map(|d| (q[3 * i + d] - q[3 * j + d]).powi(2)).sum();
            v += self.of_pair(i, j, r2);
        }
    }
    v
});
// The numbers of bodies and of lists are one number here.
liquid!(
    FirstFlat,
    &[f64],
    |self, p| {
        let mut t = 0.0;
        for i in 0..self.0.charges.len() {
            t += 0.5 * (p[3 * i] * p[3 * i] + p[3 * i + 1] * p[3 * i + 1] + p[3 * i + 2] * p[3 * i + 2]);
        }
        t
    },
    |q| {
        let mut v = 0.0;
        for i in 0..self.0.charges.len() {
            for j in 0..i {
                let r2: f64 = (0..3).map(|d| (q[3 * i + d] - q[3 * j + d]).powi(2)).sum();
                v += self.of_pair(i, j, r2);
            }
        }
        v
    }
);
system!(Gravity, &[[f64; 3]], |self, p| p.iter().flatten().map(|p| 0.5 * p * p).sum(), |q| {
    let mut v = 0.0;
    for i in 0..q.len() {
        for j in i + 1..q.len() {
            let r2: f64 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum();
            v -= self.0.charges[i] * self.0.charges[j] / (r2 + self.0.softening).sqrt();
        }
    }
    v
});
// Zipped with a list, which may be shorter; the last body has no partner after it.
system!(
    FlatGravity,
    &[f64],
    |self, p| p
        .chunks_exact(3)
        .zip(&self.0.charges)
        .map(|(p, _)| 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]))
        .sum(),
    |q| {
        let n = self.0.charges.len();
        let mut v = 0.0;
        for i in 0..n - 1 {
            for j in i + 1..n {
                let r2: f64 = (0..3).map(|d| (q[3 * i + d] - q[3 * j + d]).powi(2)).sum();
                v -= self.0.charges[i] * self.0.charges[j] / (r2 + self.0.softening).sqrt();
            }
        }
        v
    }
);

// Masses of the first bodies alone, in T and in V.
system!(
    Heavy,
    &[[f64; 3]],
    |self, p| {
        let mut t = 0.0;
        for i in 0..p.len() {
            t += p[i].iter().map(|p| p * p).sum::<f64>() / (2.0 * self.0.charges[i]);
        }
        t
    },
    |q| {
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let r2: f64 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum();
                v -= self.0.charges[i] * self.0.charges[j] / (r2 + self.0.softening).sqrt();
            }
        }
        v
    }
);
system!(
    FirstHeavy,
    &[[f64; 3]],
    |self, p| {
        let mut t = 0.0;
        for i in 0..self.0.charges.len() {
            t += p[i].iter().map(|p| p * p).sum::<f64>() / (2.0 * self.0.charges[i]);
        }
        t
    },
    |q| {
        let mut v = 0.0;
        for i in 0..self.0.charges.len() {
            for j in 0..i {
                let r2: f64 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum();
                v -= self.0.charges[i] * self.0.charges[j] / (r2 + self.0.softening).sqrt();
            }
        }
        v
    }
);

system!(
    FlatHeavy,
    &[f64],
    |self, p| {
        let mut t = 0.0;
        for k in 0..p.len() {
            t += p[k] * p[k] / (2.0 * self.0.charges[k / 3]);
        }
        t
    },
    |q| {
        let mut v = 0.0;
        for i in 0..q.len() / 3 {
            for j in 0..i {
                let r2: f64 = (0..3).map(|d| (q[3 * i + d] - q[3 * j + d]).powi(2)).sum();
                v -= self.0.charges[i] * self.0.charges[j] / (r2 + self.0.softening).sqrt();
            }
        }
        v
    }
);

/// What sums of as many terms as there are pairs differ by in another order.
const ROUNDING: f64 = (ALL * ALL) as f64 * f64::EPSILON;

fn is_near(energy: f64, expected: f64) {
    assert!((energy - expected).abs() <= ROUNDING * expected.abs(), "{energy} for {expected}");
}

#[test]
fn flat_coordinates_have_the_bits_of_points() -> Result<(), Error> {
    assert!(type_name::<<Flat as System>::Motion<f64, f64>>().contains("ManyRows"));
    let start = points(ACTING);
    let mut expected = Points(liquid(ACTING)).run_with(Verlet, start.clone(), STEP)?;
    let mut found = Flat(liquid(ACTING)).run_with(Verlet, flat(&start), STEP)?;
    is_near(found.energy(), expected.energy());
    expected.advance(STEPS)?;
    found.advance(STEPS)?;
    assert_eq!(found.state(), flat(&expected.state()));
    is_near(found.energy(), expected.energy());
    // With rounding errors that are carried along.
    let Phase { q, p } = flat(&start);
    let mut found = Flat(liquid(ACTING)).run_with(Verlet, Phase::compensated(q, p), STEP)?;
    let mut expected = Points(liquid(ACTING)).run_with(Verlet, Phase::compensated(start.q, start.p), STEP)?;
    found.advance(STEPS)?;
    expected.advance(STEPS)?;
    assert_eq!(found.state().q, expected.state().q.concat());
    assert_eq!(found.state().p, expected.state().p.concat());
    Ok(())
}

#[test]
fn bodies_after_the_first_ones_drift_freely() -> Result<(), Error> {
    assert!(type_name::<<FirstPoints as System>::Motion<f64, f64>>().contains("ManyRows"));
    let start = points(ALL);
    let mut expected = Points(liquid(ACTING)).run_with(Verlet, first(&start, ACTING), STEP)?;
    let mut found = FirstPoints(liquid(ACTING)).run_with(Verlet, start.clone(), STEP)?;
    expected.advance(STEPS)?;
    found.advance(STEPS)?;
    let state = found.state();
    assert_eq!(first(&state, ACTING), expected.state());
    assert_eq!(state.p[ACTING..], start.p[ACTING..]);
    let time = STEP * STEPS as f64;
    for body in ACTING..ALL {
        for d in 0..3 {
            // One rounding for each drift.
            let drifted = start.q[body][d] + time * start.p[body][d];
            let rounding = (STEPS + 2) as f64 * f64::EPSILON * drifted.abs().max(1.0);
            assert!((state.q[body][d] - drifted).abs() <= rounding, "{} for {drifted}", state.q[body][d]);
        }
    }
    // All of them act.
    let start = first(&start, ACTING);
    let mut all = FirstPoints(liquid(ACTING)).run_with(Verlet, start, STEP)?;
    all.advance(STEPS)?;
    assert_eq!(all.state(), expected.state());
    Ok(())
}

#[test]
fn bodies_after_those_of_the_kinetic_energy_stay() -> Result<(), Error> {
    assert!(type_name::<<FirstFlat as System>::Motion<f64, f64>>().contains("ManyRows"));
    let start = points(ALL);
    let mut expected = Points(liquid(ACTING)).run_with(Verlet, first(&start, ACTING), STEP)?;
    let mut found = FirstFlat(liquid(ACTING)).run_with(Verlet, flat(&start), STEP)?;
    is_near(found.energy(), expected.energy());
    expected.advance(STEPS)?;
    found.advance(STEPS)?;
    let (state, before) = (found.state(), flat(&start));
    assert_eq!(state.q[..3 * ACTING], expected.state().q.concat());
    assert_eq!(state.q[3 * ACTING..], before.q[3 * ACTING..]);
    assert_eq!(state.p[3 * ACTING..], before.p[3 * ACTING..]);
    Ok(())
}

#[test]
fn lists_that_end_before_the_bodies_do_end_the_pairs() -> Result<(), Error> {
    assert!(type_name::<<FlatGravity as System>::Motion<f64, f64>>().contains("ManyRows"));
    for (acting, all) in [(45, 45), (45, 50), (3, 40), (40, 41)] {
        let start = points(all);
        let mut expected = Gravity(liquid(acting)).run_with(Verlet, first(&start, acting), STEP)?;
        let mut found = FlatGravity(liquid(acting)).run_with(Verlet, flat(&start), STEP)?;
        is_near(found.energy(), expected.energy());
        expected.advance(STEPS)?;
        found.advance(STEPS)?;
        // One of them has the loop over components, which adds squares in another order.
        let (found, expected) = (found.state().q, expected.state().q.concat());
        let largest = expected.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        for (x, expected) in found.iter().zip(&expected) {
            assert!((x - expected).abs() <= ROUNDING * largest, "{x} for {expected}");
        }
        assert_eq!(found[3 * acting..], start.q.concat()[3 * acting..]);
    }
    Ok(())
}

#[test]
fn masses_of_the_first_bodies_are_enough() -> Result<(), Error> {
    assert!(type_name::<<FirstHeavy as System>::Motion<f64, f64>>().contains("ManyRows"));
    for (acting, all) in [(40, 40), (40, 45), (1, 3), (0, 2)] {
        let start = points(all);
        let mut found = FirstHeavy(liquid(acting)).run_with(Verlet, start.clone(), STEP)?;
        found.advance(STEPS)?;
        let state = found.state();
        if acting > 0 {
            let mut expected = Heavy(liquid(acting)).run_with(Verlet, first(&start, acting), STEP)?;
            expected.advance(STEPS)?;
            is_near(found.energy(), expected.energy());
            assert_eq!(first(&state, acting), expected.state());
        }
        assert_eq!(state.q[acting..], start.q[acting..]);
        assert_eq!(state.p[acting..], start.p[acting..]);
    }
    Ok(())
}

#[test]
fn a_number_may_be_that_of_the_coordinate_over_three() -> Result<(), Error> {
    assert!(type_name::<<FlatHeavy as System>::Motion<f64, f64>>().contains("ManyRows"));
    let start = points(45);
    let mut expected = Heavy(liquid(45)).run_with(Verlet, start.clone(), STEP)?;
    let mut found = FlatHeavy(liquid(45)).run_with(Verlet, flat(&start), STEP)?;
    is_near(found.energy(), expected.energy());
    expected.advance(STEPS)?;
    found.advance(STEPS)?;
    for (q, expected) in found.state().q.iter().zip(expected.state().q.as_flattened()) {
        assert!((q - expected).abs() <= ROUNDING * expected.abs().max(1.0), "{q} for {expected}");
    }
    Ok(())
}

#[test]
fn members_have_numbers_of_bodies_of_their_own() -> Result<(), Error> {
    let start = points(45);
    let member = |acting: usize| (FirstPoints(liquid(acting)), start.clone());
    let counts = [40, 45, 40, 0, 1, 40, 45, 45, 40, 40, 40, 40];
    let mut ensemble = Ensemble::new(Verlet, counts.map(member), STEP)?;
    ensemble.advance(STEPS)?;
    for (number, acting) in counts.into_iter().enumerate() {
        let (system, start) = member(acting);
        let mut alone = system.run_with(Verlet, start, STEP)?;
        alone.advance(STEPS)?;
        assert_eq!(ensemble.state(number), Some(alone.state()), "{acting}");
    }
    Ok(())
}

#[test]
fn starts_without_all_bodies_are_refused() {
    let start = flat(&points(ACTING));
    let longer = |by: usize| {
        let more = |part: &[f64]| part.iter().copied().chain(vec![0.5; by]).collect::<Vec<_>>();
        Phase::new(more(&start.q), more(&start.p))
    };
    let refused = |system: Flat, by| system.run_with(Verlet, longer(by), STEP).err();
    let partial = |length| Some(Error::PartialPoint { components: 3, length });
    assert_eq!(refused(Flat(liquid(ACTING + 1)), 1), partial(3 * ACTING + 1));
    assert_eq!(refused(Flat(liquid(ACTING + 1)), 2), partial(3 * ACTING + 2));
    assert_eq!(refused(Flat(liquid(ACTING + 1)), 3), None);
    let few = |least, length| Some(Error::FewCoordinates { least, length });
    let found = FirstPoints(liquid(ACTING)).run_with(Verlet, points(ACTING - 1), STEP).err();
    assert_eq!(found, few(ACTING, ACTING - 1));
    let found = FirstFlat(liquid(ACTING)).run_with(Verlet, flat(&points(ACTING - 1)), STEP).err();
    assert_eq!(found, few(3 * ACTING, 3 * (ACTING - 1)));
}
