#include "meshalyzer/report/journal/request.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/find_named.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/set/request_fields.h"

#include <array>
#include <cmath>
#include <type_traits>

namespace meshalyzer {
namespace {

std::string_view scope_name(Scope scope) {
  return scope == Scope::Everything ? "everything" : "attributes";
}

std::optional<Scope> scope_of(std::string_view name) {
  return find_named(std::array{Scope::Everything, Scope::AttributesOnly}, name, scope_name);
}

void write_scalar(JsonWriter& json, bool truth) {
  json.value(truth);
}
/// Writes a number as a value; JSON has no infinite numbers.
void write_scalar(JsonWriter& json, double real) {
  std::isfinite(real) ? json.value(real) : json.value(shortest(real));
}
void write_scalar(JsonWriter& json, std::size_t count) {
  json.value(count);
}
void write_scalar(JsonWriter& json, Scope scope) {
  json.value(scope_name(scope));
}
void write_scalar(JsonWriter& json, VertexArea area) {
  json.value(area_name(area));
}

/// Writes the members of a part of a request that differ from the default.
template <RequestPart Part>
void write_request_members(JsonWriter& json, const Part& part);

template <typename T>
void write_request_value(JsonWriter& json, const T& value) {
  if constexpr (kIsOptional<T>) {
    value ? write_request_value(json, *value) : json.null();
  } else if constexpr (RequestPart<T>) {
    json.begin_object(JsonLayout::Row);
    write_request_members(json, value);
    json.end_object();
  } else {
    write_scalar(json, value);
  }
}

template <RequestPart Part>
void write_request_members(JsonWriter& json, const Part& part) {
  const Part by_default{};
  for_each_request_field<Part>([&](const auto& field) {
    if (part.*field.member != by_default.*field.member) {
      json.key(field.key);
      write_request_value(json, part.*field.member);
    }
  });
}

/// Reads the members of a request, and counts them.
class RequestReader {
 public:
  explicit RequestReader(const HeadMembers& members) : members_(members) {}

  template <RequestPart Part>
  void read_members(const std::string& object, Part& part) {
    for_each_request_field<Part>([&](const auto& field) {
      std::string key = object + ".";
      key += field.key;
      if (const HeadMembers::Value* value = members_.find(key)) {
        ++n_read_;
        read_value(key, *value, part.*field.member);
      }
    });
  }

  [[nodiscard]] std::size_t n_read() const { return n_read_; }

 private:
  template <typename T>
  void read_value(const std::string& key, const HeadMembers::Value& value, T& read) {
    if constexpr (kIsOptional<T>) {
      if (std::holds_alternative<HeadMembers::Null>(value)) {
        read.reset();
      } else {
        read_value(key, value, read.emplace());
      }
    } else if constexpr (RequestPart<T>) {
      static_cast<void>(members_.get<HeadMembers::Object>(key));
      read_members(key, read);
    } else {
      read_scalar(key, read);
    }
  }

  void read_scalar(const std::string& key, bool& read) const { read = members_.get<bool>(key); }
  void read_scalar(const std::string& key, Scope& read) const {
    read = named(key, scope_of(members_.get<std::string>(key)));
  }
  void read_scalar(const std::string& key, VertexArea& read) const {
    read = named(key, vertex_area(members_.get<std::string>(key)));
  }
  void read_scalar(const std::string& key, std::size_t& read) const { read = members_.count(key); }
  void read_scalar(const std::string& key, double& read) const {
    const HeadMembers::Value& value = *members_.find(key);
    if (const std::int64_t* integer = std::get_if<std::int64_t>(&value)) {
      read = static_cast<double>(*integer);
    } else if (const double* real = std::get_if<double>(&value)) {
      read = *real;
    } else {
      read = named(key, parse_real(members_.get<std::string>(key)));
      if (!std::isinf(read)) {
        HeadMembers::refuse(key);
      }
    }
  }

  template <typename T>
  static T named(const std::string& key, const std::optional<T>& value) {
    return value ? *value : (HeadMembers::refuse(key), T{});
  }

  const HeadMembers& members_;
  std::size_t n_read_ = 0;
};

/// Checks the version.
/// @throws InvalidArgument if it is not the version of this library.
void require_version(const HeadMembers& members, const std::string& object) {
  const HeadMembers::Value* member = members.find(object);
  if (member != nullptr && std::holds_alternative<std::string>(*member)) {
    throw InvalidArgument(
        "was written by an earlier version of meshalyzer, whose journals this one cannot read");
  }
  const auto& version = members.get<std::string>(object + ".version");
  if (version != MESHALYZER_VERSION) {
    throw InvalidArgument("was written by version " + version +
                          " of meshalyzer, and this is " MESHALYZER_VERSION);
  }
}

}  // namespace

void write_request(JsonWriter& json, const Request& request) {
  json.begin_object(JsonLayout::Row);
  json.member("version", MESHALYZER_VERSION);
  write_request_members(json, request);
  json.end_object();
}

std::string request_text(const Request& request) {
  JsonWriter json;
  write_request(json, request);
  std::string text = json.take();
  text.pop_back();  // the line feed
  return text;
}

Request read_request(const HeadMembers& members, const std::string& key) {
  require_version(members, key);
  Request request;
  RequestReader reader(members);
  reader.read_members(key, request);
  if (members.n_in(key) != reader.n_read() + 1) {
    HeadMembers::refuse(key);
  }
  return request;
}

}  // namespace meshalyzer
