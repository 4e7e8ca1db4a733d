// SPDX-License-Identifier: BSD-3-Clause
//! Nanoseconds per pair by this crate, and by the C functions that it calls, of 4,096 pairs: one by
//! one and as rows. The two take turns, and the least of 200 times counts.
//!
//! cargo run --release --example speed

use pw85_sys as sys;
use std::ptr::null_mut;
use std::time::Instant;

const N: usize = 4096;

/// A multiple of 1/65536 in [0, 1), by the generator of Lehmer.
fn uniform(state: &mut u64) -> f64 {
    *state = *state * 16807 % 2147483647;
    (*state % 65536) as f64 / 65536.0
}

fn time(run: &mut dyn FnMut()) -> f64 {
    let start = Instant::now();
    run();
    start.elapsed().as_nanos() as f64 / N as f64
}

fn compare(name: &str, rust: &mut dyn FnMut(), c: &mut dyn FnMut()) {
    let mut best = [f64::INFINITY; 2];
    for _ in 0..200 {
        best = [best[0].min(time(rust)), best[1].min(time(c))];
    }
    let ratio = best[0] / best[1];
    println!(
        "{name:24} Rust {:8.2}  C {:8.2}  ratio {ratio:.3}",
        best[0], best[1]
    );
}

fn main() -> Result<(), pw85::Error> {
    let state = &mut 1;
    let mut form = || {
        let semi_axes = [0; 3].map(|_| 0.25 + 2.0 * uniform(state));
        pw85::ellipsoid_quaternion(&semi_axes, &[0; 4].map(|_| uniform(state) - 0.4))
    };
    let q1 = (0..N).map(|_| form()).collect::<Result<Vec<_>, _>>()?;
    let q2 = (0..N).map(|_| form()).collect::<Result<Vec<_>, _>>()?;
    let r12: Vec<_> = (0..N)
        .map(|_| [0; 3].map(|_| 5.0 * uniform(state) - 2.0))
        .collect();
    let inputs = (r12.as_ptr().cast(), q1.as_ptr().cast(), q2.as_ptr().cast());
    let [mut a, mut b] = [0; 2].map(|_| vec![0.0; N]);
    let mut bytes = vec![0u8; N];
    compare(
        "overlap",
        &mut || {
            (0..N).for_each(|i| bytes[i] = pw85::overlap(&r12[i], &q1[i], &q2[i]).unwrap().into())
        },
        &mut || {
            for i in 0..N {
                let (r, p, q) = (r12[i].as_ptr(), q1[i].as_ptr(), q2[i].as_ptr());
                let mut overlap = 0;
                assert_eq!(unsafe { sys::pw85_overlap(r, p, q, &mut overlap) }, 0);
                a[i] = overlap.into();
            }
        },
    );
    compare(
        "contact",
        &mut || (0..N).for_each(|i| b[i] = pw85::contact(&r12[i], &q1[i], &q2[i]).unwrap().mu2),
        &mut || {
            for i in 0..N {
                let (r, p, q) = (r12[i].as_ptr(), q1[i].as_ptr(), q2[i].as_ptr());
                let mut out = [0.0; 2];
                assert_eq!(unsafe { sys::pw85_contact(r, p, q, out.as_mut_ptr()) }, 0);
                a[i] = out[0];
            }
        },
    );
    let (r, p, q) = inputs;
    let (pa, pb, pu) = (a.as_mut_ptr(), b.as_mut_ptr(), bytes.as_mut_ptr());
    compare(
        "overlap_batch",
        &mut || pw85::overlap_batch(&r12, &q1, &q2, &mut bytes).unwrap(),
        &mut || assert_eq!(unsafe { sys::pw85_overlap_batch(N, r, p, q, pu) }, 0),
    );
    compare(
        "contact_batch",
        &mut || pw85::contact_batch(&r12, &q1, &q2, &mut a, Some(&mut b)).unwrap(),
        &mut || assert_eq!(unsafe { sys::pw85_contact_batch(N, r, p, q, pa, pb) }, 0),
    );
    compare(
        "distance_batch",
        &mut || pw85::distance_batch(&r12, &q1, &q2, Some(&mut a), None, None).unwrap(),
        &mut || {
            let (none1, none2) = (null_mut(), null_mut());
            assert_eq!(
                unsafe { sys::pw85_distance_batch(N, r, p, q, pa, none1, none2) },
                0
            );
        },
    );
    compare(
        "overlap_volume_batch",
        &mut || pw85::overlap_volume_batch(&r12, &q1, &q2, &mut a).unwrap(),
        &mut || assert_eq!(unsafe { sys::pw85_overlap_volume_batch(N, r, p, q, pa) }, 0),
    );
    Ok(())
}
