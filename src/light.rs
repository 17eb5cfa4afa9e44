//! Point lights (clauses 2.1 to 2.3).

use crate::error::Invalid;
use crate::quality::{Quality, Scale};
use crate::real::{Real, Scalar};
use crate::vector::Vector;

/// A light that shines from one point, equally in every direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight<S: Scalar> {
    position: S::Vector,
    color: S::Vector,
    power: S,
}

/// What a point receives from a light where nothing stands between (the lab's `LightSample`).
#[derive(Clone, Copy, Debug)]
pub struct LightSample<R: Real> {
    /// The unit vector toward the light.
    pub direction: R::Vector,
    /// The distance to the light.
    pub distance: R,
    /// `color * power / distance²`.
    pub radiance: R::Vector,
    /// The probability density of the sample: 1, since a point light offers no choice.
    pub pdf: R,
}

impl<S: Scalar> PointLight<S> {
    /// A light of a linear colour, whose power scales its radiance.
    ///
    /// # Errors
    /// If the position is not finite, a component of the colour is not finite or below 0, or the
    /// power is not finite or below 0.
    pub fn new(position: S::Vector, color: S::Vector, power: S) -> Result<Self, Invalid> {
        let position = Invalid::unless_finite::<S>("light position", position)?;
        let color = Invalid::unless_color::<S>("light color", color)?;
        let valid = power.is_finite() && power.to_f64() >= 0.0;
        let power = Invalid::unless(valid, "light power", power, "finite and not below 0")?;
        Ok(Self {
            position,
            color,
            power,
        })
    }

    /// Where the light is.
    pub fn position(&self) -> S::Vector {
        self.position
    }

    /// The linear colour.
    pub fn color(&self) -> S::Vector {
        self.color
    }

    /// The factor of the radiance.
    pub fn power(&self) -> S {
        self.power
    }

    /// The sample of the light from `point` (clause 2.3). Not finite at the light itself, where no
    /// direction exists.
    ///
    /// [`Quality::Textbook`] squares the distance as it is; the others scale it by a power of two
    /// first, so that the square neither overflows nor underflows where the radiance does not.
    #[inline(always)]
    pub fn sample<R: Real<Scalar = S>>(
        &self,
        point: R::Vector,
        quality: Quality,
    ) -> LightSample<R> {
        let token = point.x().token();
        let to_light = R::Vector::splat(token, self.position) - point;
        let (color, power) = (
            R::Vector::splat(token, self.color),
            R::splat(token, self.power),
        );
        let one = power.constant(1.0);
        let Scale { unit, reciprocal } = match quality {
            Quality::Textbook => Scale {
                unit: one,
                reciprocal: one,
            },
            Quality::Stable | Quality::Wide => Scale::<R>::of_vector(to_light),
        };
        let to_light = to_light * reciprocal;
        let square = to_light.dot(to_light);
        LightSample {
            direction: to_light.normalized(),
            distance: square.sqrt() * unit,
            radiance: color * (power / square * reciprocal * reciprocal),
            pdf: one,
        }
    }
}
