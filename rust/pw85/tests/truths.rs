// SPDX-License-Identifier: BSD-3-Clause
//! Values against closed forms and against published results. Nothing of these is computed by pw85.

#![allow(clippy::needless_range_loop)] // of coordinates

use std::cmp::Ordering;
use std::f64::consts::PI;

const U: f64 = f64::EPSILON / 2.0;
const UNITS: [i32; 3] = [-40, 0, 40]; // exponents of 2

fn ball(radius: f64) -> [f64; 6] {
    let square = radius * radius;
    [square, 0.0, 0.0, square, 0.0, square]
}

fn expect_near(found: f64, truth: f64, relative: f64, what: &dyn std::fmt::Debug) {
    let error = (found - truth).abs();
    assert!(
        error <= relative * truth.abs(),
        "{found:?} instead of {truth:?}: {what:?}"
    );
}

#[test]
fn balls() {
    let (r1, r2, s) = (1.0, 1.5, [2.0, -1.0, 2.0]); // s has length 3
    for unit in UNITS.map(|e| 2f64.powi(e)) {
        let r12 = s.map(|x| x * unit);
        let (q1, q2) = (ball(r1 * unit), ball(r2 * unit));
        // Balls scaled by 3/(r1 + r2) touch; f is quadratic, so mu2 has few rounding errors.
        let found = pw85::contact(&r12, &q1, &q2).unwrap();
        expect_near(found.mu2, 1.44, 8.0 * U, &r12);
        expect_near(found.lambda, 0.4, 64.0 * U, &r12); // lambda/(1 - lambda) = r1/r2
        let found = pw85::distance(&r12, &q1, &q2).unwrap();
        expect_near(found.distance, 0.5 * unit, 64.0 * U, &r12);
        for k in 0..3 {
            expect_near(found.point1[k], s[k] / 3.0 * unit, 64.0 * U, &found);
            expect_near(found.point2[k], s[k] / 2.0 * unit, 64.0 * U, &found);
        }
        assert!(!pw85::overlap(&r12, &q1, &q2).unwrap());
        expect_near(
            pw85::volume(&q1).unwrap(),
            4.0 / 3.0 * PI * unit.powi(3),
            8.0 * U,
            &q1,
        );
    }
}

#[test]
fn balls_share_the_volume_of_a_lens() {
    let (r1, r2, d) = (1.0, 1.5, 1.75);
    let cap: f64 = r1 + r2 - d;
    let truth = PI * cap * cap * (d * d + 2.0 * d * (r1 + r2) - 3.0 * (r1 - r2) * (r1 - r2));
    let truth = truth / (12.0 * d);
    for unit in UNITS.map(|e| 2f64.powi(e)) {
        let (q1, q2) = (ball(r1 * unit), ball(r2 * unit));
        for r12 in [
            [d * unit, 0.0, 0.0],
            [0.0, -d * unit, 0.0],
            [0.0, 0.0, d * unit],
        ] {
            let found = pw85::overlap_volume(&r12, &q1, &q2).unwrap();
            // The closed form has a condition number of 2 d/cap < 5; a dozen operations.
            expect_near(found, truth * unit.powi(3), 64.0 * U, &r12);
        }
    }
}

#[test]
fn circles_share_the_area_of_a_lens() {
    let (r1, r2, d): (f64, f64, f64) = (1.0, 1.5, 1.75);
    let a1 = ((d * d + r1 * r1 - r2 * r2) / (2.0 * d * r1)).acos();
    let a2 = ((d * d + r2 * r2 - r1 * r1) / (2.0 * d * r2)).acos();
    let part = |r: f64, a: f64| r * r * (a - (2.0 * a).sin() / 2.0);
    for unit in UNITS.map(|e| 2f64.powi(e)) {
        let q1 = pw85::ellipse(r1 * unit, r1 * unit, 0.0).unwrap();
        let q2 = pw85::ellipse(r2 * unit, r2 * unit, 0.0).unwrap();
        let found = pw85::overlap_area_2d(&[0.0, d * unit], &q1, &q2).unwrap();
        // acos loses some digits: the condition number of the lens is below 10.
        expect_near(
            found,
            (part(r1, a1) + part(r2, a2)) * unit * unit,
            64.0 * U,
            &q2,
        );
    }
}

