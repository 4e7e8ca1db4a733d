# SPDX-License-Identifier: BSD-3-Clause
"""Whether tests see changes of the code: each mutant is one changed expression of a header, of the library or of the Python package, and
its test must fail with the changed file in place of the true one. Prints the Test Anything Protocol.

Usage: mutants.py SOURCE BUILD [WORD], for all mutants, or those of files with a word in their path
       mutants.py SOURCE, only whether the expressions are in the files
"""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

# Header, what is changed into what, and the test that must fail.
MUTANTS = [
    ("contact/evaluation.hpp", "(alpha - lambda) * su)", "(alpha + lambda) * su)", "test_evaluation"),
    ("contact/evaluation.hpp", "alpha * alpha * dot(s, p) - lambda", "alpha * dot(s, p) - lambda", "test_evaluation"),
    ("contact/geometry.hpp", "return at.weight1 * product(q1, at.v);", "return at.weight2 * product(q1, at.v);", "test_geometry"),
    ("contact/geometry.hpp", "T(T(2) * at.lambda1 * at.lambda2)", "T(at.lambda1 * at.lambda2)", "test_geometry"),
    ("contact/contact_hessian.hpp", "ellipsoid == 1 ? -own : own", "ellipsoid == 2 ? -own : own", "test_hessian"),
    ("contact/contact_hessian.hpp", "fixed - T(0.5) * (dot(x.turn", "fixed + T(0.5) * (dot(x.turn", "test_hessian"),
    ("contact/contact_hessian.hpp", "T(2) * (weight * fixed", "T(1) * (weight * fixed", "test_hessian"),
    ("contact/forms.hpp", "two * (x * y - w * z)", "two * (x * y + w * z)", "test_forms"),
    ("algebra/sine_cosine.hpp", "-1.0 / 5040,", "-1.0 / 5039,", "test_elementary"),
    ("algebra/units.hpp", "times_power_of_two(x, -power * exponent)", "times_power_of_two(x, power * exponent)", "test_units"),
    ("algebra/powers_of_two.hpp", "exponent += 969", "exponent += 968", "test_units"),
    ("distance/support.hpp", "return {T(T(1) / extent) * point, extent};", "return {point, extent};", "test_distance"),
    ("distance/distance_derivatives.hpp", "cross(n, product(turn, rows[k]))", "cross(product(turn, rows[k]), n)", "test_distance"),
    ("distance/walls.hpp", "radius - dot(n2, section.center) - s.extent", "radius + dot(n2, section.center) - s.extent", "test_walls"),
    ("distance/solids.hpp", "search.overlap && local_normal(axes", "false && local_normal(axes", "test_solids"),
    ("distance/solids.hpp", "if ((global || search.overlap) && frame", "if (global && frame", "test_solids"),
    ("distance/solids.hpp", "slope = slope + (i == last", "slope = slope + (i != last", "test_solids"),
    ("distance/solids.hpp", "search.take_both(unit[i]);", "search.take(unit[i]);", "test_solids"),
    ("distance/capsule.hpp", "dot(at_end.s, ball.along) >= T(0)", "dot(at_end.s, ball.along) <= T(0)", "test_capsule"),
    ("contact/rotations.hpp", "matrix_entry<T>(rotation, i, j)", "matrix_entry<T>(rotation, j, i)", "test_solids"),
    ("shapes/triangle.hpp", "form.map(i - m)) < T(0));", "form.map(i - m)) > T(0));", "test_shapes"),
    ("volume/overlap_area_derivatives.hpp", "sum(0, 1) + T(factor", "sum(0, 1) - T(factor", "test_overlap_volume_derivatives"),
    ("volume/chord_derivatives.hpp", "number_of_chords = 16.0", "number_of_chords = 1e9", "test_overlap_volume_derivatives"),
    ("volume/chord_derivatives.hpp", "return end(0) && end(1);", "return end(0) || true;", "test_overlap_volume_derivatives"),
    ("volume/chord_derivatives.hpp", "sum.q1(i, j) - T(circle", "sum.q1(i, j) + T(circle", "test_overlap_volume_derivatives"),
    ("volume/chord_derivatives.hpp", "{-d.r12, d.q2, d.q1", "{d.r12, d.q2, d.q1", "test_overlap_volume_derivatives"),
    ("volume/circular_segment.hpp", "T(half * T(a.sine / larger))", "T(0)", "test_overlap_volume"),
    ("volume/rim_frame.hpp", "nearest_rims = 0x1p-26", "nearest_rims = 0.0", "test_space_kinds"),
    ("volume/rim_integrals.hpp", "= rule.above == rule.is_upper", "= rule.above != rule.is_upper", "test_space_kinds"),
    ("volume/rim_frame.hpp", "largest_distance_of_rim = 16.0", "largest_distance_of_rim = 1e6", "test_overlap_volume"),
    ("volume/common_volume.hpp", "largest_distance_of_integrals = 64.0", "largest_distance_of_integrals = 1e6", "test_overlap_volume"),
    ("volume/chord_area.hpp", "return end(0) && end(1);", "return end(0) || true;", "test_overlap_area"),
    ("volume/chord_area.hpp", "exceeds(T(a.other + a.other_error)", "exceeds(T(0.5 * a.other)", "test_overlap_area"),
    ("volume/chord_axis.hpp", "T(0.051474763346229496)", "T(0.051484763346229496)", "test_overlap_area"),
    ("volume/overlap_volume.hpp", "largest_number_of_frame = 16.0", "largest_number_of_frame = 1e6", "test_overlap_area"),
    ("overlap/containment.hpp", "return first && second;", "return first || second;", "test_overlap_volume"),
    ("motion/closest_passage.hpp", "at_end = (t == T(0) && along >= T(0))", "at_end = (t == T(0) && along <= T(0))",
     "test_closest_passage"),
    ("motion/free_path.hpp", "length < plane.until ? length", "length > plane.until ? length", "test_free_path"),
    ("overlap/compare.hpp", "(concentric ? 0 : 1) - (positive ? 1 : 0)", "(concentric ? 1 : 0) - (positive ? 1 : 0)", "test_compare"),
    ("overlap/containment_factor.hpp", "W(W(1) / search.best.root2)", "W(W(2) / search.best.root2)", "test_containment_factor"),
    ("overlap/quartic.hpp", "int apart_margin = 20", "int apart_margin = 19", "proofs recall"),
    ("contact/iteration.hpp", "int adjugate_error = 13", "int adjugate_error = 12", "proofs recall"),
    ("algebra/symmetric.hpp", "D == 2 ? 8 : 16", "D == 2 ? 8 : 15", "proofs recall"),
    # which the test includes
    ("../../src/addition/inner_forms.hpp", "pi / 2 / static_cast", "pi / 4 / static_cast", "test_random_addition"),
    ("../../src/addition/inner_forms.hpp", "0x1p-46 * outer * outer +", "0x1p-60 * outer * outer +", "test_random_addition"),
    ("../../src/addition/inner_forms.hpp", "moved * moved / margin", "moved * moved", "test_random_addition"),
    ("../../src/enclosing/certificate.cpp", "sum_error = 160.0 * u * u", "sum_error = 0.0", "test_certificate"),
    ("../../src/enclosing/certificate.cpp", "double error = eta_, size", "double error = 0.0, size", "test_certificate"),
    ("../../src/enclosing/certificate.cpp", "bound + 2.0 * u * (magnitude(excess) + error)", "bound", "test_certificate"),
    ("../../src/enclosing/certificate.cpp", " - 68.0 * u * elementary::sqrt(sum)", "", "test_certificate"),
]


