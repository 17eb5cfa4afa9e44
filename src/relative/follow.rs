//! What happens at one pixel of the ray-relative chain, decided by the kernels that draw it.

use super::Relative;
use crate::chain::Chain;
use crate::real::Scalar;
use crate::survey::Pixel;
use crate::vector::Vector;

impl<S: Scalar> Relative<S> {
    /// What happens at a point of the picture, given by the coordinates of its column and its row.
    ///
    /// No surface is ever asked whether it blocks its own light, so `blocked_by_itself` is false. A
    /// light that a surface separates from the camera was left out once a frame; here it is one
    /// that the surface does not face. The level is that of the radiance.
    pub fn follow(&self, across: S, down: S) -> Pixel {
        let direction = self.across::<S>(across) + self.down::<S>(down);
        let mut pixel = Pixel {
            level: Pixel::level_of::<S>(self.radiance(across, down)),
            ..Pixel::default()
        };
        let Some(hit) = self.nearest::<S>(direction, direction.square()) else {
            return pixel;
        };
        if !hit.meeting.mask {
            return pixel;
        }
        let object = hit.meeting.number.to_f64() as usize;
        pixel.object = Some(object);
        pixel.on_sphere = object < self.first_plane;
        for light in self.lights.iter().flatten() {
            let facing = light.height(&hit).gt(S::from_f64(0.0));
            pixel.faces_light |= facing;
            pixel.blocked_by_another |= facing && light.blocked_on_the_way(&hit, direction);
        }
        pixel
    }
}
