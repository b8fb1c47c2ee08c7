pub fn perform() -> Result<(), Box<dyn std::error::Error>> {
    let mut run = system().run_with(integrator_core::GaussLegendre::<8>, start(), 0.01)?;
    run.advance(1000)?;
    println!("{:?} {}", run.state(), run.energy());
    Ok(())
}
