//! Tests of chains of adaptors over coordinates of every length from 0 to 7: all chains up to a depth of two, and every
//! seventh one of a depth of three. The interpreted sum has the same value as that of the iterators of `std`.

use crate::{
    errors::Errors,
    graph::evaluate::Point,
    model::{Model, model},
    syntax,
};
use proc_macro2::TokenStream;

/// The items of a sequence, each with the numbers that it is made of.
type Items = Vec<Vec<f64>>;

/// What may stand after a sequence: its text, the pattern of an item by that of the item before, and what `std` makes of
/// the items, given all coordinates and a list of the system.
struct Adaptor {
    text: &'static str,
    pattern: fn(&str, usize) -> String,
    of: fn(Items, &[f64], usize) -> Items,
}

fn same(pattern: &str, _: usize) -> String {
    pattern.to_owned()
}

fn pair(pattern: &str, fresh: usize) -> String {
    format!("({pattern}, x{fresh})")
}

fn paired(items: Items, others: impl Iterator<Item = f64>) -> Items {
    items.into_iter().zip(others).map(|(item, other)| [item, vec![other]].concat()).collect()
}

const ADAPTORS: [Adaptor; 15] = [
    Adaptor { text: ".skip(1)", pattern: same, of: |items, _, _| items.into_iter().skip(1).collect() },
    Adaptor { text: ".skip(5)", pattern: same, of: |items, _, _| items.into_iter().skip(5).collect() },
    Adaptor { text: ".take(2)", pattern: same, of: |items, _, _| items.into_iter().take(2).collect() },
    Adaptor { text: ".take(6)", pattern: same, of: |items, _, _| items.into_iter().take(6).collect() },
    Adaptor {
        text: ".take(self.list.len())",
        pattern: same,
        of: |items, _, list| items.into_iter().take(list).collect(),
    },
    Adaptor {
        text: ".skip(self.list.len())",
        pattern: same,
        of: |items, _, list| items.into_iter().skip(list).collect(),
    },
    Adaptor { text: ".step_by(2)", pattern: same, of: |items, _, _| items.into_iter().step_by(2).collect() },
    Adaptor { text: ".step_by(3)", pattern: same, of: |items, _, _| items.into_iter().step_by(3).collect() },
    Adaptor { text: ".rev()", pattern: same, of: |items, _, _| items.into_iter().rev().collect() },
    Adaptor { text: ".zip(q.iter())", pattern: pair, of: |items, q, _| paired(items, q.iter().copied()) },
    Adaptor {
        text: ".zip(q.iter().skip(1))",
        pattern: pair,
        of: |items, q, _| paired(items, q.iter().copied().skip(1)),
    },
    Adaptor {
        text: ".zip(q.iter().rev().take(3))",
        pattern: pair,
        of: |items, q, _| paired(items, q.iter().copied().rev().take(3)),
    },
    Adaptor {
        text: ".zip(1..4)",
        pattern: |pattern, fresh| format!("({pattern}, n{fresh})"),
        of: |items, _, _| paired(items, [1.0, 2.0, 3.0].into_iter()),
    },
    Adaptor {
        text: ".zip(&self.list)",
        pattern: |pattern, _| format!("({pattern}, _)"),
        of: |items, _, list| items.into_iter().take(list).collect(),
    },
    Adaptor {
        text: ".enumerate()",
        pattern: |pattern, fresh| format!("(n{fresh}, {pattern})"),
        of: |items, _, _| (0..).zip(items).map(|(n, item)| [vec![f64::from(n)], item].concat()).collect(),
    },
];

/// What a chain begins with.
struct Source {
    text: &'static str,
    pattern: &'static str,
    items: fn(&[f64], usize) -> Items,
}

const SOURCES: [Source; 7] = [
    Source { text: "q.iter()", pattern: "x0", items: |q, _| q.iter().map(|x| vec![*x]).collect() },
    Source { text: "q.windows(2)", pattern: "[x0, y0]", items: |q, _| q.windows(2).map(<[f64]>::to_vec).collect() },
    Source {
        text: "q.windows(4)",
        pattern: "[x0, _, _, y0]",
        items: |q, _| q.windows(4).map(|window| vec![window[0], window[3]]).collect(),
    },
    Source {
        text: "q.chunks_exact(2)",
        pattern: "[x0, y0]",
        items: |q, _| q.chunks_exact(2).map(<[f64]>::to_vec).collect(),
    },
    Source { text: "(2..5)", pattern: "n0", items: |_, _| (2..5).map(|n| vec![f64::from(n)]).collect() },
    Source {
        text: "(3..self.list.len())",
        pattern: "n0",
        items: |_, list| (3..list).map(|n| vec![n as f64]).collect(),
    },
    Source { text: "self.list.iter()", pattern: "_", items: |_, list| vec![Vec::new(); list] },
];

/// The names that a pattern binds, in order, each with what makes a number of it.
fn numbers(pattern: &str) -> Vec<String> {
    let names = pattern.split(|letter: char| !letter.is_alphanumeric()).filter(|name| !name.is_empty());
    names.map(|name| if name.starts_with('n') { format!("{name} as f64") } else { name.to_owned() }).collect()
}

