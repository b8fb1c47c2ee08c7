//! Loops in lanes: innermost loops of systems whose number of coordinates is known at run time move them as the formulas say,
//! for every number of iterations, and members of ensembles move as single runs.

use integrator_core::{System, prelude::*};

/// More iterations than two rounds of all partial sums.
const MOST: usize = 40;

/// A power of two, so that the momentum after a step from rest is a multiple of the gradient without another rounding.
const STEP: f64 = 0.5;

/// Numbers of a system. All are numbers of `f32`, so that runs in single precision have the same ones.
#[derive(Clone)]
struct Numbers {
    table: Vec<Vec<f64>>,
    weights: Vec<f64>,
    strength: f64,
}

impl Numbers {
    fn new(count: usize, seed: usize) -> Self {
        let row = |i: usize| (0..count).map(|j| wave(31 * i + j + seed)).collect();
        Self {
            table: (0..count.max(5)).map(row).collect(),
            weights: (0..count).map(|i| 1.25 + wave(7 * i + seed)).collect(),
            strength: 0.75 + 0.25 * wave(seed),
        }
    }
}

fn wave(number: usize) -> f64 {
    f64::from((1.3 * number as f64 + 0.4).sin() as f32)
}

/// A component of a gradient: its value, and the sum of the absolute values of all that is added up in it.
#[derive(Clone, Copy, Default)]
struct Component {
    value: f64,
    size: f64,
}

impl Component {
    fn add(&mut self, value: f64, size: f64) {
        self.value += value;
        self.size += size;
    }
}

/// The difference between two sums of `terms` products with a relative rounding error of `epsilon` each, in any order,
/// over the sum of absolute values: half an epsilon for each addition and for at most 24 operations of a term, in both.
fn tolerance(terms: usize, epsilon: f64) -> f64 {
    (terms + 24) as f64 * epsilon
}

fn narrow<T: Clone>(part: &[T], of: impl Fn(T) -> f32) -> Vec<f32> {
    part.iter().cloned().map(of).collect()
}

/// A system of numbers with this potential, beside its gradient by hand. The test compares the momenta after a step from rest.
macro_rules! potential {
    ($name:ident, |$self:ident, $q:ident, $v:ident| $body:block, |$numbers:ident, $at:ident, $gradient:ident| $by_hand:block) => {
        mod $name {
            use super::*;

            struct InLanes(Numbers);

            #[hamiltonian]
            impl InLanes {
                fn kinetic(&self, p: &[f64]) -> f64 {
                    p.iter().map(|p| 0.5 * p * p).sum()
                }
                fn potential(&$self, $q: &[f64]) -> f64 {
                    let mut $v = 0.0;
                    $body
                    $v
                }
            }

            fn gradient($numbers: &Numbers, $at: &[f64]) -> Vec<Component> {
                let mut $gradient = vec![Component::default(); $at.len()];
                $by_hand
                $gradient
            }

            #[test]
            fn moves_as_the_formula_says() -> Result<(), Error> {
                assert!(InLanes::LARGE_FLOWS, "no loop is in lanes");
                for count in 2..=MOST {
                    let numbers = Numbers::new(count, 3);
                    let q: Vec<f64> = (0..count).map(|k| wave(5 * k + 1)).collect();
                    let expected = gradient(&numbers, &q);
                    let system = InLanes(numbers);
                    let check = |p: &[f64], epsilon: f64| {
                        for (p, Component { value, size }) in p.iter().zip(&expected) {
                            let (found, bound) = (-p / STEP, size * tolerance(3 * count, epsilon));
                            assert!((found - value).abs() <= bound, "{found} for {value} of {count} within {bound:e}");
                        }
                    };
                    let mut run = system.run_with(Euler, Phase::new(q.clone(), vec![0.0; count]), STEP)?;
                    run.advance(1)?;
                    check(&run.state().p, f64::EPSILON);
                    let mut single = system.run_with(Euler, Phase::new(narrow(&q, |x| x as f32), vec![0.0_f32; count]), STEP)?;
                    single.advance(1)?;
                    check(&single.state().p.iter().map(|p| f64::from(*p)).collect::<Vec<_>>(), f64::from(f32::EPSILON));
                    let start = Phase::compensated(q.clone(), vec![0.0; count]);
                    let mut compensated = system.run_with(Euler, start, STEP)?;
                    compensated.advance(1)?;
                    check(&compensated.state().p.iter().map(|p| f64::from(*p)).collect::<Vec<_>>(), f64::EPSILON);
                }
                Ok(())
            }

            #[test]
            fn members_move_as_single_runs() -> Result<(), Error> {
                for count in [2, 7, 8, 19, MOST] {
                    let member = |seed: usize| {
                        let q: Vec<f64> = (0..count).map(|k| wave(5 * k + 2 * seed)).collect();
                        (InLanes(Numbers::new(count, seed)), Phase::new(q, vec![0.0; count]))
                    };
                    let mut ensemble = Ensemble::new(Yoshida4, (0..11).map(member), 0.01)?;
                    ensemble.advance(7)?;
                    for number in 0..11 {
                        let (system, start) = member(number);
                        let mut alone = system.run_with(Yoshida4, start, 0.01)?;
                        alone.advance(7)?;
                        assert_eq!(ensemble.state(number), Some(alone.state()), "member {number}, {count} coordinates");
                    }
                }
                Ok(())
            }
        }
    };
}

