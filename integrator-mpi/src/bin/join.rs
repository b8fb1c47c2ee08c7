//! Joins the files that the ranks of an ensemble have written: `join FOLDER FILE`.

use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [folder, to] = &arguments[..] else {
        eprintln!(
            "usage: join FOLDER FILE\n\nJoins the CSV files of the ranks in FOLDER, which its manifest names, into FILE."
        );
        return ExitCode::from(2);
    };
    match integrator_mpi::join(folder, to) {
        Ok(joined) => {
            println!("{to}: {} members of {} ranks", joined.members, joined.files);
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
