//! What each wrong way answers where that can be told by hand: rays along z.

use super::{Meet, answer, ways};
use crate::conformance::{Answer, Behaviour, Question, Surface};
use crate::float::Float;
use crate::ray::Ray;
use crate::vector::Vector;

/// A ray from a place on the z axis, along it with some speed, in an interval.
type Asked = (f64, f64, [f64; 2]);

fn at<F: Float>(z: f64) -> F::Vector {
    F::Vector::constant((), [0.0, 0.0, z])
}

fn told<F: Float>(way: Meet<F>, (from, speed, ends): Asked, surface: &Surface<F>) -> Option<f64> {
    let ray = Ray {
        origin: at::<F>(from),
        direction: at::<F>(speed),
    };
    way(&ray, ends.map(F::from_f64), surface).map(F::to_f64)
}

/// From 3 to 7.
fn sphere<F: Float>() -> Surface<F> {
    Surface::Sphere {
        center: at::<F>(5.0),
        radius: F::from_f64(2.0),
    }
}

/// A plane across the axis, with its normal along it.
fn plane<F: Float>(z: f64, normal: f64) -> Surface<F> {
    Surface::Plane {
        point: at::<F>(z),
        normal: at::<F>(normal),
    }
}

fn answers<F: Float>(way: Meet<F>, surface: &Surface<F>, told_by_hand: &[(Asked, Option<f64>)]) {
    for (number, (asked, by_hand)) in told_by_hand.iter().enumerate() {
        let told = told(way, *asked, surface);
        let is_near = told
            .zip(*by_hand)
            .is_some_and(|(told, by_hand)| (told - by_hand).abs() < 1e-5 * by_hand.abs());
        assert!(is_near || told == *by_hand, "{number}: {asked:?}, {told:?}");
    }
}

/// What is right and well inside the interval is answered so by every way.
fn is_right_inside<F: Float>(ways: &[Meet<F>]) {
    let asked = (0.0, 1.0, [1.0, 9.0]);
    for &way in ways {
        answers(way, &sphere(), &[(asked, Some(3.0))]);
        answers(way, &plane(4.0, -1.0), &[(asked, Some(4.0))]);
    }
}

fn ends<F: Float>() {
    let [_, (t_max, without_end), (t_min, starts), (open, opens), ..] = ways::<F>();
    assert_eq!(
        [t_max, t_min, open],
        [
            Behaviour::TMaxIgnored,
            Behaviour::TMinIgnored,
            Behaviour::OpenInterval
        ]
    );
    is_right_inside(without_end);
    is_right_inside(&starts[..2]);
    is_right_inside(opens);
    let sphere = sphere::<F>();
    let &[without_end] = without_end else {
        panic!("one way")
    };
    answers(
        without_end,
        &sphere,
        &[
            ((0.0, 1.0, [0.0, 2.0]), Some(3.0)),
            ((0.0, 1.0, [4.0, 5.0]), Some(7.0)),
            ((0.0, 1.0, [8.0, 9.0]), None),
        ],
    );
    let [from_zero, without_start, constants @ ..] = starts else {
        panic!("two ways")
    };
    answers(
        *from_zero,
        &sphere,
        &[
            ((0.0, 1.0, [4.0, 9.0]), Some(3.0)),
            ((6.0, 1.0, [-5.0, 9.0]), Some(1.0)),
            ((9.0, 1.0, [-9.0, 9.0]), None),
            ((0.0, 1.0, [4.0, 2.0]), None),
        ],
    );
    answers(
        *without_start,
        &sphere,
        &[
            ((0.0, 1.0, [4.0, 9.0]), Some(3.0)),
            ((9.0, 1.0, [0.0, 9.0]), Some(-6.0)),
            ((9.0, 1.0, [0.0, -7.0]), None),
        ],
    );
    for (way, constant) in constants.iter().zip([1e-6, 1e-5, 1e-4, 1e-3]) {
        let (before, after) = (plane(0.5 * constant, 1.0), plane(2.0 * constant, 1.0));
        answers(*way, &before, &[((0.0, 1.0, [0.0, 9.0]), None)]);
        let found = Some(2.0 * constant);
        answers(
            *way,
            &after,
            &[
                ((0.0, 1.0, [0.0, 9.0]), found),
                ((0.0, 1.0, [1.0, 9.0]), found),
                ((0.0, 1.0, [0.0, constant]), None),
            ],
        );
    }
    assert_eq!(constants.len(), 4);
}

