/**
 * What the attacks share: the hosts, the attacked robot, the fake services, and {@link
 * org.dfra.attack.kit.Victim}, which measures the robot.
 */
package org.dfra.attack.kit;
