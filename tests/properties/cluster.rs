//! The scripts that run a check on several machines give the same result as one machine.
//!
//! A missing tool is skipped. If BEAMGAP_ADAPTERS is set, it is an error. BEAMGAP_PYTHON names a Python with
//! `dask.distributed`.

use crate::program::{run, stdout};
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const SMALL: [&str; 4] = ["--cases", "8", "--family", "segment"];

/// A folder, the path of an example in it, and the search path with the command.
fn prepared(name: &str) -> (PathBuf, PathBuf, OsString) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cluster-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/cluster").join(name);
    let of_command = Path::new(env!("CARGO_BIN_EXE_beamgap")).parent().unwrap().to_path_buf();
    let others = std::env::var_os("PATH").unwrap_or_default();
    let path =
        std::env::join_paths(std::iter::once(of_command).chain(std::env::split_paths(&others))).unwrap();
    (folder, example, path)
}

/// The document of a run on one machine. The cargo that runs the test must not appear in its commands.
fn of_one_machine(more: &[&str]) -> String {
    stdout(&run(&[&["check", "--format", "json"][..], &SMALL, more].concat()))
}

#[test]
fn two_processes_of_dask_check_what_one_does() {
    let python = std::env::var_os("BEAMGAP_PYTHON").unwrap_or("python3".into());
    let is_there = Command::new(&python).args(["-c", "import dask.distributed"]).output();
    if !is_there.is_ok_and(|output| output.status.success()) {
        assert!(
            std::env::var_os("BEAMGAP_ADAPTERS").is_none(),
            "{} has no dask.distributed",
            python.display()
        );
        return;
    }
    let (folder, script, path) = prepared("dask_check.py");
    let mut command = Command::new(python);
    command.arg(script).args(["local", "3"]).args(SMALL).current_dir(&folder).env("PATH", path);
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(fs::read_to_string(folder.join("merged.json")).unwrap(), of_one_machine(&[]));
}

#[cfg(unix)]
#[test]
fn the_tasks_of_a_slurm_array_check_what_one_machine_does() {
    let (folder, script, path) = prepared("slurm.sh");
    for task in ["1", "2", "3"] {
        let mut command = Command::new("bash");
        command.arg(&script).current_dir(&folder).env("PATH", &path).env("CASES", "4");
        command.env("SLURM_ARRAY_TASK_ID", task).env("SLURM_ARRAY_TASK_COUNT", "3");
        let output = command.env("SLURM_CPUS_PER_TASK", "1").output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
    let parts: Vec<String> =
        (1..=3).map(|task| folder.join(format!("part-{task}.json")).display().to_string()).collect();
    let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
    let merged = stdout(&run(&[&["merge", "--format", "json"][..], &parts].concat()));
    assert_eq!(merged, stdout(&run(&["check", "--cases", "4", "--format", "json"])));
}
