#include "meshalyzer/report/html/writer.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

std::string escaped(std::string_view text) {
  std::string html;
  append_escaped_html(html, text);
  return html;
}

TEST(AppendEscapedHtml, MarkupBecomesText) {
  EXPECT_EQ(escaped("<b>&\"x.obj"), "&lt;b&gt;&amp;&quot;x.obj");
}

TEST(AppendEscapedHtml, LettersOfAllAlphabetsStay) {
  EXPECT_EQ(escaped("Grüße 立方体 \xF0\x9F\xA7\x8A"), "Grüße 立方体 \xF0\x9F\xA7\x8A");
}

TEST(AppendEscapedHtml, WhatNoDocumentMayHaveIsReplaced) {
  EXPECT_EQ(escaped("a\x01"
                    "b\x7F"
                    "c\r\n\t"),
            "a�b�c�\n\t");
  EXPECT_EQ(escaped(std::string_view("a\0b", 3)), "a�b");
  // U+0085, a control character of two bytes.
  EXPECT_EQ(escaped("a\xC2\x85"
                    "b"),
            "a�b");
}

TEST(AppendEscapedHtml, CharactersThatXmlForbidsAreReplaced) {
  EXPECT_EQ(escaped("\uFFFD \xEF\xBF\xBE \xEF\xBF\xBF"), "\uFFFD \uFFFD \uFFFD");
}

TEST(AppendEscapedHtml, WhatTurnsTheTextAfterItRoundIsReplaced) {
  // The embeddings and overrides U+202A ... U+202E and the isolates U+2066 ... U+2069.
  EXPECT_EQ(escaped("a\u202Abo.x, \u202Eb\u202C.obj"), "a�bo.x, �b�.obj");
  EXPECT_EQ(escaped("a\u2066b\u2069"), "a�b�");
  // What stands beside them in the table of characters stays, and so do words written from right
  // to left.
  EXPECT_EQ(escaped("\u2029\u202F\u2065\u206A שלום"), "\u2029\u202F\u2065\u206A שלום");
}

TEST(AppendEscapedHtml, BytesThatAreNoTextAreReplacedOneByOne) {
  EXPECT_EQ(escaped("a\xFF\xC3(\xE2\x82"), "a��(��");
}

TEST(AddressOf, WhatMeansSomethingInAnAddressIsEncoded) {
  EXPECT_EQ(address_of("set_pages/a b#1?.html"), "set_pages/a%20b%231%3F.html");
  EXPECT_EQ(address_of("100%.html"), "100%25.html");
  EXPECT_EQ(address_of("javascript:alert(1)"), "javascript%3Aalert%281%29");
  EXPECT_EQ(address_of("../ü.html"), "../%C3%BC.html");
}

TEST(Slug, IsMadeOfLettersDigitsAndSingleHyphens) {
  EXPECT_EQ(slug("non-manifold edges"), "non-manifold-edges");
  EXPECT_EQ(slug(" Principal curvature, K1. "), "principal-curvature-k1");
  EXPECT_EQ(slug("<>"), "");
}

TEST(HtmlWriter, ElementsCloseInTheOrderInWhichTheyOpened) {
  HtmlWriter html;
  {
    const HtmlElement outer(html, "span", {{"class", "a\"b"}});
    html.element("code", {{"id", "x"}}, "1 < 2");
    html.void_element("br", {});
  }
  EXPECT_EQ(html.html(), "<span class=\"a&quot;b\"><code id=\"x\">1 &lt; 2</code><br></span>");
}

}  // namespace
}  // namespace meshalyzer
