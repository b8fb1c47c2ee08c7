//! Loops whose coordinates are counted from an index of the system, or come several at a time, loops over all pairs of indices,
//! and loops over rows of data.

use super::*;

potential!(
    two_fields,
    |self, q, v| {
        let n = q.len() / 2;
        for i in 0..n {
            v += self.0.strength * (q[i] * q[n + i]).sin() + 0.5 * self.0.weights[i] * q[n + i] * q[n + i];
        }
    },
    |numbers, q, gradient| {
        let n = q.len() / 2;
        for i in 0..n {
            let factor = numbers.strength * (q[i] * q[n + i]).cos();
            let size = numbers.strength * (1.0 + (q[i] * q[n + i]).abs());
            gradient[i].add(factor * q[n + i], size * q[n + i].abs());
            gradient[n + i].add(factor * q[i], size * q[i].abs());
            let spring = numbers.weights[i] * q[n + i];
            gradient[n + i].add(spring, spring.abs());
        }
    }
);

potential!(
    two_at_a_time,
    |self, q, v| {
        for i in (0..q.len() - 1).step_by(2) {
            v += self.0.strength * (q[i] * q[i + 1]).sin();
        }
        for i in 1..q.len() / 2 {
            v += 0.5 * self.0.weights[i] * q[2 * i - 1] * q[2 * i + 1];
        }
    },
    |numbers, q, gradient| {
        for i in (0..q.len() - 1).step_by(2) {
            let factor = numbers.strength * (q[i] * q[i + 1]).cos();
            let size = numbers.strength * (1.0 + (q[i] * q[i + 1]).abs());
            gradient[i].add(factor * q[i + 1], size * q[i + 1].abs());
            gradient[i + 1].add(factor * q[i], size * q[i].abs());
        }
        for i in 1..q.len() / 2 {
            for (one, other) in [(2 * i - 1, 2 * i + 1), (2 * i + 1, 2 * i - 1)] {
                let force = 0.5 * numbers.weights[i] * q[other];
                gradient[one].add(force, force.abs());
            }
        }
    }
);

potential!(
    differences,
    |self, q, v| {
        for i in 0..q.len() {
            v += self.0.weights[i] * q[i];
            for j in 0..q.len() {
                if i != j {
                    v += self.0.strength * self.0.table[i][j] * (q[i] - q[j]).sin();
                }
            }
        }
    },
    |numbers, q, gradient| {
        for i in 0..q.len() {
            gradient[i].add(numbers.weights[i], numbers.weights[i].abs());
            for j in 0..q.len() {
                let factor = numbers.strength * numbers.table[i][j];
                let (force, size) = (factor * (q[i] - q[j]).cos(), factor.abs() * (2.0 + (q[i] - q[j]).abs()));
                if i != j {
                    gradient[i].add(force, size);
                    gradient[j].add(-force, size);
                }
            }
        }
    }
);

potential!(
    short_rows,
    |self, q, v| {
        for (x, row) in q.iter().zip(&self.0.table[1..]) {
            v += 0.5 * x * row[2..].iter().zip(q).map(|(entry, y)| entry * y).sum::<f64>();
        }
    },
    |numbers, q, gradient| {
        for (i, row) in numbers.table[1..].iter().enumerate().take(q.len()) {
            for (j, entry) in row[2..].iter().enumerate() {
                for (one, other) in [(i, j), (j, i)] {
                    let force = 0.5 * entry * q[other];
                    gradient[one].add(force, force.abs());
                }
            }
        }
    }
);

potential!(
    rows_of_data,
    |self, q, v| {
        for row in &self.0.table {
            let mut z = q[0];
            for k in 0..q.len() - 1 {
                z += row[k] * q[k + 1];
            }
            v += z.exp().ln_1p() - row[0] * z;
        }
    },
    |numbers, q, gradient| {
        for row in &numbers.table {
            let products = || row.iter().zip(&q[1..]).map(|(x, q)| x * q);
            let z = q[0] + products().sum::<f64>();
            // The slope of the logistic function is at most a quarter.
            let size = 1.0 + row[0].abs() + (q[0].abs() + products().map(f64::abs).sum::<f64>()) / 4.0;
            let slope = z.exp() / (1.0 + z.exp()) - row[0];
            gradient[0].add(slope, size);
            for (component, x) in gradient[1..].iter_mut().zip(row) {
                component.add(slope * x, size * x.abs());
            }
        }
    }
);

/// A density of two peaks at points of data.
#[derive(Clone)]
struct Peaks {
    points: Vec<f64>,
}

#[hamiltonian]
impl Peaks {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        self.points.iter().map(|x| -((-(x - q[0]).powi(2)).exp() + (-(x - q[1]).powi(2)).exp()).ln()).sum()
    }
}

#[test]
fn loops_over_data_move_few_coordinates() -> Result<(), Error> {
    const { assert!(Peaks::LARGE_FLOWS && Peaks::WIDE, "no loop is in lanes") };
    for count in 0..=MOST {
        let member = |seed: usize| {
            let points = (0..count).map(|k| wave(7 * k + seed)).collect();
            (Peaks { points }, Phase::new([0.5 * wave(seed), 1.0 + 0.25 * wave(seed + 1)], [0.0; 2]))
        };
        let (system, start) = member(1);
        let mut expected = [Component::default(); 2];
        for x in &system.points {
            let peaks = start.q.map(|q| (-(x - q).powi(2)).exp());
            for ((component, q), peak) in expected.iter_mut().zip(start.q).zip(peaks) {
                // Distances are below two, so that the exponent has a rounding error of at most four.
                let force = -2.0 * (x - q) * peak / (peaks[0] + peaks[1]);
                component.add(force, 4.0 * (1.0 + force.abs()));
            }
        }
        let mut run = system.run_with(Euler, start, STEP)?;
        run.advance(1)?;
        for (p, Component { value, size }) in run.state().p.iter().zip(expected) {
            let (found, bound) = (-p / STEP, size * tolerance(count, f64::EPSILON));
            assert!((found - value).abs() <= bound, "{found} for {value} of {count} points within {bound:e}");
        }
        let mut ensemble = Ensemble::new(Verlet, (0..9).map(member), 0.01)?;
        ensemble.advance(3)?;
        for number in 0..9 {
            let (system, start) = member(number);
            let mut alone = system.run_with(Verlet, start, 0.01)?;
            alone.advance(3)?;
            assert_eq!(ensemble.state(number), Some(alone.state()), "member {number}, {count} points");
        }
    }
    Ok(())
}