/// The weight of the number with this place in an item: no sum of others that are exchanged, left out or repeated.
fn weight(place: usize) -> f64 {
    [1.0, 11.0, 101.0, 1009.0, 10007.0, 100_003.0][place]
}

/// A chain, how its items are taken apart, and its adaptors.
fn chains(depth: usize) -> Vec<(String, String, &'static Source, Vec<&'static Adaptor>)> {
    let mut all: Vec<_> =
        SOURCES.iter().map(|source| (source.text.to_owned(), source.pattern.to_owned(), source, Vec::new())).collect();
    let mut last = all.clone();
    for fresh in 1..=depth {
        let longer = last.iter().flat_map(|(text, pattern, source, adaptors)| {
            ADAPTORS.iter().map(move |adaptor| {
                let adaptors = adaptors.iter().copied().chain([adaptor]).collect();
                (format!("{text}{}", adaptor.text), (adaptor.pattern)(pattern, fresh), *source, adaptors)
            })
        });
        // Seven and the number of adaptors have no common divisor: every adaptor stands in every place.
        last = longer.step_by(if fresh < 3 { 1 } else { 7 }).collect();
        all.extend(last.iter().cloned());
    }
    all
}

/// The model of a sum over a chain, for coordinates of a type; as a chain or as a loop. The time, which is 1, keeps chains
/// without coordinates from being parameters.
fn read(kind: &str, chain: &str, pattern: &str, as_loop: bool) -> Model {
    let terms = numbers(pattern).into_iter().enumerate();
    let terms: String = terms.map(|(place, number)| format!(" + {:?} * ({number})", weight(place))).collect();
    let item = format!("(item as f64 + t) * (7.0{terms})");
    let body = if as_loop {
        format!("let mut v = 0.0; for (item, {pattern}) in {chain}.enumerate() {{ v += {item}; }} v")
    } else {
        format!("{chain}.enumerate().map(|(item, {pattern})| {item}).sum::<f64>()")
    };
    potential(kind, &body).unwrap_or_else(|error| panic!("{body}: {error}"))
}

/// The model of a system with this potential of coordinates of a type.
pub(in crate::model) fn potential(kind: &str, body: &str) -> syn::Result<Model> {
    let text = format!(
        "impl System {{ fn kinetic(&self, p: {kind}) -> f64 {{ 0.0 }} fn potential(&self, q: {kind}, t: f64) -> f64 {{ {body} }} }}"
    );
    let mut errors = Errors::default();
    let input = syntax::input(TokenStream::new(), text.parse().expect("tokens"), &mut errors).expect("an impl");
    let model = model(&input, &mut errors);
    errors.combined().map_or_else(|| Ok(model.expect("a model")), Err)
}

/// Holds the energy that was read against that of the items.
fn check(model: &Model, what: &str, q: &[f64], list: usize, items: &Items) {
    let lists = vec![list as f64; model.parameters.len()];
    let item = |(number, item): (usize, &Vec<f64>)| {
        let terms: f64 = item.iter().enumerate().map(|(place, x)| weight(place) * x).sum();
        (number as f64 + 1.0) * (7.0 + terms)
    };
    let expected: f64 = items.iter().enumerate().map(item).sum();
    let found = Point { parameters: &lists, ..Point::new(q, &[]) }.value(&model.graph, model.potential);
    // Whole numbers below 2^53: there is no rounding.
    assert_eq!(found, expected, "{what} over {q:?} with {list} in the list");
}

const LENGTHS: std::ops::Range<usize> = 0..8;

fn coordinates(length: usize) -> Vec<f64> {
    (0..length).map(|place| [3.0, 17.0, 5.0, 29.0, 2.0, 43.0, 13.0][place]).collect()
}

fn items(source: &Source, adaptors: &[&Adaptor], q: &[f64], list: usize) -> Items {
    adaptors.iter().fold((source.items)(q, list), |items, adaptor| (adaptor.of)(items, q, list))
}

#[test]
fn chains_over_slices_have_the_items_of_std() {
    for (text, pattern, source, adaptors) in chains(3) {
        let model = read("&[f64]", &text, &pattern, false);
        for length in LENGTHS {
            let (q, list) = (coordinates(length), (3 * length + adaptors.len()) % 6);
            check(&model, &text, &q, list, &items(source, &adaptors, &q, list));
        }
    }
}

#[test]
fn chains_over_arrays_have_the_items_of_std() {
    // The text is read again for every length: every third chain.
    for (text, pattern, source, adaptors) in chains(2).into_iter().step_by(3) {
        for length in LENGTHS {
            let model = read(&format!("[f64; {length}]"), &text, &pattern, false);
            let q = coordinates(length);
            for list in 0..6 {
                check(&model, &text, &q, list, &items(source, &adaptors, &q, list));
            }
        }
    }
}

#[test]
fn loops_over_chains_have_the_items_of_std() {
    for (text, pattern, source, adaptors) in chains(2) {
        let model = read("&[f64]", &text, &pattern, true);
        for length in LENGTHS {
            let q = coordinates(length);
            for list in 0..6 {
                check(&model, &text, &q, list, &items(source, &adaptors, &q, list));
            }
        }
    }
}
