//! Picture of the cascade of doublings and of a strange attractor.

use integrator_plot::{Axis, Chart, Panels, colour};

/// Draws the diagram of angular velocities, with lines at the doublings, and the section of the attractor at a torque.
pub(crate) fn picture(
    diagram: &[(f64, f64)],
    doublings: &[f64],
    ratio: f64,
    torque: f64,
    attractor: &[(f64, f64)],
) -> Panels {
    let range = |values: &mut dyn Iterator<Item = f64>| {
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], value| [least.min(value), most.max(value)])
    };
    let [low, high] = range(&mut diagram.iter().map(|(_, p)| *p));
    let mut cascade = Chart::new("Cascade of doublings")
        .claim("Angular velocity once per period of the drive. Lines: torques at which the period doubles")
        .along(Axis::linear("amplitude of the torque"))
        .up(Axis::linear("angular velocity"))
        .cloud("", diagram.iter().copied())
        .coloured(colour::INK);
    for doubling in doublings.iter().take(3) {
        cascade = cascade.line("", [(*doubling, low), (*doubling, high)]).coloured(colour::COLOURS[3]).wide(1.0);
    }
    let strange = Chart::new(format!("Strange attractor at a torque of {torque}"))
        .claim("Once per period of the drive")
        .along(Axis::linear("angle in rad"))
        .up(Axis::linear("angular velocity"))
        .cloud("", attractor.iter().copied())
        .coloured(colour::COLOURS[6]);
    Panels::new("Driven pendulum", "The period doubles again and again, until the motion is chaotic")
        .measured(format!("ratio of the last intervals between doublings: {ratio:.4}"))
        .columns(2)
        .panel(620, 520)
        .chart(cascade)
        .chart(strange)
}
