// Replaces the source that embed.py makes if no compiler for devices is available.
#include "device_code.hpp"

char const pw85::detail::gpu::device_code[] = "";
