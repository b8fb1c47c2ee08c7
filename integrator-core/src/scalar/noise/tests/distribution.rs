//! The distribution of normal numbers, and whether neighbours depend on each other.

use super::{Bad, Checks, LEVEL, STANDARD_ERRORS, counter_along, draws, failures};
use crate::scalar::noise::gaussians;
use core::f64::consts::FRAC_1_SQRT_2;

/// Two numbers of a counter.
type Pairs<'a> = &'a dyn Fn([u32; 4]) -> [f64; 2];

/// The numbers under test.
fn good(counter: [u32; 4]) -> [f64; 2] {
    gaussians::<f64>([0x1234_5678, 0x9abc_def0], |_: usize| counter)
}

/// Moments up to this order are tested.
const ORDERS: usize = 6;
/// Pairs up to this distance are compared.
const LAGS: usize = 8;
/// The distribution function is tested at this many points for each unit, up to eight.
const FINENESS: usize = 256;
/// Numbers beyond these are counted.
const FAR: [f64; 4] = [3.0, 4.0, 5.0, 6.0];

/// What is summed over all pairs.
struct Tally {
    pairs: usize,
    /// The sums of powers of the first numbers and of the second ones.
    powers: [[f64; ORDERS]; 2],
    /// How many lie in each interval.
    cells: [Vec<usize>; 2],
    beyond: [usize; FAR.len()],
    /// The sums of `x·y` and `(x² - 1)·(y² - 1)`.
    products: [f64; 2],
    /// By the word that counts and the distance of pairs, as complex numbers `z`: real and imaginary parts of `z₁*·z₂`, and
    /// `(|z₁|² - 2)·(|z₂|² - 2)`.
    lagged: [[[f64; 3]; LAGS]; 4],
}

/// Sums over pairs. Each word of the counter counts a quarter of them.
fn tally(pairs: Pairs<'_>, count: usize) -> Tally {
    let mut tally = Tally {
        pairs: count / 4 * 4,
        powers: [[0.0; ORDERS]; 2],
        cells: [vec![0; 16 * FINENESS + 2], vec![0; 16 * FINENESS + 2]],
        beyond: [0; FAR.len()],
        products: [0.0; 2],
        lagged: [[[0.0; 3]; LAGS]; 4],
    };
    for along in 0..4 {
        let mut before = [[0.0; 3]; LAGS];
        for number in 0..count / 4 {
            let pair = pairs(counter_along(along, number));
            for (place, x) in pair.into_iter().enumerate() {
                let mut power = 1.0;
                for sum in &mut tally.powers[place] {
                    power *= x;
                    *sum += power;
                }
                // The first cell has all below -8, the last one all above.
                let cell = ((x + 8.0) * FINENESS as f64 + 1.0).max(0.0) as usize;
                tally.cells[place][cell.min(16 * FINENESS + 1)] += 1;
                for (count, far) in tally.beyond.iter_mut().zip(FAR) {
                    *count += usize::from(x.abs() > far);
                }
            }
            let [x, y] = pair;
            tally.products[0] += x * y;
            tally.products[1] += (x * x - 1.0) * (y * y - 1.0);
            let now = [x, y, x * x + y * y - 2.0];
            for lag in 0..LAGS.min(number) {
                let then = before[(number - 1 - lag) % LAGS];
                let sums = &mut tally.lagged[along][lag];
                sums[0] += then[0] * now[0] + then[1] * now[1];
                sums[1] += then[0] * now[1] - then[1] * now[0];
                sums[2] += then[2] * now[2];
            }
            before[number % LAGS] = now;
        }
    }
    tally
}

/// The moment of a standard normal number: `(order - 1)!!` for even orders.
fn moment(order: usize) -> f64 {
    if order.is_multiple_of(2) { (1..order).step_by(2).map(|factor| factor as f64).product() } else { 0.0 }
}

/// Whether a count is so far from its expectation that its probability is below [`LEVEL`]: by Chernoff, a Poisson number is
/// `x` or farther out with a probability of at most `exp(-(x·ln(x/μ) - x + μ))`.
fn is_improbable(count: usize, expected: f64) -> bool {
    let x = count as f64;
    let logarithm = if count == 0 { 0.0 } else { x * (x / expected).ln() };
    logarithm - x + expected > -(0.5 * LEVEL).ln()
}

