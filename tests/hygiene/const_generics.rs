//! A system whose size is a parameter of its type.

use integrator_core::prelude::*;

/// `N` masses, each on a spring of its own.
pub struct Springs<const N: usize> {
    /// Stiffness of every spring.
    pub stiffness: f64,
    /// Every mass.
    pub mass: [f64; N],
}

#[hamiltonian(compose = V(1/2) T(1) V(1/2))]
impl<const N: usize> Springs<N> {
    fn kinetic(&self, p: &[f64; N]) -> f64 {
        let mut sum = 0.0;
        for i in 0..N {
            sum += p[i] * p[i] / (2.0 * self.mass[i]);
        }
        sum
    }
    fn potential(&self, q: &[f64; N]) -> f64 {
        let mut sum = 0.0;
        for i in 0..N {
            sum += self.stiffness * q[i] * q[i] / 2.0;
        }
        sum
    }
}

/// A chain of `N` masses, held at one end.
pub struct Chain<const N: usize> {
    /// Stiffness of every spring.
    pub stiffness: f64,
    /// Every mass.
    pub mass: [f64; N],
}

#[hamiltonian(compose = V(1/2) T(1) V(1/2))]
impl<const N: usize> Chain<N> {
    fn kinetic(&self, p: &[f64; N]) -> f64 {
        let mut sum = 0.0;
        for i in 0..N {
            sum += p[i] * p[i] / (2.0 * self.mass[i]);
        }
        sum
    }
    fn potential(&self, q: &[f64; N]) -> f64 {
        let mut sum = self.stiffness * q[0] * q[0] / 2.0;
        for i in 1..N {
            let stretch = q[i] - q[i - 1];
            sum += self.stiffness * stretch * stretch / 2.0;
        }
        sum
    }
}

/// Points in `D` dimensions on springs; bounds stand in a `where` clause.
pub struct Points<const D: usize, S>
where
    S: Stiffness,
{
    /// Where the stiffness comes from.
    pub spring: S,
}

/// What knows a stiffness.
pub trait Stiffness: 'static {
    /// The stiffness.
    fn stiffness(&self) -> f64;
}

#[hamiltonian]
impl<const D: usize, S> Points<D, S>
where
    S: Stiffness,
{
    fn kinetic(&self, p: &[[f64; D]; 2]) -> f64 {
        let mut sum = 0.0;
        for i in 0..2 {
            for d in 0..D {
                sum += p[i][d] * p[i][d] / 2.0;
            }
        }
        sum
    }
    fn potential(&self, q: &[[f64; D]; 2]) -> f64 {
        let mut sum = 0.0;
        for d in 0..D {
            let distance = q[1][d] - q[0][d];
            sum += self.spring.stiffness() * distance * distance / 2.0;
        }
        sum
    }
}

impl Stiffness for f64 {
    fn stiffness(&self) -> f64 {
        *self
    }
}

#[test]
fn one_impl_serves_every_size() {
    fn assert_runs<const N: usize>() {
        let springs = Springs { stiffness: 2.0, mass: ::std::array::from_fn(|i| 1.0 + i as f64) };
        let mut run = springs.run(Phase::new([1.0; N], [0.0; N]), 1e-3).expect("an admissible start");
        run.advance(1000).expect("finite");
        for (i, q) in run.state().q.into_iter().enumerate() {
            let frequency = (2.0 / (1.0 + i as f64)).sqrt();
            // A time of order one, by a method of order 2.
            assert!((q - frequency.cos()).abs() < 1e-4, "{run:?}");
        }
    }
    assert_runs::<1>();
    assert_runs::<5>();
}

#[test]
fn neighbours_are_coupled_in_every_size() {
    fn end<const N: usize>() -> f64 {
        let chain = Chain { stiffness: 4.0, mass: [1.0; N] };
        let mut run = chain.run(Phase::new([1.0; N], [0.0; N]), 1e-3).expect("an admissible start");
        run.advance(1000).expect("finite");
        run.state().q[0]
    }
    // Eigenvalues 4 and 2(3 ± sqrt(5)) of the stiffness matrices, with the part that the start has of each.
    let root = 5.0_f64.sqrt();
    let mode = |sign: f64| (5.0 - sign * root) / 10.0 * (6.0 + 2.0 * sign * root).sqrt().cos();
    // A time of order one, by a method of order 2.
    assert!((end::<1>() - 2.0_f64.cos()).abs() < 1e-4);
    assert!((end::<2>() - mode(1.0) - mode(-1.0)).abs() < 1e-4);
}

#[test]
fn two_points_swing_about_each_other() {
    let points = Points::<3, f64> { spring: 2.0 };
    let start = Phase::new([[0.0; 3], [1.0, 2.0, 3.0]], [[0.0; 3]; 2]);
    let mut run = points.run(start, 1e-3).expect("an admissible start");
    run.advance(1000).expect("finite");
    // The distance swings with ω² = 2·2.
    let distance = run.state().q[1][2] - run.state().q[0][2];
    assert!((distance - 3.0 * 2.0_f64.cos()).abs() < 1e-4, "{run:?}");
}
