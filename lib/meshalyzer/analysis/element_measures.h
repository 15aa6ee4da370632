#pragma once

#include "meshalyzer/analysis/field_info.h"

#include <array>
#include <cstddef>

namespace meshalyzer {

/// A T for each quantity that is measured of the vertices, edges and faces of a mesh, for example
/// its statistics or all its values.
///
/// A quantity is a member here and a row of kElementMeasures; all code that computes, adds up,
/// writes, reads or explains such quantities loops over the rows.
template <typename T>
struct ElementMeasures {
  /// The number of edges at each vertex that a face uses.
  T vertex_valence;
  T face_area;
  T aspect_ratio;
  /// The smallest angle of a face in degrees; 0 for a face of zero area.
  T corner_angle;
  T edge_length;
  /// The angle in degrees at each edge with two consistently oriented faces of non-zero area.
  T edge_angle;

  /// Returns the member that row i of kElementMeasures describes.
  [[nodiscard]] T& operator[](std::size_t i);
  [[nodiscard]] const T& operator[](std::size_t i) const;
};

/// One row for each member of ElementMeasures, in the order of reports.
template <typename T>
inline constexpr std::array kElementMeasures{
    QuantityRow<ElementMeasures<T>, T>{{.info = {.key = "vertex_valence",
                                                 .label = "vertex valence",
                                                 .definition = "edges at a vertex"},
                                        .if_none = "no face"},
                                       &ElementMeasures<T>::vertex_valence},
    QuantityRow<ElementMeasures<T>, T>{
        {.info = {.key = "face_area", .label = "face area", .definition = "area of a face"},
         .if_none = "no face",
         .total = Quantity::Total::Show},
        &ElementMeasures<T>::face_area},
    QuantityRow<ElementMeasures<T>, T>{
        {.info = {.key = "aspect_ratio",
                  .label = "aspect ratio",
                  .definition = "longest edge of a face over its shortest altitude: 1.1547 where "
                                "all edges are equal, more the thinner it is"},
         .if_none = "no face with an area"},
        &ElementMeasures<T>::aspect_ratio},
    QuantityRow<ElementMeasures<T>, T>{
        {.info = {.key = "corner_angle",
                  .label = "corner angle",
                  .definition = "smallest of the three angles of a face, in degrees: 60 where all "
                                "edges are equal, 0 where the face has no area"},
         .if_none = "no face"},
        &ElementMeasures<T>::corner_angle},
    QuantityRow<ElementMeasures<T>, T>{
        {.info = {.key = "edge_length",
                  .label = "edge length",
                  .definition = "distance of the two ends of an edge"},
         .if_none = "no edge",
         .total = Quantity::Total::Show},
        &ElementMeasures<T>::edge_length},
    QuantityRow<ElementMeasures<T>, T>{
        {.info = {.key = "edge_angle",
                  .label = "edge angle",
                  .definition = "angle in degrees between the two faces of an edge, on the side "
                                "their normals point to: 180 is flat, 270 the edge of a cube seen "
                                "from outside"},
         .if_none = "no edge between two consistently oriented faces with an area"},
        &ElementMeasures<T>::edge_angle},
};

template <typename T>
T& ElementMeasures<T>::operator[](std::size_t i) {
  return this->*kElementMeasures<T>[i].member;
}

template <typename T>
const T& ElementMeasures<T>::operator[](std::size_t i) const {
  return this->*kElementMeasures<T>[i].member;
}

}  // namespace meshalyzer
