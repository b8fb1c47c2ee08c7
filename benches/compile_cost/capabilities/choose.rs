pub fn perform() -> Result<(), Box<dyn std::error::Error>> {
    use integrator_core::check::{Goal, choose};
    println!("{}", choose(&system(), start(), 1.0, Goal::Trajectory(1e-6))?);
    Ok(())
}
