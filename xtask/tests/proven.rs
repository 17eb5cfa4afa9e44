//! Proven pictures of every scene, against a reference of more than 300 bits by another
//! formulation: the oracle's, with rays, hit points and shadow segments in the world.
//!
//! `OMBRAGE_REFERENCE_PIXELS` sets how many random pixels of each scene are judged (6).

use ombrage::{Film, Lighting, Rung, Scene, render_proven};
use ombrage_oracle::exact::{power_of_two, rational, vector};
use ombrage_oracle::light::Light;
use ombrage_oracle::shade::{Item, shade};
use ombrage_oracle::{Format, Object, Plane, Rational, Ray, Sphere};
use xtask::case::{self, Case};

type Vector = [Rational; 3];

/// The number to 400 bits after the point.
fn rounded(x: &Rational) -> Rational {
    let unit = power_of_two(400);
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
    for n in 1..400 {
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

/// A camera, and the scene as the oracle takes it.
struct Reference {
    origin: Vector,
    forward: Vector,
    right: Vector,
    up: Vector,
    items: Vec<Item>,
    lights: Vec<Light>,
}

impl Reference {
    fn new(case: &Case) -> Self {
        let exact = |v: glam::DVec3| vector(v.to_array()).expect("finite");
        let [position, look_at, up] =
            [case.view.position, case.view.look_at, case.view.up].map(exact);
        let backward = unit(&combine(&position, &number(-1.0), &look_at));
        let right = unit(&cross(&up, &backward));
        let tangent = half_tangent(case.view.fov);
        let [width, height] = [case.size.width(), case.size.height()].map(|n| number(f64::from(n)));
        let scaled = |v: Vector, x: &Rational| v.map(|c| rounded(&(c * x)));
        Self {
            up: scaled(cross(&backward, &right), &tangent),
            right: scaled(right, &(&tangent * width / height)),
            forward: backward.map(|x| -x),
            origin: position,
            items: items(&case.scene),
            lights: lights(&case.scene),
        }
    }

    /// The bytes of a pixel; `None` where the sum of several lights is too near to the border of
    /// two.
    fn pixel(&self, case: &Case, column: u32, row: u32) -> Option<[u8; 3]> {
        let place = |i: u32, n: u32| match n {
            1 => number(0.0),
            _ => number(2.0 * f64::from(i)) / number(f64::from(n - 1)) - number(1.0),
        };
        let across = place(column, case.size.width());
        let down = -place(row, case.size.height());
        let through = combine(&self.forward, &across, &self.right);
        let t_max = case.scene.t_max();
        let ray = Ray {
            origin: self.origin.clone(),
            direction: unit(&combine(&through, &down, &self.up)),
            tmin: number(0.0),
            tmax: t_max.is_finite().then(|| number(t_max)),
        };
        let of = |light| shade(Some(&ray), &self.items, light, &number(0.0));
        if of(None).hit.is_none() {
            let background = case.scene.background().to_array();
            return Some(background.map(|x| byte(&number(x))));
        }
        match &self.lights[..] {
            [] => Some([0; 3]),
            [light] => Some(of(Some(light)).bytes()),
            lights => {
                let truths: Vec<_> = lights.iter().map(|light| of(Some(light))).collect();
                let [r, g, b] = [0, 1, 2].map(|i: usize| {
                    let radiance: f64 = truths.iter().map(|t| t.li[i].round(Format::F64)).sum();
                    let scaled = 255.0 * radiance;
                    let clear = (scaled - scaled.round()).abs() > 1e-9 || scaled == 0.0;
                    clear.then_some(scaled as u8)
                });
                Some([r?, g?, b?])
            }
        }
    }
}

/// `floor(255 x)` of a number from 0 on, at most 255.
fn byte(x: &Rational) -> u8 {
    let level = Rational::from((x * number(255.0)).trunc());
    level.to_f64().value().min(255.0) as u8
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

fn samples() -> usize {
    let wanted = std::env::var("OMBRAGE_REFERENCE_PIXELS").ok();
    wanted.and_then(|text| text.parse().ok()).unwrap_or(6)
}

#[test]
fn pixels_of_every_scene_are_those_of_the_reference() {
    let mut random = 0x9e37_79b9_7f4a_7c15_u64;
    let mut below = |bound: u32| {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        (random >> 33) as u32 % bound
    };
    let (mut judged, mut lit) = (0, 0);
    for case in case::load(&[]).expect("scenes") {
        let case = if samples() > 100 {
            case
        } else {
            case.at_most(60).expect("valid")
        };
        let (scene, size) = (&case.scene, case.size);
        let (lighting, film) = (Lighting::Shadowed, Film::Clamp);
        let proven = render_proven(scene, &case.view, size, lighting, film).expect("valid");
        assert_eq!(proven.undecided(), [], "{}", case.name);
        let reference = Reference::new(&case);
        for _ in 0..samples() {
            let (column, row) = (below(size.width()), below(size.height()));
            let Some(expected) = reference.pixel(&case, column, row) else {
                continue;
            };
            let found = proven.picture().pixel(column, row);
            assert_eq!(found, Some(expected), "{}: {column}, {row}", case.name);
            judged += 1;
            lit += usize::from(expected.iter().any(|&byte| byte != 0 && byte != 127));
        }
    }
    println!("{judged} pixels judged, {lit} of them lit");
    assert!(judged > 5 * 30 && lit > 30, "{judged} judged, {lit} lit");
}

/// The pixels that f32 cannot prove are the ones that are easy to get wrong.
#[test]
fn what_was_hard_to_prove_is_right() {
    for name in ["base", "base_moved_1e7", "three_lights"] {
        let case = &case::load(&[name.into()]).expect("a scene")[0];
        let case = if samples() > 100 {
            case.clone()
        } else {
            case.at_most(150).expect("valid")
        };
        let (lighting, film) = (Lighting::Shadowed, Film::Clamp);
        let proven = render_proven(&case.scene, &case.view, case.size, lighting, film);
        let proven = proven.expect("valid");
        let reference = Reference::new(&case);
        let width = case.size.width() as usize;
        let hard = (0..proven.rungs().len()).filter(|&i| proven.rungs()[i] != Rung::F32);
        for i in hard.take(10 * samples()) {
            let (column, row) = ((i % width) as u32, (i / width) as u32);
            if let Some(expected) = reference.pixel(&case, column, row) {
                let found = proven.picture().pixel(column, row);
                assert_eq!(found, Some(expected), "{name}: {column}, {row}");
            }
        }
    }
}
