//! What it may mean that a claim fails, and what to try.

pub(super) const CONVEX: &str = "The potential may be concave along the orbit, so that this is not a property of the method here; or the orbit has left \
     within a period: try half the step.";
pub(super) const SYMPLECTIC: &str =
    "A symplectic method has no such error at any step: the method or the derivative of a flow has a defect.";
pub(super) const SOLVED: &str = "An implicit step may be too long for its equation to be solved to rounding: try half the step. Otherwise a method \
     claims to be symplectic and is not, which is a defect.";
pub(super) const STRAIGHT: &str = "The motion may be nearly that of a free particle, or the step so short that the effect is small: try a longer step.";
pub(super) const OUTLINE: &str = "The set of initial states may be so large that its outline is folded: try a smaller one. Otherwise the method has a defect.";
pub(super) const CHAOS: &str =
    "Rounding grows along a chaotic or escaping orbit: try a shorter period. Otherwise the method has a defect.";
pub(super) const ORDER: &str = "The step may be too long for the first term of the error, or the force not smooth (a kink, a jump, a cutoff): try half the \
     step. If the exponent stays, the method has a defect.";
pub(super) const SAME: &str = "Both are the same map, so that only rounding may differ: along a chaotic orbit it grows; otherwise one of the two has a defect.";
pub(super) const TOLERANCE: &str = "The orbit may pass a kink or a jump of the force, which a tolerance does not resolve; or the reference is no better: try a \
     shorter period.";
pub(super) const DRIFT: &str = "The step may resonate with the motion or be near the limit of stability, or the orbit is chaotic: try a step shorter by a \
     tenth, then half of it. If the error still grows, the method has a defect.";
pub(super) const KEEPS: &str = "The longest step of the portraits may be too short for a method of this order, or the method conserves this energy: no defect.";
pub(super) const STEPPER: &str = "This does not depend on the system: the method or the formula has a defect.";
pub(super) const SERIES: &str =
    "The step may be too long for the series of the modified Hamiltonian: try half the step.";
