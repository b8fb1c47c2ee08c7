//! Products, quotients and powers. Numbers and parameters are collected on the left, where they are multiplied once per
//! run. The rewrites are marked as in the smart constructors of sums.

use super::{Graph, Node, NodeId};

/// The number of factors of a long product.
const LONG: usize = 8;

impl Graph {
    /// A value without its sign and its prepared factors.
    pub(crate) fn without_factors(&self, x: NodeId) -> NodeId {
        match self.node(x) {
            Node::Neg(inner) => self.without_factors(inner),
            Node::Mul(factor, inner) if self.is_prepared(factor) => self.without_factors(inner),
            _ => x,
        }
    }

    /// A product. Numbers are gathered from both sides and put, with parameters, at the far left, where they are
    /// multiplied once per run.
    pub(crate) fn mul(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if let (Some(a), Some(b)) = (self.as_constant(a), self.as_constant(b)) {
            return self.constant(a * b);
        }
        // exact: signs move outwards
        match (self.node(a), self.node(b)) {
            (Node::Neg(x), Node::Neg(y)) => return self.mul(x, y),
            (Node::Neg(x), _) => {
                let product = self.mul(x, b);
                return self.neg(product);
            }
            (_, Node::Neg(y)) => {
                let product = self.mul(a, y);
                return self.neg(product);
            }
            _ => {}
        }
        // reassociating: (c x)(d y) == (c d)(x y)
        let ((c, x), (d, y)) = (self.strip(a), self.strip(b));
        let product = match (x, y) {
            (Some(x), Some(y)) => self.product(x, y),
            (Some(rest), None) | (None, Some(rest)) => rest,
            (None, None) => return self.constant(c * d),
        };
        self.scaled(c * d, product)
    }

    /// A quotient. By a number it stays one, so that `3x/3` can cancel; by anything else it is a negative power.
    pub(crate) fn div(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let Some(divisor) = self.as_constant(b) else {
            // reassociating by one rounding at most: a / (c x) == (a / c) (1 / x); a / x is printed as a division
            let (scale, rest) = self.strip(b);
            return match rest {
                Some(rest) if scale != 1.0 && scale != 0.0 && !self.is_prepared(rest) => {
                    let scale = self.constant(scale);
                    let scaled = self.div(a, scale);
                    self.div(scaled, rest)
                }
                _ => {
                    let reciprocal = self.power(b, -2);
                    self.mul(a, reciprocal)
                }
            };
        };
        // exact: a number or a coefficient is divided where the quotient is a number without rounding
        let (scale, rest) = self.strip(a);
        if let Some(quotient) = exact_quotient(scale, divisor) {
            return match rest {
                Some(rest) => self.scaled(quotient, rest),
                None => self.constant(quotient),
            };
        }
        self.intern(Node::Div(a, b))
    }

    /// `base` to the power of `halves / 2`.
    pub(crate) fn power(&mut self, base: NodeId, halves: i32) -> NodeId {
        match (halves, self.node(base)) {
            (0, _) => self.constant(1.0),
            (2, _) => base,
            (-2, Node::Constant(_)) => {
                let one = self.constant(1.0);
                self.div(one, base)
            }
            // exact: (-x)^2 == x^2 and (-x)^3 == -(x^3)
            (_, Node::Neg(x)) if halves % 4 == 0 => self.power(x, halves),
            (_, Node::Neg(x)) if halves % 2 == 0 => {
                let power = self.power(x, halves);
                self.neg(power)
            }
            // finite: (x^a)^b == x^(a b) where b is whole, and a is not a root that b would undo
            (_, Node::Power(x, inner)) if halves % 2 == 0 && (inner % 2 == 0 || self.is_never_negative(x)) => {
                match inner.checked_mul(halves / 2) {
                    Some(product) => self.power(x, product),
                    None => self.intern(Node::Power(base, halves)),
                }
            }
            (_, Node::Mul(..) | Node::Div(..)) => {
                self.power_of_roots(base, halves).unwrap_or_else(|| self.intern(Node::Power(base, halves)))
            }
            // reassociating: hypot(x, y)^n == (x^2 + y^2)^(n/2) for whole n from 2 on, which leave the range where the square does
            (_, Node::Binary(function, x, y)) if function.is_distance() && halves % 2 == 0 && halves >= 4 => {
                let [x, y] = [x, y].map(|x| self.power(x, 4));
                let square = self.add(x, y);
                self.power(square, halves / 2)
            }
            _ => self.intern(Node::Power(base, halves)),
        }
    }

