// Arguments of the annotation: sensitive(PARAMETER)
pub fn perform() -> Result<(), Box<dyn std::error::Error>> {
    let gradient = system().gradient(Verlet, start(), 0.01, 1000, |end| (0.0, end.clone()))?;
    println!("{gradient:?}");
    Ok(())
}
