//! Readable formulas: sums of products, with numbers first, then parameters, coordinates and functions of them, and one
//! fraction bar per product.
//!
//! They are for documentation only: expressions that are equal for almost all arguments are printed in the same way,
//! whatever their rounding.

/// A sum of products.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Formula(Vec<Product>);

/// A number times powers.
#[derive(Clone, Debug, PartialEq)]
struct Product {
    number: f64,
    factors: Vec<Factor>,
}

/// An atom to the power of `halves / 2`.
#[derive(Clone, Debug, PartialEq)]
struct Factor {
    atom: Atom,
    halves: i32,
}

/// What is written in one piece.
#[derive(Clone, Debug, PartialEq)]
struct Atom {
    kind: Kind,
    text: String,
    /// The sum that a group is.
    inner: Option<Formula>,
}

/// What an atom is, in the order in which factors are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    Parameter,
    Coordinate,
    Function,
    /// A name of what is not negative.
    Size,
    /// It stands in parentheses beside others.
    Group,
    /// It reaches to the end of the product.
    Total,
}

/// How tightly a text holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Tie {
    Sum,
    Product,
    Atom,
}

impl Formula {
    pub(crate) fn number(number: f64) -> Self {
        Self(vec![Product { number, factors: Vec::new() }])
    }

    pub(crate) fn atom(kind: Kind, text: String) -> Self {
        Self(vec![Product { number: 1.0, factors: vec![Factor { atom: Atom { kind, text, inner: None }, halves: 2 }] }])
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.iter().all(|product| product.number == 0.0)
    }

    /// The number that it is, if it is one.
    pub(crate) fn as_number(&self) -> Option<f64> {
        match &self.0[..] {
            [] => Some(0.0),
            [Product { number, factors }] if factors.is_empty() => Some(*number),
            _ => None,
        }
    }

    pub(crate) fn neg(self) -> Self {
        self.scaled(-1.0)
    }

    pub(crate) fn add(mut self, other: Self) -> Self {
        for product in other.0 {
            match self.0.iter_mut().find(|known| known.has_factors_of(&product)) {
                Some(known) => known.number += product.number,
                None => self.0.push(product),
            }
        }
        self.0.retain(|product| product.number != 0.0);
        self
    }

    pub(crate) fn mul(self, other: Self) -> Self {
        match (self.as_number(), other.as_number()) {
            (Some(number), _) => other.times(number),
            (_, Some(number)) => self.times(number),
            _ => {
                let mut product = self.into_product();
                let other = other.into_product();
                product.number *= other.number;
                for factor in other.factors {
                    product.multiply(factor);
                }
                Self(vec![product])
            }
        }
    }

    /// The formula to the power of `halves / 2`.
    pub(crate) fn power(self, halves: i32) -> Self {
        // What is under a root stays together.
        let product = match halves % 2 != 0 && self.0.len() > 1 {
            true => Product { number: 1.0, factors: vec![Factor { atom: Atom::group(self), halves: 2 }] },
            false => self.into_product(),
        };
        let is_whole = |factor: &Factor| factor.halves == 2 || factor.atom.kind == Kind::Size;
        let single = matches!(&product.factors[..], [factor] if product.number == 1.0 && is_whole(factor));
        if halves % 2 != 0 && !single {
            let atom = Atom::group(Self(vec![product]));
            return Self(vec![Product { number: 1.0, factors: vec![Factor { atom, halves }] }]);
        }
        let number = product.number.powf(f64::from(halves) / 2.0);
        let power = |Factor { atom, halves: own }| Factor { atom, halves: own * halves / 2 };
        let factors = product.factors.into_iter().map(power).filter(|factor| factor.halves != 0).collect();
        Self(vec![Product { number, factors }])
    }

    /// A number times it: inside of a sum where fewer numbers are written so.
    fn times(self, number: f64) -> Self {
        let outside = usize::from(number.abs() != 1.0);
        if self.0.len() < 2 {
            return self.scaled(number);
        }
        let inside = self.clone().scaled(number);
        if inside.numbers() < self.numbers() + outside {
            return inside;
        }
        let mut product = self.into_product();
        product.number *= number;
        Self(vec![product])
    }

    /// How many of its products have a number.
    fn numbers(&self) -> usize {
        self.0.iter().filter(|product| product.number.abs() != 1.0).count()
    }

    fn scaled(mut self, number: f64) -> Self {
        for product in &mut self.0 {
            product.number *= number;
        }
        self
    }

    /// As one product: a sum is a factor in parentheses, with what all of its numbers share in front.
    fn into_product(mut self) -> Product {
        if self.0.len() == 1
            && let Some(product) = self.0.pop()
        {
            return product.opened();
        }
        let shared = self.shared();
        let negative = self.0.iter().all(|product| product.number < 0.0);
        let number = if negative { -shared.number } else { shared.number };
        for product in &mut self.0 {
            product.number /= number;
            for Factor { atom, halves } in &shared.factors {
                product.multiply(Factor { atom: atom.clone(), halves: -halves });
            }
        }
        let atom = Atom::group(self);
        let mut whole = Product { number, factors: shared.factors };
        whole.multiply(Factor { atom, halves: 2 });
        whole
    }

