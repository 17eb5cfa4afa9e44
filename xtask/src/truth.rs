//! The truth of every pixel: which object, whether a light stands before it, whether it is blocked.
//!
//! Computed in double-double, which errs by about 1e-30, and independently of the strategies it
//! judges: a shadow is decided by solving for the parameter t at which the way to the light crosses
//! a surface. No side is compared, no origin moves.
//!
//! Two things are shared with the ray-relative chain, and could be wrong in both: the camera's
//! axes, which give the pixels' directions, and [`DoubleDouble`] itself. The tests below hold the
//! decisions to the exact oracle, and the directions to the exact tangent.

use ombrage::{
    Chain, DoubleDouble, Invalid, LabChain, PerspectiveCamera, PointLight, Quality, Ray, Real,
    Scalar, Scene, Shape, Size, Span, Triple, Vector, View,
};

type Number = DoubleDouble;
type Point = Triple<Number>;

/// Where a decision's margin, relative to the numbers it is made of, is smaller than this, it is
/// left open. Errors of double-double stay below it, also after a cancellation of twelve digits.
pub const UNDECIDED: f64 = 1e-18;

/// What is true of a pixel and one light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TruePixel {
    /// The surface it shows, by [`surfaces`]; `None`: the background.
    pub surface: Option<usize>,
    /// Whether the light stands before the surface: dot(normal, to light) > 0.
    pub faces_light: bool,
    /// Whether a surface stands strictly between; only where the light stands before it.
    pub blocked: bool,
    /// The smallest margin of the decisions.
    pub margin: f64,
}

impl TruePixel {
    /// Whether the light reaches it.
    pub fn is_lit(&self) -> bool {
        self.faces_light && !self.blocked
    }

    /// Whether it shows an object that the light does not reach.
    pub fn is_black(&self) -> bool {
        self.surface.is_some() && !self.is_lit()
    }

    /// Whether double-double cannot tell.
    pub fn is_undecided(&self) -> bool {
        self.margin < UNDECIDED
    }
}

/// The number of the surface of every object: that of the first object equal to it, so that
/// coincident objects count as one.
pub fn surfaces(scene: &Scene<f64>) -> Vec<usize> {
    let (spheres, planes) = (scene.spheres(), scene.planes());
    let first_sphere = |i: usize| spheres.iter().position(|s| s.shape == spheres[i].shape);
    let first_plane = |i: usize| planes.iter().position(|p| p.shape == planes[i].shape);
    let spheres_first = (0..spheres.len()).map(|i| first_sphere(i).unwrap_or(i));
    let planes_after = (0..planes.len()).map(|i| spheres.len() + first_plane(i).unwrap_or(i));
    spheres_first.chain(planes_after).collect()
}

/// The truth of every pixel of a picture, row-major, and of the first light of the scene; without a
/// light nothing faces it.
///
/// # Errors
/// If the view is invalid.
pub fn of(scene: &Scene<f64>, view: &View<f64>, size: Size) -> Result<Vec<TruePixel>, Invalid> {
    let witness = Witness::new(scene, scene.lights().first())?;
    let [width, height] = [size.width(), size.height()].map(|n| number(f64::from(n)));
    let camera = PerspectiveCamera::new(&view.cast::<Number>(), width / height)?;
    let mut pixels = Vec::with_capacity(size.pixels());
    for row in 0..size.height() {
        let down = LabChain::coordinate(row, size.height());
        for column in 0..size.width() {
            let ray = camera.ray::<Number>(LabChain::coordinate(column, size.width()), down);
            pixels.push(witness.look_along(&ray));
        }
    }
    Ok(pixels)
}

/// A scene with one of its lights, in double-double.
struct Witness {
    scene: Scene<Number>,
    surfaces: Vec<usize>,
    light: Option<Point>,
}

/// The smallest margin so far.
struct Margin(f64);

impl Margin {
    /// Takes note of a decision about the sign of `value`, a difference of numbers as large as
    /// `size`.
    fn note(&mut self, value: Number, size: Number) {
        let margin = (value / size).abs().to_f64();
        if margin < self.0 {
            self.0 = margin;
        }
    }
}

/// Where the ray meets what first.
struct Nearest {
    t: Number,
    object: usize,
}

impl Witness {
    fn new(scene: &Scene<f64>, light: Option<&PointLight<f64>>) -> Result<Self, Invalid> {
        Ok(Self {
            scene: scene.cast()?,
            surfaces: surfaces(scene),
            light: light.map(|light| Vector::constant((), light.position().to_array())),
        })
    }

