//! Steps by a table are those of the composition to the last bit, however they are looked at.

use crate::{
    composition::{Composition, catalogue::*},
    error::Error,
    hamiltonian,
    hamiltonian::Hamiltonian,
    state::{compensated::Compensated, coords::Coords, phase::Phase, precision::Precision},
    trajectory::{
        by_table::{ByTable, Kicks, Plain, WithGradients},
        run::Run,
    },
};

/// Pushed for a while, at times that steps of a quarter meet.
struct Pushed;

#[hamiltonian]
impl Pushed {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2], t: f64) -> f64 {
        let push = if t < 1.0 { 0.3 } else { 0.7 };
        -q[0].cos() + q[1].powi(4) / 4.0 - push * q[0] * q[1]
    }
}

struct Coupled;

#[hamiltonian]
impl Coupled {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -q[0].cos() + q[1].powi(4) / 4.0 - 0.3 * q[0] * q[1]
    }
}

struct ThreeParts;

#[hamiltonian(split = first + shear + last)]
impl ThreeParts {
    fn first(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn shear(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        q[0].sin() * p[1]
    }
    fn last(&self, q: [f64; 2]) -> f64 {
        -q[0].cos() + q[1].powi(4) / 4.0
    }
}

/// Parts that read the time, the last two of which are one or not.
macro_rules! driven {
    ($name:ident: $($split:tt)*) => {
        struct $name;

        #[hamiltonian(split = $($split)*)]
        impl $name {
            fn first(&self, p: [f64; 2]) -> f64 {
                (p[0] * p[0] + p[1] * p[1]) / 2.0
            }
            fn shear(&self, q: [f64; 2], p: [f64; 2], t: f64) -> f64 {
                t.cos() * q[0].sin() * p[1]
            }
            fn last(&self, q: [f64; 2], t: f64) -> f64 {
                -(q[0] - t).cos() + q[1].powi(4) / 4.0
            }
        }
    };
}

driven!(Driven: first + shear + last);
driven!(Paired: first + (shear + last));

/// States after some steps, with a look in between.
fn looked_at<K: Precision>(run: Result<Run<[K; 2]>, Error>) -> [Phase<[K; 2]>; 3] {
    let mut run = run.expect("a start");
    [1, 4, 3].map(|steps| {
        run.advance(steps).expect("finite states");
        run.state()
    })
}

fn start<K>(leaf: fn(f64) -> K) -> Phase<[K; 2]> {
    Phase { q: [1.0, 0.5].map(leaf), p: [0.3, -0.2].map(leaf) }
}

fn agrees<G: Kicks<H>, H: Hamiltonian, X: Composition<H>, K: Precision>(system: &H, composition: X, leaf: fn(f64) -> K)
where
    H::Coords: Coords<With<K> = [K; 2]>,
{
    let found = looked_at(system.run_with::<K, ByTable<G>>(ByTable::of(composition), start(leaf), 0.25));
    let expected = looked_at(system.run_with::<K, X>(composition, start(leaf), 0.25));
    // Debug output has every digit, the carried ones too.
    assert_eq!(format!("{found:?}"), format!("{expected:?}"), "{}", X::NAME);
}

fn compensated(number: f64) -> Compensated<f64> {
    Compensated { value: number, carried: 0.0 }
}

fn plain(number: f64) -> f64 {
    number
}

#[test]
fn each_kind_of_composition_takes_the_same_steps() {
    // Nothing merges; a drift leads; a kick leads; a processor; force gradients; both.
    agrees::<Plain, _, _, _>(&Coupled, Euler, plain);
    agrees::<Plain, _, _, _>(&Coupled, Verlet, plain);
    agrees::<Plain, _, _, _>(&Coupled, VelocityVerlet, plain);
    agrees::<Plain, _, _, _>(&Coupled, BlanesCasasMurua6S11, plain);
    agrees::<WithGradients, _, _, _>(&Coupled, Chin4A, plain);
    agrees::<WithGradients, _, _, _>(&Coupled, TakahashiImada4, plain);
}

#[test]
fn compensated_steps_have_the_same_corrections() {
    agrees::<Plain, _, _, _>(&Coupled, Yoshida4, compensated);
    agrees::<WithGradients, _, _, _>(&Coupled, Chin4A, compensated);
    agrees::<Plain, _, _, _>(&Pushed, Yoshida4, compensated);
    agrees::<Plain, _, _, _>(&ThreeParts, Yoshida4, compensated);
}

#[test]
fn pieces_in_time_and_parts_in_between_take_the_same_steps() {
    agrees::<Plain, _, _, _>(&Pushed, Yoshida4, plain);
    agrees::<Plain, _, _, _>(&Pushed, VelocityVerlet, plain);
    agrees::<Plain, _, _, _>(&Pushed, BlanesCasasMurua6S11, plain);
    agrees::<Plain, _, _, _>(&ThreeParts, Euler, plain);
    agrees::<Plain, _, _, _>(&ThreeParts, VelocityVerlet, plain);
    agrees::<Plain, _, _, _>(&ThreeParts, KahanLi6, plain);
    agrees::<Plain, _, _, _>(&Driven, VelocityYoshida4, plain);
    agrees::<Plain, _, _, _>(&Driven, Yoshida4, compensated);
}

#[test]
fn kicks_of_pairs_take_the_same_steps() {
    agrees::<Plain, _, _, _>(&Paired, Euler, plain);
    agrees::<Plain, _, _, _>(&Paired, Abah844, plain);
    agrees::<Plain, _, _, _>(&Paired, Abah844, compensated);
    agrees::<Plain, _, _, _>(&Paired, BlanesCasasMurua6S11, plain);
}

#[test]
fn gradients_are_part_of_the_table() {
    let run = |name| looked_at(Coupled.run_with::<f64, ByTable<WithGradients>>(name, start(plain), 0.25));
    assert_ne!(run(ByTable::of(Chin4A)), run(ByTable::of(Chin4B)));
    assert_ne!(run(ByTable::of(Verlet)), run(ByTable::of(TakahashiImada4)));
}
