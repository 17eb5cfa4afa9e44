//! Shadow rays' origins that are proven to be off their surface.

use crate::property::{Sample, for_all, positive, vector};
use ombrage::{Plane, Vector, leave};
use proptest::prelude::*;
use std::cmp::Ordering;

/// A plane across z at this height.
fn level<F: Sample>(z: F) -> Plane<F> {
    let zero = F::from_f64(0.0);
    let [point, up] = [z, F::from_f64(1.0)].map(|z| F::Vector::new(zero, zero, z));
    Plane::new(point, up).expect("a plane")
}

/// From a plane to the side of its normal, the way is a step of the largest coordinate, and no more.
pub fn it_is_the_next_number_off_a_surface<F: Sample>() {
    for_all(positive::<F>(-30..30), |z| {
        let plane = level(z);
        for (up, wanted) in [(1.0, Ordering::Greater), (-1.0, Ordering::Less)] {
            let normal = plane.normal() * F::from_f64(up);
            let left = leave::<F>(plane.point(), normal, |p| plane.side(p), wanted);
            let [_, _, above] = left.to_array();
            prop_assert_eq!(above, z.step(F::from_f64(up)));
        }
        Ok(())
    });
}

/// A point on the wanted side is returned bit for bit, wherever the normal shows.
pub fn a_point_that_is_off_stays<F: Sample>() {
    let inputs = (vector::<F>(-8..8), vector::<F>(-8..8));
    for_all(inputs, |(point, normal)| {
        let plane = level(F::from_f64(0.0));
        let side = plane.side(point);
        let stays = leave::<F>(point, normal, |p| plane.side(p), side);
        prop_assert_eq!(stays.to_array(), point.to_array());
        Ok(())
    });
}

/// Along the surface there is no way off it, and none for a point or a normal that is not finite.
pub fn where_no_way_helps_the_point_stays<F: Sample>() {
    let [zero, one, nan] = [0.0, 1.0, f64::NAN].map(F::from_f64);
    let plane = level(one);
    let off = |point: F::Vector, normal: F::Vector| {
        leave::<F>(point, normal, |p| plane.side(p), Ordering::Greater)
    };
    let sideways = F::Vector::new(one, zero, zero);
    assert_eq!(
        off(plane.point(), sideways).to_array(),
        plane.point().to_array()
    );
    let nowhere = F::Vector::new(nan, zero, one);
    assert_eq!(
        off(plane.point(), nowhere).to_array(),
        plane.point().to_array()
    );
    assert!(!off(nowhere, plane.normal()).to_array()[0].is_finite());
}
