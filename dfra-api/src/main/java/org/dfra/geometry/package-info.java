/**
 * Positions, frames and transforms. Lengths are in metres and angles in radians, except in {@link
 * org.dfra.geometry.GeoPosition}, which uses WGS84 degrees as receivers and operators do.
 */
@NullMarked
package org.dfra.geometry;

import org.jspecify.annotations.NullMarked;
