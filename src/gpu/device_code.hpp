// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The compiled program for the device (device.cpp), as a part of the library. embed.py makes its
/// definition; gpu.cpp loads it.
#ifndef PW85_GPU_DEVICE_CODE_HPP_INCLUDED
#define PW85_GPU_DEVICE_CODE_HPP_INCLUDED

namespace pw85::detail::gpu {

/// Program text in the language PTX, which the driver compiles. It is empty if the library was
/// built without a compiler for devices.
extern char const device_code[];

} // namespace pw85::detail::gpu

#endif
