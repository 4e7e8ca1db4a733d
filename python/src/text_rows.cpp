// SPDX-License-Identifier: BSD-3-Clause
// Rows of tables in text files, read and written. Python reads the rows that are not plain, word by
// word, and says what is wrong with them.
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <new>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "calls.hpp"

namespace pypw85 {
namespace {

/// The ASCII characters at which Python's str.split() splits.
constexpr bool is_blank(char c) noexcept
{
    return c <= ' ' && (c >= '\x1c' || (c >= '\t' && c <= '\r'));
}

bool is_ascii(std::string_view word) noexcept
{
    return std::all_of(word.begin(), word.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// The words of a line: between blanks, or between separators and without the blanks and quotation
/// marks around them.
class Words {
  public:
    Words(std::string_view line, char separator) noexcept : rest_{line}, separator_{separator} {}

    /// Finds the next word; false behind the last.
    bool next(std::string_view &word) noexcept
    {
        if (is_finished_) return false;
        if (separator_ != '\0') return next_between_separators(word);
        while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
        std::size_t size = 0;
        while (size < rest_.size() && !is_blank(rest_[size])) ++size;
        word = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return size > 0;
    }

    /// Whether quotation marks are such that Python has to read the line: doubled, within a word,
    /// or without a partner.
    bool is_hard() const noexcept { return is_hard_; }

  private:
    bool next_between_separators(std::string_view &word) noexcept
    {
        if (!rest_.empty() && rest_.front() == '"') return next_quoted(word);
        std::size_t const size = std::min(rest_.find(separator_), rest_.size());
        word = rest_.substr(0, size);
        is_hard_ = is_hard_ || word.find('"') != word.npos;
        is_finished_ = size == rest_.size();
        rest_.remove_prefix(is_finished_ ? size : size + 1);
        while (!word.empty() && is_blank(word.front())) word.remove_prefix(1);
        while (!word.empty() && is_blank(word.back())) word.remove_suffix(1);
        return true;
    }

    bool next_quoted(std::string_view &word) noexcept
    {
        std::size_t const end = std::min(rest_.find('"', 1), rest_.size() - 1);
        word = rest_.substr(1, std::max<std::size_t>(end, 1) - 1);
        std::string_view const mark = rest_.substr(end);
        rest_.remove_prefix(end + 1);
        is_finished_ = rest_.empty() || rest_ == "\r";
        is_hard_ = is_hard_ || end == 0 || mark.front() != '"' ||
                   !(is_finished_ || rest_.front() == separator_);
        if (!is_finished_) rest_.remove_prefix(1);
        return true;
    }

    std::string_view rest_;
    char separator_;
    bool is_finished_ = false, is_hard_ = false;
};

/// Reads a number as Python's float() does, correctly rounded. Returns false for what float()
/// refuses, and for numbers out of range.
bool read_number(std::string_view word, double &number) noexcept
{
#ifdef __cpp_lib_to_chars
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    if (word.empty() || word.back() == ')') return false; // from_chars() takes nan(text)
    char const *const end = word.data() + word.size();
    std::from_chars_result const result = std::from_chars(word.data(), end, number);
    return result.ec == std::errc{} && result.ptr == end;
#else // Python reads all numbers.
    return static_cast<void>(word), static_cast<void>(number), false;
#endif
}

/// The different names in a column, numbered as they occur.
class Names {
  public:
    std::int32_t number_of(std::string_view name)
    {
        if (last_number_ >= 0 && name == last_name_) return last_number_;
        auto const [place, is_new] =
            numbers_.try_emplace(name, static_cast<std::int32_t>(names_.size()));
        if (is_new) names_.push_back(name);
        last_name_ = name;
        return last_number_ = place->second;
    }

    Reference list() const
    {
        Reference result(PyList_New(static_cast<Py_ssize_t>(names_.size())));
        for (std::size_t k = 0; result && k < names_.size(); ++k) {
            PyObject *const name = PyBytes_FromStringAndSize(
                names_[k].data(), static_cast<Py_ssize_t>(names_[k].size()));
            if (name == nullptr) return nullptr;
            PyList_SET_ITEM(result.get(), static_cast<Py_ssize_t>(k), name);
        }
        return result;
    }

  private:
    std::unordered_map<std::string_view, std::int32_t> numbers_;
    std::vector<std::string_view> names_;
    std::string_view last_name_{};
    std::int32_t last_number_ = -1;
};

enum class Kind : char { number = 'n', name = 't', skipped = '-' };

/// Where the next numbers and names go.
struct Output {
    double *numbers;
    std::int32_t *codes;
    std::vector<Names> names;
};

/// Reads a line; false unless it is plain.
bool read_line(std::string_view line, char separator, std::string_view kinds, Output &out)
{
    // Python's csv.reader() takes a carriage return for the end of a line.
    if (separator != '\0' && std::min(line.find('\r'), line.size()) + 1 < line.size()) return false;
    Words words(line, separator);
    std::string_view word;
    auto names = out.names.begin();
    for (char const kind : kinds) {
        if (!words.next(word)) return false;
        if (kind == static_cast<char>(Kind::number)) {
            if (!read_number(word, *out.numbers++)) return false;
        } else if (kind == static_cast<char>(Kind::name)) {
            *out.codes++ = names++->number_of(word);
        } else if (!is_ascii(word)) { // Unicode has blanks of its own.
            return false;
        }
    }
    return !words.next(word) && !words.is_hard();
}

bool read_block(std::string_view block, char separator, std::string_view kinds, Output &out)
{
    while (!block.empty()) {
        std::size_t const size = std::min(block.find('\n'), block.size());
        if (!read_line(block.substr(0, size), separator, kinds, out)) return false;
        block.remove_prefix(std::min(size + 1, block.size()));
    }
    return true;
}

npy_intp lines_of(std::string_view block) noexcept
{
    bool const is_last_open = !block.empty() && block.back() != '\n';
    return std::count(block.begin(), block.end(), '\n') + is_last_open;
}

Reference new_matrix(npy_intp rows, npy_intp columns, int type)
{
    npy_intp const shape[] = {rows, columns};
    return Reference(PyArray_SimpleNew(2, shape, type));
}

template <class T> T *data_of(Reference const &array) noexcept
{
    return static_cast<T *>(PyArray_DATA(reinterpret_cast<PyArrayObject *>(array.get())));
}

PyObject *parse(std::string_view block, char separator, std::string_view kinds)
{
    auto const count = [&](Kind kind) {
        return std::count(kinds.begin(), kinds.end(), static_cast<char>(kind));
    };
    npy_intp const rows = lines_of(block), names = count(Kind::name);
    Reference numbers = new_matrix(rows, count(Kind::number), NPY_DOUBLE),
              codes = new_matrix(rows, names, NPY_INT32);
    if (!numbers || !codes) return nullptr;
    Output out{data_of<double>(numbers), data_of<std::int32_t>(codes),
               std::vector<Names>(static_cast<std::size_t>(names))};
    if (!read_block(block, separator, kinds, out)) Py_RETURN_NONE;
    Reference lists(PyTuple_New(names));
    for (npy_intp k = 0; lists && k < names; ++k) {
        Reference list = out.names[static_cast<std::size_t>(k)].list();
        if (!list) return nullptr;
        PyTuple_SET_ITEM(lists.get(), k, list.release());
    }
    return lists ? PyTuple_Pack(3, numbers.get(), codes.get(), lists.get()) : nullptr;
}

/// A column of the rows that are written: whole numbers, numbers, or names, which codes count. The
/// arrays of numbers may have several columns.
class Column {
  public:
    /// Takes an array of int64 or float64 of two dimensions, or a tuple of an array of int32 and a
    /// list of bytes. All are contiguous.
    explicit Column(PyObject *given)
    {
        bool const is_coded = PyTuple_Check(given);
        auto *const array =
            reinterpret_cast<PyArrayObject *>(is_coded ? PyTuple_GET_ITEM(given, 0) : given);
        type_ = PyArray_TYPE(array);
        data_ = static_cast<char const *>(PyArray_DATA(array));
        rows_ = PyArray_DIM(array, 0);
        width_ = is_coded ? 1 : PyArray_DIM(array, 1);
        PyObject *const names = is_coded ? PyTuple_GET_ITEM(given, 1) : nullptr;
        for (Py_ssize_t k = 0; is_coded && k < PyList_GET_SIZE(names); ++k) {
            PyObject *const name = PyList_GET_ITEM(names, k);
            names_.emplace_back(PyBytes_AS_STRING(name),
                                static_cast<std::size_t>(PyBytes_GET_SIZE(name)));
        }
    }

    npy_intp rows() const noexcept { return rows_; }

    /// Appends the numbers of a row, or its name, each with the separator behind it. Numbers have
    /// the fewest digits that are read as the same number.
    void append(npy_intp row, char separator, std::string &text) const
    {
        for (npy_intp k = row * width_; k < (row + 1) * width_; ++k) {
            if (type_ == NPY_DOUBLE)
                append_number(reinterpret_cast<double const *>(data_)[k], text);
            else if (type_ == NPY_INT64)
                append_number(reinterpret_cast<std::int64_t const *>(data_)[k], text);
            else
                text += names_[static_cast<std::size_t>(
                    reinterpret_cast<std::int32_t const *>(data_)[k])];
            text += separator;
        }
    }

  private:
    template <class Number> static void append_number(Number x, std::string &text)
    {
        char digits[32];
        text.append(digits, std::to_chars(digits, digits + sizeof digits, x).ptr);
    }

    int type_;
    char const *data_;
    npy_intp rows_, width_;
    std::vector<std::string_view> names_;
};

std::string format(char separator, std::vector<Column> const &columns)
{
    std::string text;
    for (npy_intp row = 0; row < columns.front().rows(); ++row) {
        for (Column const &column : columns) column.append(row, separator, text);
        text.back() = '\n';
    }
    return text;
}

} // namespace

PyObject *format_rows(PyObject *, PyObject *args)
{
    try {
        std::vector<Column> columns;
        for (Py_ssize_t k = 1; k < PyTuple_GET_SIZE(args); ++k)
            columns.emplace_back(PyTuple_GET_ITEM(args, k));
        long const separator = PyLong_AsLong(PyTuple_GET_ITEM(args, 0));
        std::string const text = format(static_cast<char>(separator), columns);
        return PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), nullptr);
    } catch (std::bad_alloc const &) {
        return PyErr_NoMemory();
    }
}

PyObject *parse_rows(PyObject *, PyObject *args)
{
    char const *block, *kinds;
    Py_ssize_t size, columns;
    int separator;
    if (!PyArg_ParseTuple(args, "y#iy#", &block, &size, &separator, &kinds, &columns))
        return nullptr;
    try {
        return parse({block, static_cast<std::size_t>(size)}, static_cast<char>(separator),
                     {kinds, static_cast<std::size_t>(columns)});
    } catch (std::bad_alloc const &) {
        return PyErr_NoMemory();
    }
}

} // namespace pypw85
