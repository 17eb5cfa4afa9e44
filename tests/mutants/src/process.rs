//! One test in a process of its own, bounded in time and memory.

use crate::error::{Error, Result};
use crate::programs::Test;
use rustix::process::{Pid, Signal, kill_process_group};
use std::ffi::OsStr;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// Bounds a program in memory (KiB of addresses) and processor time (seconds). The second one ends what
/// is left over where this tool is killed.
const BOUNDED: &str = r#"ulimit -v "$1"; ulimit -t "$2"; shift 2; exec "$@""#;

/// The memory a test may take: three times what the largest takes, and less than a machine has.
const MEMORY: u32 = 6 << 20;

/// How long to wait between two looks at a process.
const PAUSE: Duration = Duration::from_millis(4);

/// How a test ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// It passes.
    Passed,
    /// It fails, or its process is ended by a signal.
    Failed,
    /// It takes longer than it may, and is killed.
    TimedOut,
}

/// Runs a test of the copy at `tree` with a variable set, for no longer than `limit` seconds. Returns
/// how it ends, and after how many seconds.
///
/// # Errors
/// If it cannot be started.
pub fn run(
    test: &Test,
    tree: &Path,
    variable: Option<(&str, &OsStr)>,
    limit: f64,
) -> Result<(End, f64)> {
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let processor = (limit.ceil() as usize + 1) * (threads + 1);
    let mut command = Command::new("sh");
    command.args(["-c", BOUNDED, "sh"]);
    command.args([MEMORY.to_string(), processor.to_string()]);
    command.arg(&test.executable);
    command.args(["--exact", &test.name, "--test-threads=1", "--quiet"]);
    command.current_dir(&test.folder).process_group(0);
    command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    command.envs([
        ("CI", "true"),
        ("INSTA_UPDATE", "no"),
        ("PROPTEST_DISABLE_FAILURE_PERSISTENCE", "true"),
        ("RUST_BACKTRACE", "0"),
    ]);
    // What cargo tells the tests that it runs, and what insta would ask cargo for.
    command.env("CARGO_MANIFEST_DIR", &test.folder);
    command.env("INSTA_WORKSPACE_ROOT", tree);
    command.envs(variable);
    let failed = |error| Error::new(format!("cannot run {}: {error}; build anew", test.id()));
    let start = Instant::now();
    let mut child = command.spawn().map_err(failed)?;
    let end = loop {
        let seconds = start.elapsed().as_secs_f64();
        match child.try_wait().map_err(failed)? {
            Some(status) if status.success() => break End::Passed,
            Some(_) => break End::Failed,
            None if seconds > limit => break End::TimedOut,
            None => thread::sleep(PAUSE),
        }
    };
    let seconds = start.elapsed().as_secs_f64();
    // Its children too; where there are none, nobody is there to be killed.
    if let Some(group) = i32::try_from(child.id()).ok().and_then(Pid::from_raw) {
        kill_process_group(group, Signal::KILL).ok();
    }
    child.wait().map_err(failed)?;
    Ok((end, seconds))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::env;

    const ASKED: &str = "MUTANTS_ASKED";

    /// Does what a variable says: the test that the next one runs.
    #[test]
    fn asked() {
        match env::var(ASKED).unwrap_or_default().as_str() {
            "fail" => panic!("as asked"),
            "wait" => thread::sleep(Duration::from_secs(60)),
            _ => {}
        }
    }

    #[test]
    fn ends_are_told_apart() {
        let test = Test {
            program: "mutants".into(),
            name: "process::tests::asked".into(),
            executable: env::current_exe().expect("this program"),
            folder: ".".into(),
        };
        let ended = |what: &str, limit| {
            let variable = Some((ASKED, OsStr::new(what)));
            run(&test, Path::new("."), variable, limit).expect("it starts")
        };
        assert_eq!(ended("pass", 30.0).0, End::Passed);
        assert_eq!(ended("fail", 30.0).0, End::Failed);
        let (end, seconds) = ended("wait", 0.5);
        assert_eq!(end, End::TimedOut);
        assert!((0.5..30.0).contains(&seconds), "{seconds}");
    }
}
