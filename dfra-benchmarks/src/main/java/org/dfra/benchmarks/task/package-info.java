/**
 * Tasks in processes of their own, which end with the process that started them: attackers and
 * their robot, both ends of a measured call, and JMH, which must not share its JVM with the command
 * line.
 *
 * <p>Enter at {@link org.dfra.benchmarks.task.TaskProcess}.
 */
@NullMarked
package org.dfra.benchmarks.task;

import org.jspecify.annotations.NullMarked;
