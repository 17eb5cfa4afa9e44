//! The perspective camera.

use crate::error::Invalid;
use crate::quality::unit;
use crate::ray::Ray;
use crate::real::{Constant, Real, Scalar};
use crate::vector::Vector;

/// How a camera stands: everything about it that a person chooses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View<S: Scalar> {
    /// Where the camera is.
    pub position: S::Vector,
    /// A point at the middle of the picture.
    pub look_at: S::Vector,
    /// A direction that is up in the picture; any that is not parallel to the view.
    pub up: S::Vector,
    /// The vertical field of view in degrees, between 0 and 180.
    pub fov: S,
}

/// A pinhole camera with its viewport at distance 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerspectiveCamera<S: Scalar> {
    position: S::Vector,
    /// From the camera to the viewport's top left corner.
    top_left: S::Vector,
    /// The viewport's upper edge, left to right.
    width: S::Vector,
    /// The viewport's left edge, bottom to top.
    height: S::Vector,
}

impl<S: Scalar> PerspectiveCamera<S> {
    /// The camera of a view, for pictures of the given aspect (width / height).
    ///
    /// With the lab's view (from (0, 0, -2) along +z) the right of the picture is -x of the world.
    ///
    /// # Errors
    /// If a vector is not finite, the view has no direction, `up` is parallel to it, the field of
    /// view is not between 0 and 180 degrees, or the aspect is not finite and greater than 0.
    pub fn new(view: &View<S>, aspect: S) -> Result<Self, Invalid> {
        let Axes { forward, right, up } = view.axes(aspect)?;
        let two = S::from_f64(2.0);
        let top_left = up - right + forward;
        Ok(Self {
            position: view.position,
            top_left,
            width: right * two,
            height: up * two,
        })
    }

    /// The ray through the point of the viewport at `sx` from its left edge and `sy` from its upper
    /// one, both from 0 to 1. Its direction is a unit vector.
    #[inline(always)]
    pub fn ray<R: Real<Scalar = S>>(&self, sx: R, sy: R) -> Ray<R> {
        self.ray_along(self.across(sx) - self.down(sy))
    }

    /// From the camera to the point at `sx` of the viewport's upper edge: a column's share of a
    /// ray.
    #[inline(always)]
    pub(crate) fn across<R: Real<Scalar = S>>(&self, sx: R) -> R::Vector {
        let token = sx.token();
        R::Vector::splat(token, &self.top_left) + R::Vector::splat(token, &self.width) * sx
    }

    /// From the point at `sy` of the viewport's left edge to its upper end: what a row takes from a
    /// ray.
    #[inline(always)]
    pub(crate) fn down<R: Real<Scalar = S>>(&self, sy: R) -> R::Vector {
        R::Vector::splat(sy.token(), &self.height) * sy
    }

    /// The ray in a direction of any length.
    #[inline(always)]
    pub(crate) fn ray_along<R: Real<Scalar = S>>(&self, direction: R::Vector) -> Ray<R> {
        Ray {
            origin: R::Vector::splat(direction.x().token(), &self.position),
            direction: direction.normalized(),
        }
    }
}

/// Three directions at right angles: from the camera to the middle of the viewport at distance 1,
/// and from there to the middle of its right and its upper edge.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axes<S: Constant> {
    pub forward: S::Vector,
    pub right: S::Vector,
    pub up: S::Vector,
}

impl<S: Scalar> View<S> {
    /// The viewport's axes, for pictures of the given aspect.
    pub(crate) fn axes(&self, aspect: S) -> Result<Axes<S>, Invalid> {
        let position = Invalid::unless_finite::<S>("camera position", self.position)?;
        let look_at = Invalid::unless_finite::<S>("camera look_at", self.look_at)?;
        let up = Invalid::unless_finite::<S>("camera up", self.up)?;
        let open = self.fov.to_f64() > 0.0 && self.fov.to_f64() < 180.0;
        let fov = Invalid::unless(open, "camera fov", self.fov, "between 0 and 180 degrees")?;
        let valid = aspect.is_finite() && aspect.to_f64() > 0.0;
        let aspect = Invalid::unless(valid, "aspect", aspect, "finite and greater than 0")?;

        let backward = unit::<S>(position - look_at);
        let must_be = "another point than the camera's position";
        Invalid::unless_vector::<S>(backward.is_unit(), "camera look_at", look_at, must_be)?;
        let right = unit::<S>(unit::<S>(up).cross(backward));
        let must_be = "a direction that is not parallel to the view";
        Invalid::unless_vector::<S>(right.is_unit(), "camera up", up, must_be)?;

        Ok(Axes::new(backward, right, S::tan_half(fov), aspect))
    }
}

impl<S: Constant> Axes<S> {
    /// From unit vectors, the tangent of half the field of view, and the aspect.
    pub fn new(backward: S::Vector, right: S::Vector, tangent: S, aspect: S) -> Self {
        Self {
            forward: -backward,
            right: right * (tangent * aspect),
            up: backward.cross(right) * tangent,
        }
    }
}

impl View<f64> {
    /// The same view in another format, every number rounded to it.
    pub fn cast<S: Scalar>(&self) -> View<S> {
        let vector = |v: glam::DVec3| S::Vector::constant((), v.to_array());
        View {
            position: vector(self.position),
            look_at: vector(self.look_at),
            up: vector(self.up),
            fov: S::from_f64(self.fov),
        }
    }
}
