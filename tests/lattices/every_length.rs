//! Flows in gather form, in blocks of neighbouring sites, against plain loops by hand, at every length.

use integrator_core::{Coords, prelude::*};

/// Springs with both anharmonic terms between fixed walls (Fermi, Pasta, Ulam and Tsingou 1955).
pub(crate) struct Walls;

#[hamiltonian]
impl Walls {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = self.spring(q[0]) + self.spring(-q[q.len() - 1]);
        for i in 0..q.len() - 1 {
            energy += self.spring(q[i + 1] - q[i]);
        }
        energy
    }
    fn spring(&self, stretch: f64) -> f64 {
        stretch.powi(2) / 2.0 + 0.25 * stretch.powi(3) + 0.1 * stretch.powi(4)
    }
}

/// The same with a number of sites that the type knows; 33 fill no block of any width but one.
struct FixedWalls<const N: usize>;

#[hamiltonian]
impl<const N: usize> FixedWalls<N> {
    fn kinetic(&self, p: [f64; N]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: [f64; N]) -> f64 {
        let mut energy = self.spring(q[0]) + self.spring(-q[N - 1]);
        for i in 0..N - 1 {
            energy += self.spring(q[i + 1] - q[i]);
        }
        energy
    }
    fn spring(&self, stretch: f64) -> f64 {
        stretch.powi(2) / 2.0 + 0.25 * stretch.powi(3) + 0.1 * stretch.powi(4)
    }
}

/// The same, where each site asks whether it is at an end.
struct Ends;

#[hamiltonian]
impl Ends {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            let behind = if i == 0 { 0.0 } else { q[i - 1] };
            energy += self.spring(q[i] - behind);
            if i + 1 >= q.len() {
                energy += self.spring(-q[i]);
            }
        }
        energy
    }
    fn spring(&self, stretch: f64) -> f64 {
        stretch.powi(2) / 2.0 + 0.25 * stretch.powi(3) + 0.1 * stretch.powi(4)
    }
}

/// The same, where each spring asks whether it is at an end.
struct BothEnds;

#[hamiltonian]
impl BothEnds {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let n = q.len();
        let mut energy = 0.0;
        for i in 0..=n {
            let left = if i == 0 { 0.0 } else { q[i - 1] };
            let right = if i == n { 0.0 } else { q[i] };
            energy += self.spring(right - left);
        }
        energy
    }
    fn spring(&self, stretch: f64) -> f64 {
        stretch.powi(2) / 2.0 + 0.25 * stretch.powi(3) + 0.1 * stretch.powi(4)
    }
}

/// The same, each spring with a strength of its own, which is one.
struct StrongEnds {
    strengths: Vec<f64>,
}

#[hamiltonian]
impl StrongEnds {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let n = q.len();
        let mut energy = 0.0;
        for i in 0..n {
            let behind = if i == 0 { 0.0 } else { q[i - 1] };
            energy += self.strengths[i] * self.spring(q[i] - behind);
            if i == n - 1 {
                energy += self.strengths[i] * self.spring(-q[i]);
            }
        }
        energy
    }
    fn spring(&self, stretch: f64) -> f64 {
        stretch.powi(2) / 2.0 + 0.25 * stretch.powi(3) + 0.1 * stretch.powi(4)
    }
}

/// A ring of unequal masses on unequal springs, each site in a well of its own.
pub(crate) struct Ring {
    mass: Vec<f64>,
    stiffness: Vec<f64>,
}

#[hamiltonian]
impl Ring {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().enumerate().map(|(i, p)| p.powi(2) / (2.0 * self.mass[i])).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let n = q.len();
        let mut energy = 0.0;
        for i in 0..n {
            let behind = q[(i + n - 1) % n];
            energy += self.stiffness[i] * ((q[i] - behind).cosh() - 1.0) + (1.0 + i as f64) * q[i].powi(4) / 40.0;
        }
        energy
    }
}

/// A line of springs, and one from the last site to the first, which makes it a ring.
struct Closed;

