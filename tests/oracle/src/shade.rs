//! The exact radiance along a ray: nearest hit, one point light, exact shadows (clauses 3.1, 3.3 and 4.1).

use crate::any_hit::any_hit;
use crate::exact::{Rational, Vector, dot, floor_log2, power_of_two, sign, square, sub};
use crate::format::Format;
use crate::light::Light;
use crate::object::Object;
use crate::plane::saturate;
use crate::quantise;
use crate::ray::Ray;
use crate::real::Real;
use crate::sphere::Sphere;
use crate::surd::Surd;

/// An object of a coloured scene.
#[derive(Clone, Debug)]
pub struct Item {
    /// The object; `None` if policy calls it missed by every ray.
    pub object: Option<Object>,
    /// Its colour; `None` if it is not finite: policy calls it black.
    pub color: Option<Vector>,
}

/// What is true of a shaded ray.
#[derive(Clone, Debug)]
pub struct ShadeTruth {
    /// The nearest hit in `(tmin, tmax]`, if any.
    pub hit: Option<ShadeHit>,
    /// How it is lit; `None` if there is no hit or the light is dark by policy.
    pub lighting: Option<Lighting>,
    /// The radiance before the clamp.
    pub li: [Real; 3],
}

/// The hit that is shaded.
#[derive(Clone, Debug)]
pub struct ShadeHit {
    /// The object hit: the first of `ties`.
    pub id: usize,
    /// All objects hit at exactly this t.
    pub ties: Vec<usize>,
    /// Its parameter along the ray.
    pub t: Surd,
    /// The point.
    pub p: [Surd; 3],
    /// The unit normal on the side the ray came from.
    pub n: [Real; 3],
    /// Whether that is the object's own normal turned round.
    pub flipped: bool,
}

/// How a hit is lit.
#[derive(Clone, Debug)]
pub struct Lighting {
    /// The sign of the cosine between the normal and the direction to the light; 0 also for a light at the hit point.
    pub cos_sign: i8,
    /// The objects that cross the open segment from the hit point to the light.
    pub blockers: Vec<usize>,
    /// The objects whose surface contains the light; that alone does not block.
    pub touch: Vec<usize>,
    /// The least of `(m / radius)² - 1` in magnitude over the spheres other than those hit whose centre projects into the open
    /// segment, m being the distance from the centre to the segment: 0 grazes, less than 0 blocks. `None` if there is no
    /// such sphere or the cosine is not positive.
    pub vis_margin: Option<f64>,
    /// The cosine, where the light contributes.
    pub cos: Option<Real>,
    /// Whether the light is exactly at the hit point.
    pub light_at_hit: bool,
}

impl ShadeTruth {
    /// The bytes of clause 3.3.
    pub fn bytes(&self) -> [u8; 3] {
        [0, 1, 2].map(|i| self.li[i].decide(quantise::byte))
    }
}

/// Shades a ray; a `None` ray misses everything, a `None` light is dark by policy.
pub fn shade(
    ray: Option<&Ray>,
    scene: &[Item],
    light: Option<&Light>,
    background: &Rational,
) -> ShadeTruth {
    let nearest = |ray| any_hit(ray, scene.iter().map(|item| item.object.as_ref())).nearest_half;
    let met = ray.and_then(|ray| {
        let nearest = nearest(ray)?;
        let item = &scene[nearest.ids[0]];
        Some((ray, nearest, item.object.as_ref()?, item.color.as_ref()))
    });
    let Some((ray, nearest, object, color)) = met else {
        return ShadeTruth {
            hit: None,
            lighting: None,
            li: gray(background),
        };
    };
    let p = ray.at(&nearest.t);
    let own = object.normal(&p);
    let flipped = Surd::dot_rational(&own, &ray.direction).sign() > 0;
    let normal = if flipped { own.map(|x| -x) } else { own };
    let inverse = Surd::norm(&normal).recip();
    let n = normal
        .each_ref()
        .map(|x| Real::root(x.sign(), &(x * x) * &inverse));
    let (lighting, li) = match light.zip(color) {
        Some((light, color)) => {
            let (lighting, li) = illuminate(scene, &nearest.ids, &p, &normal, light, color);
            (Some(lighting), li)
        }
        None => (None, gray(&Rational::ZERO)),
    };
    let hit = ShadeHit {
        id: nearest.ids[0],
        ties: nearest.ids,
        t: nearest.t,
        p,
        n,
        flipped,
    };
    ShadeTruth {
        hit: Some(hit),
        lighting,
        li,
    }
}

