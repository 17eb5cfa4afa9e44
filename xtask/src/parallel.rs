//! Work shared among threads.

use crate::error::Result;
use std::num::NonZero;
use std::sync::{Mutex, PoisonError};
use std::thread;

/// Does `work` for every item, on as many threads as there are cores; the answers in the items'
/// order.
///
/// # Errors
/// The first error, in the items' order. After a failure no other item is begun.
pub fn map<T: Sync, A: Send>(items: &[T], work: impl Fn(&T) -> Result<A> + Sync) -> Result<Vec<A>> {
    let cores = thread::available_parallelism().map_or(1, NonZero::get);
    let queue = Mutex::new(items.iter().enumerate());
    let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
    let turn = || {
        let mut done = vec![];
        while let Some((place, item)) = next() {
            let answer = work(item);
            if answer.is_err() {
                while next().is_some() {}
            }
            done.push((place, answer));
        }
        done
    };
    let mut done = thread::scope(|scope| {
        let workers: Vec<_> = (1..cores.min(items.len()))
            .map(|_| scope.spawn(turn))
            .collect();
        let mut done = turn();
        for worker in workers {
            let theirs = worker.join();
            done.extend(theirs.unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        }
        done
    });
    done.sort_by_key(|(place, _)| *place);
    done.into_iter().map(|(_, answer)| answer).collect()
}
