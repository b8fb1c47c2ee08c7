//! Numbers, conditions, and what is only there behind a guard.

use super::{Grammar, PARTS, Scope, Signature};
use crate::bounded::{Arguments, functions_of};

impl Grammar {
    /// How many coordinates there are, as text.
    pub(super) fn length_text(&mut self, scope: &Scope) -> String {
        if scope.has_coordinates && (self.is_dynamic || self.choices.percent(40)) {
            format!("{}.len()", self.letter)
        } else if self.is_dynamic {
            "self.k.len()".to_owned()
        } else {
            self.length.to_string()
        }
    }

    fn literal(&mut self) -> String {
        let small = ["0.5", "1.0", "2.0", "3.0", "0.25", "1.5", "0.1", "0.0", "2.5", "(-1.0)"];
        if self.choices.percent(70) {
            let literal = self.choices.of(&small);
            return literal.to_owned();
        }
        let value = self.choices.between(0.0, 3.0);
        format!("{value:?}_f64")
    }

    /// An index of the coordinates.
    pub(super) fn index(&mut self, scope: &Scope) -> String {
        let fixed = PARTS.guards || !self.is_dynamic;
        if scope.indices.is_empty() || fixed && self.choices.percent(15) {
            return self.choices.below(self.length).to_string();
        }
        let known: Vec<&str> = scope.indices.iter().map(String::as_str).collect();
        let i = self.choices.of(&known).to_owned();
        let n = self.length_text(scope);
        let j = self.choices.of(&known).to_owned();
        match self.choices.below(14) {
            12 => format!("(self.index[{i}] + self.index[{j}]) % {n}"),
            13 => format!("(self.index[{i}] * {n} + self.index[{j}]) / {n}"),
            0 => format!("({i} + {}) % {n}", 1 + self.choices.below(3)),
            1 => format!("{n} - 1 - {i}"),
            2 => format!("self.index[{i}]"),
            3 => format!("{i} / 2"),
            4 => format!("(2 * {i} + 1) % {n}"),
            5 => format!("({i} + {n} - 1) % {n}"),
            _ => i,
        }
    }

    /// A coordinate at an index.
    pub(super) fn coordinate_at(&mut self, index: &str) -> String {
        match self.dimension {
            None => format!("{}[{index}]", self.letter),
            Some(dimension) => format!("{}[{index}][{}]", self.letter, self.choices.below(dimension)),
        }
    }

    fn leaf(&mut self, scope: &Scope) -> String {
        // A loop without iterations and a branch that is not taken need no coordinates.
        let known = PARTS.guards || !self.is_dynamic || !scope.indices.is_empty();
        match self.choices.below(14) {
            0..=4 if scope.has_coordinates && known => {
                let index = self.index(scope);
                self.coordinate_at(&index)
            }
            5 | 6 if !scope.integers.is_empty() || !scope.indices.is_empty() => self.integer_as_number(scope),
            7 if !scope.indices.is_empty() => {
                let index = self.index(scope);
                let list = self.choices.of(&["k", "long", "k", "rows"]);
                if list == "rows" { format!("self.rows[{index}][{index}]") } else { format!("self.{list}[{index}]") }
            }
            8 if !scope.arrays.is_empty() => {
                let (name, count) = scope.arrays[self.choices.below(scope.arrays.len())].clone();
                format!("{name}[{}]", self.choices.below(count))
            }
            9 => self.choices.of(&["self.a", "self.b", "self.c", "self.pos"]).to_owned(),
            10 => self.parameter(),
            11 => self.literal(),
            _ if !scope.numbers.is_empty() => scope.numbers[self.choices.below(scope.numbers.len())].clone(),
            _ => self.choices.of(&["self.a", "self.b", "self.c", "self.pos"]).to_owned(),
        }
    }

    /// A number that depends on parameters alone.
    fn parameter(&mut self) -> String {
        self.choices
            .of(&[
                "f64::from(self.flag)",
                "f64::from(self.power)",
                "(self.n as f64)",
                "(self.k.len() as f64)",
                "self.k.iter().copied().fold(0.0, f64::max)",
                "self.long[0]",
                "self.short.iter().sum::<f64>()",
            ])
            .to_owned()
    }

