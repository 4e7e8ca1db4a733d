// SPDX-License-Identifier: BSD-3-Clause
// All headers of C++, after those of others: the standard library, Boost, Eigen and TBB, where
// these are, and then macros, which the standard library of GCC cannot bear. Their macros are as
// before behind our headers.
#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#if __has_include(<boost/math/constants/constants.hpp>)
#include <boost/math/constants/constants.hpp>
#endif
#if __has_include(<eigen3/Eigen/Core>)
#include <eigen3/Eigen/Core>
#endif
#if __has_include(<tbb/blocked_range.h>)
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include "others.h"

#include "every_header.hpp"

extern "C" int success_of_c(void);

#if !defined(near) || !defined(far) || !defined(small) || !defined(min) || !defined(max) ||        \
    !defined(Status)
#error "a macro of others is not defined any more"
#endif
static_assert(std::is_same_v<Status, int>, "and it is what it was");

int main()
{
    pw85::Vector<double, 3> const r12{3.0, 0.0, 0.0};
    pw85::SymmetricMatrix<double, 3> const q{1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    auto const distance = pw85::distance(r12, q, q);
    return distance.status == pw85::StatusCode::success && distance.distance == 1.0 ? success_of_c()
                                                                                    : 1;
}
