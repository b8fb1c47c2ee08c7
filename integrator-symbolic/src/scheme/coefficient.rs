//! Coefficients.
//!
//! In: an expression of numbers. Out: its value to 31 digits, and its uncertainty. Always true: the resulting value is
//! finite.
//!
//! The uncertainty comes from the given digits. Integers, fractions, roots and short decimals (`0.28`) are exact. A
//! decimal of [`ROUNDED`] or more significant digits is assumed to be rounded, with an uncertainty of one unit in its
//! last place. Uncertainties are propagated to first order, and the proof derives its tolerance from them.

use std::ops::{Add, Div, Mul, Neg, Sub};

use syn::{BinOp, Expr, ExprCall, ExprLit, ExprUnary, Lit, UnOp};

use super::double::Double;

/// The number of significant digits from which a decimal counts as rounded.
const ROUNDED: u32 = 12;

/// The largest `n` of `root(n, x)`.
const LARGEST_ROOT: u32 = 64;

const LANGUAGE: &str =
    "note: coefficients may contain numbers, `+`, `-`, `*`, `/`, parentheses, `sqrt(x)`, `cbrt(x)` and `root(n, x)`";

/// A number and how far it may be from the one that was meant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Coefficient {
    pub(super) value: Double,
    pub(super) doubt: f64,
}

impl Coefficient {
    pub(super) const ZERO: Self = Self { value: Double::ZERO, doubt: 0.0 };
    pub(super) const ONE: Self = Self { value: Double::ONE, doubt: 0.0 };

    pub(super) fn integer(value: u32) -> Self {
        Self { value: Double::integer(u128::from(value)), doubt: 0.0 }
    }

    /// Whether the number may be zero: exactly, by rounding, or by its doubt.
    pub(super) fn vanishes(self) -> bool {
        self.value.abs().value() <= 1e-30 + self.doubt
    }

    pub(super) fn root(self, degree: u32) -> Self {
        let value = self.value.root(degree);
        let slope = f64::from(degree) * value.value().powi(degree as i32 - 1);
        Self { value, doubt: if self.doubt == 0.0 { 0.0 } else { self.doubt / slope } }
    }

    fn magnitude(self) -> f64 {
        self.value.abs().value()
    }
}

impl Add for Coefficient {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, doubt: self.doubt + other.doubt }
    }
}

impl Neg for Coefficient {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, doubt: self.doubt }
    }
}

impl Sub for Coefficient {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Coefficient {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let doubt = self.magnitude() * other.doubt + other.magnitude() * self.doubt;
        Self { value: self.value * other.value, doubt }
    }
}

impl Div for Coefficient {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, doubt: (self.doubt + value.abs().value() * other.doubt) / other.magnitude() }
    }
}

/// The value of an expression, or everything that is wrong with it.
pub(super) fn evaluate(expression: &Expr) -> syn::Result<Coefficient> {
    let value = match expression {
        Expr::Lit(ExprLit { lit, .. }) => literal(lit)?,
        Expr::Paren(inner) => evaluate(&inner.expr)?,
        Expr::Unary(ExprUnary { op: UnOp::Neg(_), expr, .. }) => -evaluate(expr)?,
        Expr::Binary(binary) => {
            let (left, right) = both(evaluate(&binary.left), evaluate(&binary.right))?;
            match binary.op {
                BinOp::Add(_) => left + right,
                BinOp::Sub(_) => left - right,
                BinOp::Mul(_) => left * right,
                BinOp::Div(_) if right.vanishes() => {
                    return Err(syn::Error::new_spanned(&binary.right, "division by zero"));
                }
                BinOp::Div(_) => left / right,
                _ => return Err(syn::Error::new_spanned(binary.op, format!("unknown operation\n{LANGUAGE}"))),
            }
        }
        Expr::Call(call) => root(call)?,
        Expr::Infer(_) => {
            let message = "`_` has to be a whole coefficient\nhelp: write `T(_)`, which is what the other drifts \
                           leave of the step";
            return Err(syn::Error::new_spanned(expression, message));
        }
        _ => return Err(syn::Error::new_spanned(expression, format!("expected a number\n{LANGUAGE}"))),
    };
    if value.value.is_finite() && value.doubt.is_finite() {
        Ok(value)
    } else {
        Err(syn::Error::new_spanned(expression, "this coefficient is not finite"))
    }
}

