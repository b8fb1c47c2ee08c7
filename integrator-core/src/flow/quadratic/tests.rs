use super::*;
use crate::{
    scalar::{double_double::DoubleDouble, simd::lanes::Lanes},
    state::compensated::Compensated,
};

/// The flow of any form.
type General<R> = Quadratic<R, 0, false>;

/// A form of reference.txt.
struct Drawn {
    kind: &'static str,
    degrees: usize,
    /// The entries of S, row by row: positions first, then momenta.
    second: Vec<f64>,
    first: Vec<f64>,
    /// The factor by which an error of one in each product may grow while exponentials are squared.
    growth: f64,
    /// Durations, with what is added to positions and momenta k of (k + 1)/4.
    flows: Vec<(f64, Vec<[f64; 2]>)>,
}

/// All of them: four kinds of up to twelve degrees of freedom.
fn drawn() -> Vec<Drawn> {
    let mut all: Vec<Drawn> = Vec::new();
    for line in include_str!("reference.txt").lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let numbers =
            |from: usize| -> Vec<f64> { words[from..].iter().map(|word| word.parse().expect("a number")).collect() };
        if words[0] == "flow" {
            let (numbers, last) = (numbers(1), all.last_mut().expect("a form before"));
            last.flows.push((numbers[0], numbers[1..].as_chunks().0.to_vec()));
            continue;
        }
        let (degrees, mut entries) = (words[2].parse().expect("a number"), numbers(3).into_iter());
        let rows = 2 * degrees;
        let mut second = vec![0.0; rows * rows];
        for (i, j) in (0..rows).flat_map(|i| (i..rows).map(move |j| (i, j))) {
            let value = entries.next().expect("an entry");
            (second[i * rows + j], second[j * rows + i]) = (value, value);
        }
        let first = entries.by_ref().take(rows).collect();
        let growth = entries.next().expect("a growth");
        all.push(Drawn { kind: words[1], degrees, second, first, growth, flows: Vec::new() });
    }
    all
}

impl Drawn {
    /// Returns the increments of a flow in double-double, with the column of constant increments.
    fn increments(&self, duration: f64, is_affine: bool) -> Vec<DoubleDouble> {
        let first = if is_affine { self.first.clone() } else { vec![0.0; self.first.len()] };
        form::Dense { size: self.degrees, second: self.second.clone(), first }.increments(duration)
    }
}

/// The form of this kind, with its slopes or without.
fn form(kind: &str, n: usize, is_affine: bool) -> Form {
    let drawn = drawn().into_iter().find(|drawn| drawn.kind == kind && drawn.degrees == n).expect("a form");
    let s = drawn.second;
    let mut form = Form::new(1);
    for i in 0..n {
        for j in 0..n {
            form.qq([i], [j], s[i * 2 * n + j]);
            form.qp([i], [j], s[i * 2 * n + n + j]);
            form.pp([i], [j], s[(n + i) * 2 * n + n + j]);
        }
        if is_affine {
            form.q([i], drawn.first[i]);
            form.p([i], drawn.first[n + i]);
        }
    }
    form
}

/// A state that a flow moves.
fn moved<K: Precision>(solver: &mut General<f64>, duration: f64, z: &mut [Vec<K::Slot<f64>>; 2])
where
    Vec<K>: Coords<Leaf = K>,
{
    let n = z[0].len();
    let [mut q, mut p] = [0, 1].map(|half| Vec::<K>::slots_from::<f64>(n, |k| z[half][k]));
    solver.flow::<Vec<K>>(duration, &mut q, &mut p);
    *z = [Vec::<K>::slots(&q).to_vec(), Vec::<K>::slots(&p).to_vec()];
}

/// The error of a sum of at most 25 products in double-double, relative to the norms of its factors.
const OF_A_PRODUCT: f64 = 25.0 / f64::from_bits((1023 + 104) << 52);

/// The largest sum of a row's absolute values.
fn norm(matrix: &[DoubleDouble], columns: usize) -> f64 {
    let of_row = |row: &[DoubleDouble]| row.iter().map(|entry| entry.lane(0).abs()).sum::<f64>();
    matrix.chunks_exact(columns).map(of_row).fold(0.0, f64::max)
}

