//! The elementary functions that device code can call.

/// The functions that have the bits of the Rust kernels on a device, or are exact there.
pub(super) const KNOWN: [&str; 23] = [
    "abs",
    "acos",
    "asin",
    "atan",
    "atan2",
    "cbrt",
    "ceil",
    "cos",
    "exp",
    "floor",
    "ln",
    "max",
    "min",
    "powf",
    "remainder",
    "round",
    "round_ties_even",
    "signum",
    "sin",
    "sqrt",
    "tan",
    "tanh",
    "trunc",
];

/// The functions that a device has of its own as well, whose bits are others: of those that are exact it needs none.
pub(super) const NATIVE: [&str; 24] = [
    "acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh", "cbrt", "cos", "cosh", "exp", "exp2", "exp_m1",
    "hypot", "ln", "ln_1p", "log10", "log2", "powf", "sin", "sin_cos", "sinh", "tan", "tanh",
];
