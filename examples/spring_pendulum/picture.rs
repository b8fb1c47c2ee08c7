//! Picture of the resonance between the outer step and the spring.

use integrator_plot::{Axis, Chart, colour};

/// Points of outer steps in half periods of the spring, and energy errors.
pub(crate) type Curve = Vec<(f64, f64)>;

/// Draws the errors by gravity alone, and by gravity and the rubber band.
pub(crate) fn picture([gravity, with_band]: [Curve; 2]) -> Chart {
    Chart::new("Resonance of outer steps with a stiff spring")
        .claim(
            "A uniform force drives the spring at h·ω = 2π, a force that varies with its length at every multiple of π",
        )
        .along(Axis::linear("outer step in half periods of the spring, h·ω / π").between(0.0, 3.25))
        .up(Axis::logarithmic("largest energy error; runs end at 10").between(1e-6, 20.0))
        .line("gravity and rubber band", with_band)
        .coloured(colour::COLOURS[1])
        .line("gravity alone", gravity)
        .coloured(colour::INK)
}