    /// Integers of several types on their way to a number.
    fn integer_as_number(&mut self, scope: &Scope) -> String {
        let known: Vec<&str> = scope.integers.iter().chain(&scope.indices).map(String::as_str).collect();
        let i = self.choices.of(&known).to_owned();
        if i.starts_with("signed") {
            let texts =
                [format!("(({i} - 2) as f64)"), format!("((({i} - 1 + 3) % 3) as f64)"), format!("({i} as f64)")];
            return texts[self.choices.below(3)].clone();
        }
        let others: Vec<&str> = scope.indices.iter().map(String::as_str).collect();
        if PARTS.integers && !others.is_empty() && self.choices.percent(40) {
            let (i, j) = (self.choices.of(&others).to_owned(), self.choices.of(&others).to_owned());
            return self.of_lists(&i, &j);
        }
        if i.starts_with("byte") {
            return self.choices.of(&["(BYTE as f64)", "f64::from(BYTE % 2)"]).replace("BYTE", &i);
        }
        match self.choices.below(if PARTS.integers { 10 } else { 0 }) {
            0 if PARTS.integers => format!("(({i} as i32 - 2) as f64)"),
            1 => format!("(({i} as u8) as f64)"),
            2 => format!("(({i} % 2) as f64)"),
            3 => format!("({i}.saturating_sub(1) as f64)"),
            4 => format!("((3 * {i} + 1) as f64)"),
            5 => format!("f64::from({i} as i32)"),
            _ => format!("({i} as f64)"),
        }
    }

    /// Integers of lists at two indices as a number.
    fn of_lists(&mut self, i: &str, j: &str) -> String {
        let texts = [
            "((self.kinds[I] + self.kinds[J]) as f64)",
            "f64::from(self.kinds[I] * self.kinds[J])",
            "((self.kinds[I] - 2 * self.kinds[J]) as f64)",
            "((self.kinds[I] * 3 / 2 + self.kinds[J] % 2) as f64)",
            "(((self.kinds[I] - self.kinds[J]) / 2) as f64)",
            "((self.kinds[I] - self.kinds[J]).abs() as f64)",
            "(self.kinds[I].max(self.kinds[J]) as f64)",
            "((self.bytes[I] as i32 - self.kinds[J]) as f64)",
            "(I as i32 - self.kmax) as f64",
            "((I as i32 * self.kinds[J] - self.power) as f64)",
        ];
        self.choices.of(&texts).replace('I', i).replace('J', j)
    }

    /// Something between -1 and 1.
    fn bounded(&mut self, scope: &Scope, depth: usize) -> String {
        let x = self.number(scope, depth);
        match self.choices.below(5) {
            0 => format!("({x}).sin()"),
            1 => format!("({x}).cos()"),
            2 => format!("({x}).tanh()"),
            3 => format!("({x}).atan().cos()"),
            _ => format!("(({x}) / (1.0 + ({x}).abs()))"),
        }
    }

    fn positive(&mut self, scope: &Scope, depth: usize) -> String {
        let x = self.number(scope, depth);
        match self.choices.below(5) {
            0 => format!("(0.5 + ({x}) * ({x}))"),
            1 => format!("(1.0 + ({x}).powi(2))"),
            2 => format!("(({x}).abs() + 0.3)"),
            3 => format!("(2.0 + ({x}).sin())"),
            _ => format!("({x}).cos().exp()"),
        }
    }

    pub(super) fn number(&mut self, scope: &Scope, depth: usize) -> String {
        if depth == 0 {
            return self.leaf(scope);
        }
        let less = depth - 1;
        match self.choices.below(100) {
            0..40 => {
                let (a, b) = (self.number(scope, less), self.number(scope, less));
                format!("({a} {} {b})", self.choices.of(&["+", "+", "-", "-", "*", "*"]))
            }
            40..46 => format!("({} / {})", self.number(scope, less), self.positive(scope, less)),
            46..49 => format!("(-{})", self.number(scope, less)),
            49..70 => self.function_of(scope, less),
            70..77 => {
                let (condition, a, b) =
                    (self.condition(scope, less), self.number(scope, less), self.number(scope, less));
                format!("(if {condition} {{ {a} }} else {{ {b} }})")
            }
            77..83 if PARTS.guards => self.guarded(scope, less),
            83..87 if scope.has_helpers && !self.helpers.is_empty() => self.helper_call(scope, less),
            87..89 => {
                let (name, value) = (self.fresh("b"), self.number(scope, less));
                let mut inner = scope.clone();
                inner.numbers.push(name.clone());
                format!("({{ let {name} = {value}; {} }})", self.number(&inner, less))
            }
            89..95 if scope.has_coordinates && scope.loops < 2 => self.chain_value(scope, less),
            _ => self.leaf(scope),
        }
    }

