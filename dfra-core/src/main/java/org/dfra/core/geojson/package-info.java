/**
 * GeoJSON (RFC 7946) as people write it by hand or draw it on a map: features with the lines they
 * begin in, polygons without holes, complaints that name file and line.
 *
 * <p>Enter at {@link org.dfra.core.geojson.GeoJsonFile}. What a feature means is its reader's
 * matter: a world takes it for an obstacle or a mine, a raster for the region.
 */
@NullMarked
package org.dfra.core.geojson;

import org.jspecify.annotations.NullMarked;
