/**
 * Affective recruitment: robots call other robots for help, and an affect, shame, determines
 * whether they offer it. This package is independent of the network.
 *
 * <pre>
 *   agent.Recruiter ---- requester.RequesterMachine   needs help      \  pure: a state and an
 *        |  |  |    '--- responder.ResponderMachine   may help        /  event give the next one
 *        |  |  '-------- strategy, affect             selects responders and the helper
 *        |  '----------- agent.RobotPort              the robot's position and motion
 *        '-------------- transport.Transport          messages: simulated, or remote events
 * </pre>
 *
 * <p>The protocol is that of the thesis, section 5.4; its timeouts, the equations of shame and the
 * rules that keep it correct despite lost messages are DFRA's own. Enter at {@link
 * org.dfra.recruit.agent.Recruiter}.
 */
@NullMarked
package org.dfra.recruit;

import org.jspecify.annotations.NullMarked;
