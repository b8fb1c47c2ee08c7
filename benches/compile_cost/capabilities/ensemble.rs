pub fn perform() -> Result<(), Box<dyn std::error::Error>> {
    let mut ensemble = Ensemble::new(Verlet, [(system(), start()), (system(), start())], 0.01)?;
    ensemble.advance(1000)?;
    println!("{:?}", ensemble.state(1));
    Ok(())
}
