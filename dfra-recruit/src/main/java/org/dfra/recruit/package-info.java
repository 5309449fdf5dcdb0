/**
 * Affective recruitment: robots that ask others for help and decide by an affect, shame, whether to
 * give it. Nothing here knows a network.
 *
 * <pre>
 *   agent.Recruiter ---- requester.RequesterMachine   who needs help    \  pure: a state and what
 *        |  |  |    '--- responder.ResponderMachine   who may help      /  happens give the next
 *        |  |  '-------- strategy, affect             who answers, who is chosen
 *        |  '----------- agent.Body                   where the robot is, and how it comes there
 *        '-------------- transport.Transport          how messages travel: simulated, or events
 * </pre>
 *
 * <p>The protocol is that of the thesis, section 5.4; its time-outs, the equations of shame and the
 * rules that keep it correct where messages are lost are this project's own. Enter at {@link
 * org.dfra.recruit.agent.Recruiter}.
 */
@NullMarked
package org.dfra.recruit;

import org.jspecify.annotations.NullMarked;
