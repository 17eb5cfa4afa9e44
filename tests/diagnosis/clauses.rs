//! What a picture shows of the clauses and of the faults.

use crate::faults::faults;
use crate::naive::Naive;
use crate::{WIDE, judge, variants};
use ombrage::conformance::diagnosis::{Diagnosis, Verdict};

const FIGURES: [&str; 5] = ["1", "2a", "2b", "3a", "3c"];

fn figure(name: &str) -> Naive {
    Naive::figure(name, WIDE.0, WIDE.1)
}

/// Every clause is shown, not shown or broken, and only one of them; the clause of a fault is not
/// shown to hold.
#[test]
fn each_clause_once() {
    let sections = include_str!("../../docs/spec.md").split("\n### ").skip(1);
    let all: Vec<&str> = sections
        .filter_map(|section| section.split(' ').next())
        .collect();
    assert!(all.contains(&"1.1") && all.contains(&"E.8"), "{all:?}");
    let right = FIGURES.map(|name| (name, figure(name)));
    let wrong = faults(WIDE.0, WIDE.1).into_iter();
    let wrong = wrong.map(|(_, name, naive)| (name, naive)).step_by(3);
    for (name, naive) in right.into_iter().chain(wrong) {
        let diagnosis = judge(&naive, name);
        let Diagnosis {
            verdict,
            findings,
            shown,
            not_shown,
            ..
        } = &diagnosis;
        for clause in &all {
            let times = [shown, not_shown].map(|list| list.iter().filter(|c| *c == clause).count());
            let is_broken = findings.iter().any(|finding| finding.clause() == *clause);
            assert!(times[0] + times[1] <= 1, "{clause} {diagnosis:?}");
            if is_broken {
                assert_eq!(times[0], 0, "{clause} {diagnosis:?}");
            } else if *verdict == Verdict::Conforms {
                assert_eq!(times[0] + times[1], 1, "{clause} {diagnosis:?}");
            }
        }
        assert!(shown.is_sorted() && not_shown.is_sorted());
    }
}

/// What the lab's figures are about.
#[test]
fn figures_show_their_clauses() {
    let shows = |name: &str| {
        let diagnosis = judge(&figure(name), name);
        assert_eq!(diagnosis.verdict, Verdict::Conforms, "{diagnosis:?}");
        diagnosis.shown
    };
    let [eye, wraps, clamps, acne, shadows] = FIGURES.map(shows);
    for (clause, which) in [
        ("1.1", [true; 5]),
        ("1.2", [true; 5]),
        ("1.3", [true; 5]),
        ("2.1", [false, true, true, true, true]),
        ("2.3", [false, true, true, true, true]),
        ("3.2", [false, true, false, false, false]),
        ("3.3", [false, false, true, true, true]),
        ("4.1", [false, false, false, true, true]),
        ("4.2", [false, false, false, true, false]),
        ("4.3", [false, false, false, false, true]),
        ("5.1", [false; 5]),
        ("E.1", [true; 5]),
        ("E.4", [true, false, false, false, false]),
        ("E.8", [false; 5]),
    ] {
        let shown = [&eye, &wraps, &clamps, &acne, &shadows];
        assert_eq!(
            shown.map(|shown| shown.contains(&clause)),
            which,
            "{clause}"
        );
    }
}

/// A fault that is called invisible changes nothing in a picture of the plain ray tracer, and one
/// that is not does.
#[test]
fn invisible_faults_leave_no_trace() {
    for name in ["1", "2b", "3c"] {
        let right = figure(name);
        let invisible = judge(&right, name).invisible;
        for (code, change) in variants::CHANGES {
            // Acne is judged by its statistics.
            if code == "ACNE" {
                continue;
            }
            let (a, b) = (right.draw(), changed(right, change).draw());
            let pairs = a.chunks_exact(3).zip(b.chunks_exact(3));
            let differ =
                |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 2);
            let is_visible = pairs.filter(differ).count() >= 8;
            let is_called_so = !invisible.iter().any(|known| known.name() == code);
            assert_eq!(is_called_so, is_visible, "{code} in {name}: {invisible:?}");
        }
    }
}

fn changed(mut naive: Naive, change: fn(&mut Naive)) -> Naive {
    change(&mut naive);
    naive
}