# The same of the library, which is linked anew, and the case of a test that must fail. Files are relative to src/.
LIBRARY_MUTANTS = [
    ("../include/pw85/any_dimension/search.hpp", "return n * (3 * n + 4);", "return 0;", "any_dimension"),
    ("../include/pw85/any_dimension/search.hpp", "T(-2) * (qv * inverse)", "T(-1) * (qv * inverse)", "any_dimension"),
    ("../include/pw85/any_dimension/overlap.hpp", "+ T(n * (3 * n + 12)) * operation_error<T>() * diagonal_form(n, q, s);", ";",
     "any_dimension"),
    ("../include/pw85/any_dimension/search.hpp", "T(at.b - t * qv)", "T(at.b + t * qv)", "any_dimension/contact"),
    ("enclosing/affine_hull.cpp", "square <= 0x1p-48", "square <= 0.0", "enclosing/flat"),
    ("enclosing/affine_hull.cpp", "first * cloud_.scale[i] + center_[i]", "center_[i]", "enclosing/flat"),
    ("enclosing/affine_hull.cpp", "basis_.vectors[a][i] * basis_.vectors[b][j]", "basis_.vectors[a][i] * basis_.vectors[a][j]",
     "enclosing/flat"),
    ("enclosing/certificate.cpp", "Wide(2.0 * (f * f + n * eta_))", "Wide(0.0)", "enclosing"),
    ("enclosing/certificate.cpp", "- first[i] * first[j]);", ");", "enclosing"),
    ("enclosing/smallest.cpp", "if (outside <= 0.0) outside = certificate_.largest_protrusion();", "", "enclosing"),
    ("enclosing/around_ellipsoids_proof.cpp", "for (std::size_t i = 0; i < bodies_.m; ++i)\n        if (!is_inside(i))",
     "for (std::size_t i = 1; i < bodies_.m; ++i)\n        if (!is_inside(i))", "enclosing"),
    ("../include/pw85/distance/solids.hpp", "axes = axes_in_unit(\n", "axes = principal_axes(\n", "solids/long_segment"),
    ("../include/pw85/distance/capsule.hpp", "- radius * square_root(dot(s, s))", "+ radius * square_root(dot(s, s))", "capsule/overlap"),
    ("../include/pw85/distance/capsule.hpp", "W(nearest.mu2 + error) < W(1)", "nearest.mu2 < W(1)", "capsule/touching"),
    ("../include/pw85/volume/rim_frame.hpp", "rim.ends = {!below, below};", "rim.ends = {below, below};", "space_kinds/specimens"),
    ("../include/pw85/volume/rim_axis.hpp", "if (!find_lowest_root(", "if (find_lowest_root(", "space_kinds/specimens"),
    ("../include/pw85/volume/pencil_roots.hpp", "towards_upper + towards_lower};", "towards_upper - towards_lower};",
     "space_kinds/specimens"),
    ("../include/pw85/volume/crossings.hpp", "begins_inside != has_maximum) return {};", "begins_inside == has_maximum) return {};",
     "plane_kinds/along_axes"),
    ("../include/pw85/volume/crossings.hpp", "if (is_inside != was_inside) {", "if (is_inside && !was_inside) {", "plane_kinds/specimens"),
    ("../include/pw85/volume/crossings.hpp", "is_inside && half_second <= accuracy.noise ?", "is_inside ?", "plane_kinds/specimens"),
    ("../include/pw85/volume/elliptic_rule.hpp", "return r < T(smallest_stretch2)", "return r < T(0)", "space_kinds/specimens"),
    ("../include/pw85/volume/crossings.hpp", "return radius >= T(0.5) &&", "return radius < T(0) &&", "plane_kinds/copies"),
    ("../include/pw85/volume/section.hpp", "(k % 2 == 0) != found.first_inside", "(k % 2 == 0) == found.first_inside",
      "plane_kinds/specimens"),
    ("../include/pw85/volume/section.hpp", "arc.cosine = -size;", "arc.cosine = size;", "plane_kinds/specimens"),
    ("../include/pw85/volume/section.hpp", "if (span < T(1)) arc.cosine = size;", "if (span < T(1)) arc.cosine = -size;",
      "plane_kinds/specimens"),
    ("../include/pw85/volume/overlap_area_derivatives.hpp", "if (!d.clear) return", "if (false) return", "plane_kinds/specimens"),
    ("../include/pw85/volume/overlap_area_derivatives.hpp", "normal[1] + (p.x - q.x)", "normal[1] + (q.x - p.x)", "plane_kinds/tangencies"),
    ("../include/pw85/distance/grain_contact.hpp", "depth + T(0.5) * dot(gradient, x)", "depth", "grain_contact/truth"),
    ("../include/pw85/distance/grain_contact.hpp", "factor = -surface.reciprocal;", "factor = surface.reciprocal;", "grain_contact/truth"),
    ("../include/pw85/distance/grain_contact_wall.hpp", " && added >= W(-0.5) * own", "", "grain_contact/walls/unlike_curvatures"),
    ("simulation/verlet_list.cpp", "all, [i](std::size_t j) { return j >= i; }))\n                    found",
     "all, [i](std::size_t j) { return j > i; }))\n                    found", "hard_ellipsoids/own_images"),
    ("simulation/float_boxes.hpp", "0x1p-18 * (farthest", "0x1p-40 * (farthest", "hard_ellipsoids/far_spheres"),
    ("simulation/float_boxes.hpp", "lower_(all.margin_ - boxes", "lower_(-boxes", "hard_ellipsoids/far_spheres"),
    ("simulation/float_boxes.hpp", "negative_upper_(all.margin_ - boxes", "negative_upper_(-boxes", "hard_ellipsoids/far_spheres"),
    ("simd/lanes/volumes.hpp", "merge(!by_three);", "merge(by_three);", "same_bits/scales"),
    ("simd/lanes/depth.hpp", "!(at.length <= parts.length + slack)", "!(at.length <= infinity<Pack>())", "same_bits/scales"),
    ("simd/lanes/signed_distance.hpp", "Pack(0.0) - found.depth", "found.depth", "same_bits/scales"),
    ("simd/lanes/listed_distances.cpp", "live & ~certain, [", "0u, [", "same_bits/scales"),
    ("simd/lanes/images.hpp", "(certainty.overlap & passing) != 0", "certainty.overlap != 0", "hard_ellipsoids/tiny_pairs"),
    ("simulation/contact_search.cpp", "length_ + 0x1p-16 * scale * sum_of_magnitudes(center);", "length_;",
     "event_chains/passing_far_away"),
    ("simulation/hamiltonian.hpp", "if (sum >= 0.0)", "if (sum >= -0.02)", "hard_ellipsoids/rejected_volumes"),
    ("simulation/hamiltonian.cpp", "accept(1.0, 0.0, change,", "accept(1.0, 0.0, 0.98 * change,", "surroundings/fields"),
    ("simulation/sweep.cpp", "    model_.particles.roll_back();\n", "", "surroundings/nan"),
    ("simulation/sweep.cpp", "if (model_.hamiltonian.has_energy()) model_.particles.commit();", "", "surroundings/nan_in_second_sweep"),
    ("simulation/sweep.cpp", "    model_.parameters.counts = before;\n", "", "surroundings/nan"),
    ("simulation/hamiltonian.cpp", "particles.order().particle(places[k]));", "places[k]);", "surroundings/sites"),
    ("simulation/sweep.cpp", "shortened(steps.translation, moved", "shortened(model_.parameters.translation, moved",
     "hard_ellipsoids/kind_steps"),
    ("simulation/sweep.cpp", "species_counts[k].add(counts_by_species[k]);",
     "species_counts[0].add(counts_by_species[k]);", "hard_ellipsoids/kind_steps"),
    ("simulation/float_boxes.hpp", "lower_ - translation", "lower_ + translation", "hard_ellipsoids/hard_spheres"),
    ("simulation/domains.cpp", "rest % 3) % parts_", "rest % 2) % parts_", "hard_ellipsoids/long_trials"),
    ("simulation/verlet_list.hpp", "if (found.count >= most_candidates && overlaps_found()) return true;",
     "if (found.count >= most_candidates) found.count = 0;", "hard_ellipsoids/many_candidates"),
    ("simulation/change.hpp", "factor : elementary::sqrt(factor)", "factor : factor", "hard_ellipsoids/aspect"),
    ("addition/covering.hpp", "overlaps(r - corner", "overlaps(r", "random_addition/saturated"),
    ("addition/voxels.hpp", "2 * voxel.corner[i] + (part >> i & 1)", "2 * voxel.corner[i]", "random_addition/saturated_discs"),
    ("addition/packing.hpp", "from, -turns, cell_[i]", "from, turns, cell_[i]", "random_addition/saturated"),
    ("addition/random_addition.cpp", "unit * particle.center", "particle.center", "random_addition/units"),
    ("simulation/walls.cpp", "ball(d, d) = radius * radius;", "ball(d, d) = 1.02 * radius * radius;", "surroundings/walls"),
    ("simulation/walls.cpp", "enlargement * (magnitude(center)", "0.9 * (magnitude(center)", "surroundings/walls"),
    ("simulation/walls.cpp", "> enlargement * width + rounding", "> 0.9 * width + rounding", "surroundings/walls"),
    ("simulation/walls.cpp", "half_space_cuts(-outward, -lower[d], particle);", "false;", "surroundings/walls"),
    ("simulation/walls.cpp", "constexpr double perpendicular = 0x1p-44", "constexpr double perpendicular = 0x1p-24",
     "surroundings/bad_input"),
    ("simulation/external_potential.cpp", "m[axis], m[3 + axis], m[6 + axis]", "m[3 * axis], m[3 * axis + 1], m[3 * axis + 2]",
     "surroundings/fields"),
    ("simulation/external_potential.cpp", "unit_measure<double, 3>() * (rect",
     "0.97 * unit_measure<double, 3>() * (rect", "surroundings/fields"),
    ("simulation/external_potential.cpp", "energy > -infinity<double>() ? energy", "true ? energy", "surroundings/nan"),
    ("simulation/volume_moves.cpp", "cost += energy_change(change);", "cost += 0.98 * energy_change(change);", "surroundings/volume"),
    ("simulation/hard_ellipsoids_external_potential.cpp", "external.energy_of_potential(engine.particles.all()) != external.saved_energy",
     "false",
     "surroundings/threads_and_restart"),
    ("simulation/hard_ellipsoids_state.cpp", "if (!elementary::isfinite(energy))", "if (false)", "surroundings/nan"),
    ("simulation/hard_ellipsoids_state.cpp", "return elementary::isfinite(external.saved_energy) ?", "return true ?",
     "saved_states/impossible_numbers"),
    ("simulation/hard_ellipsoids_state.cpp", "num_vertices > section.remaining<Vector3>()", "false", "saved_states/huge_lengths"),
    ("simulation/hard_ellipsoids_state.cpp", "periodic != 0 && periodic != 1", "false", "saved_states/impossible_numbers"),
    ("simulation/sections.cpp", "|| checksum(bytes, end) != load_word(bytes + end)", "", "saved_states/each_byte"),
    ("simulation/sections.cpp", "given > end - next ||", "", "saved_states/huge_lengths"),
    ("simulation/sections.cpp", "if (sections[section].exists()) return not_a_state;", "", "saved_states/order"),
    ("simulation/sections.cpp", "name[0] < 'a' ||", "name[0] < 'A' ||", "saved_states/unknown_sections"),
    ("simulation/sections.hpp", "if (!std::in_range<Number>(value)) refuse(PW85_EINVAL);", "", "saved_states/impossible_numbers"),
    ("simulation/sweep.cpp", " * model_.hamiltonian.pairs.reach();", ";", "pair_energy/width_of_domains"),
    ("simulation/neighborhood.cpp", "list.make(configuration.system(), reach, skin", "list.make(configuration.system(), 1.0, skin",
     "pair_energy/many_spheres"),
    ("simulation/verlet_list.hpp", "j == i ? 1 : 2", "2", "pair_energy/own_images"),
    ("simulation/sweep.cpp", "j != counted;", "true;", "pair_energy/exchange"),
    ("simulation/volume_moves.cpp", "accept_energy(before, model_.list.energy_of_all(all, pairs), stream)",
     "Outcome::accepted", "pair_energy/volume"),
    ("simulation/pair_energy.cpp", "tensor[0] + tensor[4] + tensor[8];", "tensor[0] + tensor[4];", "pair_energy/virial"),
    ("simulation/hard_ellipsoids.cpp", "if (!engine.hamiltonian.external.is_empty())",
     "if (!engine.hamiltonian.is_hard())", "pair_energy/compression"),
    ("simulation/insertions.cpp", "static_cast<double>(species.count + 1);",
     "static_cast<double>(species.count + 2);", "insertion/ideal_gas"),
    ("simulation/insertions.cpp", "species.activity * all.volume() /", "1.02 * species.activity * all.volume() /", "insertion/ideal_gas"),
    ("simulation/insertions.cpp", "accept(ratio, 1.0, -energy,", "accept(ratio, 1.0, -0.9 * energy,", "insertion/full_cell"),
    ("simulation/insertions.cpp", "half_widths = reach * particle", "half_widths = 1.0 * particle", "insertion/reach"),
    ("simulation/insertions.cpp", "if (j == skipped) return;", "", "insertion/attraction"),
    ("simulation/insertions.cpp", "particle.q, particle.q, 2);", "particle.q, particle.q, 1);", "insertion/attraction"),
    ("simulation/insertions.cpp", "if (width <= listed_) return", "if (listed_ > 0.0) return", "insertion/full_cell"),
    ("simulation/insertions.cpp", "    return test_images(particle, is_free);", "    return is_free = true, PW85_SUCCESS;",
     "insertion/full_cell"),
    ("simulation/insertions.cpp", "all.is_in_cell(all.centers[i]) && ", "", "insertion/slit"),
    ("simulation/insertions.cpp", "    } while (square > 1.0);", "    } while (false);", "insertion/full_cell"),
    ("simulation/insertions.cpp", "    std::swap(numbers_[i], numbers_[last]);\n", "", "insertion/threads_and_restart"),
    ("simulation/particles.cpp", "    all_.set(particle, all_.get(last));\n", "", "insertion/insert_and_remove"),
    ("simulation/insertions.cpp", "if (++count == most_candidates) test();", "++count;\n        count = count % most_candidates;",
     "insertion/many_neighbors"),
    ("simulation/pair_energy.cpp", "made.reach_ = (1.0 + 0x1p-50)", "made.reach_ = 0.98", "pair_energy/reach"),
    ("simulation/verlet_list.cpp", "if (reach != reach_ || ", "if (", "pair_energy/reach"),
    ("simulation/mesh_wall.cpp", "width = magnitude_of_dot(", "width = 0.5 * magnitude_of_dot(", "surroundings/mesh_of_cell"),
    ("simulation/mesh_wall.cpp", "center[d] - middle_[d]) <=", "center[d] - middle_[d]) <= 0.9 *", "surroundings/mesh_of_cell"),
    ("simulation/mesh_wall.cpp", "? periodicity.dual_of_cell(k) : Vector3{}", "? Vector3{} : Vector3{}", "surroundings/mesh_of_slab"),
    ("simulation/mesh_wall.cpp", "(2.0 - 0x1p-20)", "4.0", "surroundings/steps_in_mesh"),
    ("simulation/mesh_wall.cpp", "1.0 - 0x1p-49 * (ratio * ratio)", "1.0", "surroundings/flat_particle_in_mesh"),
    ("simulation/mesh_wall.cpp", "<= most_cells)", "<= 10.0 * most_cells)", "surroundings/bad_mesh"),
    ("simulation/sweep.cpp", "model_.hamiltonian.external.shortened(steps.translation, moved.semi_axes)", "steps.translation",
     "surroundings/steps_in_mesh"),
    ("meshes/winding.cpp", "moved != 0 ? moved : compare(b[0], a[0])", "moved", "mesh_distance/inside"),
    ("meshes/winding.cpp", "orientation(x[0], x[1], x[2]) == side ? side : 0", "side", "mesh_distance/inside"),
    ("meshes/mesh_distance.cpp", "triangle.index < best.triangle", "false", "mesh_distance/nearest"),
    ("meshes/distance_bounds.hpp", "return shape.least_projection(n) -", "return 1.01 * shape.least_projection(n) -",
     "mesh_distance/nearest"),
    ("simulation/parameters.cpp", "external.shortened(longest, species[k].semi_axes)", "longest", "surroundings/steps_in_mesh"),
    ("simulation/parameters.cpp", "maximum(useful, external.shortened(longest, configuration.semi_axes[i]))", "longest",
     "surroundings/steps_in_mesh"),
    ("simulation/hard_ellipsoids.cpp", "if (engine.hamiltonian.external.mesh.exists())", "if (false)", "surroundings/mesh_of_cell"),
    ("simulation/external_potential.cpp", "mesh.exists() && configuration.dimensions != 3", "false", "surroundings/bad_mesh"),
    ("simulation/external_potential.cpp", "return true;\n    return mesh.cuts(particle);",
     "return true;\n    return false;", "surroundings/mesh"),
    ("simulation/hard_ellipsoids_state.cpp", "read_mesh(sections[mesh], cell_read,", "read_mesh(sections[mesh], Cell{},",
     "surroundings/mesh_of_slab"),
    ("simulation/model.hpp", "else if (!list.holds(trial.places[k], particles.copy()))", "else if (false)", "hard_ellipsoids/far_spheres"),
    ("simulation/model.hpp", "particles.accept(trial.places[k]);", ";", "hard_ellipsoids/two_ellipsoids"),
    ("simulation/engine.cpp", "|| list.holds(place, particles.copy())", "|| true", "hard_ellipsoids/try"),
    ("simulation/contact_search.cpp", "own[d] += absolute(half[d]);", "own[d] += 0.0;", "event_chains/pressure"),
    ("simulation/chain_bodies.cpp", "<= (1.0 + 0x1p-40) * 2.0 * longest_", "<= 1.0 * longest_", "event_chains/one_particle"),
    ("simulation/hamiltonian.hpp", "return sum > -700.0 && uniform", "return uniform", "hard_ellipsoids/immense_pressures"),
    ("simulation/contact_search.cpp", " + 0x1p-16 * scale * sum_of_magnitudes(image.translation);", ";",
     "event_chains/passing_far_partner"),
    ("simulation/volume_moves.cpp", "all.size()) + 1.0", "all.size())", "hard_ellipsoids/ideal_gas"),
    ("simulation/volume_moves.cpp", "|| mu2 <= scale * scale", "|| std::isfinite(mu2)", "hard_ellipsoids/compress"),
    ("simulation/sweep.cpp", "            stream = before;", "", "hard_ellipsoids/long_trials"),
    ("simulation/sweep.cpp", "return product / magnitude(product);", "return product;", "hard_ellipsoids/two_ellipsoids"),
    ("simulation/sweep.cpp", "if (move != rotation && domains_", "if (move == both && domains_", "hard_ellipsoids/long_trials"),
    ("simulation/sweep.cpp", "reach_of_domains = 2.125", "reach_of_domains = 1.0", "hard_ellipsoids/long_trials"),
    ("simulation/contact_search.cpp", "image == passed_->image", "image.body == passed_->image.body", "event_chains/line"),
    ("simulation/chains.cpp", " - moved;", ";", "event_chains/pressure"),
    ("simulation/contact_search.cpp", "touched().plane.exists() && has_moved", "touched().plane.exists()", "event_chains/no_way"),
    ("../include/pw85/algebra/philox.hpp", "symmetric(), -0.0};", "symmetric(), 0.0};", "hard_ellipses/nothing_leaves_the_plane"),
    ("simulation/sweep.cpp", "steps.rotation * stream.symmetric())", "steps.rotation * stream.uniform())",
     "hard_ellipses/detailed_balance"),
    ("simulation/sweep.cpp", "imaginary = z + v * w", "imaginary = z + v", "hard_ellipses/steps"),
    ("simulation/configuration.hpp", "a[0] * b[1] - a[1] * b[0]", "a[0] * b[1]", "hard_ellipses/ideal_gas"),
    ("simulation/configuration.hpp", "for (int d = 0; d < dimensions; ++d) longest", "for (int d = 0; d < 3; ++d) longest",
     "hard_ellipses/tune"),
    ("simulation/volume_moves.cpp", "for (int k = 0; k < all.dimensions; ++k)", "for (int k = 0; k < 3; ++k)",
     "hard_ellipses/nothing_leaves_the_plane"),
    ("simulation/parameters.cpp", "(elementary::sqrt(each) - 2.0 * longest) / 3.0", "(elementary::sqrt(each) - 2.0 * longest) / 2.0",
     "hard_ellipses/tune"),
    ("simulation/hard_ellipsoids.cpp", "along[2] = -0.0;", "along[2] = 0.0;", "hard_ellipses/nothing_leaves_the_plane"),
    ("simulation/hard_ellipsoids.cpp", "if (along[2] != 0.0)", "if (false)", "hard_ellipses/bad_input"),
    ("simulation/hard_ellipsoids.cpp", "moved.center[2] = before.center[2];", "", "hard_ellipses/nothing_leaves_the_plane"),
    ("simulation/hard_ellipsoids_state.cpp", "dimensions = dimensions;", "dimensions = 3;", "hard_ellipses/changed_bytes"),
    ("simulation/hard_ellipsoids_state.cpp", "    if (all.dimensions == 2)", "    if (false)", "hard_ellipses/changed_bytes"),
]

