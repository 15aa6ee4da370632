#pragma once

#include "meshalyzer/set/request_fields.h"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer::test {

/// A change to one member of a part of a request, and the way to that member.
template <typename Part>
struct Change {
  std::string name;
  std::function<void(Part&)> make;
};

inline void make_other(bool& truth) {
  truth = !truth;
}
inline void make_other(std::size_t& count) {
  ++count;
}
inline void make_other(double& real) {
  real += 0.1;
}
inline void make_other(Scope& scope) {
  scope = Scope::AttributesOnly;
}
inline void make_other(VertexArea& area) {
  area = VertexArea::OneRing;
}

/// All changes of one member, as kRequestFields lists them.
template <RequestPart Part>
std::vector<Change<Part>> all_changes();

/// The changes of a value that a member holds.
template <typename T>
std::vector<Change<T>> changes_of() {
  if constexpr (RequestPart<T>) {
    return all_changes<T>();
  } else {
    return {{"", [](T& value) { make_other(value); }}};
  }
}

template <RequestPart Part>
std::vector<Change<Part>> all_changes() {
  std::vector<Change<Part>> all;
  for_each_request_field<Part>([&](const auto& field) {
    using Member = std::remove_cvref_t<decltype(std::declval<Part&>().*field.member)>;
    const std::string name = "." + std::string(field.key);
    const auto member = field.member;
    if constexpr (kIsOptional<Member>) {
      all.push_back({name, [member](Part& part) { (part.*member).emplace(); }});
      for (const auto& change : changes_of<typename Member::value_type>()) {
        all.push_back({name + change.name + " changed",
                       [member, change](Part& part) { change.make((part.*member).emplace()); }});
      }
    } else {
      for (const auto& change : changes_of<Member>()) {
        all.push_back(
            {name + change.name, [member, change](Part& part) { change.make(part.*member); }});
      }
    }
  });
  return all;
}

/// Requests that differ from a default one in one member each, by the way to it.
inline std::vector<std::pair<std::string, Request>> changed_requests() {
  std::vector<std::pair<std::string, Request>> requests;
  for (const Change<Request>& change : all_changes<Request>()) {
    Request request;
    change.make(request);
    requests.emplace_back(change.name, request);
  }
  return requests;
}

}  // namespace meshalyzer::test
