//! The finest decisions: whether a ray touches a sphere, and what lies on a surface.

use crate::exact::{abs, dot, exact, exact_vector, minus, sum};
use crate::property::{Sample, for_all, positive, unit_roundoff, vector};
use dashu_ratio::RBig;
use ombrage::conformance::{Kernels, Offset, Shade, Surface};
use ombrage::{
    HitRecord, Invalid, Plane, Projection, Quality, Ray, Scene, Shadow, Shape, Span, Sphere, Vector,
};
use proptest::prelude::*;
use proptest::sample::select;
use std::cmp::Ordering;

/// Three directions at right angles, each of length 3, of whole numbers.
const AXES: [[f64; 3]; 3] = [[1.0, 2.0, 2.0], [2.0, 1.0, -2.0], [2.0, -2.0, 1.0]];

/// A ray along the first axis, and a sphere whose center is at 1 on the second, with a radius of 3,
/// is touched in exact arithmetic. Moved by e along the third axis, the sphere is missed by e², and
/// turned toward the second by e, the ray hits it by as little. All of it turned, mirrored, moved
/// along the ray and scaled by powers of two, which round nothing.
pub fn the_widest_kernel_tells_the_slightest_touch<F: Sample>() {
    let turned = (
        select(vec![[0, 1, 2], [1, 2, 0], [2, 0, 1]]),
        [any::<bool>(); 3],
    );
    let moved = (-4..5i32, -8..9i32, 1..F::PRECISION as i32 - 4);
    for_all(
        (turned, moved),
        |((order, mirrors), (size, along, fine))| {
            let unit = f64::from(size).exp2();
            let place = |v: [f64; 3]| {
                let v: [f64; 3] = std::array::from_fn(|i| {
                    let sign = if mirrors[i] { -1.0 } else { 1.0 };
                    sign * v[order[i]]
                });
                F::Vector::constant((), v)
            };
            let along_axes = |a: f64, b: f64, c: f64| -> [f64; 3] {
                std::array::from_fn(|i| a * AXES[0][i] + b * AXES[1][i] + c * AXES[2][i])
            };
            let fine = f64::from(-fine).exp2();
            let hits = |across: f64, turned: f64| {
                let center = along_axes(f64::from(along) * unit, unit, across * unit);
                let sphere = Sphere::<F>::new(place(center), F::from_f64(3.0 * unit));
                let ray = Ray {
                    origin: place([0.0; 3]),
                    direction: place(along_axes(1.0, turned, 0.0)),
                };
                let all = Span::new(-F::MAX, F::MAX);
                let sphere = sphere.map_err(|error| TestCaseError::fail(error.to_string()))?;
                Ok::<_, TestCaseError>(sphere.intersect(&ray, &all, Quality::Wide).mask)
            };
            prop_assert!(hits(0.0, 0.0)?, "the touch is missed");
            prop_assert!(!hits(fine, 0.0)?, "a miss by {fine:e}² is a hit");
            // Turned at a place before or beyond the sphere's, the ray may leave it on either side.
            if along == 0 {
                prop_assert!(hits(0.0, fine)?, "a hit by {fine:e}² is a miss");
            }
            Ok(())
        },
    );
}

/// From a point on a surface, the hit at 0 is before the smallest number above 0, and beyond the largest
/// below it, however large the scene is.
pub fn the_widest_kernel_tells_the_smallest_ends_from_0<F: Sample>() {
    let sizes = (-40..60i32, -20..20i32, [any::<bool>(); 2], 0..3usize);
    for_all(sizes, |(size, speed, [outward, negative], axis)| {
        let sign = |is_negative: bool| if is_negative { -1.0 } else { 1.0 };
        let along = |length: f64| {
            let mut v = [0.0; 3];
            v[axis] = sign(negative) * length;
            F::Vector::constant((), v)
        };
        let fail = |invalid: Invalid| TestCaseError::fail(invalid.to_string());
        let unit = f64::from(size).exp2();
        let sphere = Sphere::<F>::new(along(3.0 * unit), F::from_f64(unit)).map_err(fail)?;
        let plane = Plane::<F>::new(along(4.0 * unit), along(1.0)).map_err(fail)?;
        let ray = Ray {
            origin: along(4.0 * unit),
            direction: along(-sign(outward) * f64::from(speed).exp2()),
        };
        let tiny = F::from_f64(F::MIN_POSITIVE * F::EPSILON);
        let zero = F::from_f64(0.0);
        for (min, max, has_zero) in [
            (zero, F::MAX, true),
            (tiny, F::MAX, false),
            (-tiny, tiny, true),
            (-F::MAX, -tiny, false),
        ] {
            let hit = plane.intersect(&ray, &Span::new(min, max), Quality::Wide);
            prop_assert_eq!(hit.mask, has_zero, "plane, {:?} to {:?}", min, max);
            let hit = sphere.intersect(&ray, &Span::new(min, max), Quality::Wide);
            let at_zero = hit.mask && hit.t == zero;
            prop_assert_eq!(at_zero, has_zero, "sphere, {:?} to {:?}", min, max);
        }
        Ok(())
    });
}