#[hamiltonian]
impl Closed {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let line: f64 = q.windows(2).map(|q| self.spring(q[1] - q[0])).sum();
        line + self.spring(q[0] - q[q.len() - 1])
    }
    fn spring(&self, stretch: f64) -> f64 {
        stretch.powi(2) / 2.0 + 0.25 * stretch.powi(3) + 0.1 * stretch.powi(4)
    }
}

/// Springs to the site before, numbered by that to which they lead, and to the second next; they tear.
pub(crate) struct Second {
    stiffness: Vec<f64>,
    torn: f64,
}

#[hamiltonian]
impl Second {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.5 * q[1].powi(2);
        for i in 1..q.len() {
            let stretch = q[i] - q[i - 1];
            if stretch < self.torn {
                energy += self.stiffness[i] * stretch.powi(2) / 2.0;
            }
        }
        for i in 0..q.len() - 2 {
            energy += (q[i + 2] - q[i] + 0.1 * q[i + 1]).powi(2) / 2.0;
        }
        energy
    }
}

fn spring_force(stretch: f64) -> f64 {
    stretch + 0.75 * stretch * stretch + 0.4 * stretch.powi(3)
}

/// The gradient of V of [`Walls`], with a wall before the first site and behind the last.
fn walls(q: &[f64]) -> Vec<f64> {
    let at = |i: usize| if i == 0 || i == q.len() + 1 { 0.0 } else { q[i - 1] };
    (1..=q.len()).map(|i| spring_force(at(i) - at(i - 1)) - spring_force(at(i + 1) - at(i))).collect()
}

/// The gradient of V of [`Closed`].
fn closed(q: &[f64]) -> Vec<f64> {
    let n = q.len();
    let force = |i: usize| spring_force(q[(i + 1) % n] - q[i % n]);
    (0..n).map(|i| force(i + n - 1) - force(i)).collect()
}

impl Ring {
    pub(crate) fn example(sites: usize) -> Self {
        let table = |scale: f64| (0..sites).map(|i| 1.0 + scale * (i as f64).sin()).collect();
        Self { mass: table(0.3), stiffness: table(0.5) }
    }
    fn gradient(&self, q: &[f64]) -> Vec<f64> {
        let n = q.len();
        let bond = |i: usize| self.stiffness[i % n] * (q[i % n] - q[(i + n - 1) % n]).sinh();
        (0..n).map(|i| bond(i) - bond(i + 1) + (1.0 + i as f64) * q[i].powi(3) / 10.0).collect()
    }
}

impl Second {
    pub(crate) fn example(sites: usize) -> Self {
        Self { stiffness: (0..sites).map(|i| 1.0 + 0.1 * i as f64).collect(), torn: 0.4 }
    }
    fn gradient(&self, q: &[f64]) -> Vec<f64> {
        let mut gradient = vec![0.0; q.len()];
        gradient[1] += q[1];
        for i in 1..q.len() {
            let stretch = q[i] - q[i - 1];
            if stretch < self.torn {
                gradient[i] += self.stiffness[i] * stretch;
                gradient[i - 1] -= self.stiffness[i] * stretch;
            }
        }
        for i in 2..q.len() {
            let bend = q[i] - q[i - 2] + 0.1 * q[i - 1];
            gradient[i] += bend;
            gradient[i - 1] += 0.1 * bend;
            gradient[i - 2] -= bend;
        }
        gradient
    }
}

/// A state in which no two sites are alike.
pub(crate) fn start(sites: usize) -> Phase<Vec<f64>> {
    let wave = |speed: f64| (0..sites).map(|i| 0.4 * (speed * i as f64 + 0.3).sin()).collect();
    Phase::new(wave(0.7), wave(1.3))
}

const STEP: f64 = 0.01;
const STEPS: u64 = 40;