    /// The truth along a ray, its direction a unit vector.
    fn look_along(&self, ray: &Ray<Number>) -> TruePixel {
        let mut margin = Margin(1.0);
        let mut pixel = TruePixel {
            surface: None,
            faces_light: false,
            blocked: false,
            margin: 1.0,
        };
        if let Some(nearest) = self.nearest(ray, &mut margin) {
            let own = self.surfaces[nearest.object];
            pixel.surface = Some(own);
            if let Some(light) = self.light {
                let point = ray.point_at(nearest.t);
                let outward = self.normal(nearest.object, point);
                let away = outward.dot(ray.direction) > number(0.0);
                let normal = if away { -outward } else { outward };
                let to_light = light - point;
                let toward = normal.dot(to_light);
                margin.note(toward, length(normal) * length(to_light));
                pixel.faces_light = toward > number(0.0);
                pixel.blocked =
                    pixel.faces_light && self.is_blocked(own, point, to_light, &mut margin);
            }
        }
        pixel.margin = margin.0;
        pixel
    }

    /// The nearest object up to `t_max`; of two at the same place, the one with the lower number. A
    /// surface through the camera itself is not seen at t = 0.
    fn nearest(&self, ray: &Ray<Number>, margin: &mut Margin) -> Option<Nearest> {
        let t_max = self.scene.t_max();
        let span = Span::new(number(UNDECIDED), t_max);
        let spheres = self.scene.spheres().iter().map(|sphere| {
            let to_center = sphere.shape.center() - ray.origin;
            let aside = to_center - ray.direction * to_center.dot(ray.direction);
            let square = sphere.shape.radius() * sphere.shape.radius();
            margin.note(square - aside.dot(aside), square);
            sphere
                .shape
                .intersect::<Number>(ray, &span, Quality::Stable)
        });
        let mut hits: Vec<_> = spheres.collect();
        let planes = self.scene.planes().iter();
        hits.extend(planes.map(|p| p.shape.intersect::<Number>(ray, &span, Quality::Stable)));
        let mut nearest: Option<Nearest> = None;
        for (object, hit) in hits.into_iter().enumerate() {
            if t_max.is_finite() && hit.t.is_finite() {
                margin.note(hit.t - t_max, t_max);
            }
            if !hit.mask
                || nearest
                    .as_ref()
                    .is_some_and(|n| self.are_one(n.object, object))
            {
                continue;
            }
            if let Some(nearest) = &nearest {
                margin.note(hit.t - nearest.t, hit.t);
            }
            if nearest.as_ref().is_none_or(|nearest| hit.t < nearest.t) {
                nearest = Some(Nearest { t: hit.t, object });
            }
        }
        nearest
    }

    fn are_one(&self, a: usize, b: usize) -> bool {
        self.surfaces[a] == self.surfaces[b]
    }

    /// A normal of an object at a point of it; away from a sphere's center.
    fn normal(&self, object: usize, point: Point) -> Point {
        let spheres = self.scene.spheres();
        match spheres.get(object) {
            Some(sphere) => point - sphere.shape.center(),
            None => self.scene.planes()[object - spheres.len()].shape.normal(),
        }
    }

    /// Whether a surface crosses the way `point + t to_light` for a t strictly between 0 and 1. On
    /// the sphere `own`, on which the point lies, t = 0 is one root and only the other counts; a
    /// plane never meets such a way again.
    fn is_blocked(&self, own: usize, point: Point, to_light: Point, margin: &mut Margin) -> bool {
        let square = to_light.dot(to_light);
        let spheres = self.scene.spheres().iter();
        let mut roots = vec![];
        for (object, sphere) in spheres.enumerate() {
            let from_center = point - sphere.shape.center();
            let ahead = -from_center.dot(to_light) / square;
            if self.surfaces[object] == own {
                roots.push(ahead * 2.0);
                continue;
            }
            let aside = from_center + to_light * ahead;
            let radius_squared = sphere.shape.radius() * sphere.shape.radius();
            let rest = radius_squared - aside.dot(aside);
            margin.note(rest, radius_squared);
            if rest > number(0.0) {
                let half_chord = (rest / square).sqrt();
                roots.extend([ahead - half_chord, ahead + half_chord]);
            }
        }
        let planes = (self.scene.spheres().len()..).zip(self.scene.planes());
        for (_, plane) in planes.filter(|(object, _)| self.surfaces[*object] != own) {
            let normal = plane.shape.normal();
            let to_plane = plane.shape.point() - point;
            roots.push(to_plane.dot(normal) / to_light.dot(normal));
        }
        let one = number(1.0);
        let mut blocked = false;
        for t in roots {
            margin.note(t, one);
            margin.note(t - one, one);
            blocked |= t > number(0.0) && t < one;
        }
        blocked
    }
}

