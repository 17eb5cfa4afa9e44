//! `cargo xtask check` on every fault, in every format and at every size.
//!
//! A part of it with every `cargo test`. `OMBRAGE_MATRIX=full` does all, and prints the tables of
//! docs/check.md:
//! `OMBRAGE_MATRIX=full cargo test --release -p xtask --test check_matrix -- --nocapture`

#[path = "../../tests/support/faults.rs"]
mod faults;
#[path = "../../tests/support/naive.rs"]
mod naive;
#[path = "../../tests/support/variants.rs"]
mod variants;

mod support {
    pub mod format;
}

use naive::Naive;
use ombrage::Figure;
use ombrage::conformance::diagnosis::{Code, Diagnosis, Verdict};
use support::format::Format;
use tempfile::TempDir;
use xtask::{check, parallel};

fn is_full() -> bool {
    std::env::var_os("OMBRAGE_MATRIX").is_some_and(|value| value == "full")
}

/// A picture and the codes that it should get.
#[derive(Clone)]
struct Job {
    codes: Vec<&'static str>,
    figure: &'static str,
    naive: Naive,
    words: String,
    format: Format,
}

impl Job {
    fn name(&self) -> String {
        let Self {
            codes,
            figure,
            naive,
            words,
            ..
        } = self;
        let (width, height) = (naive.width, naive.height);
        format!(
            "{codes:?} {figure} ({words}) {width}x{height} {}",
            self.format.name()
        )
    }
}

/// What a picture got.
struct Found {
    codes: Vec<&'static str>,
    verdict: Verdict,
    margin: f64,
}

impl Found {
    fn new(diagnosis: &Diagnosis, job: &Job) -> Self {
        // The two look alike, and the finding says so.
        let named = |code: &'static str, or: Option<&'static str>| {
            or.filter(|or| job.codes.contains(or)).unwrap_or(code)
        };
        let findings = diagnosis.findings.iter();
        Self {
            codes: findings
                .map(|finding| named(finding.code.name(), finding.or.map(Code::name)))
                .collect(),
            verdict: diagnosis.verdict,
            margin: diagnosis.margin.share(),
        }
    }

    fn words(&self) -> String {
        match self.verdict {
            Verdict::Faults => self.codes.join(", "),
            other => other.name().to_owned(),
        }
    }
}

/// Judges all pictures, on all cores.
fn judge(jobs: &[Job]) -> Vec<Found> {
    let directory = TempDir::new().expect("a directory");
    let numbered: Vec<(usize, &Job)> = jobs.iter().enumerate().collect();
    let one = |&(number, job): &(usize, &Job)| {
        let path = directory.path().join(number.to_string());
        job.format.write(&job.naive, &path);
        let figure = Figure::named(job.figure).expect("a figure");
        let (_, diagnosis) = check::judge(&path, figure)?;
        std::fs::remove_file(&path).expect("a file");
        let found = Found::new(&diagnosis, job);
        if is_full() {
            eprintln!("{}: {} {:.2}", job.name(), found.words(), found.margin);
        }
        Ok(found)
    };
    parallel::map(&numbered, one).expect("pictures")
}

/// One row of the table of faults: the smallest margin over the sizes in each format, or what was
/// said instead.
fn row(jobs: &[&(Job, Found)], formats: &[Format]) -> String {
    let cell = |format: &Format| {
        let cells = jobs.iter().filter(|(job, _)| job.format == *format);
        let mut least = f64::INFINITY;
        for (job, found) in cells {
            if found.codes != job.codes {
                let size = format!("{}x{}", job.naive.width, job.naive.height);
                return format!("**{} at {size}**", found.words());
            }
            least = least.min(found.margin);
        }
        format!("{least:.2}")
    };
    let cells: Vec<String> = formats.iter().map(cell).collect();
    let (job, _) = jobs[0];
    let code = job.codes[0];
    format!("| `{code}` | {} | {} |", job.figure, cells.join(" | "))
}

#[test]
fn every_fault_is_named_alone_in_every_format() {
    let sizes: &[(u32, u32)] = if is_full() {
        &[(600, 400), (320, 213), (1280, 800)]
    } else {
        &[(320, 213)]
    };
    let faults = faults::faults(1, 1).len();
    let mut jobs = vec![];
    for &(width, height) in sizes {
        for (number, (code, figure, naive)) in faults::faults(width, height).into_iter().enumerate()
        {
            // All faults in PNG are tests of the library.
            let formats = match is_full() {
                true => &Format::ALL[..],
                false => &Format::ALL[1 + number % 6..][..1],
            };
            jobs.extend(formats.iter().map(|&format| Job {
                codes: vec![code],
                figure,
                naive,
                words: number.to_string(),
                format,
            }));
        }
    }
    if !is_full() {
        jobs = jobs.into_iter().step_by(5).collect();
    }
    let found = judge(&jobs);
    let missed: Vec<String> = missed(&jobs, &found);
    let pictures = jobs.len();
    let judged: Vec<(Job, Found)> = jobs.into_iter().zip(found).collect();
    if is_full() {
        let names: Vec<String> = Format::ALL.iter().map(|format| format.name()).collect();
        println!(
            "| code | figure | {} |\n|---|---|{}",
            names.join(" | "),
            "---|".repeat(7)
        );
        for number in 0..faults {
            let its = |(job, _): &&(Job, Found)| job.words == number.to_string();
            let its: Vec<&(Job, Found)> = judged.iter().filter(its).collect();
            println!("{}", row(&its, &Format::ALL));
        }
        println!(
            "{} of {pictures} pictures: the fault alone",
            pictures - missed.len()
        );
    }
    assert!(
        missed.is_empty(),
        "{} of {pictures}: {missed:#?}",
        missed.len()
    );
}

