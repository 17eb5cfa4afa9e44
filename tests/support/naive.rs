//! A plain ray tracer of the lab's scene with a switch for every mistake: what the diagnosis is
//! tested with. It shares no code with the library, and computes in `f32`, in the order in which a
//! student would write it down.

/// What one picture is drawn with.
#[derive(Clone, Copy, Debug)]
pub struct Naive {
    pub width: u32,
    pub height: u32,
    /// Samples a side of a pixel, 0: one at its corner or middle.
    pub side: u32,
    /// Whether the samples in a pixel are random.
    pub random: bool,
    /// Samples go through the pixel's middle, not its corner.
    pub middle: bool,
    /// Coordinates are divided by w, not w - 1.
    pub over_width: bool,
    pub round: bool,
    pub t_max: f32,
    /// Figure 1.
    pub at_eye: bool,
    pub shadows: bool,
    /// Shadow rays start at the hit point, and hits count from 0 on; of the sphere and the plane.
    pub acne: [bool; 2],
    pub offset: f32,
    pub shift: [f32; 3],
    pub shadow_light: Option<[f32; 3]>,
    pub clamp: bool,
    pub saturate: bool,
    pub clamp_cosine: bool,
    pub falloff: i32,
    pub power: f32,
    pub over_pi: bool,
    pub plane: bool,
    pub flip: bool,
    pub mirror: bool,
    pub upside_down: bool,
    /// 0: none; 1: sRGB; 2: 2.2.
    pub gamma: u32,
    pub swap: bool,
    pub sphere_color: [f32; 3],
    pub plane_color: [f32; 3],
    pub background: [f32; 3],
    pub fov: f32,
    pub sphere: [f32; 4],
    pub plane_y: f32,
    pub light: [f32; 3],
    pub eye: [f32; 3],
}

type V = [f32; 3];