mod indices;

potential!(
    matrix,
    |self, q, v| {
        for i in 0..q.len() {
            for j in 0..q.len() {
                v += 0.5 * self.0.table[i][j] * q[i] * q[j];
            }
        }
    },
    |numbers, q, gradient| {
        for (k, component) in gradient.iter_mut().enumerate() {
            for (j, q) in q.iter().enumerate() {
                for term in [numbers.table[k][j], numbers.table[j][k]].map(|entry| 0.5 * entry * q) {
                    component.add(term, term.abs());
                }
            }
        }
    }
);

potential!(
    regression,
    |self, q, v| {
        for row in 0..5 {
            let mut z = q[0];
            for k in 0..q.len() - 1 {
                z += self.0.table[row][k] * q[k + 1];
            }
            v += z.exp().ln_1p();
        }
    },
    |numbers, q, gradient| {
        for row in &numbers.table[..5] {
            let products = || row.iter().zip(&q[1..]).map(|(x, q)| x * q);
            let z = q[0] + products().sum::<f64>();
            // The slope of the logistic function is at most a quarter.
            let size = 1.0 + (q[0].abs() + products().map(f64::abs).sum::<f64>()) / 4.0;
            let slope = z.exp() / (1.0 + z.exp());
            gradient[0].add(slope, size);
            for (component, x) in gradient[1..].iter_mut().zip(row) {
                component.add(slope * x, size * x.abs());
            }
        }
    }
);

potential!(
    mean_field,
    |self, q, v| {
        let c: f64 = q.iter().map(|q| q.cos()).sum();
        let s: f64 = q.iter().map(|q| q.sin()).sum();
        v -= self.0.strength * (c * c + s * s) / (2.0 * q.len() as f64);
    },
    |numbers, q, gradient| {
        let sum = |of: fn(f64) -> f64| q.iter().map(|q| of(*q)).sum::<f64>();
        let (c, s, count) = (sum(f64::cos), sum(f64::sin), q.len() as f64);
        for (component, q) in gradient.iter_mut().zip(q) {
            component.add(numbers.strength * (c * q.sin() - s * q.cos()) / count, 2.0 * numbers.strength);
        }
    }
);

potential!(
    conditions,
    |self, q, v| {
        for i in 0..q.len() {
            for j in 0..q.len() {
                let x = q[i] - 0.5 * q[j];
                if x > 0.125 {
                    v += 0.5 * self.0.weights[j] * x * x;
                }
            }
        }
    },
    |numbers, q, gradient| {
        for i in 0..q.len() {
            for j in 0..q.len() {
                let x = q[i] - 0.5 * q[j];
                if x > 0.125 {
                    let force = numbers.weights[j] * x;
                    gradient[i].add(force, force.abs());
                    gradient[j].add(-0.5 * force, 0.5 * force.abs());
                }
            }
        }
    }
);

