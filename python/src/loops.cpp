// SPDX-License-Identifier: BSD-3-Clause
// The loops of the generalised ufuncs. NumPy runs them without the GIL: nothing of Python is
// touched here.
#include <algorithm>
#include <cfenv>

#include <pw85.h>

#include "function.hpp"

namespace pypw85 {
namespace {

/// NumPy looks at the floating-point exceptions after a loop. What the library raises on its way to
/// a good result says nothing to the caller, so the flags are put back, and "invalid" is raised
/// exactly if a row is bad.
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
    template <class Assign>
    void copy(std::ptrdiff_t i, double *buffer, Assign assign) const noexcept
    {
        for (std::ptrdiff_t j = 0; j < core.dims[0]; ++j)
            for (std::ptrdiff_t k = 0; k < core.dims[1]; ++k) {
                char *const number = first + i * step + j * core_steps[0] + k * core_steps[1];
                assign(*reinterpret_cast<double *>(number), *buffer++);
            }
    }
};

/// The operands of a loop; NumPy passes the steps of the core dimensions of all operands after the
/// outer steps.
void find_rows(Function const &function, char **args, std::ptrdiff_t const *steps,
               Rows *rows) noexcept
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

template <class T> T &element(Rows const &rows, std::ptrdiff_t i) noexcept
{
    return *reinterpret_cast<T *>(rows.first + i * rows.step);
}

/// Most rows per call of a batch function, where none has to be gathered; up to that many stay in
/// one thread, as in the library.
constexpr std::ptrdiff_t max_block_rows = 4096;

/// Numbers that are gathered and scattered for a call of a batch function: 96 KiB on the stack.
constexpr std::ptrdiff_t buffer_size = 12288;

/// Rows per call of a batch function: as many as the buffer has room for, of operands that are no
/// contiguous blocks.
std::ptrdiff_t rows_per_block(Rows const *rows, int operands) noexcept
{
    std::ptrdiff_t width = 0;
    for (int k = 0; k < operands; ++k) width += rows[k].contiguous() ? 0 : rows[k].core.size();
    return width == 0 ? max_block_rows : std::min(max_block_rows, buffer_size / width);
}

/// The rows of a block as the contiguous arrays that batch functions take: where they are, or
/// copies.
class Block {
  public:
    Block(Rows const *rows, std::ptrdiff_t first, std::ptrdiff_t count) noexcept
        : rows_{rows}, first_{first}, count_{count}
    {
    }

    double const *gathered(int operand) noexcept
    {
        Rows const &rows = rows_[operand];
        double scattered[max_core_size], *const array = place(rows);
        if (rows.contiguous()) return array;
        int const size = rows.core.size();
        for (std::ptrdiff_t i = 0; i < count_; ++i)
            std::copy_n(rows.load(first_ + i, scattered), size, array + i * size);
        return array;
    }

    /// Where an output of a batch function goes.
    double *room(int operand) noexcept { return place(rows_[operand]); }

    /// Copies an output to its rows, if it is elsewhere.
    void scatter(int operand, double *array) const noexcept
    {
        Rows const &rows = rows_[operand];
        if (rows.contiguous()) return;
        for (std::ptrdiff_t i = 0; i < count_; ++i)
            rows.store(first_ + i, array + i * rows.core.size());
    }

  private:
    double *place(Rows const &rows) noexcept
    {
        if (rows.contiguous()) return &element<double>(rows, first_);
        double *const array = next_;
        next_ += count_ * rows.core.size();
        return array;
    }

    Rows const *rows_;
    std::ptrdiff_t first_, count_;
    double buffer_[buffer_size], *next_ = buffer_;
};

/// Calls batch(block, first, count), which returns a status, for blocks of rows, in threads like
/// the library. Whether all are good.
template <class Batch>
bool for_blocks(std::ptrdiff_t count, Rows const *rows, int operands, Batch const &batch) noexcept
{
    int bad = 0;
    std::ptrdiff_t const block_rows = rows_per_block(rows, operands);
#pragma omp parallel for schedule(static) reduction(| : bad) if (count > max_block_rows)
    for (std::ptrdiff_t first = 0; first < count; first += block_rows) {
        std::ptrdiff_t const n = std::min(block_rows, count - first);
        Block block(rows, first, n);
        bad |= batch(block, first, static_cast<std::size_t>(n)) != PW85_SUCCESS;
    }
    return bad == 0;
}

/// Makes truth values of codes, which are 0, 1 and 255, by loops that compilers vectorise.
void make_boolean(unsigned char *codes, std::size_t n, bool if_bad) noexcept
{
    if (if_bad)
        std::transform(codes, codes + n, codes,
                       [](unsigned char code) -> unsigned char { return code != 0; });
    else
        std::transform(codes, codes + n, codes,
                       [](unsigned char code) -> unsigned char { return code == 1; });
}

template <bool boolean> void truth_loop(char **args, std::ptrdiff_t const *dimensions,
                                        std::ptrdiff_t const *steps, void *data) noexcept
{
    Rows rows[max_operands];
    Function const &function = *static_cast<Function const *>(data);
    find_rows(function, args, steps, rows);
    FloatingPointFlags flags;
    int const nin = function.nin;
    Rows const &answers = rows[nin];
    bool const is_contiguous = answers.step == 1, if_bad = function.if_bad;
    bool const good = for_blocks(
        dimensions[0], rows, nin, [&](Block &block, std::ptrdiff_t first, std::size_t n) {
            unsigned char buffer[max_block_rows];
            unsigned char *const codes =
                is_contiguous ? &element<unsigned char>(answers, first) : buffer;
            double const *in[max_operands];
            for (int k = 0; k < nin; ++k) in[k] = block.gathered(k);
            int const status = function.codes(n, in, codes);
            if (boolean) make_boolean(codes, n, if_bad);
            for (std::size_t i = 0; !is_contiguous && i < n; ++i)
                element<unsigned char>(answers, first + static_cast<std::ptrdiff_t>(i)) = codes[i];
            return status;
        });
    flags.note(!good);
}

} // namespace

void row_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps,
              void *data)
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

void batch_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps,
                void *data)
{
    Function const &function = *static_cast<Function const *>(data);
    int const nin = function.nin, nout = function.nout;
    Rows rows[max_operands];
    find_rows(function, args, steps, rows);
    FloatingPointFlags flags;
    bool const good = for_blocks(dimensions[0], rows, nin + nout,
                                 [&](Block &block, std::ptrdiff_t, std::size_t n) {
                                     double const *in[max_operands];
                                     double *out[max_operands];
                                     for (int k = 0; k < nin; ++k) in[k] = block.gathered(k);
                                     for (int k = 0; k < nout; ++k) out[k] = block.room(nin + k);
                                     int const status = function.batch(n, in, out);
                                     for (int k = 0; k < nout; ++k) block.scatter(nin + k, out[k]);
                                     return status;
                                 });
    flags.note(!good);
}

void code_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps,
               void *data)
{
    truth_loop<false>(args, dimensions, steps, data);
}

void boolean_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps,
                  void *data)
{
    truth_loop<true>(args, dimensions, steps, data);
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
