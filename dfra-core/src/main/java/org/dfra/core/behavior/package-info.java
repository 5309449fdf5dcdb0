/**
 * What every behaviour does: takes up a goal, works at it at a rate, pauses, and ends. Enter at
 * {@link org.dfra.core.behavior.BehaviorImpl}.
 *
 * <pre>
 *   BehaviorImpl  what others see: goals, status, attributes, parameters
 *     '--&gt; GoalExecutor  control loop; takes up, pauses, resumes, cancels and ends goals
 *            |--&gt; Pursuit --&gt; StepResult  what one step of a goal has come to
 *            '--&gt; BehaviorStatusTracker  the status, and who is told of it
 *   DriveInterlock  parking brake and emergency stop     Delegation  goals of other behaviours
 * </pre>
 */
@NullMarked
package org.dfra.core.behavior;

import org.jspecify.annotations.NullMarked;
