//! The user's names as valid C++ identifiers.

use super::functions::device_functions;
use proc_macro2::Ident;

/// A name of the user's as C++ may have it; two names stay two.
pub(super) fn identifier(name: &Ident) -> String {
    identifier_of(&name.to_string())
}

/// The same of a name that is text.
pub(crate) fn identifier_of(name: &str) -> String {
    let name = name.strip_prefix("r#").unwrap_or(name);
    let mut plain = String::new();
    for letter in name.chars() {
        match letter {
            letter if letter.is_ascii() && letter != 'U' => plain.push(letter),
            // What begins with `U` is such a letter, and nothing else.
            letter => plain.push_str(&format!("U{:x}_", u32::from(letter))),
        }
    }
    // What another name becomes by an underscore gets one more.
    if is_taken(plain.trim_end_matches('_')) { plain + "_" } else { plain }
}

/// Whether a name means something else in the text, or may: macros have no small letters, or begin with an underscore.
fn is_taken(name: &str) -> bool {
    // Loops that load tables have the indices `i0`, `i1` and so on; constants that are named by a path are numbered.
    let is_numbered = ["i", "path_"].iter().any(|start| {
        name.strip_prefix(start)
            .is_some_and(|rest| !rest.is_empty() && rest.bytes().all(|letter| letter.is_ascii_digit()))
    });
    let is_reserved = name.starts_with('_') || !name.bytes().any(|letter| letter.is_ascii_lowercase());
    let is_function = device_functions().any(|known| known == name)
        || ["fast_", "library_", "partial_"].iter().any(|start| name.starts_with(start));
    is_numbered || is_reserved || is_function || TAKEN.contains(&name)
}

/// Names that mean something in C++ or C, or in the text around the lines.
const TAKEN: [&str; 113] = [
    "Motion",
    "Parameters",
    "PartialSums",
    "Source",
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asm",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "break",
    "case",
    "catch",
    "char",
    "char16_t",
    "char32_t",
    "char8_t",
    "class",
    "co_await",
    "co_return",
    "co_yield",
    "compl",
    "concept",
    "const",
    "const_cast",
    "consteval",
    "constexpr",
    "constinit",
    "continue",
    "contribution",
    "decltype",
    "default",
    "delete",
    "do",
    "div_pow_3_2",
    "double",
    "duration",
    "dynamic_cast",
    "element_of",
    "else",
    "enum",
    "errno",
    "explicit",
    "export",
    "extern",
    "false",
    "float",
    "fma",
    "for",
    "friend",
    "goto",
    "gradient",
    "if",
    "infinity",
    "inline",
    "int",
    "least",
    "long",
    "main",
    "motion",
    "mutable",
    "namespace",
    "new",
    "noexcept",
    "not",
    "not_a_number",
    "not_eq",
    "nullptr",
    "number",
    "operator",
    "or",
    "or_eq",
    "private",
    "protected",
    "public",
    "register",
    "reinterpret_cast",
    "requires",
    "restrict",
    "return",
    "short",
    "signed",
    "sin_cos",
    "sizeof",
    "static",
    "static_assert",
    "static_cast",
    "step",
    "struct",
    "switch",
    "template",
    "this",
    "thread_local",
    "throw",
    "time",
    "true",
    "try",
    "typedef",
    "typeid",
    "typename",
    "union",
    "unsigned",
    "using",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "while",
    "xor",
    "xor_eq",
];
