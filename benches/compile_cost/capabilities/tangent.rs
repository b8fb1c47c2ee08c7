pub fn perform() -> Result<(), Box<dyn std::error::Error>> {
    let mut tangent = system().tangent(Verlet, start(), [start()], 0.01)?;
    tangent.advance(1000)?;
    println!("{:?} {:?}", tangent.state(), tangent.vectors());
    Ok(())
}
