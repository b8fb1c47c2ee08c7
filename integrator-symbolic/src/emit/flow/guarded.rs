//! Tests that guarded expressions have no effect if their condition is false. The energy and the force of a table of
//! systems are computed as in the stepper, line by line, and compared with the plain function.

use crate::{
    differentiate::{fold_branches, gradient},
    graph::{Graph, Node, NodeId, Part, evaluate::Point},
    model::Model,
    pattern::stores::{lower_roots, stores},
    program::{Item, Program, Sink, Store, is_protected, schedule},
};

/// A potential as text, and as the function that it is.
struct Row {
    name: &'static str,
    text: &'static str,
    plain: fn(&[f64]) -> f64,
}

macro_rules! rows {
    ($q:ident: $($name:ident $body:block)*) => {
        &[$(Row { name: stringify!($name), text: stringify!($body), plain: |$q: &[f64]| $body }),*]
    };
}

/// Potentials of slices. Each has, without its guards, a value that is not finite, an index that is not there, or an
/// integer below zero.
const ROWS: &[Row] = rows! { q:
    ratio_of_distances_in_triples {
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..q.len() {
                for k in 0..j {
                    if i != j && i != k {
                        v += (q[k] - q[i]) / (q[j] - q[i]).powi(2).sqrt();
                    }
                }
            }
        }
        v
    }
    factor_of_the_outer_index {
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                v += q[j] * (q[i] - q[0]).abs().ln();
            }
        }
        v
    }
    densities_of_pairs {
        let mut rho = vec![0.5; q.len()];
        let mut pairs = 0.0;
        for i in 0..q.len() {
            for j in i + 1..q.len() {
                let r2 = (q[i] - q[j]).powi(2);
                if r2 < 4.0 {
                    let f = (-r2).exp();
                    rho[i] += f;
                    rho[j] += 2.0 * f;
                    pairs += r2.sqrt();
                }
            }
        }
        let mut v = pairs;
        for density in &rho {
            v -= density.sqrt();
        }
        v
    }
    densities_of_lower_pairs {
        let n = q.len();
        let mut rho = vec![1.0; n];
        for (i, x) in q.iter().enumerate() {
            for j in 0..i {
                let f = (x - q[j]).cos();
                if f < 0.3 {
                    continue;
                }
                rho[i] += f * x;
                rho[j] -= f;
            }
        }
        rho.iter().map(|x| x * x).sum::<f64>()
    }
    densities_of_all_others {
        let mut rho = vec![0.0; q.len()];
        for i in 0..q.len() {
            for j in 0..q.len() {
                if i != j {
                    rho[i] += (q[i] * q[j]).sin();
                    rho[j] += q[i];
                }
            }
        }
        let mut v = 0.0;
        for (x, density) in q.iter().zip(&rho) {
            v += x * density * density;
        }
        v
    }
    log_sum_exp {
        let top = q.iter().map(|x| 300.0 * x * x).fold(f64::NEG_INFINITY, f64::max);
        top + q.iter().map(|x| (300.0 * x * x - top).exp()).sum::<f64>().ln()
    }
    largest_of_equal_ones {
        let mut top = -9.0;
        for x in q {
            for y in [0.5, 0.5] {
                if (x - y).powi(2) > top {
                    top = (x - y).powi(2);
                }
            }
        }
        let low = q.iter().fold(f64::INFINITY, |low, x| low.min(x * x * x));
        top * q[0] + low
    }
    products_with_zeros {
        let mut all = 1.0;
        let mut others = 1.0;
        for (k, x) in q.iter().enumerate() {
            all *= x - 0.7 + 0.25 * k as f64;
            others *= (x - 0.7) * (x + 0.2);
        }
        all + others * q[0] + q.iter().filter(|x| **x > 0.1).map(|x| x * x - 4.0).product::<f64>()
    }
    factor_of_no_index {
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..q.len() {
                if i > q.len() + j {
                    v += q[j] * (-q[i].abs()).ln();
                }
            }
        }
        v + q.iter().map(|x| x * x).sum::<f64>()
    }
    term_of_no_index {
        let mut v = 0.0;
        for i in 0..q.len() {
            for _ in 0..i {
                v += (q[i] - q[0]).abs().sqrt();
            }
        }
        v
    }
    cutoff_inside {
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..q.len() {
                if (q[j] - q[i]).abs() > 0.1 {
                    for k in 0..q.len() {
                        if (q[k] - q[i]).abs() > 0.1 && k != j {
                            v += (q[k] - q[j]).powi(2) / ((q[j] - q[i]).abs() * (q[k] - q[i]).abs());
                        }
                    }
                }
            }
        }
        v
    }
    root_of_a_maximum {
        q.iter().map(|x| x.max(0.0).sqrt() + (0.0_f64).max(*x).ln().max(-(x * x)) + x.min(0.35).abs().powf(1.5)).sum()
    }
    maximum_of_a_root {
        q.iter().map(|x| (x - 0.5).sqrt().max(0.1 * x) + (0.2 * x).min((-x).ln()) + (x.ln()).max((-x).ln())).sum()
    }
    clamped_root {
        q.iter().map(|x| x.clamp(0.0, 1.5).sqrt() + x.clamp(-0.1, 0.9) * x).sum()
    }
    clamped_nan {
        q.iter().map(|x| x.sqrt().clamp(0.1, 1.2)).sum()
    }
    branches_one_after_the_other {
        let mut v = 1.0;
        for y in q {
            let mut x = *y;
            if x > 0.0 {
                x = x.sqrt() + 0.1;
            } else {
                x = x * x;
            }
            if x > 0.2 {
                x = x.ln() + 2.0;
            }
            if x < 1.5 {
                x *= 1.1;
            } else {
                x -= 0.3;
            }
            if *y < 1.0 {
                x += y.sin();
                x += x * x;
            } else {
                x -= 1.0;
            }
            if x > 0.1 {
                x = 1.0 / x;
            }
            v += x * x;
        }
        v
    }
    index_below_zero {
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..3 {
                if i > 0 {
                    v += q[i - 1].powi(2) * (q[i] + j as f64);
                }
            }
        }
        v
    }
    index_below_zero_in_an_empty_loop {
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                v += q[i - 1].sin() * q[j] + (i - 1) as f64 * q[i].cos();
            }
        }
        v
    }
    indices_behind_two_conditions {
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..q.len() {
                if i + j < q.len() {
                    v += q[i + j].exp() * q[i];
                }
                if j >= i {
                    v += q[j - i].sin() * q[i];
                }
                if i > 0 && q[i - 1] > 0.5 {
                    v += q[i - 1].ln() * q[j];
                }
                if i == 0 || q[i - 1] < 0.5 {
                    v += q[j];
                }
            }
        }
        v
    }
    a_sum_over_a_number_of_coordinates {
        let mut v = 0.0;
        for x in q {
            if q.len() > 2 {
                let z = (0..3).map(|k| q[k] * q[k]).sum::<f64>();
                v += (z * x).cos();
            }
        }
        v
    }
    coordinates_that_may_not_be_there {
        let mut v = 0.0;
        for x in q {
            if q.len() > 1 {
                v += q[1] * q[0] * x;
            }
            if q.len() > 2 {
                v += q[2].sin() * x;
            }
        }
        if q.len() > 3 {
            v += q[3] * q[0];
        }
        v
    }
    first_one_left_out {
        let mut v = 0.0;
        for i in 0..q.len() {
            if i == 0 {
                continue;
            }
            for j in 0..q.len() {
                v += (q[i - 1] - q[i]).powi(2) * q[j];
            }
        }
        v
    }
    stillinger_weber {
        let mut v = 0.0;
        for i in 0..q.len() {
            for j in 0..q.len() {
                if i == j {
                    continue;
                }
                let r = ((q[j] - q[i]).powi(2) + 0.01 * (j as f64 - i as f64).powi(2)).sqrt();
                if r < 1.8 {
                    v += 0.5 * 7.05 * (0.6 / r.powi(4) - 1.0) * (1.0 / (r - 1.8)).exp();
                    for k in 0..j {
                        if k != i {
                            let s = ((q[k] - q[i]).powi(2) + 0.01 * (k as f64 - i as f64).powi(2)).sqrt();
                            if s < 1.8 {
                                let dot = (q[j] - q[i]) * (q[k] - q[i])
                                    + 0.01 * (j as f64 - i as f64) * (k as f64 - i as f64);
                                v += 21.0 * (1.2 / (r - 1.8) + 1.2 / (s - 1.8)).exp()
                                    * (dot / (r * s) + 1.0 / 3.0).powi(2);
                            }
                        }
                    }
                }
            }
        }
        v
    }
};

