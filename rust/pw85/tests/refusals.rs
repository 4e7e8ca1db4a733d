// SPDX-License-Identifier: BSD-3-Clause
//! Bad input: each call gives an error that names the argument and, of many rows, the row.

use pw85::{Error, Status};

const BALL: [f64; 6] = [1.0, 0.0, 0.0, 1.0, 0.0, 1.0];
const R12: [f64; 3] = [3.0, 0.0, 0.0];

#[test]
fn numbers_that_are_not_finite() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for entry in 0..3 {
            let mut r12 = R12;
            r12[entry] = bad;
            let error = pw85::contact(&r12, &BALL, &BALL).unwrap_err();
            assert_eq!(error.status, Status::InvalidArgument, "{r12:?}");
            assert_eq!(error.function, "pw85_contact");
            assert_eq!(error.argument, Some("r12"), "{r12:?}");
            assert_eq!(error.row, None);
            let expected = if bad.is_nan() {
                None
            } else {
                Some((entry, bad))
            };
            assert_eq!(error.entry, expected, "{r12:?}");
        }
        for entry in 0..6 {
            let mut q2 = BALL;
            q2[entry] = bad;
            let error = pw85::distance(&R12, &BALL, &q2).unwrap_err();
            assert_eq!(error.argument, Some("q2"), "{q2:?}");
        }
    }
}

#[test]
fn forms_that_are_not_positive_definite() {
    for bad in [
        [0.0; 6],
        [-1.0, 0.0, 0.0, -1.0, 0.0, -1.0],
        [1.0, 2.0, 0.0, 1.0, 0.0, 1.0],
    ] {
        let error = pw85::overlap(&R12, &bad, &BALL).unwrap_err();
        assert_eq!(
            (error.status, error.argument),
            (Status::NotPositiveDefinite, Some("q1")),
            "{bad:?}"
        );
        assert_eq!(
            pw85::volume(&bad).unwrap_err().argument,
            Some("q"),
            "{bad:?}"
        );
    }
}

#[test]
fn other_arguments() {
    let error = pw85::spheroid(-1.0, 1.0, &[0.0, 0.0, 1.0]).unwrap_err();
    assert_eq!(
        (error.status, error.argument),
        (Status::InvalidArgument, Some("a"))
    );
    assert_eq!(
        error.to_string(),
        "pw85_spheroid: a must be > 0, not -1.0 (entry 0)"
    );
    assert_eq!(
        pw85::spheroid(1.0, 1.0, &[0.0; 3]).unwrap_err().argument,
        Some("n")
    );
    assert_eq!(
        pw85::ellipse(1.0, 0.0, 0.0).unwrap_err().argument,
        Some("b")
    );
    assert_eq!(
        pw85::condition(&R12, &BALL, &BALL, 1.5)
            .unwrap_err()
            .argument,
        Some("lambda")
    );
    let error = pw85::contact_geometry(&[0.0; 3], &BALL, &BALL, 0.5).unwrap_err();
    assert_eq!(error.argument, Some("r12"));
    let shrinks = pw85::Motion {
        growth: -1.0,
        ..Default::default()
    };
    let still = pw85::Motion::default();
    let error = pw85::first_contact(&R12, &BALL, &BALL, &still, &shrinks, 2.0).unwrap_err();
    assert_eq!(error.argument, Some("motion2"));
    assert_eq!(
        pw85::inertia(&[0.0; 6], true).unwrap_err().argument,
        Some("q")
    );
    assert_eq!(
        pw85::random_points(&[0.0; 6], true, 1, &mut [])
            .unwrap_err()
            .argument,
        Some("q")
    );
}

#[test]
fn the_first_bad_row_is_named_and_the_others_are_computed() {
    for n in [1, 7, 64, 1000] {
        for bad in [0, n / 2, n - 1] {
            let r12 = vec![R12; n];
            let q1 = vec![BALL; n];
            let mut q2 = vec![BALL; n];
            q2[bad..].fill([-1.0; 6]);
            let mut distance = vec![0.0; n];
            let found = pw85::distance_batch(&r12, &q1, &q2, Some(&mut distance), None, None);
            let error = found.unwrap_err();
            assert_eq!(error.status, Status::NotPositiveDefinite);
            assert_eq!(
                (error.argument, error.row),
                (Some("q2"), Some(bad)),
                "{n} rows"
            );
            let text = format!("pw85_distance: q2 must be positive definite (row {bad})");
            assert_eq!(error.to_string(), text);
            assert!(
                distance[..bad].iter().all(|d| (d - 1.0).abs() < 1e-15),
                "{distance:?}"
            );
            assert!(distance[bad..].iter().all(|d| d.is_nan()), "{distance:?}");
        }
    }
}