#[test]
fn increments_are_those_of_matrix_exponentials_at_sixty_digits() {
    let mut kinds = Vec::new();
    for drawn in drawn() {
        let columns = 2 * drawn.degrees + 1;
        for (duration, exact) in &drawn.flows {
            let z = |column: usize| if column == columns - 1 { 1.0 } else { (column + 1) as f64 / 4.0 };
            let matrix = drawn.increments(*duration, true);
            let off = matrix.chunks_exact(columns).zip(exact).map(|(row, exact)| {
                let products = row.iter().enumerate().map(|(column, entry)| *entry * DoubleDouble::of(z(column)));
                let sum = products.fold(DoubleDouble::of(0.0), |sum, product| sum + product);
                (sum - DoubleDouble::of(exact[0]) - DoubleDouble::of(exact[1])).lane(0).abs()
            });
            let off = off.fold(0.0, f64::max);
            // The norm of the point is its largest component, and two doubles hold the reference to 2^-106.
            let most = z(columns - 2) * drawn.growth * OF_A_PRODUCT;
            assert!(off <= most, "{} {} {duration}: {off:.1e}, at most {most:.1e}", drawn.kind, drawn.degrees);
        }
        kinds.push((drawn.kind, drawn.degrees, drawn.flows.len()));
    }
    let expected = ["definite", "indefinite", "nilpotent", "defective"].into_iter();
    assert_eq!(kinds, expected.flat_map(|kind| (1..=12).map(move |n| (kind, n, 2))).collect::<Vec<_>>());
}

#[test]
fn flows_compose_and_keep_areas() {
    for drawn in drawn() {
        let (n, w) = (drawn.degrees, 2 * drawn.degrees);
        let flow = |duration: f64| {
            let mut matrix = drawn.increments(duration, false);
            for k in 0..w {
                matrix[k * (w + 1) + k] += DoubleDouble::of(1.0);
            }
            matrix
        };
        let [a, b, both, back] = [1.25, -0.5, 0.75, -1.25].map(flow);
        let entry = |m: &[DoubleDouble], i: usize, j: usize| m[i * (w + 1) + j];
        // The error of either factor times the other one, that of the result, and those of the products of the test
        // itself; the transposed matrix has a norm of at most as many times that as it has rows.
        let near = |found: DoubleDouble, exact: DoubleDouble, [x, y]: [&[DoubleDouble]; 2], what: &str| {
            let (x, y) = (norm(x, w + 1), norm(y, w + 1));
            let most = (drawn.growth * (1.0 + x + y) + x * y) * w as f64 * OF_A_PRODUCT;
            let off = (found - exact).lane(0).abs();
            assert!(off <= most, "{} {n}, {what}: {off:.1e}, at most {most:.1e}", drawn.kind);
        };
        for i in 0..w {
            for j in 0..w {
                let zero = DoubleDouble::of(0.0);
                let sum = |of: &dyn Fn(usize) -> DoubleDouble| (0..w).fold(zero, |sum, k| sum + of(k));
                let product = |x: &[DoubleDouble], y: &[DoubleDouble]| sum(&|k| entry(x, i, k) * entry(y, k, j));
                near(product(&a, &b), entry(&both, i, j), [&a, &b], "group law");
                let unit = DoubleDouble::of(f64::from(u8::from(i == j)));
                near(product(&a, &back), unit, [&a, &back], "reversibility");
                // M^T J M = J.
                let area = sum(&|k| {
                    let (partner, sign) = if k < n { (n + k, 1.0) } else { (k - n, -1.0) };
                    entry(&a, k, i) * entry(&a, partner, j) * DoubleDouble::of(sign)
                });
                let exact = DoubleDouble::of(f64::from(u8::from(j == i + n)) - f64::from(u8::from(i == j + n)));
                near(area, exact, [&a, &a], "area");
            }
        }
    }
}

