//! Pictures by another formulation than the kit's: rays, hit points and ways to the light in the
//! world, by the exact oracle. Only the camera is rounded, to 256 bits.

use ombrage::{Film, Lighting, Scene};
use ombrage_oracle::any_hit::any_hit;
use ombrage_oracle::exact::{power_of_two, rational, square, vector};
use ombrage_oracle::light::Light;
use ombrage_oracle::shade::{Item, shade};
use ombrage_oracle::{Object, Plane, Rational, Ray, Real, Sphere, Surd, Vector};
use xtask::case::Case;

/// Bits after the point of all numbers that are rounded.
const BITS: isize = 256;

/// The number to so many bits.
fn rounded(x: &Rational) -> Rational {
    let unit = power_of_two(BITS);
    Rational::from((x * &unit).trunc()) / unit
}

fn number(x: f64) -> Rational {
    rational(x).expect("finite")
}

fn root(x: &Rational) -> Rational {
    let first = number(x.to_f64().value().sqrt());
    (0..4).fold(first, |y, _| rounded(&((&y + x / &y) / number(2.0))))
}

/// The sum of `first`, and terms of which each is the one before times a factor.
fn series(first: Rational, factor: impl Fn(f64) -> Rational) -> Rational {
    let (mut sum, mut term) = (first.clone(), first);
    for n in 1..256 {
        term = rounded(&(term * factor(f64::from(n))));
        sum += &term;
    }
    sum
}

/// π by Machin's formula.
fn pi() -> Rational {
    let arctangent = |n: f64| {
        let step = |k: f64| number(1.0 - 2.0 * k) / (number(2.0 * k + 1.0) * number(n * n));
        series(number(1.0) / number(n), step)
    };
    number(16.0) * arctangent(5.0) - number(4.0) * arctangent(239.0)
}

fn half_tangent(degrees: f64) -> Rational {
    let angle = rounded(&(number(degrees) * pi() / number(360.0)));
    let square = &angle * &angle;
    let over = |n: f64| -(&square / number(n));
    let sine = series(angle.clone(), |n| over(2.0 * n * (2.0 * n + 1.0)));
    let cosine = series(number(1.0), |n| over(2.0 * n * (2.0 * n - 1.0)));
    rounded(&(sine / cosine))
}

fn combine(a: &Vector, x: &Rational, b: &Vector) -> Vector {
    std::array::from_fn(|i| rounded(&(&a[i] + x * &b[i])))
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

fn unit(v: &Vector) -> Vector {
    let length = root(&v.iter().fold(number(0.0), |sum, x| sum + x * x));
    v.each_ref().map(|x| rounded(&(x / &length)))
}

/// Where a column or row is on its edge of the viewport, from -1 to 1.
fn place(index: u32, count: u32) -> Rational {
    match count {
        1 => number(0.0),
        _ => number(2.0 * f64::from(index)) / number(f64::from(count - 1)) - number(1.0),
    }
}

/// A camera, and the scene as the oracle takes it.
pub struct Reference {
    origin: Vector,
    forward: Vector,
    right: Vector,
    up: Vector,
    columns: Vec<Rational>,
    rows: Vec<Rational>,
    t_max: Option<Rational>,
    items: Vec<Item>,
    lights: Vec<Light>,
    background: Vector,
    lighting: Lighting,
    film: Film,
}

/// What a ray meets first.
struct Seen<'a> {
    point: [Surd; 3],
    /// On the side the ray comes from, of any length.
    normal: [Surd; 3],
    color: &'a Vector,
}

impl Reference {
    /// The picture of a case.
    pub fn new(case: &Case, lighting: Lighting, film: Film) -> Self {
        let exact = |v: glam::DVec3| vector(v.to_array()).expect("finite");
        let [position, look_at, up] =
            [case.view.position, case.view.look_at, case.view.up].map(exact);
        let backward = unit(&combine(&position, &number(-1.0), &look_at));
        let right = unit(&cross(&up, &backward));
        let tangent = half_tangent(case.view.fov);
        let [width, height] = [case.size.width(), case.size.height()];
        let aspect = number(f64::from(width)) / number(f64::from(height));
        let scaled = |v: Vector, x: &Rational| v.map(|c| rounded(&(c * x)));
        let t_max = case.scene.t_max();
        Self {
            up: scaled(cross(&backward, &right), &tangent),
            right: scaled(right, &(&tangent * aspect)),
            forward: backward.map(|x| -x),
            origin: position,
            columns: (0..width).map(|i| place(i, width)).collect(),
            rows: (0..height).map(|i| -place(i, height)).collect(),
            t_max: t_max.is_finite().then(|| number(t_max)),
            items: items(&case.scene),
            lights: lights(&case.scene),
            background: exact(case.scene.background()),
            lighting,
            film,
        }
    }