#[test]
fn bad_rows_of_truth_values_are_marked() {
    let mut overlap = [7; 3];
    let q2 = [BALL, [0.0; 6], [9.0, 0.0, 0.0, 9.0, 0.0, 9.0]];
    let error = pw85::overlap_batch(&[R12; 3], &[BALL; 3], &q2, &mut overlap).unwrap_err();
    assert_eq!(error.row, Some(1));
    assert_eq!(overlap, [0, 255, 1]);
    let r12 = [[f64::INFINITY, 0.0, 0.0]; 1];
    let error = pw85::overlap_batch(&r12, &[BALL], &[BALL], &mut overlap[..1]).unwrap_err();
    assert!(
        error.to_string().ends_with(", not inf (row 0, entry 0)"),
        "{error}"
    );
}

/// Refusals of a slice with one row less or one more than the others.
fn expect_length(argument: &str, first: &str, result: Result<(), Error>) {
    let error = result.unwrap_err();
    assert_eq!(
        (error.status, error.argument),
        (Status::InvalidArgument, Some(argument))
    );
    assert_eq!(
        error.requirement,
        format!("must have as many rows as {first}")
    );
    assert_eq!((error.row, error.entry), (None, None));
}

#[test]
fn slices_of_other_lengths() {
    for wrong in [0, 2, 4] {
        let (r, q) = (vec![R12; wrong], vec![BALL; wrong]);
        let (r3, q3) = ([R12; 3], [BALL; 3]);
        let (mut a, mut b) = ([0.0; 3], vec![0.0; wrong]);
        expect_length("q1", "r12", pw85::contact_batch(&r3, &q, &q3, &mut a, None));
        expect_length("q2", "r12", pw85::contact_batch(&r3, &q3, &q, &mut a, None));
        expect_length(
            "mu2",
            "r12",
            pw85::contact_batch(&r3, &q3, &q3, &mut b, None),
        );
        expect_length(
            "lambda",
            "r12",
            pw85::contact_batch(&r3, &q3, &q3, &mut a, Some(&mut b)),
        );
        assert_eq!(a, [0.0; 3], "nothing is written");
        let mut points = vec![[0.0; 3]; wrong];
        let found = pw85::distance_batch(&r3, &q3, &q3, None, None, Some(&mut points));
        expect_length("point2", "r12", found);
        expect_length(
            "q",
            "normals",
            pw85::contact_plane_batch(&r3, &a, &q, None, None),
        );
        assert_eq!(
            pw85::overlap_any(&BALL, &r3, &q).unwrap_err().argument,
            Some("q2")
        );
        assert_eq!(
            pw85::contact_polytope(&r3, &b, &BALL).unwrap_err().argument,
            Some("offsets")
        );
        assert_eq!(
            pw85::overlap_polytope(&r3, &b, &BALL).unwrap_err().argument,
            Some("offsets")
        );
        // The lengths are those of the slices, whatever the first one is.
        expect_length("q1", "r12", pw85::contact_batch(&r, &q3, &q3, &mut a, None));
    }
}

#[test]
fn empty_slices_are_no_rows() {
    assert_eq!(pw85::contact_batch(&[], &[], &[], &mut [], None), Ok(()));
    assert_eq!(
        pw85::distance_batch(&[], &[], &[], Some(&mut []), None, None),
        Ok(())
    );
    assert_eq!(pw85::overlap_batch_2d(&[], &[], &[], &mut []), Ok(()));
    assert_eq!(pw85::overlap_any(&BALL, &[], &[]), Ok(false));
    assert_eq!(pw85::overlap_polytope(&[], &[], &BALL), Ok(true));
    assert_eq!(pw85::random_points(&BALL, false, 0, &mut []), Ok(()));
    assert_eq!(pw85::rows::<3>(&[]).unwrap().len(), 0);
}

