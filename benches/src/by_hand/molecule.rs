//! A molecule with lists of bonds, angles and dihedrals. A vector of terms is evaluated at a time: atoms are gathered,
//! and forces are scattered lane by lane.

use crate::{
    enter::{Kernel, enter},
    plan::{HandWritten, Plan},
    problems::molecule,
    vector::{Many, Row, Vector},
};
use std::marker::PhantomData;

/// Largest number of lanes of a vector.
const LANES: usize = 8;

/// Terms of `ATOMS` atoms and `NUMBERS` parameters each.
type Terms<const ATOMS: usize, const NUMBERS: usize> = (Vec<[u32; ATOMS]>, [Vec<f64>; NUMBERS]);

/// A molecule and its state.
#[derive(Clone)]
pub struct Molecule {
    bonds: Terms<2, 2>,
    angles: Terms<3, 1>,
    dihedrals: Terms<4, 1>,
    bending: f64,
    inverse_masses: Vec<f64>,
    q: Vec<[f64; 3]>,
    p: Vec<[f64; 3]>,
    forces: Vec<[f64; 3]>,
}

impl Molecule {
    /// Creates the molecule at a state.
    pub fn new(system: &molecule::Molecule, q: &[[f64; 3]], p: &[[f64; 3]]) -> Self {
        let lengths = system.bonds.iter().map(|bond| bond.2).collect();
        Self {
            bonds: (
                system.bonds.iter().map(|&(a, b, _)| [a as u32, b as u32]).collect(),
                [lengths, system.stiffness.clone()],
            ),
            angles: (
                system.angles.iter().map(|&(a, b, c, _)| [a as u32, b as u32, c as u32]).collect(),
                [system.angles.iter().map(|angle| angle.3).collect()],
            ),
            dihedrals: (
                system.dihedrals.iter().map(|&(a, b, c, d)| [a as u32, b as u32, c as u32, d as u32]).collect(),
                [system.barriers.clone()],
            ),
            bending: system.bending,
            inverse_masses: system.masses.iter().map(|mass| 1.0 / mass).collect(),
            q: q.to_vec(),
            p: p.to_vec(),
            forces: vec![[0.0; 3]; q.len()],
        }
    }

    /// Takes `steps` steps, and returns one coordinate.
    pub fn advance(&mut self, plan: &Plan, steps: u64) -> f64 {
        enter(March { molecule: self, plan, steps })
    }
}

struct March<'a> {
    molecule: &'a mut Molecule,
    plan: &'a Plan,
    steps: u64,
}

impl Kernel for March<'_> {
    type Out = f64;

    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) -> f64 {
        let mut flows = Flows::<V>(self.molecule, PhantomData);
        self.plan.march(&mut flows, self.steps);
        flows.0.q[0][0]
    }
}

struct Flows<'a, V>(&'a mut Molecule, PhantomData<V>);

impl<V: Vector<Number = f64>> HandWritten for Flows<'_, V> {
    #[inline(always)]
    fn drift(&mut self, t: f64) {
        let Molecule { q, p, inverse_masses, .. } = &mut *self.0;
        for ((q, p), inverse_mass) in q.iter_mut().zip(p).zip(inverse_masses) {
            let factor = t * *inverse_mass;
            for d in 0..3 {
                q[d] = factor.mul_add(p[d], q[d]);
            }
        }
    }

    #[inline(always)]
    fn kick(&mut self, t: f64) {
        let Molecule { bonds, angles, dihedrals, bending, q, p, forces, .. } = &mut *self.0;
        forces.fill([0.0; 3]);
        add::<V, Bond, 2, 2>(q, forces, bonds, Bond);
        add::<V, Angle, 3, 1>(q, forces, angles, Angle { bending: *bending });
        add::<V, Dihedral, 4, 1>(q, forces, dihedrals, Dihedral);
        for (p, force) in p.iter_mut().zip(forces) {
            for d in 0..3 {
                p[d] = t.mul_add(force[d], p[d]);
            }
        }
    }
}

/// Computes the forces of a vector of terms from the positions of their atoms and the parameters of the terms.
trait Force<const ATOMS: usize, const NUMBERS: usize>: Copy {
    fn of<V: Vector<Number = f64>>(self, atoms: [[V; 3]; ATOMS], numbers: [V; NUMBERS]) -> [[V; 3]; ATOMS];
}

/// Adds the forces of all terms: full vectors first, then the remaining terms one by one. There are no closures,
/// because closures are compiled without vector instructions.
#[inline(always)]
fn add<V: Vector<Number = f64>, F: Force<ATOMS, NUMBERS>, const ATOMS: usize, const NUMBERS: usize>(
    q: &[[f64; 3]],
    forces: &mut [[f64; 3]],
    terms: &Terms<ATOMS, NUMBERS>,
    force: F,
) {
    let first = add_from::<V, F, ATOMS, NUMBERS>(q, forces, terms, force, 0);
    add_from::<Many<f64, 1>, F, ATOMS, NUMBERS>(q, forces, terms, force, first);
}

/// Adds the forces of full vectors of terms, starting at a given term. Returns the first remaining term.
#[inline(always)]
fn add_from<V: Vector<Number = f64>, F: Force<ATOMS, NUMBERS>, const ATOMS: usize, const NUMBERS: usize>(
    q: &[[f64; 3]],
    forces: &mut [[f64; 3]],
    (atoms, numbers): &Terms<ATOMS, NUMBERS>,
    force: F,
    mut first: usize,
) -> usize {
    while first + V::LANES <= atoms.len() {
        let at = &atoms[first..first + V::LANES];
        let mut gathered = [[V::splat(0.0); 3]; ATOMS];
        for atom in 0..ATOMS {
            gathered[atom] = gather(q, at, atom);
        }
        let mut own = [V::splat(0.0); NUMBERS];
        for number in 0..NUMBERS {
            own[number] = V::load(&numbers[number][first..]);
        }
        scatter(forces, at, force.of(gathered, own));
        first += V::LANES;
    }
    first
}

