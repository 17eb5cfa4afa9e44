//! Whether anything lies on a ray, and what lies nearest.

use crate::object::Object;
use crate::ray::{Interval, PerInterval, Ray};
use crate::surd::Surd;
use std::cmp::Ordering;

/// What is true of a ray and a scene.
#[derive(Clone, Debug)]
pub struct AnyHitTruth {
    /// Which objects have a root in the interval.
    pub blockers: PerInterval<Vec<usize>>,
    /// The nearest hit in `(tmin, tmax]`, if any.
    pub nearest_half: Option<Nearest>,
}

/// The nearest hit.
#[derive(Clone, Debug)]
pub struct Nearest {
    /// The objects hit at exactly this t, in order.
    pub ids: Vec<usize>,
    /// Its parameter along the ray.
    pub t: Surd,
}

/// Which of `objects` a ray meets. `None` stands for an object that policy calls missed by every ray.
pub fn any_hit<'a>(
    ray: &Ray,
    objects: impl IntoIterator<Item = Option<&'a Object>>,
) -> AnyHitTruth {
    let roots: Vec<Vec<Surd>> = objects
        .into_iter()
        .map(|o| o.map_or(Vec::new(), |o| o.roots(ray)))
        .collect();
    let meets = |id: &usize, interval| roots[*id].iter().any(|t| ray.admits(t, interval));
    AnyHitTruth {
        blockers: PerInterval::of(|interval| {
            (0..roots.len()).filter(|id| meets(id, interval)).collect()
        }),
        nearest_half: nearest(ray, &roots),
    }
}

/// The nearest of the roots of each object in `(tmin, tmax]`.
fn nearest(ray: &Ray, roots: &[Vec<Surd>]) -> Option<Nearest> {
    let mut nearest: Option<Nearest> = None;
    for (id, roots) in roots.iter().enumerate() {
        let Some(t) = roots.iter().find(|t| ray.admits(t, Interval::Half)) else {
            continue;
        };
        match nearest.as_mut().map(|best| (t.compare(&best.t), best)) {
            Some((Ordering::Greater, _)) => {}
            Some((Ordering::Equal, best)) => best.ids.push(id),
            Some((Ordering::Less, _)) | None => {
                nearest = Some(Nearest {
                    ids: vec![id],
                    t: t.clone(),
                });
            }
        }
    }
    nearest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::Plane;
    use crate::sphere::Sphere;

    #[test]
    fn ties_between_irrational_roots() {
        // The spheres are met at 4 - √3, before the plane at 4.
        let ray = Ray::new([0.0, 1.0, -4.0], [0.0, 0.0, 1.0], 0.0, f64::INFINITY).unwrap();
        let sphere = || Sphere::new([0.0; 3], 2.0).map(Object::Sphere);
        let objects = [
            Plane::new([0.0, 0.0, 0.0], [0.0, 0.0, 1.0]).map(Object::Plane),
            sphere(),
            None,
            sphere(),
        ];
        let truth = any_hit(&ray, objects.iter().map(Option::as_ref));
        assert_eq!(truth.nearest_half.unwrap().ids, [1, 3]);
        assert_eq!(truth.blockers.closed, [0, 1, 3]);
    }
}
