//! The same program on one rank and on several: states, sums and errors are the same, and those of an ensemble without MPI.

mod mpirun;
#[allow(dead_code, reason = "the program of the ranks needs more of them")]
#[path = "systems.rs"]
mod systems;

use integrator_core::{
    chaos::{Indicator, map},
    prelude::*,
};
use mpirun::{JOIN, Program};
use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
};
use systems::{Bath, HenonHeiles, MEMBERS, STEPS, pendulum};

const RANKS: Program = Program("rank_program", None);

#[test]
fn states_and_sums_do_not_depend_on_the_number_of_ranks() {
    let Some(plain) = RANKS.on_any_number(&["plain"]) else { return };
    let member = |i: usize| (pendulum(i), Phase::new([i as f64 / 40.0], [0.1]));
    let mut swarm = Ensemble::new(Yoshida4, (0..MEMBERS).map(member), 0.01).unwrap();
    swarm.advance(STEPS).unwrap();
    let states: Vec<_> = swarm.states().collect();
    assert!(plain.starts_with(&format!("{states:?}\n")), "{plain}");
    // Means of a hundred numbers below ten, added one after the other.
    let mean = states.iter().map(|state| state.q[0]).sum::<f64>() / MEMBERS as f64;
    let printed = plain.split("mean: ").nth(1).and_then(|rest| rest.split(',').next()?.parse::<f64>().ok()).unwrap();
    assert!((printed - mean).abs() <= 100.0 * 10.0 * f64::EPSILON, "{printed} {mean}");
    for case in ["compensated", "few", "lists"] {
        RANKS.on_any_number(&[case]);
    }
}

#[test]
fn members_have_the_same_noise_on_any_number_of_ranks() {
    let Some(noise) = RANKS.on_any_number(&["noise"]) else { return };
    let members = (0..MEMBERS).map(|i| (Bath, Phase::new([i as f64 / 40.0], [0.1])));
    let mut swarm = Ensemble::new(Baoab, members, 0.01).unwrap().with_seed(7);
    swarm.advance(STEPS).unwrap();
    let states: Vec<_> = swarm.states().collect();
    assert!(noise.starts_with(&format!("{states:?}\n")), "{noise}");
}

/// A program takes the place of a device.
#[cfg(feature = "gpu")]
#[test]
fn members_have_the_same_bits_on_devices_and_ranks_may_have_them_there() {
    const ON_DEVICES: Program = Program("rank_program", Some("avx2"));
    let can_compare = integrator_core::InstructionSet::available().contains(&integrator_core::InstructionSet::Fused);
    let has_compiler =
        ["c++", "g++", "clang++"].iter().any(|name| Command::new(name).arg("--version").output().is_ok());
    if !can_compare || !has_compiler {
        return println!("SKIPPED: without fused multiply-add or a C++ compiler there is nothing to compare");
    }
    const EVERYWHERE: Program = Program("everywhere", Some("avx2"));
    let Some(here) = EVERYWHERE.printed(1, &[]) else { return };
    assert_eq!(here.trim().len(), 16, "{here}");
    for (ranks, place) in [(1, "device"), (1, "text"), (4, "ranks")] {
        assert_eq!(EVERYWHERE.printed(ranks, &[place]).as_ref(), Some(&here), "{place}");
    }
    let Some(plain) = ON_DEVICES.printed(1, &["plain"]) else { return };
    assert_eq!(ON_DEVICES.printed(3, &["on devices"]), Some(plain));
    let (saved, name) = (folder("devices"), folder("devices").display().to_string());
    let Some(whole) = ON_DEVICES.printed(3, &["save", &name]) else { return };
    let Some(resumed) = ON_DEVICES.printed(2, &["resume on devices", &name]) else { return };
    assert!(end(&resumed).is_some() && end(&resumed) == end(&whole), "{resumed}");
    let refused = ON_DEVICES.printed(2, &["no device"]).unwrap_or_default();
    assert!(
        ["no NVIDIA driver", "no device 1000"]
            .iter()
            .any(|says| refused.starts_with(&format!("on rank 1: there is {says}"))),
        "{refused}"
    );
    fs::remove_dir_all(saved).unwrap();
}

#[test]
fn maps_of_orbits_do_not_depend_on_the_number_of_ranks() {
    let Some(maps) = RANKS.on_any_number(&["map"]) else { return };
    let start = |i: usize| Phase::new([i as f64 / 20.0, 0.1], [0.3, 0.0]);
    let expected = map(&HenonHeiles, Verlet, (0..11).map(start), 0.05, 2_000, Indicator::Megno).unwrap();
    let lines: Vec<&str> = maps.lines().collect();
    assert_eq!(lines[0], format!("{expected:?}"));
    assert!(expected.iter().any(|megno| *megno != expected[0]), "orbits differ: {maps}");
    assert!(lines[2].starts_with("on rank 0: "), "{maps}");
    assert!(lines[3].starts_with("member 2 (on rank 0): the initial state is not finite"), "{maps}");
}