    /// The bytes of a pixel; `None` where the sum of several lights is nearer than 2^-240 to the
    /// border of two.
    pub fn pixel(&self, column: u32, row: u32) -> Option<[u8; 3]> {
        let (across, down) = (&self.columns[column as usize], &self.rows[row as usize]);
        let through = combine(&self.forward, across, &self.right);
        let ray = Ray {
            origin: self.origin.clone(),
            direction: unit(&combine(&through, down, &self.up)),
            tmin: number(0.0),
            tmax: self.t_max.clone(),
        };
        let Some(radiances) = self.radiances(&ray) else {
            return Some([0, 1, 2].map(|i| self.byte(&self.background[i])));
        };
        let [red, green, blue] = [0, 1, 2].map(|i| match &radiances[..] {
            [radiance] => Some(radiance[i].decide(|x| self.byte(x))),
            several => {
                let unit = power_of_two(BITS);
                let whole = |x: &Rational| Rational::from((x * &unit).trunc());
                let parts = several.iter().map(|radiance| radiance[i].decide(whole));
                let least = parts.fold(number(0.0), |sum, part| sum + part);
                let most = &least + number(several.len() as f64);
                let [least, most] = [least, most].map(|x| self.byte(&(x / &unit)));
                (least == most).then_some(least)
            }
        });
        Some([red?, green?, blue?])
    }

    /// What each light adds to the radiance along a ray; `None` if it meets nothing.
    fn radiances(&self, ray: &Ray) -> Option<Vec<[Real; 3]>> {
        let lights = self.lights.iter();
        match self.lighting {
            Lighting::Eye => Some(vec![self.seen(ray)?.by_eye(ray)]),
            Lighting::Unshadowed => {
                let seen = self.seen(ray)?;
                Some(lights.map(|light| seen.by(light)).collect())
            }
            Lighting::Shadowed => {
                let of = |light: &Light| {
                    let truth = shade(Some(ray), &self.items, Some(light), &number(0.0));
                    truth.hit.map(|_| truth.li)
                };
                match &self.lights[..] {
                    [] => self.seen(ray).map(|_| vec![]),
                    _ => lights.map(of).collect(),
                }
            }
        }
    }

    fn seen(&self, ray: &Ray) -> Option<Seen<'_>> {
        let objects = self.items.iter().map(|item| item.object.as_ref());
        let nearest = any_hit(ray, objects).nearest_half?;
        let item = &self.items[nearest.ids[0]];
        let point = ray.at(&nearest.t);
        let normal = item.object.as_ref()?.normal(&point);
        let away = Surd::dot_rational(&normal, &ray.direction).sign() > 0;
        Some(Seen {
            normal: if away { normal.map(|x| -x) } else { normal },
            color: item.color.as_ref()?,
            point,
        })
    }

    /// `floor(255 x)` of a number from 0 on, as the film has it. What lies less than 2^-201 of itself
    /// below the border of two bytes is on it.
    fn byte(&self, x: &Rational) -> u8 {
        let scaled = x * (number(255.0) + power_of_two(-193));
        let level = Rational::from(scaled.trunc()).to_f64().value();
        match self.film {
            Film::Clamp => level.min(255.0) as u8,
            Film::Wrap => (level % 256.0) as u8,
        }
    }
}

impl Seen<'_> {
    /// Lit from the eye: colour times cosine.
    fn by_eye(&self, ray: &Ray) -> [Real; 3] {
        let along = Surd::dot_rational(&self.normal, &ray.direction);
        let square_of_ray = ray
            .direction
            .iter()
            .fold(number(0.0), |sum, x| sum + square(x));
        let lengths = Surd::norm(&self.normal).scale(&square_of_ray);
        let cosine = &(&along * &along) * &lengths.recip();
        self.color
            .each_ref()
            .map(|factor| Real::root(1, cosine.scale(&square(factor))))
    }

    /// Lit by a light before which nothing stands: colours times power times cosine over the
    /// squared distance.
    fn by(&self, light: &Light) -> [Real; 3] {
        let way: [Surd; 3] =
            std::array::from_fn(|i| &Surd::from(light.position[i].clone()) - &self.point[i]);
        let (height, distance) = (Surd::dot(&self.normal, &way), Surd::norm(&way));
        if height.sign() <= 0 {
            return [0; 3].map(|_| Real::from(number(0.0)));
        }
        let cube = &(&distance * &distance) * &distance;
        let falloff = &(&height * &height) * &(&Surd::norm(&self.normal) * &cube).recip();
        std::array::from_fn(|i| {
            let factor = &self.color[i] * &light.color[i] * &light.power;
            Real::root(1, falloff.scale(&square(&factor)))
        })
    }
}

fn items(scene: &Scene<f64>) -> Vec<Item> {
    let spheres = scene.spheres().iter().map(|sphere| Item {
        object: Sphere::new(sphere.shape.center().to_array(), sphere.shape.radius())
            .map(Object::Sphere),
        color: vector(sphere.color().to_array()),
    });
    let planes = scene.planes().iter().map(|plane| Item {
        object: Plane::new(
            plane.shape.point().to_array(),
            plane.shape.normal().to_array(),
        )
        .map(Object::Plane),
        color: vector(plane.color().to_array()),
    });
    spheres.chain(planes).collect()
}

fn lights(scene: &Scene<f64>) -> Vec<Light> {
    let lights = scene.lights().iter();
    let lights = lights.filter_map(|light| {
        Light::new(
            light.position().to_array(),
            light.power(),
            light.color().to_array(),
        )
    });
    lights.collect()
}