/// Gathers the positions of one atom of each term.
#[inline(always)]
fn gather<V: Vector<Number = f64>, const ATOMS: usize>(q: &[[f64; 3]], at: &[[u32; ATOMS]], atom: usize) -> [V; 3] {
    let mut columns = [[0.0; LANES]; 3];
    for lane in 0..V::LANES {
        let point = q[at[lane][atom] as usize];
        for d in 0..3 {
            columns[d][lane] = point[d];
        }
    }
    [V::load(&columns[0]), V::load(&columns[1]), V::load(&columns[2])]
}

/// Scatters the forces to the atoms, term by term.
#[inline(always)]
fn scatter<V: Vector<Number = f64>, const ATOMS: usize>(
    forces: &mut [[f64; 3]],
    at: &[[u32; ATOMS]],
    added: [[V; 3]; ATOMS],
) {
    let mut columns = [[[0.0; LANES]; 3]; ATOMS];
    for atom in 0..ATOMS {
        for d in 0..3 {
            added[atom][d].store(&mut columns[atom][d]);
        }
    }
    for lane in 0..V::LANES {
        for atom in 0..ATOMS {
            let force = &mut forces[at[lane][atom] as usize];
            for d in 0..3 {
                force[d] += columns[atom][d][lane];
            }
        }
    }
}

#[inline(always)]
fn minus<V: Vector>(a: [V; 3], b: [V; 3]) -> [V; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn plus<V: Vector>(a: [V; 3], b: [V; 3]) -> [V; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
fn times<V: Vector>(factor: V, a: [V; 3]) -> [V; 3] {
    [factor * a[0], factor * a[1], factor * a[2]]
}

/// `x a - y b`
#[inline(always)]
fn difference<V: Vector>(x: V, a: [V; 3], y: V, b: [V; 3]) -> [V; 3] {
    let first = times(x, a);
    [y.fnma(b[0], first[0]), y.fnma(b[1], first[1]), y.fnma(b[2], first[2])]
}

#[inline(always)]
fn dot<V: Vector>(a: [V; 3], b: [V; 3]) -> V {
    a[2].fma(b[2], a[1].fma(b[1], a[0] * b[0]))
}

#[inline(always)]
fn cross<V: Vector>(a: [V; 3], b: [V; 3]) -> [V; 3] {
    [a[2].fnma(b[1], a[1] * b[2]), a[0].fnma(b[2], a[2] * b[0]), a[1].fnma(b[0], a[0] * b[1])]
}

#[derive(Clone, Copy)]
struct Bond;

impl Force<2, 2> for Bond {
    /// `-k (r - l) / r` along the bond.
    #[inline(always)]
    fn of<V: Vector<Number = f64>>(self, [a, b]: [[V; 3]; 2], [length, stiffness]: [V; 2]) -> [[V; 3]; 2] {
        let along = minus(b, a);
        let distance = dot(along, along).sqrt();
        let pull = times(stiffness * (distance - length) / distance, along);
        [pull, times(V::splat(-1.0), pull)]
    }
}

#[derive(Clone, Copy)]
struct Angle {
    bending: f64,
}

impl Force<3, 1> for Angle {
    /// Derivative of the cosine with respect to both arms.
    #[inline(always)]
    fn of<V: Vector<Number = f64>>(self, [a, b, c]: [[V; 3]; 3], [wanted]: [V; 1]) -> [[V; 3]; 3] {
        let (u, v) = (minus(a, b), minus(c, b));
        let (uu, vv) = (dot(u, u), dot(v, v));
        let inverse = V::splat(1.0) / (uu * vv);
        let root = inverse.sqrt();
        let cosine = dot(u, v) * root;
        let pull = V::splat(self.bending) * (wanted - cosine);
        let (both, own) = (pull * root, pull * cosine * inverse);
        let of_u = difference(both, v, own * vv, u);
        let of_v = difference(both, u, own * uu, v);
        [of_u, times(V::splat(-1.0), plus(of_u, of_v)), of_v]
    }
}

#[derive(Clone, Copy)]
struct Dihedral;

impl Force<4, 1> for Dihedral {
    /// Derivative of the cosine with respect to the normals of both planes, and from these to the three bonds.
    #[inline(always)]
    fn of<V: Vector<Number = f64>>(self, [a, b, c, d]: [[V; 3]; 4], [barrier]: [V; 1]) -> [[V; 3]; 4] {
        let (u, v, w) = (minus(b, a), minus(c, b), minus(d, c));
        let (m, n) = (cross(u, v), cross(v, w));
        let (mm, nn) = (dot(m, m), dot(n, n));
        let inverse = V::splat(1.0) / (mm * nn);
        let root = inverse.sqrt();
        let cosine = dot(m, n) * root;
        let pull = barrier * (cosine * cosine).fnma(V::splat(6.0), V::splat(1.5));
        let (both, own) = (pull * root, pull * cosine * inverse);
        let of_m = difference(both, n, own * nn, m);
        let of_n = difference(both, m, own * mm, n);
        let (of_u, of_w) = (cross(v, of_m), cross(of_n, v));
        let of_v = plus(cross(of_m, u), cross(w, of_n));
        [times(V::splat(-1.0), of_u), minus(of_u, of_v), minus(of_v, of_w), of_w]
    }
}