fn both<A, B>(left: syn::Result<A>, right: syn::Result<B>) -> syn::Result<(A, B)> {
    match (left, right) {
        (Ok(left), Ok(right)) => Ok((left, right)),
        (Err(mut left), Err(right)) => {
            left.combine(right);
            Err(left)
        }
        (Err(error), _) | (_, Err(error)) => Err(error),
    }
}

fn root(call: &ExprCall) -> syn::Result<Coefficient> {
    let name = match &*call.func {
        Expr::Path(path) => path.path.get_ident().map(ToString::to_string).unwrap_or_default(),
        _ => String::new(),
    };
    let arguments: Vec<&Expr> = call.args.iter().collect();
    let (degree, of) = match (name.as_str(), arguments.as_slice()) {
        ("sqrt", [of]) => (2, of),
        ("cbrt", [of]) => (3, of),
        ("root", [degree, of]) => (root_degree(degree)?, of),
        ("sqrt" | "cbrt", _) => {
            return Err(syn::Error::new_spanned(call, format!("`{name}` takes one argument\nhelp: write `{name}(x)`")));
        }
        ("root", _) => {
            return Err(syn::Error::new_spanned(
                call,
                "`root` takes two arguments\nhelp: write, for example, `root(5, x)` for the fifth root of x",
            ));
        }
        _ => return Err(syn::Error::new_spanned(&call.func, format!("unknown function\n{LANGUAGE}"))),
    };
    let value = evaluate(of)?;
    if value.value.value() < 0.0 {
        let message = "the root of a negative number is not supported\nhelp: move the sign outside, `-cbrt(x)`";
        return Err(syn::Error::new_spanned(of, message));
    }
    Ok(value.root(degree))
}

fn root_degree(expression: &Expr) -> syn::Result<u32> {
    if let Expr::Lit(ExprLit { lit: Lit::Int(literal), .. }) = expression
        && let Ok(degree) = literal.base10_parse::<u32>()
        && (1..=LARGEST_ROOT).contains(&degree)
    {
        return Ok(degree);
    }
    let message = format!(
        "the degree of a root has to be an integer from 1 to {LARGEST_ROOT}\nhelp: write, for example, `root(5, x)`"
    );
    Err(syn::Error::new_spanned(expression, message))
}

fn literal(literal: &Lit) -> syn::Result<Coefficient> {
    let (digits, suffix) = match literal {
        Lit::Int(literal) => (literal.base10_digits(), literal.suffix()),
        Lit::Float(literal) => (literal.base10_digits(), literal.suffix()),
        _ => return Err(syn::Error::new(literal.span(), format!("expected a number\n{LANGUAGE}"))),
    };
    if !suffix.is_empty() {
        let message = format!("coefficients have no type suffix\nhelp: remove `{suffix}`");
        return Err(syn::Error::new(literal.span(), message));
    }
    decimal(digits).ok_or_else(|| syn::Error::new(literal.span(), "this coefficient is not finite"))
}

