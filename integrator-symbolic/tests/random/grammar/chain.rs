//! Chains of iterators.

use super::{Grammar, PARTS, Scope};

/// What an iterator yields.
#[derive(Clone)]
enum Item {
    Number,
    /// An index; of the coordinates where they have so many.
    Index {
        of_coordinates: bool,
    },
    /// So many neighbouring numbers, or points.
    Part(usize),
    Point,
    Bond,
    Both(Box<Item>, Box<Item>),
}

impl Grammar {
    /// A chain, the pattern of its items, and the scope behind the pattern.
    pub(super) fn chain(&mut self, scope: &Scope) -> (String, String, Scope) {
        let (mut text, mut item) = self.source(scope);
        for _ in 0..self.choices.below(if PARTS.bounds { 4 } else { 0 }) {
            (text, item) = self.adapted(scope, text, item);
        }
        let mut inner = scope.clone();
        let pattern = self.pattern(&item, &mut inner);
        (text, pattern, inner)
    }

    /// The sum over a chain.
    pub(super) fn chain_value(&mut self, scope: &Scope, depth: usize) -> String {
        let (mut chain, pattern, mut inner) = self.chain(scope);
        inner.loops += 1;
        if self.choices.percent(10) {
            let condition = self.condition(&inner, 0);
            // A filter sees one reference more.
            chain = format!("{chain}.filter(|&{pattern}| {condition})");
        }
        let value = self.number(&inner, depth);
        match self.choices.below(8) {
            0 => {
                let name = self.fresh("s");
                format!("{chain}.fold(0.0, |{name}, {pattern}| {name} + {value})")
            }
            _ => format!("{chain}.map(|{pattern}| {value}).sum::<f64>()"),
        }
    }

    fn source(&mut self, scope: &Scope) -> (String, Item) {
        let n = self.length_text(scope);
        let q = self.letter;
        let coordinates = if self.dimension.is_some() { Item::Point } else { Item::Number };
        match self.choices.below(14) {
            0..=3 if scope.has_coordinates => (format!("{q}.iter()"), coordinates),
            4 | 5 => (format!("(0..{n})"), Item::Index { of_coordinates: true }),
            6 => (format!("(1..{n})"), Item::Index { of_coordinates: true }),
            7 => (format!("(0..{})", self.choices.below(5)), Item::Index { of_coordinates: false }),
            8 if scope.has_coordinates && self.dimension.is_none() => {
                let size = 1 + self.choices.below(3);
                (format!("{q}.windows({size})"), Item::Part(size))
            }
            9 if scope.has_coordinates && self.dimension.is_none() => {
                let size = 1 + self.choices.below(3);
                (format!("{q}.chunks_exact({size})"), Item::Part(size))
            }
            10 => ("self.bonds.iter()".to_owned(), Item::Bond),
            11 if self.choices.percent(30) => {
                let values: Vec<_> = (0..1 + self.choices.below(3)).map(|_| self.number(scope, 0)).collect();
                (format!("[{}].iter()", values.join(", ")), Item::Number)
            }
            _ => (format!("self.{}.iter()", self.choices.of(&["k", "long", "short"])), Item::Number),
        }
    }

    fn adapted(&mut self, scope: &Scope, text: String, item: Item) -> (String, Item) {
        match self.choices.below(8) {
            0 => (format!("{text}.rev()"), item),
            1 | 2 => (format!("{text}.skip({})", self.choices.below(5)), item),
            3 => (format!("{text}.take({})", self.choices.below(5)), item),
            4 => (format!("{text}.step_by({})", 1 + self.choices.below(3)), item),
            5 => {
                let of_coordinates = text.starts_with(&format!("{}.iter()", self.letter));
                (format!("{text}.enumerate()"), Item::Both(Box::new(Item::Index { of_coordinates }), Box::new(item)))
            }
            _ => {
                let (mut other, mut of) = self.source(scope);
                if self.choices.percent(40) {
                    (other, of) = self.adapted(scope, other, of);
                }
                (format!("{text}.zip({other})"), Item::Both(Box::new(item), Box::new(of)))
            }
        }
    }

    fn pattern(&mut self, item: &Item, scope: &mut Scope) -> String {
        match item {
            Item::Number => {
                let name = self.fresh("x");
                scope.numbers.extend([name.clone(), name.clone()]);
                format!("&{name}")
            }
            Item::Index { of_coordinates } => {
                let name = self.fresh("i");
                if *of_coordinates { &mut scope.indices } else { &mut scope.integers }.push(name.clone());
                name
            }
            Item::Part(size) => {
                let name = self.fresh("part");
                scope.arrays.extend([(name.clone(), *size), (name.clone(), *size)]);
                name
            }
            Item::Point => {
                let names: Vec<String> = (0..self.dimension.unwrap_or(1)).map(|_| self.fresh("x")).collect();
                scope.numbers.extend(names.clone());
                format!("&[{}]", names.join(", "))
            }
            Item::Bond => {
                let (i, j) = (self.fresh("i"), self.fresh("j"));
                scope.indices.extend([i.clone(), j.clone()]);
                format!("&({i}, {j})")
            }
            Item::Both(a, b) => {
                let (a, b) = (self.pattern(a, scope), self.pattern(b, scope));
                format!("({a}, {b})")
            }
        }
    }
}