/// Verlet by hand.
fn by_hand(start: &Phase<Vec<f64>>, mass: &[f64], gradient: impl Fn(&[f64]) -> Vec<f64>) -> Phase<Vec<f64>> {
    let Phase { mut q, mut p } = start.clone();
    for _ in 0..STEPS {
        for i in 0..q.len() {
            q[i] += 0.5 * STEP * p[i] / mass[i];
        }
        let gradient = gradient(&q);
        for i in 0..q.len() {
            p[i] -= STEP * gradient[i];
            q[i] += 0.5 * STEP * p[i] / mass[i];
        }
    }
    Phase::new(q, p)
}

/// Forty steps round each of a dozen operations on numbers of at most 20, and stretch what they leave behind by e at
/// most in a time of 0.4: less than 40 · 12 · 20 · e · 1.1e-16 = 3e-12.
fn agree<C: Coords<Leaf = f64>>(name: &str, sites: usize, state: &Phase<C>, expected: &Phase<Vec<f64>>) {
    for (computed, expected) in [(&state.q, &expected.q), (&state.p, &expected.p)] {
        for (i, (a, b)) in computed.flat().iter().zip(expected).enumerate() {
            assert!((a - b).abs() < 3e-12, "{name} with {sites} sites: {a} for {b} at {i}");
        }
    }
}

fn followed<H: Hamiltonian<Coords = Vec<f64>>>(system: &H, start: Phase<Vec<f64>>) -> Phase<Vec<f64>> {
    let mut run = system.run_with(Verlet, start, STEP).expect("a start");
    run.advance(STEPS).expect("finite states");
    run.state()
}

/// Every length around the widths of blocks, 2, 4, 8 and 16, and a longer one.
fn lengths(fewest: usize) -> impl Iterator<Item = usize> {
    (fewest..20).chain([31, 32, 33, 34, 100])
}

#[test]
fn walls_at_every_length() {
    // The energy of no sites is an index out of bounds in the function itself, which every start evaluates.
    for sites in lengths(1) {
        let expected = by_hand(&start(sites), &vec![1.0; sites], walls);
        agree("walls", sites, &followed(&Walls, start(sites)), &expected);
        agree("ends", sites, &followed(&Ends, start(sites)), &expected);
        agree("both ends", sites, &followed(&BothEnds, start(sites)), &expected);
        let strong = StrongEnds { strengths: vec![1.0; sites] };
        agree("ends with strengths", sites, &followed(&strong, start(sites)), &expected);
    }
}

#[test]
fn rings_at_every_length() {
    for sites in lengths(0) {
        let ring = Ring::example(sites);
        let expected = by_hand(&start(sites), &ring.mass, |q| ring.gradient(q));
        agree("ring", sites, &followed(&ring, start(sites)), &expected);
    }
    for sites in lengths(1) {
        let expected = by_hand(&start(sites), &vec![1.0; sites], closed);
        agree("closed line", sites, &followed(&Closed, start(sites)), &expected);
    }
}

#[test]
fn second_neighbours_at_every_length() {
    for sites in lengths(2) {
        let second = Second::example(sites);
        let expected = by_hand(&start(sites), &vec![1.0; sites], |q| second.gradient(q));
        agree("second neighbours", sites, &followed(&second, start(sites)), &expected);
    }
}

fn fixed<const N: usize>() {
    let Phase { q, p } = start(N);
    let array = |values: &[f64]| <[f64; N]>::try_from(values).expect("as many");
    let mut run = FixedWalls::<N>.run(Phase::new(array(&q), array(&p)), STEP).expect("a start");
    run.advance(STEPS).expect("finite states");
    let state = run.state();
    let same = followed(&Walls, start(N));
    assert_eq!((&state.q[..], &state.p[..]), (&same.q[..], &same.p[..]), "{N} sites, known when compiling or not");
}

#[test]
fn a_length_known_when_compiling_changes_no_bit() {
    fixed::<1>();
    fixed::<2>();
    fixed::<7>();
    fixed::<8>();
    fixed::<32>();
    fixed::<33>();
}

