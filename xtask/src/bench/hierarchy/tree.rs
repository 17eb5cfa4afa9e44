//! A binary tree of boxes around spheres, split at the median of the widest axis.

use ombrage::{Mask, Object, Ray, Real, Scalar, Sphere, Vector};

/// The most spheres in a leaf.
const LEAF: usize = 4;

/// The deepest tree there can be: halves of a list that fits into memory.
const DEEPEST: usize = 64;

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
    Split(usize, usize, usize),
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
    fn grow(&mut self, first: usize, end: usize) -> usize {
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
        number
    }

    /// Starts along a ray.
    #[inline(always)]
    pub fn walk<R: Real<Scalar = S>>(&self, ray: &Ray<R>) -> Walk<'_, R> {
        let one = ray.origin.x().constant(1.0);
        let inverse = ray.direction.to_array().map(|x| one / x);
        Walk {
            tree: self,
            origin: ray.origin.to_array(),
            inverse,
            upward: inverse.map(|x| x.gt(x.constant(0.0)).any()),
            stack: [0; DEEPEST],
            depth: usize::from(!self.nodes.is_empty()),
        }
    }
}

/// A way through the tree along a ray, the nearer half first.
pub struct Walk<'a, R: Real> {
    tree: &'a Tree<R::Scalar>,
    origin: [R; 3],
    inverse: [R; 3],
    /// Whether the ray, in any lane, goes up along an axis.
    upward: [bool; 3],
    stack: [usize; DEEPEST],
    depth: usize,
}

impl<'a, R: Real> Walk<'a, R> {
    /// The spheres of the next leaf that any lane may meet between two parameters.
    #[inline(always)]
    pub fn next_leaf(&mut self, min: R, max: R) -> Option<&'a [Item<R::Scalar>]> {
        while self.depth > 0 {
            self.depth -= 1;
            let node = &self.tree.nodes[self.stack[self.depth]];
            if !self.meets(node, min, max).any() {
                continue;
            }
            match node.content {
                Content::Leaf(first, end) => return Some(&self.tree.spheres[first..end]),
                Content::Split(axis, lower, upper) => {
                    let order = if self.upward[axis] {
                        [upper, lower]
                    } else {
                        [lower, upper]
                    };
                    self.stack[self.depth..self.depth + 2].copy_from_slice(&order);
                    self.depth += 2;
                }
            }
        }
        None
    }

    /// The lanes that pass through the box (Kay and Kajiya, "Ray Tracing Complex Scenes", 1986).
    #[inline(always)]
    fn meets(&self, node: &Node<R::Scalar>, min: R, max: R) -> R::Mask {
        let (mut enter, mut leave) = (min, max);
        let token = min.token();
        let bounds = node.low.to_array().into_iter().zip(node.high.to_array());
        for (axis, (low, high)) in bounds.enumerate() {
            let at = |bound| (R::splat(token, bound) - self.origin[axis]) * self.inverse[axis];
            let (a, b) = (at(low), at(high));
            let rising = a.lt(b);
            let (near, far) = (R::select(rising, a, b), R::select(rising, b, a));
            enter = R::select(near.gt(enter), near, enter);
            leave = R::select(far.lt(leave), far, leave);
        }
        enter.le(leave)
    }
}