/// The largest of the sizes, times so many unit roundoffs.
fn most(u: f64, factor: f64, sizes: [RBig; 3]) -> RBig {
    exact(u * factor) * sizes.into_iter().map(abs).max().unwrap_or(RBig::ZERO)
}

/// The surface passes through the box around the projected point, and the box is no larger than a few
/// roundings of what the point is made of.
pub fn projected_points_are_as_near_as_they_say<F: Sample>() {
    let u = unit_roundoff::<F>();
    let plane = (vector::<F>(-4..8), vector::<F>(-3..3));
    let plane = plane.prop_filter_map("a plane", |(q, n)| Plane::new(q, n).ok());
    let sphere = (vector::<F>(-4..8), positive::<F>(-3..4));
    let sphere = sphere.prop_filter_map("a sphere", |(c, r)| Sphere::new(c, r).ok());
    let near = vector::<F>(-4..4);
    for_all((plane, sphere, near), |(plane, sphere, near)| {
        let parts = |projection: Projection<F>| {
            let [point, error] = [projection.point, projection.error];
            (exact_vector::<F>(point), exact_vector::<F>(error))
        };
        let (q, n) = (plane.point(), plane.normal());
        let (point, error) = parts(plane.project(q + near));
        let (q, n, p) = (
            exact_vector::<F>(q),
            exact_vector::<F>(n),
            exact_vector::<F>(q + near),
        );
        let height = abs(dot(&minus(&point, &q), &n));
        let reach = dot(&error, &n.clone().map(abs));
        prop_assert!(height <= reach, "the plane does not meet the box");
        // 8 roundings of a sum of three terms, each at most the largest difference, and 1 of the
        // result; the rest is room for their products.
        let allowed = most(u, 30.0, minus(&p, &q)) + most(u, 2.0, point);
        prop_assert!(
            error.iter().all(|e| *e <= allowed),
            "a plane's box is large"
        );

        let (c, r) = (sphere.center(), sphere.radius());
        let direction = near.normalized();
        prop_assume!(direction.to_array()[0].is_finite());
        let (point, error) = parts(sphere.project(c + direction * r));
        let (c, r) = (exact_vector::<F>(c), exact(r));
        let way = minus(&point, &c).map(abs);
        let square = |v: &[RBig; 3]| dot(v, v);
        let nearest = std::array::from_fn(|i| (&way[i] - &error[i]).max(RBig::ZERO));
        let farthest = std::array::from_fn(|i| &way[i] + &error[i]);
        let inside = square(&nearest) <= &r * &r && &r * &r <= square(&farthest);
        prop_assert!(inside, "the sphere does not meet the box");
        // 5 roundings of the way from the center, and 1 of the result.
        let allowed = exact(8.0 * u) * r + most(u, 2.0, point);
        prop_assert!(
            error.iter().all(|e| *e <= allowed),
            "a sphere's box is large"
        );
        Ok(())
    });
}

/// A hit of a ray that comes from outside, and its scene.
fn hit<F: Sample>(
    plane: Plane<F>,
    sphere: Sphere<F>,
    ray: &Ray<F>,
) -> Result<(Scene<F>, HitRecord<F>), Invalid> {
    let black = F::Vector::constant((), [0.0; 3]);
    let scene = Scene::new(black, F::MAX)?
        .with_sphere(sphere, black)?
        .with_plane(plane, black)?;
    let span = Span::new(F::from_f64(1e-3), F::MAX);
    let hit = scene.intersect(ray, &span, Quality::Stable);
    Ok((scene, hit))
}

