//! A program that answers requests, as a child that cannot do harm: whatever it prints, reads or
//! leaves unread, this side neither waits for ever nor keeps more than a few megabytes.

use crate::error::{Error, Result};
use crate::lines::{printable, read_line};
use std::ffi::OsString;
use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::process::{self, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::sync::{Arc, Mutex, MutexGuard, Once, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// The longest line that is read as an answer, in bytes: 64 KiB.
pub const LONGEST: usize = 1 << 16;

/// A line that never ends is given up after so many bytes.
const ENDLESS: usize = 1 << 24;

/// Lines that may wait for this side, so that a flood waits in its pipe.
const WAITING: usize = 64;

/// The last bytes of standard error that are kept.
const TAIL: usize = 1 << 12;

/// What a program printed, and when.
#[derive(Debug)]
pub enum Printed {
    /// A line, without its end.
    Line(Vec<u8>, Instant),
    /// A line of more than [`LONGEST`] bytes.
    LongLine,
    /// A line that does not end.
    Endless,
    /// Standard output is closed.
    End,
    /// Nothing in the time given.
    Nothing,
}

impl Printed {
    /// The next line of an output.
    pub fn next(output: &mut impl BufRead) -> Self {
        let mut line = vec![];
        match read_line(output, &mut line, LONGEST, ENDLESS) {
            Ok(Some(length)) if length > ENDLESS => Self::Endless,
            Ok(Some(length)) if length > LONGEST => Self::LongLine,
            Ok(Some(_)) => Self::Line(line, Instant::now()),
            Ok(None) | Err(_) => Self::End,
        }
    }
}

/// Something that prints answers.
pub trait Program {
    /// What it prints next, until a deadline.
    fn next(&mut self, deadline: Instant) -> Printed;

    /// How it ended, if it does before the deadline; then the last line it wrote to standard error.
    fn end(&mut self, deadline: Instant) -> (Option<ExitStatus>, String);
}

/// Output that is at hand.
impl Program for &[u8] {
    fn next(&mut self, _: Instant) -> Printed {
        Printed::next(self)
    }

    fn end(&mut self, _: Instant) -> (Option<ExitStatus>, String) {
        (None, String::new())
    }
}

/// A running child. Dropped, it is killed with all its own children.
pub struct Child {
    process: process::Child,
    printed: Receiver<Printed>,
    errors: Arc<Mutex<Vec<u8>>>,
}

impl Child {
    /// Starts a program and feeds it `input`, then closes its standard input.
    ///
    /// # Errors
    /// If there is no such program, or it may not run.
    pub fn start(program: &[OsString], input: Vec<u8>) -> Result<Self> {
        let (name, arguments) = program
            .split_first()
            .ok_or_else(|| Error::new("no program is given: write it after --"))?;
        kill_on_interrupt();
        let mut command = Command::new(name);
        command
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut running = running();
        let mut process = command.spawn().map_err(|error| cannot_run(name, &error))?;
        *running = Some(process.id());
        drop(running);
        let (sender, printed) = sync_channel(WAITING);
        let errors = Arc::new(Mutex::new(vec![]));
        if let Some(mut stdin) = process.stdin.take() {
            // A child that stops reading breaks the pipe, which ends the thread.
            thread::spawn(move || drop(stdin.write_all(&input)));
        }
        if let Some(stdout) = process.stdout.take() {
            thread::spawn(move || read_lines(stdout, &sender));
        }
        if let Some(stderr) = process.stderr.take() {
            let errors = Arc::clone(&errors);
            thread::spawn(move || keep_tail(stderr, &errors));
        }
        Ok(Self {
            process,
            printed,
            errors,
        })
    }
}

impl Program for Child {
    fn next(&mut self, deadline: Instant) -> Printed {
        let left = deadline.saturating_duration_since(Instant::now());
        match self.printed.recv_timeout(left) {
            Ok(printed) => printed,
            Err(RecvTimeoutError::Timeout) => Printed::Nothing,
            Err(RecvTimeoutError::Disconnected) => Printed::End,
        }
    }

    fn end(&mut self, deadline: Instant) -> (Option<ExitStatus>, String) {
        let status = loop {
            match self.process.try_wait() {
                Ok(None) if Instant::now() < deadline => thread::sleep(Duration::from_millis(1)),
                Ok(status) => break status,
                Err(_) => break None,
            }
        };
        let errors = self.errors.lock().unwrap_or_else(PoisonError::into_inner);
        let text = String::from_utf8_lossy(&errors);
        let line = text.lines().rev().find(|line| !line.trim().is_empty());
        (status, printable(line.unwrap_or_default().trim(), 120))
    }
}

impl Drop for Child {
    fn drop(&mut self) {
        let mut running = running();
        kill_group(self.process.id());
        // A process that has ended already cannot be killed, and needs it not.
        let _ = self.process.kill();
        let _ = self.process.wait();
        *running = None;
    }
}

fn cannot_run(name: &OsString, error: &std::io::Error) -> Error {
    let name = name.display();
    let advice = match error.kind() {
        ErrorKind::NotFound => "give the path of a program, such as ./kernels",
        ErrorKind::PermissionDenied => "make it executable, or give its interpreter first",
        _ => "give a program that runs on this machine, or its interpreter first",
    };
    Error::new(format!("cannot run {name}: {error}; {advice}"))
}

fn read_lines(stdout: impl Read, sender: &SyncSender<Printed>) {
    let mut stdout = BufReader::new(stdout);
    loop {
        let printed = Printed::next(&mut stdout);
        let is_last = matches!(printed, Printed::Endless | Printed::End);
        if sender.send(printed).is_err() || is_last {
            return;
        }
    }
}

fn keep_tail(mut stderr: impl Read, tail: &Mutex<Vec<u8>>) {
    let mut buffer = [0; TAIL];
    while let Ok(read @ 1..) = stderr.read(&mut buffer) {
        let mut tail = tail.lock().unwrap_or_else(PoisonError::into_inner);
        tail.extend_from_slice(&buffer[..read]);
        let surplus = tail.len().saturating_sub(TAIL);
        tail.drain(..surplus);
    }
}

/// The process that runs, for Ctrl-C to kill.
static RUNNING: Mutex<Option<u32>> = Mutex::new(None);

fn running() -> MutexGuard<'static, Option<u32>> {
    RUNNING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The child has a process group of its own, which Ctrl-C does not reach.
fn kill_on_interrupt() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let handler = || {
            // Held to the end of the process, so that no other child is started.
            if let Some(id) = *running() {
                kill_group(id);
            }
            process::exit(130);
        };
        // Without the handler the child still ends at the end of its input.
        let _ = ctrlc::set_handler(handler);
    });
}

/// Kills a child with its own children, where the system knows groups.
#[cfg(unix)]
fn kill_group(id: u32) {
    use rustix::process::{Pid, Signal, kill_process_group};
    let group = i32::try_from(id).ok().and_then(Pid::from_raw);
    if let Some(group) = group {
        // A group that has ended cannot be killed, and needs it not.
        let _ = kill_process_group(group, Signal::KILL);
    }
}

#[cfg(not(unix))]
fn kill_group(_id: u32) {}