potential!(
    neighbours,
    |self, q, v| {
        let sum: f64 = (0..q.len() - 1).map(|k| q[k] * q[k + 1]).sum();
        v += 0.5 * sum * sum;
        for k in 1..q.len() {
            v += 0.5 * self.0.weights[k] * (q[k] - 0.5 * q[0]).powi(2);
        }
    },
    |numbers, q, gradient| {
        let products = || q.windows(2).map(|both| both[0] * both[1]);
        let (sum, size) = (products().sum::<f64>(), products().map(f64::abs).sum::<f64>());
        for k in 1..q.len() {
            gradient[k - 1].add(sum * q[k], size * q[k].abs());
            gradient[k].add(sum * q[k - 1], size * q[k - 1].abs());
            let force = numbers.weights[k] * (q[k] - 0.5 * q[0]);
            gradient[k].add(force, force.abs());
            gradient[0].add(-0.5 * force, 0.5 * force.abs());
        }
    }
);

/// Test particles in the field of bodies that come first.
#[derive(Clone)]
struct Field {
    masses: Vec<f64>,
    softening: f64,
}

const PARTICLES: usize = 3;

#[hamiltonian]
impl Field {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let bodies = self.masses.len();
        let mut v = 0.0;
        for i in bodies..q.len() {
            for j in 0..bodies {
                let d = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                v -= self.masses[j] / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + self.softening).sqrt();
            }
        }
        v
    }
}

/// The same, by a sum over components.
struct ByComponents(Field);

#[hamiltonian]
impl ByComponents {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        p.iter().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let bodies = self.0.masses.len();
        let mut v = 0.0;
        for i in bodies..q.len() {
            for j in 0..bodies {
                let r2: f64 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum();
                v -= self.0.masses[j] / (r2 + self.0.softening).sqrt();
            }
        }
        v
    }
}

#[test]
fn test_particles_move_in_the_field_of_bodies() -> Result<(), Error> {
    const { assert!(Field::LARGE_FLOWS && Field::WIDE, "no loop is in lanes") };
    for bodies in 1..=MOST {
        let count = bodies + PARTICLES;
        let member = |seed: usize| {
            let q: Vec<_> = (0..count).map(|i| [0, 1, 2].map(|d| wave(5 * i + 17 * d + seed))).collect();
            let masses = (0..bodies).map(|i| 1.25 + wave(3 * i + seed)).collect();
            (Field { masses, softening: 0.5 }, Phase::new(q, vec![[0.0; 3]; count]))
        };
        let (system, start) = member(1);
        let mut expected = vec![[Component::default(); 3]; count];
        for i in bodies..count {
            for j in 0..bodies {
                let d = [0, 1, 2].map(|k| start.q[i][k] - start.q[j][k]);
                let r2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + system.softening;
                let factor = system.masses[j] / (r2 * r2.sqrt());
                for (k, x) in d.into_iter().enumerate() {
                    expected[i][k].add(factor * x, (factor * x).abs());
                    expected[j][k].add(-factor * x, (factor * x).abs());
                }
            }
        }
        let check = |p: &[[f64; 3]], epsilon: f64| {
            for (p, Component { value, size }) in p.iter().flatten().zip(expected.iter().flatten()) {
                let (found, bound) = (-p / STEP, size * tolerance(bodies, epsilon));
                assert!((found - value).abs() <= bound, "{found} for {value} of {bodies} bodies within {bound:e}");
            }
        };
        let mut run = system.run_with(Euler, start.clone(), STEP)?;
        run.advance(1)?;
        check(&run.state().p, f64::EPSILON);
        let mut by_components = ByComponents(system.clone()).run_with(Euler, start.clone(), STEP)?;
        by_components.advance(1)?;
        assert_eq!(by_components.state(), run.state(), "{bodies} bodies");
        let narrow = |part: &[[f64; 3]]| part.iter().map(|point| point.map(|x| x as f32)).collect::<Vec<_>>();
        let mut single = system.run_with(Euler, Phase::new(narrow(&start.q), narrow(&start.p)), STEP)?;
        single.advance(1)?;
        let wide: Vec<_> = single.state().p.iter().map(|p| p.map(f64::from)).collect();
        check(&wide, f64::from(f32::EPSILON));

        let mut ensemble = Ensemble::new(Verlet, (0..9).map(member), 0.01)?;
        ensemble.advance(3)?;
        for number in 0..9 {
            let (system, start) = member(number);
            let mut alone = system.run_with(Verlet, start, 0.01)?;
            alone.advance(3)?;
            assert_eq!(ensemble.state(number), Some(alone.state()), "member {number}, {bodies} bodies");
        }
    }
    Ok(())
}
