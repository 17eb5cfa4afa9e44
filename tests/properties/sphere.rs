//! Where rays meet spheres.

use crate::exact::{dot, exact, exact_vector, minus};
use crate::property::{Sample, for_all, positive, ray, unit_roundoff, vector};
use crate::report::differs;
use ombrage::{Plane, Quality, Ray, Shape, Span, Sphere, Vector};
use proptest::prelude::*;

fn spheres<F: Sample>() -> impl Strategy<Value = Sphere<F>> {
    let parts = (vector::<F>(-4..5), positive::<F>(-2..4));
    parts.prop_filter_map("a sphere", |(center, radius)| {
        Sphere::new(center, radius).ok()
    })
}

/// A scene seen in mirrors across the coordinate planes is hit at the same t, to the bit.
pub fn hits_are_the_same_in_a_mirror<F: Sample>() {
    for_all(
        (spheres::<F>(), ray::<F>(-4..5), any::<[bool; 3]>()),
        |(sphere, ray, mirrors)| {
            let mirrored = |v: F::Vector| {
                let flip = |(x, mirror): (F, bool)| if mirror { -x } else { x };
                let [x, y, z] = v.to_array();
                let [a, b, c] = mirrors;
                F::Vector::new(flip((x, a)), flip((y, b)), flip((z, c)))
            };
            let all = Span::new(-F::MAX, F::MAX);
            let hit = sphere.intersect(&ray, &all, Quality::Textbook);
            let center = mirrored(sphere.center());
            let twin = Sphere::new(center, sphere.radius());
            let twin = twin.map_err(|error| TestCaseError::fail(error.to_string()))?;
            let (origin, direction) = (mirrored(ray.origin), mirrored(ray.direction));
            let seen = twin.intersect(&Ray { origin, direction }, &all, Quality::Textbook);
            prop_assert_eq!(hit.mask, seen.mask);
            let [ox, oy, oz] = ray.origin.to_array();
            let [dx, dy, dz] = ray.direction.to_array();
            let [cx, cy, cz] = sphere.center().to_array();
            let inputs = [
                ("origin x", ox),
                ("origin y", oy),
                ("origin z", oz),
                ("direction x", dx),
                ("direction y", dy),
                ("direction z", dz),
                ("center x", cx),
                ("center y", cy),
                ("center z", cz),
                ("radius", sphere.radius()),
            ];
            let same = !hit.mask || hit.t == seen.t;
            prop_assert!(same, "{}", differs("t in a mirror", &inputs, hit.t, seen.t));
            Ok(())
        },
    );
}

/// A ray aimed well inside the sphere (at most 0.87 of the radius from its centre) hits it in a
/// point whose distance from the centre is the radius, give or take
/// `64 u m² / r + 4 u (|p| + |o|)`, where m is the larger of r and the distance of the origin.
///
/// Counting the roundings of `b² - 4ac`: b is off by 8 u |d| m, c by 7 u m², so the discriminant by
/// 88 u |d|² m²; its root is at least 0.98 |d| r, so the root is off by 45 u |d| m² / r; half of
/// that, and 10 u m for -b and the division, is the way along the ray. The point itself takes two
/// roundings more.
pub fn hit_point_lies_on_sphere<F: Sample>() {
    let aim = [-0.5..0.5, -0.5..0.5, -0.5..0.5];
    for_all(
        (spheres::<F>(), vector::<F>(-4..5), aim),
        |(sphere, origin, aim)| {
            let inside = F::Vector::constant((), aim) * sphere.radius();
            let direction = sphere.center() + inside - origin;
            let length = direction.dot(direction).to_f64().sqrt();
            prop_assume!(length > 1e-2);
            let ray = Ray { origin, direction };
            let hit = sphere.intersect(&ray, &Span::new(F::default(), F::MAX), Quality::Textbook);
            prop_assert!(hit.mask, "a ray into the sphere misses it");
            let f64s = |v: F::Vector| v.to_array().map(ombrage::Scalar::to_f64);
            let size = |v: F::Vector| f64s(v).into_iter().map(|c| c * c).sum::<f64>().sqrt();
            let point = ray.point_at(hit.t);
            let from_center = minus(
                &exact_vector::<F>(point),
                &exact_vector::<F>(sphere.center()),
            );
            let radius = exact(sphere.radius());
            let off = dot(&from_center, &from_center) - &radius * &radius;
            let (off, r) = (off.to_f64().value().abs(), sphere.radius().to_f64());
            let m = size(origin - sphere.center()).max(r);
            let allowed =
                unit_roundoff::<F>() * (64.0 * m * m / r + 4.0 * (size(point) + size(origin)));
            prop_assert!(
                off <= 2.0 * r * allowed + allowed * allowed,
                "off by {:e}, {allowed:e} allowed",
                off / 2.0 / r
            );
            Ok(())
        },
    );
}