#[test]
fn every_rank_returns_the_same_errors() {
    let Some(refused) = RANKS.printed(3, &["refused"]) else { return };
    assert!(refused.starts_with("member 29 (on rank 0): the initial state is not finite"), "{refused}");
    let lost = RANKS.on_any_number(&["lost"]).unwrap_or_default();
    let lines: Vec<&str> = lost.lines().collect();
    assert!(lines[0].starts_with("98 under way: 3 members diverged: 29 in step "), "{lost}");
    assert!(lines[0].contains(", 59 in step ") && lines[0].contains(", 89 in step "), "{lost}");
    assert_eq!(lines[1], "then done, 310 steps");
    assert!(lines[2].starts_with("on rank 0: "), "{lost}");
    assert!(lines[3].starts_with("on rank 0: "), "{lost}");
    assert_eq!(lines[4], "done: 11 stay");
    let strayed = RANKS.on_any_number(&["strayed"]).unwrap_or_default();
    let lines: Vec<&str> = strayed.lines().collect();
    assert!(
        lines[0].starts_with("on rank 0: the bound on the energy deviation has to be positive, but it is 0"),
        "{strayed}"
    );
    assert_eq!(lines[1], "done");
    let says = "98 under way, 300 steps: 3 members exceeded the bound on their energy, or diverged (29, 59, 89); the others \
                continued; member 29: the energy after step ";
    assert!(lines[2].starts_with(says), "{strayed}");
    assert_eq!(
        RANKS.on_any_number(&["none"]).as_deref(),
        Some("an ensemble requires at least one member on any rank\n")
    );
}

#[test]
fn a_rank_that_is_killed_or_panics_ends_the_job_and_the_checkpoint_resumes() {
    let (killed, whole) = (folder("killed"), folder("whole"));
    let [killed_name, whole_name] = [&killed, &whole].map(|folder| folder.display().to_string());
    // A panic ends the job with the code of `MPI_ABORT`, not with its own, 101; that it was called, MPI does not always say.
    for (case, says, code) in [("killed", "rank 2", None), ("panics", "the last one", Some(1))] {
        let Some(output) = RANKS.start(3, &[case, &killed_name]) else { return };
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && errors.contains(says), "{case}: {errors}");
        assert!(code.is_none() || output.status.code() == code, "{case}: {}, {errors}", output.status);
    }
    let Some(uninterrupted) = RANKS.printed(1, &["save", &whole_name]) else { return };
    let Some(resumed) = RANKS.printed(2, &["resume", &killed_name]) else { return };
    assert!(end(&resumed).is_some() && end(&resumed) == end(&uninterrupted), "{resumed}");
    for folder in [killed, whole] {
        fs::remove_dir_all(folder).unwrap();
    }
}

/// What a case prints at its end.
fn end(text: &str) -> Option<&str> {
    text.split("end ").nth(1)
}

#[test]
fn a_checkpoint_is_resumed_by_any_number_of_ranks() {
    let saved = folder("saved");
    let name = saved.display().to_string();
    let Some(whole) = RANKS.printed(3, &["save", &name]) else { return };
    // The first one is gone, and nothing but the second is there.
    let mut names: Vec<_> =
        fs::read_dir(&saved).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    let files = ["1-rank-00000.members", "1-rank-00001.members", "1-rank-00002.members", "members.json"];
    assert_eq!(names, files);
    assert!(end(&whole).is_some());
    for ranks in 1..=4 {
        let Some(resumed) = RANKS.printed(ranks, &["resume", &name]) else { return };
        assert_eq!(end(&resumed), end(&whole), "on {ranks} ranks");
        assert!(resumed.starts_with("done, 301 steps"), "{resumed}");
    }
    let damaged = saved.join("1-rank-00001.members");
    let mut bytes = fs::read(&damaged).unwrap();
    bytes[100] ^= 1;
    fs::write(&damaged, bytes).unwrap();
    let refused = RANKS.printed(4, &["resume", &name]).unwrap_or_default();
    assert!(refused.contains("1-rank-00001.members: this checkpoint is damaged"), "{refused}");
    fs::remove_dir_all(&saved).unwrap();
    let refused = RANKS.printed(2, &["resume", &name]).unwrap_or_default();
    assert!(refused.starts_with("on rank 0: ") && refused.contains("members.json"), "{refused}");
}

/// A folder of its own for a test, empty.
fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("integrator-mpi-{name}-{}", std::process::id()));
    let _ = fs::remove_dir_all(&folder);
    folder
}

#[test]
fn files_of_ranks_are_joined_to_those_of_one() {
    let (of_one, of_three) = (folder("one"), folder("three"));
    for (ranks, folder) in [(1, &of_one), (3, &of_three)] {
        let Some(printed) = RANKS.printed(ranks, &["csv", &folder.display().to_string()]) else { return };
        assert_eq!(printed, "done\n");
    }
    let join = |folder: &Path| {
        let to = folder.join("all.csv");
        let output = Command::new(JOIN).args([folder, &to]).output().unwrap();
        (output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned(), fs::read_to_string(to))
    };
    let (joined, errors, one) = join(&of_one);
    assert!(joined, "{errors}");
    let (_, _, three) = join(&of_three);
    assert_eq!(one.unwrap(), three.unwrap());
    // A file that was cut off is told by its name.
    let part = of_three.join("0-rank-00001.csv");
    let text = fs::read_to_string(&part).unwrap();
    fs::write(&part, text.lines().take(10).map(|line| format!("{line}\n")).collect::<String>()).unwrap();
    let (joined, errors, _) = join(&of_three);
    assert!(!joined && errors.contains("0-rank-00001.csv: 9 members, but the manifest says 34"), "{errors}");
    fs::remove_file(of_three.join("csv.json")).unwrap();
    let (joined, errors, _) = join(&of_three);
    assert!(!joined && errors.contains("csv.json"), "{errors}");
    for folder in [of_one, of_three] {
        fs::remove_dir_all(folder).unwrap();
    }
}
