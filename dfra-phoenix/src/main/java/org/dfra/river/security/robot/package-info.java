/**
 * What the processes of a robot share for decisions by their policy: named facts, the robot's
 * position, and the calls that wait for an operator's confirmation.
 *
 * <p>Start at {@link org.dfra.river.security.robot.RobotState}, which each process of a secure
 * robot has, and {@link org.dfra.river.security.robot.PolicyControl}, which operators call. What is
 * shared are files in the folder {@value org.dfra.river.security.robot.RobotState#FOLDER} of the
 * state folder.
 */
@NullMarked
package org.dfra.river.security.robot;

import org.jspecify.annotations.NullMarked;
