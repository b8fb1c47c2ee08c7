// Arguments of the annotation: sensitive(PARAMETER)
pub fn perform() -> Result<(), Box<dyn std::error::Error>> {
    let mut tangent = system().sensitivities(Verlet, start(), [], 0.01)?;
    tangent.advance(1000)?;
    println!("{:?} {:?}", tangent.state(), tangent.vectors());
    Ok(())
}
