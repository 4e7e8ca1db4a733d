// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Headers of neighbours and simulations, precompiled with -Dprecompiled=true.
#ifndef PW85_PCH_LIBRARY_HPP_INCLUDED
#define PW85_PCH_LIBRARY_HPP_INCLUDED

#include "../base/c_arrays.hpp"
#include "../rows/many_pairs.hpp"
#include "../simulation/model.hpp"

#endif
