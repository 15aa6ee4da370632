#pragma once

#include "meshalyzer/defects/defect.h"

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <span>
#include <vector>

namespace meshalyzer {

/// A list of defects, each packed into as many bytes as it needs: some forty for a defect of one
/// vertex or face, where a Defect takes three hundred. A mesh may have millions of defects.
///
/// Reading an element unpacks it, so that elements are values, never references.
class DefectList {
 public:
  class Iterator;
  using value_type = Defect;
  using const_iterator = Iterator;

  DefectList() = default;
  DefectList(std::initializer_list<Defect> defects) {
    for (const Defect& defect : defects) push_back(defect);
  }

  [[nodiscard]] std::size_t size() const { return begin_of_.size(); }
  [[nodiscard]] bool empty() const { return begin_of_.empty(); }
  [[nodiscard]] Defect operator[](std::size_t i) const;
  /// @throws std::out_of_range  if there is no such defect.
  [[nodiscard]] Defect at(std::size_t i) const;
  [[nodiscard]] Defect front() const { return (*this)[0]; }
  [[nodiscard]] Defect back() const { return (*this)[size() - 1]; }
  [[nodiscard]] Iterator begin() const;
  [[nodiscard]] Iterator end() const;

  /// Returns the code of a defect without unpacking the rest.
  [[nodiscard]] DefectCode code_of(std::size_t i) const;
  /// Returns whether a defect is fixable without unpacking the rest.
  [[nodiscard]] bool is_fixable(std::size_t i) const;

  void push_back(const Defect& defect);
  /// Appends the first `n` defects of another list.
  void append(DefectList others, std::size_t n);

 private:
  [[nodiscard]] const std::byte* bytes_of(std::size_t i) const {
    return bytes_.data() + begin_of_[i];
  }

  std::vector<std::byte> bytes_;
  /// #defects: where the bytes of each begin.
  std::vector<std::size_t> begin_of_;
};

/// Visits the defects of a list in order.
class DefectList::Iterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = Defect;
  using difference_type = std::ptrdiff_t;
  using pointer = void;
  using reference = Defect;

  Iterator(const DefectList& list, std::size_t place) : list_(&list), place_(place) {}

  [[nodiscard]] Defect operator*() const { return (*list_)[place_]; }
  Iterator& operator++() {
    ++place_;
    return *this;
  }
  Iterator operator++(int) {
    const Iterator before = *this;
    ++place_;
    return before;
  }
  friend bool operator==(const Iterator& a, const Iterator& b) { return a.place_ == b.place_; }

 private:
  const DefectList* list_;
  std::size_t place_;
};

inline DefectList::Iterator DefectList::begin() const {
  return {*this, 0};
}

inline DefectList::Iterator DefectList::end() const {
  return {*this, size()};
}

}  // namespace meshalyzer
