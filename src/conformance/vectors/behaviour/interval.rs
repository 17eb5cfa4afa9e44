//! Behaviours that give another hit, or none: their answers are known beforehand.

use super::predict::{Meet, answer, right, ways};
use super::{Evidence, Judged, Tally, Threshold, is_about_right};
use crate::conformance::Answer;
use crate::float::Float;
use std::collections::BTreeSet;

const THRESHOLD: Threshold = Threshold {
    matched: 2,
    part: 0.8,
};

/// What is named, and the ids of the cases that it explains.
pub fn recognise<'a, F: Float>(group: &[&Judged<'a>]) -> (Vec<Evidence<'a>>, BTreeSet<&'a str>) {
    let (mut named, mut explained) = (vec![], BTreeSet::new());
    for (behaviour, ways) in ways::<F>() {
        let tallies = ways.iter().map(|&meet| tally::<F>(group, meet));
        let found = tallies.filter_map(|tally| {
            let evidence = tally.evidence(behaviour, group, THRESHOLD)?;
            Some((evidence, tally.matching))
        });
        let best = found.max_by(|(a, _), (b, _)| {
            let part = |e: &Evidence| e.matched as f64 / e.telling as f64;
            let parts = part(a).total_cmp(&part(b));
            parts.then(a.matched.cmp(&b.matched))
        });
        if let Some((evidence, matching)) = best {
            named.push(evidence);
            explained.extend(matching);
        }
    }
    (named, explained)
}

fn tally<'a, F: Float>(group: &[&Judged<'a>], meet: Meet<F>) -> Tally<'a> {
    let mut tally = Tally::default();
    for judged in group {
        let case = judged.case;
        let Ok(question) = case.question::<F>() else {
            continue;
        };
        let answers = [meet, right::<F>].map(|meet| answer(&question, meet));
        let [Some(predicted), Some(right)] = answers else {
            continue;
        };
        let is_right = is_about_right::<F>(judged);
        if is_same(&predicted, &right) {
            tally.other(is_hit(&right), is_right);
        } else {
            let told = Answer::<F>::of(case.kernel(), &judged.out);
            let matches = told.is_ok_and(|told| is_same(&told, &predicted));
            tally.tell(judged, matches && !is_right);
        }
    }
    tally
}

fn is_hit<F: Float>(answer: &Answer<F>) -> bool {
    match answer {
        Answer::Hit(t) => t.is_some(),
        Answer::AnyHit(occluded) => *occluded,
        _ => false,
    }
}

/// Whether both hit or both miss, and at the same t, give or take one in a thousand.
fn is_same<F: Float>(a: &Answer<F>, b: &Answer<F>) -> bool {
    match (a, b) {
        (Answer::Hit(Some(a)), Answer::Hit(Some(b))) => {
            let [a, b] = [a, b].map(|t| t.to_f64());
            a == b || (a - b).abs() <= 1e-3 * a.abs().max(b.abs())
        }
        _ => is_hit(a) == is_hit(b),
    }
}
