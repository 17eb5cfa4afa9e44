//! Pictures with faults, drawn by another renderer, and what the diagnosis says of them.

#[path = "support/faults.rs"]
mod faults;
#[path = "support/naive.rs"]
mod naive;
#[path = "support/variants.rs"]
mod variants;

mod diagnosis {
    mod clauses;
    mod conventions;
    mod estimates;
}

use naive::Naive;
use ombrage::conformance::diagnosis::{Diagnosis, Verdict, diagnose};
use ombrage::{Figure, Picture, Size};

/// The size of a picture that shows all faults.
const WIDE: (u32, u32) = (160, 107);

fn picture(naive: &Naive) -> Picture {
    let size = Size::new(naive.width, naive.height).expect("a size");
    Picture::new(size, &naive.draw()).expect("three bytes a pixel")
}

fn judge(naive: &Naive, figure: &str) -> Diagnosis {
    let figure = Figure::named(figure).expect("a figure");
    diagnose(&picture(naive), figure, &[]).expect("a size that is judged")
}

fn codes(diagnosis: &Diagnosis) -> Vec<&'static str> {
    diagnosis
        .findings
        .iter()
        .map(|finding| finding.code.name())
        .collect()
}

/// Whether a code is what was found: CLAMPED and SATURATED look alike.
fn is_named(code: &str, diagnosis: &Diagnosis) -> bool {
    let [finding] = &diagnosis.findings[..] else {
        return false;
    };
    finding.code.name() == code || finding.or.is_some_and(|or| or.name() == code)
}

#[test]
fn every_fault_is_named_alone() {
    for (code, figure, naive) in faults::faults(WIDE.0, WIDE.1) {
        let diagnosis = judge(&naive, figure);
        assert!(
            is_named(code, &diagnosis),
            "{code} {figure}: {:?}",
            codes(&diagnosis)
        );
    }
}

#[test]
fn right_pictures_conform() {
    for figure in ["1", "2a", "2b", "3a", "3c"] {
        for (words, naive) in variants::conventions(figure, WIDE.0, WIDE.1)
            .into_iter()
            .filter(|(words, _)| !words.starts_with("one random"))
            .step_by(5)
        {
            let diagnosis = judge(&naive, figure);
            let verdict = diagnosis.verdict;
            assert_eq!(
                verdict,
                Verdict::Conforms,
                "{figure} {words}: {diagnosis:?}"
            );
        }
    }
}

/// Both faults of at least nine pairs in ten are named; every fourth pair is tried.
#[test]
fn pairs_of_faults_are_named() {
    let pairs: Vec<_> = variants::pairs(WIDE.0, WIDE.1)
        .into_iter()
        .step_by(4)
        .collect();
    let mut missed = vec![];
    for (a, b, figure, naive) in &pairs {
        let diagnosis = judge(naive, figure);
        let found = codes(&diagnosis);
        if !found.contains(a) || !found.contains(b) {
            missed.push(format!("{a} + {b}: {found:?}"));
        }
    }
    assert!(
        10 * missed.len() <= pairs.len(),
        "{} of {}: {missed:?}",
        missed.len(),
        pairs.len()
    );
}
