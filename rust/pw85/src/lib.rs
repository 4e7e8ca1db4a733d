// SPDX-License-Identifier: BSD-3-Clause
#![doc = include_str!("../README.md")]
#![no_std]
#![warn(missing_docs)]

#[cfg(feature = "std")]
extern crate std;

mod error;
#[rustfmt::skip]
#[allow(clippy::too_many_arguments)]
mod questions;
mod settings;
mod shapes;

pub use error::Error;
pub use pw85_sys::pw85_motion as Motion;
pub use questions::*;
pub use settings::*;
pub use shapes::*;