#[test]
fn overlaps_are_decided_exactly_at_contact() {
    // Balls of radii 1 and 2 whose centres are 3 apart touch.
    let r12 = [3.0, 0.0, 0.0];
    for (xx, overlap) in [(1.0 - U, false), (1.0, false), (1.0 + 2.0 * U, true)] {
        let q1 = [xx, 0.0, 0.0, 1.0, 0.0, 1.0];
        assert_eq!(pw85::overlap(&r12, &q1, &ball(2.0)), Ok(overlap), "{xx:?}");
        let sign = pw85::compare(&r12, &q1, &ball(2.0), 1.0).unwrap();
        assert_eq!(sign, 1f64.partial_cmp(&xx).unwrap(), "{xx:?}");
    }
    let equal = pw85::compare(&r12, &ball(1.0), &ball(2.0), 1.0).unwrap();
    assert_eq!(equal, Ordering::Equal);
}

#[test]
fn hard_ellipsoids_of_hoomd_rs() {
    // The example of the type Ellipsoid of hoomd-geometry 1.1.0, documented there: equal ellipsoids
    // with the semi-axes 1, 2, 3 along the coordinates overlap in all four places.
    let q = pw85::ellipsoid(
        &[1.0, 2.0, 3.0],
        &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    );
    let q = q.unwrap();
    for r12 in [
        [0.9, 0.0, 0.0],
        [1.1, 0.0, 0.0],
        [0.0, 1.9, 0.0],
        [0.0, 2.1, 0.0],
    ] {
        assert_eq!(pw85::overlap(&r12, &q, &q), Ok(true), "{r12:?}");
    }
    // Along the coordinates they touch at twice their semi-axes.
    for k in 0..3 {
        let touching = 2.0 * (k as f64 + 1.0);
        for (distance, overlap) in [(touching * (1.0 - U), true), (touching, false)] {
            let mut r12 = [0.0; 3];
            r12[k] = distance;
            assert_eq!(pw85::overlap(&r12, &q, &q), Ok(overlap), "{r12:?}");
            r12[k] = -distance;
            assert_eq!(pw85::overlap(&r12, &q, &q), Ok(overlap), "{r12:?}");
        }
    }
}

#[test]
fn hard_ellipses_of_hoomd_rs() {
    // The separations along an axis of hoomd-geometry's test of equal ellipses with the semi-axes 1
    // and 4, and the example of its type Ellipse: the sum of the semi-axes less 0.1.
    let equal = pw85::ellipse(1.0, 4.0, 0.0).unwrap();
    for (x, overlap) in [
        (0.0, true),
        (1.0, true),
        (1.999_999, true),
        (2.000_001, false),
        (2.1, false),
    ] {
        assert_eq!(
            pw85::overlap_2d(&[x, 0.0], &equal, &equal),
            Ok(overlap),
            "{x}"
        );
    }
    let (long, round) = (
        pw85::ellipse(0.5, 3.0, 0.0).unwrap(),
        pw85::ellipse(1.0, 2.0, 0.0).unwrap(),
    );
    assert_eq!(pw85::overlap_2d(&[0.0, 4.9], &long, &round), Ok(true));
    assert_eq!(pw85::overlap_2d(&[0.0, 5.0], &long, &round), Ok(false)); // they touch
}

#[test]
fn moving_balls() {
    let (still, ball) = (pw85::Motion::default(), ball(1.0));
    let moving = pw85::Motion {
        velocity: [-2.0, 0.0, 0.0],
        ..still
    };
    let time = |t_max| pw85::first_contact(&[6.0, 0.0, 0.0], &ball, &ball, &still, &moving, t_max);
    // The search ends before contact, by less than 1e-12 of the time here: its bound is 80 u S.
    expect_near(time(f64::INFINITY).unwrap(), 2.0, 1e-12, &moving);
    assert_eq!(time(1.5), Ok(f64::INFINITY));
    let grows = pw85::Motion {
        growth: 0.5,
        ..still
    };
    let found = pw85::first_contact(&[6.0, 0.0, 0.0], &ball, &ball, &grows, &grows, 9.0).unwrap();
    expect_near(found, 4.0, 1e-12, &grows); // 2 (1 + t/2) = 6
    let mut times = [0.0; 2];
    let (r12, motions) = ([[6.0, 0.0, 0.0]; 2], [moving, still]);
    pw85::first_contact_batch(
        &r12,
        &[ball; 2],
        &[ball; 2],
        &[still; 2],
        &motions,
        9.0,
        &mut times,
    )
    .unwrap();
    expect_near(times[0], 2.0, 1e-12, &times);
    assert_eq!(times[1], f64::INFINITY);
}