fn open_ends<F: Float>() {
    let [.., (_, opens), _, _] = ways::<F>();
    let &[
        after_start,
        before_end,
        inside,
        unless_at_start,
        unless_at_an_end,
    ] = opens
    else {
        panic!("five ways");
    };
    let sphere = sphere::<F>();
    // Of a ray that starts before the sphere, on it and in it: what an interval from the near root
    // on has, one up to it, one from the far root on, one up to that.
    for (from, near, far) in [(0.0, 3.0, 7.0), (3.0, 0.0, 4.0), (6.0, -3.0, 1.0)] {
        let asked = |min: f64, max: f64| (from, 1.0, [min, max]);
        let (before, between, beyond) = (near - 1.0, 0.5 * (near + far), far + 1.0);
        for (way, at_near, to_near, at_far, to_far) in [
            (after_start, Some(far), Some(near), None, Some(far)),
            (before_end, Some(near), None, Some(far), None),
            (inside, Some(far), None, None, None),
            (unless_at_start, None, Some(near), None, Some(far)),
            (unless_at_an_end, None, None, None, None),
        ] {
            answers(
                way,
                &sphere,
                &[
                    (asked(near, beyond), at_near),
                    (asked(before, near), to_near),
                    (asked(far, beyond), at_far),
                    (asked(between, far), to_far),
                    (asked(before, beyond), Some(near)),
                    (asked(between, beyond), Some(far)),
                ],
            );
        }
    }
}

/// After 0 come the smallest numbers: a far root as near to it as there are is the next hit.
fn next_to_zero<F: Float>() {
    let [.., (_, opens), _, _] = ways::<F>();
    for speed in [8.0, 1e20, 1e-3 / F::MIN_POSITIVE] {
        let asked = (3.0, speed, [0.0, 9.0]);
        answers(opens[0], &sphere::<F>(), &[(asked, Some(4.0 / speed))]);
    }
}

fn sides<F: Float>() {
    let [.., (culled, cullers), (missed, missers)] = ways::<F>();
    assert_eq!(
        [culled, missed],
        [Behaviour::PlaneCulled, Behaviour::InsideMissed]
    );
    let &[from_the_front, from_behind] = cullers else {
        panic!("two ways")
    };
    let asked = (0.0, 2.0, [0.0, 9.0]);
    for normal in [0.5, 1.0, 3.0] {
        let (facing, turned) = (plane(4.0, -normal), plane(4.0, normal));
        answers(from_the_front, &facing, &[(asked, Some(2.0))]);
        answers(from_the_front, &turned, &[(asked, None)]);
        answers(from_behind, &facing, &[(asked, None)]);
        answers(from_behind, &turned, &[(asked, Some(2.0))]);
    }
    let (before, on, within) = (0.0, 3.0, 5.0);
    let far = |from: f64| (from, 1.0, [0.5, 9.0]);
    let all = |from: f64| (from, 1.0, [-9.0, 9.0]);
    for way in cullers {
        answers(
            *way,
            &sphere(),
            &[(far(before), Some(3.0)), (far(within), Some(2.0))],
        );
    }
    let &[near_root, from_outside, from_off] = missers else {
        panic!("three ways")
    };
    let beyond = (before, 1.0, [4.0, 9.0]);
    for (way, told) in [
        (near_root, [None, None, None, Some(0.0), Some(-2.0)]),
        (from_outside, [Some(7.0), Some(4.0), None, Some(0.0), None]),
        (from_off, [Some(7.0), None, None, None, None]),
    ] {
        let asked = [beyond, far(on), far(within), all(on), all(within)];
        let told: Vec<_> = asked.into_iter().zip(told).collect();
        answers(way, &sphere(), &told);
        answers(way, &sphere(), &[(far(before), Some(3.0))]);
        answers(
            way,
            &plane(4.0, 1.0),
            &[(far(before), Some(4.0)), (all(within), Some(-1.0))],
        );
    }
}

