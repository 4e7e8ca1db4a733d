// SPDX-License-Identifier: BSD-3-Clause
// The functions of pw85_gpu.h for arrays on the host. They divide the arrays into pieces and call
// the functions for arrays on a device (gpu.cpp). Two pieces are in progress at any time: one is
// copied while the other one is computed.
#include <pw85_gpu.h>

#include <algorithm>
#include <cstring>
#include <span>

#include "../base/c_arrays.hpp"
#include "../base/parallel.hpp"
#include "driver.hpp"

using namespace pw85;
using namespace pw85::detail;
using namespace pw85::detail::gpu;
using pw85::detail::max_rows;
using pw85::detail::c_api::any_null;

namespace {

/// An array of rows.
struct Column {
    char *rows;
    std::size_t width; ///< bytes
};

/// The arrays of a call. The first output marks bad pairs. It is computed even if the caller passes
/// null for it. In this case its `rows` is null.
struct Table {
    std::span<Column const> inputs, outputs;

    std::size_t width() const noexcept
    {
        std::size_t sum = 0;
        for (auto const columns : {inputs, outputs})
            for (Column const &c : columns) sum += c.width;
        return sum;
    }
};

/// The number of pairs of a piece. The memory of a piece is some tens of megabytes, once pinned on
/// the host and once on the device.
constexpr std::size_t piece_size = std::size_t{1} << 17;

constexpr int max_columns = 10;

/// Copies between arrays of the caller and pinned memory, with all threads: one is slower than the
/// bus to the device.
void copy(char *to, char const *from, std::size_t size) noexcept
{
    for_all(
        size,
        [&](Range bytes) {
            std::memcpy(to + bytes.begin, from + bytes.begin, bytes.end - bytes.begin);
            return Failure{0, PW85_SUCCESS};
        },
        std::size_t{1} << 20);
}

/// The memory and the stream for one of the pieces that are in progress.
class Piece {
  public:
    Piece(Driver const &driver, Table const &table, std::size_t capacity) noexcept
        : driver_(driver), table_(table), capacity_(capacity)
    {
        std::size_t const size = table.width() * capacity;
        ready_ = driver.create_stream(&stream_, non_blocking) == 0 &&
                 driver.allocate_pinned(&pinned_, size, 0) == 0 &&
                 driver.allocate(&device_, size, stream_) == 0;
    }
    Piece(Piece const &) = delete;
    Piece &operator=(Piece const &) = delete;
    ~Piece()
    {
        if (device_ != 0) driver_.release(device_, stream_);
        if (stream_ != nullptr) driver_.synchronize(stream_);
        if (pinned_ != nullptr) driver_.release_pinned(pinned_);
        if (stream_ != nullptr) driver_.destroy_stream(stream_);
    }

    bool is_ready() const noexcept { return ready_; }

    /// Queues three steps for `count` pairs from `begin` on: copy the inputs to the device;
    /// compute(stream, count, columns); copy the outputs back.
    template <class Compute>
    int send(std::size_t begin, std::size_t count, Compute const &compute) noexcept
    {
        begin_ = begin;
        count_ = count;
        double *columns[max_columns];
        std::size_t offset = 0, k = 0;
        bool sent = true;
        for (Column const &c : table_.inputs) {
            copy(pinned(offset), c.rows + begin * c.width, count * c.width);
            sent = sent && driver_.to_device(device_ + offset, pinned(offset), count * c.width,
                                             stream_) == 0;
            columns[k++] = reinterpret_cast<double *>(device_ + offset);
            offset += capacity_ * c.width;
        }
        std::size_t const outputs = offset;
        for (Column const &c : table_.outputs) {
            columns[k++] = reinterpret_cast<double *>(device_ + offset);
            offset += capacity_ * c.width;
        }
        if (int const status = sent ? compute(stream_, count, columns) : PW85_EDEVICE)
            return status;
        return fetch(outputs) ? PW85_SUCCESS : PW85_EDEVICE;
    }

    /// Waits for the outputs and copies them to the caller's arrays. If `first_bad` is still
    /// SIZE_MAX, it becomes the index of the first bad pair.
    template <class IsBad> bool collect(std::size_t &first_bad, IsBad const &is_bad) noexcept
    {
        if (count_ == 0) return true;
        if (driver_.synchronize(stream_) != 0) return false;
        std::size_t offset = 0;
        for (Column const &c : table_.inputs) offset += capacity_ * c.width;
        for (std::size_t i = 0; first_bad == SIZE_MAX && i < count_; ++i)
            if (is_bad(pinned(offset), i)) first_bad = begin_ + i;
        for (Column const &c : table_.outputs) {
            if (c.rows != nullptr)
                copy(c.rows + begin_ * c.width, pinned(offset), count_ * c.width);
            offset += capacity_ * c.width;
        }
        count_ = 0;
        return true;
    }

  private:
    char *pinned(std::size_t offset) const noexcept
    {
        return static_cast<char *>(pinned_) + offset;
    }

    bool fetch(std::size_t offset) noexcept
    {
        bool fetched = true;
        for (Column const &c : table_.outputs) {
            fetched = fetched && driver_.to_host(pinned(offset), device_ + offset, count_ * c.width,
                                                 stream_) == 0;
            offset += capacity_ * c.width;
        }
        return fetched;
    }