    fn function_of(&mut self, scope: &Scope, depth: usize) -> String {
        let everywhere = [functions_of(Arguments::Any), vec!["abs", "signum"]].concat();
        match self.choices.below(16) {
            0..=3 => format!("({}).{}()", self.number(scope, depth), self.choices.of(&everywhere)),
            4 => {
                let name = self.choices.of(&functions_of(Arguments::Bounded));
                format!("{}.{name}()", self.bounded(scope, depth))
            }
            5 | 6 => {
                let name = self.choices.of(&functions_of(Arguments::Positive));
                format!("{}.{name}()", self.positive(scope, depth))
            }
            7 => {
                let name = self.choices.of(&functions_of(Arguments::Inner));
                format!("(0.5 * {}).{name}()", self.bounded(scope, depth))
            }
            8 if PARTS.integers && !scope.indices.is_empty() && self.choices.percent(30) => {
                let known: Vec<&str> = scope.indices.iter().map(String::as_str).collect();
                let (i, j) = (self.choices.of(&known).to_owned(), self.choices.of(&known).to_owned());
                format!("{}.powi(self.kinds[{i}] - self.kinds[{j}])", self.positive(scope, depth))
            }
            8 => format!("({}).powi({})", self.number(scope, depth), self.choices.below(5)),
            9 => format!("{}.powi(-{})", self.positive(scope, depth), 1 + self.choices.below(3)),
            10 => {
                let exponent = self.choices.of(&["1.5", "-0.5", "0.5", "2.0", "3.0", "-1.0", "1.3", "self.a"]);
                format!("{}.powf({exponent})", self.positive(scope, depth))
            }
            11 => format!("({}).hypot({})", self.number(scope, depth), self.positive(scope, depth)),
            12 => format!("({}).atan2({})", self.number(scope, depth), self.positive(scope, depth)),
            13 => {
                let name = self.choices.of(&["min", "max"]);
                format!("({}).{name}({})", self.number(scope, depth), self.number(scope, depth))
            }
            14 => {
                let [x, y, z] = [(); 3].map(|()| self.number(scope, depth));
                format!("({x}).mul_add({y}, {z})")
            }
            _ => format!("({}).clamp(-0.7, 0.8)", self.number(scope, depth)),
        }
    }

    pub(super) fn condition(&mut self, scope: &Scope, depth: usize) -> String {
        let index = |grammar: &mut Self| {
            let known: Vec<&str> = scope.indices.iter().map(String::as_str).collect();
            grammar.choices.of(&known).to_owned()
        };
        match self.choices.below(12) {
            0 if depth > 0 => format!("({} && {})", self.condition(scope, depth - 1), self.condition(scope, depth - 1)),
            1 if depth > 0 => format!("({} || {})", self.condition(scope, depth - 1), self.condition(scope, depth - 1)),
            2 if depth > 0 => format!("!({})", self.condition(scope, depth - 1)),
            3 => self
                .choices
                .of(&["self.flag", "self.n > 1", "self.optional.is_some()", "self.short.is_empty()"])
                .to_owned(),
            4 | 5 if !scope.indices.is_empty() => {
                let i = index(self);
                format!("{i} % {} == {}", 2 + self.choices.below(2), self.choices.below(2))
            }
            11 if PARTS.integers && !scope.indices.is_empty() => {
                let (i, j) = (index(self), index(self));
                let texts = [
                    "self.kinds[I] * self.kinds[J] < 0",
                    "(self.kinds[I] - self.kinds[J]).abs() > 1",
                    "(self.kinds[I] + self.kinds[J]) % 2 == 0",
                    "self.kinds[I] + self.kinds[J] < self.kmax",
                    "I < self.n",
                    "self.bytes[I] + 1 == self.bytes[J]",
                ];
                self.choices.of(&texts).replace('I', &i).replace('J', &j)
            }
            6 | 7 if scope.indices.len() > 1 => {
                let (i, j) = (index(self), index(self));
                format!("{i} {} {j}", self.choices.of(&["<", "<=", ">", ">=", "!=", "=="]))
            }
            _ => {
                let (a, b) = (self.number(scope, depth.min(1)), self.leaf(scope));
                format!("{a} {} {b}", self.choices.of(&["<", "<=", ">", ">="]))
            }
        }
    }

