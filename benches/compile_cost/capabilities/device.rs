// Arguments of the annotation: gpu
pub fn perform() -> Result<(), Box<dyn std::error::Error>> {
    println!("{}", <System as integrator_core::__private::DeviceText>::TEXT);
    let mut run = system().run_with(Verlet, start(), 0.01)?;
    run.advance(1000)?;
    println!("{:?} {}", run.state(), run.energy());
    Ok(())
}
