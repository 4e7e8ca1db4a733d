// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Saved states: named sections of numbers, as the same bytes on every machine.
///
/// 1. A state is a sequence of words of eight bytes, the least significant byte first: signature,
///    format, number of bytes of the state, sections, checksum.
/// 2. A section is a name of eight characters, the number of bytes of its numbers, and the numbers:
///    integers in two's complement, or IEEE 754 binary64.
/// 3. A reader skips a section with an unknown name if the name begins with a small letter, and
///    refuses it otherwise, as for the chunks of PNG (ISO/IEC 15948, 5.4).
/// 4. The checksum is the CRC-32 of all bytes before it (ISO/IEC 15948, annex D).
///
/// Points 1 to 4 are the same in all formats.
#ifndef PW85_SIMULATION_SECTIONS_HPP_INCLUDED
#define PW85_SIMULATION_SECTIONS_HPP_INCLUDED

#include <bit>
#include <concepts>
#include <cstring>
#include <utility>

#include <pw85.h>

#include "../base/array.hpp"

namespace pw85::detail::simulation {

/// The sections of format 1. Later versions add sections, and do not change these.
enum Section {
    settings,
    cell,
    particles,
    law,
    mesh,
    species,
    walls,
    fields,
    potential,
    num_sections
};

namespace {

inline constexpr std::size_t bytes_of_word = 8;

/// Returns a word whose bytes in memory are those of a state, or the word of such bytes. Compilers
/// load and store shifted bytes one by one.
[[gnu::always_inline]] inline std::uint64_t in_state_order(std::uint64_t word) noexcept
{
    return std::endian::native == std::endian::big ? __builtin_bswap64(word) : word;
}

[[gnu::always_inline]] inline std::uint64_t load_word(unsigned char const *bytes) noexcept
{
    std::uint64_t word;
    std::memcpy(&word, bytes, bytes_of_word);
    return in_state_order(word);
}

[[gnu::always_inline]] inline void store_word(std::uint64_t word, unsigned char *bytes) noexcept
{
    word = in_state_order(word);
    std::memcpy(bytes, &word, bytes_of_word);
}

/// Two types, one of which may be const.
template <class T, class U>
concept Is = std::same_as<T const, U const>;

/// Calls visit(number) for each number of an object: of arrays and vectors, or those that
/// each_number() names.
template <class Object, class Visit>
[[gnu::always_inline]] inline void visit_numbers(Object &object, Visit const &visit) noexcept
{
    if constexpr (std::is_arithmetic_v<Object>) {
        visit(object);
    } else if constexpr (std::is_array_v<Object>) {
        for (auto &element : object) visit_numbers(element, visit);
    } else if constexpr (requires { object.coordinates; }) {
        visit_numbers(object.coordinates, visit);
    } else {
        each_number(object, [&](auto &...members) { (visit_numbers(members, visit), ...); });
    }
}

} // namespace

/// Writes words one after the other, or only counts them.
class Writer {
  public:
    /// Counts if the pointer is null.
    [[gnu::always_inline]] explicit Writer(unsigned char *bytes) noexcept : bytes_(bytes) {}

    std::size_t num_bytes() const noexcept { return size_; }

    /// Writes the signature and the format. `size` is the number of bytes of the whole state.
    void begin(std::size_t size) noexcept;

    /// Writes a section of numbers, objects and arrays.
    template <class... Objects>
    [[gnu::always_inline]] void section(Section section, Objects const &...objects) noexcept
    {
        std::size_t const start = begin_section(section);
        (add(objects), ...);
        end_section(start);
    }

    /// Writes a section of n objects, which object(i) returns.
    template <class Object> [[gnu::always_inline]] void section_of(Section section, std::size_t n,
                                                                   Object const &object) noexcept
    {
        std::size_t const start = begin_section(section);
        for (std::size_t i = 0; i < n; ++i) add(object(i));
        end_section(start);
    }

    /// Writes the checksum.
    void end() noexcept;

  private:
    std::size_t begin_section(Section section) noexcept;
    void end_section(std::size_t start) noexcept;

    [[gnu::always_inline]] void add_word(std::uint64_t word) noexcept
    {
        if (bytes_ != nullptr) store_word(word, bytes_ + size_);
        size_ += bytes_of_word;
    }

