//! The elementary functions that device code can call.

use crate::graph::function::{Device, TABLE};

fn named(kinds: [Device; 2]) -> impl Iterator<Item = &'static str> {
    TABLE.iter().filter(move |row| kinds.contains(&row.device)).map(|row| row.name)
}

/// The functions that have the bits of the Rust kernels on a device, or are exact there.
pub(crate) fn device_functions() -> impl Iterator<Item = &'static str> {
    named([Device::Exact, Device::Kernel]).chain(["sqrt"])
}

/// The functions that a device has of its own as well, whose bits are others: of those that are exact it needs none.
pub(super) fn native_functions() -> impl Iterator<Item = &'static str> {
    named([Device::Library, Device::Kernel]).chain(["sin_cos"])
}
