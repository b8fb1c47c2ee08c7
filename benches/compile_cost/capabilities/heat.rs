pub fn perform() -> Result<(), Box<dyn std::error::Error>> {
    let mut run = system().run_with(Verlet, start(), 0.01)?;
    println!("{:?} {}", run.advance_with_balance(1000)?, run.kinetic_temperature());
    let mut chain = system().metropolised(Verlet, start(), 0.5)?;
    chain.advance(1000)?;
    println!("{:?} {}", chain.run().state(), chain.accepted());
    Ok(())
}
