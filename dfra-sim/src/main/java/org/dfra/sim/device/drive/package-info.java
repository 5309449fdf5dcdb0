/**
 * Emulated drive controllers, at the byte level.
 *
 * <p>Enter at {@link org.dfra.sim.device.drive.RflexDevice}: it moves a {@link
 * org.dfra.sim.physics.DrivetrainPhysics} and measures a {@link
 * org.dfra.sim.physics.BatteryPhysics}.
 */
@NullMarked
package org.dfra.sim.device.drive;

import org.jspecify.annotations.NullMarked;
