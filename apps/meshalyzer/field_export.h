#pragma once

#include "meshalyzer/picture/field.h"
#include "options.h"

#include <string>

namespace meshalyzer {

/// A field of a mesh in its colours. Only referred to.
struct ColouredField {
  const Soup& soup;
  /// The field, which belongs to this soup.
  const Field& field;
  const FieldColours& colours;
  /// A remark on the values, in ASCII.
  std::string remark = {};
};

/// Writes a field as quality and colour of the vertices of a mesh: all vertex records and all faces
/// whose corners are defined, in file order. A field of faces also as theirs, where the format can.
///
/// @param file  Written in place of what is there, as its ending says (field_format_of_name());
///              its folder must be there.
/// @throws IoError         if it cannot be written.
/// @throws InvalidArgument if the ending is of no format that holds a field.
void write_field(const std::string& file, const ColouredField& field);

/// The same, computed here. Nothing is written where the source has not what the field needs.
///
/// @param wanted  Which field and palette; not which file.
void write_field(const std::string& file, const FieldSource& source, const FieldExport& wanted);

}  // namespace meshalyzer
