/**
 * What sensors do wrong while their robot stands, as figures that the estimators want to know; the
 * procedures of {@code docs/reference/sensor-noise.md}. Enter at {@link
 * org.dfra.app.noise.NoiseStudy}.
 */
@NullMarked
package org.dfra.app.noise;

import org.jspecify.annotations.NullMarked;
