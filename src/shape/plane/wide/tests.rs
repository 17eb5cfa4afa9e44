//! The filter of the plane, and its exact way.

use super::super::super::wide::tests::{
    Triple, crossed, everywhere, for_all, from_next_to, is_right, near_one, plus, scaled, vector,
};
use super::{Question, are_parallel};
use crate::Plane;
use crate::real::Scalar;
use crate::shape::wide::trust;
use proptest::prelude::*;

/// The question of a plane from an origin at this height over it, and a direction that climbs by so
/// much on its way of 1.
fn question<S: Scalar>(
    [along, normal]: [Triple; 2],
    (height, slope): (f64, f64),
    length: f64,
) -> Question<S::Wide> {
    let point = [0.5, -0.25, 0.375];
    Question {
        origin: vector::<S>(plus(plus(point, along, -1.25), normal, height)),
        direction: vector::<S>(plus(along, normal, slope)),
        point: vector::<S>(point),
        normal: vector::<S>(scaled(normal, length)),
        span: everywhere(),
    }
}

/// A number that may be next to 0.
fn small() -> impl Strategy<Value = f64> {
    (near_one(50), 0.25..1.0_f64).prop_map(|(factor, size)| (factor - 1.0) * size)
}

/// Origins next to the plane, directions next to along it, ends next to the hit.
fn never_wrong<S: Scalar>() {
    let inputs = (crossed(), (small(), small()), 1.0..2.0_f64, near_one(110));
    for_all(inputs, |(lines, place, length, end)| {
        let asked = question::<S>(lines, place, length);
        let trusted = trust::<S>();
        prop_assert!(is_right::<S>(asked.filtered(trusted), asked.exact()));
        let span = from_next_to(asked.exact(), end);
        let asked = Question { span, ..asked };
        prop_assert!(is_right::<S>(asked.filtered(trusted), asked.exact()));
        Ok(())
    });
}

/// A ray that is well off the plane and not along it leaves no doubt.
fn decides<S: Scalar>() {
    let clear = || prop_oneof![-1.0..-0.01_f64, 0.01..1.0_f64];
    let inputs = (crossed(), (clear(), clear()), 1.0..2.0_f64, near_one(6));
    for_all(inputs, |(lines, place, length, end)| {
        let asked = question::<S>(lines, place, length);
        let trusted = trust::<S>();
        let found = asked.filtered(trusted);
        prop_assert!(matches!(found, Some(Some(_))));
        prop_assert!(is_right::<S>(found, asked.exact()));
        let span = from_next_to(asked.exact(), end);
        let asked = Question { span, ..asked };
        prop_assert!(asked.filtered(trusted).is_some());
        prop_assert!(is_right::<S>(asked.filtered(trusted), asked.exact()));
        Ok(())
    });
}

#[test]
fn the_filter_is_never_wrong() {
    never_wrong::<f32>();
    never_wrong::<f64>();
}

#[test]
fn what_is_off_the_plane_and_not_along_it_leaves_no_doubt() {
    decides::<f32>();
    decides::<f64>();
}

/// A vector is parallel to its multiples, and to nothing else, however near.
#[test]
fn parallels() {
    let factors = prop_oneof![Just(0.125_f64), Just(3.0), Just(-1.0), Just(-192.0)];
    for_all((crossed(), factors, 1..50), |([a, b], factor, bits)| {
        let exactly = a.map(|x| x as f32);
        let multiple = exactly.map(|x| f64::from(x) * factor);
        let exactly = exactly.map(f64::from);
        let parallel = |a: Triple, b: Triple| are_parallel::<f64>(a.into(), b.into());
        prop_assert!(parallel(exactly, multiple));
        prop_assert!(!parallel(exactly, b));
        let near = plus(multiple, b, 0.5_f64.powi(bits));
        prop_assert_eq!(parallel(exactly, near), near == multiple);
        Ok(())
    });
}

/// Planes coincide where a point of one is on the other and their normals are parallel; the lengths of
/// these do not matter, nor which points they go through.
#[test]
fn planes_of_the_same_points() {
    let plane = |point: Triple, normal: Triple| {
        Plane::<f64>::new(point.into(), normal.into()).expect("a plane")
    };
    let normal = [1.0, -2.0, 0.5];
    let one = plane([3.0, 1.0, 2.0], normal);
    let through = |by: [f64; 2]| {
        let [x, z] = by;
        [3.0 + 2.0 * x - 0.5 * z, 1.0 + x, 2.0 + z]
    };
    for by in [[0.0, 0.0], [1.0, 0.0], [-3.0, 8.0]] {
        for length in [1.0, -0.3, 7.0] {
            let same = plane(through(by), scaled(normal, length));
            assert!(one.coincides_with(&same) && same.coincides_with(&one));
        }
        let turned = plane(through(by), [1.0, -2.0, 0.5_f64.next_up()]);
        assert!(!one.coincides_with(&turned));
        let beside = plane(plus(through(by), normal, f64::EPSILON * 8.0), normal);
        assert!(!one.coincides_with(&beside));
    }
}
