//! Progress over experiments that each know their own steps.

use crate::progress;
use indicatif::ProgressBar;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

/// A bar over all experiments, which says what is running and how much time is left.
///
/// It is divided by how long each experiment is expected to take, so that the rate is steady and
/// the time left that follows from it right.
pub struct Stages {
    bar: ProgressBar,
}

impl Stages {
    /// A bar for experiments that together take about so many milliseconds.
    pub fn new(expected: u64) -> Self {
        let bar = progress::bar(expected, true);
        progress::show_time_left(&bar);
        Self { bar }
    }

    /// Runs an experiment of about so many milliseconds, which counts its steps on a bar of its own.
    pub fn run<T>(
        &self,
        name: &'static str,
        expected: u64,
        work: impl FnOnce(&ProgressBar) -> T,
    ) -> T {
        let (start, own) = (self.bar.position(), ProgressBar::hidden());
        own.set_length(0);
        let done = AtomicBool::new(false);
        let answer = thread::scope(|scope| {
            scope.spawn(|| {
                while !done.load(Ordering::Relaxed) {
                    let share = own.position() as f64 / own.length().unwrap_or(0).max(1) as f64;
                    self.bar
                        .set_position(start + (share.min(1.0) * expected as f64) as u64);
                    self.bar.set_message(format!("{name} {}", own.message()));
                    thread::sleep(Duration::from_millis(100));
                }
            });
            let answer = work(&own);
            done.store(true, Ordering::Relaxed);
            answer
        });
        self.bar.set_position(start + expected);
        answer
    }

    /// Takes the bar away.
    pub fn finish(self) {
        self.bar.finish_and_clear();
    }
}
