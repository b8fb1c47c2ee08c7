//! Tests that arrays filled by loops have the same values as in Rust, wherever they are read.
#![allow(clippy::explicit_iter_loop, clippy::needless_range_loop, reason = "the language of H")]

use crate::{graph::evaluate::Point, model::loops::sequence::tests::potential};

macro_rules! rows {
    ($(|$q:ident| $body:block),+ $(,)?) => {
        [$((stringify!($body), |$q: [f64; 5]| $body)),+]
    };
}

/// A function as text and as what it is.
type Row = (&'static str, fn([f64; 5]) -> f64);

const ROWS: [Row; 20] = rows![
    |q| {
        let mut h = [0.0; 32];
        for k in 0..32 {
            let mut s = 0.25 * k as f64;
            for i in 0..5 {
                s += (i + k) as f64 * q[i];
            }
            h[k] = s.tanh();
        }
        let mut v = 0.0;
        for k in 0..32 {
            v += h[k] * h[31 - k];
        }
        v
    },
    |q| {
        let mut h = [0.5; 20];
        for k in 0..20 {
            for i in 0..5 {
                h[k] += q[i] * k as f64;
            }
        }
        h.iter().zip(h.iter().skip(1)).map(|(a, b)| a * b).sum::<f64>()
    },
    |q| {
        let mut h = [0.5; 20];
        for k in 3..17 {
            h[k] = q[k % 5];
        }
        let mut v = h[2] + h[3] + h[16] + h[17];
        for k in 0..20 {
            v += h[k] * k as f64;
        }
        v
    },
    |q| {
        let mut h = [1.0; 20];
        for k in 2..20 {
            h[k] *= q[k % 5];
        }
        for k in 0..18 {
            h[k] = h[k] * h[k] + 1.0;
        }
        let mut v = 0.0;
        for x in h {
            v += x * x;
        }
        v
    },
    |q| {
        let mut h = [0.0; 20];
        let mut v = 0.0;
        for (k, x) in q.iter().enumerate() {
            h[k] = x * x;
            v += h[k] * k as f64;
        }
        v + h[1] + h[7] + h.iter().sum::<f64>()
    },
    |q| {
        let (mut a, mut b) = ([0.0; 20], [1.0; 20]);
        for k in 0..20 {
            a[k] = q[k % 5];
            b[k] += a[k] * a[k];
        }
        let mut v = 0.0;
        for k in 0..20 {
            v += a[k] / b[(k + 1) % 20];
        }
        v
    },
    |q| {
        let mut r = [[0.0; 20]; 20];
        for i in 0..20 {
            for j in 0..20 {
                r[i][j] = q[i % 5] - (j as f64) * q[j % 5];
            }
        }
        let mut v = 0.0;
        for i in 0..20 {
            for j in 0..i {
                v += r[i][j] * r[j][i];
            }
        }
        v
    },
    |q| {
        let mut d = [[0.0; 2]; 20];
        for i in 0..20 {
            for c in 0..2 {
                d[i][c] = q[(i + c) % 5];
            }
        }
        let mut v = 0.0;
        for i in 0..20 {
            v += d[i][0] * d[i][1];
        }
        v
    },
    |q| {
        let mut h = [0.0; 20];
        for k in 0..20 {
            if k == 7 {
                continue;
            }
            h[k] = q[k % 5];
        }
        let mut v = h[7] + h[8];
        for k in 0..20 {
            v += h[k];
        }
        v
    },
    |q| {
        let mut h = [1.0; 20];
        if q[0] > 0.5 {
            for k in 0..20 {
                h[k] = q[k % 5];
            }
        }
        let mut g = [1.0; 20];
        if q[0] > 1.5 {
            for k in 0..20 {
                g[k] = q[k % 5];
            }
        }
        let mut v = 0.0;
        for k in 0..20 {
            v += h[k] * g[k];
        }
        v
    },
    |q| {
        let scale = 2.0;
        let s: Vec<f64> = q.iter().map(|x| x * scale).collect();
        let scale = 3.0;
        let mut v = s[4];
        for i in 0..5 {
            v += s[i] * s[(i + 1) % 5];
        }
        v * scale
    },
    |q| {
        let s = q.map(|x| x * x);
        let [a, _, b, _, _] = s;
        a * b + s.iter().sum::<f64>()
    },
    |q| {
        let h: [f64; 24] = std::array::from_fn(|k| q[k % 5] * k as f64);
        h.iter().map(|x| x.cos()).sum::<f64>() * h.len() as f64
    },
    |q| {
        let n = q.len();
        let mut h = vec![0.0; n];
        for k in 0..n {
            h[k] = q[k] * q[n - 1 - k];
        }
        h[0] + h.iter().map(|x| x * x).sum::<f64>()
    },
    |q| {
        let s = [q[0]; 20];
        let mut v = 0.0;
        for i in 0..20 {
            v += s[i] * i as f64;
        }
        for x in s {
            v += x * x;
        }
        v
    },
    |q| {
        let part = &[q[0], q[1], q[2]][1..];
        let mut v = 0.0;
        for i in 0..2 {
            v += part[i] * i as f64;
        }
        v + part[0]
    },
    |q| {
        let mut v = 0.0;
        for j in 0..5 {
            let mut h = [0.0; 20];
            for k in 0..20 {
                h[k] = q[j] * (k as f64 - q[k % 5]);
            }
            for k in 0..20 {
                v += h[k] * h[k];
            }
        }
        v
    },
    |q| {
        let mut h = [1.0; 20];
        for (k, h) in h.iter_mut().enumerate() {
            *h += k as f64 * q[k % 5];
        }
        let mut v = h[3];
        for h in h {
            v += h * h;
        }
        v
    },
    |q| {
        let mut h = [0.5; 24];
        for (x, (y, k)) in h.iter_mut().zip(q.iter().zip(1..4)) {
            *x *= y * k as f64;
            *x += 1.0;
        }
        h[1] * h[2] * h[3] + h.iter().sum::<f64>()
    },
    |q| {
        let mut h = [q[0], q[1], q[2], q[3], q[4]];
        for x in &mut h {
            *x = x.cos();
        }
        let mut g = [0.25; 4];
        for g in g.iter_mut() {
            *g = 2.0 * *g * h[0];
        }
        h[1] * h[4] + g[3]
    },
];

const Q: [f64; 5] = [0.7, -1.3, 0.4, 2.1, -0.2];

/// Some 400 terms, each of about ten operations, rounded in another order: at most 400 roundings of the largest sum and
/// ten of each term, of numbers that are a hundred times the result where they cancel.
const TOLERANCE: f64 = 400.0 * 110.0 * f64::EPSILON;

#[test]
fn filled_arrays_have_the_values_of_rust() {
    for (text, value) in ROWS {
        let expected = value(Q);
        let model = potential("[f64; 5]", &format!("let v = {text}; v + 0.0 * t"))
            .unwrap_or_else(|error| panic!("{text}: {error}"));
        let found = Point::new(&Q, &[]).value(&model.graph, model.potential);
        assert!((found - expected).abs() <= TOLERANCE * expected.abs().max(1.0), "{text}: {found} for {expected}");
    }
}

/// The text is read once for every place that reads an element, not once for every element.
#[test]
fn the_graph_does_not_grow_with_the_array() {
    let nodes = |units: u32| {
        let body = format!(
            "let mut h = [0.0; {units}]; for k in 0..{units} {{ let mut s = t; for x in q {{ s += k as f64 * x; }} h[k] = s.tanh(); }} \
             let mut v = 0.0; for k in 0..{units} {{ v += h[k]; }} v"
        );
        potential("[f64; 5]", &body).expect("a model").graph.len()
    };
    assert_eq!(nodes(32), nodes(256));
}
