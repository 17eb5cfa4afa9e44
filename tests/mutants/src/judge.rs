//! Trying each mutant with the tests that reach it, until one notices it.

use crate::error::Result;
use crate::mutant_switch::ON;
use crate::outcomes::{Outcomes, Verdict};
use crate::pool;
use crate::process::{End, run};
use crate::project::digest;
use crate::reach::Judge;
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError};

/// How many times as long as without a mutant a test may take, and how many seconds more: a mutant that
/// loops is noticed by that, one that is slow, or a machine that is busy, is not.
const PATIENCE: (f64, f64) = (8.0, 5.0);

/// How far a run goes.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// The slowest test that is tried, in seconds.
    pub seconds: f64,
    /// The seconds for one mutant.
    pub budget: f64,
    /// How many processes run at a time.
    pub jobs: usize,
}

/// Tries these mutants in the copy at `tree`, and writes what becomes of them.
///
/// # Errors
/// If a test cannot be started, or an outcome not be written.
pub fn try_all(
    tree: &Path,
    mutants: &[usize],
    judges: &[Judge],
    outcomes: &Outcomes,
    effort: Effort,
) -> Result<()> {
    let mut order = mutants.to_vec();
    // Neighbours are noticed by the same tests; in a mixed order it is soon known which notice most.
    order.sort_by_key(|mutant| digest(mutant));
    let records = outcomes.records()?;
    let kills = Kills::default();
    outcomes.noticing().for_each(|test| kills.count(test));
    let (tried, noticed) = (AtomicUsize::new(0), AtomicUsize::new(0));
    pool::each(effort.jobs, &order, |_, &mutant| {
        let verdict = judged(tree, mutant, judges, outcomes.tried(mutant), &kills, effort)?;
        let is_noticed = usize::from(matches!(verdict, Verdict::Noticed { .. }));
        outcomes.add(&records, mutant, verdict)?;
        let noticed = noticed.fetch_add(is_noticed, Relaxed) + is_noticed;
        let tried = tried.fetch_add(1, Relaxed) + 1;
        if tried.is_multiple_of(25) || tried == order.len() {
            eprintln!(
                "{tried} of {} mutants tried, {noticed} noticed",
                order.len()
            );
        }
        Ok(())
    })
}

/// Tries one mutant.
fn judged(
    tree: &Path,
    mutant: usize,
    judges: &[Judge],
    before: &[String],
    kills: &Kills,
    effort: Effort,
) -> Result<Verdict> {
    let reaching = judges
        .iter()
        .filter(|judge| judge.reached.contains(&mutant));
    let reaching: Vec<&Judge> = reaching.collect();
    let mut tried = before.to_vec();
    let number = mutant.to_string();
    let mut spent = 0.0;
    for (judge, seconds) in kills.sorted(&reaching, effort.seconds) {
        let id = judge.test.id();
        if spent + seconds > effort.budget || tried.contains(&id) {
            continue;
        }
        let limit = PATIENCE.0 * seconds + PATIENCE.1;
        let (end, took) = run(&judge.test, tree, Some((ON, OsStr::new(&number))), limit)?;
        if end != End::Passed {
            kills.count(&id);
            return Ok(Verdict::Noticed { by: id });
        }
        spent += took;
        tried.push(id);
    }
    let untried = reaching
        .iter()
        .filter(|judge| !tried.contains(&judge.test.id()));
    let untried = untried.count();
    Ok(Verdict::NotNoticed { tried, untried })
}

/// How many mutants each test has noticed.
#[derive(Default)]
struct Kills(Mutex<BTreeMap<String, u32>>);

impl Kills {
    fn count(&self, test: &str) {
        let mut kills = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        *kills.entry(test.to_owned()).or_default() += 1;
    }

    /// The tests that are no slower than this, with their times: those first that are quick and have
    /// noticed much.
    fn sorted<'a>(&self, judges: &[&'a Judge], slowest: f64) -> Vec<(&'a Judge, f64)> {
        let kills = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mut timed: Vec<(f64, &Judge, f64)> = vec![];
        for judge in judges {
            if let Some(seconds) = judge.seconds.filter(|seconds| *seconds <= slowest) {
                let noticed = kills.get(&judge.test.id()).copied().unwrap_or_default();
                // To start a process takes time too.
                let cost = (seconds + 0.02) / (1.0 + f64::from(noticed));
                timed.push((cost, judge, seconds));
            }
        }
        timed.sort_by(|a, b| a.0.total_cmp(&b.0));
        timed
            .into_iter()
            .map(|(_, judge, seconds)| (judge, seconds))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::programs::Test;
    use std::collections::BTreeSet;

    fn judge(name: &str, seconds: Option<f64>) -> Judge {
        Judge {
            test: Test {
                program: "all".into(),
                name: name.into(),
                executable: "all".into(),
                folder: ".".into(),
            },
            seconds,
            reached: BTreeSet::new(),
        }
    }

    #[test]
    fn quick_tests_first_and_those_that_notice_much() {
        let judges = [
            judge("middle", Some(0.5)),
            judge("quick", Some(0.01)),
            judge("slow", Some(4.0)),
            judge("endless", None),
            judge("sharp", Some(0.6)),
        ];
        let kills = Kills::default();
        kills.count("all sharp");
        let judges: Vec<&Judge> = judges.iter().collect();
        let names = |slowest| -> Vec<&str> {
            let sorted = kills.sorted(&judges, slowest).into_iter();
            sorted.map(|(judge, _)| judge.test.name.as_str()).collect()
        };
        assert_eq!(names(5.0), ["quick", "sharp", "middle", "slow"]);
        assert_eq!(names(1.0), ["quick", "sharp", "middle"]);
    }
}
