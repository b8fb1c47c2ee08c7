//! The chapters of the guide, whose programs are documentation tests. `integrator-plot` tests the chapter that draws, and
//! `integrator-reference` those on textbook methods.

/// One module for each chapter, with a documentation that is tested.
macro_rules! chapters {
    ($($name:ident)*) => {
        $(
            #[doc = include_str!(concat!("../../docs/guide/src/", stringify!($name), ".md"))]
            mod $name {}
        )*
    };
}

chapters!(c_export cookbook introduction orbits_and_chains writing_h parts nonseparable step planets pace composing ensembles gpus clusters python big_systems vectorised_sums taylor deviation_vectors expansion command_line terms limits for_molecular_dynamics);
// What these measure takes the feature `check`.
#[cfg(feature = "check")]
chapters!(choosing splitting fast_and_slow friction generic conserved precision certificates messages for_rebound_users for_accelerators for_samplers);
#[cfg(feature = "frequencies")]
chapters!(chaos);
#[cfg(feature = "output")]
chapters!(seeing_and_saving);
