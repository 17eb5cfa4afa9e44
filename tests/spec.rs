//! Every clause of docs/spec.md: a control case that conforms, and failing twins - wrong variants
//! that the same check must reject, with the clause's name.

#[path = "support/report.rs"]
mod report;

mod spec {
    pub mod any_hit;
    pub mod camera;
    pub mod check;
    pub mod counted;
    pub mod engine;
    pub mod light;
    pub mod lighting;
    pub mod plane;
    pub mod shadow;
}

/// For each clause a module of tests in both floats: `conforms::*` and `rejects::*`.
macro_rules! clauses {
    ($($id:literal $clause:ident: $file:ident::$check:ident
        conforms [$($kit:ident)*] rejects [$($twin:ident)*];)*) => {
        /// The clauses that have tests, and the tests' modules.
        const TESTED: &[(&str, &str)] = &[$(($id, stringify!($clause))),*];

        $(mod $clause {
            clauses!(@float f32 $id $file::$check [$($kit)*] [$($twin)*]);
            clauses!(@float f64 $id $file::$check [$($kit)*] [$($twin)*]);
        })*
    };
    (@float $float:ident $id:literal $file:ident::$check:ident
        [$($kit:ident)*] [$($twin:ident)*]) => {
        mod $float {
            mod conforms {
                use crate::spec::$file::{self, $check};
                type F = core::primitive::$float;

                $(#[test]
                fn $kit() {
                    if let Err(words) = $check::<F>($file::$kit::<F>) {
                        panic!("{words}");
                    }
                })*
            }

            mod rejects {
                use crate::spec::$file::{self, $check};
                type F = core::primitive::$float;

                $(#[test]
                fn $twin() {
                    let words = $check::<F>($file::$twin::<F>)
                        .expect_err(concat!("clause ", $id, ": a wrong variant passes"));
                    let named = words.starts_with(concat!("clause ", $id, ": "));
                    assert!(named, "the check names another clause than {}: {words}", $id);
                })*
            }
        }
    };
}

clauses! {
    "1.1" clause_1_1: plane::check_1_1
        conforms [kit_t]
        rejects [culled_from_behind not_divided parallel_is_a_hit open_at_its_start];
    "1.2" clause_1_2: plane::check_1_2
        conforms [kit_intersect]
        rejects [normal_as_stored normal_of_any_length farthest_hit];
    "1.3" clause_1_3: plane::check_1_3
        conforms [kit_figure_1]
        rejects [plane_too_low plane_not_red];
    "2.1" clause_2_1: light::check_2_1
        conforms [kit_sample]
        rejects [power_ignored color_ignored];
    "2.2" clause_2_2: light::check_2_2
        conforms [kit_sample]
        rejects [from_one_direction];
    "2.3" clause_2_3: light::check_2_3
        conforms [kit_sample]
        rejects [distance_not_squared direction_of_any_length direction_from_the_light
            pdf_of_a_sphere];
    "3.1" clause_3_1: lighting::check_3_1
        conforms [kit_unshadowed kit_by_any_hit kit_by_nearest_hit]
        rejects [cosine_below_zero_kept cosine_left_out divided_by_pi material_ignored
            background_black
            only_the_first_light];
    "3.2" clause_3_2: lighting::check_3_2
        conforms [kit_wrap]
        rejects [saturating_bytes saturating_figure];
    "3.3" clause_3_3: lighting::check_3_3
        conforms [kit_clamp]
        rejects [wrapping_bytes wrapping_figure rounding_to_nearest];
    "4.1" clause_4_1: lighting::check_4_1
        conforms [kit_by_any_hit kit_by_nearest_hit]
        rejects [kit_unshadowed no_end_at_the_light no_start_at_the_surface ends_halfway];
    "4.2" clause_4_2: shadow::check_4_2
        conforms [kit_self_hitting]
        rejects [half_open_interval endless_interval moved_away];
    "4.3" clause_4_3: shadow::check_4_3
        conforms [kit_offset]
        rejects [not_moved against_the_normal a_tenth_of_the_normal figure_with_acne
            figure_without_shadow];
    "5.1" clause_5_1: any_hit::check_5_1
        conforms [kit_of_scene kit_of_shapes]
        rejects [does_not_stop no_end no_start near_root_only];
    "5.2" clause_5_2: any_hit::check_5_2
        conforms [kit_figure_3c]
        rejects [asks_for_the_nearest another_picture];
    "E.1" clause_e_1: camera::check_e_1
        conforms [kit_position]
        rejects [pixel_centres];
    "E.2" clause_e_2: camera::check_e_2
        conforms [kit_camera]
        rejects [mirrored upside_down field_of_view_across direction_of_any_length];
    "E.3" clause_e_3: engine::check_e_3
        conforms [kit_sphere]
        rejects [near_root_only far_root_first open_at_its_end];
    "E.4" clause_e_4: engine::check_e_4
        conforms [kit_ray_cast]
        rejects [flat_color dark_from_behind];
    "E.5" clause_e_5: engine::check_e_5
        conforms [kit_ray_cast]
        rejects [open_at_zero open_at_t_max no_t_max];
    "E.6" clause_e_6: engine::check_e_6
        conforms [kit_byte]
        rejects [rounded_to_nearest nan_is_white];
    "E.7" clause_e_7: engine::check_e_7
        conforms [kit_scene]
        rejects [black_background shorter_sight];
    "E.8" clause_e_8: engine::check_e_8
        conforms [kit_dot]
        rejects [from_the_right from_the_back one_precision_up];
}

