//! Properties of every kernel, checked with random inputs in both floats, and what bad input does.
//!
//! `PROPTEST_CASES` sets how many inputs each property gets (256).

#[path = "support/exact.rs"]
mod exact;
#[path = "support/property.rs"]
mod property;
#[path = "support/report.rs"]
mod report;

mod properties {
    pub mod accuracy;
    pub mod bad_input;
    pub mod bounded;
    pub mod camera;
    pub mod chains;
    pub mod close;
    pub mod double_double;
    pub mod film;
    pub mod kleene;
    pub mod leave;
    pub mod light;
    pub mod losses;
    pub mod names;
    pub mod picture;
    pub mod plane;
    pub mod proven;
    pub mod ray;
    pub mod relative;
    pub mod sabotage;
    pub mod scene;
    pub mod sphere;
    pub mod touch;
}

/// One test for each property, or one in each float: `plane::f32::hit_point_lies_on_plane`.
macro_rules! properties {
    ($(in both floats, $module:ident { $($name:ident)* })*
        $(once, $single_module:ident { $($single:ident)* })*) => {
        $(mod $module {
            properties!(@float f32 $module $($name)*);
            properties!(@float f64 $module $($name)*);
        })*
        $(mod $single_module {
            $(#[test]
            fn $single() {
                crate::properties::$single_module::$single();
            })*
        })*
    };
    (@float $float:ident $module:ident $($name:ident)*) => {
        mod $float {
            $(#[test]
            fn $name() {
                crate::properties::$module::$name::<core::primitive::$float>();
            })*
        }
    };
}

properties! {
    in both floats, plane {
        t_is_within_its_bound
        hit_point_lies_on_plane
        t_is_the_same_for_every_point_of_the_plane
        a_parallel_ray_misses
        the_normal_has_unit_length_or_is_refused
        a_normal_of_any_moderate_length_is_taken
    }
    in both floats, sphere {
        hits_are_the_same_in_a_mirror
        hit_point_lies_on_sphere
        an_interval_sees_the_roots_it_contains
        a_huge_sphere_is_a_plane
    }
    in both floats, scene {
        any_hit_is_whether_a_nearest_hit_exists
        any_hit_is_that_of_a_naive_oracle
        any_hit_does_not_depend_on_the_order_of_objects
        any_hit_grows_with_t_max
        normals_face_the_ray_and_have_unit_length
        the_nearest_hit_is_the_nearest_of_all_objects
        cast_rounds_every_number
        cast_refuses_what_the_format_cannot_hold
    }
    in both floats, light {
        attributes_are_within_their_bounds
        what_is_in_range_is_right_whatever_lies_between
        direction_has_unit_length
        radiance_falls_with_the_square_of_the_distance
        radiance_grows_with_the_power
        a_light_at_the_point_contributes_nothing
    }
    in both floats, ray {
        offset_leaves_on_the_side_of_the_normal
        offset_stays_small
        offset_along_the_opposite_normal_is_the_mirror_image
        interval_is_closed_and_holds_no_nan
        step_goes_from_number_to_number
    }
    in both floats, leave {
        it_is_the_next_number_off_a_surface
        a_point_that_is_off_stays
        where_no_way_helps_the_point_stays
    }
    in both floats, film {
        bytes_around_every_level_are_exact
        bytes_are_exact
        bytes_of_any_bits_are_bytes
        clamped_bytes_grow_with_radiance
    }
    in both floats, camera {
        directions_have_unit_length
        the_middle_ray_looks_at_its_aim
        the_field_of_view_is_vertical
        a_view_is_cast_number_by_number
    }
    in both floats, bad_input {
        shapes_are_refused_by_field_and_value
        lights_are_refused_by_field_and_value
        scenes_are_refused_by_field_and_value
        cameras_are_refused_by_field_and_value
        no_bits_make_the_kit_panic
        figures_of_any_size_are_drawn
    }
    in both floats, touch {
        the_widest_kernel_tells_the_smallest_ends_from_0
        the_widest_kernel_tells_the_slightest_touch
        projected_points_are_as_near_as_they_say
        shadow_rays_start_where_their_strategy_says
        origins_on_the_surface_are_seen_by_direction
        a_light_on_a_sphere_shines_up_to_the_tangent
    }
    in both floats, accuracy {
        agreement_counts_bits_and_places
        agreement_at_its_ends
        units_are_told_from_others
        scaling_by_a_power_of_two_is_exact
    }
    once, bounded {
        bounds_hold_in_f32
        bounds_hold_in_f64
        bounds_hold_in_double_double
        nothing_is_known_beyond_the_largest_number
        a_product_with_zero_is_zero
        large_quotients_are_within_their_bounds
        a_rounded_double_double_is_within_its_bound
        half_tangents_are_within_their_bounds
    }
    once, kleene {
        choices_are_those_of_three_valued_logic
    }
    once, close {
        moderate_numbers_stay_known
        integer_parts_and_leading_bits_are_known_up_to_their_ends
    }
    once, sabotage {
        bounds_too_small_are_noticed
        certainty_too_early_is_noticed
    }
    once, double_double {
        parts_sum_up_exactly
        sums_are_within_2_to_the_minus_104
        differences_of_neighbours_are_within_2_to_the_minus_104
        products_are_within_2_to_the_minus_102
        quotients_are_within_2_to_the_minus_103
        scaled_numbers_are_exact
        nothing_is_wider
        roots_are_within_2_to_the_minus_101
        trunc_is_the_integer_part
        comparisons_are_exact
        step_moves_by_whole_places
        infinities_and_nan_never_become_numbers
        tangents_are_those_of_exact_angles
        tangents_are_those_of_half_the_angle
    }
    once, losses {
        losses_of_sums_are_condition_numbers
        losses_of_planes_are_condition_numbers_or_angles
        losses_of_spheres_are_those_of_the_rim_or_of_the_formula
        losses_of_cosines_are_those_of_angles
        turns_and_bytes_make_up_the_radiance
        steps_are_those_of_the_traces
        losses_are_told_in_words
    }
    once, chains {
        both_draw_the_same_pictures
        surveys_tell_what_pixels_show
    }
    once, relative {
        a_surface_through_the_camera_parts_what_it_sees
        a_light_in_a_plane_lights_neither_side
        a_far_sphere_near_its_light_keeps_its_shading
    }
    once, picture {
        pictures_are_refused_by_field_and_value
    }
    once, proven {
        no_proof_contradicts_a_higher_one
        random_scenes_find_out_a_false_proof
    }
    once, names {
        shadows_are_read_from_their_names
        qualities_are_read_from_their_names
        rungs_have_their_names
        sizes_that_are_judged
    }
}
