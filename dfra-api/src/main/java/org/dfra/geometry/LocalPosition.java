package org.dfra.geometry;

import java.io.Serializable;

/**
 * A position in the plane that touches the ellipsoid at a datum, ENU.
 *
 * @param east metres to the east of the datum
 * @param north metres to the north of it
 * @param up metres above it, along its vertical
 */
public record LocalPosition(double east, double north, double up) implements Serializable {}
