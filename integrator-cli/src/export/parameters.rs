//! The user's fields and constants in C, and expressions that read them.
//!
//! In: the struct and the constants of a file, and Rust expressions of parameters. Out: members and expressions of C99, in the
//! order of operations of the Rust text; or the place that has no equivalent.

use integrator_symbolic::identifier;
use proc_macro2::{Span, TokenStream, TokenTree};
use std::collections::BTreeMap;
use syn::{BinOp, Block, Expr, Fields, ItemConst, ItemStruct, Lit, Pat, Stmt, Type, UnOp, spanned::Spanned};

/// What cannot be translated, and where.
pub(super) type Obstacle = (Span, String);

/// A field of the user's struct.
pub(super) struct Field {
    pub(super) name: String,
    /// The type in C, and the lengths of an array; the type in Rust where C has none.
    pub(super) kind: Result<(&'static str, String), (Span, String)>,
    pub(super) documentation: String,
}

/// Structs and constants of a file, by name; those of an impl by `Self::NAME`.
#[derive(Default)]
pub(super) struct Items {
    structs: BTreeMap<String, ItemStruct>,
    constants: BTreeMap<String, Expr>,
}

impl Items {
    /// The items in tokens, however deep.
    pub(super) fn of(tokens: TokenStream) -> Self {
        let mut items = Self::default();
        items.add(tokens);
        items
    }

    fn add(&mut self, tokens: TokenStream) {
        let trees: Vec<TokenTree> = tokens.into_iter().collect();
        let ends = |tree: &TokenTree, is_struct: bool| match tree {
            TokenTree::Punct(mark) => mark.as_char() == ';',
            TokenTree::Group(group) => is_struct && group.delimiter() == proc_macro2::Delimiter::Brace,
            _ => false,
        };
        for (at, tree) in trees.iter().enumerate() {
            match tree {
                TokenTree::Ident(word) if word == "struct" || word == "const" => {
                    let length = trees[at..]
                        .iter()
                        .position(|tree| ends(tree, word == "struct"))
                        .map_or(trees.len() - at, |end| end + 1);
                    let item: TokenStream = trees[at..at + length].iter().cloned().collect();
                    if let Ok(found) = syn::parse2::<ItemStruct>(item.clone()) {
                        self.structs.insert(found.ident.to_string(), found);
                    } else if let Ok(found) = syn::parse2::<ItemConst>(item) {
                        self.constants.insert(found.ident.to_string(), *found.expr);
                    }
                }
                TokenTree::Group(group) => self.add(group.stream()),
                _ => {}
            }
        }
    }

    /// The fields of a struct; `None` if it is declared elsewhere.
    pub(super) fn fields(&self, system: &str) -> Option<Vec<Field>> {
        let Fields::Named(fields) = &self.structs.get(system)?.fields else { return Some(Vec::new()) };
        let field = |field: &syn::Field| {
            let name = field.ident.as_ref()?.to_string();
            let documentation = field.attrs.iter().filter_map(|attribute| match &attribute.meta {
                syn::Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
                    Expr::Lit(text) => match &text.lit {
                        Lit::Str(text) => Some(text.value().trim().replace("*/", "* /")),
                        _ => None,
                    },
                    _ => None,
                },
                _ => None,
            });
            Some(Field { kind: self.kind(&field.ty), documentation: documentation.collect::<Vec<_>>().join(" "), name })
        };
        Some(fields.named.iter().filter_map(field).collect())
    }

    /// A type in C, and the lengths of an array.
    fn kind(&self, kind: &Type) -> Result<(&'static str, String), Obstacle> {
        let other = || {
            let text = quote::ToTokens::to_token_stream(kind).to_string().replace(' ', "");
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
            let text = quote::ToTokens::to_token_stream(expression).to_string();
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
            Expr::Path(path) => {
                let name = path.path.segments.last().map(|last| last.ident.to_string()).unwrap_or_default();
                match (known.get(&name), self.constants.get(&name), of_std(&name)) {
                    (Some(text), ..) => text.clone(),
                    (None, Some(value), _) => in_parentheses(&in_c(value)?),
                    (None, None, Some(value)) => value.to_owned(),
                    _ => return refused(),
                }
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