    /// The product of two factors without numbers.
    fn product(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if let Some(merged) = self.merged_powers(a, b) {
            return merged;
        }
        if let Some(collected) = self.with_roots_collected(a, b) {
            return collected;
        }
        match (self.is_prepared(a), self.is_prepared(b)) {
            // reassociating: x (k y) stays; k (l y) == (k l) y and (k x) l == (k l) x
            (true, false) => self.scaled_by(a, b),
            (false, true) => self.scaled_by(b, a),
            (true, true) => self.intern(Node::Mul(a, b)),
            // exact: multiplication commutes; a product keeps its own left side so that x y x grows to the right
            (false, false) => match (self.node(a), self.node(b)) {
                (Node::Mul(..), _) => self.intern(Node::Mul(a, b)),
                (_, Node::Mul(..)) => self.intern(Node::Mul(b, a)),
                _ => self.intern(Node::Mul(a.min(b), a.max(b))),
            },
        }
    }

    /// finite: x^a x^b == x^(a+b), for exponents of one sign that do not undo a root.
    fn merged_powers(&mut self, a: NodeId, b: NodeId) -> Option<NodeId> {
        let exponent = |id| match self.node(id) {
            Node::Power(base, halves) => (base, halves),
            _ => (id, 2),
        };
        let ((base, first), (other, second)) = (exponent(a), exponent(b));
        let undoes = first % 2 != 0 && second % 2 != 0 && !self.is_never_negative(base);
        if base != other || first.signum() != second.signum() || undoes {
            return None;
        }
        Some(self.power(base, first.checked_add(second)?))
    }

    /// Whether a value is zero, positive or NaN whatever its coordinates and parameters are.
    pub(crate) fn is_never_negative(&self, id: NodeId) -> bool {
        let of = |id| self.is_never_negative(id);
        match self.node(id) {
            // A root is NaN where its argument is negative.
            Node::Power(base, halves) => halves % 4 == 0 || halves % 2 != 0 || of(base),
            Node::Constant(bits) => f64::from_bits(bits) >= 0.0,
            Node::Parameter(id) => self.never_negative.contains(&id),
            Node::Unary(function, _) | Node::Binary(function, ..) if function.row().never_negative => true,
            // The larger of a value and a number is no smaller than the number, also where the value is NaN.
            Node::Binary(function, a, b) if function.name() == "max" => {
                [a, b].into_iter().any(|id| self.as_constant(id).is_some_and(|bound| bound >= 0.0)) || of(a) && of(b)
            }
            Node::Binary(function, a, b) if function.name() == "min" => of(a) && of(b),
            Node::Mul(a, b) => a == b || of(a) && of(b),
            Node::Add(a, b) | Node::Div(a, b) | Node::Select(_, a, b) => of(a) && of(b),
            Node::Sum(_, body) => of(body),
            _ => false,
        }
    }

    /// Whether a value is above zero whatever its coordinates are, where addends that are prepared are.
    pub(crate) fn is_positive(&self, id: NodeId) -> bool {
        let above = |id| self.is_prepared(id) && self.as_constant(id) != Some(0.0) || self.is_positive(id);
        match self.node(id) {
            Node::Constant(bits) => f64::from_bits(bits) > 0.0,
            Node::Add(a, b) => self.is_never_negative(a) && above(b) || self.is_never_negative(b) && above(a),
            Node::Mul(a, b) => self.is_positive(a) && self.is_positive(b),
            Node::Power(base, _) => self.is_positive(base),
            _ => self.is_never_zero(id),
        }
    }

    /// Whether a value is zero by underflow alone.
    pub(crate) fn is_never_zero(&self, id: NodeId) -> bool {
        match self.node(id) {
            Node::Constant(bits) => f64::from_bits(bits) != 0.0,
            Node::Power(_, halves) if halves < 0 => true,
            Node::Unary(function, _) => matches!(function.name(), "exp" | "exp2" | "cosh"),
            Node::Neg(a) => self.is_never_zero(a),
            Node::Mul(a, b) => self.is_never_zero(a) && self.is_never_zero(b),
            _ => false,
        }
    }

    /// Whether a value is zero, negative or NaN whatever its coordinates and parameters are.
    pub(crate) fn falls(&self, id: NodeId) -> bool {
        matches!(self.node(id), Node::Neg(a) if self.is_never_negative(a))
    }