fn gray(x: &Rational) -> [Real; 3] {
    [0, 1, 2].map(|_| Real::from(x.clone()))
}

/// The light at the point `p`, which the objects `hit` share; `normal` need not be of length 1.
fn illuminate(
    scene: &[Item],
    hit: &[usize],
    p: &[Surd; 3],
    normal: &[Surd; 3],
    light: &Light,
    color: &Vector,
) -> (Lighting, [Real; 3]) {
    let segment = Segment::new(p, &light.position);
    let d2 = &segment.length2;
    let projection = Surd::dot(normal, &segment.along);
    let cos_sign = projection.sign();
    let light_at_hit = d2.sign() == 0;
    let all = |test: &dyn Fn(&Object) -> bool| -> Vec<usize> {
        (0..scene.len())
            .filter(|&id| scene[id].object.as_ref().is_some_and(test))
            .collect()
    };
    let blockers = all(&|object| !light_at_hit && segment.crosses(object));
    let position = light.position.clone().map(Surd::from);
    let touch = all(&|object| object.side(&position) == 0);
    let vis_margin = (cos_sign > 0).then(|| segment.margin(scene, hit)).flatten();
    let (mut cos, mut li) = (None, gray(&Rational::ZERO));
    if cos_sign > 0 && blockers.is_empty() {
        let cos2 = &(&projection * &projection) * &(&Surd::norm(normal) * d2).recip();
        // li² = (color * light * power)² cos² / d2², in the field of p.
        let falloff = &cos2 * &(d2 * d2).recip();
        li = std::array::from_fn(|i| {
            let factor = &color[i] * &light.color[i] * &light.power;
            Real::root(sign(&factor), falloff.scale(&square(&factor)))
        });
        cos = Some(Real::root(1, cos2));
    }
    (
        Lighting {
            cos_sign,
            blockers,
            touch,
            vis_margin,
            cos,
            light_at_hit,
        },
        li,
    )
}

/// From a hit point to a light elsewhere.
struct Segment<'a> {
    from: &'a [Surd; 3],
    to: &'a Vector,
    along: [Surd; 3],
    length2: Surd,
}

impl<'a> Segment<'a> {
    fn new(from: &'a [Surd; 3], to: &'a Vector) -> Self {
        let along: [Surd; 3] = std::array::from_fn(|i| &Surd::from(to[i].clone()) - &from[i]);
        Segment {
            length2: Surd::norm(&along),
            from,
            to,
            along,
        }
    }

    /// Whether a surface meets the segment strictly between its ends.
    fn crosses(&self, object: &Object) -> bool {
        match object {
            Object::Plane(plane) => {
                let light = dot(&sub(self.to, &plane.point), &plane.normal);
                plane.side(self.from).sign() * sign(&light) < 0
            }
            Object::Sphere(sphere) => self.crosses_sphere(sphere),
        }
    }

    /// The roots of `g(s) = length2 s² - 2 b s + start` in (0, 1), by the signs of g at both ends.
    fn crosses_sphere(&self, sphere: &Sphere) -> bool {
        let (b, start) = self.project(sphere);
        let to_light = sub(self.to, &sphere.center);
        let end = dot(&to_light, &to_light) - square(&sphere.radius);
        match (start.sign(), sign(&end)) {
            (1, 1) => {
                let discriminant = &(&b * &b) - &(&self.length2 * &start);
                discriminant.sign() >= 0 && b.sign() > 0 && (&self.length2 - &b).sign() > 0
            }
            // One root is an end; the other is 2b / length2 or start / length2.
            (0, 1) => b.sign() > 0,
            (1, 0) => (&self.length2 - &start).sign() > 0,
            (from, to) => from * to < 0,
        }
    }

    /// `dot(center - from, along)` and `|center - from|² - radius²`.
    fn project(&self, sphere: &Sphere) -> (Surd, Surd) {
        let to_center = sphere.from_center(self.from).map(|x| -x);
        let start = &Surd::norm(&to_center) - &Surd::from(square(&sphere.radius));
        (Surd::dot(&to_center, &self.along), start)
    }

    /// See [`Lighting::vis_margin`].
    fn margin(&self, scene: &[Item], hit: &[usize]) -> Option<f64> {
        let others = scene.iter().enumerate().filter(|(id, _)| !hit.contains(id));
        others
            .filter_map(|(_, item)| match &item.object {
                Some(Object::Sphere(sphere)) => self.margin_of(sphere),
                _ => None,
            })
            .min_by(|a, b| a.abs().total_cmp(&b.abs()))
    }

