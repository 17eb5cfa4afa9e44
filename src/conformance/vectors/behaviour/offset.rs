//! Shadow rays whose origin moves by the same length everywhere.

use super::{Behaviour, Evidence, Judged, Tally, Threshold, Wrong};
use crate::conformance::{Answer, Kernel, Offset, Question};
use crate::float::Float;
use crate::vector::Vector;

const THRESHOLD: Threshold = Threshold {
    matched: 3,
    part: 0.8,
};

/// What is named: most of all origins, right or wrong, are `p + length n`, rounded, with one length
/// for points whose coordinates differ by orders of magnitude.
pub fn recognise<'a, F: Float>(group: &[&Judged<'a>]) -> Option<Evidence<'a>> {
    let moves: Vec<(&Judged<'a>, Offset<F>, F::Vector)> = group
        .iter()
        .filter_map(|judged| {
            let Ok(Question::Offset(question)) = judged.case.question::<F>() else {
                return None;
            };
            match Answer::<F>::of(Kernel::Offset, &judged.out) {
                Ok(Answer::Offset(after)) => Some((*judged, question, after)),
                _ => None,
            }
        })
        .collect();
    let mut lengths: Vec<f64> = moves
        .iter()
        .filter(|(_, question, _)| size::<F>(question.point) < 100.0)
        .map(|(_, question, after)| length::<F>(*after - question.point))
        .collect();
    lengths.sort_by(f64::total_cmp);
    let length = lengths.get(lengths.len() / 2).copied()?;
    let mut tally = Tally::default();
    let mut wrong = false;
    for (judged, question, after) in &moves {
        let predicted = question.point + question.normal * F::from_f64(length);
        let matches = is_near::<F>(*after, predicted, length);
        wrong |= matches && matches!(judged.verdict.wrong, Some(Wrong::Side | Wrong::Far));
        tally.tell(judged, matches);
    }
    tally
        .evidence(Behaviour::OffsetConstant, group, THRESHOLD)
        .filter(|_| wrong && length > 0.0)
}

fn size<F: Float>(v: F::Vector) -> f64 {
    let sizes = v.to_array().map(|x| x.to_f64().abs());
    sizes.into_iter().fold(0.0, f64::max)
}

fn length<F: Float>(v: F::Vector) -> f64 {
    let squares = v.to_array().map(|x| x.to_f64() * x.to_f64());
    squares.into_iter().sum::<f64>().sqrt()
}

/// Within two units in the last place, or one in a hundred of the way.
fn is_near<F: Float>(a: F::Vector, b: F::Vector, way: f64) -> bool {
    let near =
        |(a, b): (F, F)| a.ulp_distance(b) <= 2 || (a.to_f64() - b.to_f64()).abs() <= 0.01 * way;
    a.to_array().into_iter().zip(b.to_array()).all(near)
}
