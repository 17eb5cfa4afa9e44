//! Which tests reach which mutants, how long they take, and whether they pass without any.

use crate::error::{Error, Result};
use crate::mutant_switch::REACHED;
use crate::process::{End, run};
use crate::programs::Test;
use crate::records::{self, Records};
use crate::{pool, project::Project};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// A test that passes without a mutant.
#[derive(Debug)]
pub struct Judge {
    /// The test.
    pub test: Test,
    /// How many seconds it takes; none if more than asked for.
    pub seconds: Option<f64>,
    /// The mutants that it reaches.
    pub reached: BTreeSet<usize>,
}

/// What is written of a test.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Row {
    /// The copy that it was recorded in: another one has other numbers.
    tree: String,
    test: String,
    /// The most that it was allowed to take.
    limit: f64,
    seconds: Option<f64>,
    passes: bool,
    reached: BTreeSet<usize>,
}

/// Runs all tests that have not been run in this copy, `digest`, and returns those that can judge: they
/// reach a mutant, and pass without any. Names those that do not pass.
///
/// # Errors
/// If a test cannot be started.
pub fn record(
    project: &Project,
    tree: &Path,
    digest: &str,
    tests: Vec<Test>,
    (seconds, jobs): (f64, usize),
) -> Result<Vec<Judge>> {
    let path = project.room().join("reach.jsonl");
    let known = |row: &Row| row.tree == digest && (row.seconds.is_some() || row.limit >= seconds);
    let mut rows = records::read::<Row>(&path);
    rows.retain(known);
    // Those of other copies would only make the file large.
    fs::write(&path, []).map_err(|error| Error::at(&path, &error))?;
    let records = Records::open(&path)?;
    rows.iter().try_for_each(|row| records.add(row))?;
    let done: BTreeSet<String> = rows.into_iter().map(|row| row.test).collect();
    let is_new = |test: &&Test| !done.contains(&test.id());
    let new: Vec<&Test> = tests.iter().filter(is_new).collect();
    let ended = AtomicUsize::new(0);
    pool::each(jobs, &new, |job, test| {
        let reached = project.room().join(format!("reached.{job}"));
        records.add(&row(test, tree, digest, &reached, seconds)?)?;
        let ended = ended.fetch_add(1, Relaxed) + 1;
        if ended.is_multiple_of(25) || ended == new.len() {
            eprintln!("what tests reach: {ended} of {}", new.len());
        }
        Ok(())
    })?;
    let rows = records::read::<Row>(&path).into_iter();
    let rows = rows.filter(known).map(|row| (row.test.clone(), row));
    Ok(judges(tests, &rows.collect()))
}

/// Runs a test and records what it reaches.
fn row(test: &Test, tree: &Path, digest: &str, file: &Path, limit: f64) -> Result<Row> {
    let failed = |error| Error::at(file, &error);
    fs::write(file, []).map_err(failed)?;
    let (end, seconds) = run(test, tree, Some((REACHED, file.as_os_str())), limit)?;
    let bytes = fs::read(file).map_err(failed)?;
    let numbers = bytes.as_chunks::<4>().0.iter();
    let numbers = numbers.map(|bytes| u32::from_le_bytes(*bytes) as usize);
    Ok(Row {
        tree: digest.to_owned(),
        test: test.id(),
        limit,
        seconds: (end != End::TimedOut).then_some(seconds),
        // One that takes too long may pass or not: it is not used.
        passes: end != End::Failed,
        reached: numbers.collect(),
    })
}

/// The tests that judge, by their rows.
fn judges(tests: Vec<Test>, rows: &BTreeMap<String, Row>) -> Vec<Judge> {
    let mut judges = vec![];
    for test in tests {
        let Some(row) = rows.get(&test.id()) else {
            continue;
        };
        if !row.passes {
            eprintln!("not used, it fails without a mutant: {}", row.test);
        } else if !row.reached.is_empty() {
            judges.push(Judge {
                test,
                seconds: row.seconds,
                reached: row.reached.clone(),
            });
        }
    }
    judges
}
