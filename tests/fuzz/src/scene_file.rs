use ombrage::{
    Engine, Film, LabChain, Level, Lighting, PerspectiveCamera, Quality, Relative, Scalar, Shadow,
    Size, View,
};
use std::num::NonZero;
use std::path::Path;
use xtask::case;
use xtask::scene_file::{self, SceneFile};

/// A scene file is drawn in every way, with the same bytes at every level; or it is refused in one
/// line that names the file and the line.
pub fn scene_file(bytes: &[u8]) {
    match scene_file::parse(Path::new("any.toml"), bytes.to_vec()) {
        Ok(file) => {
            draw::<f32>(&file);
            draw::<f64>(&file);
        }
        Err(error) => {
            let message = error.to_string();
            let rest = message.strip_prefix("any.toml:");
            let line = rest.and_then(|rest| rest.split_once(':')?.0.parse().ok());
            assert!(line.is_some_and(|line: usize| line > 0), "{message}");
            assert_eq!(message.lines().count(), 1, "{message}");
        }
    }
}

fn draw<S: Scalar>(file: &SceneFile) {
    let size = Size::new(5, 3).expect("a size");
    let one = NonZero::new(1);
    let scalar = Engine::new(Level::Scalar, one).expect("every machine has it");
    let best = Engine::new(Level::best(), one).expect("this machine has it");
    for lighting in [Lighting::Eye, Lighting::Shadowed] {
        let chain = Relative::<S>::new(&file.scene, &file.view, size, lighting);
        let Ok(chain) = chain else { continue };
        let same =
            scalar.render(&chain, size, Film::Clamp) == best.render(&chain, size, Film::Clamp);
        let level = best.level();
        assert!(same, "{lighting:?} differs at {level} in {}", S::NAME);
    }
    let view: View<S> = file.view.cast();
    let camera = PerspectiveCamera::new(&view, S::from_f64(size.aspect()));
    let (Ok(scene), Ok(camera)) = (file.scene.cast::<S>(), camera) else {
        return;
    };
    for quality in Quality::ALL {
        for shadow in Shadow::ALL {
            let chain = LabChain {
                scene: &scene,
                camera: &camera,
                integrator: case::direct(quality, Some(shadow)),
            };
            let same =
                scalar.render(&chain, size, Film::Wrap) == best.render(&chain, size, Film::Wrap);
            let level = best.level();
            assert!(same, "{quality:?} {shadow:?} at {level} in {}", S::NAME);
        }
    }
}
