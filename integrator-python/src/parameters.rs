//! Keyword arguments of a system, by serde: the fields of the user's struct are their names.

use crate::{
    arrays::frozen,
    errors::{input_error, nearest},
};
use pyo3::{
    exceptions::PyTypeError,
    prelude::*,
    types::{PyDict, PyList, PyTuple},
};
use pythonize::{Depythonizer, pythonize};
use serde::{
    Serialize,
    de::{self, DeserializeOwned, DeserializeSeed, Error as _, MapAccess, Visitor, value::Error},
    forward_to_deserialize_any,
};

/// A system whose fields Python can set and read.
#[diagnostic::on_unimplemented(
    message = "the fields of `{Self}` cannot become keyword arguments of Python",
    label = "has no `Clone`, `serde::Serialize` or `serde::Deserialize`",
    note = "write `#[derive(Clone, serde::Deserialize, serde::Serialize)]`, and in Cargo.toml `serde = {{ version = \"1\", \
            features = [\"derive\"] }}`"
)]
pub trait Parameters: Clone + Serialize + DeserializeOwned + Send + Sync + 'static {}

impl<H: Clone + Serialize + DeserializeOwned + Send + Sync + 'static> Parameters for H {}

/// The names of the fields of a struct; `None` if serde does not give them, as for `#[serde(flatten)]`.
pub(crate) fn field_names<H: Parameters>() -> Option<&'static [&'static str]> {
    let mut names = None;
    // It never builds a value: the deserializer notes what is requested.
    let _ = H::deserialize(Names(&mut names));
    names
}

struct Names<'n>(&'n mut Option<&'static [&'static str]>);

impl<'de> de::Deserializer<'de> for Names<'_> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Error> {
        Err(Error::custom("no value"))
    }
    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        *self.0 = Some(fields);
        self.deserialize_any(visitor)
    }
    fn deserialize_unit_struct<V: Visitor<'de>>(self, name: &'static str, visitor: V) -> Result<V::Value, Error> {
        self.deserialize_struct(name, &[], visitor)
    }
    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit newtype_struct seq tuple
        tuple_struct map enum identifier ignored_any
    }
}

/// Builds a system from keyword arguments.
///
/// # Errors
/// `TypeError` for unknown and missing names, `InputError` for values of the wrong type.
pub(crate) fn build<H: Parameters>(system: &str, keywords: &Bound<'_, PyDict>) -> PyResult<H> {
    let names = field_names::<H>();
    for keyword in keywords.keys() {
        let keyword: String = keyword.extract()?;
        if let Some(names) = names.filter(|names| !names.contains(&&*keyword)) {
            let (help, names) = (nearest(keywords.py(), &keyword, names), names.join(", "));
            let note = if names.is_empty() { "it has no parameters" } else { "its parameters are " };
            let message = format!("{system}() has no parameter `{keyword}`{help}\nnote: {note}{names}");
            return Err(PyTypeError::new_err(message));
        }
    }
    H::deserialize(Keywords(keywords)).map_err(|error| match error.to_string().strip_prefix("missing field ") {
        Some(field) => PyTypeError::new_err(format!("{system}() requires the parameter {field}")),
        None => input_error(format!("{system}(): {error}")),
    })
}

/// The parameters of a system by their names. Arrays of numbers are NumPy arrays that cannot be written.
pub(crate) fn listed<'py, H: Parameters>(py: Python<'py>, system: &H) -> PyResult<Bound<'py, PyDict>> {
    let (fields, parameters) = (pythonize(py, system)?, PyDict::new(py));
    if let Ok(fields) = fields.cast::<PyDict>() {
        for (name, value) in fields {
            parameters.set_item(name, frozen(&value)?)?;
        }
    }
    Ok(parameters)
}

/// Keyword arguments as the fields of a struct.
struct Keywords<'a, 'py>(&'a Bound<'py, PyDict>);

impl<'de> de::Deserializer<'de> for Keywords<'_, '_> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_map(Fields { items: self.0.iter().collect::<Vec<_>>(), next: None })
    }
    fn deserialize_unit_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_unit()
    }
    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit newtype_struct seq tuple
        tuple_struct map struct enum identifier ignored_any
    }
}

type Item<'py> = (Bound<'py, PyAny>, Bound<'py, PyAny>);

/// The keyword arguments that are left, and the one whose name was read last.
struct Fields<'py> {
    items: Vec<Item<'py>>,
    next: Option<Item<'py>>,
}

impl<'de> MapAccess<'de> for Fields<'_> {
    type Error = Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Error> {
        self.next = self.items.pop();
        let Some((name, _)) = &self.next else { return Ok(None) };
        seed.deserialize(&mut Depythonizer::from_object(name)).map(Some).map_err(Error::custom)
    }
    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Error> {
        let Some((name, value)) = self.next.take() else { return Err(Error::custom("a value has no name")) };
        let value = plain(&value).map_err(Error::custom)?;
        let read = seed.deserialize(&mut Depythonizer::from_object(&value));
        read.map_err(|error| Error::custom(format!("the parameter `{name}`: {error}")))
    }
}

/// A value with lists in place of NumPy arrays.
fn plain<'py>(value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    if value.is_instance_of::<PyList>() || value.is_instance_of::<PyTuple>() {
        let elements = value.try_iter()?.map(|element| plain(&element?)).collect::<PyResult<Vec<_>>>()?;
        return Ok(PyList::new(value.py(), elements)?.into_any());
    }
    value.getattr("tolist").map_or(Ok(value.clone()), |tolist| tolist.call0())
}