/// The pictures that got other codes than they should have.
fn missed(jobs: &[Job], found: &[Found]) -> Vec<String> {
    let pairs = jobs.iter().zip(found);
    let wrong = pairs.filter(|(job, found)| {
        let conforms = found.verdict == Verdict::Conforms;
        found.codes != job.codes || conforms != job.codes.is_empty()
    });
    let words = wrong.map(|(job, found)| format!("{}: {}", job.name(), found.words()));
    words.collect()
}

#[test]
fn right_pictures_conform_in_every_convention_and_format() {
    let mut jobs = vec![];
    for figure in ["1", "2a", "2b", "3a", "3c"] {
        for (words, naive) in variants::conventions(figure, 240, 160) {
            // JPEG makes something else of the noise of one random ray a pixel.
            let formats = match words.starts_with("one random") {
                true => &Format::ALL[..1],
                false => &Format::ALL[..],
            };
            jobs.extend(formats.iter().map(|&format| Job {
                codes: vec![],
                figure,
                naive,
                words: words.clone(),
                format,
            }));
        }
    }
    if !is_full() {
        jobs = jobs.into_iter().step_by(61).collect();
    }
    let found = judge(&jobs);
    let missed = missed(&jobs, &found);
    println!(
        "{} of {} right pictures conform",
        jobs.len() - missed.len(),
        jobs.len()
    );
    assert!(
        missed.is_empty(),
        "{} of {}: {missed:#?}",
        missed.len(),
        jobs.len()
    );
}

/// The formats in which pairs are judged.
const FORMATS: [Format; 3] = [PNG, FINE, COARSE];
const PNG: Format = Format::Png;
const FINE: Format = Format::Jpeg(90, false);
const COARSE: Format = Format::Jpeg(75, true);

/// The pairs of which not both are named, and in which formats: docs/check.md says so.
const NOT_NAMED: [(&str, &str, &[Format]); 9] = [
    ("WRAPPED", "ACNE", &[COARSE]),
    ("ACNE", "WRONG_POWER", &[FINE, COARSE]),
    ("ACNE", "EXTRA_PI", &[FINE, COARSE]),
    ("ACNE", "MIRRORED", &[FINE, COARSE]),
    ("ACNE", "RED_BLUE_SWAPPED", &[FINE, COARSE]),
    ("ACNE", "WRONG_COLOUR", &[FINE, COARSE]),
    ("NO_FALLOFF", "GAMMA", &[PNG]),
    ("NO_FALLOFF", "WRONG_COLOUR", &[PNG, FINE, COARSE]),
    ("LINEAR_FALLOFF", "GAMMA", &[PNG]),
];

/// Both faults of a pair are named, but for those that are known; one of these that is named fails too.
#[test]
fn pairs_of_faults_are_named() {
    let mut jobs = vec![];
    for (a, b, figure, naive) in variants::pairs(320, 213) {
        jobs.extend(FORMATS.map(|format| Job {
            codes: vec![a, b],
            figure,
            naive,
            words: "a pair".to_owned(),
            format,
        }));
    }
    if !is_full() {
        // A few of all, and acne that looks most like less light.
        let is_hard = |job: &Job| job.codes == ["ACNE", "LINEAR_FALLOFF"] && job.format == FINE;
        let numbered = jobs.into_iter().enumerate();
        let some = numbered.filter(|(number, job)| number % 34 == 0 || is_hard(job));
        jobs = some.map(|(_, job)| job).collect();
    }
    let found = judge(&jobs);
    let mut named = 0;
    let mut unlike = vec![];
    for (job, found) in jobs.iter().zip(&found) {
        let is_named = job.codes.iter().all(|code| found.codes.contains(code));
        let is_known = NOT_NAMED
            .iter()
            .any(|(a, b, formats)| job.codes == [*a, *b] && formats.contains(&job.format));
        named += usize::from(is_named);
        if is_named == is_known {
            unlike.push(format!("{}: {}", job.name(), found.words()));
        }
    }
    println!("{named} of {} pairs: both named", jobs.len());
    assert!(unlike.is_empty(), "not as docs/check.md says: {unlike:#?}");
}
