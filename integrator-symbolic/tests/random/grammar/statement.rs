//! Statements: variables, arrays, branches, and loops that add up.

use super::{Grammar, PARTS, Scope};

impl Grammar {
    pub(super) fn statement(&mut self, scope: &mut Scope, depth: usize) -> String {
        match self.choices.below(20) {
            0..=3 => {
                let (name, value) = (self.fresh("v"), self.number(scope, depth));
                scope.numbers.push(name.clone());
                format!("let {name} = {value};\n")
            }
            4 => {
                let (name, value) = (self.fresh("v"), self.number(scope, depth));
                let mut inner = scope.clone();
                inner.numbers.push(name.clone());
                let (operator, by) = (self.choices.of(&["+=", "-=", "*=", "="]), self.number(&inner, 1));
                scope.numbers.push(name.clone());
                format!("let mut {name} = {value}; {name} {operator} {by};\n")
            }
            5 => {
                let (name, value) = (self.fresh("v"), self.number(scope, depth));
                let (condition, by, other) = (self.condition(scope, 1), self.number(scope, 1), self.number(scope, 1));
                scope.numbers.push(name.clone());
                let other =
                    if self.choices.percent(50) { format!("else {{ {name} -= {other}; }}") } else { String::new() };
                format!("let mut {name} = {value}; if {condition} {{ {name} += {by}; }} {other}\n")
            }
            6 => {
                let count = 1 + self.choices.below(3);
                let (name, values) = (self.fresh("list"), self.several(scope, count));
                scope.arrays.push((name.clone(), count));
                format!("let {name} = [{values}];\n")
            }
            7 => {
                let (a, b) = (self.fresh("v"), self.fresh("v"));
                let values = self.several(scope, 2);
                let text = match self.choices.below(3) {
                    0 => format!("let [{a}, {b}] = [{values}];\n"),
                    1 => format!("let ({a}, {b}) = ({values});\n"),
                    _ => format!("let ({a}, {b}) = ({}).sin_cos();\n", self.number(scope, 1)),
                };
                scope.numbers.extend([a, b]);
                text
            }
            8 if scope.has_coordinates => self.sums_in_an_array(scope),
            _ if scope.has_coordinates => self.sum(scope, depth),
            _ => {
                let (name, value) = (self.fresh("v"), self.number(scope, depth));
                scope.numbers.push(name.clone());
                format!("let {name} = {value};\n")
            }
        }
    }

    fn several(&mut self, scope: &Scope, count: usize) -> String {
        (0..count).map(|_| self.number(scope, 1)).collect::<Vec<_>>().join(", ")
    }

    /// An array whose elements are added to in a loop.
    fn sums_in_an_array(&mut self, scope: &mut Scope) -> String {
        let (name, mut inner) = (self.fresh("list"), scope.clone());
        let head = self.head(&mut inner);
        let (a, b) = (self.number(&inner, 1), self.number(&inner, 1));
        scope.arrays.push((name.clone(), 2));
        format!("let mut {name} = [0.0; 2]; for {head} {{ {name}[0] += {a}; {name}[1] -= {b}; }}\n")
    }

    /// A loop that adds up.
    fn sum(&mut self, scope: &mut Scope, depth: usize) -> String {
        let name = self.fresh("z");
        let start = self.choices.of(&["0.0", "0.0", "1.0", "self.a"]);
        let mut inner = scope.clone();
        let head = self.head(&mut inner);
        let body = self.body(inner, &name, depth);
        scope.numbers.push(name.clone());
        format!("let mut {name} = {start}; for {head} {{ {body} }}\n")
    }

    /// What a loop does: names, exceptions, addends, loops inside.
    fn body(&mut self, mut scope: Scope, sum: &str, depth: usize) -> String {
        let mut text = String::new();
        if !scope.indices.is_empty() && self.choices.percent(15) {
            let condition = self.condition(&Scope { numbers: Vec::new(), ..scope.clone() }, 0);
            let before =
                if self.choices.percent(30) { format!("{sum} += {}; ", self.number(&scope, 0)) } else { String::new() };
            text += &format!("if {condition} {{ {before}continue; }} ");
        }
        if PARTS.guards && self.choices.percent(20) {
            let (guard, place) = self.guard(&scope);
            text += &format!("if !({guard}) {{ continue; }} ");
            scope.numbers.extend([place.clone(), place]);
        }
        if self.choices.percent(30) {
            let (name, value) = (self.fresh("l"), self.number(&scope, depth.saturating_sub(1)));
            text += &format!("let {name} = {value}; ");
            scope.numbers.push(name);
        }
        if !scope.indices.is_empty() && self.choices.percent(20) {
            let (name, value) = (self.fresh("m"), self.index(&scope));
            text += &format!("let {name} = {value}; ");
            scope.indices.push(name);
        }
        let count = 1 + self.choices.below(2);
        for position in 1..=count {
            let operator = self.choices.of(&["+=", "+=", "-="]);
            match self.choices.below(10) {
                0..=2 if scope.loops < 3 => {
                    let mut inner = scope.clone();
                    let head = self.head(&mut inner);
                    let body = self.body(inner, sum, depth.saturating_sub(1));
                    text += &format!("for {head} {{ {body} }} ");
                }
                3 | 4 if PARTS.guards => {
                    let (guard, place) = self.guard(&scope);
                    let mut inner = scope.clone();
                    inner.numbers.extend([place.clone(), place.clone()]);
                    let value = self.number(&inner, depth);
                    text += &format!("if {guard} {{ {sum} {operator} {place} * {value}; }} ");
                }
                5 => {
                    let (condition, value) = (self.condition(&scope, 1), self.number(&scope, depth));
                    let mut skip = String::new();
                    if position == count && self.choices.percent(30) {
                        skip = format!("if {} {{ continue; }} ", self.condition(&scope, 0));
                    }
                    text += &format!("if {condition} {{ {skip}{sum} {operator} {value}; }} ");
                }
                _ => text += &format!("{sum} {operator} {}; ", self.number(&scope, depth)),
            }
        }
        text
    }

