// The loops of the generalised ufuncs. NumPy runs them without the GIL: nothing of Python is touched here.
#include <algorithm>
#include <cfenv>

#include <pw85.h>

#include "function.hpp"

namespace pypw85 {
namespace {

/// NumPy looks at the floating-point exceptions after a loop. What the library raises on its way to a good result says
/// nothing to the caller, so the flags are put back, and "invalid" is raised exactly if a row is bad.
class FloatingPointFlags {
  public:
    FloatingPointFlags() noexcept { std::fegetexceptflag(&flags_, FE_ALL_EXCEPT); }

    FloatingPointFlags(FloatingPointFlags const &) = delete;
    FloatingPointFlags &operator=(FloatingPointFlags const &) = delete;

    ~FloatingPointFlags()
    {
        std::fesetexceptflag(&flags_, FE_ALL_EXCEPT);
        if (bad_) std::feraiseexcept(FE_INVALID);
    }

    void note(bool bad) noexcept { bad_ = bad_ || bad; }

  private:
    std::fexcept_t flags_;
    bool bad_ = false;
};

/// Rows of one operand, anywhere in memory.
struct Rows {
    char *first;
    std::ptrdiff_t step; ///< bytes from row to row; 0 if one row is broadcast
    Core core;
    std::ptrdiff_t core_steps[2]; ///< bytes along the core dimensions
    bool row_contiguous;

    /// Numbers of row i, in `buffer` if they are scattered.
    double *load(std::ptrdiff_t i, double *buffer) const noexcept
    {
        if (row_contiguous) return reinterpret_cast<double *>(first + i * step);
        copy(i, buffer, [](double &number, double &buffered) { buffered = number; });
        return buffer;
    }

    void store(std::ptrdiff_t i, double *buffer) const noexcept
    {
        copy(i, buffer, [](double &number, double &buffered) { number = buffered; });
    }

    /// Whether all rows together are one contiguous block of `size` numbers each.
    bool contiguous() const noexcept
    {
        return row_contiguous && step == static_cast<std::ptrdiff_t>(sizeof(double)) * core.size();
    }

  private:
    template <class Assign> void copy(std::ptrdiff_t i, double *buffer, Assign assign) const noexcept
    {
        for (std::ptrdiff_t j = 0; j < core.dims[0]; ++j)
            for (std::ptrdiff_t k = 0; k < core.dims[1]; ++k) {
                char *const number = first + i * step + j * core_steps[0] + k * core_steps[1];
                assign(*reinterpret_cast<double *>(number), *buffer++);
            }
    }
};

/// The operands of a loop; NumPy passes the steps of the core dimensions of all operands after the outer steps.
void find_rows(Function const &function, char **args, std::ptrdiff_t const *steps, Rows *rows) noexcept
{
    std::ptrdiff_t const *core_step = steps + function.operands();
    for (int k = 0; k < function.operands(); ++k) {
        Core const &core = function.cores[k];
        rows[k] = {args[k], steps[k], core, {0, 0}, true};
        std::ptrdiff_t dense = static_cast<std::ptrdiff_t>(sizeof(double)) * core.size();
        for (int d = 0; d < core.ndim; ++d) {
            rows[k].core_steps[d] = *core_step++;
            dense /= core.dims[d];
            rows[k].row_contiguous = rows[k].row_contiguous && rows[k].core_steps[d] == dense;
        }
    }
}

/// Rows per call of a batch function when they have to be gathered first: 70 kB on the stack.
constexpr std::ptrdiff_t block_rows = 512;

/// Gathers blocks of pairs (r12, q1, q2).
class PairBlocks {
  public:
    explicit PairBlocks(Rows const *rows) noexcept : rows_{rows} {}

    double const *r12(std::ptrdiff_t first, std::ptrdiff_t count) noexcept
    {
        return gather(rows_[0], first, count, r12_);
    }
    double const *q1(std::ptrdiff_t first, std::ptrdiff_t count) noexcept
    {
        return gather(rows_[1], first, count, q1_);
    }
    double const *q2(std::ptrdiff_t first, std::ptrdiff_t count) noexcept
    {
        return gather(rows_[2], first, count, q2_);
    }