/// Between the two hits the ray is inside; so an interval within has none, and one around has both.
pub fn an_interval_sees_the_roots_it_contains<F: Sample>() {
    for_all((spheres::<F>(), ray::<F>(-4..5)), |(sphere, ray)| {
        let everything = Span::new(-F::MAX, F::MAX);
        let near = sphere.intersect(&ray, &everything, Quality::Textbook);
        prop_assert_eq!(
            near.mask,
            sphere.intersect_any(&ray, &everything, Quality::Textbook)
        );
        if !near.mask || near.t == F::default() {
            return Ok(());
        }
        let after = near.t.step(F::from_f64(1.0));
        let at = |min, max| sphere.intersect(&ray, &Span::new(min, max), Quality::Textbook);
        prop_assert_eq!(
            at(near.t, near.t).mask,
            true,
            "the interval of the near root alone"
        );
        let far = at(after, F::MAX);
        if far.mask {
            prop_assert!(far.t > near.t);
            prop_assert_eq!(at(far.t, far.t).t, far.t);
            prop_assert_eq!(at(near.t, far.t).t, near.t, "both ends");
            if after < far.t {
                let before = far.t.step(F::from_f64(-1.0));
                prop_assert!(
                    far.t == F::default() || !at(after, before).mask,
                    "between the roots"
                );
            }
        }
        Ok(())
    });
}

/// A sphere far bigger than the scene is nearly its tangent plane.
pub fn a_huge_sphere_is_a_plane<F: Sample>() {
    let inputs = (
        [-1.0..1.0, 1.0..2.0, -1.0..1.0],
        [-0.5..0.5f64, -0.5..0.5f64],
    );
    for_all(inputs, |(origin, [x, z])| {
        let vector = |v: [f64; 3]| F::Vector::constant((), v);
        let ray: Ray<F> = Ray {
            origin: vector(origin),
            direction: vector([x, -1.0, z]),
        };
        // At a radius of 1024 a ray within 3 of the top sinks by at most 3² / 2048 below the plane.
        let sphere = Sphere::<F>::new(vector([0.0, -1024.0, 0.0]), F::from_f64(1024.0));
        let plane = Plane::<F>::new(vector([0.0; 3]), vector([0.0, 1.0, 0.0]));
        let ((Ok(sphere), Ok(plane)), all) = ((sphere, plane), Span::new(F::default(), F::MAX))
        else {
            return Err(TestCaseError::fail("the shapes are valid"));
        };
        let (round, flat) = (
            sphere.intersect(&ray, &all, Quality::Textbook),
            plane.intersect(&ray, &all, Quality::Textbook),
        );
        prop_assert!(round.mask && flat.mask);
        // The roundings of the sphere's formula add 64 u m² / r with m < 1027.
        let sinks = 9.0 / 2048.0 + unit_roundoff::<F>() * 64.0 * 1030.0;
        let apart = round.t.to_f64() - flat.t.to_f64();
        prop_assert!((-sinks..=2.0 * sinks).contains(&apart), "{apart} apart");
        Ok(())
    });
}