/// A run computes neighbouring sites side by side, an ensemble members: no bit tells.
fn member_for_member<H: Hamiltonian<Coords = Vec<f64>> + Send + Sync>(of: impl Fn(usize) -> H, fewest: usize) {
    for sites in lengths(fewest) {
        let members = (0..9).map(|_| (of(sites), start(sites)));
        let mut together = Ensemble::new(Yoshida4, members, STEP).expect("starts");
        together.advance(STEPS).expect("finite states");
        let mut alone = of(sites).run_with(Yoshida4, start(sites), STEP).expect("a start");
        alone.advance(STEPS).expect("finite states");
        for member in 0..9 {
            assert_eq!(together.state(member), Some(alone.state()), "member {member} with {sites} sites");
        }
    }
}

#[test]
fn blocks_and_lanes_have_the_same_bits() {
    member_for_member(|_| Walls, 1);
    member_for_member(Ring::example, 1);
    member_for_member(|_| Closed, 1);
    member_for_member(Second::example, 2);
}

/// A compensated chain whose number of sites its type knows, alone, in portions and in lanes, against one of a length that is
/// known when it runs.
fn compensated_sites<const N: usize, X>(composition: X)
where
    X: Composition<FixedWalls<N>> + Composition<Walls>,
{
    let Phase { q, p } = start(N);
    let at_run_time = Phase::compensated(q.clone(), p.clone());
    let array = |values: Vec<f64>| <[f64; N]>::try_from(values).expect("as many sites");
    let known = Phase::compensated(array(q), array(p));
    let mut run = Walls.run_with(composition, at_run_time, STEP).expect("a start");
    run.advance(STEPS).expect("finite states");
    let Phase { q, p } = run.state();

    let alone = |portions: [u64; 3]| {
        let mut run = FixedWalls::<N>.run_with(composition, known, STEP).expect("a start");
        portions.into_iter().for_each(|portion| run.advance(portion).expect("finite states"));
        run.state()
    };
    let whole = alone([STEPS, 0, 0]);
    assert_eq!((whole.q.to_vec(), whole.p.to_vec()), (q, p), "{}, {N} sites", X::NAME);
    assert_eq!(alone([1, 2, STEPS - 3]), whole, "{}, {N} sites in portions", X::NAME);
    let mut together = Ensemble::new(composition, (0..9).map(|_| (FixedWalls::<N>, known)), STEP).expect("an ensemble");
    together.advance(STEPS).expect("finite states");
    assert_eq!(together.state(8), Some(whole), "{}, {N} sites in lanes", X::NAME);
}

#[test]
fn compensated_sites_have_the_same_bits_in_blocks_and_lanes() {
    compensated_sites::<1, _>(Verlet);
    compensated_sites::<7, _>(KahanLi8);
    compensated_sites::<32, _>(KahanLi8);
    compensated_sites::<33, _>(Yoshida4);
    compensated_sites::<33, _>(Chin4A);
    compensated_sites::<130, _>(Verlet);
}

#[test]
fn every_precision_has_lattices() {
    for sites in lengths(1) {
        let exact = followed(&Walls, start(sites));
        let Phase { q, p } = start(sites);
        let mut compensated = Walls.run(Phase::compensated(q.clone(), p.clone()), STEP).expect("a start");
        compensated.advance(STEPS).expect("finite states");
        let Phase { q: exact_q, .. } = &exact;
        for (a, b) in compensated.state().q.iter().zip(exact_q) {
            assert!((a.value - b).abs() < 3e-12, "compensated, {sites} sites: {a:?} for {b}");
        }
        let single = |values: &[f64]| values.iter().map(|x| *x as f32).collect::<Vec<_>>();
        let mut singles = Walls.run(Phase::new(single(&q), single(&p)), STEP).expect("a start");
        singles.advance(STEPS).expect("finite states");
        // As above, with the rounding of a single precision number, 6e-8.
        for (a, b) in singles.state().q.iter().zip(exact_q) {
            assert!((f64::from(*a) - b).abs() < 40.0 * 12.0 * 20.0 * 2.8 * 6e-8, "singles, {sites} sites: {a} for {b}");
        }
    }
}
