// SPDX-License-Identifier: GPL-2.0-only
/// @file
/// The words of a command of an input script.
#ifndef PW85_LAMMPS_WORDS_HPP_INCLUDED
#define PW85_LAMMPS_WORDS_HPP_INCLUDED

#include "host.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <pw85.h>

namespace pw85_lammps {

/// Returns a number in a message.
inline std::string decimal(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.15g", value);
    return text.data();
}

/// Returns the cause for which the library refused a pair. `first` and `second` are names for its
/// ellipsoids.
inline std::string words_of(pw85_error const &cause, std::string const &first,
                            std::string const &second)
{
    std::string const name = cause.argument == nullptr ? "" : cause.argument;
    if (name.empty()) return cause.function == nullptr ? "no cause is known" : cause.requirement;
    std::string const subject = name == "q1"   ? "the form of " + first
                                : name == "q2" ? "the form of " + second
                                               : name;
    return subject + " " + cause.requirement;
}

/// Reads words one after the other, and says what is wrong with them.
class Words : protected LAMMPS_NS::Pointers {
  public:
    /// @param subject what the words describe: the subject of error messages
    Words(LAMMPS_NS::LAMMPS *lammps, std::string subject, int count, char **words)
        : Pointers(lammps), subject_(std::move(subject)), count_(count), words_(words)
    {
    }

    bool done() const { return position_ == count_; }

    /// Returns the words that are left.
    int num_left() const { return count_ - position_; }
    char **left() const { return words_ + position_; }

    bool next_is(std::string const &text) const { return !done() && text == words_[position_]; }

    /// Returns whether the next word begins like this.
    bool starts_with(std::string const &text) const
    {
        return !done() && std::string(words_[position_]).rfind(text, 0) == 0;
    }

    /// Skips the next word if it is this one, and says whether it was.
    bool skip(std::string const &text)
    {
        bool const found = next_is(text);
        position_ += found ? 1 : 0;
        return found;
    }

    std::string word(std::string const &what)
    {
        if (done()) refuse("lacks " + what);
        return words_[position_++];
    }

    double number(std::string const &what, double smallest = 0.0, double largest = HUGE_VAL)
    {
        std::string const text = word(what);
        double const value = LAMMPS_NS::utils::numeric(FLERR, text.c_str(), false, lmp);
        if (!(value >= smallest && std::isfinite(value) && value <= largest))
            refuse("has a bad " + what + ": " + text + ", which must be " +
                   range(smallest, largest));
        return value;
    }

    /// Returns any finite number.
    double coordinate(std::string const &what) { return number(what, -HUGE_VAL); }

    double positive(std::string const &what)
    {
        double const value = number(what);
        if (value == 0.0) refuse("has a " + what + " of zero, which must be > 0");
        return value;
    }

    /// Returns an integer.
    LAMMPS_NS::bigint whole(std::string const &what, LAMMPS_NS::bigint smallest,
                            LAMMPS_NS::bigint largest)
    {
        std::string const text = word(what);
        double const value = LAMMPS_NS::utils::numeric(FLERR, text.c_str(), false, lmp);
        if (!(value >= static_cast<double>(smallest) && value <= static_cast<double>(largest) &&
              value == std::floor(value)))
            refuse("has a bad " + what + ": " + text + ", which must be a whole number from " +
                   std::to_string(smallest) + " to " + std::to_string(largest));
        return static_cast<LAMMPS_NS::bigint>(value);
    }

    /// Returns the next word as a number, or nothing for the word NULL.
    std::optional<double> number_or_null(std::string const &what, double smallest = 0.0)
    {
        if (skip("NULL")) return {};
        return number(what, smallest);
    }

    template <class Choice>
    Choice choice(std::string const &what, std::map<std::string, Choice> const &choices)
    {
        std::string const text = word(what);
        auto const found = choices.find(text);
        if (found != choices.end()) return found->second;
        std::string names;
        for (auto const &[name, value] : choices) names += (names.empty() ? "" : ", ") + name;
        refuse("has an unknown " + what + " " + text + ": use one of " + names);
    }

    [[noreturn]] void refuse(std::string const &reason) const
    {
        stop_all(*error, subject_ + " " + reason);
    }

  private:
    /// Returns the numbers that number() allows, in words.
    static std::string range(double smallest, double largest)
    {
        if (std::isinf(smallest)) return "a finite number";
        if (std::isinf(largest)) return "a finite number >= " + decimal(smallest);
        return "a number from " + decimal(smallest) + " to " + decimal(largest);
    }

    std::string subject_;
    int count_, position_ = 0;
    char **words_;
};

} // namespace pw85_lammps

#endif
