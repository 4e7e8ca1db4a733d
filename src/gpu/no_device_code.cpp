#include "device_code.hpp"

char const pw85::detail::gpu::device_code[] = "";
