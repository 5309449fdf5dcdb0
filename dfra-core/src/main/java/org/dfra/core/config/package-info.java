/**
 * The configuration of a robot: its XML, the properties of its modules, their parameters.
 *
 * <pre>
 *   robot.xml --RobotXml.read--&gt; RobotDescription
 *      |                           GroupDescription, one JVM each
 *      v                             RegistrarDescription, one per robot at most
 *   module.properties                ModuleDescription --&gt; the activation log
 *                                      Parameters --&gt; the driver
 * </pre>
 *
 * <p>Start at {@link org.dfra.core.config.RobotXml}, or at {@link org.dfra.core.config.Parameters}
 * for a driver's view. An invalid configuration throws a {@link
 * org.dfra.core.config.ConfigurationException} that lists all faults, a line each: file and line,
 * fault, remedy. The reference for users is {@code docs/reference/robot-xml.md}.
 */
@NullMarked
package org.dfra.core.config;

import org.jspecify.annotations.NullMarked;
