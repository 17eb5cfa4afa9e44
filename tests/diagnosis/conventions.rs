//! How a right picture was drawn, and how sure that is.

use crate::naive::Naive;
use crate::{WIDE, judge, picture};
use ombrage::conformance::diagnosis::{Diagnosis, Rounding, Sampling, Verdict, diagnose};
use ombrage::{Figure, Picture, Size};

#[test]
fn are_those_of_the_drawing() {
    let right = Naive::figure("3c", WIDE.0, WIDE.1);
    for (sampling, sampled) in [
        (Sampling::Corner, right),
        (
            Sampling::Center,
            Naive {
                middle: true,
                over_width: true,
                ..right
            },
        ),
        (
            Sampling::CenterOfSteps,
            Naive {
                middle: true,
                ..right
            },
        ),
        (
            Sampling::Average,
            Naive {
                side: 4,
                over_width: true,
                ..right
            },
        ),
        (Sampling::AverageOfSteps, Naive { side: 4, ..right }),
    ] {
        for (rounding, round) in [(Rounding::Truncate, false), (Rounding::Nearest, true)] {
            for t_max in [1000.0, f32::INFINITY] {
                let naive = Naive {
                    round,
                    t_max,
                    ..sampled
                };
                let Diagnosis {
                    verdict,
                    conventions,
                    ..
                } = judge(&naive, "3c");
                let words = format!("{sampling:?} {rounding:?} {t_max}: {conventions:?}");
                assert_eq!(verdict, Verdict::Conforms, "{words}");
                assert_eq!(conventions.sampling, sampling, "{words}");
                assert_eq!(conventions.rounding, rounding, "{words}");
                let t_max = Some(f64::from(t_max));
                assert!(
                    conventions.t_max.is_none() || conventions.t_max == t_max,
                    "{words}"
                );
            }
        }
    }
}

/// The largest parameter cuts the plane off before the horizon: a row of a high picture, beside the
/// sphere.
#[test]
fn t_max_shows_in_a_high_picture() {
    for t_max in [1000.0, f32::INFINITY] {
        let naive = Naive {
            t_max,
            ..Naive::figure("1", 260, 620)
        };
        let conventions = judge(&naive, "1").conventions;
        assert_eq!(conventions.t_max, Some(f64::from(t_max)));
    }
}

#[test]
fn a_margin_tells_the_best_from_the_next() {
    let right = judge(&Naive::figure("3c", WIDE.0, WIDE.1), "3c").margin;
    assert!(right.error < 0.1 && right.runner_up_error > right.error);
    assert!(!right.runner_up.is_empty());
    let share = right.share();
    assert!((0.0..=1.0).contains(&share) && share > 0.5, "{right:?}");
    let equal = ombrage::conformance::diagnosis::Margin {
        error: right.runner_up_error,
        ..right
    };
    assert_eq!(equal.share(), 0.0);
}

/// The smallest pictures that are judged are judged, smaller ones are refused, and so is a detail.
#[test]
fn sizes() {
    for (width, height, is_judged) in [(32, 32, true), (31, 32, false), (32, 31, false)] {
        let picture = picture(&Naive::figure("3c", width, height));
        let figure = Figure::named("3c").expect("a figure");
        assert_eq!(diagnose(&picture, figure, &[]).is_ok(), is_judged);
    }
    let detail = Figure::named("3b").expect("a figure");
    let size = Size::new(60, 40).expect("a size");
    let picture = Picture::black(size);
    let refused = diagnose(&picture, detail, &[]).expect_err("a detail");
    assert_eq!(refused.field, "figure");
}
