//! Quadratic forms in positions and momenta, sparse, and the blocks of degrees of freedom that they couple.

use crate::{
    flow::exponential::exponential_less_one,
    scalar::{double_double::DoubleDouble, real::Real},
};
use alloc::{collections::BTreeMap, vec, vec::Vec};

/// `½ zᵀ S z + bᵀ z`, where `z` is positions and momenta: the entries of `S` and of `b` that are there.
///
/// Coordinates have an even number where they are positions, the next one for their momentum.
#[derive(Clone, Debug, PartialEq)]
pub struct Form {
    /// The number of components of a point.
    components: usize,
    second: BTreeMap<[usize; 2], f64>,
    first: BTreeMap<usize, f64>,
}

/// Derivatives are added at the indices of coordinates: those of a number, or those of a point and of its component.
impl Form {
    /// One without any term.
    pub(super) fn new(components: usize) -> Self {
        Self { components, second: BTreeMap::new(), first: BTreeMap::new() }
    }

    /// The second derivative by two positions; its mirror image comes by itself.
    pub fn qq<const D: usize>(&mut self, i: [usize; D], j: [usize; D], value: f64) {
        self.symmetric(2 * self.degree(i), 2 * self.degree(j), value);
    }
    /// The second derivative by two momenta; its mirror image comes by itself.
    pub fn pp<const D: usize>(&mut self, i: [usize; D], j: [usize; D], value: f64) {
        self.symmetric(2 * self.degree(i) + 1, 2 * self.degree(j) + 1, value);
    }
    /// The second derivative by a position and a momentum, in both orders.
    pub fn qp<const D: usize>(&mut self, i: [usize; D], j: [usize; D], value: f64) {
        let [a, b] = [2 * self.degree(i), 2 * self.degree(j) + 1];
        self.add(a, b, value);
        self.add(b, a, value);
    }
    /// The derivative by a position where all coordinates are zero.
    pub fn q<const D: usize>(&mut self, i: [usize; D], value: f64) {
        *self.first.entry(2 * self.degree(i)).or_default() += value;
    }
    /// The derivative by a momentum where all coordinates are zero.
    pub fn p<const D: usize>(&mut self, i: [usize; D], value: f64) {
        *self.first.entry(2 * self.degree(i) + 1).or_default() += value;
    }

    /// Returns the index of the degree of freedom of a component of a point.
    fn degree<const D: usize>(&self, indices: [usize; D]) -> usize {
        indices.iter().fold(0, |degree, index| degree * self.components + index)
    }
    /// Half of it at each of both places, so that both have the same bits in the end.
    fn symmetric(&mut self, a: usize, b: usize, value: f64) {
        self.add(a, b, 0.5 * value);
        self.add(b, a, 0.5 * value);
    }
    fn add(&mut self, a: usize, b: usize, value: f64) {
        *self.second.entry([a, b]).or_default() += value;
    }

    /// The pairs of degrees of freedom that it couples, those with themselves that it moves.
    fn couplings(&self) -> impl Iterator<Item = [usize; 2]> {
        let second = self.second.iter().filter(|(_, value)| **value != 0.0).map(|(place, _)| place.map(|z| z / 2));
        let first = self.first.iter().filter(|(_, value)| **value != 0.0).map(|(z, _)| [z / 2; 2]);
        second.chain(first)
    }
}

/// The form of one member on the degrees of freedom of a block: positions first, then momenta.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Dense {
    /// The number of degrees of freedom.
    pub(super) size: usize,
    pub(super) second: Vec<f64>,
    pub(super) first: Vec<f64>,
}

/// Blocks with equal forms, for all members.
#[derive(Clone, Debug)]
pub(super) struct Group {
    /// The number of degrees of freedom of a block.
    pub(super) size: usize,
    /// Whether there are linear terms.
    pub(super) is_affine: bool,
    /// The degrees of freedom of all blocks, one block after the other.
    pub(super) places: Vec<usize>,
    /// The form of each member.
    pub(super) of_members: Vec<Dense>,
}

