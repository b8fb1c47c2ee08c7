pub fn perform() -> Result<(), Box<dyn std::error::Error>> {
    macro_rules! run {
        ($($method:expr),*) => {$(
            let mut run = system().run_with($method, start(), 0.01)?;
            run.advance(1000)?;
            println!("{:?} {}", run.state(), run.energy());
        )*};
    }
    run!(Verlet, Yoshida4, BlanesMoan6, KahanLi8, Euler);
    Ok(())
}