# The same of the Python package, and the file and cases of pytest that must fail.
PYTHON_MUTANTS = [
    ("_statistics.py", "(dimensions * num_particles * width)", "(2 * num_particles * width)",
     "test_observables.py equation_of_state_of_hard_spheres"),
    ("_statistics.py", "(dimensions * num_particles * width)", "(3 * num_particles * width)", "test_planes.py compressibility"),
    ("_statistics.py", "density * np.diff(edges**dimensions)", "density * np.diff(edges**2)", "test_packing.py correlation"),
    ("_statistics.py", "UNIT_BALL[dimensions] * np.diff(edges**dimensions)", "UNIT_BALL[dimensions] * np.diff(edges**3)",
     "test_planes.py pair_correlation"),
    ("_statistics.py", "[known] ** 4", "[known] ** 2", "test_planes.py orders"),
    ("_statistics.py", "np.where(first < second, np.pi / 2, 0.0)", "0.0", "test_planes.py orders"),
    ("_statistics.py", "long * short >= middle**2", "long * short < middle**2", "test_observables.py director"),
    ("_statistics.py", "(dimensions * known.T", "(0.9 * dimensions * known.T", "test_packing.py nematic_order"),
    ("_system.py", "abs(a * d - b * c) if", "abs(a * d) if", "test_planes.py from_ellipses"),
    ("_packing.py", "self.free[:, 0] = [1, 1, 0], [0, 0, 1]", "pass", "test_planes.py relax"),
    ("_drawing.py", "(not shift.any())", "False", "test_planes.py picture"),
    ("_statistics.py", "directions[long - short <= _ROUND * long] = np.nan", "pass", "test_observables.py spheres_have_no_axes"),
    ("_blocking.py", "self._pending[level] + block) / 2", "self._pending[level] + block) / 3", "test_observables.py blocks"),
    ("_blocking.py", "_FACTOR = 0.85", "_FACTOR = 0.6", "test_observables.py errors_of_correlated_samples"),
    ("_blocking.py", "_LONGEST_TIME = 1 / 8", "_LONGEST_TIME = 4", "test_observables.py the_slowest_decides"),
    ("_blocking.py", "self._counts[level] - 1) / 2", "self._counts[level]) / 2", "test_observables.py drifts"),
    ("_observables.py", "_BIAS_BY_DIFFERENCE = 16 / 15", "_BIAS_BY_DIFFERENCE = 1", "test_observables.py"),
    ("_observables.py", "p2 * (both - counts - weighted)", "p2 * (both + counts - weighted)", "test_observables.py"),
    ("_poses.py", "np.cross(normal, arm1)", "np.cross(arm1, normal)", "test_poses.py finite_differences"),
    ("_poses.py", "np.cross(point2 - translation2, normal)", "np.cross(point2, normal)", "test_poses.py finite_differences"),
    ("_poses.py", "rotation2.T @ rotation1))", "rotation1))", "test_poses.py common_motions"),
    ("_poses.py", " or np.linalg.det(given) < 0", "", "test_poses.py wrong_poses"),
    ("_structure.py", "len(multiples) // 2 + 1 :", "len(multiples) // 2 :", "test_structure.py"),
    ("_structure.py", "* reach / (2 * np.pi)", "* reach / (4 * np.pi)", "test_structure.py"),
    ("_structure.py", "np.abs(density_modes(system, multiples)) ** 2 / len", "np.abs(density_modes(system, multiples)) / len",
     "test_structure.py"),
    ("_structure.py", "np.pi / limits[0] * (1 + 2.0**-40))", "np.pi / limits[0] * (1 - 2.0**-40))", "test_structure.py"),
    ("_structure.py", "length * (1 + 2.0**-40) >=", "length * (1 - 2.0**-40) >=", "test_structure.py"),
    ("_structure.py", "between <= np.cos(_LEAST_ANGLE)", "between <= 1", "test_structure.py"),
    ("_structure.py", "1 if m == 0 else 2", "2", "test_structure.py"),
    ("_structure.py", "owner[rank < nearest], bonds[rank < nearest]", "owner[rank <= nearest], bonds[rank <= nearest]",
     "test_structure.py"),
    ("_structure.py", "known * (known - 1)", "known * known", "test_structure.py"),
    ("_structure.py", "np.round(steps), 0)", "0, 0)", "test_structure.py"),
    ("_structure.py", "(place - then[0]) @ cell", "(place - then[0])", "test_structure.py"),
    ("_structure.py", "axes, now) < 0, -1, 1)", "axes, now) < 0, 1, 1)", "test_structure.py"),
    ("_structure.py", "np.arctan2(sine, cosine) / sine", "1", "test_structure.py"),
    ("formats/gsd.py", "if found == frames:", "if found >= frames:", "test_mc.py in_gsd"),
    ("cli/_runs.py", "_append(self._table_path, self.table_length, b\"\")", "pass", "test_mc.py table"),
]


