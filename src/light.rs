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
    /// `color * power` as a product of two vectors of about the same magnitude, the first of powers
    /// of two: so neither overflows, nor the radiance before its time.
    halves: [S::Vector; 2],
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
            halves: halves::<S>(color, power),
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
        let position = R::Vector::splat(token, &self.position);
        let (color, power) = (
            R::Vector::splat(token, &self.color),
            R::splat(token, self.power),
        );
        let one = power.constant(1.0);
        let whole = Scale {
            unit: one,
            reciprocal: one,
        };
        let (to_light, stretch, Scale { unit, reciprocal }) = match quality {
            Quality::Textbook => (position - point, whole, whole),
            Quality::Stable | Quality::Wide => {
                let (to_light, stretch) = difference::<R>(position, point);
                (to_light, stretch, Scale::<R>::of_vector(to_light))
            }
        };
        let to_light = to_light * reciprocal;
        let square = to_light.dot(to_light);
        let radiance = match quality {
            Quality::Textbook => color * (power / square),
            Quality::Stable | Quality::Wide => {
                let [coarse, fine] = self.halves.map(|half| R::Vector::splat(token, &half));
                let reciprocal = reciprocal * stretch.reciprocal;
                fine * reciprocal * (one / square) * (coarse * reciprocal)
            }
        };
        LightSample {
            direction: to_light.normalized(),
            distance: square.sqrt() * unit * stretch.unit,
            radiance,
            pdf: one,
        }
    }
}

/// See [`PointLight`].
fn halves<S: Scalar>(color: S::Vector, power: S) -> [S::Vector; 2] {
    let root = |x: S| {
        let root = x.sqrt().binade();
        let smallest = S::from_f64(S::MIN_POSITIVE);
        S::select(root < smallest, smallest, root)
    };
    let [r, g, b] = color.to_array().map(root);
    let coarse = S::Vector::new(r, g, b);
    let [fine_r, fine_g, fine_b] = color.to_array();
    let fine = S::Vector::new(fine_r / r, fine_g / g, fine_b / b);
    let coarse_power = root(power);
    [coarse * coarse_power, fine * (power / coarse_power)]
}

/// `a - b` over the unit of a scale: 1, or 2 where the difference itself would overflow.
#[inline(always)]
fn difference<R: Real<Scalar: Scalar>>(a: R::Vector, b: R::Vector) -> (R::Vector, Scale<R>) {
    let plain = a - b;
    let largest = R::splat(plain.x().token(), R::Scalar::MAX);
    let [x, y, z] = plain.abs().to_array();
    let overflows = x.gt(largest) | y.gt(largest) | z.gt(largest);
    let (half, one, two) = (x.constant(0.5), x.constant(1.0), x.constant(2.0));
    (
        R::Vector::select(overflows, a * half - b * half, plain),
        Scale {
            unit: R::select(overflows, two, one),
            reciprocal: R::select(overflows, half, one),
        },
    )
}