/// All checks of normal numbers.
///
/// A sum of `n` independent terms of variance `v` fails at five standard errors, `5·sqrt(n·v)`. The variances are:
///
/// | term | variance |
/// |---|---|
/// | `x^p` | `m(2p) - m(p)²` with the moments `m` |
/// | `x·y` | 1 |
/// | `(x² - 1)·(y² - 1)` | 4 |
/// | real or imaginary part of `z₁*·z₂` | 2 |
/// | `(|z₁|² - 2)·(|z₂|² - 2)` | 16 |
///
/// The distribution function fails by the inequality of Dvoretzky, Kiefer, Wolfowitz and Massart: the probability that it is
/// somewhere more than `d` from that of `n` numbers is at most `2·exp(-2·n·d²)`.
fn checks(pairs: Pairs<'_>, count: usize) -> Checks {
    let tally = tally(pairs, count);
    let n = tally.pairs as f64;
    let mut checks: Checks = Vec::new();
    let mut check = |name: String, holds: bool| match checks.iter_mut().find(|(other, _)| *other == name) {
        Some((_, both)) => *both &= holds,
        None => checks.push((name, holds)),
    };
    let within = |sum: f64, count: f64, variance: f64| sum.abs() <= STANDARD_ERRORS * (count * variance).sqrt();
    for powers in tally.powers {
        for (sum, order) in powers.into_iter().zip(1..) {
            let variance = moment(2 * order) - moment(order).powi(2);
            check(format!("moment {order}"), within(sum - n * moment(order), n, variance));
        }
    }
    for cells in &tally.cells {
        let (mut below, mut distance) = (0, 0.0_f64);
        for (edge, count) in cells[..cells.len() - 1].iter().enumerate() {
            below += count;
            let x = edge as f64 / FINENESS as f64 - 8.0;
            distance = distance.max((below as f64 / n - 0.5 * pxfm::f_erfc(-x * FRAC_1_SQRT_2)).abs());
        }
        check("distribution function".to_owned(), 2.0 * (-2.0 * n * distance * distance).exp() >= LEVEL);
    }
    for (count, far) in tally.beyond.into_iter().zip(FAR) {
        let expected = 2.0 * n * pxfm::f_erfc(far * FRAC_1_SQRT_2);
        check(format!("numbers beyond {far}"), !is_improbable(count, expected));
    }
    check("two numbers".to_owned(), within(tally.products[0], n, 1.0));
    check("squares of two numbers".to_owned(), within(tally.products[1], n, 4.0));
    for (along, lags) in tally.lagged.into_iter().enumerate() {
        for (lag, [real, imaginary, squares]) in (1..).zip(lags) {
            let terms = n / 4.0 - lag as f64;
            check(format!("lag {lag} in word {along}"), within(real, terms, 2.0));
            check(format!("turned, lag {lag} in word {along}"), within(imaginary, terms, 2.0));
            check(format!("squares, lag {lag} in word {along}"), within(squares, terms, 16.0));
        }
    }
    checks
}

#[test]
fn numbers_are_normal_and_independent() {
    let checks = checks(&good, draws() / 2);
    assert!(failures(&checks).is_empty(), "{:?}", failures(&checks));
}

/// A counter before another one along a word.
fn earlier(mut counter: [u32; 4], along: usize, by: usize) -> [u32; 4] {
    counter[along] = counter[along].wrapping_sub(by as u32);
    counter
}

#[test]
fn every_check_of_the_distribution_fails_for_some_bad_generator() {
    const COUNT: usize = 500_000;
    let each = |of: fn(f64) -> f64| move |counter| good(counter).map(of);
    let twelve = |counter: [u32; 4]| {
        [0, 1].map(|place| {
            let uniform = |key| super::rounds(10, counter, [key, place]).map(|word| f64::from(word) / 4_294_967_296.0);
            [0, 1, 2].map(|key| uniform(key).iter().sum::<f64>()).iter().sum::<f64>() - 6.0
        })
    };
    let table: [(&str, Pairs<'_>, &[&str]); 12] = [
        (
            "a constant",
            &|_| [0.5, 0.5],
            &[
                "moment 1",
                "moment 2",
                "distribution function",
                "numbers beyond 3",
                "two numbers",
                "squares, lag 1 in word 0",
            ],
        ),
        ("sums of twelve uniform numbers", &twelve, &["moment 4", "moment 6", "numbers beyond 3", "numbers beyond 4"]),
        ("a mean of 0.05", &each(|x| x + 0.05), &["moment 1", "moment 3", "moment 5", "distribution function"]),
        ("a deviation of 1.05", &each(|x| 1.05 * x), &["moment 2", "moment 4", "moment 6"]),
        ("no tails", &each(|x| x.clamp(-2.9, 2.9)), &["numbers beyond 3", "numbers beyond 4"]),
        (
            "an outlier in 65536",
            &|counter| good(counter).map(|x| if counter.map(|word| word & 0xffff).contains(&0x4321) { 7.0 } else { x }),
            &["numbers beyond 5", "numbers beyond 6"],
        ),
        ("a grid", &each(|x| (64.0 * x).floor() / 64.0 + 1.0 / 128.0), &["distribution function"]),
        (
            "equal numbers",
            &|counter| good(counter).map(|_| good(counter)[0]),
            &["two numbers", "squares of two numbers"],
        ),
        (
            "equal sizes",
            &|counter| {
                let [x, y] = good(counter);
                [x, x.abs().copysign(y)]
            },
            &["squares of two numbers"],
        ),
        ("no negative numbers", &each(f64::abs), &["moment 1", "moment 3", "moment 5", "lag 8 in word 3"]),
        ("a half of the circle", &|counter| good(counter).map(f64::abs), &["two numbers"]),
        (
            "one round",
            &|counter| {
                let words = super::rounds(1, counter, [5, 6]).map(u64::from);
                crate::scalar::noise::gaussian::of_words::<f64>(|_: usize| words)
            },
            &["distribution function"],
        ),
    ];
    let mut bad = Bad::default();
    for (name, pairs, expected) in table {
        bad.fails(name, &checks(pairs, COUNT), expected);
    }
    for along in 0..4 {
        for lag in 1..=LAGS {
            let sum = move |counter| {
                let [[a, b], [c, d]] = [good(counter), good(earlier(counter, along, lag))];
                [FRAC_1_SQRT_2 * (a + c), FRAC_1_SQRT_2 * (b + d)]
            };
            let turned = move |counter| {
                let [[a, b], [c, d]] = [good(counter), good(earlier(counter, along, lag))];
                [FRAC_1_SQRT_2 * (a + d), FRAC_1_SQRT_2 * (b - c)]
            };
            for (name, pairs) in [("lag", &sum as Pairs<'_>), ("turned, lag", &turned)] {
                let name = format!("{name} {lag} in word {along}");
                let squares = format!("squares, lag {lag} in word {along}");
                bad.fails(&name, &checks(pairs, 20_000), &[&name, &squares]);
            }
        }
    }
    bad.cover(&checks(&good, 4_000));
}
