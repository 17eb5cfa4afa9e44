//! From a place in the picture to the light that comes from there.

use crate::camera::PerspectiveCamera;
use crate::integrator::Integrator;
use crate::quality::Quality;
use crate::real::{Real, Scalar};
use crate::relative::Relative;
use crate::scene::Scene;
use crate::vector::Vector;

/// A scene, a camera and an integrator, ready for rays. There are two: the lab's, [`LabChain`], and
/// the kit's own, [`Relative`].
pub trait Chain<S: Scalar>: Sync {
    /// Where a column or row of pixels is, the `index`-th of `count`, as
    /// [`across`](Self::across) and [`down`](Self::down) take it.
    fn coordinate(index: u32, count: u32) -> S;

    /// A column's share of the way from the camera to a point of the viewport.
    fn across<R: Real<Scalar = S>>(&self, column: R) -> R::Vector;

    /// A row's share of it: their sum is the direction of the pixel's ray, of any length.
    fn down<R: Real<Scalar = S>>(&self, row: R) -> R::Vector;

    /// What the objects send back along a direction, a linear colour, and in which lanes there is
    /// an object; `None` where there is none in any.
    fn reflected<R: Real<Scalar = S>>(&self, direction: R::Vector) -> Option<(R::Mask, R::Vector)>;

    /// The linear colour seen where there is no object.
    fn background(&self) -> S::Vector;

    /// The radiance, a linear colour, at a point of the picture given by the coordinates of its
    /// column and its row.
    #[inline(always)]
    fn radiance<R: Real<Scalar = S>>(&self, column: R, row: R) -> R::Vector {
        let background = R::Vector::splat(column.token(), &self.background());
        match self.reflected::<R>(self.across(column) + self.down(row)) {
            None => background,
            Some((mask, reflected)) => R::Vector::select(mask, reflected, background),
        }
    }

    /// Which of the two it is.
    fn kind(&self) -> ChainKind<'_, S>;

    /// Whether several pixels at a time are faster than one by one.
    fn gains_from_packets(&self) -> bool {
        true
    }
}

/// One of the two chains. Pictures are drawn by a loop that is compiled once for each.
#[derive(Clone, Copy, Debug)]
pub enum ChainKind<'a, S: Scalar> {
    /// The lab's.
    Lab(&'a LabChain<'a, S>),
    /// The kit's own.
    Relative(&'a Relative<S>),
}

/// The lab's chain: a ray, its nearest hit, the hit point, shadow rays from there.
#[derive(Clone, Copy, Debug)]
pub struct LabChain<'a, S: Scalar> {
    /// What there is to see.
    pub scene: &'a Scene<S>,
    /// From where.
    pub camera: &'a PerspectiveCamera<S>,
    /// How light is summed up.
    pub integrator: Integrator,
}

impl<S: Scalar> Chain<S> for LabChain<'_, S> {
    /// `index / (count - 1)`: from 0 for the first column or row to 1 for the last; the middle
    /// where there is only one.
    #[inline(always)]
    fn coordinate(index: u32, count: u32) -> S {
        if count == 1 {
            S::from_f64(0.5)
        } else {
            S::from_f64(f64::from(index)) / S::from_f64(f64::from(count - 1))
        }
    }

    #[inline(always)]
    fn across<R: Real<Scalar = S>>(&self, column: R) -> R::Vector {
        self.camera.across(column)
    }

    #[inline(always)]
    fn down<R: Real<Scalar = S>>(&self, row: R) -> R::Vector {
        -self.camera.down(row)
    }

    #[inline(always)]
    fn reflected<R: Real<Scalar = S>>(&self, direction: R::Vector) -> Option<(R::Mask, R::Vector)> {
        self.integrator
            .reflected(self.scene, &self.camera.ray_along::<R>(direction))
    }

    fn background(&self) -> S::Vector {
        self.scene.background()
    }

    fn kind(&self) -> ChainKind<'_, S> {
        ChainKind::Lab(self)
    }

    /// The kernels one precision up are computed one by one: as packets they do not fit the
    /// registers.
    fn gains_from_packets(&self) -> bool {
        self.integrator.quality() != Quality::Wide
    }
}