    /// The place is a local variable: bytes may be anything, also the members of this object, so
    /// that these would be loaded again for each number.
    template <class Object> [[gnu::always_inline]] void add(Object const &object) noexcept
    {
        unsigned char *const first = bytes_ == nullptr ? nullptr : bytes_ + size_;
        std::size_t place = 0;
        visit_numbers(object, [&]<class Number>(Number const &number) {
            std::uint64_t word;
            if constexpr (std::same_as<Number, double>)
                word = std::bit_cast<std::uint64_t>(number);
            else
                word = static_cast<std::uint64_t>(number); // which extends the sign
            if (first != nullptr) store_word(word, first + place);
            place += bytes_of_word;
        });
        size_ += place;
    }

    template <class Elements>
    requires requires(Elements elements) { elements.data(); }
    [[gnu::always_inline]] void add(Elements const &elements) noexcept
    {
        for (std::size_t k = 0; k < elements.size(); ++k) add(elements[k]);
    }

    unsigned char *bytes_;
    std::size_t size_ = 0;
};

/// Reads the numbers of a section. After the first fault all numbers are 0.
class Reader {
  public:
    /// A section that does not exist.
    Reader() noexcept = default;
    [[gnu::always_inline]] Reader(unsigned char const *bytes, std::size_t size) noexcept
        : next_(bytes), num_words_(size / bytes_of_word)
    {
    }

    bool exists() const noexcept { return next_ != nullptr; }

    /// The number of objects that remain.
    template <class Object> [[gnu::always_inline]] std::size_t remaining() const noexcept
    {
        std::size_t words = 0;
        Object object{};
        visit_numbers(object, [&](auto const &) { ++words; });
        return num_words_ / words;
    }

    /// Reads numbers and objects.
    template <class... Objects> [[gnu::always_inline]] void read(Objects &...objects) noexcept
    {
        auto const read_number = [&]<class Number>(Number &number) {
            std::uint64_t const word = next_word();
            if constexpr (std::same_as<Number, double>) {
                number = std::bit_cast<double>(word);
            } else {
                using Word =
                    std::conditional_t<std::is_signed_v<Number>, std::int64_t, std::uint64_t>;
                auto const value = static_cast<Word>(word);
                if (!std::in_range<Number>(value)) refuse(PW85_EINVAL);
                number = std::in_range<Number>(value) ? static_cast<Number>(value) : Number{0};
            }
        };
        (visit_numbers(objects, read_number), ...);
    }

    /// Reads an array of n elements, which must remain.
    template <class Element>
    [[gnu::always_inline]] void read_array(std::size_t n, Array<Element> &array) noexcept
    {
        if (!array.resize(n)) return refuse(PW85_ENOMEM);
        for (std::size_t k = 0; k < n; ++k) read(array[k]);
    }

    /// Reads the rest as an array.
    template <class Element> [[gnu::always_inline]] void read_array(Array<Element> &array) noexcept
    {
        read_array(remaining<Element>(), array);
    }

    /// The status of what was read: PW85_EINVAL also if numbers remain.
    int finish() const noexcept;

  private:
    [[gnu::always_inline]] std::uint64_t next_word() noexcept
    {
        if (num_words_ == 0) refuse(PW85_EINVAL);
        if (status_ != PW85_SUCCESS) return 0;
        --num_words_;
        return load_word(std::exchange(next_, next_ + bytes_of_word));
    }

    [[gnu::always_inline]] void refuse(int status) noexcept
    {
        if (status_ == PW85_SUCCESS) status_ = status;
    }

    unsigned char const *next_ = nullptr;
    std::size_t num_words_ = 0;
    int status_ = PW85_SUCCESS;
};

/// Requirement on bytes with another signature or impossible numbers.
inline constexpr char const *not_a_state = "must be a state that pw85_hard_ellipsoids_save() wrote";

/// Finds the sections of a state. Returns the requirement that the bytes do not meet, or null.
char const *find_sections(std::size_t size, unsigned char const *bytes,
                          Reader (&sections)[num_sections]) noexcept;

} // namespace pw85::detail::simulation

#endif