/// With a direction of 1.1, of which the square is taken for 1: by hand `5.5 ± √(5.5² - 21)`, and
/// `5.5 ± √(4 - (1.1 · 5.5 - 5)²)`. Beside the axis, what is left of the radius.
fn unit_directions<F: Float>() {
    let [(unit, ways), ..] = ways::<F>();
    assert_eq!(unit, Behaviour::UnitDirectionAssumed);
    is_right_inside(ways);
    let &[without_a, residual, by_distance] = ways else {
        panic!("three ways")
    };
    let sphere = sphere::<F>();
    let asked = |min: f64, max: f64| (0.0, 1.1, [min, max]);
    for (way, root) in [(without_a, 9.25_f64.sqrt()), (residual, 2.8975_f64.sqrt())] {
        let (near, far) = (5.5 - root, 5.5 + root);
        answers(
            way,
            &sphere,
            &[
                (asked(0.0, 9.0), Some(near)),
                (asked(5.0, 9.0), Some(far)),
                (asked(0.0, 2.0), None),
                (asked(5.0, 6.0), None),
                (asked(9.0, 99.0), None),
            ],
        );
        // Both ends belong to the interval.
        for (ends, told) in [
            ([3.0, 5.0], 3.0),
            ([0.0, 3.0], 3.0),
            ([7.0, 9.0], 7.0),
            ([5.0, 7.0], 7.0),
        ] {
            answers(way, &sphere, &[((0.0, 1.0, ends), Some(told))]);
        }
        answers(way, &plane(4.4, 1.0), &[(asked(0.0, 9.0), Some(4.0))]);
    }
    answers(residual, &sphere, &[((0.0, 2.0, [0.0, 99.0]), None)]);
    for speed in [0.25, 1.1, 8.0] {
        let asked = |min: f64| (0.0, speed, [min, 9.0]);
        answers(
            by_distance,
            &sphere,
            &[(asked(0.0), Some(3.0)), (asked(4.0), Some(7.0))],
        );
        answers(by_distance, &plane(4.0, 1.0), &[(asked(0.0), Some(4.0))]);
    }
}

/// Any hit is one of any surface; what is not asked about hits has no answer here.
fn any_hit<F: Float>() {
    let [_, (_, ways), ..] = ways::<F>();
    let asked = |surfaces: &[Surface<F>], from: f64| {
        let question = Question::AnyHit {
            ray: Ray {
                origin: at::<F>(from),
                direction: at::<F>(1.0),
            },
            ends: [0.0, 1.0].map(F::from_f64),
            surfaces: surfaces.to_vec(),
        };
        matches!(answer(&question, ways[0]), Some(Answer::AnyHit(true)))
    };
    let (sphere, plane) = (sphere(), plane(20.0, 1.0));
    assert!(asked(&[sphere], 0.0) && !asked(&[sphere], 9.0) && !asked(&[], 0.0));
    assert!(asked(&[sphere, plane], 9.0) && asked(&[plane, sphere], 9.0));
    assert!(answer(&Question::Quantise(F::from_f64(0.5)), ways[0]).is_none());
}

#[test]
fn each_way_has_the_answers_told_by_hand() {
    ends::<f32>();
    ends::<f64>();
    open_ends::<f32>();
    open_ends::<f64>();
    next_to_zero::<f32>();
    next_to_zero::<f64>();
    sides::<f32>();
    sides::<f64>();
    unit_directions::<f32>();
    unit_directions::<f64>();
    any_hit::<f32>();
    any_hit::<f64>();
}
