/**
 * The base of every behaviour: it accepts a goal, executes it at a rate, pauses, and ends. Start at
 * {@link org.dfra.core.behavior.BehaviorImpl}.
 *
 * <pre>
 *   BehaviorImpl  public interface: goals, status, attributes, parameters
 *     '--&gt; GoalExecutor  control loop; starts, pauses, resumes, cancels and ends goals
 *            |--&gt; GoalExecution --&gt; StepResult  the result of one step of a goal
 *            '--&gt; BehaviorStatusTracker  the status, and notification of listeners
 *   DriveInterlock  parking brake, emergency stop      GoalDelegation  goals of other behaviours
 * </pre>
 */
@NullMarked
package org.dfra.core.behavior;

import org.jspecify.annotations.NullMarked;