/// Where each strategy says that a shadow ray starts, it starts; what it skips or leaves out, it does.
pub fn shadow_rays_start_where_their_strategy_says<F: Sample>() {
    let plane = (vector::<F>(-2..3), vector::<F>(-1..1));
    let plane = plane.prop_filter_map("a plane", |(q, n)| Plane::new(q, n).ok());
    let sphere = (vector::<F>(-2..3), positive::<F>(-1..2));
    let sphere = sphere.prop_filter_map("a sphere", |(c, r)| Sphere::new(c, r).ok());
    let rays = (vector::<F>(-2..4), vector::<F>(-2..3), vector::<F>(-1..2));
    for_all(
        (plane, sphere, rays),
        |(plane, sphere, (from, to, light))| {
            let direction = (to - from).normalized();
            let to_light = light.normalized();
            let is_direction = |v: F::Vector| v.to_array()[0].is_finite();
            prop_assume!(is_direction(direction) && is_direction(to_light));
            let ray = Ray {
                origin: from,
                direction,
            };
            let built = hit(plane, sphere, &ray);
            let (scene, hit) = built.map_err(|error| TestCaseError::fail(error.to_string()))?;
            prop_assume!(hit.mask);
            let distance = F::from_f64(8.0);
            let cast = |shadow: Shadow| shadow.ray(&scene, &hit, to_light, distance);
            for shadow in Shadow::ALL {
                let cast = cast(shadow);
                prop_assert_eq!(cast.ray.direction, to_light);
                prop_assert_eq!(
                    cast.skip,
                    (shadow == Shadow::SkipSelf).then_some(hit.object)
                );
                prop_assert!(
                    cast.span.contains(distance)
                        && !cast.span.contains(distance.step(F::from_f64(1.0)))
                );
            }
            let starts = |shadow: Shadow| cast(shadow).span.min;
            let smallest = F::MIN_POSITIVE * F::EPSILON;
            prop_assert_eq!(starts(Shadow::SelfHitting).to_f64(), 0.0);
            prop_assert_eq!(starts(Shadow::HalfOpen).to_f64(), smallest);
            prop_assert_eq!(starts(Shadow::Reprojection).to_f64(), smallest);
            prop_assert_eq!(starts(Shadow::TMin(0.25)).to_f64(), 0.25);
            let offset = cast(Shadow::ConstantOffset(0.25)).ray.origin;
            prop_assert_eq!(offset, hit.point + hit.normal * F::from_f64(0.25));

            // Clear of the surface, on the side that the ray came from.
            let side = |point: F::Vector| match hit.object.to_f64() as usize {
                0 => sphere.side(point),
                _ => plane.side(point),
            };
            let came = side(from);
            prop_assume!(came != Ordering::Equal);
            let origin = cast(Shadow::ErrorBound).ray.origin;
            // A coordinate of 0 is not moved: the next number is too small to count.
            let has_zero = origin.to_array().into_iter().any(|x| x.to_f64() == 0.0);
            let is_clear = side(origin) == came || (has_zero && side(origin) == Ordering::Equal);
            prop_assert!(is_clear, "{origin:?}, {:?} of the surface", side(origin));
            let on_surface = cast(Shadow::Reprojection).ray.origin.to_array();
            for (axis, n) in hit.normal.to_array().into_iter().enumerate() {
                let stays = origin.to_array()[axis] == on_surface[axis];
                prop_assert!(n.to_f64() != 0.0 || stays, "moved across the normal");
            }
            // Near all the same: 1000 units in the last place of a scene of this size are far more than
            // the few roundings of a hit point that is not grazed.
            let origin = exact_vector::<F>(origin);
            let apart = minus(&origin, &exact_vector::<F>(hit.point));
            let size = sum(exact_vector::<F>(hit.point).map(abs)) + exact(64.0);
            let small = dot(&apart, &apart) <= exact(1e6 * F::EPSILON * F::EPSILON) * &size * &size;
            prop_assert!(small, "an origin is moved far");
            Ok(())
        },
    );
}

