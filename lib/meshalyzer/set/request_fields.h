#pragma once

#include "meshalyzer/set/request.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>

namespace meshalyzer {

/// A member of a part of a request, and its key in files.
template <typename Part, typename Member>
struct RequestField {
  std::string_view key;
  Member Part::*member;
};
template <typename Part, typename Member>
RequestField(std::string_view, Member Part::*) -> RequestField<Part, Member>;

/// All members of a part of a request. Requests are written and read by this table; if a member is
/// missing here, the code does not compile.
template <typename Part>
inline constexpr auto kRequestFields = std::tuple{};

template <>
inline constexpr auto kRequestFields<GoodnessThresholds> = std::tuple{
    RequestField{"aspect_ratio", &GoodnessThresholds::aspect_ratio},
    RequestField{"edge_angle_degrees", &GoodnessThresholds::edge_angle_degrees},
    RequestField{"edge_length", &GoodnessThresholds::edge_length},
};

template <>
inline constexpr auto kRequestFields<MeshRequest> = std::tuple{
    RequestField{"scope", &MeshRequest::scope},
    RequestField{"goodness", &MeshRequest::goodness},
    RequestField{"shorter_than", &MeshRequest::shorter_than},
    RequestField{"longer_than", &MeshRequest::longer_than},
    RequestField{"angle_below_degrees", &MeshRequest::angle_below_degrees},
    RequestField{"angle_above_degrees", &MeshRequest::angle_above_degrees},
    RequestField{"aspect_above", &MeshRequest::aspect_above},
    RequestField{"exact_coincidence", &MeshRequest::exact_coincidence},
    RequestField{"judge_fitness", &MeshRequest::judge_fitness},
    RequestField{"curvature", &MeshRequest::curvature},
    RequestField{"max_list", &MeshRequest::max_list},
};

template <>
inline constexpr auto kRequestFields<SeparationOptions> = std::tuple{
    RequestField{"search_radius", &SeparationOptions::search_radius},
    RequestField{"search_cone_degrees", &SeparationOptions::search_cone_degrees},
    RequestField{"include_self", &SeparationOptions::include_self},
};

template <>
inline constexpr auto kRequestFields<SetQuestions> = std::tuple{
    RequestField{"intersections", &SetQuestions::intersections},
    RequestField{"separation", &SetQuestions::separation},
    RequestField{"statistics", &SetQuestions::statistics},
    RequestField{"force", &SetQuestions::force},
};

template <>
inline constexpr auto kRequestFields<Request> = std::tuple{
    RequestField{"mesh", &Request::mesh},
    RequestField{"list_offenders", &Request::list_offenders},
    RequestField{"is_set", &Request::is_set},
    RequestField{"between", &Request::between},
    RequestField{"time_limit", &Request::time_limit},
};

template <typename Part>
inline constexpr std::size_t kRequestFieldCount =
    std::tuple_size_v<std::remove_const_t<decltype(kRequestFields<Part>)>>;

template <typename T>
inline constexpr bool kIsOptional = false;
template <typename T>
inline constexpr bool kIsOptional<std::optional<T>> = true;

/// Converts to any type in an unevaluated expression. Optionals are excluded: they convert from
/// their content, so there would be two ways to make one.
struct AnyValue {
  template <typename T>
  requires(!kIsOptional<T>) operator T() const;
};

/// Counts the members of an aggregate without bases: the number of values that can initialize it. A
/// static_assert with it proves that a list of all members is complete.
template <typename T, typename... Values>
consteval std::size_t member_count(Values... values) {
  if constexpr (requires { T{values..., AnyValue{}}; }) {
    return member_count<T>(values..., AnyValue{});
  } else {
    return sizeof...(values);
  }
}

/// Tells whether a type is a part of a request, with members of its own.
template <typename T>
concept RequestPart = kRequestFieldCount<T>
!= 0;

/// Calls `use` with each row of the table of a part.
template <RequestPart Part, typename Use>
void for_each_request_field(const Use& use) {
  static_assert(member_count<Part>() == kRequestFieldCount<Part>,
                "a member of the request is missing in kRequestFields");
  std::apply([&](const auto&... field) { (use(field), ...); }, kRequestFields<Part>);
}

}  // namespace meshalyzer
