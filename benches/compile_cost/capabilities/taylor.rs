// Arguments of the annotation: taylor
pub fn perform() -> Result<(), Box<dyn std::error::Error>> {
    let mut run = system().run_with(integrator_core::taylor::Taylor::tolerance(1e-16), start(), 0.01)?;
    run.advance(1000)?;
    println!("{:?} {}", run.state(), run.energy());
    Ok(())
}
