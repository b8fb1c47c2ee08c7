//! Bodies of `potential` of every kind, each with its gradient written by hand.

use crate::{Cell, Kind, START, TIME, close, kicked};
use integrator_core::prelude::*;
use std::{
    collections::{BTreeMap, HashMap},
    sync::Arc,
};

/// A list that is outside of every impl.
const WEIGHTS: [f64; 2] = [2.0, 0.5];

/// A function that is outside of every impl.
fn weight(x: f64) -> f64 {
    1.0 + x
}

/// Declares a test for every row: the name, the body of `potential`, and its gradient at coordinates `a, b, c, d` and
/// time `t` for the system `s`. Names that rows mention are given once, in front.
macro_rules! rows {
    (
        ($self:ident, $q:ident, $t:ident) ($s:ident, $a:ident, $b:ident, $c:ident, $d:ident)
        $($name:ident { $($body:tt)* } => $gradient:expr;)*
    ) => {
        $(mod $name {
            use super::*;

            struct System {
                mass: f64,
                stiffness: [f64; 4],
                table: Vec<f64>,
                bonds: Vec<(usize, usize)>,
                neighbours: Vec<usize>,
                count: usize,
                charge: i32,
                soft: f32,
                tilted: bool,
                cell: Cell,
                boxed: Box<f64>,
                shared: Arc<f64>,
                lent: &'static f64,
                kind: Kind,
                kinds: Vec<Kind>,
                optional: Option<f64>,
                lists: Vec<Vec<usize>>,
                starts: [usize; 5],
                columns: Vec<usize>,
                weights: Vec<Vec<f64>>,
                rings: Vec<[usize; 2]>,
                by_number: BTreeMap<usize, f64>,
                by_pair: HashMap<(usize, usize), f64>,
                by_name: HashMap<String, f64>,
            }

            #[hamiltonian]
            impl System {
                const WIDTH: usize = 2;
                const ORDER: usize = 2 * Self::WIDTH;
                fn kinetic(&self, p: [f64; 4]) -> f64 {
                    p.iter().map(|p| p * p / 2.0).sum()
                }
                fn potential(&$self, $q: [f64; 4], $t: f64) -> f64 {
                    $($body)*
                }
                fn spring(&self, d: f64) -> f64 {
                    0.5 * self.mass * d * d
                }
                fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
                    [a[0] - b[0], a[1] - b[1]]
                }
                fn opposite(a: [f64; 2]) -> [f64; 2] {
                    std::array::from_fn(|k| -a[k])
                }
                fn polar(&self, x: f64, y: f64) -> (f64, f64) {
                    (x.hypot(y), y.atan2(x))
                }
                fn strength(&self) -> f64 {
                    match self.charge {
                        0 => 0.0,
                        _ => 5.0,
                    }
                }
            }

            #[test]
            fn moves_by_the_hand_written_gradient() {
                let system = System {
                    mass: 2.0,
                    stiffness: [1.0, 2.0, 3.0, 4.0],
                    table: vec![4.0, 3.0, 2.0, 1.0],
                    bonds: vec![(0, 1), (1, 3)],
                    neighbours: vec![1, 2, 3, 0],
                    count: 3,
                    charge: 2,
                    soft: 0.5,
                    tilted: true,
                    cell: Cell { edge: 1.5, sides: [1.0, 2.5] },
                    boxed: Box::new(1.25),
                    shared: Arc::new(2.25),
                    lent: &3.25,
                    kind: Kind::Spring(1.5),
                    kinds: vec![Kind::Spring(2.0), Kind::Free, Kind::Listed { list: vec![5.0, 7.0], at: 1 }, Kind::Spring(3.0)],
                    optional: Some(1.5),
                    lists: vec![vec![1], vec![], vec![0, 3], vec![1]],
                    starts: [0, 1, 1, 3, 4],
                    columns: vec![1, 0, 3, 1],
                    rings: vec![[1, 3], [2, 0], [3, 1], [0, 2]],
                    by_number: BTreeMap::from([(1, 5.0), (2, 6.0)]),
                    by_pair: HashMap::from([((1, 0), 2.0), ((2, 1), 3.0), ((3, 0), 4.0)]),
                    by_name: HashMap::from([("stiff".to_owned(), 7.0)]),
                    weights: vec![vec![1.0, 2.0, 3.0, 4.0], vec![1.0, -1.0]],
                };
                let (gradient, energy) = kicked(&system, START, TIME);
                close(&[energy], &[system.potential(START, TIME)]);
                let ($s, [$a, $b, $c, $d], $t) = (&system, START, TIME);
                close(&gradient, &$gradient);
            }
        })*
    };
}

