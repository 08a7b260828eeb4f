#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace base {

/// Writes value / 10^decimals as a short decimal: "30", "-0.05", "12.5". No locale, no exponent.
/// Precondition: 0 <= decimals <= 9.
std::string write_decimal(std::int64_t value, int decimals);

/// Says why a text is no decimal.
enum class DecimalError
{
    none,
    empty,
    comma,    ///< a comma where the point should be
    exponent, ///< a number with an exponent
    no_number,
    too_large, ///< more than 12 digits before the point
};

struct Decimal
{
    DecimalError error;
    std::int64_t value; ///< times 10^decimals, rounded, halves away from zero; 0 on error
};

/// Reads [+-]digits[.digits], or [+-].digits, and returns it times 10^decimals as a whole number.
/// More decimals are rounded. Only whole-number arithmetic, so that the result is the same everywhere.
/// Precondition: 0 <= decimals <= 6.
Decimal read_decimal(std::string_view text, int decimals);

} // namespace base
