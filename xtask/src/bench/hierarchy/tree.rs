//! A binary tree of boxes around spheres, split at the median of the widest axis.

use ombrage::{Mask, Object, Ray, Real, Scalar, Sphere, Vector};

/// The most spheres in a leaf.
const LEAF: usize = 4;

/// The most nodes that wait: one a level, of a tree over fewer than 2^32 spheres.
const DEEPEST: usize = 32;

/// A sphere of a scene, with its colour.
type Item<S> = Object<S, Sphere<S>>;

/// A tree over the spheres of a scene.
pub struct Tree<S: Scalar> {
    nodes: Vec<Node<S>>,
    spheres: Vec<Item<S>>,
}

/// A box, and what is in it.
struct Node<S: Scalar> {
    low: S::Vector,
    high: S::Vector,
    content: Content,
}

#[derive(Clone, Copy)]
enum Content {
    /// Spheres from the first to before the last.
    Leaf(usize, usize),
    /// The axis of the split, the node with the lower half, and the one with the upper.
    Split(usize, u32, u32),
}

impl<S: Scalar> Tree<S> {
    /// Builds it.
    pub fn over(spheres: &[Item<S>]) -> Self {
        let mut tree = Self {
            nodes: vec![],
            spheres: spheres.to_vec(),
        };
        if !spheres.is_empty() {
            tree.grow(0, spheres.len());
        }
        tree
    }

    /// Adds the node of some spheres and returns its number.
    fn grow(&mut self, first: usize, end: usize) -> u32 {
        let spheres = &mut self.spheres[first..end];
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        for sphere in &*spheres {
            // Wider by a little than the sphere, so that no rounding of the box test loses a hit.
            let radius = sphere.shape.radius().to_f64() * (1.0 + 1.0 / 256.0);
            let center = sphere.shape.center().to_array().map(S::to_f64);
            for axis in 0..3 {
                low[axis] = low[axis].min(center[axis] - radius);
                high[axis] = high[axis].max(center[axis] + radius);
            }
        }
        let wide = |axis: &usize| high[*axis] - low[*axis];
        let axis = (0..3)
            .max_by(|a, b| wide(a).total_cmp(&wide(b)))
            .unwrap_or(0);
        let number = self.nodes.len();
        self.nodes.push(Node {
            low: Vector::constant((), low),
            high: Vector::constant((), high),
            content: Content::Leaf(first, end),
        });
        if end - first > LEAF {
            let place = |sphere: &Item<S>| sphere.shape.center().to_array()[axis].to_f64();
            let middle = spheres.len() / 2;
            spheres.select_nth_unstable_by(middle, |a, b| place(a).total_cmp(&place(b)));
            let lower = self.grow(first, first + middle);
            let upper = self.grow(first + middle, end);
            self.nodes[number].content = Content::Split(axis, lower, upper);
        }
        number as u32
    }

    /// A way that starts at the root.
    #[inline(always)]
    pub fn start(&self) -> Way {
        Way {
            ahead: [0; DEEPEST],
            count: usize::from(!self.nodes.is_empty()),
        }
    }

    /// The spheres of the next leaf on the way that any lane may meet between two parameters.
    #[inline(always)]
    pub fn next_leaf<R: Real<Scalar = S>>(
        &self,
        way: &mut Way,
        line: &Line<R>,
        min: R,
        max: R,
    ) -> Option<&[Item<S>]> {
        while way.count > 0 {
            way.count -= 1;
            let node = &self.nodes[way.ahead[way.count] as usize];
            if !line.meets(node, min, max).any() {
                continue;
            }
            match node.content {
                Content::Leaf(first, end) => return Some(&self.spheres[first..end]),
                Content::Split(axis, lower, upper) => {
                    let [later, sooner] = match line.upward[axis] {
                        true => [upper, lower],
                        false => [lower, upper],
                    };
                    way.ahead[way.count] = later;
                    way.ahead[way.count + 1] = sooner;
                    way.count += 2;
                }
            }
        }
        None
    }
}

/// The nodes that a ray has still to visit, the nearer half last.
pub struct Way {
    ahead: [u32; DEEPEST],
    count: usize,
}

/// A ray as boxes see it.
pub struct Line<R: Real> {
    origin: R::Vector,
    inverse: R::Vector,
    /// Whether the ray, in any lane, goes up along an axis.
    upward: [bool; 3],
}

impl<R: Real<Scalar: Scalar>> Line<R> {
    /// The line of a ray.
    #[inline(always)]
    pub fn of(ray: &Ray<R>) -> Self {
        let (zero, one) = (ray.origin.x().constant(0.0), ray.origin.x().constant(1.0));
        let [x, y, z] = ray.direction.to_array();
        Self {
            origin: ray.origin,
            inverse: Vector::new(one / x, one / y, one / z),
            upward: [x.gt(zero).any(), y.gt(zero).any(), z.gt(zero).any()],
        }
    }

    /// The lanes that pass through the box (Kay and Kajiya, "Ray Tracing Complex Scenes", 1986).
    #[inline(always)]
    fn meets(&self, node: &Node<R::Scalar>, min: R, max: R) -> R::Mask {
        let token = min.token();
        let low = R::Vector::splat(token, &node.low) - self.origin;
        let high = R::Vector::splat(token, &node.high) - self.origin;
        let (a, b) = (low * self.inverse, high * self.inverse);
        let (enter, leave) = narrowed(min, max, a.x(), b.x());
        let (enter, leave) = narrowed(enter, leave, a.y(), b.y());
        let (enter, leave) = narrowed(enter, leave, a.z(), b.z());
        enter.le(leave)
    }
}

/// What is left of an interval between two planes, met in either order.
#[inline(always)]
fn narrowed<R: Real>(enter: R, leave: R, a: R, b: R) -> (R, R) {
    let rising = a.lt(b);
    let (near, far) = (R::select(rising, a, b), R::select(rising, b, a));
    (
        R::select(near.gt(enter), near, enter),
        R::select(far.lt(leave), far, leave),
    )
}
