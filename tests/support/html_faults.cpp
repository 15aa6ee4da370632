#include "support/html_faults.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <set>
#include <utility>

namespace meshalyzer::test {
namespace {

constexpr std::array<std::string_view, 5> kVoid{"br", "hr", "input", "link", "meta"};
constexpr std::array<std::string_view, 2> kRaw{"script", "style"};
constexpr std::array<std::string_view, 9> kNotInParagraph{"div", "p",  "ul",      "ol",    "table",
                                                          "h2",  "h3", "section", "figure"};

template <typename Words>
bool is_one_of(std::string_view word, const Words& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_name_character(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '-';
}

bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\t';
}

using Attributes = std::map<std::string, std::string, std::less<>>;

class Checker {
 public:
  explicit Checker(std::string_view html) : html_(html) {}

  std::vector<std::string> faults() {
    check_characters();
    if (!html_.starts_with("<!doctype html>")) fault("no doctype");
    at_ = html_.find('>') + 1;
    while (at_ < html_.size()) step();
    for (const std::string& tag : open_) fault("not closed: " + tag);
    for (const std::string& id : referred_) {
      if (!ids_.contains(id)) fault("no element has the id " + id);
    }
    if (n_first_headings_ != 1) fault("not one h1");
    return faults_;
  }

 private:
  void fault(const std::string& what) { faults_.push_back(what); }

  /// Continuation bytes must follow lead bytes, as many as these say.
  void check_characters() {
    for (std::size_t i = 0; i < html_.size();) {
      const auto c = static_cast<unsigned char>(html_[i]);
      if ((c < 0x20U && c != '\n' && c != '\t') || c == 0x7FU) fault("control character");
      const std::size_t length = c < 0x80U ? 1 : c < 0xE0U ? 2 : c < 0xF0U ? 3 : 4;
      bool is_whole = (c < 0x80U || c >= 0xC2U) && i + length <= html_.size();
      for (std::size_t k = 1; is_whole && k < length; ++k) {
        is_whole = (static_cast<unsigned char>(html_[i + k]) & 0xC0U) == 0x80U;
      }
      if (!is_whole) fault("bytes that are not UTF-8");
      i += is_whole ? length : 1;
    }
  }

  void step() {
    if (html_.substr(at_).starts_with("</")) return end_tag();
    if (html_[at_] == '<') return start_tag();
    if (html_[at_] == '&') check_reference(html_.substr(at_));
    if (html_[at_] == '>') fault("stray >");
    if (open_.empty() && !is_space(html_[at_])) fault("text outside the document");
    ++at_;
  }

  void check_reference(std::string_view text) {
    const std::size_t end = text.find(';');
    const bool is_reference =
        end != std::string_view::npos && end > 1 && end < 8 &&
        std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(end),
                    [](char c) { return is_name_character(c) || c == '#'; });
    if (!is_reference) fault("stray &");
  }

  std::string name() {
    const std::size_t begin = at_;
    while (at_ < html_.size() && is_name_character(html_[at_])) ++at_;
    return std::string(html_.substr(begin, at_ - begin));
  }

  void end_tag() {
    at_ += 2;
    const std::string tag = name();
    if (at_ == html_.size() || html_[at_] != '>') fault("end tag of " + tag + " goes on");
    ++at_;
    if (open_.empty() || open_.back() != tag) {
      fault("closed out of order: " + tag);
      return;
    }
    open_.pop_back();
  }

  void start_tag() {
    ++at_;
    const std::string tag = name();
    if (tag.empty()) return fault("stray <");
    const Attributes attributes = read_attributes(tag);
    check_place(tag);
    check_attributes(tag, attributes);
    check_heading(tag);
    if (is_one_of(tag, kVoid)) return;
    if (is_one_of(tag, kRaw)) return skip_raw(tag);
    open_.push_back(tag);
  }

