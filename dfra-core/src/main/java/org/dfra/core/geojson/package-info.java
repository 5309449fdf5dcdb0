/**
 * Reads GeoJSON (RFC 7946) that was written by hand or drawn on a map: features with line numbers,
 * polygons without holes, error messages with file and line.
 *
 * <p>Start at {@link org.dfra.core.geojson.GeoJsonFile}. The reader interprets a feature: as an
 * obstacle or a mine in a world, or as the region of a raster search.
 */
@NullMarked
package org.dfra.core.geojson;

import org.jspecify.annotations.NullMarked;
