//! Time, measured so that a busy or throttled machine slows all contenders alike.

use std::time::Instant;

/// The median seconds that each task takes, over `rounds` rounds in which every task runs once; one
/// more round goes before them and does not count.
pub fn interleaved(rounds: usize, tasks: &mut [Box<dyn FnMut() + '_>]) -> Vec<f64> {
    laps(rounds, tasks).into_iter().map(median).collect()
}

/// The seconds of each task in every round of the same.
pub fn laps(rounds: usize, tasks: &mut [Box<dyn FnMut() + '_>]) -> Vec<Vec<f64>> {
    let mut seconds = vec![vec![]; tasks.len()];
    for round in 0..=rounds {
        for (task, seconds) in tasks.iter_mut().zip(&mut seconds) {
            let start = Instant::now();
            task();
            let elapsed = start.elapsed().as_secs_f64();
            if round > 0 {
                seconds.push(elapsed);
            }
        }
    }
    seconds
}

/// The middle value, the upper one of two; NaN of none.
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
