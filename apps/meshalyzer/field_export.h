#pragma once

#include "meshalyzer/picture/field.h"
#include "options.h"

#include <string>

namespace meshalyzer {

/// A field of a mesh and its colours. The struct only refers to its data.
struct ColouredField {
  const Soup& soup;
  /// The field, which belongs to this soup.
  const Field& field;
  const FieldColours& colours;
  /// A remark on the values, in ASCII.
  std::string remark = {};
};

/// Writes a field as quality and colour of the vertices of a mesh, with all vertex records and all
/// faces whose corners are defined, in file order. A field of faces is also written as theirs if
/// the format can hold it.
///
/// @param file  The file, which is replaced if it exists; its ending determines the format
///              (field_format_of_name()), and its folder must exist.
/// @throws IoError         if it cannot be written.
/// @throws InvalidArgument if the ending is of no format that holds a field.
void write_field(const std::string& file, const ColouredField& field);

/// Computes a field and writes it. Nothing is written if the source lacks data for it.
///
/// @param wanted  The field and the palette; its file is ignored.
void write_field(const std::string& file, const FieldSource& source, const FieldExport& wanted);

}  // namespace meshalyzer
