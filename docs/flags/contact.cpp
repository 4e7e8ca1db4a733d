#include <cstdio>
#include <limits>

#include <pw85/pw85.hpp>

int main()
{
    double const nan = std::numeric_limits<double>::quiet_NaN();
    pw85::SymmetricMatrix<double, 3> const sphere{1.0, 0.0, 0.0, 1.0, 0.0, 1.0};
    auto const good = pw85::contact(pw85::Vector{3.0, 0.0, 0.0}, sphere, sphere);
    auto const bad = pw85::contact(pw85::Vector{nan, 0.0, 0.0}, sphere, sphere);
    std::printf("mu^2 = %g, %s; %s\n", good.mu2, pw85::strerror(good.status),
                bad.status == pw85::Status::invalid_argument ? "NaN is seen"
                                                             : "NaN is not seen");
}
