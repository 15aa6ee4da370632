#pragma once

#include "meshalyzer/io/write.h"
#include "meshalyzer/set/set_run.h"
#include "support/described_set.h"
#include "support/temporary_folder.h"

#include <atomic>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace meshalyzer::test {

/// Soups as files of a folder, by number.
class SoupFiles {
 public:
  explicit SoupFiles(const std::vector<Soup>& soups) {
    for (std::size_t i = 0; i < soups.size(); ++i) {
      paths_.push_back(folder_.file(std::to_string(10 + i) + ".mesh"));
      write_mesh(soups[i], paths_.back());
    }
  }

  [[nodiscard]] const std::vector<std::string>& paths() const { return paths_; }
  /// A further file, of any content.
  void add(const std::string& name, const std::string& content) {
    paths_.push_back(folder_.file(name));
    write_bytes(paths_.back(), content);
  }

 private:
  TemporaryFolder folder_;
  std::vector<std::string> paths_;
};

/// The calls that a listener received.
struct Told {
  std::map<Index, Analysis> meshes;
  std::map<Index, std::string> troubles;
  std::map<Index, ObjectFindings> findings;

  void add(const Told& other) {
    meshes.insert(other.meshes.begin(), other.meshes.end());
    troubles.insert(other.troubles.begin(), other.troubles.end());
    findings.insert(other.findings.begin(), other.findings.end());
  }
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const auto& [number, mesh] : meshes) {
      text += std::to_string(number) + ": " + described(mesh);
    }
    for (const auto& [number, why] : troubles) {
      text += std::to_string(number) + ": " + why + "\n";
    }
    for (const auto& [number, found] : findings) {
      text += described(found);
    }
    return text;
  }
};

/// Writes down all calls; knows what it is given.
class Recorder : public RunListener, public EarlierFindings {
 public:
  Told known;
  Told told;
  /// One line a call: "mesh 3", "trouble 4", "findings 2", "files 3/5 36", "between 1/5 12".
  std::vector<std::string> calls;
  /// The content of the calls.
  std::string text;

  void on_mesh(Index number, const Analysis& mesh) override {
    call("mesh " + std::to_string(number), described(mesh));
    told.meshes.emplace(number, mesh);
  }
  void on_unreadable(Index number, const std::string& why) override {
    call("trouble " + std::to_string(number), why);
    told.troubles.emplace(number, why);
  }
  void on_findings(const ObjectFindings& findings) override {
    call("findings " + std::to_string(findings.owner), described(findings));
    told.findings.emplace(findings.owner, findings);
  }
  void on_progress(const RunProgress& progress) override {
    const bool is_files = progress.stage == RunProgress::Stage::Files;
    call((is_files ? "files " : "between ") + std::to_string(progress.done) + "/" +
             std::to_string(progress.total) + " " + std::to_string(progress.faces),
         "");
  }
  std::optional<Analysis> mesh(Index number) const override { return find(known.meshes, number); }
  std::optional<std::string> error(Index number) const override {
    return find(known.troubles, number);
  }
  std::optional<ObjectFindings> findings(Index owner) const override {
    return find(known.findings, owner);
  }

  /// Tells whether two calls ever came at the same time.
  [[nodiscard]] bool was_called_at_once() const { return was_called_at_once_; }

 protected:
  virtual void call(const std::string& name, const std::string& said) {
    was_called_at_once_ = was_called_at_once_ || is_in_call_.exchange(true);
    calls.push_back(name);
    text += name + "\n" + said;
    is_in_call_ = false;
  }

 private:
  template <typename T>
  static std::optional<T> find(const std::map<Index, T>& items, Index number) {
    const auto place = items.find(number);
    return place == items.end() ? std::nullopt : std::optional(place->second);
  }

  std::atomic<bool> is_in_call_ = false;
  std::atomic<bool> was_called_at_once_ = false;
};

/// The options of a run that need not look for what a recorder knows.
inline SetOptions knowing(const Recorder& recorder, SetOptions options = {}) {
  options.earlier = &recorder;
  return options;
}

}  // namespace meshalyzer::test
