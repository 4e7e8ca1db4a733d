// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Saved simulations taken apart and put together again by what the manual says of their format.
#ifndef PW85_TESTS_SAVED_SECTIONS_HPP_INCLUDED
#define PW85_TESTS_SAVED_SECTIONS_HPP_INCLUDED

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace pw85_tests {

using Bytes = std::vector<unsigned char>;
using Words = std::vector<std::uint64_t>;

inline std::uint64_t word_of(double number) { return std::bit_cast<std::uint64_t>(number); }

inline std::uint64_t word_at(std::span<unsigned char const> bytes, std::size_t offset)
{
    std::uint64_t word = 0;
    for (std::size_t k = 8; k-- > 0;) word = 256 * word + bytes[offset + k];
    return word;
}

inline void append_word(Bytes &bytes, std::uint64_t word)
{
    for (int k = 0; k < 8; ++k) bytes.push_back(static_cast<unsigned char>(word >> 8 * k));
}

/// The CRC-32 of PNG and zlib, a bit at a time.
inline std::uint32_t crc32(std::span<unsigned char const> bytes)
{
    std::uint32_t sum = 0xffffffff;
    for (unsigned char const byte : bytes) {
        sum ^= byte;
        for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320 : 0);
    }
    return ~sum;
}

/// Puts the right size and checksum into bytes.
inline Bytes sealed(Bytes bytes)
{
    Bytes size;
    append_word(size, bytes.size());
    std::copy(size.begin(), size.end(), bytes.begin() + 16);
    bytes.erase(bytes.end() - 8, bytes.end());
    append_word(bytes, crc32(bytes));
    return bytes;
}

/// The sections of a state, in their order.
struct SavedSections {
    std::uint64_t signature, format;
    std::vector<std::pair<std::string, Words>> sections;

    explicit SavedSections(Bytes const &bytes)
        : signature(word_at(bytes, 0)), format(word_at(bytes, 8))
    {
        for (std::size_t at = 24; at < bytes.size() - 8;) {
            Words words(static_cast<std::size_t>(word_at(bytes, at + 8) / 8));
            for (std::size_t k = 0; k < words.size(); ++k)
                words[k] = word_at(bytes, at + 16 + 8 * k);
            sections.emplace_back(std::string(&bytes[at], &bytes[at] + 8), words);
            at += 16 + 8 * words.size();
        }
    }

    /// The numbers of the section whose name begins so. There must be one.
    Words &operator[](std::string const &name)
    {
        std::size_t k = 0;
        while (!sections.at(k).first.starts_with(name)) ++k;
        return sections[k].second;
    }

    Bytes bytes() const
    {
        Bytes made;
        for (std::uint64_t const word : {signature, format, std::uint64_t{0}})
            append_word(made, word);
        for (auto const &[name, words] : sections) {
            made.insert(made.end(), name.begin(), name.end());
            append_word(made, 8 * words.size());
            for (std::uint64_t const word : words) append_word(made, word);
        }
        append_word(made, 0);
        return sealed(made);
    }
};

/// A state in which a number of a section is another one.
inline Bytes with_word(Bytes const &bytes, std::string const &name, std::size_t k,
                       std::uint64_t word)
{
    SavedSections state(bytes);
    state[name].at(k) = word;
    return state.bytes();
}

/// A state in which a number is another one wherever it first occurs. It must occur.
inline Bytes with_number(Bytes const &bytes, double old, double number)
{
    SavedSections state(bytes);
    for (auto &[name, words] : state.sections)
        for (std::uint64_t &word : words)
            if (word == word_of(old)) {
                word = word_of(number);
                return state.bytes();
            }
    return {};
}

} // namespace pw85_tests

#endif
