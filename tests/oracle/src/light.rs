//! The exact sample of a point light, clause 2.3.

use crate::exact::{Rational, Vector, dot, power_of_two, rational, sign, sub, vector};
use crate::format::Format;
use crate::real::Real;
use crate::surd::Surd;

/// A point light of a colour and a power; radiance is `color * power / distance²`.
#[derive(Clone, Debug)]
pub struct Light {
    /// Its position.
    pub position: Vector,
    /// Its power, of any sign.
    pub power: Rational,
    /// Its colour.
    pub color: Vector,
}

/// What is true of a light sample.
#[derive(Clone, Debug)]
pub struct LightTruth {
    /// The distance to the light.
    pub dist: Real,
    /// Its square.
    pub d2: Rational,
    /// The unit vector toward the light.
    pub dir: [Real; 3],
    /// `color * power / d2`
    pub radiance: Vector,
}

impl Light {
    /// `None` where policy calls the light dark: a NaN or an infinity.
    pub fn new(position: [f64; 3], power: f64, color: [f64; 3]) -> Option<Light> {
        Some(Light {
            position: vector(position)?,
            power: rational(power)?,
            color: vector(color)?,
        })
    }

    /// The sample of the light at the point `p`; `None` if the light is exactly there, where it has no direction.
    pub fn sample(&self, p: &Vector) -> Option<LightTruth> {
        let to_light = sub(&self.position, p);
        let d2 = dot(&to_light, &to_light);
        (sign(&d2) != 0).then(|| LightTruth {
            dist: Real::from(Surd::root(d2.clone())),
            dir: to_light.map(|x| Real::root(sign(&x), Surd::from(&x * &x / &d2))),
            radiance: std::array::from_fn(|i| &self.color[i] * &self.power / &d2),
            d2,
        })
    }
}

/// What befalls a kernel that squares the distance in `format`: `d2_overflows` to infinity, `d2_underflows` below the
/// smallest normal number.
pub fn flags(d2: &Rational, format: Format) -> Vec<&'static str> {
    let rounded = format.round(d2);
    let smallest = power_of_two(format.min_exponent());
    [
        ("d2_overflows", rounded.is_infinite()),
        ("d2_underflows", *d2 < smallest),
    ]
    .into_iter()
    .filter_map(|(flag, raised)| raised.then_some(flag))
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pythagorean_sample_is_rational() {
        let light = Light::new([3.0, 4.0, 0.0], 50.0, [1.0, 0.5, 0.0]).unwrap();
        let truth = light.sample(&vector([0.0; 3]).unwrap()).unwrap();
        assert_eq!(truth.dist, Real::from(Rational::from(5)));
        assert_eq!(truth.d2, Rational::from(25));
        assert_eq!(
            truth.dir[0],
            Real::from(Rational::from_parts(3.into(), 5u8.into()))
        );
        assert_eq!(truth.radiance[0], Rational::from(2));
        assert!(light.sample(&light.position).is_none());
    }

    #[test]
    fn flags_of_the_square() {
        let square = |x: f64| rational(x).unwrap() * rational(x).unwrap();
        assert_eq!(flags(&square(1e30), Format::F32), ["d2_overflows"]);
        assert_eq!(flags(&square(1e-20), Format::F32), ["d2_underflows"]);
        assert!(flags(&square(1e30), Format::F64).is_empty());
    }
}
