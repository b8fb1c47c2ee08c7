//! Errors are gathered, so that all of them are reported at once.

use proc_macro2::TokenStream;

/// The errors found so far.
#[derive(Default)]
pub(super) struct Errors(Vec<syn::Error>);

impl Errors {
    pub(super) fn push(&mut self, error: syn::Error) {
        self.0.push(error);
    }

    /// The value, if there is one; else the error is kept.
    pub(super) fn keep<T>(&mut self, outcome: syn::Result<T>) -> Option<T> {
        outcome.map_err(|error| self.push(error)).ok()
    }

    pub(super) fn count(&self) -> usize {
        self.0.len()
    }

    /// All errors as one, if there is any.
    pub(super) fn combined(self) -> Option<syn::Error> {
        self.0.into_iter().reduce(|mut all, next| {
            all.combine(next);
            all
        })
    }

    pub(super) fn into_tokens(self) -> TokenStream {
        self.combined().map_or_else(TokenStream::new, |error| error.to_compile_error())
    }
}
