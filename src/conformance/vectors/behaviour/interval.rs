//! Behaviours that give another hit, or none: their answers are known beforehand.

use super::predict::{Meet, answer, right, ways};
use super::{Behaviour, Evidence, Judged, Tally, Threshold, is_about_right};
use crate::conformance::{Answer, Question};
use crate::float::Float;
use std::collections::BTreeSet;

/// What garbage a unit vector makes that is none depends on the order of operations where the
/// length is extreme, so half of the cases are enough there.
fn threshold(behaviour: Behaviour) -> Threshold {
    let (matched, part) = match behaviour {
        Behaviour::UnitDirectionAssumed => (3, 0.5),
        _ => (2, 0.8),
    };
    Threshold { matched, part }
}

/// A case with what was asked, what would be right and what was answered.
struct Told<'a, 'b, F: Float> {
    judged: &'b Judged<'a>,
    question: Question<F>,
    right: Answer<F>,
    told: Option<Answer<F>>,
    is_right: bool,
}

/// What is named, and the ids of the cases that it explains: those that tell it from the truth.
///
/// The behaviour that explains most cases is named first; what it explains speaks for no other.
pub fn recognise<'a, F: Float>(group: &[&Judged<'a>]) -> (Vec<Evidence<'a>>, BTreeSet<&'a str>) {
    let told: Vec<Told<F>> = group
        .iter()
        .filter_map(|judged| Told::new(judged))
        .collect();
    let (mut named, mut explained) = (vec![], BTreeSet::new());
    let mut ways: Vec<(Behaviour, &[Meet<F>])> = ways::<F>().to_vec();
    loop {
        let tallies = ways.iter().flat_map(|(behaviour, ways)| {
            let tally = |meet: &Meet<F>| (*behaviour, tally(&told, *meet, &explained));
            ways.iter().map(tally)
        });
        let found = tallies.filter_map(|(behaviour, tally)| {
            let evidence = tally.evidence(behaviour, group, threshold(behaviour))?;
            Some((evidence, tally.telling))
        });
        let Some((evidence, telling)) = found.max_by_key(|(evidence, _)| evidence.matched) else {
            return (named, explained);
        };
        ways.retain(|(behaviour, _)| *behaviour != evidence.behaviour);
        named.push(evidence);
        explained.extend(telling);
    }
}

impl<'a, 'b, F: Float> Told<'a, 'b, F> {
    fn new(judged: &'b Judged<'a>) -> Option<Self> {
        let question = judged.case.question::<F>().ok()?;
        Some(Self {
            judged,
            right: answer(&question, right::<F>)?,
            question,
            told: Answer::of(judged.case.kernel(), &judged.out).ok(),
            is_right: is_about_right::<F>(judged),
        })
    }
}

fn tally<'a, F: Float>(
    told: &[Told<'a, '_, F>],
    meet: Meet<F>,
    explained: &BTreeSet<&str>,
) -> Tally<'a> {
    let mut tally = Tally::default();
    let open = |told: &&Told<F>| !explained.contains(told.judged.case.id());
    for case in told.iter().filter(open) {
        let Some(predicted) = answer(&case.question, meet) else {
            continue;
        };
        if is_same(&predicted, &case.right) {
            tally.other(is_hit(&case.right), case.is_right);
        } else {
            let told = case.told.as_ref();
            let matches = told.is_some_and(|told| is_same(told, &predicted));
            tally.tell(case.judged, matches && !case.is_right);
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
