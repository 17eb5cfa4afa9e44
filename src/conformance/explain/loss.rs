//! Where digits are lost, and why: how much larger than a result are the terms it is made of.

use super::trace::{Drawing, First, Trace};
use crate::camera::Axes;
use crate::film::Film;
use crate::light::LightSample;
use crate::quality::Quality;
use crate::ray::Ray;
use crate::real::{DoubleDouble, Real, Scalar};
use crate::scene::Scene;
use crate::shape::{Plane, Sphere};
use crate::vector::{Triple, Vector};
use std::fmt;

type D = DoubleDouble;
type V = Triple<D>;

/// Why a result has fewer right digits than what it is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Loss {
    /// Terms that cancel, so many times as large as what is left.
    Cancellation(f64),
    /// A direction runs almost along the surface: the sine of the angle is one over this.
    Grazing(f64),
    /// The ray almost touches the sphere: r² is so many times what is left of it, r² - m², with m
    /// the distance of the line from the center.
    Tangency(f64),
    /// So many whole turns of 256 are dropped.
    Wrap(u64),
}

impl Loss {
    /// How many bits it costs: the logarithm of the factor. All of them where the byte wraps.
    pub fn bits(self) -> f64 {
        match self {
            Loss::Cancellation(factor) | Loss::Grazing(factor) | Loss::Tangency(factor) => {
                factor.log2()
            }
            Loss::Wrap(_) => f64::INFINITY,
        }
    }

    /// A loss of less than three bits is none.
    pub(super) fn if_large(self) -> Option<Self> {
        (self.bits() >= 3.0).then_some(self)
    }
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (what, factor) = match self {
            Loss::Cancellation(factor) => ("cancellation: terms over result", factor),
            Loss::Grazing(factor) => (
                "grazing: 1 over the sine of the angle to the surface",
                factor,
            ),
            Loss::Tangency(factor) => ("tangency: r² over r² - m², m the line's distance", factor),
            Loss::Wrap(turns) => return write!(f, "wrap: {turns} x 256 is dropped"),
        };
        match factor {
            _ if factor.is_infinite() => write!(f, "{what} is infinite, no digit is left"),
            _ if *factor < 1e6 => {
                write!(f, "{what} is {factor:.0}, {:.0} bits are lost", self.bits())
            }
            _ => write!(
                f,
                "{what} is {factor:.1e}, {:.0} bits are lost",
                self.bits()
            ),
        }
    }
}

fn length(v: V) -> D {
    v.dot(v).sqrt()
}

/// How many times as large as a result its terms are: infinite where nothing is left of them, and
/// once where they are 0, of which nothing is lost.
fn ratio(terms: D, result: D) -> f64 {
    if terms == D::from_f64(0.0) {
        return 1.0;
    }
    let ratio = (terms / result).abs().to_f64();
    if ratio.is_nan() { f64::INFINITY } else { ratio }
}

fn worst(losses: impl IntoIterator<Item = Loss>) -> Option<Loss> {
    let worst = losses
        .into_iter()
        .max_by(|a, b| a.bits().total_cmp(&b.bits()));
    worst.and_then(Loss::if_large)
}

/// Of a sum of two terms.
pub(super) fn of_sum(a: D, b: D) -> Option<Loss> {
    Loss::Cancellation(ratio(a.abs() + b.abs(), a + b)).if_large()
}

/// Of the plane's t = dot(q - o, n) / dot(d, n).
pub(super) fn of_plane(ray: &Ray<D>, plane: &Plane<D>) -> Option<Loss> {
    let normal = plane.normal();
    let offset = plane.point() - ray.origin;
    let along = ray.direction.dot(normal);
    let height = offset.dot(normal);
    let terms = (plane.point().abs() + ray.origin.abs()).dot(normal.abs());
    worst([
        Loss::Grazing(ratio(length(ray.direction) * length(normal), along)),
        Loss::Cancellation(ratio(terms, height)),
    ])
}

/// Of the sphere's t, by the formula of the quality; the ray's direction is a unit vector.
pub(super) fn of_sphere(ray: &Ray<D>, sphere: &Sphere<D>, quality: Quality) -> Option<Loss> {
    let from_center = ray.origin - sphere.center();
    let rr = sphere.radius() * sphere.radius();
    let b = from_center.dot(ray.direction);
    let moment = from_center.cross(ray.direction);
    let rest = rr - moment.dot(moment);
    let tangency = Loss::Tangency(ratio(rr, rest));
    // b² - c, of which the square of the distance to the center is the largest term.
    let cancels = Loss::Cancellation(ratio(b * b, rest));
    // A line as near as this passes the center at 63/64 of the radius or more.
    if tangency.bits() >= 5.0 {
        return Some(tangency);
    }
    match quality {
        Quality::Textbook => cancels.if_large(),
        Quality::Stable | Quality::Wide => None,
    }
}

/// Of a component of the point `o + t d`.
pub(super) fn of_point(ray: &Ray<D>, first: &First<D>) -> [Option<Loss>; 3] {
    let (o, d) = (ray.origin.to_array(), (ray.direction * first.t).to_array());
    [0, 1, 2].map(|i| of_sum(o[i], d[i]))
}

/// Of a component of `p - c`, the sphere's normal.
pub(super) fn of_normal(first: &First<D>, center: V) -> [Option<Loss>; 3] {
    let (p, c) = (first.point.to_array(), (-center).to_array());
    [0, 1, 2].map(|i| of_sum(p[i], c[i]))
}

/// Of a component of the direction to the light.
pub(super) fn of_direction(first: &First<D>, light: V) -> [Option<Loss>; 3] {
    let (l, p) = (light.to_array(), (-first.point).to_array());
    [0, 1, 2].map(|i| of_sum(l[i], p[i]))
}

/// Of dot(n, l).
pub(super) fn of_cosine(normal: V, sample: &LightSample<D>) -> Option<Loss> {
    let cosine = normal.dot(sample.direction);
    Loss::Grazing(ratio(D::from_f64(1.0), cosine)).if_large()
}

/// Of the ray's direction, a sum of the viewport's corner and parts of its edges.
pub(super) fn of_view(axes: &Axes<D>, [sx, sy]: [D; 2]) -> [Option<Loss>; 3] {
    let two = D::from_f64(2.0);
    let [right, up, forward] = [axes.right, axes.up, axes.forward].map(Vector::to_array);
    [0, 1, 2].map(|i| {
        let (across, down) = (two * right[i] * sx, two * up[i] * sy);
        let terms = right[i].abs() + up[i].abs() + forward[i].abs() + across.abs() + down.abs();
        let result = up[i] - right[i] + forward[i] + across - down;
        Loss::Cancellation(ratio(terms, result)).if_large()
    })
}

/// Of a byte.
pub(super) fn of_byte(trace: &Trace<D>, drawing: &Drawing) -> [Option<Loss>; 3] {
    trace.radiance.to_array().map(|x| {
        let turns = (x.to_f64() * 255.0 / 256.0) as u64;
        (drawing.film == Film::Wrap && turns > 0).then_some(Loss::Wrap(turns))
    })
}

/// Of the t of an object, by its number.
pub(super) fn of_object(
    ray: &Ray<D>,
    scene: &Scene<D>,
    number: usize,
    quality: Quality,
) -> Option<Loss> {
    match scene.spheres().get(number) {
        Some(sphere) => of_sphere(ray, &sphere.shape, quality),
        None => of_plane(ray, &scene.planes()[number - scene.spheres().len()].shape),
    }
}
