//! Proven pictures of random scenes: what a proof in one precision says, no higher one contradicts.

use super::sabotage::{EarlyChoices, EarlyComparisons, SmallBounds};
use crate::property::{Verdict, fails, for_all, number, positive};
use glam::DVec3;
use ombrage::{
    Chain, DoubleDouble, Film, Invalid, Lighting, PerspectiveCamera, Plane, PointLight, Proof,
    Prover, Relative, Rigorous, Rung, Scene, Size, Sphere, View, render_proven,
};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use std::cell::Cell;

/// A picture to prove.
#[derive(Clone, Debug)]
struct Subject {
    scene: Scene<f64>,
    view: View<f64>,
    size: Size,
    lighting: Lighting,
    film: Film,
}

/// Whole numbers, which make ties, and any.
fn point() -> impl Strategy<Value = DVec3> + Clone {
    let whole = [-3..=3i8, -3..=3i8, -3..=3i8].prop_map(|p| DVec3::from(p.map(f64::from)));
    let any = [-3..3, -3..3, -3..3].map(number::<f64>);
    prop_oneof![whole, any.prop_map(DVec3::from)]
}

fn length() -> impl Strategy<Value = f64> + Clone {
    prop_oneof![(1..=3u8).prop_map(f64::from), positive::<f64>(-2..2)]
}

fn color() -> impl Strategy<Value = DVec3> + Clone {
    [0.0..1.0f64, 0.0..1.0, 0.0..1.0].prop_map(DVec3::from)
}

type Ball = (DVec3, f64, DVec3);

/// Where the camera and the first light are, and what there is twice: as they come, or in a place
/// where a sign is zero.
fn arranged(
    (mut spheres, planes): (Vec<Ball>, Vec<(DVec3, DVec3, DVec3)>),
    mut lights: Vec<(DVec3, DVec3, f64)>,
    mut view: View<f64>,
    way: u8,
) -> Result<(Scene<f64>, View<f64>), Invalid> {
    let light = lights[0].0;
    if let Some(&(center, radius, color)) = spheres.first() {
        match way {
            0 => view.position = center,
            1 => view.position = center - radius * DVec3::Z,
            2 => lights[0].0 = center + radius * DVec3::Y,
            3 => lights[0].0 = center,
            4 => spheres.push((center, radius, DVec3::ONE - color)),
            _ => {}
        }
    }
    match (way, planes.first()) {
        (5, Some(&(point, ..))) => view.position = point,
        (6, Some(&(point, ..))) => lights[0].0 = point,
        (7, _) => view.position = light,
        _ => {}
    }
    let mut scene = Scene::new(
        DVec3::splat(0.3),
        if way == 8 { 4.0 } else { f64::INFINITY },
    )?;
    for (center, radius, color) in spheres {
        scene = scene.with_sphere(Sphere::new(center, radius)?, color)?;
    }
    for (point, normal, color) in planes {
        scene = scene.with_plane(Plane::new(point, normal)?, color)?;
    }
    for (position, color, power) in lights {
        scene = scene.with_light(PointLight::new(position, color, power)?);
    }
    Ok((scene, view))
}

fn subjects() -> impl Strategy<Value = Subject> {
    let objects = (
        vec((point(), length(), color()), 0..4),
        vec((point(), point(), color()), 0..3),
    );
    let lights = vec((point(), color(), positive::<f64>(0..6)), 1..4);
    let fov = prop_oneof![select(vec![30.0, 45.0, 60.0, 90.0, 120.0]), 5.0..170.0f64];
    let view = (point(), point(), point(), fov);
    let view = view.prop_map(|(position, look_at, up, fov)| View {
        position,
        look_at,
        up,
        fov,
    });
    let lighting = select(vec![
        Lighting::Shadowed,
        Lighting::Shadowed,
        Lighting::Unshadowed,
        Lighting::Eye,
    ]);
    let kind = (
        1..=24u32,
        1..=24u32,
        lighting,
        select(vec![Film::Clamp, Film::Wrap]),
    );
    let scene = (objects, lights, view, 0..16u8);
    let scene = scene.prop_filter_map("a scene", |(objects, lights, view, way)| {
        arranged(objects, lights, view, way).ok()
    });
    let near = (0.0..1.0f64, 0.0..1.0f64, 0..4u8);
    (scene, kind, near).prop_filter_map("a view", |((scene, view), kind, near)| {
        let (width, height, lighting, film) = kind;
        let subject = Subject {
            scene,
            view,
            size: Size::new(width, height).ok()?,
            lighting,
            film,
        };
        let (across, down, wanted) = near;
        let place = |at: f64, count: u32| (at * f64::from(count)) as u32;
        let (column, row) = (place(across, width), place(down, height));
        let border = subject.at_a_border(column, row)?;
        match wanted {
            0 | 1 => Some(border),
            2 => subject.at_an_edge(column, row),
            _ => Some(subject),
        }
    })
}

