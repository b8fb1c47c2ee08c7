//! The argument that requests device code: `gpu`, `gpu(functions = native)`.

use proc_macro2::{Ident, Span};
use syn::{Token, parenthesized, parse::ParseStream, token::Paren};

/// Whose elementary functions text for devices calls.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum DeviceFunctions {
    /// Those of this library, with the bits of the processor.
    Own,
    /// Those of the device.
    Native,
}

/// Text for devices: `gpu`, `gpu(functions = native)`.
pub(crate) struct Gpu {
    pub(crate) span: Span,
    pub(crate) functions: DeviceFunctions,
}

/// What stands after `gpu`.
pub(super) fn gpu_of(input: ParseStream<'_>, span: Span) -> syn::Result<Gpu> {
    if !input.peek(Paren) {
        return Ok(Gpu { span, functions: DeviceFunctions::Own });
    }
    let is = "unknown argument of `gpu`\nhelp: write `gpu` or `gpu(functions = native)`\nnote: `native` selects the \
              elementary functions of the device, which are not bitwise identical to those of the processor";
    let content;
    parenthesized!(content in input);
    let expect = |expected: &str| match content.parse::<Ident>() {
        Ok(found) if found == expected => Ok(()),
        Ok(found) => Err(syn::Error::new(found.span(), is)),
        Err(_) if content.is_empty() => Err(syn::Error::new(span, is)),
        Err(error) => Err(syn::Error::new(error.span(), is)),
    };
    expect("functions")?;
    content.parse::<Option<Token![=]>>()?;
    expect("native")?;
    if content.is_empty() { Ok(Gpu { span, functions: DeviceFunctions::Native }) } else { Err(content.error(is)) }
}
