#include "device_code.hpp"

char const pw85::gpu::device_code[] = "";