impl Subject {
    /// The same with colours that put a pixel as near to the border of two bytes as `f64` can: no
    /// proof but the last ones may say on which side it is. `None` if the view is not valid.
    fn at_a_border(&self, column: u32, row: u32) -> Option<Self> {
        let Self {
            scene, view, size, ..
        } = self;
        let chain = Relative::<f64>::new(scene, view, *size, self.lighting).ok()?;
        let across = Relative::<f64>::coordinate(column, size.width());
        let down = Relative::<f64>::coordinate(row, size.height());
        let level = 255.0 * chain.radiance::<f64>(across, down).max_element();
        let factor = level.round().max(1.0) / level;
        if !(0.01..100.0).contains(&factor) {
            return Some(self.clone());
        }
        self.with(factor, Some)
    }

    /// The same with spheres that the ray of a pixel touches, as far as `f64` can say. `None` if there
    /// is no such sphere.
    fn at_an_edge(&self, column: u32, row: u32) -> Option<Self> {
        let Self { view, size, .. } = self;
        let camera = PerspectiveCamera::new(view, size.aspect()).ok()?;
        let place = |i: u32, count: u32| f64::from(i) / f64::from((count - 1).max(1));
        let ray = camera.ray::<f64>(place(column, size.width()), place(row, size.height()));
        self.with(1.0, |sphere| {
            let distance = (sphere.center() - ray.origin).cross(ray.direction).length();
            Sphere::new(sphere.center(), distance).ok()
        })
    }

    /// The same with colours times a factor, and other spheres.
    fn with(
        &self,
        factor: f64,
        other: impl Fn(Sphere<f64>) -> Option<Sphere<f64>>,
    ) -> Option<Self> {
        let mut changed = Scene::new(self.scene.background(), self.scene.t_max()).ok()?;
        for sphere in self.scene.spheres() {
            let color = sphere.color() * factor;
            changed = changed.with_sphere(other(sphere.shape)?, color).ok()?;
        }
        for plane in self.scene.planes() {
            let color = plane.color() * factor;
            changed = changed.with_plane(plane.shape, color).ok()?;
        }
        for &light in self.scene.lights() {
            changed = changed.with_light(light);
        }
        Some(Self {
            scene: changed,
            ..self.clone()
        })
    }
}

/// How many pixels each rung proved.
type Counts = [usize; 5];

/// Every proof of a pixel gives the same bytes: in `f32` by the rule `P`, in `f64`, in double-double
/// and, where [`render_proven`] came to it, exactly.
fn proofs_agree<P: Proof>(subject: &Subject, counts: &Cell<Counts>) -> Verdict {
    let &Subject {
        ref scene,
        ref view,
        size,
        lighting,
        film,
    } = subject;
    let valid = |invalid: Invalid| TestCaseError::fail(invalid.to_string());
    let proven = render_proven(scene, view, size, lighting, film).map_err(valid)?;
    let single = Prover::<f32, P>::new(scene, view, size, lighting, film).map_err(valid)?;
    let double = Prover::<f64>::new(scene, view, size, lighting, film).map_err(valid)?;
    let wide = Prover::<DoubleDouble>::new(scene, view, size, lighting, film).map_err(valid)?;
    let mut count = counts.get();
    for (i, rung) in (0..).zip(proven.rungs()) {
        let (column, row) = (i % size.width(), i / size.width());
        count[rung as usize] += 1;
        let rendered = proven.picture().pixel(column, row);
        let proofs = [
            single.pixel(column, row),
            double.pixel(column, row),
            wide.pixel(column, row),
            rendered.filter(|_| rung != Rung::Undecided),
        ];
        let mut bytes = proofs.iter().flatten();
        let first = bytes.next();
        prop_assert!(
            bytes.all(|other| Some(other) == first),
            "column {column}, row {row}, {rung:?}: {proofs:?}"
        );
    }
    counts.set(count);
    Ok(())
}

pub fn no_proof_contradicts_a_higher_one() {
    let counts = Cell::new([0; 5]);
    let scenes = Cell::new(0);
    for_all(subjects(), |subject| {
        scenes.set(scenes.get() + 1);
        proofs_agree::<Rigorous>(&subject, &counts)
    });
    let (counts, scenes) = (counts.get(), scenes.get());
    println!("{scenes} scenes, pixels by rung: {counts:?}");
    let [single, double, wide, _, undecided] = counts;
    assert!(single > 4 * scenes, "{single} of {scenes} scenes in f32");
    assert!(double + wide > scenes / 16, "{double} in f64, {wide} wider");
    assert!(undecided <= scenes / 4, "{undecided} undecided");
}

pub fn random_scenes_find_out_a_false_proof() {
    fn is_found<P: Proof>() -> bool {
        let counts = Cell::new([0; 5]);
        fails(subjects(), |subject| proofs_agree::<P>(&subject, &counts))
    }
    assert!(is_found::<SmallBounds>(), "bounds");
    assert!(is_found::<EarlyComparisons>(), "comparisons");
    assert!(is_found::<EarlyChoices>(), "choices");
}