/// The blocks of these members' forms, those with equal forms together.
pub(super) fn groups(members: &[Form]) -> Vec<Group> {
    let blocks = components(members.iter().flat_map(Form::couplings));
    let mut place = BTreeMap::new();
    for (block, own) in blocks.iter().enumerate() {
        place.extend(own.iter().enumerate().map(|(k, degree)| (*degree, (block, k))));
    }
    let empty = |own: &Vec<usize>| {
        let size = own.len();
        vec![Dense { size, second: vec![0.0; 4 * size * size], first: vec![0.0; 2 * size] }; members.len()]
    };
    let mut dense: Vec<Vec<Dense>> = blocks.iter().map(empty).collect();
    for (member, form) in members.iter().enumerate() {
        let at = |z: usize, k: usize, size: usize| if z.is_multiple_of(2) { k } else { size + k };
        for ([a, b], value) in &form.second {
            if let (Some((block, j)), Some((other, k))) = (place.get(&(a / 2)), place.get(&(b / 2)))
                && block == other
            {
                let own = &mut dense[*block][member];
                let (row, column) = (at(*a, *j, own.size), at(*b, *k, own.size));
                own.second[row * 2 * own.size + column] = *value;
            }
        }
        for (z, value) in &form.first {
            if let Some((block, k)) = place.get(&(z / 2)) {
                let own = &mut dense[*block][member];
                own.first[at(*z, *k, own.size)] = *value;
            }
        }
    }
    let mut known: BTreeMap<Vec<u64>, usize> = BTreeMap::new();
    let mut groups: Vec<Group> = Vec::new();
    for (places, of_members) in blocks.into_iter().zip(dense) {
        let numbers = of_members.iter().flat_map(|own| own.second.iter().chain(&own.first));
        let group = *known.entry(numbers.map(|number| number.to_bits()).collect()).or_insert(groups.len());
        if group == groups.len() {
            let is_affine = of_members.iter().any(|own| own.first.iter().any(|slope| *slope != 0.0));
            groups.push(Group { size: places.len(), is_affine, places: Vec::new(), of_members });
        }
        groups[group].places.extend(places);
    }
    groups
}

/// The connected components of what is coupled, each in rising order.
fn components(couplings: impl Iterator<Item = [usize; 2]>) -> Vec<Vec<usize>> {
    let mut parents: BTreeMap<usize, usize> = BTreeMap::new();
    fn root(parents: &mut BTreeMap<usize, usize>, mut degree: usize) -> usize {
        while let Some(parent) = parents.get(&degree).copied().filter(|parent| *parent != degree) {
            let above = parents.get(&parent).copied().unwrap_or(parent);
            parents.insert(degree, above);
            degree = above;
        }
        parents.insert(degree, degree);
        degree
    }
    for [a, b] in couplings {
        let (a, b) = (root(&mut parents, a), root(&mut parents, b));
        parents.insert(a.max(b), a.min(b));
    }
    let mut found: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    let degrees: Vec<usize> = parents.keys().copied().collect();
    for degree in degrees {
        found.entry(root(&mut parents, degree)).or_default().push(degree);
    }
    found.into_values().collect()
}

impl Dense {
    /// Returns the increments of positions and momenta by a flow of this duration: a matrix with a column for constant
    /// increments, row by row.
    ///
    /// Degrees of freedom that do not couple in this member are exponentiated separately, so that a member is bitwise
    /// identical to its run alone, even in a block that couples in other members.
    pub(super) fn increments(&self, duration: f64) -> Vec<DoubleDouble> {
        let Self { size, second, first } = self;
        let width = 2 * size;
        let degrees = (0..*size).flat_map(|j| (0..*size).map(move |k| [j, k]));
        let couples = |[j, k]: &[usize; 2]| {
            let halves = [(*j, *k), (*j, k + size), (j + size, *k), (j + size, k + size)];
            halves.iter().any(|(a, b)| second[a * width + b] != 0.0) || j == k
        };
        let mut increments = vec![DoubleDouble::of(0.0); width * (width + 1)];
        for own in components(degrees.filter(couples)) {
            let rows: Vec<usize> = own.iter().copied().chain(own.iter().map(|k| k + size)).collect();
            let is_affine = rows.iter().any(|z| first[*z] != 0.0);
            let order = rows.len() + usize::from(is_affine);
            let mut generator = vec![DoubleDouble::of(0.0); order * order];
            for (row, z) in rows.iter().enumerate() {
                // Positions follow the derivative by momenta, momenta go against that by positions.
                let (partner, duration) = if z < size { (z + size, duration) } else { (z - size, -duration) };
                let duration = DoubleDouble::of(duration);
                for (column, other) in rows.iter().enumerate() {
                    generator[row * order + column] = duration * DoubleDouble::of(second[partner * width + other]);
                }
                if is_affine {
                    generator[row * order + rows.len()] = duration * DoubleDouble::of(first[partner]);
                }
            }
            let powers = exponential_less_one(order, generator);
            for (row, z) in rows.iter().enumerate() {
                for (column, other) in rows.iter().chain(is_affine.then_some(&width)).enumerate() {
                    increments[z * (width + 1) + other] = powers[row * order + column];
                }
            }
        }
        increments
    }
}