  Attributes read_attributes(const std::string& tag) {
    Attributes attributes;
    while (at_ < html_.size() && html_[at_] != '>') {
      if (!is_space(html_[at_])) {
        fault("no blank before an attribute of " + tag);
        ++at_;
        continue;
      }
      while (at_ < html_.size() && is_space(html_[at_])) ++at_;
      const std::string key = name();
      const auto [place, is_new] = attributes.emplace(key, read_value(key));
      if (!is_new) fault("given twice: " + place->first);
    }
    ++at_;
    return attributes;
  }

  std::string read_value(const std::string& key) {
    if (at_ >= html_.size() || html_[at_] != '=') return "";
    ++at_;
    if (at_ >= html_.size() || html_[at_] != '"') {
      fault("no quotes: " + key);
      return "";
    }
    const std::size_t begin = ++at_;
    at_ = std::min(html_.find('"', begin), html_.size());
    const std::string value(html_.substr(begin, at_ - begin));
    ++at_;
    for (std::size_t i = value.find('&'); i != std::string::npos; i = value.find('&', i + 1)) {
      check_reference(std::string_view(value).substr(i));
    }
    if (value.find('<') != std::string::npos) fault("< in the attribute " + key);
    return value;
  }

  void check_place(const std::string& tag) {
    const std::string parent = open_.empty() ? "" : open_.back();
    const auto must_be_in = [&](std::initializer_list<std::string_view> parents) {
      if (std::find(parents.begin(), parents.end(), parent) == parents.end()) {
        fault(tag + " in " + parent);
      }
    };
    if (tag == "li") must_be_in({"ul", "ol"});
    if (tag == "tr") must_be_in({"thead", "tbody"});
    if (tag == "td" || tag == "th") must_be_in({"tr"});
    if (tag == "summary") must_be_in({"details"});
    if (tag == "figcaption") must_be_in({"figure"});
    if (tag == "button" && is_one_of("button", open_)) fault("button in button");
    if (is_one_of("p", open_) && is_one_of(tag, kNotInParagraph)) fault(tag + " in p");
    if (tag == "main" && std::exchange(has_main_, true)) fault("main twice");
  }

  void check_attributes(const std::string& tag, const Attributes& attributes) {
    for (const auto& [key, value] : attributes) {
      if (key.starts_with("on")) fault("handler " + key);
      if (key == "id" && !ids_.insert(value).second) fault("id twice: " + value);
      if (key == "aria-describedby" || key == "aria-labelledby" || key == "for") {
        referred_.insert(value);
      }
      if (key == "href" && value.starts_with('#')) referred_.insert(value.substr(1));
    }
    if (tag == "th" && !attributes.contains("scope")) fault("th without a scope");
    if (tag == "button" && !attributes.contains("type")) fault("button without a type");
    if (tag == "svg" && !attributes.contains("aria-label")) fault("svg without a label");
  }

  void check_heading(const std::string& tag) {
    if (tag.size() != 2 || tag[0] != 'h' || tag[1] < '1' || tag[1] > '6') return;
    if (tag[1] > last_heading_ + 1) fault("a level left out before " + tag);
    last_heading_ = tag[1];
    if (tag == "h1") ++n_first_headings_;
  }

  void skip_raw(const std::string& tag) {
    const std::size_t end = html_.find("</" + tag, at_);
    if (end == std::string_view::npos) fault("not closed: " + tag);
    at_ = std::min(html_.find('>', std::min(end, html_.size())), html_.size() - 1) + 1;
  }

  std::string_view html_;
  std::size_t at_ = 0;
  std::vector<std::string> open_;
  std::set<std::string> ids_;
  std::set<std::string> referred_;
  char last_heading_ = '0';
  int n_first_headings_ = 0;
  bool has_main_ = false;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> html_faults(std::string_view html) {
  return Checker(html).faults();
}

std::string_view script_of(std::string_view html, std::string_view id) {
  std::string attribute = "id=\"";
  attribute += id;
  attribute += "\">";
  const std::size_t place = html.find(attribute);
  if (place == std::string_view::npos) return {};
  const std::size_t begin = place + attribute.size();
  return html.substr(begin, html.find("</script>", begin) - begin);
}

}  // namespace meshalyzer::test
