//! The ray-relative chain: the kit's default way from a scene to radiance.
//!
//! Everything is taken relative to the camera once, before the first ray ([`Relative::new`], in
//! double-double). Then the camera is the origin, directions need no normalisation, and no kernel
//! ever forms a point in world space. What it rests on:
//!
//! - A sphere is hit where the discriminant `r² D² - |c x D|²` is not negative (Lagrange's identity;
//!   no difference of squares of distances).
//! - Whether a surface shadows itself is a sign, not a distance, so no epsilon is needed. The way
//!   from the camera to the point it sees crosses no surface; so camera and point are on the same
//!   side of every surface, and a surface that separates the light from the camera keeps it from
//!   every point the camera sees. Such lights are left out once a frame. Of what remains, planes and
//!   spheres around the camera block nothing, and only spheres beside the way to the light need a
//!   look.
//! - The sphere a shadow ray leaves is skipped by its number; of spheres that coincide there is one.

mod follow;
mod light;
mod round;
mod setup;
mod sphere;

use crate::chain::{Chain, ChainKind};
use crate::real::{Constant, Mask, Real, Scalar};
use crate::vector::Vector;
use light::Light;
use sphere::Sphere;

/// A scene as its camera sees it, ready for rays.
#[derive(Clone, Debug)]
pub struct Relative<S: Constant> {
    forward: S::Vector,
    right: S::Vector,
    up: S::Vector,
    spheres: Vec<Sphere<S>>,
    planes: Vec<Plane<S>>,
    /// The number of the scene's first plane.
    first_plane: usize,
    /// `None`: the light is at the eye.
    lights: Option<Vec<Light<S>>>,
    background: S::Vector,
    t_max_squared: S,
    /// Whether every distance counts, whatever the numbers above say.
    endless: bool,
}

/// Where the light comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lighting {
    /// From the eye, without falloff: Figure 1.
    Eye,
    /// From the scene's lights; nothing casts a shadow: Figure 2.
    Unshadowed,
    /// From the scene's lights, where nothing stands between: Figure 3(c).
    Shadowed,
}

/// A plane with the camera on its positive side: `dot(normal, x) = height`, and `height < 0`.
#[derive(Clone, Copy, Debug)]
struct Plane<S: Constant> {
    normal: S::Vector,
    height: S,
    /// (`t_max` / height)²: a hit at `height / slope` counts where `slope²` times this reaches D².
    reach: S,
    number: S,
    color: S::Vector,
}

/// Where a ray from the camera meets a surface.
#[derive(Clone, Copy)]
struct Meeting<R: Real> {
    mask: R::Mask,
    t: R,
    /// `-dot(normal, direction)`, above 0.
    slope: R,
    number: R,
}

/// The nearest meeting so far, and the first and the last surface that any lane met; there is none
/// where first is after last.
struct Search<R: Real> {
    nearest: Meeting<R>,
    first: usize,
    last: usize,
}

/// What a ray from the camera meets first.
#[derive(Clone, Copy)]
struct Nearest<R: Real> {
    meeting: Meeting<R>,
    /// The unit normal on the camera's side.
    normal: R::Vector,
    color: R::Vector,
}

impl<R: Real> Meeting<R> {
    /// The nearer of this and another.
    #[inline(always)]
    fn or_nearer(self, other: Self) -> Self {
        let nearer = other.mask & (!self.mask | other.t.lt(self.t));
        Self {
            mask: self.mask | nearer,
            t: R::select(nearer, other.t, self.t),
            slope: R::select(nearer, other.slope, self.slope),
            number: R::select(nearer, other.number, self.number),
        }
    }

    /// The lanes that meet the object of this number.
    #[inline(always)]
    fn is_with(&self, number: R::Scalar) -> R::Mask {
        self.number.is(R::splat(self.number.token(), number))
    }
}

impl<R: Real> Search<R> {
    /// Before any surface was asked; `any` may be any number.
    #[inline(always)]
    fn new(any: R) -> Self {
        Self {
            nearest: Meeting {
                mask: R::never(any.token()),
                t: any,
                slope: any,
                number: any,
            },
            first: usize::MAX,
            last: 0,
        }
    }

    /// Whether no surface was met.
    #[inline(always)]
    fn is_empty(&self) -> bool {
        self.first > self.last
    }

    /// Adds what the surface of the next index answered.
    #[inline(always)]
    fn add(&mut self, index: usize, meeting: Option<Meeting<R>>) {
        let Some(meeting) = meeting else { return };
        self.nearest = if self.is_empty() {
            meeting
        } else {
            self.nearest.or_nearer(meeting)
        };
        (self.first, self.last) = (self.first.min(index), index);
    }
}

impl<S: Constant> Plane<S> {
    /// Where a ray from the camera meets the plane; `None` if no lane does.
    #[inline(always)]
    fn meet<R: Real<Scalar = S>>(
        &self,
        direction: R::Vector,
        square: R,
        endless: bool,
    ) -> Option<Meeting<R>> {
        let token = square.token();
        let slope = -R::Vector::splat(token, &self.normal).dot(direction);
        let mut mask = slope.gt(slope.constant(0.0));
        if !endless {
            mask = mask & (slope * slope * R::splat(token, self.reach)).ge(square);
        }
        if !mask.any() {
            return None;
        }
        Some(Meeting {
            mask,
            t: -R::splat(token, self.height) / slope,
            slope,
            number: R::splat(token, self.number),
        })
    }
}

