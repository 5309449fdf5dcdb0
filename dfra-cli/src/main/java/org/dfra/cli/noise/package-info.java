/**
 * Sensor errors while the robot is stopped, as parameters for the estimators; the procedures of
 * {@code docs/reference/sensor-noise.md}. Entry point: {@link org.dfra.cli.noise.NoiseStudy}.
 */
@NullMarked
package org.dfra.cli.noise;

import org.jspecify.annotations.NullMarked;
