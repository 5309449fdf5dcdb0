/**
 * How long the processes of a robot take to start, and how much memory they have.
 *
 * <pre>
 *   {@link org.dfra.benchmarks.start.RobotStart} -- brings robots up, kills a process, reads memory
 *   {@link org.dfra.benchmarks.start.ComputingTask} -- what a group computes, with one compiler or both
 * </pre>
 */
@NullMarked
package org.dfra.benchmarks.start;

import org.jspecify.annotations.NullMarked;