#[test]
fn blocks_are_coupled_coordinates_and_equal_ones_share_a_matrix() {
    let mut form = Form::new(1);
    // Two equal oscillators, one that is not, a pair that rotates, one that is pushed, and nothing at 4 and 6.
    for (i, stiffness) in [(0, 2.0), (1, 3.0), (7, 2.0)] {
        form.qq([i], [i], stiffness);
        form.pp([i], [i], 1.0);
    }
    form.qp([2], [5], 0.5);
    form.qp([5], [2], -0.5);
    form.qq([4], [6], 0.0);
    form.q([3], 9.81);
    let found: Vec<_> = groups(&[form.clone()]).iter().map(|group| (group.size, group.places.clone())).collect();
    assert_eq!(found, [(1, vec![0, 7]), (1, vec![1]), (2, vec![2, 5]), (1, vec![3])]);
    // What one member couples is a block for all.
    let mut other = form.clone();
    other.qq([1], [4], 0.25);
    let found: Vec<_> = groups(&[form, other]).iter().map(|group| (group.size, group.places.clone())).collect();
    assert_eq!(found, [(1, vec![0, 7]), (2, vec![1, 4]), (2, vec![2, 5]), (1, vec![3])]);
}

#[test]
fn a_member_has_the_bits_of_its_run_alone_whatever_the_others_couple() {
    let forms = [("definite", 3), ("defective", 2), ("indefinite", 1), ("nilpotent", 3)]
        .map(|(kind, n)| form(kind, n, kind == "definite"));
    let start = |half: usize, k: usize| (half as f64 + 0.5) * (k as f64 - 0.75);
    let mut together = General::<Lanes<f64, 4>>::of_forms(&forms, 4);
    let lanes = |half: usize| <[f64; 4]>::slots_from::<Lanes<f64, 4>>(4, |k| Lanes::of(start(half, k)));
    let (mut q, mut p) = (lanes(0), lanes(1));
    let durations = [0.125, 0.5, -0.25, 0.125];
    for duration in durations {
        together.flow::<[f64; 4]>(duration, &mut q, &mut p);
    }
    for (lane, form) in forms.iter().enumerate() {
        let mut alone = General::<f64>::of_forms(std::slice::from_ref(form), 4);
        let (mut own_q, mut own_p) = ([0, 1, 2, 3].map(|k| start(0, k)), [0, 1, 2, 3].map(|k| start(1, k)));
        for duration in durations {
            alone.flow::<[f64; 4]>(duration, &mut own_q, &mut own_p);
        }
        for k in 0..4 {
            assert_eq!([q[k].lane(lane), p[k].lane(lane)], [own_q[k], own_p[k]], "member {lane}, coordinate {k}");
        }
    }
}

#[test]
fn degrees_of_freedom_alone_are_moved_with_the_same_bits() {
    // All alike; one that differs; one that does not move.
    for frequencies in [[2.0, 2.0, 2.0], [2.0, 3.0, 2.0], [2.0, 0.0, 2.0]] {
        let mut form = Form::new(1);
        for (i, frequency) in frequencies.into_iter().enumerate() {
            form.qq([i], [i], frequency);
            form.pp([i], [i], frequency / 2.0);
        }
        let mut general = General::<f64>::of_forms(&[form.clone()], 3);
        let mut lone = Quadratic::<f64, 0, true>::of_forms(&[form], 3);
        let (mut q, mut p) = ([0.3, -0.2, 0.5], [0.1, 0.4, -0.6]);
        let (mut own_q, mut own_p) = (q, p);
        for duration in [0.125, 0.5, -0.25, 0.125] {
            general.flow::<[f64; 3]>(duration, &mut q, &mut p);
            lone.flow::<[f64; 3]>(duration, &mut own_q, &mut own_p);
        }
        assert_eq!((q, p), (own_q, own_p), "{frequencies:?}");
        assert!(q != [0.3, -0.2, 0.5] && (q[1] == -0.2) == (frequencies[1] == 0.0), "{q:?}");
    }
}