class Tests:
    """The programs of a build folder, made anew from a folder `work` with the sources of which one is changed."""

    def __init__(self, source, build):
        self.source, self.build = source, build
        units = json.loads((build / "compile_commands.json").read_text())
        self.of_library = [unit for unit in units if unit["output"].startswith(("src/libpw85.so", "src/simd/"))]
        self.units = {Path(unit["file"]).name: unit for unit in units}
        self.compiled_once = [unit for unit in units if unit["output"].startswith("tests/oracle/libonce")]
        self.links = [shlex.split(line) for line in self.ninja("commands").splitlines() if " -o " in line and " -c " not in line]
        self.read_by = {}  # what each object was compiled from
        for line in self.ninja("deps").splitlines():
            if not line.startswith(" "):
                files = self.read_by[line.partition(":")[0]] = set()
            else:
                files.add(line.strip())

    def ninja(self, tool):
        return subprocess.run(["ninja", "-C", self.build, "-t", tool], check=True, stdout=subprocess.PIPE, text=True).stdout

    def fails_with_header(self, changed, program, work):
        """Whether a test fails that is compiled with the headers in `work`, with what its libraries have of the changed one."""
        name, *arguments = program.split() if " " in program else (program, "--tap", "-k", "-m", "quick")
        unit = self.units[f"{name}.cpp"]
        link = next(words for words in self.links if Path(words[words.index("-o") + 1]).name == name)
        file = f"../{changed.relative_to(work)}"
        linked = [unit for unit in self.compiled_once if str(Path(unit["output"]).parent.with_suffix("")) in link]
        once = [unit for unit in linked if file in self.read_by[unit["output"]]]
        objects = [self.compile(unit, work, f"once{k}.o") for k, unit in enumerate(once)]
        at = link.index("-o")  # an object goes before those of archives
        self.link([*link[:at], *objects, *link[at:]], {unit["output"]: self.compile(unit, work, "changed.o")}, work / "changed")
        return self.status(work / "changed", *arguments, LD_LIBRARY_PATH=self.build / "src") != 0

    def fails_with_library(self, changed, case, work):
        """Whether a case of a test fails with the library of which a file is changed."""
        file = f"../{changed.relative_to(work)}"
        units = [unit for unit in self.of_library if file in self.read_by[unit["output"]]]
        link = next(words for words in self.links if words[words.index("-o") + 1].startswith("src/libpw85.so"))
        objects = {unit["output"]: self.compile(unit, work, f"changed{k}.o") for k, unit in enumerate(units)}
        self.link(link, objects, work / "libpw85.so.3")
        program = self.build / f"tests/test_{case.partition('/')[0]}"
        return self.status(program, "-p", f"/{case}", "-m", "quick", LD_LIBRARY_PATH=work) != 0

    def fails_with_package(self, changed, cases, work):
        """Whether cases fail with the package in which a module is changed, not because of an error of pytest."""
        package, test = work / "python/pypw85", self.source / "python/tests"
        text = changed.read_text(encoding="utf-8")
        shutil.rmtree(package)
        shutil.copytree(self.build / "python/pypw85", package, symlinks=False)
        changed.unlink()
        changed.write_text(text, encoding="utf-8")
        file, _, name = cases.partition(" ")  # all cases of the file, or those with the word
        return self.status(sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", test / file, "-k", name,
                           PYTHONPATH=f"{work / 'python'}:{test}", PYTHONDONTWRITEBYTECODE="1", PYPW85_SOURCE=self.source,
                           LD_LIBRARY_PATH=self.build / "src") == 1

    def compile(self, unit, work, name):
        """Compiles a unit with the sources in `work` in place of those beside the build folder, and so without a precompiled header."""
        command = re.sub(r" -fpch-preprocess -include \S+", "", unit["command"])
        given = (word for word in shlex.split(command) if word != "-Werror")
        words = [re.sub(r"^(-I)?\.\./(?=include|src|tests)", rf"\1{work}/", word) for word in given]
        words[words.index("-o") + 1] = str(work / name)
        self.run(words)
        return work / name

    def link(self, words, objects, output):
        words = [str(objects.get(word, word)) for word in words]
        words[words.index("-o") + 1] = str(output)
        self.run(words)

    def run(self, words):
        subprocess.run(words, cwd=self.build, check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def status(self, *command, **environment):
        variables = {**os.environ, **{name: str(value) for name, value in environment.items()}}
        return subprocess.run(command, env=variables, cwd=self.build, timeout=300, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL).returncode


def mutants():
    """The kind of each mutant, the file in the sources, what is changed into what, and the test."""
    folders = {"header": ("include/pw85", MUTANTS), "library": ("src", LIBRARY_MUTANTS), "package": ("python/pypw85", PYTHON_MUTANTS)}
    return [(kind, os.path.normpath(f"{folder}/{file}"), *rest) for kind, (folder, listed) in folders.items() for file, *rest in listed]


def stale_mutants(source):
    """The mutants whose expression is not in the file, or more than once."""
    counts = ((file, old, (source / file).read_text(encoding="utf-8").count(old)) for _, file, old, *_ in mutants())
    return [f"{file} has {count} times {old!r}" for file, old, count in counts if count != 1]


def is_seen(tests, fails, file, old, new, test):
    """Whether a test fails after a change of a file, and why not."""
    with tempfile.TemporaryDirectory(prefix="pw85-mutant-") as folder:
        work = Path(folder)
        for part in ("include", "src", "tests", "python/pypw85"):
            shutil.copytree(tests.source / part, work / part)
        changed = work / file
        changed.write_text(changed.read_text(encoding="utf-8").replace(old, new), encoding="utf-8")
        try:
            return fails(changed, test, work), f"{test} passes with {new!r}"
        except subprocess.CalledProcessError as error:
            return False, f"{error}\n{error.stdout.decode()}"
        except subprocess.TimeoutExpired:
            return True, ""


def main():
    source, *build = (Path(word).resolve() for word in sys.argv[1:3])
    if stale := stale_mutants(source):
        return "\n".join(stale)
    if not build:
        return 0
    tests = Tests(source, build[0])
    fails = {"header": tests.fails_with_header, "library": tests.fails_with_library, "package": tests.fails_with_package}
    chosen = [mutant for mutant in mutants() if all(word in mutant[1] for word in sys.argv[3:])]
    print(f"1..{len(chosen)}")
    all_seen = True
    for number, (kind, file, old, new, test) in enumerate(chosen, 1):
        seen, why = is_seen(tests, fails[kind], file, old, new, test)
        all_seen = all_seen and seen
        print(f"{'ok' if seen else 'not ok'} {number} {file}: {new}", flush=True)
        if not seen:
            print("\n".join(f"# {line}" for line in why.splitlines()[:20]), flush=True)
    return 0 if all_seen else 1


if __name__ == "__main__":
    sys.exit(main())