/// How many coordinates there are in turn, and where they are; none twice, and no cutoff of a row at any distance.
const STARTS: &[&[f64]] = &[&[0.7], &[0.7, -0.2], &[0.7, -0.2, 1.9], &[0.3, -0.8, 1.1, 2.6]];

fn model_of(text: &str) -> Model {
    let item = format!(
        "impl System {{
            fn kinetic(&self, p: &[f64]) -> f64 {{ p.iter().map(|p| p * p / 2.0).sum() }}
            fn potential(&self, q: &[f64]) -> f64 {text}
        }}"
    );
    crate::model::of_text(&item)
}

fn program(model: &Model, stores: &[Store]) -> Program {
    let is_leaf = |graph: &Graph, id| matches!(graph.node(id), Node::Constant(_) | Node::FromIndex(_));
    schedule(&model.graph, stores, is_leaf)
}

/// The energy, as its lines compute it.
fn energy(model: &mut Model) -> Program {
    let value = lower_roots(model, &[model.potential])[0];
    program(model, &[Store { context: Vec::new(), sink: Sink::Return, value }])
}

/// The gradient, collected by branches or, where that is done, by choices between values.
fn force(model: &mut Model, by_choices: bool) -> Program {
    let mut gradient = gradient(&mut model.graph, model.potential, Part::Position);
    if by_choices && !gradient.iter().any(|contribution| is_protected(&mut model.graph, contribution)) {
        gradient = fold_branches(&mut model.graph, &gradient);
    }
    let stores = stores(model, &gradient, Sink::Collect);
    program(model, &stores)
}

