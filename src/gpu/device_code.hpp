/// @file
/// The program for the device, device.cpp, in the library.
#ifndef PW85_GPU_DEVICE_CODE_HPP_INCLUDED
#define PW85_GPU_DEVICE_CODE_HPP_INCLUDED

namespace pw85::detail::gpu {

/// Text that the driver compiles; empty where the library was built without a compiler for devices.
extern char const device_code[];

} // namespace pw85::detail::gpu

#endif
