//! The lab's chain with a hierarchy of boxes over its spheres: a measuring stick for the kit's plain
//! lists. It gives the same bytes, with the same kernels.

mod tree;

use fearless_simd::{Simd, dispatch};
use ombrage::{
    Chain, Film, Float, HitRecord, Invalid, LabChain, Lane, Lanes, Level, Mask, Object, Packet,
    Pair, PerspectiveCamera, Picture, Quality, Ray, Real, Scalar, Scene, Shadow, ShadowRay, Shape,
    Size, Span, Vector,
};
use tree::{Line, Tree};

/// The kernels that Figure 3(c) uses.
const QUALITY: Quality = Quality::Textbook;

/// A scene with a tree over its spheres, ready for rays.
pub struct Hierarchical<S: Scalar> {
    scene: Scene<S>,
    camera: PerspectiveCamera<S>,
    tree: Tree<S>,
}

/// A format that packets exist for.
pub trait InPackets: Float {
    /// Computes all bytes of a picture at a level.
    fn fill(picture: &Hierarchical<Self>, level: Level, size: Size, bytes: &mut [u8]);
}

impl<E: Lane> InPackets for E {
    fn fill(picture: &Hierarchical<E>, level: Level, size: Size, bytes: &mut [u8]) {
        match level.simd() {
            None => picture.rows::<E>((), size, bytes),
            Some(level) => dispatch!(level, simd => in_pairs(picture, simd, size, bytes)),
        }
    }
}

#[inline(always)]
fn in_pairs<L: Simd, E: Lane>(picture: &Hierarchical<E>, simd: L, size: Size, bytes: &mut [u8]) {
    picture.rows::<Pair<Packet<L, E>>>(simd, size, bytes);
}

impl<S: Scalar> Hierarchical<S> {
    /// Builds the tree.
    pub fn new(scene: &Scene<S>, camera: &PerspectiveCamera<S>) -> Self {
        Self {
            tree: Tree::over(scene.spheres()),
            scene: scene.clone(),
            camera: *camera,
        }
    }

    /// Renders a picture on one thread.
    ///
    /// # Errors
    /// None: there are three bytes a pixel.
    pub fn render(&self, level: Level, size: Size) -> Result<Picture, Invalid>
    where
        S: InPackets,
    {
        let mut bytes = vec![0; 3 * size.pixels()];
        S::fill(self, level, size, &mut bytes);
        Picture::new(size, &bytes)
    }

