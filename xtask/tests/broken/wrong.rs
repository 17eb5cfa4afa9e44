//! Kernels that are wrong in one way, by the name of their fault.

use ombrage::conformance::{Answer, Ends, Kernels, Question, Surface};
use ombrage::{Float, Quality, Ray, Real, Scalar, Vector};

/// Kernels that are not.
pub const RIGHT: Kernels = Kernels {
    quality: Quality::Wide,
    shadow: None,
};

/// The wrong answer; `None` for the right one.
pub fn answer<F: Float>(fault: &str, question: &Question<F>) -> Option<Answer<F>> {
    match *question {
        Question::Hit { ray, ends, surface } => Some(Answer::Hit(hit(fault, ray, ends, &surface))),
        Question::AnyHit {
            ray,
            ends,
            ref surfaces,
        } => {
            let mut surfaces = surfaces.iter();
            let occluded = surfaces.any(|surface| hit(fault, ray, ends, surface).is_some());
            Some(Answer::AnyHit(occluded))
        }
        Question::Offset(question) => {
            let [x, y, z] = question.point.to_array().map(|x| x.to_f64().abs());
            let way = match fault {
                "moves-by-a-constant" => 1e-3,
                // Two constants, one for each side of x.
                "moves-by-about-a-constant" if question.normal.x().to_f64() < 0.0 => 1e-3,
                "moves-by-about-a-constant" => 1.004e-3,
                "moves-in-proportion" => 0.01 * (x + y + z),
                "stays" => 0.0,
                _ => return None,
            };
            let way = question.normal * F::from_f64(way);
            Some(Answer::Offset(question.point + way))
        }
        _ => None,
    }
}

fn hit<F: Float>(fault: &str, ray: Ray<F>, ends: Ends<F>, surface: &Surface<F>) -> Option<F> {
    let [tmin, tmax] = ends;
    let right = |ends| RIGHT.hit(&ray, ends, surface);
    let along = match *surface {
        Surface::Plane { normal, .. } => ray.direction.dot(normal).to_f64(),
        Surface::Sphere { .. } => 0.0,
    };
    match (fault, *surface) {
        ("never-hits", _) => None,
        ("ignores-t-max", _) => right([tmin, F::from_f64(f64::INFINITY)]),
        ("ignores-t-min", _) => right([F::from_f64(0.0), tmax]),
        ("t-min-of-its-own", _) => right([F::from_f64(1e-4), tmax]),
        ("half-open", _) => right(ends).filter(|t| *t > tmin),
        ("open", _) => right(ends).filter(|t| *t > tmin && *t < tmax),
        ("culls", _) => right(ends).filter(|_| along <= 0.0),
        ("culls-the-front", _) => right(ends).filter(|_| along >= 0.0),
        ("misses-from-inside", Surface::Sphere { center, radius }) => {
            let from_center = ray.origin - center;
            let outside = from_center.dot(from_center) > radius * radius;
            right(ends).filter(|_| outside)
        }
        ("textbook", Surface::Sphere { center, radius })
            if is_moderate::<F, _>([ray.origin, ray.direction, center], radius) =>
        {
            half_b(&ray, ends, center, radius)
        }
        ("unit", Surface::Sphere { center, radius })
            if is_moderate::<F, _>([ray.origin, center], radius) =>
        {
            unit(&ray, ends, center, radius)
        }
        ("distance", _) => {
            let sizes = ray.direction.abs().to_array();
            let largest = sizes
                .into_iter()
                .fold(sizes[0], |a, b| if a < b { b } else { a });
            let direction = ray.direction * (F::from_f64(1.0) / largest);
            let direction = direction.normalized();
            RIGHT.hit(&Ray { direction, ..ray }, ends, surface)
        }
        ("overflows", _) => Kernels::default().hit(&ray, ends, surface),
        _ => right(ends),
    }
}

/// The textbook's roots with b halved, in the order that comes to mind.
fn half_b<F: Float>(
    ray: &Ray<F>,
    [tmin, tmax]: Ends<F>,
    center: F::Vector,
    radius: F,
) -> Option<F> {
    let a = ray.direction.dot(ray.direction);
    let to_center = center - ray.origin;
    let half_b = to_center.dot(ray.direction);
    let discriminant = half_b * half_b - a * (to_center.dot(to_center) - radius * radius);
    let root = Real::sqrt(discriminant);
    let mut roots = [(half_b - root) / a, (half_b + root) / a].into_iter();
    roots.find(|t| *t >= tmin && *t <= tmax && Scalar::is_finite(*t))
}

/// A stable form for unit directions.
fn unit<F: Float>(ray: &Ray<F>, [tmin, tmax]: Ends<F>, center: F::Vector, radius: F) -> Option<F> {
    let to_center = center - ray.origin;
    let along = to_center.dot(ray.direction);
    let aside = to_center - ray.direction * along;
    let half_chord = Real::sqrt(radius * radius - aside.dot(aside));
    let mut roots = [along - half_chord, along + half_chord].into_iter();
    roots.find(|t| *t >= tmin && *t <= tmax && Scalar::is_finite(*t))
}

/// Whether no square overflows or underflows.
fn is_moderate<F: Float, const N: usize>(vectors: [F::Vector; N], radius: F) -> bool {
    let mut numbers = vectors
        .map(Vector::to_array)
        .into_iter()
        .flatten()
        .chain([radius]);
    numbers.all(|x| x.to_f64() == 0.0 || (1e-6..1e8).contains(&x.to_f64().abs()))
}
