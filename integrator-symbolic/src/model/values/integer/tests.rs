//! Tests that integers behave as in Rust: energies over them have the same values as the same source compiled as code.

use crate::{graph::evaluate::Point, model::loops::sequence::tests::potential};

const Q: [f64; 4] = [0.7, -1.3, 0.4, 2.1];

/// A body as text, and its value as code.
macro_rules! rows {
    ($q:ident: $($body:block)+) => {
        [$((stringify!($body), (|$q: [f64; 4]| -> f64 { $body })(Q))),+]
    };
}

#[test]
#[allow(clippy::needless_range_loop, clippy::unnecessary_cast, reason = "rows are written as users write H")]
fn energies_over_integers_are_those_of_the_code() {
    let rows = rows! { q:
        { let mut v = 0.0; for i in 0..4 { v += (i as i32 - 2) as f64 * q[i]; } v }
        { let mut v = 0.0; for i in 0..4 { v += q[i as usize] * q[((i - 1 + 4) % 4) as usize]; } v }
        { let mut v = 0.0; for k in 0..5 { v += (k - 2) as f64 * q[1]; } v }
        { let mut v = 0.0; for k in -2..3 { v += k as f64 * q[((k + 2) % 4) as usize]; } v }
        { let mut v = 0.0; for k in -2_i32..=2 { v += f64::from(k) * q[0].powi(2); } v }
        { let mut v = 0.0; for i in 0..4_i32 { for k in i - 1..=i + 1 { v += q[i as usize] * q[((k + 4) % 4) as usize]; } } v }
        { let mut v = 0.0; for i in 250..260 { v += (i as u8) as f64 * q[0]; } v }
        { let mut v = 0.0; for i in 120..140 { v += (i as i8) as f64 * q[0]; } v }
        { let mut v = 0.0; for i in 0..4 { v += -(i as f64) * q[i] + (-(i as i64)) as f64 * q[i]; } v }
        { let mut v = 0.0; for i in 0..4 { if i as i32 - 2 < 0 { v += q[i]; } } v }
        { let mut v = 0.0; for i in 0..4 { for _j in i + 1..3 { v += q[i]; } } v }
        { let mut v = 0.0; for i in 0..4_usize { for j in 0..i.saturating_sub(1).min(2) { v += q[i] * q[j]; } } v }
        { let mut v = 0.0; for i in 0..4 { for j in 0..3 - i { v += q[i] * q[j]; } } v }
        { let mut v = 0.0; for n in 0..4 { v += q[0].powi(n as i32) + q[3].powi(2 - n as i32); } v }
        { (0..4).map(|i| ((i as i64 - 5) / 2 * 2 + (i as i64 - 5) % 3) as f64 * q[i]).sum::<f64>() }
        { (0..4_usize).map(|i| (i ^ 1) as f64 * q[i] * q[i ^ 1]).sum::<f64>() }
        { let mut v = 0.0; for i in 0..8_usize { v += (i & 1) as f64 * q[i >> 1] + q[(i << 1) & 3]; } v }
        { let mut v = 0.0; for i in 0..4_u32 { for j in 0..4_u32 { if (i + j) & 1 == 0 { v += (i ^ 1) as f64 * q[j as usize]; } } } v }
        { (1..4).map(|i| (i - 1) as f64 * q[i] * q[i - 1]).sum::<f64>() }
    };
    for (text, expected) in rows {
        let text = text.trim().trim_start_matches('{').trim_end_matches('}');
        let model = potential("[f64; 4]", text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let found = Point::new(&Q, &[]).value(&model.graph, model.potential);
        // Tens of additions of numbers up to 255 in another order.
        assert!((found - expected).abs() <= 1e4 * f64::EPSILON, "{text}: {found} for {expected}");
    }
}
