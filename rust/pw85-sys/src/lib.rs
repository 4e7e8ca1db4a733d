// SPDX-License-Identifier: BSD-3-Clause
//! The declarations of the C library pw85. Its headers document them; the crate `pw85` is the safe
//! way to call them.
#![no_std]
#![allow(non_camel_case_types)]

#[rustfmt::skip]
mod functions;

pub use functions::*;

/// `int` of C, on all machines for which the library is made.
pub type c_int = i32;
/// A byte of a text of C, whether `char` has a sign there or not.
pub type c_char = u8;

/// Motion of an ellipsoid.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct pw85_motion {
    /// Velocity of the centre.
    pub velocity: [f64; 3],
    /// Angular velocity about the centre, in radians per unit of time.
    pub angular_velocity: [f64; 3],
    /// At time t the semi-axes are 1 + growth t times those at time 0.
    pub growth: f64,
}

/// The cause for which a call was refused. The texts are constants of the library, or null.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct pw85_error {
    /// Status that the function returned.
    pub status: c_int,
    /// Name of the function; null if there is no refusal.
    pub function: *const c_char,
    /// Name of the argument; null if the cause is not one argument.
    pub argument: *const c_char,
    /// What the argument must be, or a sentence.
    pub requirement: *const c_char,
    /// Row of the arrays, from 0.
    pub row: usize,
    /// Entry of the row, from 0.
    pub entry: usize,
    /// The entry, or NaN.
    pub value: f64,
}

extern "C" {
    /// Writes the cause of the last refusal in the calling thread, and forgets it.
    pub fn pw85_last_error(error: *mut pw85_error) -> c_int;
}