    /// What all products of a sum have in common, without sign.
    fn shared(&self) -> Product {
        let Some(first) = self.0.first() else { return Product { number: 1.0, factors: Vec::new() } };
        let numbers = self.0.iter().map(|product| product.number.abs());
        let least = numbers.clone().fold(f64::INFINITY, f64::min);
        let is_shared = least > 0.0 && numbers.clone().all(|number| (number / least).fract() == 0.0);
        let common = |Factor { atom, halves }: &Factor| {
            let powers = self.0.iter().map(|product| {
                product.factors.iter().find(|factor| factor.atom == *atom).map_or(0, |factor| factor.halves)
            });
            let (least, most) = powers.fold((*halves, *halves), |(least, most), own| (least.min(own), most.max(own)));
            let halves = if least > 0 { least } else { most.min(0) };
            Some(Factor { atom: atom.clone(), halves }).filter(|factor| factor.halves != 0)
        };
        let factors = first.factors.iter().filter_map(common).collect();
        Product { number: if is_shared { least } else { 1.0 }, factors }
    }

    /// As text.
    pub(crate) fn text(&self) -> String {
        self.tied().0
    }

    /// As text that holds together at least as tightly as `needed`.
    pub(crate) fn text_of(&self, needed: Tie) -> String {
        let (text, tie) = self.tied();
        if tie >= needed { text } else { format!("({text})") }
    }

    fn tied(&self) -> (String, Tie) {
        if let [product] = &self.0[..] {
            return product.tied();
        }
        let mut terms: Vec<&Product> = self.0.iter().collect();
        terms.sort_by_key(|product| product.rank());
        // A sum does not begin with a sign where it need not.
        let rank = terms.first().map(|first| first.rank());
        let leads =
            |product: &&Product| product.number > 0.0 && (Some(product.rank()) == rank || product.is_constant());
        if let Some(at) = terms.iter().position(leads)
            && terms[0].number < 0.0
        {
            let first = terms.remove(at);
            terms.insert(0, first);
        }
        let mut text = String::new();
        for product in terms {
            let (term, _) = Product { number: product.number.abs(), ..product.clone() }.tied();
            match (text.is_empty(), product.number < 0.0) {
                (true, false) => {}
                (true, true) => text.push('-'),
                (false, false) => text.push_str(" + "),
                (false, true) => text.push_str(" - "),
            }
            text.push_str(&term);
        }
        if text.is_empty() {
            text.push('0');
        }
        (text, Tie::Sum)
    }
}

impl Atom {
    fn group(inner: Formula) -> Self {
        Self { kind: Kind::Group, text: inner.text(), inner: Some(inner) }
    }
}

impl Product {
    /// The same with the factors of a group that is one product among its own.
    fn opened(self) -> Self {
        let mut opened = Self { number: self.number, factors: Vec::new() };
        for factor in self.factors {
            match &factor.atom.inner {
                Some(Formula(products)) if products.len() == 1 && factor.halves % 2 == 0 => {
                    opened.number *= products[0].number.powi(factor.halves / 2);
                    for inner in &products[0].factors {
                        opened.multiply(Factor { halves: inner.halves * factor.halves / 2, ..inner.clone() });
                    }
                }
                _ => opened.multiply(factor),
            }
        }
        opened
    }

    fn multiply(&mut self, factor: Factor) {
        match self.factors.iter().position(|known| known.atom == factor.atom) {
            Some(at) => {
                self.factors[at].halves += factor.halves;
                if self.factors[at].halves == 0 {
                    self.factors.remove(at);
                }
            }
            None => self.factors.push(factor),
        }
    }

    /// Where it stands in a sum: by its degree, a positive number first, what is constant last.
    fn rank(&self) -> i32 {
        match self.is_constant() {
            true if self.factors.is_empty() && self.number > 0.0 => i32::MIN,
            true => i32::MAX,
            false => match self.factors.iter().map(Factor::degree).sum() {
                // After all powers of coordinates.
                0 => i32::MAX - 1,
                degree => degree,
            },
        }
    }

    fn is_constant(&self) -> bool {
        self.factors.iter().all(|factor| factor.atom.kind == Kind::Parameter)
    }

    fn has_factors_of(&self, other: &Self) -> bool {
        self.factors.len() == other.factors.len() && other.factors.iter().all(|factor| self.factors.contains(factor))
    }

