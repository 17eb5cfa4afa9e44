//! Behaviours that show as errors of no certain size: the kernels fail where kernels with the
//! behaviour fail, and others do not.

use super::{Behaviour, Evidence, Judged, Tally, Threshold, is_about_right};
use crate::conformance::{Kernel, Kernels, Question, promise};
use crate::float::Float;
use crate::quality::Quality;
use crate::real::Scalar;
use crate::vector::Vector;
use std::collections::BTreeSet;

const THRESHOLD: Threshold = Threshold {
    matched: 3,
    part: 0.6,
};

/// What is named; cases that another behaviour explains do not count.
pub fn recognise<'a, F: Float>(
    kernel: Kernel,
    group: &[&Judged<'a>],
    explained: &BTreeSet<&str>,
) -> Vec<Evidence<'a>> {
    let (mut textbook, mut overflow) = (Tally::default(), Tally::default());
    for judged in group {
        let case = judged.case;
        if explained.contains(case.id()) {
            continue;
        }
        let Ok(question) = case.question::<F>() else {
            continue;
        };
        let fails = case.fails(&judged.verdict, promise(kernel).allowed);
        let plain = fails_in(judged, &question, Quality::Textbook);
        let stable = fails_in(judged, &question, Quality::Stable);
        // The kit's stable light samples are scaled; of rays only the wide ones are.
        let unscaled = if kernel == Kernel::LightSample {
            plain
        } else {
            stable
        };
        if unscaled {
            overflow.tell(judged, fails);
        } else if plain {
            if is_unit(&question) {
                textbook.tell(judged, fails);
            }
        } else {
            let class = has_nothing(judged);
            let right = is_about_right::<F>(judged);
            textbook.other(class, right);
            overflow.other(class, right);
        }
    }
    let textbook = textbook
        .evidence(Behaviour::TextbookSphere, group, THRESHOLD)
        .filter(|_| kernel == Kernel::RaySphere);
    let overflow = overflow.evidence(Behaviour::Overflow, group, THRESHOLD);
    textbook.into_iter().chain(overflow).collect()
}

/// Whether the kit's kernel of this quality is further from the truth than any good one.
fn fails_in<F: Float>(judged: &Judged, question: &Question<F>, quality: Quality) -> bool {
    let kernels = Kernels {
        quality,
        shadow: None,
    };
    let case = judged.case;
    kernels.answer(question).is_ok_and(|answer| {
        let verdict = case.judge(&answer.out());
        case.fails(&verdict, promise(case.kernel()).allowed)
    })
}

/// Whether the truth is that nothing is hit.
fn has_nothing(judged: &Judged) -> bool {
    let truth = judged.case.truth();
    let [hit, occluded] = ["hit", "occluded"].map(|key| truth[key]["closed"].as_bool());
    hit.or(occluded) == Some(false)
}

/// Whether the direction is a unit vector, give or take one in a thousand. Elsewhere kernels that
/// take it for one fail for that reason.
fn is_unit<F: Float>(question: &Question<F>) -> bool {
    match question {
        Question::Hit { ray, .. } => {
            let direction = ray.direction.to_array().map(Scalar::to_f64);
            let square: f64 = direction.iter().map(|x| x * x).sum();
            (square - 1.0).abs() < 2e-3
        }
        _ => true,
    }
}
