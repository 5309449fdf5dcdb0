/**
 * The iRobot rFLEX controller of an ATRV-Jr: wheels, odometry and battery over one link.
 *
 * <pre>
 *   RflexDriveImpl ----.                              .--&gt; RflexFramer --&gt; RflexDecoder --.
 *   RflexOdometryImpl --+--&gt; RflexController ==link==+                                     |
 *   RflexBatteryImpl --'     (one per address)        '--- RflexOutbox &lt;--- RflexCommands  |
 *           ^                                                                              |
 *           '------------------------------- RflexMessage --------------------------------'
 * </pre>
 *
 * <p>Enter at {@link org.dfra.drivers.drive.rflex.RflexDriveImpl}. A serial port has one reader, so
 * the three modules share a {@link org.dfra.drivers.drive.rflex.RflexController} and must be in one
 * group of the robot's XML.
 */
@NullMarked
package org.dfra.drivers.drive.rflex;

import org.jspecify.annotations.NullMarked;