  private:
    static double const *gather(Rows const &rows, std::ptrdiff_t first, std::ptrdiff_t count, double *buffer) noexcept
    {
        double scattered[max_core_size];
        if (rows.contiguous()) return rows.load(first, scattered);
        int const size = rows.core.size();
        for (std::ptrdiff_t i = 0; i < count; ++i)
            std::copy_n(rows.load(first + i, scattered), size, buffer + i * size);
        return buffer;
    }

    Rows const *rows_;
    double r12_[block_rows * PW85_DIM];
    double q1_[block_rows * PW85_SYM];
    double q2_[block_rows * PW85_SYM];
};

/// Whether the library can take all operands as they are.
bool all_contiguous(Rows const *rows, int operands) noexcept
{
    return std::all_of(rows, rows + operands, [](Rows const &operand) { return operand.contiguous(); });
}

template <class T> T &element(Rows const &rows, std::ptrdiff_t i) noexcept
{
    return *reinterpret_cast<T *>(rows.first + i * rows.step);
}

double *numbers(char *operand) noexcept { return reinterpret_cast<double *>(operand); }

/// Calls batch(pairs, first, count) for blocks of gathered rows, in threads like the library. Whether all are good.
template <class Batch> bool for_blocks(std::ptrdiff_t count, Rows const *rows, Batch const &batch) noexcept
{
    int bad = 0;
#pragma omp parallel for schedule(static) reduction(| : bad) if (count > 8 * block_rows)
    for (std::ptrdiff_t first = 0; first < count; first += block_rows) {
        PairBlocks pairs(rows);
        bad |= batch(pairs, first, std::min(block_rows, count - first)) != PW85_SUCCESS;
    }
    return bad == 0;
}

/// Batch functions with outputs of floating-point numbers, by their arrays: r12 or directions, q1, q2, outputs.
int contact_batch(std::size_t n, double const *const *in, double *const *out) noexcept
{
    return pw85_contact_batch(n, in[0], in[1], in[2], out[0], out[1]);
}

int contact_batch_2d(std::size_t n, double const *const *in, double *const *out) noexcept
{
    return pw85_contact_batch_2d(n, in[0], in[1], in[2], out[0], out[1]);
}

int closest_approach_batch(std::size_t n, double const *const *in, double *const *out) noexcept
{
    return pw85_closest_approach_batch(n, in[0], in[1], in[2], out[0]);
}

int contact_derivatives_batch(std::size_t n, double const *const *in, double *const *out) noexcept
{
    return pw85_contact_derivatives_batch(n, in[0], in[1], in[2], out[0], out[1], out[2], out[3], out[4], out[5],
                                          out[6]);
}

/// Most numbers that a batch function gives per row.
constexpr int max_outputs = 2 + 5 * PW85_DIM;

/// Calls a batch function for gathered rows, and scatters its outputs. Whether all are good.
template <auto batch> bool pair_blocks(std::ptrdiff_t count, Rows const *rows, int operands) noexcept
{
    return for_blocks(count, rows, [rows, operands](PairBlocks &pairs, std::ptrdiff_t first, std::ptrdiff_t n) {
        double buffer[max_outputs * block_rows], *out[max_operands], *next = buffer;
        for (int k = 3; k < operands; ++k) {
            out[k - 3] = next;
            next += rows[k].core.size() * block_rows;
        }
        double const *const in[] = {pairs.r12(first, n), pairs.q1(first, n), pairs.q2(first, n)};
        int const status = batch(static_cast<std::size_t>(n), in, out);
        for (int k = 3; k < operands; ++k)
            for (std::ptrdiff_t i = 0; i < n; ++i) rows[k].store(first + i, out[k - 3] + i * rows[k].core.size());
        return status;
    });
}

/// The loop of a batch function.
template <auto batch>
void pair_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps, void *data) noexcept
{
    Function const &function = *static_cast<Function const *>(data);
    int const operands = function.operands();
    Rows rows[max_operands];
    find_rows(function, args, steps, rows);
    FloatingPointFlags flags;
    if (!all_contiguous(rows, operands)) return flags.note(!pair_blocks<batch>(dimensions[0], rows, operands));
    double *arrays[max_operands];
    std::transform(args, args + operands, arrays, numbers);
    flags.note(batch(static_cast<std::size_t>(dimensions[0]), arrays, arrays + 3) != PW85_SUCCESS);
}

/// The overlap of ellipses or ellipsoids, by the size of r12.
decltype(&pw85_overlap_batch) overlap_batch(Rows const *rows) noexcept
{
    return rows[0].core.size() == 2 ? pw85_overlap_batch_2d : pw85_overlap_batch;
}

template <bool boolean> bool overlap_blocks(std::ptrdiff_t count, Rows const *rows) noexcept
{
    return for_blocks(count, rows, [rows](PairBlocks &pairs, std::ptrdiff_t first, std::ptrdiff_t n) {
        unsigned char overlap[block_rows];
        int const status = overlap_batch(rows)(static_cast<size_t>(n), pairs.r12(first, n), pairs.q1(first, n),
                                               pairs.q2(first, n), overlap);
        for (std::ptrdiff_t i = 0; i < n; ++i)
            element<unsigned char>(rows[3], first + i) = boolean ? overlap[i] != 0 : overlap[i];
        return status;
    });
}

template <bool boolean>
void overlap_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps, void *data) noexcept
{
    Rows rows[max_operands];
    find_rows(*static_cast<Function const *>(data), args, steps, rows);
    FloatingPointFlags flags;
    std::ptrdiff_t const n = dimensions[0];
    if (!all_contiguous(rows, 3) || rows[3].step != 1) return flags.note(!overlap_blocks<boolean>(n, rows));
    auto *const overlap = reinterpret_cast<unsigned char *>(args[3]);
    int const status =
        overlap_batch(rows)(static_cast<size_t>(n), numbers(args[0]), numbers(args[1]), numbers(args[2]), overlap);
    flags.note(status != PW85_SUCCESS);
    if (boolean && status != PW85_SUCCESS)
        std::transform(overlap, overlap + n, overlap, [](unsigned char code) { return code != 0; });
}

} // namespace

