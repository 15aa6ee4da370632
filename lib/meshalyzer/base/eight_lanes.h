#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif
#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace meshalyzer {

// Eight numbers side by side, as the leaves and nodes of trees hold them, and comparisons of all
// eight at once. There are three sets of types with the same names and the same answers to the last
// bit: `avx2` and `sse2` where the compiler may use such registers, and `portable` everywhere.

namespace portable {

/// Eight truth values.
struct EightFlags {
  unsigned flags = 0;

  /// Bit i is set where flag i is.
  [[nodiscard]] unsigned bits() const { return flags; }
  friend EightFlags operator|(EightFlags a, EightFlags b) { return {a.flags | b.flags}; }
  friend EightFlags operator&(EightFlags a, EightFlags b) { return {a.flags & b.flags}; }
};

template <typename Number>
struct EightNumbers {
  std::array<Number, 8> lanes;

  [[nodiscard]] static EightNumbers load(const std::array<Number, 8>& numbers) { return {numbers}; }
  [[nodiscard]] static EightNumbers all(Number number) {
    EightNumbers eight;
    eight.lanes.fill(number);
    return eight;
  }
  [[nodiscard]] std::array<Number, 8> numbers() const { return lanes; }

  friend EightNumbers operator+(const EightNumbers& a, const EightNumbers& b) {
    return combine(a, b, [](Number x, Number y) { return x + y; });
  }
  friend EightNumbers operator-(const EightNumbers& a, const EightNumbers& b) {
    return combine(a, b, [](Number x, Number y) { return x - y; });
  }
  friend EightNumbers operator*(const EightNumbers& a, const EightNumbers& b) {
    return combine(a, b, [](Number x, Number y) { return x * y; });
  }
  friend EightNumbers operator/(const EightNumbers& a, const EightNumbers& b) {
    return combine(a, b, [](Number x, Number y) { return x / y; });
  }
  /// Returns the first numbers where the flags are set, and the second ones elsewhere.
  friend EightNumbers select(EightFlags flags, const EightNumbers& a, const EightNumbers& b) {
    EightNumbers result;
    for (std::size_t i = 0; i < 8; ++i) {
      result.lanes[i] = (flags.flags >> i & 1U) != 0 ? a.lanes[i] : b.lanes[i];
    }
    return result;
  }
  /// Returns the smaller numbers. Where two are equal or cannot be compared, it returns the second.
  friend EightNumbers min(const EightNumbers& a, const EightNumbers& b) {
    return combine(a, b, [](Number x, Number y) { return x < y ? x : y; });
  }
  friend EightNumbers max(const EightNumbers& a, const EightNumbers& b) {
    return combine(a, b, [](Number x, Number y) { return y < x ? x : y; });
  }
  friend EightFlags operator<(const EightNumbers& a, const EightNumbers& b) {
    return compare(a, b, [](Number x, Number y) { return x < y; });
  }
  friend EightFlags operator<=(const EightNumbers& a, const EightNumbers& b) {
    return compare(a, b, [](Number x, Number y) { return x <= y; });
  }
  friend EightFlags operator==(const EightNumbers& a, const EightNumbers& b) {
    return compare(a, b, [](Number x, Number y) { return x == y; });
  }

 private:
  template <typename Operation>
  static EightNumbers combine(const EightNumbers& a, const EightNumbers& b, Operation of) {
    EightNumbers result;
    for (std::size_t i = 0; i < 8; ++i) {
      result.lanes[i] = of(a.lanes[i], b.lanes[i]);
    }
    return result;
  }
  template <typename Relation>
  static EightFlags compare(const EightNumbers& a, const EightNumbers& b, Relation holds) {
    EightFlags result;
    for (std::size_t i = 0; i < 8; ++i) {
      result.flags |= static_cast<unsigned>(holds(a.lanes[i], b.lanes[i])) << i;
    }
    return result;
  }
};

using EightFloats = EightNumbers<float>;
using EightIds = EightNumbers<std::uint32_t>;

}  // namespace portable

#ifdef __SSE2__
namespace sse2 {

/// Eight truth values; all bits of a lane are set, or none.
struct EightFlags {
  __m128 low;
  __m128 high;

  [[nodiscard]] unsigned bits() const {
    return static_cast<unsigned>(_mm_movemask_ps(low)) |
           static_cast<unsigned>(_mm_movemask_ps(high)) << 4;
  }
  friend EightFlags operator|(const EightFlags& a, const EightFlags& b) {
    return {_mm_or_ps(a.low, b.low), _mm_or_ps(a.high, b.high)};
  }
  friend EightFlags operator&(const EightFlags& a, const EightFlags& b) {
    return {_mm_and_ps(a.low, b.low), _mm_and_ps(a.high, b.high)};
  }
};

struct EightFloats {
  __m128 low;
  __m128 high;

