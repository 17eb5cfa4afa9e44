//! Shapes: what rays hit. One file a shape.

mod plane;
mod sphere;

pub use plane::Plane;
pub use sphere::Sphere;

use crate::quality::Quality;
use crate::ray::{Ray, Span};
use crate::real::{Real, Scalar};

/// Where a ray meets a shape.
#[derive(Clone, Copy, Debug)]
pub struct Hit<R: Real> {
    /// Whether there is a hit at all.
    pub mask: R::Mask,
    /// The ray's parameter there; means nothing where the mask is false.
    pub t: R,
}

/// What every shape can be asked.
///
/// The shape is made of scalars; the ray may have one lane or many.
pub trait Shape<S: Scalar> {
    /// The nearest hit in the interval.
    fn intersect<R: Real<Scalar = S>>(
        &self,
        ray: &Ray<R>,
        span: &Span<R>,
        quality: Quality,
    ) -> Hit<R>;

    /// Whether there is any hit in the interval, without saying where (clause 5.1). For one shape this
    /// costs what [`intersect`](Self::intersect) costs; what it saves, it saves on a scene.
    fn intersect_any<R: Real<Scalar = S>>(
        &self,
        ray: &Ray<R>,
        span: &Span<R>,
        quality: Quality,
    ) -> R::Mask {
        self.intersect(ray, span, quality).mask
    }

    /// The unit normal at a point of the shape, on the side a plane's normal shows to or outside of a sphere.
    fn normal_at<R: Real<Scalar = S>>(&self, point: R::Vector) -> R::Vector;
}

impl<R: Real> Hit<R> {
    /// A hit found one precision up.
    #[inline(always)]
    fn narrow(wide: Hit<R::Wide>) -> Self {
        Self {
            mask: R::narrow_mask(wide.mask),
            t: R::narrow(wide.t),
        }
    }
}
