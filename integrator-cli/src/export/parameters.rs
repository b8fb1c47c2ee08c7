//! The user's parameters in C: the members of a struct, and expressions that read them.
//!
//! In: the fields of a type, and Rust expressions of parameters. Out: members and expressions of C99, in the order of operations
//! of the Rust text; or the place that has no equivalent.

use super::items::Items;
use integrator_symbolic::identifier;
use proc_macro2::Span;
use quote::ToTokens;
use std::{collections::BTreeMap, fmt::Write};
use syn::{BinOp, Block, Expr, ExprPath, Lit, Pat, Stmt, Type, UnOp, spanned::Spanned};

/// What cannot be translated, and where.
pub(super) type Obstacle = (Span, String);

/// The parameters of a system.
pub(super) struct Parameters<'i> {
    pub(super) items: &'i Items,
    pub(super) system: &'i str,
}

impl Parameters<'_> {
    /// The members of the struct: the fields that H reads, with their documentation.
    pub(super) fn members(&self, is_read: impl Fn(&str) -> bool) -> Result<String, Obstacle> {
        let fields = self.items.fields(self.system).ok_or_else(|| {
            let message = format!(
                "`struct {}` is declared in another file, or several times in this one\nhelp: `export` reads the types of its fields; \
                 declare it once in this file",
                self.system
            );
            (Span::call_site(), message)
        })?;
        let mut members = String::new();
        for field in fields {
            let name = field.ident.as_ref().map(ToString::to_string).unwrap_or_default();
            if !is_read(&name) {
                continue;
            }
            let (kind, lengths) = self.kind(&field.ty)?;
            let documentation: Vec<String> = field.attrs.iter().filter_map(documented).collect();
            let comment =
                if documentation.is_empty() { String::new() } else { format!(" /* {} */", documentation.join(" ")) };
            let _ = writeln!(members, "    {kind} {}{lengths};{comment}", identifier(&name));
        }
        Ok(members)
    }

    /// A type in C, and the lengths of an array.
    fn kind(&self, kind: &Type) -> Result<(&'static str, String), Obstacle> {
        let other = || {
            let text = kind.to_token_stream().to_string().replace(' ', "");
            (
                kind.span(),
                format!(
                    "`export` does not support fields of the type `{text}`\nhelp: use numbers, `bool`, and arrays of them"
                ),
            )
        };
        match kind {
            Type::Array(array) => {
                let (element, lengths) = self.kind(&array.elem)?;
                let length = self.expression(&array.len, &BTreeMap::new())?;
                Ok((element, format!("[{length}]{lengths}")))
            }
            Type::Path(path) => match path.path.get_ident().map(ToString::to_string).as_deref() {
                Some("f64") => Ok(("double", String::new())),
                Some("bool") => Ok(("int", String::new())),
                Some("usize" | "u64" | "u32" | "u16" | "u8" | "isize" | "i64" | "i32" | "i16" | "i8") => {
                    Ok(("long long", String::new()))
                }
                _ => Err(other()),
            },
            _ => Err(other()),
        }
    }

    /// An expression in C, where some names are known.
    pub(super) fn expression(&self, expression: &Expr, known: &BTreeMap<String, String>) -> Result<String, Obstacle> {
        let in_c = |expression: &Expr| self.expression(expression, known);
        let refused = || {
            let text = expression.to_token_stream().to_string();
            Err((
                expression.span(),
                format!(
                    "`export` has no C code for the parameter expression `{text}`\nhelp: compute it before, and keep it in a field"
                ),
            ))
        };
        Ok(match expression {
            Expr::Lit(literal) => match &literal.lit {
                Lit::Float(number) => {
                    number.base10_digits().to_owned() + if number.base10_digits().ends_with('.') { "0" } else { "" }
                }
                Lit::Int(number) if number.suffix() == "f64" => format!("{}.0", number.base10_digits()),
                Lit::Int(number) => number.base10_digits().to_owned(),
                Lit::Bool(flag) => i32::from(flag.value).to_string(),
                _ => return refused(),
            },
            Expr::Paren(inner) => in_parentheses(&in_c(&inner.expr)?),
            Expr::Group(inner) => in_c(&inner.expr)?,
            Expr::Unary(unary) => match unary.op {
                UnOp::Neg(_) => format!("-{}", in_c(&unary.expr)?),
                UnOp::Not(_) => format!("!{}", in_c(&unary.expr)?),
                _ => return refused(),
            },
            Expr::Binary(binary) => {
                if matches!(binary.op, BinOp::Rem(_)) && !self.is_integer(expression, known) {
                    return Ok(format!("fmod({}, {})", in_c(&binary.left)?, in_c(&binary.right)?));
                }
                let sign = match binary.op {
                    BinOp::Add(_) => "+",
                    BinOp::Sub(_) => "-",
                    BinOp::Mul(_) => "*",
                    BinOp::Div(_) => "/",
                    BinOp::Rem(_) => "%",
                    BinOp::Lt(_) => "<",
                    BinOp::Le(_) => "<=",
                    BinOp::Gt(_) => ">",
                    BinOp::Ge(_) => ">=",
                    BinOp::Eq(_) => "==",
                    BinOp::Ne(_) => "!=",
                    BinOp::And(_) => "&&",
                    BinOp::Or(_) => "||",
                    _ => return refused(),
                };
                format!("({} {sign} {})", in_c(&binary.left)?, in_c(&binary.right)?)
            }
            Expr::Cast(cast) => {
                let kind = self.kind(&cast.ty)?.0;
                format!("({kind}){}", in_parentheses(&in_c(&cast.expr)?))
            }
            Expr::Field(field) => match (&*field.base, &field.member) {
                (Expr::Path(base), syn::Member::Named(name)) if base.path.is_ident("self") => {
                    format!("parameters->{}", identifier(&name.to_string()))
                }
                _ => return refused(),
            },
            Expr::Index(index) => format!("{}[{}]", in_c(&index.expr)?, in_c(&index.index)?),
            Expr::If(choice) => {
                let Some((_, otherwise)) = &choice.else_branch else { return refused() };
                let [holds, otherwise] = [self.block(&choice.then_branch, known)?, in_c(otherwise)?];
                format!("({} ? {holds} : {otherwise})", in_c(&choice.cond)?)
            }
            Expr::Reference(reference) => in_c(&reference.expr)?,
            Expr::Block(block) => self.block(&block.block, known)?,
            Expr::Path(path) => match self.named(path, known)? {
                Some(text) => text,
                None => return refused(),
            },
            Expr::MethodCall(call) if self.is_integer(&call.receiver, known) && call.method != "has" => {
                return refused();
            }
            Expr::MethodCall(call) => {
                let arguments =
                    std::iter::once(&*call.receiver).chain(&call.args).map(in_c).collect::<Result<Vec<_>, _>>()?;
                match function(&call.method.to_string(), &arguments) {
                    Some(text) => text,
                    None => return refused(),
                }
            }
            Expr::Call(call) => {
                let Expr::Path(path) = &*call.func else { return refused() };
                let name = path.path.segments.last().map(|last| last.ident.to_string()).unwrap_or_default();
                match function(&name, &call.args.iter().map(in_c).collect::<Result<Vec<_>, _>>()?) {
                    Some(text) => text,
                    None => return refused(),
                }
            }
            _ => return refused(),
        })
    }

    /// A name: an index, a constant of `std`, of a type or of a module.
    fn named(&self, path: &ExprPath, known: &BTreeMap<String, String>) -> Result<Option<String>, Obstacle> {
        let segments: Vec<String> = path.path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        let [before @ .., name] = &segments[..] else { return Ok(None) };
        if let ([], Some(text)) = (before, known.get(name).filter(|text| !text.is_empty())) {
            return Ok(Some(text.clone()));
        }
        let owner = before.last().map(|owner| if owner == "Self" { self.system } else { owner });
        let constant = [owner, None].into_iter().find_map(|owner| self.items.constant(owner, name));
        // A constant that is made from itself is no Rust.
        let key = segments.join("::");
        match constant.filter(|_| !known.contains_key(&key) && before.last().is_none_or(|owner| owner != "consts")) {
            Some(value) => {
                let text = self
                    .expression(value, &BTreeMap::from_iter([(key, String::new())].into_iter().chain(known.clone())))?;
                Ok(Some(in_parentheses(&text)))
            }
            None => Ok(of_std(name).map(str::to_owned)),
        }
    }

    /// Whether an expression is an integer: its operators are others in C.
    fn is_integer(&self, expression: &Expr, known: &BTreeMap<String, String>) -> bool {
        let is_of = |kind: &Type| self.kind(kind).is_ok_and(|(kind, _)| kind == "long long");
        match expression {
            Expr::Lit(literal) => matches!(&literal.lit, Lit::Int(number) if number.suffix() != "f64"),
            Expr::Paren(inner) => self.is_integer(&inner.expr, known),
            Expr::Group(inner) => self.is_integer(&inner.expr, known),
            Expr::Unary(unary) => self.is_integer(&unary.expr, known),
            Expr::Index(index) => self.is_integer(&index.expr, known),
            Expr::Binary(binary) => self.is_integer(&binary.left, known) || self.is_integer(&binary.right, known),
            Expr::Cast(cast) => is_of(&cast.ty),
            Expr::Path(path) => path.path.get_ident().is_some_and(|name| is_index(&name.to_string(), known)),
            Expr::Field(field) => {
                let fields = self.items.fields(self.system).unwrap_or_default();
                let name = field.member.to_token_stream().to_string();
                fields.iter().any(|field| field.ident.as_ref().is_some_and(|known| *known == name) && is_of(&field.ty))
            }
            _ => false,
        }
    }

    /// A block whose lets are written where they are read.
    fn block(&self, block: &Block, known: &BTreeMap<String, String>) -> Result<String, Obstacle> {
        let (mut known, mut value) = (known.clone(), String::new());
        for statement in &block.stmts {
            match statement {
                Stmt::Local(local) => match (&local.pat, &local.init) {
                    (Pat::Ident(name), Some(start)) => {
                        let text = self.expression(&start.expr, &known)?;
                        known.insert(name.ident.to_string(), in_parentheses(&text));
                    }
                    _ => return Err((local.span(), "`export` has no C code for this `let`".to_owned())),
                },
                Stmt::Expr(expression, None) => value = self.expression(expression, &known)?,
                other => return Err((other.span(), "`export` has no C code for this statement\nhelp: compute the parameter before, and keep it in a field".to_owned())),
            }
        }
        Ok(value)
    }
}

