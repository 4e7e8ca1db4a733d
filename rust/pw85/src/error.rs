// SPDX-License-Identifier: BSD-3-Clause
//! Causes of errors, and the checks of slices.

use crate::questions::STATUSES;
use crate::Status;
use core::{fmt, ptr, slice, str};
use pw85_sys as sys;

/// The cause for which a call was refused: which argument, which row, and what it must be.
///
/// ```
/// let q = [1.0, 0.0, 0.0, 1.0, 0.0, 1.0];
/// let error = pw85::contact(&[3.0, 0.0, 0.0], &q, &[-1.0; 6]).unwrap_err();
/// assert_eq!(error.status, pw85::Status::NotPositiveDefinite);
/// assert_eq!(error.argument, Some("q2"));
/// assert_eq!(error.to_string(), "pw85_contact: q2 must be positive definite");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Error {
    /// What kind of cause it is.
    pub status: Status,
    /// The function of C that refused the call. For a bad row it is the function of one row.
    pub function: &'static str,
    /// The argument, if the cause is one.
    pub argument: Option<&'static str>,
    /// What the argument must be, as "must be positive definite"; a sentence without an argument.
    pub requirement: &'static str,
    /// The first bad row, from 0, of a function of many rows.
    pub row: Option<usize>,
    /// The entry of the row, from 0, and the number that it has, if the cause is one number.
    pub entry: Option<(usize, f64)>,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: ", self.function)?;
        if let Some(argument) = self.argument {
            write!(f, "{argument} ")?;
        }
        f.write_str(self.requirement)?;
        if let Some((_, value)) = self.entry {
            write!(f, ", not {value:?}")?;
        }
        match (self.row, self.entry) {
            (Some(row), Some((entry, _))) => write!(f, " (row {row}, entry {entry})"),
            (Some(row), None) => write!(f, " (row {row})"),
            (None, Some((entry, _))) => write!(f, " (entry {entry})"),
            (None, None) => Ok(()),
        }
    }
}

impl From<i32> for Status {
    fn from(number: i32) -> Self {
        let known = STATUSES.iter().find(|one| **one as i32 == number);
        *known.unwrap_or(&Status::Unknown)
    }
}

#[cfg(feature = "std")]
impl std::error::Error for Error {}

/// A text of the library, which is there as long as the process; none for a null pointer.
///
/// # Safety
///
/// `start` is null or a constant of the library, with a zero at its end.
pub(crate) unsafe fn text(start: *const sys::c_char) -> Option<&'static str> {
    if start.is_null() {
        return None;
    }
    let length = (0..).take_while(|&k| *start.add(k) != 0).count();
    str::from_utf8(slice::from_raw_parts(start.cast(), length)).ok()
}

/// The cause that the library has on record, directly after a call returned this status.
#[cold]
#[inline(never)]
fn cause(status: i32, is_of_rows: bool) -> Error {
    let mut record = sys::pw85_error {
        status: 0,
        function: ptr::null(),
        argument: ptr::null(),
        requirement: ptr::null(),
        row: 0,
        entry: 0,
        value: f64::NAN,
    };
    unsafe {
        sys::pw85_last_error(&mut record);
        let meaning = text(sys::pw85_strerror(status)).unwrap_or("");
        Error {
            status: status.into(),
            function: text(record.function).unwrap_or("pw85"),
            argument: text(record.argument),
            requirement: text(record.requirement).unwrap_or(meaning),
            row: is_of_rows.then_some(record.row),
            entry: (!record.value.is_nan()).then_some((record.entry, record.value)),
        }
    }
}

/// The result of a function of one row.
#[inline]
pub(crate) fn check(status: i32) -> Result<(), Error> {
    if status == 0 {
        Ok(())
    } else {
        Err(cause(status, false))
    }
}

/// The result of a function of many rows.
#[inline]
pub(crate) fn check_rows(status: i32) -> Result<(), Error> {
    if status == 0 {
        Ok(())
    } else {
        Err(cause(status, true))
    }
}

/// The result of a function that returns no status: NaN if it was refused.
#[inline]
pub(crate) fn check_number(number: f64) -> Result<(), Error> {
    if number.is_nan() {
        Err(cause(1, false))
    } else {
        Ok(())
    }
}

/// How many rows an output has; n if it is not asked for.
pub(crate) fn rows_of<T>(given: &Option<&mut [T]>, n: usize) -> usize {
    given.as_ref().map_or(n, |rows| rows.len())
}

/// An output as C takes it.
pub(crate) fn pointer<T>(given: Option<&mut [T]>) -> *mut f64 {
    given.map_or(ptr::null_mut(), |rows| rows.as_mut_ptr().cast())
}

/// An argument that the library cannot be given.
#[cold]
pub(crate) fn refused(
    function: &'static str,
    argument: &'static str,
    requirement: &'static str,
) -> Error {
    let status = Status::InvalidArgument;
    let argument = Some(argument);
    Error {
        status,
        function,
        argument,
        requirement,
        row: None,
        entry: None,
    }
}

/// Refuses the first slice that has not n rows.
pub(crate) fn same_rows(
    function: &'static str,
    requirement: &'static str,
    n: usize,
    counts: &[(&'static str, usize)],
) -> Result<(), Error> {
    match counts.iter().find(|(_, count)| *count != n) {
        None => Ok(()),
        Some((argument, _)) => Err(refused(function, argument, requirement)),
    }
}