/// Reads `123.45e-6`. Digits beyond the 38th are below a unit of 2^-106 and are left out.
fn decimal(text: &str) -> Option<Coefficient> {
    let (negative, text) = text.strip_prefix('-').map_or((false, text), |rest| (true, rest));
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let mut scale = exponent.parse::<i32>().ok()?.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    let last_place = scale;
    let digits: Vec<u128> = (whole.chars().chain(fraction.chars()).map_while(|digit| digit.to_digit(10)))
        .skip_while(|digit| *digit == 0)
        .map(u128::from)
        .collect();
    let mut integer = 0_u128;
    for (position, digit) in digits.iter().enumerate() {
        if position < 38 {
            integer = integer * 10 + digit;
        } else {
            scale = scale.checked_add(1)?;
        }
    }
    if integer == 0 {
        return Some(Coefficient::ZERO);
    }
    // Outside this range the power of ten itself leaves the finite numbers.
    if !(-290..=290).contains(&scale) {
        return None;
    }
    let power = Double::integer(10).power(scale.unsigned_abs());
    let integer = Double::integer(integer);
    let value = if scale < 0 { integer / power } else { integer * power };
    let is_decimal = text.contains(['.', 'e', 'E']);
    let doubt = if is_decimal && digits.len() >= ROUNDED as usize { 10_f64.powi(last_place) } else { 0.0 };
    Some(Coefficient { value: if negative { -value } else { value }, doubt })
}

#[cfg(test)]
mod tests {
    use super::{Coefficient, evaluate};

    fn value(text: &str) -> Coefficient {
        evaluate(&syn::parse_str(text).expect("an expression")).unwrap_or_else(|error| panic!("{text}: {error}"))
    }

    fn message(text: &str) -> String {
        let errors = evaluate(&syn::parse_str(text).expect("an expression")).expect_err("a refusal");
        errors.into_iter().map(|error| error.to_string()).collect::<Vec<_>>().join(" | ")
    }

    #[test]
    fn expressions_that_are_equal_in_exact_arithmetic() {
        for (left, right) in [
            ("1/3 + 1/6", "0.5"),
            ("-1/72", "1/(-72)"),
            ("2 - 3 - 4", "-5"),
            ("1/(2 - cbrt(2))", "(4 + 2*cbrt(2) + cbrt(4))/6"),
            ("sqrt(3)/6", "1/(2*sqrt(3))"),
            ("root(5, 32)", "2"),
            ("1_000e-3", "1"),
            ("0x10", "16"),
            ("1.41421356237309504880168872420969807856967187537694807317667973799", "sqrt(2)"),
            ("0.000125", "1/8000"),
            (
                "12345678901234567890123456789012345678901234567890e-49",
                "1.2345678901234567890123456789012345678901234567890",
            ),
        ] {
            let difference = value(left) - value(right);
            assert!(difference.value.abs().value() < 2e-31, "{left} = {right}, off by {difference:?}");
        }
    }

    #[test]
    fn doubt_follows_the_digits_typed() {
        assert_eq!(value("0.28").doubt, 0.0);
        assert_eq!(value("123456789012345").doubt, 0.0, "integers are exact");
        assert_eq!(value("0.784513610477560").doubt, 1e-15);
        assert_eq!(value("2*0.784513610477560").doubt, 2e-15);
        assert_eq!(value("1 - 0.784513610477560/2").doubt, 0.5e-15);
        assert!((value("sqrt(4.00000000000000)").doubt - 0.25e-14).abs() < 1e-20);
    }

    #[test]
    fn every_mistake_has_its_message() {
        assert_eq!(message("1/(2 - 2)"), "division by zero");
        assert!(message("sqrt(1 - 2)").starts_with("the root of a negative number is not supported"));
        assert_eq!(message("1e300*1e-200 + 1e999"), "this coefficient is not finite | this coefficient is not finite");
        assert_eq!(message("0.5f32"), "coefficients have no type suffix\nhelp: remove `f32`");
        assert!(message("sqrt(1, 2)").starts_with("`sqrt` takes one argument"));
        assert!(message("root(0, 2)").starts_with("the degree of a root"));
        assert!(message("root(3)").starts_with("`root` takes two arguments"));
        assert!(message("exp(1)").starts_with("unknown function"));
        assert!(message("2 ^ 3").starts_with("unknown operation"));
        assert!(message("half").starts_with("expected a number"));
        assert!(message("1/0 + 1/0").contains('|'), "both divisions are reported");
        assert!(message("1 - _").starts_with("`_` has to be a whole coefficient"));
    }
}