/// Whether a name is the index of a loop, which keeps its name in C.
fn is_index(name: &str, known: &BTreeMap<String, String>) -> bool {
    known.get(name).is_some_and(|text| *text == identifier(name))
}

/// The text of a documentation comment.
fn documented(attribute: &syn::Attribute) -> Option<String> {
    match &attribute.meta {
        syn::Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(syn::ExprLit { lit: Lit::Str(text), .. }) => Some(text.value().trim().replace("*/", "* /")),
            _ => None,
        },
        _ => None,
    }
}

/// An expression as one operand.
fn in_parentheses(text: &str) -> String {
    let is_word = text.chars().all(|letter| letter.is_ascii_alphanumeric() || matches!(letter, '_' | '.'));
    let mut depth = 0;
    let closes = text.find(|letter| {
        depth += i32::from(letter == '(') - i32::from(letter == ')');
        depth == 0
    });
    if is_word || text.starts_with('(') && closes == Some(text.len() - 1) {
        text.to_owned()
    } else {
        format!("({text})")
    }
}

/// A constant of `std` as a literal.
fn of_std(name: &str) -> Option<&'static str> {
    let known = [
        ("PI", "3.141592653589793"),
        ("TAU", "6.283185307179586"),
        ("FRAC_PI_2", "1.5707963267948966"),
        ("E", "2.718281828459045"),
        ("SQRT_2", "1.4142135623730951"),
        ("LN_2", "0.6931471805599453"),
        ("NAN", "(0.0 / 0.0)"),
        ("INFINITY", "(1.0 / 0.0)"),
        ("NEG_INFINITY", "(-1.0 / 0.0)"),
    ];
    known.iter().find(|(known, _)| *known == name).map(|(_, value)| *value)
}

