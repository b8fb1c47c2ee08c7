pub fn perform() -> Result<(), Box<dyn std::error::Error>> {
    let mut run = system().run_with(Paced(integrator_core::GaussLegendre::<8>), start(), 0.01)?;
    run.advance_to(10.0)?;
    println!("{:?} {}", run.state(), run.energy());
    Ok(())
}