    /// `(m² - r²) / r²` with `m² = |center - from|² - b² / length2`, as the quotient of two f64: `length2 start - b²` and
    /// `length2 r²`, each rounded after division by one power of two that brings the latter near 1.
    fn margin_of(&self, sphere: &Sphere) -> Option<f64> {
        let (b, start) = self.project(sphere);
        if b.sign() <= 0 || (&self.length2 - &b).sign() <= 0 {
            return None;
        }
        let whole = self.length2.scale(&square(&sphere.radius));
        let excess = &(&self.length2 * &start) - &(&b * &b);
        let unit = power_of_two(-Real::from(whole.clone()).decide(floor_log2));
        let round = |x: &Surd| Real::from(x.scale(&unit)).round(Format::F64);
        Some(saturate(round(&excess) / round(&whole)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::vector;
    use crate::plane::Plane;

    fn item(object: Option<Object>) -> Item {
        Item {
            object,
            color: vector([1.0, 0.5, 0.0]),
        }
    }

    fn sphere(center: [f64; 3], radius: f64) -> Item {
        item(Sphere::new(center, radius).map(Object::Sphere))
    }

    fn floor(y: f64) -> Item {
        item(Plane::new([0.0, y, 0.0], [0.0, 3.0, 0.0]).map(Object::Plane))
    }

    /// Looking from (0.3, 0, -5) along z, past nothing rational.
    fn lit(scene: &[Item], light: [f64; 3]) -> ShadeTruth {
        let ray = Ray::new([0.3, 0.0, -5.0], [0.0, 0.0, 1.0], 0.0, f64::INFINITY);
        let light = Light::new(light, 100.0, [1.0; 3]);
        shade(ray.as_ref(), scene, light.as_ref(), &Rational::ZERO)
    }

    #[test]
    fn twins_do_not_shadow_each_other() {
        let scene = [sphere([0.0; 3], 1.0), sphere([0.0; 3], 1.0)];
        let truth = lit(&scene, [1.0, 2.0, -4.0]);
        assert_eq!(truth.hit.unwrap().ties, [0, 1]);
        assert!(truth.lighting.unwrap().blockers.is_empty());
        // Seen from behind, both block.
        assert_eq!(
            lit(&scene, [1.0, 2.0, 4.0]).lighting.unwrap().blockers,
            [0, 1]
        );
    }

    #[test]
    fn an_object_through_the_light_touches_and_does_not_block() {
        let truth = lit(&[sphere([0.0; 3], 1.0), floor(2.0)], [1.0, 2.0, -4.0]);
        let lighting = truth.lighting.unwrap();
        assert_eq!((lighting.touch, lighting.blockers), (vec![1], vec![]));
        assert!(lighting.cos.is_some() && truth.li[0].sign() == 1 && truth.li[2].sign() == 0);
    }

    #[test]
    fn a_tangent_sphere_blocks() {
        let down = Ray::new([0.0; 3], [0.0, -1.0, 0.0], 0.0, f64::INFINITY);
        let light = Light::new([0.0, 10.0, 0.0], 1.0, [1.0; 3]);
        let margin = |x: f64| {
            let scene = [floor(-2.0), sphere([x, 4.0, 0.0], 1.0)];
            let lighting = shade(down.as_ref(), &scene, light.as_ref(), &Rational::ZERO)
                .lighting
                .unwrap();
            (
                lighting.blockers.len(),
                lighting.vis_margin.unwrap().total_cmp(&0.0),
            )
        };
        assert_eq!(margin(1.0), (1, std::cmp::Ordering::Equal));
        assert_eq!(
            margin(Format::F64.step(1.0, 1)),
            (0, std::cmp::Ordering::Greater)
        );
        assert_eq!(
            margin(Format::F64.step(1.0, -1)),
            (1, std::cmp::Ordering::Less)
        );
    }

    #[test]
    fn the_normal_faces_the_ray() {
        let inside = lit(&[sphere([0.0, 0.0, -5.0], 2.0)], [0.3, 0.0, -5.0]);
        let hit = inside.hit.unwrap();
        assert!(hit.flipped && hit.n[2].sign() == -1);
        assert_eq!(inside.lighting.unwrap().cos_sign, 1);
    }
}
