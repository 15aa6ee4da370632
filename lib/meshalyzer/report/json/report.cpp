#include "meshalyzer/report/json/report.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/require.h"
#include "meshalyzer/report/json/bytes.h"
#include "meshalyzer/report/json/findings.h"
#include "meshalyzer/report/json/mesh.h"
#include "meshalyzer/report/json/name.h"
#include "meshalyzer/report/json/schema.h"
#include "meshalyzer/report/json/set.h"
#include "meshalyzer/report/json/writer.h"

#include <utility>

namespace meshalyzer {

class JsonReport::Pieces {
 public:
  Pieces(TextSink sink, JsonOffenders offenders) : sink_(std::move(sink)), offenders_(offenders) {
    require_function("the sink of a JSON report", sink_);
    json_.begin_object();
    json_.member("schema", kReportSchema);
    json_.member("version", MESHALYZER_VERSION);
    json_.key("meshes");
    json_.begin_array();
  }

  void add(const Analysis& mesh) {
    require(stage_ == Stage::Meshes);
    json_.begin_object();
    write_mesh_members(json_, mesh, offenders_);
    json_.end_object();
    pour();
  }

  void add_unreadable(std::string path, std::string why) {
    require(stage_ == Stage::Meshes);
    unreadable_.push_back({std::move(path), std::move(why)});
  }

  void add(const ObjectFindings& findings, const std::vector<std::string>& names) {
    require(stage_ != Stage::Finished);
    if (!findings.separation) {
      return;
    }
    if (stage_ == Stage::Meshes) {
      begin_set();
      json_.key("closest");
      json_.begin_object();
      stage_ = Stage::Closest;
    }
    json_.key(json_name(names[findings.owner]));
    FindingsWriter(json_, names, on_row()).closest(*findings.separation);
    pour();
  }

  void finish(const SetAnalysis* set) {
    require(stage_ != Stage::Finished && (set != nullptr || stage_ == Stage::Meshes));
    if (set == nullptr) {
      end_meshes();
    } else {
      end_closest();
      write_set_members(json_, *set, on_row());
      json_.end_object();
    }
    json_.end_object();
    sink_(json_.take());
    stage_ = Stage::Finished;
  }

 private:
  enum class Stage { Meshes, Closest, Finished };

  static void require(bool is_in_order) {
    if (!is_in_order) {
      throw InvalidArgument("a JSON report is of meshes, then findings, then the set");
    }
  }

  void end_meshes() {
    json_.end_array();
    if (unreadable_.empty()) return;
    json_.key("unreadable");
    json_.begin_array();
    for (const Unreadable& file : unreadable_) {
      json_.begin_object(JsonLayout::Row);
      write_bytes(json_, "path", file.path);
      write_bytes(json_, "error", file.why);
      json_.end_object();
    }
    json_.end_array();
  }

  void begin_set() {
    end_meshes();
    json_.key("set");
    json_.begin_object();
  }

  void end_closest() {
    if (stage_ == Stage::Closest) {
      json_.end_object();
      return;
    }
    begin_set();
    json_.key("closest");
    json_.null();
  }

  void pour() { sink_(json_.drain()); }

  /// Returns the function that passes on long lists in pieces of moderate number and size.
  std::function<void()> on_row() {
    return [this] {
      constexpr std::size_t kPiece = std::size_t{1} << 16U;
      if (json_.pending() >= kPiece) {
        pour();
      }
    };
  }

  struct Unreadable {
    std::string path;
    std::string why;
  };

  TextSink sink_;
  JsonOffenders offenders_;
  JsonWriter json_;
  std::vector<Unreadable> unreadable_;
  Stage stage_ = Stage::Meshes;
};

JsonReport::JsonReport(TextSink sink, JsonOffenders offenders)
    : pieces_(std::make_unique<Pieces>(std::move(sink), offenders)) {}
JsonReport::~JsonReport() = default;
JsonReport::JsonReport(JsonReport&&) noexcept = default;
JsonReport& JsonReport::operator=(JsonReport&&) noexcept = default;

void JsonReport::add(const Analysis& mesh) {
  pieces_->add(mesh);
}

void JsonReport::add_unreadable(std::string path, std::string why) {
  pieces_->add_unreadable(std::move(path), std::move(why));
}

void JsonReport::add(const ObjectFindings& findings, const std::vector<std::string>& names) {
  pieces_->add(findings, names);
}

void JsonReport::finish(const SetAnalysis* set) {
  pieces_->finish(set);
}

std::string json_report(std::span<const Analysis> meshes, const SetAnalysis* set,
                        JsonOffenders offenders) {
  std::string text;
  JsonReport report([&](std::string_view piece) { text += piece; }, offenders);
  for (const Analysis& mesh : meshes) {
    report.add(mesh);
  }
  report.finish(set);
  return text;
}

}  // namespace meshalyzer
