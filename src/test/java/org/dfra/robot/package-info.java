/**
 * Whole robots in real processes: phoenix, its groups, their registrars and modules.
 *
 * <p>Enter at {@link org.dfra.robot.RobotBootstrapIT}.
 */
package org.dfra.robot;
