//! The number of threads is the requested one.

/// The results do not depend on the number of threads, so this test counts the threads.
#[cfg(target_os = "linux")]
#[test]
fn as_many_threads_work_as_are_asked_for() {
    use crate::program::command;
    use std::process::Stdio;
    use std::time::{Duration, Instant};

    let asked = 7;
    let arguments = ["check", "--cases", "1000000", "--threads", &asked.to_string()];
    let mut child = command(&arguments).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    let tasks = format!("/proc/{}/task", child.id());
    let (start, mut most) = (Instant::now(), 0);
    while most <= asked && start.elapsed() < Duration::from_secs(10) {
        std::thread::sleep(Duration::from_millis(10));
        most = most.max(std::fs::read_dir(&tasks).unwrap().count());
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(most, asked + 1, "the workers, and the thread that waits for them");
}
