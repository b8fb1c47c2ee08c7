use super::*;
use crate::{
    scalar::{double_double::DoubleDouble, simd::lanes::Lanes},
    state::compensated::Compensated,
};

/// The flow of any form.
type General<R> = Quadratic<R, 0, false>;

/// The entries of S by the formulas of reference.py, row by row: positions first, then momenta.
fn second(kind: &str, n: usize) -> Vec<f64> {
    let w = 2 * n;
    let e = |i: usize, j: usize| ((7 * i + 13 * j + 5 * n + 3 * i * j) % 11) as f64 / 8.0 - 0.625;
    let mut s = vec![0.0; w * w];
    match kind {
        "definite" => {
            for (place, s) in s.iter_mut().enumerate() {
                let (i, j) = (place / w, place % w);
                *s = (0..w).map(|k| e(i, k) * e(j, k)).sum::<f64>() + f64::from(u8::from(i == j));
            }
            return s;
        }
        "indefinite" => {
            for (place, s) in s.iter_mut().enumerate() {
                *s = e(place / w, place % w) + e(place % w, place / w);
            }
            return s;
        }
        "nilpotent" => {
            for k in 0..n - 1 {
                s[(n + k) * w + k + 1] = 1.0;
                s[(k + 1) * w + n + k] = 1.0;
            }
            s[w * w - 1] = 1.0;
        }
        _ => {
            for k in (0..n - 1).step_by(2) {
                for (a, b, value) in [(k, n + k + 1, 0.75), (k + 1, n + k, -0.75)] {
                    s[a * w + b] = value;
                    s[b * w + a] = value;
                }
                s[k * w + k] = 1.0;
                s[(k + 1) * w + k + 1] = 1.0;
            }
            s[w * w - 1] += f64::from(u8::from(n % 2 == 1));
        }
    }
    let shear = |i: usize, j: usize| match (i == j, i >= n && j < n) {
        (true, _) => 1.0,
        (_, true) => ((i - n + j) % 3) as f64 / 4.0 - 0.25,
        _ => 0.0,
    };
    let product = |left: &dyn Fn(usize, usize) -> f64, right: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
        (0..w * w).map(|place| (0..w).map(|k| left(place / w, k) * right(k, place % w)).sum()).collect()
    };
    let half = product(&|i, k| shear(k, i), &|k, j| s[k * w + j]);
    product(&|i, k| half[i * w + k], &shear)
}