/// A method of `f64` as a call of C; the maths library of both is the same.
fn function(name: &str, arguments: &[String]) -> Option<String> {
    let text = match (name, arguments) {
        ("powi", [x, n]) => return Some(power(x, n.trim_matches(['(', ')']).parse().ok()?)),
        // Whether an array has an element, as generated code checks it.
        ("Elements", [list]) => return Some(list.clone()),
        ("has", [list, index]) => return Some(format!("({index} < (long long)(sizeof {list} / sizeof {list}[0]))")),
        ("recip", [x]) => return Some(format!("(1.0 / {x})")),
        ("clone", [x]) => return Some(x.clone()),
        ("from", [x]) => return Some(format!("(double)({x})")),
        ("signum", [x]) => return Some(format!("copysign(1.0, {x})")),
        ("abs", [_]) => "fabs",
        ("ln", [_]) => "log",
        ("ln_1p", [_]) => "log1p",
        ("exp_m1", [_]) => "expm1",
        ("round_ties_even", [_]) => "rint",
        ("powf", [..]) => "pow",
        ("mul_add", [..]) => "fma",
        ("max", [..]) => "fmax",
        ("min", [..]) => "fmin",
        (
            "sin" | "cos" | "tan" | "asin" | "acos" | "atan" | "sinh" | "cosh" | "tanh" | "asinh" | "acosh" | "atanh"
            | "exp" | "exp2" | "log2" | "log10" | "sqrt" | "cbrt" | "floor" | "ceil" | "trunc" | "round" | "atan2"
            | "hypot",
            _,
        ) => name,
        _ => return None,
    };
    Some(format!("{text}({})", arguments.join(", ")))
}

/// The products of `powi`, in the order of Rust's compiler.
fn power(x: &str, exponent: i32) -> String {
    let (mut left, mut square, mut power) = (exponent.unsigned_abs(), x.to_owned(), None);
    while left > 0 {
        if left % 2 == 1 {
            power = Some(power.map_or(square.clone(), |power| format!("({power} * {square})")));
        }
        left /= 2;
        square = format!("({square} * {square})");
    }
    let power = power.unwrap_or_else(|| "1.0".to_owned());
    if exponent < 0 { format!("(1.0 / {power})") } else { power }
}