fn number(value: f64) -> Number {
    Number::from_f64(value)
}

fn length(vector: Point) -> Number {
    vector.dot(vector).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case;
    use ombrage_oracle::shade::{Item, shade};
    use ombrage_oracle::{Object, Plane, Rational, Sphere, exact, light::Light};
    use std::path::PathBuf;

    /// Numbers that look random, the same in every run (Marsaglia, "Xorshift RNGs", Journal of
    /// Statistical Software 8 (2003)).
    struct Random(u64);

    impl Random {
        fn below(&mut self, bound: u32) -> u32 {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            (self.0 >> 33) as u32 % bound
        }
    }

    fn items(scene: &Scene<f64>) -> Vec<Item> {
        let item = |object| Item {
            object,
            color: exact::vector([1.0; 3]),
        };
        let spheres = scene.spheres().iter().map(|sphere| {
            let (center, radius) = (sphere.shape.center(), sphere.shape.radius());
            Sphere::new(center.to_array(), radius).map(Object::Sphere)
        });
        let planes = scene.planes().iter().map(|plane| {
            let (point, normal) = (plane.shape.point(), plane.shape.normal());
            Plane::new(point.to_array(), normal.to_array()).map(Object::Plane)
        });
        spheres.chain(planes).map(item).collect()
    }

    /// The oracle takes rays of f64; the directions of pixels are rounded for both. A direction is
    /// then a unit vector only to 2^-53, so a pixel is left out where `t_max` hangs on that.
    #[test]
    fn agrees_with_the_exact_oracle_on_every_scene() {
        let scenes = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tests/scenes");
        let mut random = Random(0x9e37_79b9_7f4a_7c15);
        let (mut judged, mut blocked) = (0, 0);
        for path in case::scene_files(&scenes).expect("scenes") {
            let case = case::Case::read(&path).expect("a scene");
            let (scene, size) = (&case.scene, case.size);
            let objects = scene.spheres().len() + scene.planes().len();
            let samples = if objects > 16 { 10 } else { 40 };
            let items = items(scene);
            let camera = case.camera::<f64>().expect("a camera");
            for light in scene.lights() {
                let witness = Witness::new(scene, Some(light)).expect("valid in double-double");
                let exact_light = Light::new(light.position().to_array(), 1.0, [1.0; 3]);
                for _ in 0..samples {
                    let place = [size.width(), size.height()].map(|n| (random.below(n), n));
                    let [across, down] = place.map(|(i, n)| LabChain::coordinate(i, n));
                    let ray = camera.ray::<f64>(across, down);
                    let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
                    let wide = Ray {
                        origin: Vector::constant((), origin),
                        direction: Vector::constant((), direction),
                    };
                    let mine = witness.look_along(&wide);
                    if mine.margin < 1e-12 {
                        continue;
                    }
                    let ray = ombrage_oracle::Ray::new(origin, direction, 0.0, scene.t_max());
                    let truth = shade(ray.as_ref(), &items, exact_light.as_ref(), &Rational::ZERO);
                    let surface = truth.hit.as_ref().map(|hit| witness.surfaces[hit.id]);
                    let faces = truth.lighting.as_ref().is_some_and(|l| l.cos_sign > 0);
                    let black = truth
                        .lighting
                        .as_ref()
                        .is_some_and(|l| !l.blockers.is_empty());
                    let expected = (surface, faces, faces && black);
                    let found = (mine.surface, mine.faces_light, mine.blocked);
                    assert_eq!(found, expected, "{} {origin:?} {direction:?}", case.name);
                    judged += 1;
                    blocked += usize::from(mine.blocked);
                }
            }
        }
        assert!(
            judged > 900 && blocked > 50,
            "{judged} judged, {blocked} blocked"
        );
    }

    /// tan 30° = 1/√3: for the lab's camera the direction to the middle of the upper edge has y/z
    /// with 3 (y/z)² = 1, and to the corner x/z = 3/2 y/z.
    #[test]
    fn directions_are_exact_to_thirty_digits() {
        let case = case::Case {
            name: "lab".into(),
            scene: ombrage::lab::scene().expect("valid"),
            view: ombrage::lab::view(),
            size: Size::LAB,
        };
        let camera = case.camera::<Number>().expect("valid");
        let [x, y, z] = camera
            .ray::<Number>(number(0.0), number(0.0))
            .direction
            .to_array();
        let (one, slope) = (number(1.0), y / z);
        let error = (slope * slope * 3.0 - one).abs().to_f64();
        assert!(error < 1e-30, "{error:e}");
        let error = (x / y - number(1.5)).abs().to_f64();
        assert!(error < 1e-30, "{error:e}");
    }
}