/// The form of these entries with slopes that rise along positions and momenta.
fn form(kind: &str, n: usize, is_affine: bool) -> Form {
    let s = second(kind, n);
    let mut form = Form::new(1);
    for i in 0..n {
        for j in 0..n {
            form.qq([i], [j], s[i * 2 * n + j]);
            form.qp([i], [j], s[i * 2 * n + n + j]);
            form.pp([i], [j], s[(n + i) * 2 * n + n + j]);
        }
        if is_affine {
            form.q([i], i as f64 / 8.0);
            form.p([i], (n + i) as f64 / 8.0);
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

const KINDS: [&str; 4] = ["definite", "indefinite", "nilpotent", "defective"];

/// The matrix of all degrees of freedom in double-double, with the column of what is added everywhere.
fn increments(kind: &str, n: usize, is_affine: bool, duration: f64) -> Vec<DoubleDouble> {
    let slope = |k: usize| if is_affine { k as f64 / 8.0 } else { 0.0 };
    form::Dense { size: n, second: second(kind, n), first: (0..2 * n).map(slope).collect() }.increments(duration)
}

#[test]
fn increments_are_those_of_matrix_exponentials_at_sixty_digits() {
    let mut lines = 0;
    for line in include_str!("reference.txt").lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let (kind, n): (_, usize) = (words[0], words[1].parse().expect("a number"));
        let numbers: Vec<f64> = words[2..].iter().map(|word| word.parse().expect("a number")).collect();
        let matrix = increments(kind, n, true, numbers[0]);
        let (mut off, mut scale) = (0.0_f64, 0.0_f64);
        for (row, exact) in matrix.chunks_exact(2 * n + 1).zip(numbers[1..].as_chunks::<2>().0) {
            let z = |column: usize| if column == 2 * n { 1.0 } else { (column + 1) as f64 / 4.0 };
            let mut sum = DoubleDouble::of(0.0);
            for (column, entry) in row.iter().enumerate() {
                sum += *entry * DoubleDouble::of(z(column));
                scale = scale.max(entry.lane(0).abs() * z(column));
            }
            off = off.max((sum - DoubleDouble::of(exact[0]) - DoubleDouble::of(exact[1])).lane(0).abs());
        }
        // Each of at most 24 + 9 products of at most 25 terms is off by 25·2^-104 of its norm, and each squaring doubles
        // what is relative to it: 2^-85 with nine of them; two doubles hold the reference to 2^-106.
        assert!(off <= scale * 2.0_f64.powi(-85), "{kind} {n} {}: {:.1e}", numbers[0], off / scale);
        lines += 1;
    }
    assert_eq!(lines, 4 * 12 * 2);
}

#[test]
fn flows_compose_and_keep_areas() {
    for (kind, n) in KINDS.into_iter().flat_map(|kind| (1..=6).map(move |n| (kind, n))) {
        let w = 2 * n;
        let flow = |duration: f64| {
            let mut matrix = increments(kind, n, false, duration);
            for k in 0..w {
                matrix[k * (w + 1) + k] += DoubleDouble::of(1.0);
            }
            matrix
        };
        let [a, b, both, back] = [0.75, 0.5, 1.25, -0.75].map(flow);
        let norm = |m: &[DoubleDouble]| m.iter().fold(0.0_f64, |norm, entry| norm.max(entry.lane(0).abs()));
        let entry = |m: &[DoubleDouble], i: usize, j: usize| m[i * (w + 1) + j];
        // As above, with the products of the test itself.
        let near = |found: DoubleDouble, exact: DoubleDouble, scale: f64, what: &str| {
            let off = (found - exact).lane(0).abs();
            assert!(off <= scale * w as f64 * 2.0_f64.powi(-85), "{kind} {n}, {what}: {off:.1e}");
        };
        for i in 0..w {
            for j in 0..w {
                let zero = DoubleDouble::of(0.0);
                let sum = |of: &dyn Fn(usize) -> DoubleDouble| (0..w).fold(zero, |sum, k| sum + of(k));
                let product = |x: &[DoubleDouble], y: &[DoubleDouble]| sum(&|k| entry(x, i, k) * entry(y, k, j));
                near(product(&a, &b), entry(&both, i, j), norm(&a) * norm(&b), "group law");
                let unit = DoubleDouble::of(f64::from(u8::from(i == j)));
                near(product(&a, &back), unit, norm(&a) * norm(&back), "reversibility");
                // M^T J M = J.
                let area = sum(&|k| {
                    let (partner, sign) = if k < n { (n + k, 1.0) } else { (k - n, -1.0) };
                    entry(&a, k, i) * entry(&a, partner, j) * DoubleDouble::of(sign)
                });
                let exact = DoubleDouble::of(f64::from(u8::from(j == i + n)) - f64::from(u8::from(i == j + n)));
                near(area, exact, norm(&a) * norm(&a), "area");
            }
        }
    }
}

#[test]
fn blocks_are_what_couples_and_equal_ones_share_a_matrix() {
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
fn durations_of_a_composition_are_found_by_one_look() {
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
fn durations_without_end_are_forgotten() {
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
    let steps = 10_000_000;
    // A step rounds four products, their sums and the state, each by half an ulp of the radius or less in either
    // direction: an ulp of energy for each of them is far above what they add up to. With entries rounded to f64, or with
    // a second part of the last digits alone, the second of these is off by 1e-10 and more.
    let walk = 8.0 * f64::from(steps).sqrt() * f64::EPSILON;
    for at in [[0.1, 1.0], [1.3, 3.3]] {
        let plain = off::<f64>(|x| x, |x| x, at, steps);
        assert!(plain <= walk, "{at:?}: {plain:.1e}");
        let compensated = off::<Compensated<f64>>(|x| Compensated { value: x, carried: 0.0 }, |x| x.value, at, steps);
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