#[test]
fn numbers_that_are_not_whole_rows() {
    let mut numbers = [0.0; 7];
    for n in [1, 2, 4, 5, 7] {
        let error = pw85::rows::<3>(&numbers[..n]).unwrap_err();
        assert_eq!(error.to_string(), "rows: numbers must be whole rows");
        assert!(pw85::rows_mut::<3>(&mut numbers[..n]).is_err());
    }
    assert!(pw85::rows::<0>(&numbers).is_err());
    assert_eq!(pw85::rows::<3>(&numbers[1..]).unwrap(), [[0.0; 3]; 2]); // a view
}

#[test]
fn smallest_ellipsoids_that_do_not_exist() {
    let mut q = [0.0; 3];
    let line = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0], [5.0, 5.0]];
    let error = pw85::enclosing_ellipsoid(&line, 1e-3, &mut q).unwrap_err();
    assert_eq!(error.status, Status::NotPositiveDefinite);
    let error = pw85::enclosing_ellipsoid(&line[..2], 1e-3, &mut q).unwrap_err();
    assert_eq!(error.status, Status::InvalidArgument);
    let square = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, f64::NAN]];
    let error = pw85::enclosing_ellipsoid(&square, 1e-3, &mut q).unwrap_err();
    assert_eq!(error.argument, Some("points"));
    let error = pw85::enclosing_ellipsoid(&square[..3], -1.0, &mut q).unwrap_err();
    assert_eq!(error.argument, Some("tolerance"));
    for wrong in [0, 2, 4] {
        let error = pw85::enclosing_ellipsoid(&line, 1e-3, &mut vec![0.0; wrong]).unwrap_err();
        assert_eq!(error.argument, Some("q"));
        let (centers, forms) = ([[0.0; 2]; 1], vec![1.0; wrong]);
        let error = pw85::enclosing_ellipsoid_of(&centers, &forms, 1e-3, &mut q).unwrap_err();
        assert_eq!(error.argument, Some("forms"));
    }
    let error = pw85::enclosing_ellipsoid(&[[0.0; 17]; 20], 1e-3, &mut [0.0; 153]).unwrap_err();
    assert_eq!(error.requirement, "must be of 1 to 16 dimensions");
    // A tolerance that rounding does not allow is told by the excess.
    let found = pw85::enclosing_ellipsoid(&[[0.1, 0.2], [0.7, 0.3], [0.5, 0.9]], 1e-300, &mut q);
    assert!(found.unwrap().excess > 1e-300);
}

/// A text in an array, without memory of the heap.
struct Fixed([u8; 80], usize);

impl std::fmt::Write for Fixed {
    fn write_str(&mut self, text: &str) -> std::fmt::Result {
        let room = self.0[self.1..]
            .get_mut(..text.len())
            .ok_or(std::fmt::Error)?;
        room.copy_from_slice(text.as_bytes());
        self.1 += text.len();
        Ok(())
    }
}

#[test]
fn errors_are_shown_without_memory_of_the_heap() {
    let mut text = Fixed([0; 80], 0);
    let error = pw85::contact(&R12, &BALL, &[-1.0; 6]).unwrap_err();
    std::fmt::write(&mut text, format_args!("{error}")).unwrap();
    assert_eq!(
        &text.0[..text.1],
        b"pw85_contact: q2 must be positive definite"
    );
}

#[test]
fn errors_go_to_other_threads_and_each_thread_has_its_own() {
    fn is_shared<T: Send + Sync + Copy + 'static>() {}
    is_shared::<Error>();
    is_shared::<pw85::Contact>();
    is_shared::<pw85::Motion>();
    let threads = (0..4).map(|k| {
        std::thread::spawn(move || {
            (0..1000).all(|_| {
                let forms = if k % 2 == 0 {
                    (&BALL, &[0.0; 6])
                } else {
                    (&[0.0; 6], &BALL)
                };
                let error = pw85::contact(&R12, forms.0, forms.1).unwrap_err();
                error.argument == Some(if k % 2 == 0 { "q2" } else { "q1" })
            })
        })
    });
    assert!(threads
        .collect::<Vec<_>>()
        .into_iter()
        .all(|one| one.join().unwrap()));
}

#[cfg(feature = "std")]
#[test]
fn an_error_is_an_error_of_std() {
    fn fails() -> Result<f64, Box<dyn std::error::Error + Send + Sync>> {
        Ok(pw85::volume(&[0.0; 6])?)
    }
    assert_eq!(
        fails().unwrap_err().to_string(),
        "pw85_volume: q must be positive definite"
    );
}
