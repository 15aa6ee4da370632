#include "meshalyzer/io/convert/stl_attributes.h"

#include "meshalyzer/base/bytes.h"
#include "meshalyzer/io/stl_layout.h"
#include "meshalyzer/io/text_scanner.h"

#include <bit>

namespace meshalyzer {

std::vector<Group> named_solids(std::string_view text) {
  std::vector<Group> solids;
  Index n_facets = 0;
  bool has_name = false;
  TextScanner in(text);
  while (in.next_record()) {
    // The first letters distinguish the keywords that can occur here.
    const std::string_view word = in.word();
    if (word.size() == 5 && (word[0] == 's' || word[0] == 'S')) {
      solids.push_back({in.rest_of_record(), n_facets});
      has_name = has_name || !solids.back().name.empty();
    } else if (word.size() == 8 && (word[3] == 's' || word[3] == 'S')) {
      in.skip_record();  // endsolid, whose name may consist of any words
    } else if (word.size() == 8 && (word[3] == 'f' || word[3] == 'F')) {
      ++n_facets;
    }
  }
  return has_name ? solids : std::vector<Group>{};
}

std::vector<std::uint16_t> read_attribute_words(std::string_view content, std::size_t n_facets) {
  std::vector<std::uint16_t> words(n_facets);
  for (std::size_t i = 0; i < n_facets; ++i) {
    const std::size_t at = kStlFacetsOffset + kStlFacetBytes * i + kStlAttributeOffset;
    words[i] = load<std::uint16_t>(content.data() + at, std::endian::little);
  }
  return words;
}

std::string_view stl_header(std::string_view content) {
  const std::string_view header = content.substr(0, kStlHeaderBytes);
  return header.substr(0, header.find_last_not_of(std::string_view(" \0", 2)) + 1);
}

}  // namespace meshalyzer
