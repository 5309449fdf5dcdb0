/**
 * From a robot's description to its processes: brought up, taken down, and changed in between.
 *
 * <p>Enter at {@link org.dfra.bringup.RobotBootstrapIT}.
 */
package org.dfra.bringup;