    fn tied(&self) -> (String, Tie) {
        let mut product = self.clone();
        product.put_number_inside();
        product.iteration_difference();
        if product.number == 0.0 {
            return ("0".to_owned(), Tie::Atom);
        }
        // A sum alone needs no parentheses.
        if let [Factor { atom: Atom { inner: Some(inner), .. }, halves: 2 }] = &product.factors[..]
            && product.number == 1.0
        {
            return inner.tied();
        }
        product.factors.sort_by_key(|factor| factor.atom.kind);
        let (above, below): (Vec<_>, Vec<_>) = product.factors.iter().partition(|factor| factor.halves > 0);
        let (numerator, denominator) = fraction(product.number.abs(), product.factors.is_empty());
        let mut over: Vec<String> = Vec::new();
        if numerator != "1" || above.is_empty() {
            over.push(numerator);
        }
        let beside = above.len() + below.len() + over.len() + usize::from(denominator.is_some()) > 1;
        let mut reaches = false;
        for (at, factor) in above.iter().enumerate() {
            let is_last = at + 1 == above.len() && below.is_empty() && denominator.is_none();
            reaches |= factor.atom.kind == Kind::Total && factor.halves == 2;
            over.push(factor.text(factor.halves, beside, is_last));
        }
        let mut under: Vec<String> = denominator.into_iter().collect();
        under.extend(below.iter().map(|factor| factor.text(-factor.halves, true, false)));
        let tie = if over.len() + under.len() > 1 || reaches { Tie::Product } else { Tie::Atom };
        let text = match &under[..] {
            [] => over.join(" "),
            [one] => format!("{} / {one}", over.join(" ")),
            many => format!("{} / ({})", over.join(" "), many.join(" ")),
        };
        if product.number < 0.0 { (format!("-{text}"), Tie::Sum) } else { (text, tie) }
    }

    /// Writes `2 (a / 2 + b)` as `a + 2 b`.
    fn put_number_inside(&mut self) {
        let number = self.number.abs();
        let is_sum = |factor: &&mut Factor| factor.halves == 2 && factor.atom.inner.is_some();
        if number != 1.0
            && number != 0.0
            && let Some(factor) = self.factors.iter_mut().find(is_sum)
            && let Some(inner) = &factor.atom.inner
            && let scaled = inner.clone().scaled(number)
            && scaled.numbers() <= inner.numbers()
        {
            factor.atom = Atom::group(scaled);
            self.number /= number;
        }
    }

    /// Writes `-(a - b)` as `b - a`.
    fn iteration_difference(&mut self) {
        let is_difference = |factor: &&mut Factor| {
            let products = factor.atom.inner.as_ref().map_or(&[][..], |Formula(products)| &products[..]);
            let signs = products.iter().filter(|product| product.number < 0.0).count();
            factor.halves == 2 && products.len() == 2 && signs == 1
        };
        if self.number < 0.0
            && let Some(factor) = self.factors.iter_mut().find(is_difference)
            && let Some(inner) = factor.atom.inner.take()
        {
            factor.atom = Atom::group(inner.neg());
            self.number = -self.number;
        }
    }
}

impl Factor {
    /// The degree in coordinates, in halves.
    fn degree(&self) -> i32 {
        match (&self.atom.inner, self.atom.kind) {
            (Some(Formula(products)), _) => {
                let inner = |product: &Product| product.factors.iter().map(Self::degree).sum::<i32>();
                self.halves / 2 * products.iter().map(inner).max().unwrap_or(0)
            }
            (None, Kind::Coordinate) => self.halves,
            _ => 0,
        }
    }

    /// The factor to a positive power; `beside` others.
    fn text(&self, halves: i32, beside: bool, is_last: bool) -> String {
        let Atom { kind, text, .. } = &self.atom;
        let grouped = match kind {
            Kind::Group => true,
            Kind::Total => halves != 2 || !is_last,
            _ => false,
        };
        let base = if grouped { format!("({text})") } else { text.clone() };
        match halves {
            1 => format!("sqrt({text})"),
            2 if !beside => text.clone(),
            2 => base,
            _ if halves % 2 == 0 => format!("{base}^{}", halves / 2),
            _ => format!("{base}^({halves}/2)"),
        }
    }
}

/// Denominators of numbers that are written as fractions.
const DENOMINATORS: [f64; 9] = [2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0];

/// A positive number as numerator and denominator: as a fraction where that is simpler than its digits.
fn fraction(number: f64, alone: bool) -> (String, Option<String>) {
    let small = number != 0.0 && !(1e-4..1e15).contains(&number);
    let digits = if small { format!("{number:e}") } else { number.to_string() };
    let numerator = |denominator: &f64| {
        let numerator = (number * denominator).round();
        (numerator / denominator == number && (1.0..10.0).contains(&numerator)).then_some(numerator)
    };
    let is_short = number.fract() == 0.0 || alone && digits.len() < 6;
    let simplest = DENOMINATORS.iter().find_map(|denominator| Some((numerator(denominator)?, denominator)));
    match simplest.filter(|_| !is_short) {
        Some((numerator, denominator)) => (numerator.to_string(), Some(denominator.to_string())),
        None => (digits, None),
    }
}
