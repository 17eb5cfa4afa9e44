//! The exact height of a shadow ray's origin above the surface it leaves.

use crate::exact::{Rational, Vector, dot, sign, sub, vector};
use crate::format::Format;
use crate::object::Object;
use crate::real::Real;
use crate::surd::Surd;

/// A surface seen from one side.
#[derive(Clone, Debug)]
pub struct Side<'a> {
    object: &'a Object,
    /// 1 where the object's normal points (for a sphere outside), -1 behind.
    side: i8,
}

impl<'a> Side<'a> {
    /// The side of `object` that a ray came from: that of its origin or, if the origin is on the surface, that which its
    /// direction comes from. `None` for a non-finite ray or a direction along the surface it starts on.
    pub fn seen_by(object: &'a Object, origin: [f64; 3], direction: [f64; 3]) -> Option<Side<'a>> {
        let (origin, direction) = (vector(origin)?.map(Surd::from), vector(direction)?);
        let along = || Surd::dot_rational(&object.normal(&origin), &direction).sign();
        let side = match (object.side(&origin), object) {
            (0, Object::Plane(_)) => -along(),
            // A ray that enters a sphere from its surface meets it again from inside.
            (0, Object::Sphere(_)) => along(),
            (side, _) => side,
        };
        (side != 0).then_some(Side { object, side })
    }

    /// The distance of `p` from the surface, positive on this side.
    pub fn height(&self, p: &Vector) -> Real {
        let height = match self.object {
            Object::Plane(plane) => {
                let along = dot(&sub(p, &plane.point), &plane.normal);
                let square = &along * &along / dot(&plane.normal, &plane.normal);
                return Real::root(sign(&along) * self.side, Surd::from(square));
            }
            Object::Sphere(sphere) => {
                let from_center = sub(p, &sphere.center);
                Surd::new(
                    -sphere.radius.clone(),
                    Rational::ONE,
                    dot(&from_center, &from_center),
                )
            }
        };
        Real::from(if self.side < 0 { -height } else { height })
    }
}

/// The origin of Wächter and Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems
/// chapter 6: `p` moved along `n` by 256 units in the last place or, nearer than 1/32 to the world's origin, by a fixed
/// length. For f32 the published constants; for f64 the analogue, 256 ulp and 2^-45.
pub fn wachter_binder(p: [f64; 3], n: [f64; 3], format: Format) -> [f64; 3] {
    const INT_SCALE: f64 = 256.0;
    const NEAR: f64 = 1.0 / 32.0;
    let float_scale = match format {
        Format::F32 => 1.0 / 65536.0,
        Format::F64 => f64::EPSILON * 128.0,
    };
    std::array::from_fn(|i| {
        if p[i].abs() < NEAR {
            return format.narrow(p[i] + format.narrow(float_scale * n[i]));
        }
        format.step(p[i], i64::from((INT_SCALE * n[i]) as i32))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::Plane;
    use crate::sphere::Sphere;

    #[test]
    fn heights_are_seen_from_the_origin() {
        let sphere = Sphere::new([0.0; 3], 2.0).map(Object::Sphere).unwrap();
        let height = |origin: f64, direction: f64| {
            let side = Side::seen_by(&sphere, [origin, 0.0, 0.0], [direction, 0.0, 0.0]).unwrap();
            side.height(&vector([0.0, 3.0, 4.0]).unwrap())
        };
        assert_eq!(height(9.0, -1.0), Real::from(Rational::from(3)));
        assert_eq!(height(0.0, -1.0), Real::from(Rational::from(-3)));
        assert_eq!(height(2.0, -1.0), Real::from(Rational::from(-3)));
        let plane = Plane::new([0.0; 3], [0.0, 0.0, -2.0])
            .map(Object::Plane)
            .unwrap();
        let side = Side::seen_by(&plane, [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]).unwrap();
        assert_eq!(
            side.height(&vector([7.0, 7.0, 0.5]).unwrap()),
            Real::from(Rational::from_parts(1.into(), 2u8.into()))
        );
    }
}
