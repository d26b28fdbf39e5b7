/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Included before sources that are compiled once more without wide vectors: other names for what they define.
 */
#define duct_search_new narrow_search_new
#define duct_search_free narrow_search_free
#define duct_search_nearest narrow_search_nearest
#define duct_search_sequence narrow_search_sequence
#define duct_search_one_by_one narrow_search_one_by_one
#define duct_search_exact_new narrow_search_exact_new
#define duct_feature_distance narrow_feature_distance
#define duct_feature_distances narrow_feature_distances
#define duct_nearest_put narrow_nearest_put
#define duct_nearest_finish narrow_nearest_finish
#define duct_exact_build narrow_exact_build
#define duct_exact_release narrow_exact_release
#define duct_exact_place narrow_exact_place
#define duct_velocity_filter_init narrow_velocity_filter_init
#define duct_velocity_taps narrow_velocity_taps
#define duct_velocity_taps_of_all narrow_velocity_taps_of_all
#define duct_jump_distance narrow_jump_distance
#define duct_leaves_make narrow_leaves_make
#define duct_leaves_free narrow_leaves_free
#define duct_leaves_clear narrow_leaves_clear
#define duct_leaves_add narrow_leaves_add
#define duct_leaves_finish narrow_leaves_finish
#define duct_leaves_best narrow_leaves_best
#define DUCTUS_NARROW
