//! What a command found, for people and for programs.

use serde_json::Value;

/// The same twice.
pub(crate) struct Answer {
    pub(crate) text: String,
    pub(crate) json: Value,
}
