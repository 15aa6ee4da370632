#include "meshalyzer/mesh/soup.h"

namespace meshalyzer {

std::string_view format_name(Format format) {
  switch (format) {
    case Format::Mesh:
      return "mesh";
    case Format::Inria:
      return "inria";
    case Format::Obj:
      return "obj";
    case Format::Off:
      return "off";
    case Format::Stl:
      return "stl";
    case Format::Ply:
      return "ply";
  }
  return "";
}

}  // namespace meshalyzer