rows! {
    (self, q, t) (s, a, b, c, d)

    // Numbers and variables
    arithmetic { q[0] * q[1] - q[2] / (1.0 + q[3]) } => [b, a, -1.0 / (1.0 + d), c / (1.0 + d).powi(2)];
    shadowing { let x = q[0]; let x = x * x; x * q[1] } => [2.0 * a * b, a * a, 0.0, 0.0];
    assignment { let mut x = q[0]; x *= q[1]; x = x + 1.0; x } => [b, a, 0.0, 0.0];
    assigned_together { let (mut x, mut y) = (q[0], q[1]); if x > y { (x, y) = (y, x); } x * y * y } => [2.0 * a * b, a * a, 0.0, 0.0];
    blocks { let x = { let y = q[0]; y * y }; x } => [2.0 * a, 0.0, 0.0, 0.0];
    tuples { let pair = (q[0], q[1]); pair.0 * pair.1 } => [b, a, 0.0, 0.0];
    arrays { let d = [q[0] - q[1], q[2] - q[3]]; d[0] * d[1] } => [c - d, d - c, a - b, b - a];
    filled_arrays { let mut s = [0.0; 4]; for i in 0..4 { s[i] = q[i] * q[i]; } s[0] * s[3] } => [2.0 * a * d * d, 0.0, 0.0, 2.0 * d * a * a];
    filled_layers { let mut h = [0.0; 32]; for k in 0..32 { let mut s = 0.1 * k as f64; for i in 0..4 { s += self.stiffness[(i + k) % 4] * q[i]; } h[k] = s.tanh(); } let mut v = 0.0; for k in 0..32 { v += self.table[k % 4] * h[k]; } v } => [0, 1, 2, 3].map(|i| (0..32).map(|k| { let x = 0.1 * k as f64 + (0..4).map(|i| s.stiffness[(i + k) % 4] * START[i]).sum::<f64>(); s.table[k % 4] * s.stiffness[(i + k) % 4] / x.cosh().powi(2) }).sum::<f64>());
    filled_vectors { let mut h = vec![0.0; self.count]; for k in 0..self.count { h[k] = q[k] * q[k]; } h.iter().map(|x| x * x).sum::<f64>() } => [4.0 * a.powi(3), 4.0 * b.powi(3), 4.0 * c.powi(3), 0.0];
    changed_items { let mut h = [1.0; 20]; for (k, h) in h.iter_mut().enumerate() { *h += k as f64 * q[k % 4]; } let mut s = [0.0; 4]; for (s, (x, k)) in s.iter_mut().zip(q.iter().zip(&self.table)) { *s = k * x; } h.iter().sum::<f64>() + s[0] * s[1] } => [40.0 + 12.0 * b, 45.0 + 12.0 * a, 50.0, 55.0];
    collected { let s: Vec<f64> = q.iter().map(|x| x * x).collect(); let r = q.map(f64::exp); s[0] * s[1] + r[2] } => [2.0 * a * b * b, 2.0 * b * a * a, c.exp(), 0.0];
    from_functions_of_known_length { fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] { std::array::from_fn(|k| a[k] - b[k]) } let d = minus([q[0], q[1]], [q[2], q[3]]); let e = Self::opposite(d); let w: [f64; 2] = std::array::from_fn(|k| 2.0 * self.stiffness[k]); w[0] * d[0] * e[1] + w[1] * q[0] + Self::difference(d, std::array::from_fn(|k| q[k + 1]))[0] } => [2.0 * (d - b) + 5.0, 2.0 * (c - a) - 1.0, 2.0 * (b - d) - 1.0, 2.0 * (a - c)];
    from_functions { let h: [f64; 24] = std::array::from_fn(|k| k as f64 * q[k % 4]); h.iter().map(|x| x * x).sum::<f64>() } => [0, 1, 2, 3].map(|i| (0..6).map(|m| 2.0 * START[i] * ((i + 4 * m) as f64).powi(2)).sum::<f64>());
    patterns { let ([x, _], (y, z)) = ([q[0], q[1]], (q[2], q[3])); x * y * z } => [c * d, 0.0, a * d, a * c];
    taken_apart { let [x, y, z, w] = q; x * y * z * w } => [b * c * d, a * c * d, a * b * d, a * b * c];
    taken_apart_at_the_ends { let [x, .., y] = q; let [_, between @ ..] = q; x * y + between[0] * between[2] + between.len() as f64 * x } => [d + 3.0, d, 0.0, a + b];
    references { let x = &q[0]; *x * x } => [2.0 * a, 0.0, 0.0, 0.0];
    typed_variables { let x: f64 = q[0]; x * x } => [2.0 * a, 0.0, 0.0, 0.0];
    literals { 2f64 * q[0] + 1_0.5e-1_f64 * q[1] } => [2.0, 1.05, 0.0, 0.0];
    inner_constants { const STRENGTH: f64 = 3.0; STRENGTH * q[0] } => [3.0, 0.0, 0.0, 0.0];
    inner_use { use std::f64::consts::PI; PI * q[0] } => [std::f64::consts::PI, 0.0, 0.0, 0.0];
    assertions { debug_assert!(q[0].is_finite()); q[0] * q[0] } => [2.0 * a, 0.0, 0.0, 0.0];
    changing { let mut k = self.mass; if q[0] > 0.0 { k += 1.0; } k * q[0] } => [3.0, 0.0, 0.0, 0.0];

    // Functions
    roots { q[0].powi(3) + (1.0 + q[1]).sqrt() + q[2].cbrt() + (1.0 + q[3]).recip() } => [3.0 * a * a, 0.5 / (1.0 + b).sqrt(), 1.0 / (3.0 * c.cbrt().powi(2)), -1.0 / (1.0 + d).powi(2)];
    real_powers { (1.0 + q[0]).powf(1.3) + (1.0 + q[1]).powf(self.mass) + (2.0 + q[2]).powf(q[3]) } => [1.3 * (1.0 + a).powf(0.3), s.mass * (1.0 + b).powf(s.mass - 1.0), d * (2.0 + c).powf(d - 1.0), (2.0 + c).powf(d) * (2.0 + c).ln()];
    integer_powers { (1.0 + q[0]).powi(self.charge) + (1.0 + q[1]).powi(-2) } => [2.0 * (1.0 + a), -2.0 / (1.0 + b).powi(3), 0.0, 0.0];
    exponentials { q[0].exp() + q[1].exp2() + q[2].exp_m1() } => [a.exp(), std::f64::consts::LN_2 * b.exp2(), c.exp(), 0.0];
    logarithms { (1.0 + q[0]).ln() + q[1].ln_1p() + (1.0 + q[2]).log2() + (1.0 + q[3]).log10() + (1.0 + q[3]).log(3.0) } => [1.0 / (1.0 + a), 1.0 / (1.0 + b), 1.0 / ((1.0 + c) * std::f64::consts::LN_2), (1.0 / std::f64::consts::LN_10 + 1.0 / 3.0_f64.ln()) / (1.0 + d)];
    angles { q[0].sin() * q[1].cos() + q[2].tan() } => [a.cos() * b.cos(), -a.sin() * b.sin(), 1.0 / c.cos().powi(2), 0.0];
    sine_and_cosine { let (s, c) = q[0].sin_cos(); s * c } => [(2.0 * a).cos(), 0.0, 0.0, 0.0];
    inverses { q[0].asin() + q[1].acos() + q[2].atan() + q[3].atan2(1.0 + q[2]) } => [1.0 / (1.0 - a * a).sqrt(), -1.0 / (1.0 - b * b).sqrt(), 1.0 / (1.0 + c * c) - d / (d * d + (1.0 + c).powi(2)), (1.0 + c) / (d * d + (1.0 + c).powi(2))];
    hyperbolics { q[0].sinh() + q[1].cosh() + q[2].tanh() } => [a.cosh(), b.sinh(), 1.0 / c.cosh().powi(2), 0.0];
    inverse_hyperbolics { q[0].asinh() + (2.0 + q[1]).acosh() + q[2].atanh() } => [1.0 / (1.0 + a * a).sqrt(), 1.0 / ((2.0 + b).powi(2) - 1.0).sqrt(), 1.0 / (1.0 - c * c), 0.0];
    hypotenuse { q[0].hypot(q[1]) + q[2].mul_add(q[3], 1.0) } => [a / a.hypot(b), b / a.hypot(b), d, c];
    degrees { q[0].to_radians() + q[1].to_degrees() } => [1.0_f64.to_radians(), 1.0_f64.to_degrees(), 0.0, 0.0];
    piecewise { q[0].min(q[1]) + q[2].max(0.0) + q[1].abs() * 2.0 + q[3].clamp(-0.1, 0.1) + q[0].signum() * q[3] } => [0.0, -1.0, 1.0, 1.0];
    nearest_image { let d = q[0] - 2.0 * (q[0] / 2.0).round(); d * d + q[1].floor() * q[1] + q[2].ceil() * q[2] + q[3].trunc() * q[3] + q[2].round_ties_even() * q[3] } => [2.0 * (a - 2.0 * (a / 2.0).round()), b.floor(), c.ceil(), d.trunc() + c.round_ties_even()];
    remainders { q[0].fract() * q[0] + (q[1] % 0.75).powi(2) + q[2].rem_euclid(0.75).powi(2) } => [a + a.fract(), 2.0 * (b % 0.75), 2.0 * c.rem_euclid(0.75), 0.0];
    paths { f64::sin(q[0]) + f64::powi(q[1], 2) } => [a.cos(), 2.0 * b, 0.0, 0.0];

    // Sums
    ranges { let mut v = 0.0; for i in 0..4 { v += q[i] * q[i]; } v } => [2.0 * a, 2.0 * b, 2.0 * c, 2.0 * d];
    inclusive_ranges { let mut v = 0.0; for i in 1..=3 { v -= q[i] * q[i - 1]; } v } => [-b, -a - c, -b - d, -c];
    backwards { let mut v = 0.0; for i in (0..4).rev() { v += i as f64 * q[i] * q[i]; } v } => [0.0, 2.0 * b, 4.0 * c, 6.0 * d];
    strides { let mut v = 0.0; for i in (0..4).step_by(2) { v += q[i] * q[i + 1]; } v } => [b, a, d, c];
    triangular { let mut v = 0.0; for i in 0..4 { for j in 0..i { v += (q[i] - q[j]).powi(2); } } v } => [a, b, c, d].map(|x| 2.0 * (4.0 * x - (a + b + c + d)));
    upper_triangle { let mut v = 0.0; for i in 0..4 { for j in i + 1..4 { v += q[i] * q[j]; } } v } => [b + c + d, a + c + d, a + b + d, a + b + c];
    several_sums { let (mut u, mut v) = (0.0, 0.0); for i in 0..4 { u += q[i]; v += q[i] * q[i]; } u * v } => [a, b, c, d].map(|x| (a * a + b * b + c * c + d * d) + 2.0 * x * (a + b + c + d));
    arrays_of_sums { let mut s = [0.0; 2]; for i in 0..4 { s[0] += q[i]; s[1] -= q[i] * q[i]; } s[0] * s[1] } => [a, b, c, d].map(|x| -(a * a + b * b + c * c + d * d) - 2.0 * x * (a + b + c + d));
    inner_arrays_of_sums { let mut s = [0.0; 2]; for pair in q.chunks_exact(2) { for d in 0..2 { s[d] += pair[d]; } } s[0] * s[1] } => [b + d, a + c, b + d, a + c];
    inner_sums { let mut v = 0.0; for i in 0..2 { let mut r = 1.0; for d in 0..2 { r += q[2 * i + d] * q[2 * i + d]; } v += r.sqrt(); } v } => [a / (1.0 + a * a + b * b).sqrt(), b / (1.0 + a * a + b * b).sqrt(), c / (1.0 + c * c + d * d).sqrt(), d / (1.0 + c * c + d * d).sqrt()];
    skipping { let mut v = 0.0; for i in 0..4 { for j in 0..4 { if i == j { continue; } v += q[i] * q[j]; } } v } => [2.0 * (b + c + d), 2.0 * (a + c + d), 2.0 * (a + b + d), 2.0 * (a + b + c)];
    skipping_after_a_sum { let mut v = 0.0; for i in 0..4 { for j in 0..i { if j + 1 == i { v += q[i] * q[j]; continue; } v += 2.0 * q[i] * q[j]; } } v } => [b + 2.0 * c + 2.0 * d, a + c + 2.0 * d, 2.0 * a + b + d, 2.0 * a + 2.0 * b + c];
    skipped_patterns { let mut v = 0.0; for i in 0..4 { let Some(k) = self.by_number.get(&i) else { continue }; if let Some(l) = self.by_pair.get(&(i, 0)) && *l > 3.0 { continue; } v += k * q[i]; } v } => [0.0, 5.0, 6.0, 0.0];
    over_coordinates { let mut v = 0.0; for x in q { v += x * x; } for x in &q { v += x; } v } => [2.0 * a + 1.0, 2.0 * b + 1.0, 2.0 * c + 1.0, 2.0 * d + 1.0];
    over_lists { let mut v = 0.0; for &(i, j) in &self.bonds { v += (q[i] - q[j]).powi(2); } v } => [2.0 * (a - b), 2.0 * (b - a) + 2.0 * (b - d), 0.0, 2.0 * (d - b)];
    listed_indices { let mut v = 0.0; for i in 0..4 { v += q[i] * q[self.neighbours[i]]; } v } => [b + d, a + c, b + d, a + c];
    neighbour_lists { let mut v = 0.0; for i in 0..4 { for &j in &self.lists[i] { v += q[i] * q[j]; } } v } => [b + c, a + d, a + d, c + b];
    neighbour_arrays { let mut v = 0.0; for i in 0..4 { for &j in &self.rings[i] { v += q[i] * q[j]; } } for &[i, j] in &self.rings { v += q[i] * q[j] * q[j]; } v } => [2.0 * (b + d) + 2.0 * c * a + c * c, 2.0 * (a + c) + d * d + 2.0 * d * b, 2.0 * (b + d) + a * a + 2.0 * a * c, 2.0 * (a + c) + 2.0 * b * d + b * b];
    arrays_of_points { let mut v = 0.0; for [x, y] in [[q[0], q[1]], [q[2], q[3]]] { v += x * y; } for a in [[q[0], q[2]]] { v += a[0] * a[1] * a[1]; } v } => [b + c * c, a, d + 2.0 * a * c, c];
    lists_of_lists { let mut v = 0.0; for (row, x) in self.lists.iter().zip(q) { for j in row.iter() { v += x * q[*j]; } } v } => [b + c, a + d, a + d, c + b];
    compressed_rows { let mut v = 0.0; for i in 0..4 { for k in self.starts[i]..self.starts[i + 1] { v += self.table[k] * q[i] * q[self.columns[k]]; } } v } => [4.0 * b + 3.0 * c, 4.0 * a + d, 3.0 * a + 2.0 * d, 2.0 * c + b];
    chosen_indices { let mut v = 0.0; for i in 0..4 { let next = if i + 1 == q.len() { 0 } else { i + 1 }; let before = if i == 0 { 3 } else { i - 1 }; let far = if i < 2 { 3 } else { 1 }; v += q[i] * q[next] + 2.0 * q[i] * q[before] + q[i] * q[far]; } v } => [3.0 * (b + d) + d, 3.0 * (a + c) + d + c + d, 3.0 * (b + d) + b, 3.0 * (a + c) + a + b + b];
    index_arithmetic { let mut v = 0.0; for i in 0..2 { for j in 0..2 { v += q[i * 2 + j] * q[i * 2 + (j + 1) % 2]; } } v } => [2.0 * b, 2.0 * a, 2.0 * d, 2.0 * c];
    bits_of_indices { let mut v = 0.0; for i in 0..4 { v += (i & 1) as f64 * q[i] * q[i ^ 1] + q[i >> 1]; } v } => [2.0 + b, 2.0 + a, d, c];
    named_indices { let mut v = 0.0; for i in 0..4 { let next = (i + 1) % 4; v += q[i] * q[next]; } v } => [b + d, a + c, b + d, a + c];
    signed_integers { let mut v = 0.0; for i in 0..4 { v += (i as i32 - 2) as f64 * q[i]; } v } => [-2.0, -1.0, 0.0, 1.0];
    signed_remainders { let mut v = 0.0; for i in 0..4 { v += q[i as usize] * q[((i - 1 + 4) % 4) as usize]; } v } => [b + d, a + c, b + d, a + c];
    ranges_from_below_zero { let mut v = 0.0; for k in -1..2 { v += k as f64 * q[(k + 1) as usize]; } v } => [-1.0, 0.0, 1.0, 0.0];
    wrapping_casts { let mut v = 0.0; for i in 254..258 { v += (i as u8) as f64 * q[0]; } v } => [510.0, 0.0, 0.0, 0.0];
    counted_strides { let mut v = 0.0; for i in (0..4).step_by(2) { for _ in 1..i { v += q[0] * q[0]; } } v } => [2.0 * a, 0.0, 0.0, 0.0];
    stopped_differences { let mut v = 0.0; for i in 0..q.len() { for j in 0..i.saturating_sub(1) { v += q[i] * q[j]; } } v } => [c + d, d, a, a + b];
    powers_by_an_index { let mut v = 0.0; for n in 0..4 { v += (1.0 + q[0]).powi(n as i32); } v } => [1.0 + 2.0 * (1.0 + a) + 3.0 * (1.0 + a).powi(2), 0.0, 0.0, 0.0];
    bounds { let mut v = 0.0; for i in 0..self.count { v += q[i] * q[i]; } v } => [2.0 * a, 2.0 * b, 2.0 * c, 0.0];
    lengths { let mut v = 0.0; for i in 0..q.len() - 1 { v += q[i] * q[i + 1]; } v } => [b, a + c, b + d, c];
    horner { let mut v = 0.0; for k in (0..3).rev() { v = v * q[0] + self.stiffness[k]; } v } => [2.0 + 6.0 * a, 0.0, 0.0, 0.0];
    polynomials { let mut v = 0.0; for k in self.table.iter().rev() { v = v * q[0] + k; } v } => [3.0 + 4.0 * a + 3.0 * a * a, 0.0, 0.0, 0.0];
    polynomials_in_arms { let mut v = 0.0; for i in 0..4 { v += match &self.kinds[i] { Kind::Listed { list, .. } => list.iter().rev().fold(0.0, |v, k| v * q[i] + k), _ => q[i] }; } v } => [1.0, 1.0, 7.0, 1.0];
    guarded_recurrences { let mut v = [0.0; 4]; for n in 0..4 { v[n] = 1.0; if n >= 1 { v[n] += q[0] * v[n - 1]; } if n >= 2 && v[n - 2] > 0.0 { v[n] -= v[n - 2]; } } v[3] } => [-1.0 + 2.0 * a + 3.0 * a * a, 0.0, 0.0, 0.0];
    legendre { let x = q[0]; let mut l = [0.0; 4]; for n in 0..4 { l[n] = match n { 0 => 1.0, 1 => x, _ => ((2 * n - 1) as f64 * x * l[n - 1] - (n - 1) as f64 * l[n - 2]) / n as f64 }; } let mut m = [0.0; 4]; for n in 0..4 { if n == 0 { m[n] = 1.0; continue; } m[n] = if n == 1 { x } else { 2.0 * x * m[n - 1] - m[n - 2] }; } l[3] + m[3] } => [7.5 * a * a - 1.5 + 12.0 * a * a - 3.0, 0.0, 0.0, 0.0];
    triangles { let mut w = [[0.0; 4]; 4]; for n in 0..4 { for m in 0..4 { if m > n { continue; } if n == 0 { w[0][0] = 1.0; } else { w[n][m] = q[0] * w[n - 1][m]; if m >= 1 { w[n][m] += q[1] * w[n - 1][m - 1]; } } } } w[3][1] + w[3][2] } => [6.0 * a * b + 3.0 * b * b, 3.0 * a * a + 6.0 * a * b, 0.0, 0.0];
    lengths_by_constants { let mut v = [0.0; Self::ORDER]; v[0] = 1.0; for n in 1..Self::ORDER { v[n] = 1.0 + q[0] * v[n - 1]; } let (mut x, mut y) = (1.0, q[1]); for _ in 1..Self::ORDER - 1 { (x, y) = (y, 2.0 * q[1] * y - x); } v[Self::ORDER - 1] + y + (0..Self::ORDER).fold(1.0, |product, k| product * (q[2] + k as f64)) } => [1.0 + 2.0 * a + 3.0 * a * a, 12.0 * b * b - 3.0, 4.0 * c.powi(3) + 18.0 * c * c + 22.0 * c + 6.0, 0.0];
    any_number_of_factors { let mut w = 1.0; for i in 0..self.count { w *= 1.0 + q[i]; } w + self.table.iter().map(|k| q[3] - k).product::<f64>() } => [(1.0 + b) * (1.0 + c), (1.0 + a) * (1.0 + c), (1.0 + a) * (1.0 + b), (0..4).map(|i| (0..4).filter(|j| *j != i).map(|j| d - s.table[j]).product::<f64>()).sum()];
    factors_that_are_zero { (0..self.count).map(|i| q[i] - 0.4).product::<f64>() + self.table.iter().map(|_| (q[3] - 0.2) * (q[0] - 0.4)).product::<f64>() } => [(b - 0.4) * (c - 0.4), 0.0, 0.0, 0.0];
    largest_of_any_number { let (mut top, mut low) = (-9.0, f64::INFINITY); for k in &self.table { let x = k * q[0] + k * k * q[1]; if x > top { top = x; } low = low.min(x); } top * low } => { let (top, low) = (a + b, 4.0 * a + 16.0 * b); [low + 4.0 * top, low + 16.0 * top, 0.0, 0.0] };
    log_sum_exp { let logs: Vec<f64> = self.table.iter().map(|k| -k * q[0] * q[0]).collect(); let top = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max); top + logs.iter().map(|x| (x - top).exp()).sum::<f64>().ln() } => { let weights = [4.0, 3.0, 2.0, 1.0].map(|k: f64| (-k * a * a).exp()); let mean = (4.0 * weights[0] + 3.0 * weights[1] + 2.0 * weights[2] + weights[3]) / weights.iter().sum::<f64>(); [-2.0 * a * mean, 0.0, 0.0, 0.0] };
    densities_of_pairs { let mut rho = vec![1.0; self.count]; for i in 0..self.count { for j in i + 1..self.count { let f = q[i] * q[j]; rho[i] += f; rho[j] += f; } } rho.iter().map(|x| x * x).sum::<f64>() } => { let x = [a, b, c]; let rho = x.map(|own| 1.0 + own * (a + b + c - own)); let slope = |m: usize| (0..3).map(|i| 2.0 * rho[i] * if i == m { a + b + c - x[m] } else { x[i] }).sum::<f64>(); [slope(0), slope(1), slope(2), 0.0] };
    products { let mut v = 1.0; for i in 0..4 { v *= q[i]; } v } => [b * c * d, a * c * d, a * b * d, a * b * c];
    read_on_the_way { let (mut s, mut v) = (0.0, 0.0); for x in q { s += x; v += s * s; } let mut e = 1.0; for _ in 0..6 { e -= (e * e - 2.0 - q[0]) / (2.0 * e); } v + e } => { let sums = [a, a + b, a + b + c, a + b + c + d]; let tail = |k: usize| sums[k..].iter().map(|s| 2.0 * s).sum::<f64>(); [tail(0) + 0.5 / (2.0 + a).sqrt(), tail(1), tail(2), tail(3)] };

    // Iterators
    mapped { q.iter().map(|x| x * x).sum::<f64>() } => [2.0 * a, 2.0 * b, 2.0 * c, 2.0 * d];
    mapped_ranges { (0..4).map(|i| self.stiffness[i] * q[i] * q[i]).sum::<f64>() } => [2.0 * a, 4.0 * b, 6.0 * c, 8.0 * d];
    enumerated { q.iter().enumerate().map(|(i, x)| i as f64 * x).sum::<f64>() } => [0.0, 1.0, 2.0, 3.0];
    zipped { q.iter().zip(&self.table).map(|(x, k)| k * x).sum::<f64>() } => [4.0, 3.0, 2.0, 1.0];
    zipped_with_fewer { q.iter().zip(self.table.iter().skip(2)).map(|(x, k)| k * x).sum::<f64>() } => [2.0, 1.0, 0.0, 0.0];
    zipped_neighbours { q.iter().zip(q.iter().skip(1)).map(|(x, y)| x * y).sum::<f64>() } => [b, a + c, b + d, c];
    rings_by_cycle { q.iter().zip(q.iter().cycle().skip(1)).map(|(x, y)| x * y * y).sum::<f64>() } => [b * b + 2.0 * a * d, c * c + 2.0 * a * b, d * d + 2.0 * b * c, a * a + 2.0 * c * d];
    numbered { (1..).zip(q).map(|(n, x)| n as f64 * x).sum::<f64>() + q.iter().zip(2..).map(|(x, n)| n as f64 * x * x).sum::<f64>() + std::iter::zip(&q, &self.table).map(|(x, k)| k * x).sum::<f64>() } => [1.0 + 4.0 * a + 4.0, 2.0 + 6.0 * b + 3.0, 3.0 + 8.0 * c + 2.0, 4.0 + 10.0 * d + 1.0];
    windows { q.windows(2).map(|w| w[0] * w[1]).sum::<f64>() } => [b, a + c, b + d, c];
    windows_taken_apart { let mut v = 0.0; for pair in q.windows(2) { let [x, y] = pair else { continue }; if let &[z, _] = pair { v += x * y * z; } } v } => [2.0 * a * b, a * a + 2.0 * b * c, b * b + 2.0 * c * d, c * c];
    array_windows { q.array_windows().map(|[x, y]| x * y).sum::<f64>() } => [b, a + c, b + d, c];
    array_windows_of_a_length { q.array_windows::<2>().map(|w| w[0] * w[1]).sum::<f64>() } => [b, a + c, b + d, c];
    array_windows_in_a_loop { let mut sum = 0.0; for [x, y] in q.array_windows() { sum += x * y; } sum } => [b, a + c, b + d, c];
    array_windows_in_a_fold { q.array_windows().fold(0.0, |sum, &[x, y]| sum + x * y) } => [b, a + c, b + d, c];
    ends { q.first().unwrap() * q.last().copied().unwrap() } => [d, 0.0, 0.0, a];
    items_that_may_be_there { let mut v = 0.0; for i in 0..q.len() { v += q[i] * q.get(i + 1).map_or(1.0, |x| x * x); if let Some(x) = q.get(i + 2) { v += x * q[i]; } } v } => [b * b + c, 2.0 * a * b + c * c + d, 2.0 * b * c + d * d + a, 2.0 * c * d + 1.0 + b];
    copies { let copy = q.to_vec(); copy[0] * copy.as_slice()[1] + copy.first().copied().unwrap_or(0.0) } => [b + 1.0, a, 0.0, 0.0];
    changed_copies { let mut moved = q; moved[0] *= 2.0; moved[3] += moved[0]; moved[0] * moved[1] * moved[3] } => [2.0 * b * (d + 2.0 * a) + 4.0 * a * b, 2.0 * a * (d + 2.0 * a), 0.0, 2.0 * a * b];
    split_lists { let (left, right) = q.split_at(2); let (first, rest) = q.split_first().unwrap(); left[0] * right[1] + first * rest.iter().sum::<f64>() } => [d + b + c + d, a, a, a + a];
    ends_of_a_part { q[1..].first().expect("a site") * q[..3].last().unwrap() } => [0.0, c, b, 0.0];
    chunks { q.chunks_exact(2).map(|c| c[0] * c[1]).sum::<f64>() } => [b, a, d, c];
    even_chunks { q.chunks(2).map(|c| c[0] * c[1]).sum::<f64>() } => [b, a, d, c];
    iterators_in_variables { let pairs = q.iter().zip(&self.table); let squares = q.iter().map(|x| x * x); let chosen = self.table.iter().rev().take(3); pairs.map(|(x, k)| k * x).sum::<f64>() + squares.sum::<f64>() + chosen.zip(q).map(|(k, x)| k * x).sum::<f64>() } => [5.0 + 2.0 * a, 5.0 + 2.0 * b, 5.0 + 2.0 * c, 1.0 + 2.0 * d];
    folded { q.iter().fold(0.0, |sum, x| sum + x * x) } => [2.0 * a, 2.0 * b, 2.0 * c, 2.0 * d];
    folded_further { q.iter().fold(0.0, |sum, x| sum * sum + x) } => [8.0 * a * (a * a + b) * ((a * a + b).powi(2) + c), 4.0 * (a * a + b) * ((a * a + b).powi(2) + c), 2.0 * ((a * a + b).powi(2) + c), 1.0];
    folded_coefficients { (0..3).rev().fold(0.0, |v, k| v * q[0] + self.stiffness[k]) } => [2.0 + 6.0 * a, 0.0, 0.0, 0.0];
    folded_lists { self.table.iter().rev().fold(0.0, |v, k| v * q[0] + k) } => [3.0 + 4.0 * a + 3.0 * a * a, 0.0, 0.0, 0.0];
    folded_tuples { let (a, b) = q.iter().fold((0.0, 0.0), |(a, b), x| (a + x, b + x * x)); a * b } => [a, b, c, d].map(|x| (a * a + b * b + c * c + d * d) + 2.0 * x * (a + b + c + d));
    folded_branches { q.iter().fold(0.0, |sum, x| if *x > 0.0 { sum + x * x } else { sum }) } => [a, b, c, d].map(|x| if x > 0.0 { 2.0 * x } else { 0.0 });
    largest { q.iter().fold(-1.0, |top: f64, x| top.max(*x)) } => [a, b, c, d].map(|x| if x == a.max(b).max(c).max(d) { 1.0 } else { 0.0 });
    paths_of_functions { let square = |x: f64| x * x; q.into_iter().map(f64::sin).sum::<f64>() + q.into_iter().map(square).sum::<f64>() } => [a, b, c, d].map(|x| x.cos() + 2.0 * x);
    kept_in_bounds { let mut v = 0.0; for i in 0..4 { if i + 1 < 4 { v += q[i] * q[i + 1]; } if i >= 2 { continue; } v += q[i + 2]; } v } => [b, a + c, b + d + 1.0, c + 1.0];
    kept_below_the_end { let mut v = 0.0; for i in 0..4 { if i != 3 { v += q[i] * q[i + 1]; } match i { 2 | 3 => {} _ => v += q[i + 2] } } v + (0..4).filter(|&i| i != q.len() - 1).map(|i| q[i + 1]).sum::<f64>() } => [b, a + c + 1.0, b + d + 2.0, c + 2.0];
    factors { q.iter().map(|x| 1.0 + x * x).product::<f64>() } => [a, b, c, d].map(|x| 2.0 * x / (1.0 + x * x) * (1.0 + a * a) * (1.0 + b * b) * (1.0 + c * c) * (1.0 + d * d));
    filtered { (0..4).filter(|i| i % 2 == 0).map(|i| q[i] * q[i]).sum::<f64>() } => [2.0 * a, 0.0, 2.0 * c, 0.0];
    adaptors { q.iter().skip(1).take(2).map(|x| x * x).sum::<f64>() + q.iter().rev().step_by(2).sum::<f64>() } => [0.0, 2.0 * b + 1.0, 2.0 * c, 1.0];
    nested_iterators { (0..4).map(|i| (0..i).map(|j| q[i] * q[j]).sum::<f64>()).sum::<f64>() } => [b + c + d, a + c + d, a + b + d, a + b + c];
    matrix_rows { self.weights.iter().zip(&self.table).map(|(row, k)| k * row.iter().zip(q).map(|(w, x)| w * x).sum::<f64>().powi(2)).sum::<f64>() } => { let (y, z) = (8.0 * (a + 2.0 * b + 3.0 * c + 4.0 * d), 6.0 * (a - b)); [y + z, 2.0 * y - z, 3.0 * y, 4.0 * y] };
    flattened { [[q[0], q[1]], [q[2], q[3]]].iter().flatten().map(|x| x * x).sum::<f64>() } => [2.0 * a, 2.0 * b, 2.0 * c, 2.0 * d];
    flat_maps { (0..4).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| q[i] * q[j]).sum::<f64>() } => [b + c + d, a + c + d, a + b + d, a + b + c];
    parts { let part = &q[1..]; part[0] * part[2] + part.len() as f64 * part.iter().sum::<f64>() } => [0.0, d + 3.0, 3.0, b + 3.0];
    slices { q[1..].iter().zip(&q[..3]).map(|(y, x)| y * x).sum::<f64>() + q[1..=2].iter().sum::<f64>() } => [b, a + c + 1.0, b + d + 1.0, c];
    iterated_arrays { [q[0], q[3]].iter().map(|x| x * x).sum::<f64>() } => [2.0 * a, 0.0, 0.0, 2.0 * d];
    closures { q.windows(2).map(|w| { let d = w[1] - w[0]; d * d }).sum::<f64>() } => [2.0 * (a - b), 2.0 * (b - a) + 2.0 * (b - c), 2.0 * (c - b) + 2.0 * (c - d), 2.0 * (d - c)];
    sums_of_array_elements { let mut bonds = [0.0; 3]; for k in 0..3 { bonds[k] = q[k] * q[k + 1]; } (0..3).map(|k| bonds[k] / (1.0 + self.stiffness[k])).sum::<f64>() } => [b / 2.0, a / 2.0 + c / 3.0, b / 3.0 + d / 4.0, c / 4.0];

    // Branches
    branch_values { if q[0] > 0.0 { q[0] * q[0] } else { q[1] } } => [2.0 * a, 0.0, 0.0, 0.0];
    else_if { if q[0] < 0.0 { q[0] } else if q[1] >= 0.0 { q[1] } else { q[2] * q[2] } } => [0.0, 0.0, 2.0 * c, 0.0];
    branch_statements { let mut v = q[0]; if q[1] <= 0.0 { v += q[1] * q[2]; } v } => [1.0, c, b, 0.0];
    joined_conditions { if (q[0] > 0.0 && q[1] < 0.0 || q[2] == 0.0) && !(q[3] != q[3]) { q[0] * q[1] } else { 0.0 } } => [b, a, 0.0, 0.0];
    named_conditions { let inside = q[0].abs() < 1.0; if inside { q[0] * q[1] } else { 0.0 } } => [b, a, 0.0, 0.0];
    on_parameters { if self.tilted { self.mass * q[0] } else { 0.0 } } => [s.mass, 0.0, 0.0, 0.0];
    on_indices { let mut v = 0.0; for i in 0..4 { v += if i % 2 == 0 { q[i] } else { -q[i] }; } v } => [1.0, -1.0, 1.0, -1.0];
    cutoffs { let mut v = 0.0; for i in 0..4 { for j in 0..i { let d = q[i] - q[j]; if d * d < 0.3 { v += d * d; } } } v } => [2.0 * (2.0 * a - c - d), 2.0 * (b - d), 2.0 * (2.0 * c - a - d), 2.0 * (3.0 * d - a - b - c)];
    matching { let k = match self.charge { 1 => 1.0, _ => 3.0 }; k * q[0] } => [3.0, 0.0, 0.0, 0.0];
    match_arms { match self.charge { 1 => q[0], 2 | 3 => q[1] * q[1], _ => 0.0 } } => [0.0, 2.0 * b, 0.0, 0.0];
    arm_names { match self.kind { Kind::Free => 0.0, Kind::Spring(k) if k > 9.0 => q[1], Kind::Spring(k) => k * q[0] * q[0], Kind::Listed { ref list, at: i } => list[i] * q[2] } } => [3.0 * a, 0.0, 0.0, 0.0];
    matched_indices { let mut v = 0.0; for i in 0..4 { match i { 0 | 3 => {} _ => v += q[i] * q[i] } } v } => [0.0, 2.0 * b, 2.0 * c, 0.0];
    matched_items { let mut v = 0.0; for (kind, x) in self.kinds.iter().zip(q) { v += match kind { Kind::Free => 0.0, Kind::Spring(k) => *k * x, Kind::Listed { list, at } => list[*at] * x * x }; } v } => [2.0, 0.0, 2.0 * 7.0 * c, 3.0];
    arm_references { let mut v = 0.0; for i in 0..4 { match &self.kinds[i] { Kind::Free => {} Kind::Spring(k) => v += k * q[i] * q[i], Kind::Listed { at, .. } => v += q[at + 1] } } if let Some(k) = &self.optional { v += k * q[1]; } v } => [4.0 * a, 1.5, 1.0, 6.0 * d];
    if_let { if let Some(k) = self.optional { k * q[0] } else { q[1] } } => [1.5, 0.0, 0.0, 0.0];
    if_let_among_conditions { if let Some(k) = self.optional && k > 1.0 && q[0] > 0.0 && let Kind::Spring(l) = self.kind { k * l * q[0] } else { q[1] } } => [2.25, 0.0, 0.0, 0.0];
    let_else { let Some(k) = self.optional else { return 0.0 }; k * q[0] } => [1.5, 0.0, 0.0, 0.0];
    options { self.optional.map_or(0.0, |k| k * q[0]) + self.kinds.get(9).map(|_| q[1]).unwrap_or(q[2]) + self.optional.unwrap_or(q[3]) } => [1.5, 0.0, 1.0, 0.0];
    early_return { let r = q[0] - q[1]; if r < 0.5 { return 0.0; } let s = r * q[2]; if self.tilted { return s; } s * s } => [c, -c, a - b, 0.0];
    nested_return { let mut v = q[3]; if q[0] > 0.0 { v += q[2]; if q[1] > 0.0 { return v; } else { v *= 2.0; } } else if q[1] > 1.0 { return 0.0; } v * q[0] } => [2.0 * (c + d), 0.0, 2.0 * a, 2.0 * a];
    returned_values { let k = match self.optional { Some(k) => k, None => return q[1] }; return k * q[0]; } => [1.5, 0.0, 0.0, 0.0];
    matching_macros { if matches!(self.charge, 1 | 2) { q[0] } else { 0.0 } } => [1.0, 0.0, 0.0, 0.0];

    // Helper methods
    helpers { self.spring(q[0] - q[1]) } => [s.mass * (a - b), s.mass * (b - a), 0.0, 0.0];
    array_helpers { let d = Self::difference([q[0], q[1]], [q[2], q[3]]); d[0] * d[1] } => [b - d, a - c, d - b, c - a];
    tuple_helpers { let (r, angle) = self.polar(q[0], q[1]); r * r + angle } => [2.0 * a - b / (a * a + b * b), 2.0 * b + a / (a * a + b * b), 0.0, 0.0];
    called_closures { let k = self.mass; let spring = |x: f64| { if x > 0.5 { return 0.0; } k * x * x }; spring(q[0]) + spring(q[2]) + (|x: f64| x * x)(q[1]) } => [2.0 * s.mass * a, 2.0 * b, 0.0, 0.0];
    inner_functions { fn square(x: f64) -> f64 { x * x } square(q[0]) * q[1] } => [2.0 * a * b, a * a, 0.0, 0.0];
    parameter_methods { self.strength() * q[0] } => [5.0, 0.0, 0.0, 0.0];

    // The system's own values
    fields { self.cell.edge * q[0] + self.stiffness[2] * q[1] + self.cell.sides[1] * q[2] } => [1.5, 3.0, 2.5, 0.0];
    vectors { self.table[1] * q[0] + self.table.len() as f64 * q[1] } => [3.0, 4.0, 0.0, 0.0];
    casts { self.count as f64 * q[0] + f64::from(self.charge) * q[1] + self.soft as f64 * q[2] } => [3.0, 2.0, 0.5, 0.0];
    integers_of_other_types { let k = 2 * self.charge - 1; let mut v = (1.0 + q[0]).powi(self.charge + 1) + k as f64 * q[1]; if self.charge % 2 == 0 { v += q[2]; } v += match self.charge % 3 { 2 => q[3], _ => 0.0 }; v } => [3.0 * (1.0 + a).powi(2), 3.0, 1.0, 1.0];
    pair_tables { let mut v = 0.0; for i in 0..4 { for j in 0..i { v += self.table[self.neighbours[i] % 2 * Self::WIDTH + self.neighbours[j] % 2] * q[i] * q[j]; } } v } => [0, 1, 2, 3].map(|i| [0, 1, 2, 3].into_iter().filter(|j| *j != i).map(|j| s.table[[1, 0, 1, 0][i.max(j)] * 2 + [1, 0, 1, 0][i.min(j)]] * START[j]).sum::<f64>());
    integers_of_two_lists { let mut v = 0.0; for i in 0..4 { for j in 0..i { if (self.neighbours[i] + self.neighbours[j]) % 2 == 1 { v += (self.neighbours[i] * self.neighbours[j]) as f64 * q[i]; } } } v } => [0.0, 2.0, 6.0, 0.0];
    ranges_of_integers { let mut v = 0.0; for l in 0..=self.charge { for m in -l..=l { v += (l * l + m) as f64 * q[0]; } } v + (-self.charge..=self.charge).filter(|&l| l != 0).map(|l| q[1].powi(2) / f64::from(l * l)).sum::<f64>() } => [23.0, 5.0 * b, 0.0, 0.0];
    truth { f64::from(self.tilted) * q[0] + self.tilted as u8 as f64 * q[1] } => [1.0, 1.0, 0.0, 0.0];
    truth_of_conditions { (q[0] > 0.0) as i32 as f64 * q[0] * q[0] + f64::from(q[1] > 0.0) * q[2] + f64::from(q[3]) } => [2.0 * a, 0.0, 0.0, 1.0];
    constants { Self::WIDTH as f64 * q[0] + std::f64::consts::PI * q[1] } => [2.0, std::f64::consts::PI, 0.0, 0.0];
    struct_patterns { let Self { mass, cell: Cell { edge, .. }, bonds, .. } = self; let (i, j) = bonds[1]; mass * edge * q[i] * q[j] } => [0.0, 3.0 * d, 0.0, 3.0 * b];
    types_that_are_asked_for { let k: f64 = self.table.iter().sum(); let (n, m): (usize, f64) = (self.neighbours.iter().sum(), self.soft.into()); let list: Vec<f64> = self.table.iter().map(|x| x * x).collect(); let line = |k: f64, x: f64| 2.0 * k * x; 2.0 * k * q[0] + n as f64 * q[1] + m.sqrt() * q[2] + list[1] * q[3] + line(self.soft.into(), q[3]) } => [20.0, 6.0, 0.5_f64.sqrt(), 10.0];
    given_references { let first = self.table.first().unwrap(); let mut v = first * q[0] + self.table.last().unwrap().powf(q[1]); v += first; v } => [4.0, 0.0, 0.0, 0.0];
    maps { let mut v = self.by_name["stiff"] * q[3]; for i in 0..4 { if self.columns.contains(&i) { v += q[i]; } if let Some(k) = self.by_number.get(&i) { v += k * q[i]; } for j in 0..i { if self.by_pair.contains_key(&(i, j)) { v += self.by_pair[&(i, j)] * q[i] * q[j]; } } } v } => [1.0 + 2.0 * b + 4.0 * d, 6.0 + 2.0 * a + 3.0 * c, 6.0 + 3.0 * b, 8.0 + 4.0 * a];
    iterators_of_the_system { let mut v = 0.0; for (k, x) in self.by_number.values().zip(q) { v += k * x; } v + self.lists.iter().flatten().zip(q).map(|(i, x)| *i as f64 * x).sum::<f64>() } => [5.0 + 1.0, 6.0 + 0.0, 3.0, 1.0];
    boxes { *self.boxed * q[0] + *self.shared * q[1] + *self.lent * q[2] } => [1.25, 2.25, 3.25, 0.0];
    borrowed_values { let k = &self.mass; let l = match self.charge { 1 => 1.0, _ => *k }; self.table.iter().zip(q).map(|(s, x)| *s * l * x).sum::<f64>() } => [8.0, 6.0, 4.0, 2.0];
    constant_lists { const C: [f64; 3] = [1.0, 2.0, 4.0]; let mut v = 0.0; for i in 0..24 { v += C[i % 3] * WEIGHTS[i % 2] * q[i % 4]; } v } => [28.0, 7.0, 28.0, 7.0];
    functions_of_literals { weight(2.0) * q[0] + weight(self.mass) * q[1] } => [3.0, 3.0, 0.0, 0.0];
    any_rust { let top = self.table.iter().copied().fold(0.0, f64::max); top * q[0] } => [4.0, 0.0, 0.0, 0.0];
    made_lists { let twice = |x: f64| 2.0 * x; let list = vec![1.0, twice(self.mass)]; list[1] * q[0] } => [4.0, 0.0, 0.0, 0.0];

    // Time
    time { q[0] * (self.mass * t).sin() + t * t } => [(s.mass * t).sin(), 0.0, 0.0, 0.0];
    time_in_conditions { if t < 1.0 { t * q[0] } else { q[0] } } => [t, 0.0, 0.0, 0.0];
}
