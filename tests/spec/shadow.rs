//! Clauses 4.2 and 4.3: how a shadow ray leaves its surface.

use super::check::{Verdict, holds, ray, shows, span, vector};
use ombrage::{
    DirectLighting, Figure, Float, HitRecord, Integrator, Picture, Quality, Ray, Shadow,
    ShadowQuery, Size, Span, Vector, lab,
};

/// Clause 4.2: left alone, the shadow ray starts at the hit point and counts hits from 0 on.
pub fn check_4_2<F: Float>(
    leave: impl Fn(&HitRecord<F>, F::Vector, F) -> (Ray<F>, Span<F>),
) -> Verdict {
    let scene = lab::scene::<F>().map_err(|error| error.to_string())?;
    let hit = scene.intersect(
        &ray([0.0; 3], [0.0, -1.0, 0.0]),
        &span([0.0, 1000.0]),
        Quality::Textbook,
    );
    let (up, distance) = (vector::<F>([0.0, 1.0, 0.0]), F::from_f64(12.0));
    let (shadow_ray, interval) = leave(&hit, up, distance);
    holds!(
        "4.2",
        shadow_ray.origin == hit.point,
        "the ray starts at {:?}",
        shadow_ray.origin
    );
    holds!(
        "4.2",
        shadow_ray.direction == up,
        "the ray goes to {:?}",
        shadow_ray.direction
    );
    let zero = F::default();
    holds!("4.2", interval.contains(zero), "0 is not in {interval:?}");
    holds!(
        "4.2",
        !interval.contains(-F::from_bits(1)),
        "a number below 0 is in {interval:?}"
    );
    holds!(
        "4.2",
        interval.contains(distance),
        "the light's distance is not in {interval:?}"
    );
    let beyond = distance.step(F::from_f64(1.0));
    holds!(
        "4.2",
        !interval.contains(beyond),
        "a number beyond the light is in {interval:?}"
    );
    let blocked = scene.intersect_any(&shadow_ray, &interval, Quality::Textbook);
    holds!(
        "4.2",
        blocked,
        "a point exactly on the plane does not shadow itself"
    );
    Ok(())
}

fn start<F: Float>(
    shadow: Shadow,
    hit: &HitRecord<F>,
    direction: F::Vector,
    distance: F,
) -> (Ray<F>, Span<F>) {
    let scene = lab::scene::<F>().expect("the lab's scene is valid");
    let shadow = shadow.ray(&scene, hit, direction, distance);
    (shadow.ray, shadow.span)
}

pub fn kit_self_hitting<F: Float>(
    hit: &HitRecord<F>,
    direction: F::Vector,
    distance: F,
) -> (Ray<F>, Span<F>) {
    start(Shadow::SelfHitting, hit, direction, distance)
}

pub fn half_open_interval<F: Float>(
    hit: &HitRecord<F>,
    direction: F::Vector,
    distance: F,
) -> (Ray<F>, Span<F>) {
    let (ray, span) = start(Shadow::SelfHitting, hit, direction, distance);
    (
        ray,
        Span {
            min: F::from_bits(1),
            ..span
        },
    )
}

pub fn endless_interval<F: Float>(
    hit: &HitRecord<F>,
    direction: F::Vector,
    distance: F,
) -> (Ray<F>, Span<F>) {
    let (ray, span) = start(Shadow::SelfHitting, hit, direction, distance);
    (
        ray,
        Span {
            max: F::MAX,
            ..span
        },
    )
}

pub fn moved_away<F: Float>(
    hit: &HitRecord<F>,
    direction: F::Vector,
    distance: F,
) -> (Ray<F>, Span<F>) {
    start(Shadow::UlpOffset, hit, direction, distance)
}

/// How a ray is moved off its surface, and the figure with such rays.
pub struct Leaving<F: Float> {
    offset: fn(&Ray<F>, F::Vector) -> Ray<F>,
    figure: fn() -> Picture,
}

/// Clause 4.3: the origin moves a little along the normal.
pub fn check_4_3<F: Float>(leaving: impl Fn() -> Leaving<F>) -> Verdict {
    let Leaving { offset, figure } = leaving();
    for p in [-1000.0, -2.0, -0.03, 0.0, 0.01, 1.0, 3.7, 1e6] {
        for axis in 0..3 {
            for sign in [1.0, -1.0] {
                let on_axis =
                    |value: f64| std::array::from_fn(|i| if i == axis { value } else { 0.5 });
                let normal = std::array::from_fn(|i| if i == axis { sign } else { 0.0 });
                let start = ray::<F>(on_axis(p), [0.0, 0.6, 0.8]);
                let moved = offset(&start, vector::<F>(normal));
                holds!(
                    "4.3",
                    moved.direction == start.direction,
                    "the direction changes at {p}"
                );
                let distance = (moved.origin - start.origin).to_array();
                let along = distance[axis].to_f64() * sign;
                holds!(
                    "4.3",
                    along > 0.0,
                    "at {p} the origin moves by {along} along the normal"
                );
                // 256 places of at most EPSILON times the coordinate; twice that past a power of 2
                let most = 512.0 * F::EPSILON * p.abs().max(0.5);
                holds!(
                    "4.3",
                    along <= most,
                    "at {p} the origin moves by {along}, more than {most}"
                );
                let aside = (0..3)
                    .filter(|&i| i != axis)
                    .all(|i| distance[i] == F::default());
                holds!(
                    "4.3",
                    aside,
                    "at {p} the origin moves aside by {distance:?}"
                );
            }
        }
    }
    let visible = |seen: &super::check::Seen| if seen.shadowed { 0.0 } else { seen.direct };
    let right = shows(&figure(), visible, |level| level as u8);
    holds!(
        "4.3",
        right.is_ok(),
        "Figure 3(c) in {}: {right:?}",
        F::NAME
    );
    Ok(())
}

fn draw<F: Float>(shadow: Option<Shadow>) -> Picture {
    let query = ShadowQuery::Any;
    let integrator = Integrator::DirectLighting(DirectLighting {
        quality: Quality::Textbook,
        shadow,
        query,
    });
    let figure = Figure::named("3c").expect("one of the six figures");
    let figure = Figure {
        integrator,
        ..*figure
    };
    figure
        .draw::<F>(Size::LAB)
        .expect("the lab's scene is valid")
}

pub fn kit_offset<F: Float>() -> Leaving<F> {
    let figure = || {
        let figure = Figure::named("3c").expect("one of the six figures");
        figure
            .draw::<F>(Size::LAB)
            .expect("the lab's scene is valid")
    };
    Leaving {
        offset: |ray, normal| ray.offset(normal),
        figure,
    }
}

pub fn not_moved<F: Float>() -> Leaving<F> {
    Leaving {
        offset: |ray, _| *ray,
        ..kit_offset()
    }
}

pub fn against_the_normal<F: Float>() -> Leaving<F> {
    Leaving {
        offset: |ray, normal| ray.offset(-normal),
        ..kit_offset()
    }
}

pub fn a_tenth_of_the_normal<F: Float>() -> Leaving<F> {
    let offset = |ray: &Ray<F>, normal: F::Vector| Ray {
        origin: ray.origin + normal * F::from_f64(0.1),
        ..*ray
    };
    Leaving {
        offset,
        ..kit_offset()
    }
}

pub fn figure_with_acne<F: Float>() -> Leaving<F> {
    Leaving {
        figure: || draw::<F>(Some(Shadow::SelfHitting)),
        ..kit_offset()
    }
}

pub fn figure_without_shadow<F: Float>() -> Leaving<F> {
    Leaving {
        figure: || draw::<F>(None),
        ..kit_offset()
    }
}
