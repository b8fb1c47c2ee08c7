//! Values of the interpreter, and why an evaluation stops.

use crate::number::{Kind, Number};
use std::rc::Rc;
use syn::Ident;

/// Why an evaluation did not go on.
#[derive(Clone)]
pub(crate) enum Stop {
    /// What Rust does at this place in a debug build is a panic.
    Panic(String),
    /// This is no Rust, or Rust that the interpreter was not taught.
    Foreign(String),
    Continue,
    Break,
    Return(Box<Value>),
}

impl std::fmt::Display for Stop {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Panic(what) => write!(f, "a panic: {what}"),
            Self::Foreign(what) => write!(f, "no Rust that is known here: {what}"),
            Self::Continue | Self::Break | Self::Return(_) => f.write_str("control flow without a loop"),
        }
    }
}

pub(crate) type Outcome<T> = Result<T, Stop>;

pub(crate) fn foreign<T>(what: impl Into<String>) -> Outcome<T> {
    Err(Stop::Foreign(what.into()))
}

pub(crate) fn panic<T>(what: impl Into<String>) -> Outcome<T> {
    Err(Stop::Panic(what.into()))
}

/// An argument of a call.
pub(crate) fn argument(arguments: &[Value], place: usize) -> Outcome<&Value> {
    match arguments.get(place) {
        Some(argument) => Ok(argument),
        None => foreign("an argument is missing"),
    }
}

/// An integer type; that of a literal follows from what it meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct IntegerType {
    pub(crate) name: &'static str,
    pub(crate) from: i128,
    pub(crate) to: i128,
}

macro_rules! integer_types {
    ($($name:ident)*) => {
        pub(crate) const INTEGER_TYPES: &[IntegerType] =
            &[$(IntegerType { name: stringify!($name), from: $name::MIN as i128, to: $name::MAX as i128 }),*];
    };
}
integer_types! { usize u8 u16 u32 u64 isize i8 i16 i32 i64 }

pub(crate) const USIZE: IntegerType = INTEGER_TYPES[0];

impl IntegerType {
    pub(crate) fn named(name: &str) -> Option<Self> {
        INTEGER_TYPES.iter().copied().find(|known| known.name == name)
    }
    /// What `as` makes of a number that does not fit.
    pub(crate) fn wrapped(self, value: i128) -> i128 {
        let count = self.to - self.from + 1;
        self.from + (value - self.from).rem_euclid(count)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Integer {
    pub(crate) value: i128,
    pub(crate) of: Option<IntegerType>,
}

impl Integer {
    pub(crate) fn size(value: usize) -> Self {
        Self { value: value as i128, of: Some(USIZE) }
    }

    /// The type that two operands have in common.
    pub(crate) fn common(self, other: Self) -> Outcome<Option<IntegerType>> {
        match (self.of, other.of) {
            (Some(a), Some(b)) if a != b => foreign(format!("{} meets {}", a.name, b.name)),
            (a, b) => Ok(a.or(b)),
        }
    }

    /// The result of arithmetic, checked as in a debug build.
    pub(crate) fn checked(value: Option<i128>, of: Option<IntegerType>) -> Outcome<Self> {
        let range = of.or_else(|| IntegerType::named("i32"));
        match (value, range) {
            (Some(value), Some(range)) if (range.from..=range.to).contains(&value) => Ok(Self { value, of }),
            _ => panic("an integer overflows"),
        }
    }
}

/// A function that was written in place, with what it sees.
pub(crate) struct Closure {
    pub(crate) text: syn::ExprClosure,
    pub(crate) seen: Vec<(Ident, Value)>,
}

/// An element of a sequence, evaluated when it is asked for, as by the iterators of `std`.
#[derive(Clone)]
pub(crate) enum Element {
    Ready(Value),
    Mapped(Value, Rc<Element>),
    Both(Rc<Element>, Rc<Element>),
}

#[derive(Clone)]
pub(crate) enum Value {
    Unit,
    Bool(bool),
    /// What a comparison in a flow gives.
    Mask(bool),
    /// A mask of lanes that disagree.
    Torn,
    Integer(Integer),
    Number(Number),
    /// A coordinate in a motion.
    Slot(Number),
    /// An array, a slice or a `Vec`.
    List(Rc<Vec<Value>>),
    Tuple(Rc<Vec<Value>>),
    Range(Integer, Integer),
    Sequence(Rc<Vec<Element>>),
    Option(Option<Rc<Value>>),
    Struct(Rc<Vec<(String, Value)>>),
    Closure(Rc<Closure>),
    /// A function that is passed by its path.
    Path(String),
    /// Something of the runtime that is told numbers: what is called on it is noted by the machine.
    Told,
    /// What is around a site of a lattice.
    Site(Rc<crate::drivers::Site>),
}

impl From<Number> for Value {
    fn from(number: Number) -> Self {
        Self::Number(number)
    }
}

impl From<Integer> for Value {
    fn from(integer: Integer) -> Self {
        Self::Integer(integer)
    }
}

impl Value {
    pub(crate) fn plain(value: f64) -> Self {
        Number::plain(value).into()
    }
    pub(crate) fn size(value: usize) -> Self {
        Integer::size(value).into()
    }
    pub(crate) fn list(values: impl IntoIterator<Item = Self>) -> Self {
        Self::List(Rc::new(values.into_iter().collect()))
    }
    pub(crate) fn tuple(values: impl IntoIterator<Item = Self>) -> Self {
        Self::Tuple(Rc::new(values.into_iter().collect()))
    }

    /// What it is, in a word.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Self::Unit => "nothing",
            Self::Bool(_) => "a truth",
            Self::Mask(_) | Self::Torn => "a mask",
            Self::Integer(_) => "an integer",
            Self::Number(_) => "a number",
            Self::Slot(_) => "a slot",
            Self::List(_) => "a list",
            Self::Tuple(_) => "a tuple",
            Self::Range(..) => "a range",
            Self::Sequence(_) => "an iterator",
            Self::Option(_) => "an option",
            Self::Struct(_) => "a struct",
            Self::Closure(_) | Self::Path(_) => "a function",
            Self::Told => "something of the runtime",
            Self::Site(_) => "a site",
        }
    }

