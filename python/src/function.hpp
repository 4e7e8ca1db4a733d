// SPDX-License-Identifier: BSD-3-Clause
// The description from which a function of the C API becomes a generalised ufunc and a fast call
// for single arguments.
#ifndef PYPW85_FUNCTION_HPP_INCLUDED
#define PYPW85_FUNCTION_HPP_INCLUDED

#include <cstddef>
#include <vector>

namespace pypw85 {

/// Most numbers in one row of one operand: a 9×9 matrix.
inline constexpr int max_core_size = 81;

/// Most operands of a function, inputs and outputs together.
inline constexpr int max_operands = 10;

/// Shape of one row of an operand: the core dimensions.
struct Core {
    int ndim = 0;
    std::ptrdiff_t dims[2] = {1, 1};

    int size() const noexcept { return static_cast<int>(dims[0] * dims[1]); }
};

/// A pointer for each operand; what it points to is contiguous.
using Inputs = double const *const *;
using Outputs = double *const *;

/// One function for one row: reads `in`, writes `out`, returns a status.
using Evaluate = int (*)(Inputs in, Outputs out);

/// One function for n rows: reads `in`, writes `out`, returns the status of the first bad row.
using Batch = int (*)(std::size_t n, Inputs in, Outputs out);

/// The only output of a function of n rows if it is a truth value: 0, 1, or 255 for a bad row.
using Codes = int (*)(std::size_t n, Inputs in, unsigned char *codes);

struct Function {
    char const *name;
    char const *signature; ///< core signature, as NumPy writes it, fixed sizes only
    Evaluate evaluate;
    Batch batch; ///< null: `evaluate` for each row, or `codes`
    Codes codes; ///< not null: the only output is a truth value
    bool if_bad; ///< what the truth value of a bad row is
    int nin = 0; ///< this and what follows is read from the signature by parse_signature()
    int nout = 0;
    Core cores[max_operands] = {};

    int operands() const noexcept { return nin + nout; }
    bool is_truth() const noexcept { return codes != nullptr; }
};

/// Fills in what the signature says.
void parse_signature(Function &function) noexcept;

/// All functions. Their addresses are kept by the ufuncs, so they live as long as the process.
std::vector<Function> &functions();

/// Calls `evaluate` for each row; `data` is the Function.
void row_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps,
              void *data);

/// Calls `batch` for blocks of rows, in threads; `data` is the Function.
void batch_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps,
                void *data);

/// Calls `codes` for blocks of rows. Output: 0, 1, or 255 for a bad row.
void code_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps,
               void *data);

/// The loop of a function with a boolean output, which is `if_bad` for a bad row.
void boolean_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps,
                  void *data);

/// Raises the floating-point exception "invalid" if a status (C long) is not zero; output: the
/// status, as a double.
void report_loop(char **args, std::ptrdiff_t const *dimensions, std::ptrdiff_t const *steps,
                 void *data);

} // namespace pypw85

#endif