fn add(a: V, b: V) -> V {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn sub(a: V, b: V) -> V {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn scale(a: V, s: f32) -> V {
    [a[0] * s, a[1] * s, a[2] * s]
}

fn dot(a: V, b: V) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn normalize(a: V) -> V {
    scale(a, 1.0 / dot(a, a).sqrt())
}

impl Naive {
    /// A right figure: `1`, `2a`, `2b`, `3a` or `3c`.
    pub fn figure(name: &str, width: u32, height: u32) -> Self {
        Naive {
            width,
            height,
            side: 0,
            random: false,
            middle: false,
            over_width: false,
            round: false,
            t_max: 1000.0,
            at_eye: name == "1",
            shadows: name.starts_with('3'),
            acne: [name == "3a"; 2],
            offset: 1e-4,
            shift: [0.0; 3],
            shadow_light: None,
            clamp: name != "2a",
            saturate: false,
            clamp_cosine: true,
            falloff: 2,
            power: 100.0,
            over_pi: false,
            plane: true,
            flip: false,
            mirror: false,
            upside_down: false,
            gamma: 0,
            swap: false,
            sphere_color: [0.0, 0.0, 1.0],
            plane_color: [1.0, 0.0, 0.0],
            background: [0.5; 3],
            fov: 60.0,
            sphere: [0.0, 0.0, 3.0, 1.0],
            plane_y: -2.0,
            light: [1.0, 10.0, 1.0],
            eye: [0.0, 0.0, -2.0],
        }
    }

    /// The picture: width x height x 3 bytes, row-major.
    pub fn draw(&self) -> Vec<u8> {
        let mut seed = 0x9e37_79b9_u32;
        let mut random = || {
            seed ^= seed << 13;
            seed ^= seed >> 17;
            seed ^= seed << 5;
            (seed >> 8) as f32 / (1 << 24) as f32
        };
        let mut bytes = vec![];
        for row in 0..self.height {
            let j = if self.upside_down {
                self.height - 1 - row
            } else {
                row
            };
            for column in 0..self.width {
                let i = if self.mirror {
                    self.width - 1 - column
                } else {
                    column
                };
                let mut sum = [0.0; 3];
                let side = self.side.max(1);
                for sub_row in 0..side {
                    for sub_column in 0..side {
                        let within = match (self.side, self.random) {
                            (0, false) if self.middle => [0.5, 0.5],
                            (0, false) => [0.0, 0.0],
                            (_, true) => [random(), random()],
                            (n, false) => {
                                [sub_column, sub_row].map(|k| (k as f32 + 0.5) / n as f32)
                            }
                        };
                        sum = add(sum, self.trace(i as f32 + within[0], j as f32 + within[1]));
                    }
                }
                let color = scale(sum, 1.0 / (side * side) as f32);
                let [r, g, b] = color.map(|x| self.byte(x));
                bytes.extend(if self.swap { [b, g, r] } else { [r, g, b] });
            }
        }
        bytes
    }

    fn byte(&self, x: f32) -> u8 {
        let mut x = x;
        if self.clamp {
            x = x.clamp(0.0, 1.0);
        }
        x = match self.gamma {
            1 if x <= 0.003_130_8 => 12.92 * x,
            1 => 1.055 * x.powf(1.0 / 2.4) - 0.055,
            2 => x.powf(1.0 / 2.2),
            _ => x,
        };
        let level = if self.round {
            (x * 255.0).round()
        } else {
            x * 255.0
        };
        if self.saturate {
            level as u8
        } else {
            (level as i32) as u8
        }
    }

    fn trace(&self, px: f32, py: f32) -> V {
        let (w, h) = (self.width as f32, self.height as f32);
        let less = if self.over_width { 0.0 } else { 1.0 };
        let (sx, sy) = (px / (w - less), py / (h - less));
        let tall = (self.fov.to_radians() / 2.0).tan();
        let direction = normalize([
            -(2.0 * sx - 1.0) * tall * w / h,
            (1.0 - 2.0 * sy) * tall,
            1.0,
        ]);
        let Some((t, is_sphere)) = self.nearest(self.eye, direction, 0.0, self.t_max) else {
            return self.background;
        };
        let point = add(self.eye, scale(direction, t));
        let mut normal = self.normal(point, direction, is_sphere);
        if self.flip {
            normal = scale(normal, -1.0);
        }
        let color = if is_sphere {
            self.sphere_color
        } else {
            self.plane_color
        };
        if self.at_eye {
            let cosine = dot(normal, scale(direction, -1.0));
            return scale(
                color,
                if self.clamp_cosine {
                    cosine.max(0.0)
                } else {
                    cosine
                },
            );
        }
        let to_light = sub(self.light, point);
        let distance = dot(to_light, to_light).sqrt();
        let l = scale(to_light, 1.0 / distance);
        if self.shadows && self.is_blocked(point, normal, is_sphere) {
            return [0.0; 3];
        }
        let mut cosine = dot(normal, l);
        if self.clamp_cosine {
            cosine = cosine.max(0.0);
        }
        let mut radiance = self.power / distance.powi(self.falloff);
        if self.over_pi {
            radiance /= std::f32::consts::PI;
        }
        scale(color, radiance * cosine)
    }

    fn is_blocked(&self, point: V, normal: V, is_sphere: bool) -> bool {
        let acne = self.acne[usize::from(!is_sphere)];
        let from = if acne {
            point
        } else {
            add(point, scale(normal, self.offset))
        };
        let from = add(from, self.shift);
        let to_light = sub(self.shadow_light.unwrap_or(self.light), from);
        let distance = dot(to_light, to_light).sqrt();
        let direction = scale(to_light, 1.0 / distance);
        self.nearest(from, direction, 0.0, distance).is_some()
    }

    fn normal(&self, point: V, direction: V, is_sphere: bool) -> V {
        let [x, y, z, _] = self.sphere;
        let outward = if is_sphere {
            normalize(sub(point, [x, y, z]))
        } else {
            [0.0, 1.0, 0.0]
        };
        if dot(outward, direction) > 0.0 {
            scale(outward, -1.0)
        } else {
            outward
        }
    }

    /// The nearest hit, and whether it is the sphere.
    fn nearest(&self, origin: V, direction: V, t_min: f32, t_max: f32) -> Option<(f32, bool)> {
        let mut best: Option<(f32, bool)> = None;
        let [x, y, z, radius] = self.sphere;
        let from_center = sub(origin, [x, y, z]);
        let a = dot(direction, direction);
        let b = 2.0 * dot(direction, from_center);
        let c = dot(from_center, from_center) - radius * radius;
        let discriminant = b * b - 4.0 * a * c;
        if discriminant >= 0.0 {
            let root = discriminant.sqrt();
            for t in [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)] {
                if best.is_none() && t >= t_min && t <= t_max {
                    best = Some((t, true));
                }
            }
        }
        if self.plane {
            let t = (self.plane_y - origin[1]) / direction[1];
            if t >= t_min && t <= t_max && best.is_none_or(|(nearest, _)| t < nearest) {
                best = Some((t, false));
            }
        }
        best
    }
}