    pub(crate) fn number(&self) -> Outcome<&Number> {
        match self {
            Self::Number(number) => Ok(number),
            other => foreign(format!("{} in place of a number", other.kind())),
        }
    }
    pub(crate) fn integer(&self) -> Outcome<Integer> {
        match self {
            Self::Integer(integer) => Ok(*integer),
            other => foreign(format!("{} in place of an integer", other.kind())),
        }
    }
    /// An index or a length.
    pub(crate) fn index(&self) -> Outcome<usize> {
        let integer = self.integer()?;
        match integer.of {
            None | Some(USIZE) => usize::try_from(integer.value).or_else(|_| panic("an index below zero")),
            Some(of) => foreign(format!("{} as an index", of.name)),
        }
    }
    pub(crate) fn truth(&self) -> Outcome<bool> {
        match self {
            Self::Bool(truth) => Ok(*truth),
            other => foreign(format!("{} in place of a truth", other.kind())),
        }
    }
    pub(crate) fn mask(&self) -> Outcome<bool> {
        match self {
            Self::Mask(mask) => Ok(*mask),
            Self::Torn => Ok(true),
            other => foreign(format!("{} in place of a mask", other.kind())),
        }
    }

    /// A method of a mask of lanes that disagree.
    pub(crate) fn of_torn(&self, name: &str, arguments: &[Value]) -> Outcome<Value> {
        Ok(match (name, arguments) {
            ("any", []) => Self::Bool(true),
            ("and", [Self::Mask(false)]) => Self::Mask(false),
            ("or", [Self::Mask(true)]) => Self::Mask(true),
            ("not", []) | ("and" | "or", [Self::Mask(_) | Self::Torn]) => Self::Torn,
            _ => return foreign(format!("`{name}` of a mask")),
        })
    }
    pub(crate) fn items(&self) -> Outcome<&[Value]> {
        match self {
            Self::List(items) => Ok(items),
            other => foreign(format!("{} in place of a list", other.kind())),
        }
    }
    pub(crate) fn field(&self, name: &str) -> Outcome<&Value> {
        match self {
            Self::Struct(fields) => match fields.iter().find(|(known, _)| known == name) {
                Some((_, value)) => Ok(value),
                None => foreign(format!("no field `{name}`")),
            },
            other => foreign(format!("a field `{name}` of {}", other.kind())),
        }
    }
    /// The element of a list.
    pub(crate) fn at(&self, index: usize) -> Outcome<&Value> {
        let items = self.items()?;
        match items.get(index) {
            Some(item) => Ok(item),
            None => panic(format!("index out of bounds: the len is {} but the index is {index}", items.len())),
        }
    }

    /// The same with every number inside as a number of another kind.
    pub(crate) fn lifted(&self, kind: Kind) -> Self {
        match self {
            Self::Number(number) => number.clone().of_kind(kind).into(),
            Self::List(items) => Self::list(items.iter().map(|item| item.lifted(kind))),
            Self::Struct(fields) => {
                let lifted = fields.iter().map(|(name, value)| (name.clone(), value.lifted(kind)));
                Self::Struct(Rc::new(lifted.collect()))
            }
            other => other.clone(),
        }
    }

    /// The numbers inside, in order.
    pub(crate) fn numbers(&self, into: &mut Vec<Number>) {
        match self {
            Self::Integer(integer) => into.push(Number::plain(integer.value as f64)),
            Self::Number(number) | Self::Slot(number) => into.push(number.clone()),
            Self::List(items) => items.iter().for_each(|item| item.numbers(into)),
            _ => {}
        }
    }
}
