//! The properties of a composition that its kernels know at compile time.

use crate::launch::Launch;
use integrator_core::__private::StageRow;

/// The text of `Composed` for the stages of a launch; that of any composition is [`ANY_COMPOSITION`](crate::launch::ANY_COMPOSITION).
pub(crate) fn composed(launch: &Launch, stages: &[StageRow]) -> String {
    let Launch { leads_with_kick, cycle, before, after, is_whole, .. } = *launch;
    let has_gradients = stages.iter().any(|[_, _, gradient, ..]| *gradient != 0.0);
    let has_processor = (before, after) != (0, 0);
    format!(
        "struct Composed {{\n    static constexpr int CYCLE = {cycle};\n    static constexpr bool LEADS_WITH_KICK = {}, \
         HAS_GRADIENTS = {has_gradients}, HAS_PROCESSOR = {has_processor}, MAY_BE_WHOLE = {};\n}};\n",
        leads_with_kick != 0,
        is_whole != 0
    )
}