    /// All rows, each first to a row of its own that has room for the last packet.
    #[inline(always)]
    fn rows<R: Lanes<Scalar = S>>(&self, token: R::Token, size: Size, bytes: &mut [u8]) {
        let width = size.width();
        let places = 0..width.next_multiple_of(R::LANES as u32);
        let columns: Vec<S> = places
            .map(|i| <LabChain<'_, S> as Chain<S>>::coordinate(i.min(width - 1), width))
            .collect();
        let mut spare = vec![0; 3 * (columns.len() + R::SPILL)];
        for (row, target) in (0..).zip(bytes.chunks_exact_mut(3 * width as usize)) {
            let down = <LabChain<'_, S> as Chain<S>>::coordinate(row, size.height());
            let down = R::splat(token, down);
            for column in (0..columns.len()).step_by(R::LANES) {
                let across = R::load(token, &columns[column..]);
                let [red, green, blue] = self.radiance(across, down).to_array();
                let film = Film::Clamp;
                let rgb = [film.byte(red), film.byte(green), film.byte(blue)];
                R::store_rgb(rgb, &mut spare[3 * column..]);
            }
            target.copy_from_slice(&spare[..target.len()]);
        }
    }

    #[inline(always)]
    fn radiance<R: Real<Scalar = S>>(&self, across: R, down: R) -> R::Vector {
        let ray = self.camera.ray(across, down);
        let zero = across.constant(0.0);
        let background = R::Vector::splat(zero.token(), &self.scene.background());
        let span = Span::new(zero, R::splat(zero.token(), self.scene.t_max()));
        let hit = self.nearest(&ray, &span);
        if !hit.mask.any() {
            return background;
        }
        let mut sum = R::Vector::new(zero, zero, zero);
        for light in self.scene.lights() {
            let sample = light.sample::<R>(hit.point, QUALITY);
            let cosine = hit.normal.dot(sample.direction);
            let facing = hit.mask & cosine.gt(zero);
            if !facing.any() {
                continue;
            }
            let shadow = Shadow::UlpOffset;
            let shadow = shadow.ray(&self.scene, &hit, sample.direction, sample.distance);
            let visible = facing & !self.any(facing, &shadow);
            let lit = sum + hit.color * sample.radiance * cosine;
            sum = R::Vector::select(visible, lit, sum);
        }
        R::Vector::select(hit.mask, sum, background)
    }

    /// The nearest hit, as [`Scene::intersect`] finds it.
    #[inline(always)]
    fn nearest<R: Real<Scalar = S>>(&self, ray: &Ray<R>, span: &Span<R>) -> HitRecord<R> {
        let zero = span.min.constant(0.0);
        let mut nearest = HitRecord {
            mask: R::never(zero.token()),
            point: ray.origin,
            normal: ray.direction,
            distance: zero,
            object: zero,
            color: R::Vector::new(zero, zero, zero),
        };
        let (mut way, line) = (self.tree.start(), Line::of(ray));
        loop {
            let max = R::select(nearest.mask, nearest.distance, span.max);
            let Some(leaf) = self.tree.next_leaf(&mut way, &line, span.min, max) else {
                break;
            };
            for sphere in leaf {
                keep_nearer(&mut nearest, ray, span, sphere);
            }
        }
        for plane in self.scene.planes() {
            keep_nearer(&mut nearest, ray, span, plane);
        }
        nearest
    }

    /// Whether anything blocks a shadow ray, in the lanes that ask.
    #[inline(always)]
    fn any<R: Real<Scalar = S>>(&self, asked: R::Mask, shadow: &ShadowRay<R>) -> R::Mask {
        let ShadowRay { ray, span, .. } = shadow;
        let mut hit = R::never(span.max.token());
        for plane in self.scene.planes() {
            hit = hit | plane.shape.intersect_any(ray, span, QUALITY);
        }
        let (mut way, line) = (self.tree.start(), Line::of(ray));
        let nowhere = span.min.constant(-1.0);
        while (asked & !hit).any() {
            let open = R::select(asked & !hit, span.max, nowhere);
            let Some(leaf) = self.tree.next_leaf(&mut way, &line, span.min, open) else {
                break;
            };
            for sphere in leaf {
                hit = hit | sphere.shape.intersect_any(ray, span, QUALITY);
            }
        }
        hit
    }
}

/// Replaces the record where the ray meets the object sooner, as the kit's scenes do.
#[inline(always)]
fn keep_nearer<R: Real<Scalar: Scalar>, G: Shape<R::Scalar>>(
    nearest: &mut HitRecord<R>,
    ray: &Ray<R>,
    span: &Span<R>,
    object: &Object<R::Scalar, G>,
) {
    let hit = object.shape.intersect(ray, span, QUALITY);
    let nearer = hit.mask & (!nearest.mask | hit.t.lt(nearest.distance));
    if !nearer.any() {
        return;
    }
    let point = ray.point_at(hit.t);
    let outward = object.shape.normal_at::<R>(point);
    let away = outward.dot(ray.direction).gt(hit.t.constant(0.0));
    let normal = R::Vector::select(away, -outward, outward);
    let color = R::Vector::splat(hit.t.token(), &object.color());
    nearest.mask = nearest.mask | nearer;
    nearest.point = R::Vector::select(nearer, point, nearest.point);
    nearest.normal = R::Vector::select(nearer, normal, nearest.normal);
    nearest.distance = R::select(nearer, hit.t, nearest.distance);
    nearest.color = R::Vector::select(nearer, color, nearest.color);
}