    Driver const &driver_;
    Table const table_;
    std::size_t const capacity_;
    Handle stream_ = nullptr;
    void *pinned_ = nullptr;
    Address device_ = 0;
    std::size_t begin_ = 0, count_ = 0;
    bool ready_;
};

/// Computes all pieces. It returns PW85_EDEVICE if the device fails. A bad pair is not an error
/// here: its index goes to `first_bad`.
template <class Compute, class IsBad> int send_all(std::size_t n, Table const &table,
                                                   Compute const &compute, IsBad const &is_bad,
                                                   std::size_t &first_bad) noexcept
{
    Driver const *const d = driver();
    Context const context(d);
    if (context.handle() == nullptr) return PW85_EDEVICE;
    std::size_t const capacity = std::min(n, piece_size);
    Piece pieces[2] = {{*d, table, capacity}, {*d, table, capacity}};
    if (!pieces[0].is_ready() || !pieces[1].is_ready()) return PW85_EDEVICE;
    std::size_t k = 0;
    for (std::size_t begin = 0; begin < n; begin += capacity, ++k) {
        Piece &piece = pieces[k % 2];
        if (!piece.collect(first_bad, is_bad)) return PW85_EDEVICE;
        if (int const status = piece.send(begin, std::min(capacity, n - begin), compute))
            return status;
    }
    bool const earlier = pieces[k % 2].collect(first_bad, is_bad),
               later = pieces[(k + 1) % 2].collect(first_bad, is_bad);
    return earlier && later ? PW85_SUCCESS : PW85_EDEVICE;
}

struct HostPairs {
    double const *r12, *q1, *q2;
};

Column column(double const *rows, std::size_t numbers) noexcept
{
    return {reinterpret_cast<char *>(const_cast<double *>(rows)), numbers * sizeof(double)};
}

/// Computes all pairs and returns the status of the first bad one. If the device fails, all outputs
/// are filled with bytes of 255. As numbers these are NaN; for overlaps they mark a bad pair.
template <class Compute, class IsBad> int run(std::size_t n, HostPairs const &in,
                                              std::span<Column const> outputs,
                                              Compute const &compute, IsBad const &is_bad) noexcept
{
    Column const inputs[] = {column(in.r12, 3), column(in.q1, 6), column(in.q2, 6)};
    std::size_t bad = SIZE_MAX;
    int const status = send_all(n, Table{inputs, outputs}, compute, is_bad, bad);
    if (status != PW85_SUCCESS) {
        for (Column const &c : outputs)
            if (c.rows != nullptr) std::memset(c.rows, 0xff, n * c.width);
        return status;
    }
    double contact[2];
    return bad == SIZE_MAX
               ? PW85_SUCCESS
               : pw85_contact(in.r12 + 3 * bad, in.q1 + 6 * bad, in.q2 + 6 * bad, contact);
}

bool is_bad_number(char const *marks, std::size_t i) noexcept
{
    double x;
    std::memcpy(&x, marks + i * sizeof x, sizeof x);
    return x != x;
}

bool is_bad_overlap(char const *marks, std::size_t i) noexcept
{
    return static_cast<unsigned char>(marks[i]) == 255;
}

} // namespace

int pw85_gpu_contact_host(size_t n, double const *r12, double const *q1, double const *q2,
                          double *mu2, double *lambda)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, mu2)) return PW85_EINVAL;
    Column const outputs[] = {column(mu2, 1), column(lambda, 1)};
    return run(
        n, {r12, q1, q2}, {outputs, lambda == nullptr ? 1u : 2u},
        [=](Handle stream, std::size_t count, double *const *c) {
            return pw85_gpu_contact_batch(stream, count, c[0], c[1], c[2], c[3],
                                          lambda == nullptr ? nullptr : c[4]);
        },
        is_bad_number);
}

int pw85_gpu_overlap_host(size_t n, double const *r12, double const *q1, double const *q2,
                          unsigned char *overlap)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2, overlap)) return PW85_EINVAL;
    Column const outputs[] = {{reinterpret_cast<char *>(overlap), 1}};
    return run(
        n, {r12, q1, q2}, outputs,
        [](Handle stream, std::size_t count, double *const *c) {
            return pw85_gpu_overlap_batch(stream, count, c[0], c[1], c[2],
                                          reinterpret_cast<unsigned char *>(c[3]));
        },
        is_bad_overlap);
}

int pw85_gpu_contact_derivatives_host(size_t n, double const *r12, double const *q1,
                                      double const *q2, double *mu2, double *lambda, double *point,
                                      double *normal, double *d_r12, double *d_rot1, double *d_rot2)
{
    if (n == 0) return PW85_SUCCESS;
    if (n > max_rows || any_null(r12, q1, q2)) return PW85_EINVAL;
    double *const vectors[] = {point, normal, d_r12, d_rot1, d_rot2};
    Column outputs[7] = {column(mu2, 1)};
    std::size_t size = 1;
    if (lambda != nullptr) outputs[size++] = column(lambda, 1);
    for (double *const v : vectors)
        if (v != nullptr) outputs[size++] = column(v, 3);
    return run(
        n, {r12, q1, q2}, {outputs, size},
        [=](Handle stream, std::size_t count, double *const *c) {
            std::size_t k = 4;
            auto const next = [&](double *wanted) { return wanted == nullptr ? nullptr : c[k++]; };
            double *const l = next(lambda), *const x = next(point), *const m = next(normal),
                          *const f = next(d_r12), *const t1 = next(d_rot1),
                          *const t2 = next(d_rot2);
            return pw85_gpu_contact_derivatives_batch(stream, count, c[0], c[1], c[2], c[3], l, x,
                                                      m, f, t1, t2);
        },
        is_bad_number);
}