impl<S: Constant> Relative<S> {
    /// What the camera sees along a direction; `None` where no lane meets anything.
    #[inline(always)]
    fn nearest<R: Real<Scalar = S>>(&self, direction: R::Vector, square: R) -> Option<Nearest<R>> {
        let token = square.token();
        let t_max_squared = R::splat(token, self.t_max_squared);
        let mut search = Search::new(square);
        for (index, sphere) in (0..).zip(&self.spheres) {
            let meeting = sphere.meet(direction, square, t_max_squared, self.endless);
            search.add(index, meeting);
        }
        for (index, plane) in (self.spheres.len()..).zip(&self.planes) {
            search.add(index, plane.meet(direction, square, self.endless));
        }
        if search.is_empty() {
            return None;
        }
        let Search {
            nearest,
            first,
            last,
        } = search;
        let (mut normal, mut color) = self.surface::<R>(first, direction, nearest.t);
        for index in first + 1..=last {
            let here = nearest.is_with(self.number(index));
            if here.any() {
                let (its_normal, its_color) = self.surface::<R>(index, direction, nearest.t);
                normal = R::Vector::select(here, its_normal, normal);
                color = R::Vector::select(here, its_color, color);
            }
        }
        Some(Nearest {
            meeting: nearest,
            normal,
            color,
        })
    }

    /// The number of a surface; spheres come before planes.
    #[inline(always)]
    fn number(&self, index: usize) -> S {
        match self.spheres.get(index) {
            Some(sphere) => sphere.number,
            None => self.planes[index - self.spheres.len()].number,
        }
    }

    /// The unit normal on the camera's side, and the colour, of a surface that is met at `t`.
    #[inline(always)]
    fn surface<R: Real<Scalar = S>>(
        &self,
        index: usize,
        direction: R::Vector,
        t: R,
    ) -> (R::Vector, R::Vector) {
        let token = t.token();
        match self.spheres.get(index) {
            Some(sphere) => (
                sphere.normal(direction, t),
                R::Vector::splat(token, &sphere.color),
            ),
            None => {
                let plane = &self.planes[index - self.spheres.len()];
                (
                    R::Vector::splat(token, &plane.normal),
                    R::Vector::splat(token, &plane.color),
                )
            }
        }
    }
}

impl<S: Constant> Relative<S> {
    /// See [`Chain::across`].
    #[inline(always)]
    pub(crate) fn across<R: Real<Scalar = S>>(&self, column: R) -> R::Vector {
        R::Vector::splat(column.token(), &self.right) * column
    }

    /// See [`Chain::down`].
    #[inline(always)]
    pub(crate) fn down<R: Real<Scalar = S>>(&self, row: R) -> R::Vector {
        let token = row.token();
        R::Vector::splat(token, &self.forward) - R::Vector::splat(token, &self.up) * row
    }

    /// See [`Chain::reflected`].
    #[inline(always)]
    pub(crate) fn reflected<R: Real<Scalar = S>>(
        &self,
        direction: R::Vector,
    ) -> Option<(R::Mask, R::Vector)> {
        let square = direction.square();
        let hit = self.nearest(direction, square)?;
        let reflected = match &self.lights {
            None => hit.color * (hit.meeting.slope * square.inverse_root()),
            Some(lights) => {
                let zero = square.constant(0.0);
                let mut sum = R::Vector::new(zero, zero, zero);
                for light in lights {
                    sum = light.add(sum, &hit, direction);
                }
                sum
            }
        };
        Some((hit.meeting.mask, reflected))
    }
}

impl<S: Scalar> Chain<S> for Relative<S> {
    fn kind(&self) -> ChainKind<'_, S> {
        ChainKind::Relative(self)
    }

    /// From -1 at the first column or row to 1 at the last.
    fn coordinate(index: u32, count: u32) -> S {
        coordinate(index, count)
    }

    #[inline(always)]
    fn across<R: Real<Scalar = S>>(&self, column: R) -> R::Vector {
        self.across(column)
    }

    #[inline(always)]
    fn down<R: Real<Scalar = S>>(&self, row: R) -> R::Vector {
        self.down(row)
    }

    #[inline(always)]
    fn reflected<R: Real<Scalar = S>>(&self, direction: R::Vector) -> Option<(R::Mask, R::Vector)> {
        self.reflected::<R>(direction)
    }

    fn background(&self) -> S::Vector {
        self.background
    }
}

/// Where a column or row of pixels is: from -1 for the first to 1 for the last.
pub(crate) fn coordinate<S: Constant>(index: u32, count: u32) -> S {
    let twice_from_middle = 2.0 * f64::from(index) - f64::from(count - 1);
    if twice_from_middle == 0.0 {
        return S::from_f64(0.0);
    }
    S::from_f64(twice_from_middle) / S::from_f64(f64::from(count - 1))
}
