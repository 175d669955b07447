#pragma once

#include <string>

#include "mesher/geometry/domain.h"

namespace parmesan {

/// Reads the polygons of a GeoJSON text (RFC 7946): Polygon, MultiPolygon, GeometryCollection, Feature or
/// FeatureCollection. Longitude and latitude are taken as x and y; further coordinates are skipped. Points and lines in
/// features and collections are left out, with a note.
///
/// The inside of a feature is what an odd number of its rings enclose, whatever their direction. One feature is a
/// domain with the sides "boundary" and "hole1", "hole2", ... Several are the regions of one domain, by their
/// properties' name or "feature1", ..., where they overlap the smallest one's, with sides of the same names, and "a|b"
/// between two of them. Points nearer than the merge tolerance, or 16 ulp of the largest coordinate, become one first,
/// and sides bend to points as near, so that rings a little apart have a border; the domain's notes tell of it. Errors:
/// FileError with the line and the JSON pointer, also where there are no polygons and for keys given twice;
/// GeometryError for several features whose rings cross, unless they are to be split there.
Domain read_geojson(const std::string& path, Crossings crossings = Crossings::Refuse, double merge_tolerance = 0.0);
Domain parse_geojson(const std::string& text, const std::string& name, Crossings crossings = Crossings::Refuse,
                     double merge_tolerance = 0.0);

}  // namespace parmesan
