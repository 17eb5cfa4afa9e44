//! Work shared among threads, each item with the time that it takes.

use crate::error::Result;
use std::sync::{Mutex, PoisonError};
use std::thread;

/// Does `work` for every item on so many threads; it is told which of them it is on.
///
/// # Errors
/// One of the errors. After a failure no other item is begun.
pub fn each<T: Sync>(
    jobs: usize,
    items: &[T],
    work: impl Fn(usize, &T) -> Result<()> + Sync,
) -> Result<()> {
    let queue = Mutex::new(items.iter());
    let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
    let turn = |job: usize| {
        while let Some(item) = next() {
            if let Err(error) = work(job, item) {
                while next().is_some() {}
                return Err(error);
            }
        }
        Ok(())
    };
    thread::scope(|scope| {
        let workers: Vec<_> = (0..jobs)
            .map(|job| scope.spawn(move || turn(job)))
            .collect();
        let join = |worker: thread::ScopedJoinHandle<'_, Result<()>>| {
            worker
                .join()
                .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        };
        workers
            .into_iter()
            .map(join)
            .collect::<Vec<_>>()
            .into_iter()
            .collect()
    })
}
