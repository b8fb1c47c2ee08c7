//! The properties of a composition that its kernels know at compile time.

use crate::launch::{Launch, Row};

/// The text of `Composed` for the stages of a launch; that of any composition is [`ANY_COMPOSITION`](crate::launch::ANY_COMPOSITION).
pub(crate) fn composed(launch: &Launch, stages: &[Row]) -> String {
    let Launch { leads_with_kick, cycle, before, after, .. } = *launch;
    let has_gradients = stages.iter().any(|[_, _, gradient, ..]| *gradient != 0.0);
    let has_processor = (before, after) != (0, 0);
    format!(
        "struct Composed {{\n    static constexpr int CYCLE = {cycle};\n    static constexpr bool LEADS_WITH_KICK = {}, \
         HAS_GRADIENTS = {has_gradients}, HAS_PROCESSOR = {has_processor};\n}};\n",
        leads_with_kick != 0
    )
}
