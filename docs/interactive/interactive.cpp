// What the interactive page computes, for WebAssembly: the page writes its input into `input`,
// calls evaluate(), and reads `output`.
#include <pw85/pw85.hpp>

namespace {

using Vector3 = pw85::Vector<double, 3>;
using Quaternion = pw85::Vector<double, 4>;

struct Input {
    Vector3 semi_axes1;
    Quaternion quaternion1;
    Vector3 semi_axes2;
    Quaternion quaternion2;
    Vector3 r12;
};

constexpr int samples = 101;

struct Output {
    double status, mu2, lambda, distance;
    Vector3 point, normal, closest1, closest2;
    double f[samples]; // at λ = 0, 0.01 ... 1
};

} // namespace

extern "C" {

[[gnu::visibility("default")]] Input input;
[[gnu::visibility("default")]] Output output;

[[gnu::visibility("default")]] void evaluate()
{
    auto const q1 = pw85::ellipsoid_quaternion(input.semi_axes1, input.quaternion1).q;
    auto const q2 = pw85::ellipsoid_quaternion(input.semi_axes2, input.quaternion2).q;
    auto const contact = pw85::contact(input.r12, q1, q2);
    auto const geometry = pw85::contact_geometry(input.r12, q1, q2, contact.lambda);
    auto const gap = pw85::distance(input.r12, q1, q2);
    output.status = static_cast<int>(contact.status);
    output.mu2 = contact.mu2;
    output.lambda = contact.lambda;
    output.distance = gap.distance;
    output.point = geometry.point;
    output.normal = geometry.normal;
    output.closest1 = gap.point1;
    output.closest2 = gap.point2;
    for (int i = 0; i < samples; ++i) {
        double const lambda = i / (samples - 1.0);
        output.f[i] = pw85::detail::checked_f(lambda, input.r12, q1, q2);
    }
}
// What the compiler calls, as there is no library here.

[[gnu::noinline]] void *memset(void *to, int byte, unsigned long size)
{
    auto volatile *const bytes = static_cast<unsigned char *>(to);
    for (unsigned long i = 0; i < size; ++i)
        bytes[i] = static_cast<unsigned char>(byte);
    return to;
}

double frexp(double x, int *exponent)
{
    *exponent = 0;
    if (x == 0 || x - x != 0) return x;
    int shift = 0;
    if (__builtin_fabs(x) < 0x1p-1022) {
        x *= 0x1p54;
        shift = -54;
    }
    auto const bits = __builtin_bit_cast(unsigned long long, x);
    *exponent = static_cast<int>(bits >> 52 & 0x7ff) - 1022 + shift;
    return __builtin_bit_cast(double, (bits & ~(0x7ffull << 52)) | (1022ull << 52));
}

// The product of two numbers of 128 bits, by halves of halves.
__int128 __multi3(__int128 a, __int128 b)
{
    using Half = unsigned long long;
    using Whole = unsigned __int128;
    Half const low = 0xffffffff, a0 = static_cast<Half>(a), b0 = static_cast<Half>(b);
    Half const p = (a0 & low) * (b0 & low), q = (a0 >> 32) * (b0 & low),
               r = (a0 & low) * (b0 >> 32);
    Half const middle = (p >> 32) + (q & low) + (r & low);
    Half const high = (a0 >> 32) * (b0 >> 32) + (q >> 32) + (r >> 32) + (middle >> 32) +
                      static_cast<Half>(a >> 64) * b0 + a0 * static_cast<Half>(b >> 64);
    return static_cast<__int128>(static_cast<Whole>(high) << 64 |
                                 (middle << 32 | (p & low)));
}
}
