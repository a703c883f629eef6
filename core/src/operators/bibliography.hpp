#pragma once

namespace polylap {

/// Several operators come from the one thesis.
inline constexpr const char* herholz_2012 = R"(@mastersthesis{herholz2012,
  author = {Philipp Herholz},
  title = {General discrete {L}aplace operators on polygonal meshes},
  type = {Diploma thesis},
  school = {Humboldt-Universit{\"a}t zu Berlin},
  year = {2012}
})";

}  // namespace polylap
