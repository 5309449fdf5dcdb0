/**
 * What a robot's processes have from the computer: its address, its registrar, a JVM; and a
 * subscription that outlives the process which was subscribed to.
 *
 * <p>Enter at {@link org.dfra.robot.SubscriptionIT}.
 */
package org.dfra.robot;
