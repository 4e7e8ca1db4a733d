// SPDX-License-Identifier: BSD-3-Clause
//! The version, the reproducible mode, and rows of plain numbers.

use crate::error::{refused, text, Error};
use core::slice;
use pw85_sys as sys;

/// The version of the library that is linked, as "3.0.0".
///
/// ```
/// assert!(pw85::version().starts_with("3."));
/// ```
pub fn version() -> &'static str {
    unsafe { text(sys::pw85_version()) }.unwrap_or("")
}

/// Switches the reproducible mode on or off, for all threads of the process. In this mode all
/// functions give the same bits on every processor, in every language and with every number of
/// threads, and take longer.
///
/// ```
/// pw85::set_reproducible(true);
/// assert!(pw85::is_reproducible());
/// ```
pub fn set_reproducible(on: bool) {
    unsafe { sys::pw85_set_reproducible(on.into()) };
}

/// Whether the reproducible mode is on: see [`set_reproducible()`].
///
/// ```
/// let before = pw85::is_reproducible();
/// pw85::set_reproducible(!before);
/// assert_eq!(pw85::is_reproducible(), !before);
/// ```
pub fn is_reproducible() -> bool {
    let mut on = 0;
    unsafe { sys::pw85_is_reproducible(&mut on) };
    on == 1
}

/// Plain numbers as rows of N numbers, without a copy.
///
/// # Errors
///
/// The numbers are not whole rows.
///
/// ```
/// let numbers = [3.0, 2.0, 1.0, 0.0, 4.0, 0.0]; // of two vectors
/// assert_eq!(pw85::rows::<3>(&numbers)?, [[3.0, 2.0, 1.0], [0.0, 4.0, 0.0]]);
/// assert_eq!(pw85::rows::<4>(&numbers).unwrap_err().argument, Some("numbers"));
/// # Ok::<(), pw85::Error>(())
/// ```
///
/// The compiler refuses other types of numbers:
///
/// ```compile_fail,E0308
/// let single = [3.0f32, 2.0, 1.0];
/// pw85::rows::<3>(&single);
/// ```
pub fn rows<const N: usize>(numbers: &[f64]) -> Result<&[[f64; N]], Error> {
    let n = whole_rows::<N>(numbers.len())?;
    // An array has the alignment of its numbers, and no gaps.
    Ok(unsafe { slice::from_raw_parts(numbers.as_ptr().cast(), n) })
}

/// Plain numbers as rows of N numbers that can be written: see [`rows()`].
///
/// # Errors
///
/// The numbers are not whole rows.
///
/// ```
/// let mut numbers = [0.0; 6];
/// pw85::rows_mut::<3>(&mut numbers)?[1] = [3.0, 2.0, 1.0];
/// assert_eq!(numbers, [0.0, 0.0, 0.0, 3.0, 2.0, 1.0]);
/// # Ok::<(), pw85::Error>(())
/// ```
pub fn rows_mut<const N: usize>(numbers: &mut [f64]) -> Result<&mut [[f64; N]], Error> {
    let n = whole_rows::<N>(numbers.len())?;
    Ok(unsafe { slice::from_raw_parts_mut(numbers.as_mut_ptr().cast(), n) })
}

fn whole_rows<const N: usize>(count: usize) -> Result<usize, Error> {
    if N == 0 || count % N != 0 {
        return Err(refused("rows", "numbers", "must be whole rows"));
    }
    Ok(count / N)
}