void row_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps, void *data)
{
    Function const &function = *static_cast<Function const *>(data);
    int const nin = function.nin, operands = function.operands();
    Rows rows[max_operands];
    find_rows(function, args, steps, rows);
    FloatingPointFlags flags;
    double buffers[max_operands][max_core_size];
    double const *in[max_operands];
    double *out[max_operands];
    for (std::ptrdiff_t i = 0; i < dimensions[0]; ++i) {
        for (int k = 0; k < nin; ++k) in[k] = rows[k].load(i, buffers[k]);
        for (int k = nin; k < operands; ++k)
            out[k - nin] = rows[k].row_contiguous ? rows[k].load(i, nullptr) : buffers[k];
        flags.note(function.evaluate(in, out) != PW85_SUCCESS);
        for (int k = nin; k < operands; ++k)
            if (!rows[k].row_contiguous) rows[k].store(i, buffers[k]);
    }
}

void contact_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps, void *data)
{
    pair_loop<contact_batch>(args, dimensions, steps, data);
}

void contact_2d_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps, void *data)
{
    pair_loop<contact_batch_2d>(args, dimensions, steps, data);
}

void closest_approach_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps, void *data)
{
    pair_loop<closest_approach_batch>(args, dimensions, steps, data);
}

void contact_derivatives_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps, void *data)
{
    pair_loop<contact_derivatives_batch>(args, dimensions, steps, data);
}

void overlap_code_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps, void *data)
{
    overlap_loop<false>(args, dimensions, steps, data);
}

void overlap_boolean_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps, void *data)
{
    overlap_loop<true>(args, dimensions, steps, data);
}

void report_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps, void *)
{
    FloatingPointFlags flags;
    for (std::ptrdiff_t i = 0; i < dimensions[0]; ++i) {
        long const status = *reinterpret_cast<long const *>(args[0] + i * steps[0]);
        *reinterpret_cast<double *>(args[1] + i * steps[1]) = static_cast<double>(status);
        flags.note(status != 0);
    }
}

} // namespace pypw85