    /// A product as a number times the rest; `1` and the node itself where there is no number.
    pub(super) fn strip(&mut self, id: NodeId) -> (f64, Option<NodeId>) {
        match self.node(id) {
            Node::Constant(bits) => (f64::from_bits(bits), None),
            Node::Mul(a, b) => match self.strip(a) {
                (1.0, _) => (1.0, Some(id)),
                (scale, None) => (scale, Some(b)),
                (scale, Some(rest)) => {
                    let rest = self.product(rest, b);
                    (scale, Some(rest))
                }
            },
            _ => (1.0, Some(id)),
        }
    }

    /// A number times a node without one.
    fn scaled(&mut self, scale: f64, rest: NodeId) -> NodeId {
        match scale {
            1.0 => rest,
            // exact: (-c) x == -(c x)
            _ if scale.is_sign_negative() => {
                let product = self.scaled(-scale, rest);
                self.neg(product)
            }
            _ => {
                let scale = self.constant(scale);
                self.scaled_by(scale, rest)
            }
        }
    }

    /// A number or parameter times a node, put at the far left of the node's factors.
    fn scaled_by(&mut self, scale: NodeId, rest: NodeId) -> NodeId {
        match (self.node(rest), self.as_constant(scale)) {
            (Node::Neg(inner), _) => {
                let product = self.scaled_by(scale, inner);
                self.neg(product)
            }
            // Put into the front of a long product, it would keep that from being shared with its multiples.
            (Node::Mul(..), Some(_)) if self.is_long_product(rest) => self.intern(Node::Mul(scale, rest)),
            (Node::Mul(a, b), _) => {
                let left = self.scaled_by(scale, a);
                match self.as_constant(left) {
                    Some(number) => self.scaled(number, b),
                    None => self.intern(Node::Mul(left, b)),
                }
            }
            (Node::Div(numerator, divisor), Some(number)) => {
                // exact: c (x / d) == (c/d) x where c/d is a number without rounding
                let quotient = self.as_constant(divisor).and_then(|divisor| exact_quotient(number, divisor));
                match quotient {
                    Some(quotient) => {
                        let quotient = self.constant(quotient);
                        self.mul(quotient, numerator)
                    }
                    None => self.intern(Node::Mul(scale, rest)),
                }
            }
            // finite: 2ⁿ (c x + d y) == (2ⁿ c) x + (2ⁿ d) y
            (Node::Add(a, b), Some(number))
                if is_power_of_two(number) && [a, b].iter().all(|x| self.has_number(*x)) =>
            {
                let [a, b] = [a, b].map(|x| self.mul(scale, x));
                self.add(a, b)
            }
            _ => self.intern(Node::Mul(scale, rest)),
        }
    }

    /// Whether a product has many factors, and none in front that is prepared, with which a number would be multiplied.
    fn is_long_product(&self, id: NodeId) -> bool {
        let factors = std::iter::successors(Some(id), |id| match self.node(*id) {
            Node::Mul(left, _) => Some(left),
            _ => None,
        });
        let (count, first) = factors.take(LONG + 1).fold((0, id), |(count, _), left| (count + 1, left));
        count > LONG && !self.is_prepared(first)
    }

    /// Whether a node is a number times something else.
    fn has_number(&mut self, id: NodeId) -> bool {
        match self.node(id) {
            Node::Neg(inner) => self.has_number(inner),
            _ => matches!(self.strip(id), (scale, Some(_)) if scale != 1.0),
        }
    }

    /// The step times a node: at the far left of its factors, beside what is shared or prepared.
    pub(crate) fn stepped(&mut self, x: NodeId) -> NodeId {
        let step = self.step();
        match self.node(x) {
            Node::Neg(inner) => {
                let update = self.stepped(inner);
                self.intern(Node::Neg(update))
            }
            Node::Mul(a, b) if !self.is_prepared(x) => {
                let left = self.stepped(a);
                self.intern(Node::Mul(left, b))
            }
            _ if self.as_constant(x) == Some(1.0) => step,
            _ => self.intern(Node::Mul(step, x)),
        }
    }
}

/// `a / b`, if it is a number without rounding.
fn exact_quotient(a: f64, b: f64) -> Option<f64> {
    let quotient = a / b;
    (quotient.is_finite() && (-quotient).mul_add(b, a) == 0.0).then_some(quotient)
}

/// Whether a factor changes no digit of what it multiplies.
fn is_power_of_two(x: f64) -> bool {
    const MANTISSA: u64 = (1 << (f64::MANTISSA_DIGITS - 1)) - 1;
    x.is_normal() && x.to_bits() & MANTISSA == 0
}