    /// A condition, and a number that is there only where it holds.
    pub(super) fn guard(&mut self, scope: &Scope) -> (String, String) {
        let n = self.length_text(scope);
        let known: Vec<&str> = scope.indices.iter().map(String::as_str).collect();
        if known.is_empty() || self.choices.percent(25) {
            let of_system = [
                ("self.n > 0 && self.n <= self.k.len()", "self.k[self.n - 1]"),
                ("!self.empty.is_empty()", "self.empty[0]"),
                ("self.optional.is_some()", "self.optional.unwrap()"),
                ("self.short.len() > 2", "self.short[2]"),
                ("self.n < self.short.len()", "self.short[self.n]"),
            ];
            if scope.has_coordinates && (self.is_dynamic || self.length > 1) && self.choices.percent(30) {
                let last = if self.is_dynamic { self.choices.below(4) } else { 1 };
                let place = self.coordinate_at(&last.to_string());
                return (format!("{n} > {last}"), place);
            }
            let (guard, place) = of_system[self.choices.below(of_system.len())];
            return (guard.to_owned(), place.to_owned());
        }
        let (i, j) = (self.choices.of(&known).to_owned(), self.choices.of(&known).to_owned());
        let at = |grammar: &mut Self, index: String| match scope.has_coordinates {
            true => grammar.coordinate_at(&index),
            false => format!("self.long[{index}]"),
        };
        match self.choices.below(12) {
            9 => (format!("{i} != {n} - 1"), at(self, format!("{i} + 1"))),
            10 => (format!("!({i} == {n} - 1)"), at(self, format!("{i} + 1"))),
            11 => (format!("{i} + 1 != {n} && {i} > 0"), at(self, format!("{i} + 1"))),
            // No coordinate is so large, and not all lists are so long.
            8 if scope.has_coordinates => {
                let element = self.choices.of(&["self.k[self.n - 1 - i]", "self.long[i + self.n]", "self.k[3]"]);
                (
                    format!("{} > 1.6", self.coordinate_at(&i)),
                    element.replace("i]", &format!("{i}]")).replace("[i", &format!("[{i}")),
                )
            }
            7 => (format!("{j} > {i}"), format!("self.k[{i} + 1]")),
            0 => (format!("{i} > 0"), at(self, format!("{i} - 1"))),
            1 => (format!("{i} + 1 < {n}"), at(self, format!("{i} + 1"))),
            2 => (format!("{i} < self.short.len()"), format!("self.short[{i}]")),
            3 => (format!("{j} > {i}"), format!("self.long[{j} - {i}]")),
            4 => (format!("{i} > 0"), format!("self.long[{i} - 1]")),
            5 if scope.has_coordinates && i != j => {
                let (a, b) = (self.coordinate_at(&i), self.coordinate_at(&j));
                (format!("{i} != {j}"), format!("(1.0 / ({a} - {b}))"))
            }
            _ => (format!("{i} < self.n"), format!("self.k[self.n - 1 - {i}]")),
        }
    }

    fn guarded(&mut self, scope: &Scope, depth: usize) -> String {
        let (mut guard, place) = self.guard(scope);
        let mut inner = scope.clone();
        inner.numbers.extend([place.clone(), place.clone(), place.clone()]);
        if self.choices.percent(25) {
            guard = format!("{guard} && {}", self.condition(&inner, 0));
        }
        let (value, other) = (self.number(&inner, depth), self.number(scope, depth));
        format!("(if {guard} {{ {place} * {value} }} else {{ {other} }})")
    }

    fn helper_call(&mut self, scope: &Scope, depth: usize) -> String {
        let helper = self.choices.below(self.helpers.len());
        let (name, signature) = (self.helpers[helper].name.clone(), self.helpers[helper].signature);
        match signature {
            Signature::Numbers(count) => {
                let arguments: Vec<_> = (0..count).map(|_| self.number(scope, depth)).collect();
                format!("self.{name}({})", arguments.join(", "))
            }
            Signature::Array => format!("self.{name}([{}, {}])", self.number(scope, depth), self.number(scope, depth)),
            Signature::Pair => format!("self.{name}({}).{}", self.number(scope, depth), self.choices.below(2)),
            Signature::Index => format!("self.{name}({})", self.index(scope)),
        }
    }
}