/// A clause of docs/spec.md: its id, and what its lines `- Item:`, `- Test:` and `- Figure:` say.
struct Clause {
    id: String,
    items: Vec<String>,
    test: String,
    figures: Vec<String>,
}

/// The clauses of docs/spec.md.
fn written() -> Vec<Clause> {
    let text = include_str!("../docs/spec.md");
    let sections = text.split("\n### ").skip(1);
    sections
        .map(|section| {
            let id = section
                .split_whitespace()
                .next()
                .unwrap_or_default()
                .to_owned();
            let line = |key: &str| {
                let start = format!("- {key}: ");
                let line = section.lines().find_map(|line| line.strip_prefix(&start));
                line.unwrap_or_else(|| panic!("clause {id}: no line `{start}`"))
            };
            let list = |key| {
                line(key)
                    .split(", ")
                    .map(|word| word.trim_matches('`').to_owned())
            };
            let (items, test) = (
                list("Item").collect(),
                line("Test").trim_matches('`').to_owned(),
            );
            let figures = list("Figure").collect();
            Clause {
                id,
                items,
                test,
                figures,
            }
        })
        .collect()
}

#[test]
fn every_clause_has_a_test_and_every_test_a_clause() {
    let written = written();
    for clause in &written {
        let tested = TESTED.contains(&(clause.id.as_str(), clause.test.as_str()));
        assert!(
            tested,
            "clause {}: no test module {}",
            clause.id, clause.test
        );
    }
    for (id, test) in TESTED {
        let count = written.iter().filter(|clause| clause.id == *id).count();
        assert_eq!(
            count, 1,
            "{test}: clause {id} is in docs/spec.md {count} times"
        );
    }
}

#[test]
fn every_figure_is_one_of_the_six() {
    for Clause { id, figures, .. } in written() {
        for figure in figures
            .iter()
            .filter(|word| !["all", "none"].contains(&word.as_str()))
        {
            assert!(
                ombrage::Figure::named(figure).is_some(),
                "clause {id}: no figure {figure}"
            );
        }
    }
    for figure in ombrage::FIGURES {
        let clause = written()
            .into_iter()
            .find(|clause| clause.id == figure.clause);
        let shown = clause.is_some_and(|clause| clause.figures.iter().any(|f| f == figure.name));
        assert!(
            shown,
            "clause {} does not show figure {}",
            figure.clause, figure.name
        );
    }
}

#[test]
fn every_item_is_in_the_source() {
    let source = source(concat!(env!("CARGO_MANIFEST_DIR"), "/src").as_ref());
    let words: Vec<&str> = source
        .split(|c: char| !c.is_alphanumeric() && c != '_')
        .collect();
    for Clause { id, items, .. } in written() {
        for item in items {
            let found = item.split("::").all(|name| words.contains(&name));
            assert!(found, "clause {id}: no item {item} in src");
        }
    }
}

/// All Rust source under a folder, without comments.
fn source(folder: &std::path::Path) -> String {
    let entries = std::fs::read_dir(folder).expect("src can be read");
    let text = |path: std::path::PathBuf| {
        if path.is_dir() {
            return source(&path);
        }
        let text = std::fs::read_to_string(path).expect("source can be read");
        let code = text
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"));
        code.flat_map(|line| [line, "\n"]).collect()
    };
    entries
        .map(|entry| text(entry.expect("src can be read").path()))
        .collect()
}