/// A ray that starts on a surface sees it from the side that its direction tells: a sphere from
/// inside if it enters there, a plane from behind if it leaves along the normal.
pub fn origins_on_the_surface_are_seen_by_direction<F: Sample>() {
    let sizes = (
        [-40..40i8, -40..40, -40..40],
        1..9i8,
        0..3usize,
        any::<bool>(),
    );
    for_all(sizes, |(center, radius, axis, negative)| {
        let axis_of = |length: f64| {
            let mut v = [0.0; 3];
            v[axis] = if negative { -length } else { length };
            F::Vector::constant((), v)
        };
        let fail = |invalid: Invalid| TestCaseError::fail(invalid.to_string());
        let center = F::Vector::constant((), center.map(f64::from));
        let radius = f64::from(radius);
        let sphere = Sphere::<F>::new(center, F::from_f64(radius)).map_err(fail)?;
        let radius_of = F::from_f64(radius);
        let kernels = Kernels::default();
        let inside = kernels.offset::<F>(&Offset {
            ray: Ray {
                origin: center - axis_of(radius),
                direction: axis_of(1.0),
            },
            surface: Surface::Sphere {
                center,
                radius: radius_of,
            },
            point: center + axis_of(radius),
            normal: axis_of(-1.0),
        });
        prop_assert_eq!(sphere.side(inside), Ordering::Less);
        let plane = Plane::<F>::new(center, axis_of(2.0)).map_err(fail)?;
        for (along, side) in [(1.0, Ordering::Less), (-1.0, Ordering::Greater)] {
            let moved = kernels.offset::<F>(&Offset {
                ray: Ray {
                    origin: center,
                    direction: axis_of(along),
                },
                surface: Surface::Plane {
                    point: center,
                    normal: axis_of(2.0),
                },
                point: center,
                normal: axis_of(-along),
            });
            prop_assert_eq!(plane.side(moved), side);
        }
        Ok(())
    });
}

/// From where its way to a point of the sphere touches the sphere there, a light on the sphere shines;
/// from nearer it does, and from behind it does not. Turned, mirrored and scaled: 15 is the radius, 25
/// the distance of the lit point, 20 the length of the tangent.
pub fn a_light_on_a_sphere_shines_up_to_the_tangent<F: Sample>() {
    let turned = (
        select(vec![[0, 1, 2], [1, 2, 0], [2, 0, 1]]),
        [any::<bool>(); 3],
    );
    for_all((turned, -8..9i32), |((order, mirrors), size)| {
        let unit = f64::from(size).exp2();
        let place = |v: [f64; 3]| {
            let v: [f64; 3] = std::array::from_fn(|i| {
                let sign = if mirrors[i] { -unit } else { unit };
                sign * v[order[i]]
            });
            F::Vector::constant((), v)
        };
        let one = F::Vector::constant((), [1.0; 3]);
        let lit = |light: [f64; 3], kernels: Kernels, tmin: f64| {
            let question = Shade::<F> {
                ray: Ray {
                    origin: place([24.0, 0.0, 1.0]),
                    direction: place([1.0, 0.0, -1.0]),
                },
                ends: [F::from_f64(tmin), F::MAX],
                objects: vec![
                    (
                        Surface::Sphere {
                            center: place([0.0; 3]),
                            radius: F::from_f64(15.0 * unit),
                        },
                        one,
                    ),
                    (
                        Surface::Plane {
                            point: place([25.0, 0.0, 0.0]),
                            normal: place([1.0, 0.0, 0.0]),
                        },
                        one,
                    ),
                ],
                light: place(light),
                light_color: one,
                power: F::from_f64(unit * unit),
                background: F::from_f64(0.0),
            };
            let shaded = kernels.shade(&question);
            shaded.map(|shaded| shaded.li.to_array()[0].to_f64() > 0.0)
        };
        let own = |light| lit(light, Kernels::default(), 0.0);
        for tangent in [[9.0, 12.0, 0.0], [9.0, -12.0, 0.0], [9.0, 0.0, 12.0]] {
            prop_assert_eq!(own(tangent), Ok(true), "a tangent, {:?}", tangent);
        }
        for nearer in [[15.0, 0.0, 0.0], [12.0, 9.0, 0.0], [12.0, 0.0, -9.0]] {
            prop_assert_eq!(own(nearer), Ok(true), "from nearer, {:?}", nearer);
        }
        for behind in [[0.0, 15.0, 0.0], [-15.0, 0.0, 0.0], [5.0, 10.0, -10.0]] {
            prop_assert_eq!(own(behind), Ok(false), "from behind, {:?}", behind);
        }
        // The lab's rays know no other start than 0.
        let lab = Kernels {
            shadow: Some(Shadow::SkipSelf),
            ..Kernels::default()
        };
        prop_assert_eq!(lit([20.0, 3.0, 0.0], lab, 0.0), Ok(true));
        prop_assert!(lit([20.0, 3.0, 0.0], lab, 0.25).is_err());
        Ok(())
    });
}