#[test]
fn durations_of_a_composition_are_found_by_one_lookup() {
    let (mut durations, mut misses) = (Durations::default(), Vec::new());
    let mut ask = |duration: f64, misses: &mut Vec<f64>| match durations.next(duration) {
        Some(number) => number,
        None => {
            misses.push(duration);
            durations.turn(duration).0
        }
    };
    // A palindrome with merged ends, as compositions have them: 1.0 opens, 2.0 merges two of them.
    let first = [1.0, 0.25, -0.5, -0.5, 0.25];
    let numbers: Vec<usize> = first.iter().map(|duration| ask(*duration, &mut misses)).collect();
    assert_eq!(numbers, [0, 1, 2, 2, 1]);
    for cycle in 0..10 {
        misses.clear();
        let numbers = [2.0, 0.25, -0.5, -0.5, 0.25].map(|duration| ask(duration, &mut misses));
        assert_eq!(numbers, [3, 1, 2, 2, 1]);
        assert!(cycle < 2 || misses.is_empty(), "{misses:?}");
    }
}

#[test]
fn the_number_of_stored_durations_is_bounded() {
    let mut solver = General::<f64>::of_forms(&[form("definite", 1, false)], 1);
    let mut z = [vec![1.0], vec![0.0]];
    for step in 1..5000 {
        moved::<f64>(&mut solver, f64::from(step) * 1e-4, &mut z);
        let known = solver.0.as_ref().map_or(0, |known| known.numbers.len());
        assert!((1..=8 * 1024).contains(&known), "{known}");
    }
    assert!(z[0][0].is_finite());
}

#[test]
fn energies_walk_and_do_not_drift() {
    fn off<K: Precision>(of: fn(f64) -> K::Slot<f64>, value: fn(K::Slot<f64>) -> f64, at: [f64; 2], steps: i32) -> f64
    where
        Vec<K>: Coords<Leaf = K>,
    {
        let mut oscillator = Form::new(1);
        oscillator.qq([0], [0], 1.0);
        oscillator.pp([0], [0], 1.0);
        let [duration, radius] = at;
        let mut solver = General::<f64>::of_forms(&[oscillator], 1);
        let [mut q, mut p] = [radius, 0.0].map(|start| Vec::<K>::slots_from::<f64>(1, |_| of(start)));
        for _ in 0..steps {
            solver.flow::<Vec<K>>(duration, &mut q, &mut p);
        }
        let [q, p] = [&q, &p].map(|slots| value(Vec::<K>::slots(slots)[0]));
        ((q * q + p * p) / (radius * radius) - 1.0).abs()
    }
    let steps = 1_000_000;
    // A step rounds four products, their sums and the state, each by half an ulp of the radius or less in either
    // direction: an ulp of energy for each of them is far above what they add up to. With entries rounded to f64, or with
    // a second part of the last digits alone, the second of these is off by 1e-11 and more.
    let walk = 8.0 * f64::from(steps).sqrt() * f64::EPSILON;
    for at in [[0.1, 1.0], [1.3, 3.3]] {
        let plain = off::<f64>(|x| x, |x| x, at, steps);
        assert!(plain <= walk, "{at:?}: {plain:.1e}");
        let compensated = off::<Compensated<f64>>(|x| [x, 0.0], |x| x[0], at, steps);
        assert!(compensated <= walk, "{at:?}, compensated: {compensated:.1e}");
    }
}

#[test]
fn states_of_single_precision_walk_too() {
    let mut solver = General::<f32>::of_forms(&[form("definite", 1, false)], 1);
    let mut plain = General::<f64>::of_forms(&[form("definite", 1, false)], 1);
    let (mut q, mut p, mut other_q, mut other_p) = ([1.0_f32], [0.0_f32], [1.0], [0.0]);
    for _ in 0..100_000 {
        solver.flow::<[f32; 1]>(0.7, &mut q, &mut p);
        plain.flow::<[f64; 1]>(0.7, &mut other_q, &mut other_p);
    }
    // As above, by what S makes of units: its entries and those of its root are below 4.
    let walk = 8.0 * 4.0 * 100_000.0_f64.sqrt() * f64::from(f32::EPSILON);
    let off = (f64::from(q[0]) - other_q[0]).abs().max((f64::from(p[0]) - other_p[0]).abs());
    assert!(off <= walk, "{off:.1e} {walk:.1e}");
}