/// Lines as numbers: every line is computed where it stands, whether anything reads it or not.
struct Lines<'m> {
    graph: &'m Graph,
    point: Point<'m>,
    returned: f64,
    collected: Vec<f64>,
}

impl<'m> Lines<'m> {
    fn new(graph: &'m Graph, q: &'m [f64]) -> Self {
        Self { graph, point: Point::new(q, &[]), returned: 0.0, collected: vec![0.0; q.len()] }
    }

    fn name(&mut self, id: NodeId) {
        self.point.known.remove(&id);
        let value = self.point.value(self.graph, id);
        self.point.known.insert(id, value);
    }

    fn run(mut self, items: &[Item]) -> Self {
        self.items(items);
        self
    }

    fn items(&mut self, items: &[Item]) {
        for item in items {
            self.item(item);
        }
    }

    fn item(&mut self, item: &Item) {
        let graph = self.graph;
        match item {
            Item::Let(id) => self.name(*id),
            Item::SineCosine { sine, cosine, .. } => [*sine, *cosine].into_iter().for_each(|id| self.name(id)),
            Item::Begin(id) => {
                let beginning = match graph.node(*id) {
                    Node::Fold(fold, ..) => fold.beginning(),
                    _ => 0.0,
                };
                self.point.known.insert(*id, beginning);
            }
            Item::Loop { by, body } => {
                let range = graph.loops.get(*by);
                for iteration in self.point.index(graph, range.from)..self.point.index(graph, range.to) {
                    self.point.running.insert(*by, iteration);
                    self.items(body);
                }
                self.point.running.remove(by);
            }
            Item::Branch { condition, holds, body } => {
                if self.point.holds(graph, *condition) == *holds {
                    self.items(body);
                }
            }
            Item::Add { sum, value } => {
                let value = self.point.value(graph, *value);
                let known = self.point.known.get_mut(sum).expect("a sum that has begun");
                *known = match graph.node(*sum) {
                    Node::Fold(fold, ..) => fold.joined(*known, value),
                    _ => *known + value,
                };
            }
            Item::Choose { choice, value } => {
                let value = self.point.value(graph, *value);
                self.point.known.insert(*choice, value);
            }
            Item::Sink(Sink::Return, value) => self.returned = self.point.value(graph, *value),
            Item::Sink(Sink::Collect(element), value) => {
                let at = self.point.index(graph, element.index) as usize;
                self.collected[at] += self.point.value(graph, *value);
            }
            Item::Sink(other, _) => unreachable!("{other:?} is not used"),
        }
    }
}

/// The derivative by differences that are symmetric and extrapolated once: with h = 1e-4 off by h⁴ times a fifth
/// derivative, of which those of the rows are up to 1e5, and by eps/h = 2e-12 times the energy.
fn difference(row: &Row, q: &[f64], at: usize) -> f64 {
    let shifted = |h: f64| {
        let mut q = q.to_vec();
        q[at] += h;
        (row.plain)(&q)
    };
    let central = |h: f64| (shifted(h) - shifted(-h)) / (2.0 * h);
    (4.0 * central(5e-5) - central(1e-4)) / 3.0
}

#[test]
fn energies_and_forces_are_those_of_the_plain_function() {
    for row in ROWS {
        let mut model = model_of(row.text);
        let (energy, forces) = (energy(&mut model), [false, true].map(|by_choices| force(&mut model, by_choices)));
        for q in STARTS {
            let (name, expected) = (row.name, (row.plain)(q));
            let found = Lines::new(&model.graph, q).run(&energy.items).returned;
            if expected.is_nan() {
                assert!(found.is_nan(), "{name} at {q:?}: {found} for a NaN");
                continue;
            }
            // Sums of a few dozen terms of the size of the largest, in another order.
            let scale = 1.0 + expected.abs();
            assert!((found - expected).abs() < 1e-12 * scale, "{name} at {q:?}: {found} for {expected}");
            for force in &forces {
                let found = Lines::new(&model.graph, q).run(&force.items).collected;
                for (at, found) in found.into_iter().enumerate() {
                    let expected = difference(row, q, at);
                    let scale = scale + expected.abs();
                    assert!((found - expected).abs() < 1e-8 * scale, "{name} at {q:?}, {at}: {found} for {expected}");
                }
            }
        }
    }
}