#[test]
fn matrices_have_their_rows() {
    // A quarter turn about z takes the first semi-axis to y.
    let turn = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let found = pw85::ellipsoid(&[3.0, 2.0, 1.0], &turn).unwrap();
    assert_eq!(found, [4.0, 0.0, 0.0, 9.0, 0.0, 1.0]);
    let half = 0.5f64.sqrt();
    let s = pw85::ellipsoid_factor(&[3.0, 2.0, 1.0], &[half, 0.0, 0.0, half]).unwrap();
    let truth = [[0.0, -2.0, 0.0], [3.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    for i in 0..3 {
        for j in 0..3 {
            // The entries of a rotation by a quaternion err by a few u.
            assert!((s[i][j] - truth[i][j]).abs() <= 16.0 * U, "{s:?}");
        }
    }
    let found = pw85::contact_hessian(&[3.0, 0.0, 0.0], &ball(1.0), &ball(1.0), 0.5).unwrap();
    // mu2 = r12 squared/4 for unit balls.
    expect_near(found[0][0], 0.5, 64.0 * U, &found);
    expect_near(found[2][2], 0.5, 64.0 * U, &found);
}

/// A multiple of 1/65536 in [0, 1), by the generator of Lehmer.
fn uniform(state: &mut u64) -> f64 {
    *state = *state * 16807 % 2147483647;
    (*state % 65536) as f64 / 65536.0
}

#[test]
fn rows_are_pairs_in_any_order() {
    let (state, n) = (&mut 1, 257);
    let mut next = |from: f64, to: f64| from + (to - from) * uniform(state);
    let mut form = || {
        let axes = [0; 3].map(|_| next(0.25, 4.0));
        pw85::ellipsoid_quaternion(&axes, &[0; 4].map(|_| next(-1.0, 1.1))).unwrap()
    };
    let q1: Vec<_> = (0..n).map(|_| form()).collect();
    let q2: Vec<_> = (0..n).map(|_| form()).collect();
    let r12: Vec<_> = (0..n).map(|_| [0; 3].map(|_| next(-4.0, 4.0))).collect();
    let (mut mu2, mut overlap, mut distance) = (vec![0.0; n], vec![0; n], vec![0.0; n]);
    let mut point = vec![[0.0; 3]; n];
    pw85::contact_batch(&r12, &q1, &q2, &mut mu2, None).unwrap();
    pw85::overlap_batch(&r12, &q1, &q2, &mut overlap).unwrap();
    pw85::distance_batch(&r12, &q1, &q2, Some(&mut distance), None, Some(&mut point)).unwrap();
    let mut again = vec![0.0; n];
    let turned = |rows: &[[f64; 6]]| rows.iter().rev().copied().collect::<Vec<_>>();
    let r21: Vec<_> = r12.iter().rev().copied().collect();
    pw85::contact_batch(&r21, &turned(&q1), &turned(&q2), &mut again, None).unwrap();
    again.reverse();
    assert_eq!(again, mu2);
    for i in 0..n {
        let pair = (r12[i], q1[i], q2[i]);
        let one = pw85::contact(&r12[i], &q1[i], &q2[i]).unwrap();
        // Both err by 4 u cond at most.
        let cond = pw85::condition(&r12[i], &q1[i], &q2[i], one.lambda).unwrap();
        expect_near(mu2[i], one.mu2, 8.0 * U * cond, &pair);
        let decided = pw85::overlap(&r12[i], &q1[i], &q2[i]).unwrap();
        assert_eq!(overlap[i], u8::from(decided), "{pair:?}");
        let found = pw85::distance(&r12[i], &q1[i], &q2[i]).unwrap();
        assert_eq!(distance[i] == 0.0, decided, "{pair:?}");
        assert!((found.distance - distance[i]).abs() <= 1e-12, "{pair:?}");
        assert_eq!(found.point2[0].is_nan(), point[i][0].is_nan(), "{pair:?}");
    }
}

#[test]
fn smallest_ellipsoids() {
    let mut q = [0.0; 10];
    let cube: Vec<[f64; 4]> = (0..16)
        .map(|k| [1, 2, 4, 8].map(|bit| if k & bit == 0 { -1.0 } else { 1.0 }))
        .collect();
    let found = pw85::enclosing_ellipsoid(&cube, 1e-9, &mut q).unwrap();
    assert!(found.excess <= 1e-9, "{found:?}");
    // A volume that exceeds the least one by e has semi-axes that err by no more than about sqrt(e).
    let truth = [4.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 4.0, 0.0, 4.0];
    assert!(
        q.iter().zip(truth).all(|(a, b)| (a - b).abs() < 4e-4),
        "{q:?}"
    );
    let mut points = vec![[0.0; 3]; 1000];
    pw85::random_points(&[9.0, 0.0, 0.0, 4.0, 0.0, 1.0], true, 7, &mut points).unwrap();
    for [x, y, z] in points {
        expect_near(x * x / 9.0 + y * y / 4.0 + z * z, 1.0, 80.0 * U, &[x, y, z]);
    }
}