  [[nodiscard]] static EightFloats load(const std::array<float, 8>& numbers) {
    return {_mm_loadu_ps(numbers.data()), _mm_loadu_ps(numbers.data() + 4)};
  }
  [[nodiscard]] static EightFloats all(float number) {
    return {_mm_set1_ps(number), _mm_set1_ps(number)};
  }
  [[nodiscard]] std::array<float, 8> numbers() const {
    std::array<float, 8> numbers;
    _mm_storeu_ps(numbers.data(), low);
    _mm_storeu_ps(numbers.data() + 4, high);
    return numbers;
  }
  friend EightFloats operator+(const EightFloats& a, const EightFloats& b) {
    return {_mm_add_ps(a.low, b.low), _mm_add_ps(a.high, b.high)};
  }
  friend EightFloats operator-(const EightFloats& a, const EightFloats& b) {
    return {_mm_sub_ps(a.low, b.low), _mm_sub_ps(a.high, b.high)};
  }
  friend EightFloats operator*(const EightFloats& a, const EightFloats& b) {
    return {_mm_mul_ps(a.low, b.low), _mm_mul_ps(a.high, b.high)};
  }
  friend EightFloats operator/(const EightFloats& a, const EightFloats& b) {
    return {_mm_div_ps(a.low, b.low), _mm_div_ps(a.high, b.high)};
  }
  friend EightFloats select(const EightFlags& flags, const EightFloats& a, const EightFloats& b) {
    return {_mm_or_ps(_mm_and_ps(flags.low, a.low), _mm_andnot_ps(flags.low, b.low)),
            _mm_or_ps(_mm_and_ps(flags.high, a.high), _mm_andnot_ps(flags.high, b.high))};
  }
  friend EightFloats min(const EightFloats& a, const EightFloats& b) {
    return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)};
  }
  friend EightFloats max(const EightFloats& a, const EightFloats& b) {
    return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)};
  }
  friend EightFlags operator<(const EightFloats& a, const EightFloats& b) {
    return {_mm_cmplt_ps(a.low, b.low), _mm_cmplt_ps(a.high, b.high)};
  }
  friend EightFlags operator<=(const EightFloats& a, const EightFloats& b) {
    return {_mm_cmple_ps(a.low, b.low), _mm_cmple_ps(a.high, b.high)};
  }
};

struct EightIds {
  __m128i low;
  __m128i high;

  [[nodiscard]] static EightIds load(const std::array<std::uint32_t, 8>& numbers) {
    const auto* halves = reinterpret_cast<const __m128i*>(numbers.data());
    return {_mm_loadu_si128(halves), _mm_loadu_si128(halves + 1)};
  }
  [[nodiscard]] static EightIds all(std::uint32_t number) {
    const __m128i four = _mm_set1_epi32(std::bit_cast<int>(number));
    return {four, four};
  }
  friend EightFlags operator==(const EightIds& a, const EightIds& b) {
    return {_mm_castsi128_ps(_mm_cmpeq_epi32(a.low, b.low)),
            _mm_castsi128_ps(_mm_cmpeq_epi32(a.high, b.high))};
  }
};

}  // namespace sse2
#endif

#ifdef __AVX2__
namespace avx2 {

/// Eight truth values; all bits of a lane are set, or none.
struct EightFlags {
  __m256 lanes;

  [[nodiscard]] unsigned bits() const { return static_cast<unsigned>(_mm256_movemask_ps(lanes)); }
  friend EightFlags operator|(const EightFlags& a, const EightFlags& b) {
    return {_mm256_or_ps(a.lanes, b.lanes)};
  }
  friend EightFlags operator&(const EightFlags& a, const EightFlags& b) {
    return {_mm256_and_ps(a.lanes, b.lanes)};
  }
};

struct EightFloats {
  __m256 lanes;

  [[nodiscard]] static EightFloats load(const std::array<float, 8>& numbers) {
    return {_mm256_loadu_ps(numbers.data())};
  }
  [[nodiscard]] static EightFloats all(float number) { return {_mm256_set1_ps(number)}; }
  [[nodiscard]] std::array<float, 8> numbers() const {
    std::array<float, 8> numbers;
    _mm256_storeu_ps(numbers.data(), lanes);
    return numbers;
  }
  friend EightFloats operator+(const EightFloats& a, const EightFloats& b) {
    return {_mm256_add_ps(a.lanes, b.lanes)};
  }
  friend EightFloats operator-(const EightFloats& a, const EightFloats& b) {
    return {_mm256_sub_ps(a.lanes, b.lanes)};
  }
  friend EightFloats operator*(const EightFloats& a, const EightFloats& b) {
    return {_mm256_mul_ps(a.lanes, b.lanes)};
  }
  friend EightFloats operator/(const EightFloats& a, const EightFloats& b) {
    return {_mm256_div_ps(a.lanes, b.lanes)};
  }
  friend EightFloats select(const EightFlags& flags, const EightFloats& a, const EightFloats& b) {
    return {_mm256_blendv_ps(b.lanes, a.lanes, flags.lanes)};
  }
  friend EightFloats min(const EightFloats& a, const EightFloats& b) {
    return {_mm256_min_ps(a.lanes, b.lanes)};
  }
  friend EightFloats max(const EightFloats& a, const EightFloats& b) {
    return {_mm256_max_ps(a.lanes, b.lanes)};
  }
  friend EightFlags operator<(const EightFloats& a, const EightFloats& b) {
    return {_mm256_cmp_ps(a.lanes, b.lanes, _CMP_LT_OS)};
  }
  friend EightFlags operator<=(const EightFloats& a, const EightFloats& b) {
    return {_mm256_cmp_ps(a.lanes, b.lanes, _CMP_LE_OS)};
  }
};

struct EightIds {
  __m256i lanes;

  [[nodiscard]] static EightIds load(const std::array<std::uint32_t, 8>& numbers) {
    return {_mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers.data()))};
  }
  [[nodiscard]] static EightIds all(std::uint32_t number) {
    return {_mm256_set1_epi32(std::bit_cast<int>(number))};
  }
  friend EightFlags operator==(const EightIds& a, const EightIds& b) {
    return {_mm256_castsi256_ps(_mm256_cmpeq_epi32(a.lanes, b.lanes))};
  }
};

}  // namespace avx2
#endif

#if defined(__AVX2__)
using avx2::EightFlags;
using avx2::EightFloats;
using avx2::EightIds;
#elif defined(__SSE2__)
using sse2::EightFlags;
using sse2::EightFloats;
using sse2::EightIds;
#else
using portable::EightFlags;
using portable::EightFloats;
using portable::EightIds;
#endif

}  // namespace meshalyzer