    /// What is there in the iterations of a loop that may have none: elements of lists, and a coordinate that is not
    /// there where others are few.
    fn read_in_iterations(&mut self, scope: &mut Scope, elements: &[&str]) {
        let coordinate = self.choices.below(self.length).to_string();
        let numbers = elements.iter().map(ToString::to_string).chain([self.coordinate_at(&coordinate)]);
        scope.numbers.extend(numbers.filter(|_| PARTS.guards));
    }

    /// The head of a loop over integers of a type that the system gives.
    fn typed_head(&mut self, scope: &mut Scope) -> String {
        let outer = scope.integers.iter().rev().find(|name| name.starts_with("signed_k")).cloned();
        let (name, range) = match (self.choices.below(6), outer) {
            (0, Some(outer)) => ("signed_k", format!("-{outer}..={outer}")),
            (1, Some(outer)) => ("signed_k", format!("{outer}..=self.kmax")),
            (0 | 1, None) => ("signed_k", "0..=self.kmax".to_owned()),
            (2, _) => ("signed_k", "-self.kmax..=self.kmax".to_owned()),
            (3, _) => ("signed_k", "self.kmax - 2..=self.kmax".to_owned()),
            (4, _) => ("byte", "1..=self.lmax".to_owned()),
            _ => ("signed_k", "0..self.kmax + 1".to_owned()),
        };
        let name = self.fresh(name);
        scope.integers.push(name.clone());
        format!("{name} in {range}")
    }

    /// The head of a loop; its names enter the scope.
    fn head(&mut self, scope: &mut Scope) -> String {
        scope.loops += 1;
        let n = self.length_text(scope);
        let outer = (!scope.bounds.is_empty()).then(|| scope.bounds[self.choices.below(scope.bounds.len())].clone());
        let i = self.fresh("i");
        if let Some(outer) = outer
            && self.choices.percent(50)
        {
            scope.indices.push(i.clone());
            scope.bounds.push(i.clone());
            return match self.choices.below(4) {
                0 => format!("{i} in 0..{outer}"),
                1 => format!("{i} in {outer} + 1..{n}"),
                2 => format!("{i} in 0..={outer}"),
                _ => format!("{i} in (0..{outer}).rev()"),
            };
        }
        if PARTS.integers && self.choices.percent(12) {
            return self.typed_head(scope);
        }
        let range = match self.choices.below(18) {
            0..=4 => format!("0..{n}"),
            5 => format!("1..{n}"),
            6 => format!("(0..{n}).rev()"),
            7 => format!("(0..{n}).step_by(2)"),
            8 => "0..self.n".to_owned(),
            9 if PARTS.bounds => {
                self.read_in_iterations(scope, &["self.k[self.n - 1]", "self.long[self.n]"]);
                format!("{}..self.n", 1 + self.choices.below(3))
            }
            10 => format!("0..{n} / 2"),
            11 if PARTS.integers => {
                let name = self.fresh("signed");
                scope.integers.push(name.clone());
                return format!("{name} in {}..{}", self.choices.below(2), 2 + self.choices.below(3));
            }
            12 | 13 => {
                let j = self.fresh("j");
                scope.indices.extend([i.clone(), j.clone()]);
                if self.choices.percent(50) {
                    return format!("&({i}, {j}) in &self.bonds");
                }
                let w = self.fresh("w");
                scope.numbers.push(w.clone());
                return format!("&({i}, {j}, {w}) in &self.springs");
            }
            14 if PARTS.guards => {
                self.read_in_iterations(scope, &["self.short[0]", "self.short[self.short.len() - 1]"]);
                let x = self.fresh("x");
                scope.numbers.push(x.clone());
                return format!("&{x} in self.short.iter()");
            }
            _ => {
                let (chain, pattern, inner) = self.chain(scope);
                *scope = inner;
                return format!("{pattern} in {chain}");
            }
        };
        scope.indices.push(i.clone());
        scope.bounds.push(i.clone());
        format!("{i} in {range}")
    }
}
