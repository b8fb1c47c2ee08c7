pub fn perform() -> Result<(), Box<dyn std::error::Error>> {
    println!("{}", certify(&system(), Verlet, start(), 0.01)?);
    Ok(())
}
