//! Every check is fed what is right and what is wrong: the right ones pass, and each wrong one is told by its name.

mod parts;
mod schemes;
mod systems;

mod any_units;
mod edges;
mod flows;
mod modified;
mod orbit;
mod right;
mod stated;
mod steps;
mod wrong;
