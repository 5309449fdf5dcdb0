/**
 * Controllers of wheels that do not exist, byte by byte.
 *
 * <p>Enter at {@link org.dfra.sim.device.drive.RflexDevice}: it moves a {@link
 * org.dfra.sim.body.DriveBody} and measures a {@link org.dfra.sim.body.BatteryBody}.
 */
@NullMarked
package org.dfra.sim.device.drive;

import org.jspecify.annotations.NullMarked;
