/**
 * Where things are. Lengths in metres and angles in radians everywhere but in {@link
 * org.dfra.geometry.GeoPosition}, which keeps WGS84 degrees for the edges: receivers and people.
 */
@NullMarked
package org.dfra.geometry;

import org.jspecify.annotations.NullMarked;
