#include "meshalyzer/defects/defect_list.h"

#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

namespace meshalyzer {
namespace {

// A packed defect is its code, its flags, and then the members that the flags announce, in the
// order of Defect: a list as the number of its items and their bytes, all else as its bytes.

enum Flag : std::uint16_t {
  kIsWarning = 1U << 0U,
  kIsFixable = 1U << 1U,
  kHasVertices = 1U << 2U,
  kHasEdges = 1U << 3U,
  kHasFaces = 1U << 4U,
  kHasPositions = 1U << 5U,
  kHasPairs = 1U << 6U,
  kHasValue = 1U << 7U,
  kHasLimit = 1U << 8U,
  kHasLine = 1U << 9U,
  kHasDetail = 1U << 10U,
};

/// The bytes that every packed defect begins with.
struct Head {
  DefectCode code = DefectCode::Corrupt;
  std::uint8_t padding = 0;
  std::uint16_t flags = 0;
};

Head read_head(const std::byte* bytes) {
  Head head;
  std::memcpy(&head, bytes, sizeof head);
  return head;
}

/// Returns the flag if there is something to be announced by it, else 0.
std::uint16_t flag_if(bool is_set, Flag flag) {
  return is_set ? static_cast<std::uint16_t>(flag) : std::uint16_t{0};
}

Head head_of(const Defect& defect) {
  Head head;
  head.code = defect.code;
  head.flags = static_cast<std::uint16_t>(
      flag_if(defect.severity == Severity::Warning, kIsWarning) |
      flag_if(defect.fixable, kIsFixable) | flag_if(!defect.vertices.empty(), kHasVertices) |
      flag_if(!defect.edges.empty(), kHasEdges) | flag_if(!defect.faces.empty(), kHasFaces) |
      flag_if(!defect.positions.empty(), kHasPositions) |
      flag_if(!defect.pairs.empty(), kHasPairs) | flag_if(defect.value.has_value(), kHasValue) |
      flag_if(defect.limit.has_value(), kHasLimit) | flag_if(defect.line.has_value(), kHasLine) |
      flag_if(!defect.detail.empty(), kHasDetail));
  return head;
}

/// Appends the members of a defect to bytes.
class Packer {
 public:
  Packer(std::vector<std::byte>& bytes, std::uint16_t flags) : bytes_(bytes), flags_(flags) {}

  template <typename List>
  void list(Flag flag, const List& items) {
    if ((flags_ & flag) == 0) return;
    const auto n = static_cast<std::uint32_t>(items.size());
    append(&n, sizeof n);
    append(items.data(), n * sizeof(typename List::value_type));
  }
  template <typename T>
  void value(Flag flag, const std::optional<T>& value) {
    if ((flags_ & flag) != 0) append(&*value, sizeof(T));
  }
  void append(const void* data, std::size_t n) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), first, first + n);
  }

 private:
  std::vector<std::byte>& bytes_;
  std::uint16_t flags_;
};

/// Reads the members of a defect from bytes.
class Unpacker {
 public:
  Unpacker(const std::byte* at, std::uint16_t flags) : at_(at), flags_(flags) {}

  template <typename List>
  void list(Flag flag, List& items) {
    if ((flags_ & flag) == 0) return;
    std::uint32_t n = 0;
    take(&n, sizeof n);
    items.resize(n);
    take(items.data(), n * sizeof(typename List::value_type));
  }
  template <typename T>
  void value(Flag flag, std::optional<T>& value) {
    if ((flags_ & flag) != 0) take(&value.emplace(), sizeof(T));
  }

 private:
  void take(void* data, std::size_t n) {
    std::memcpy(data, at_, n);
    at_ += n;
  }

  const std::byte* at_;
  std::uint16_t flags_;
};

/// Packs or unpacks the members in their order.
template <typename Pass, typename AnyDefect>
void pass_members(Pass& pass, AnyDefect& defect) {
  pass.list(kHasVertices, defect.vertices);
  pass.list(kHasEdges, defect.edges);
  pass.list(kHasFaces, defect.faces);
  pass.list(kHasPositions, defect.positions);
  pass.list(kHasPairs, defect.pairs);
  pass.value(kHasValue, defect.value);
  pass.value(kHasLimit, defect.limit);
  pass.value(kHasLine, defect.line);
  pass.list(kHasDetail, defect.detail);
}

}  // namespace

Defect DefectList::operator[](std::size_t i) const {
  const Head head = read_head(bytes_of(i));
  Defect defect;
  defect.code = head.code;
  defect.severity = (head.flags & kIsWarning) != 0 ? Severity::Warning : Severity::Error;
  defect.fixable = (head.flags & kIsFixable) != 0;
  Unpacker unpacker(bytes_of(i) + sizeof head, head.flags);
  pass_members(unpacker, defect);
  return defect;
}

Defect DefectList::at(std::size_t i) const {
  if (i >= size()) throw std::out_of_range("no such defect");
  return (*this)[i];
}

DefectCode DefectList::code_of(std::size_t i) const {
  return read_head(bytes_of(i)).code;
}

bool DefectList::is_fixable(std::size_t i) const {
  return (read_head(bytes_of(i)).flags & kIsFixable) != 0;
}

void DefectList::push_back(const Defect& defect) {
  begin_of_.push_back(bytes_.size());
  const Head head = head_of(defect);
  Packer packer(bytes_, head.flags);
  packer.append(&head, sizeof head);
  pass_members(packer, defect);
}

void DefectList::append(DefectList others, std::size_t n) {
  if (n == others.size() && empty()) {
    *this = std::move(others);
    return;
  }
  const std::size_t end = n == others.size() ? others.bytes_.size() : others.begin_of_[n];
  const std::size_t shift = bytes_.size();
  bytes_.insert(bytes_.end(), others.bytes_.begin(),
                others.bytes_.begin() + static_cast<std::ptrdiff_t>(end));
  for (std::size_t i = 0; i < n; ++i) begin_of_.push_back(others.begin_of_[i] + shift);
}

}  // namespace meshalyzer
