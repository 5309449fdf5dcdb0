/**
 * Agents: decisions that a robot makes with others. A {@link org.dfra.agent.RecruitmentAgent} asks
 * the team for help, and answers the calls of others.
 *
 * <pre>
 *   requester                                   responder
 *      |---- HELP (place, percept) -- to all --&gt;|
 *      |&lt;--- ACCEPT (time to the place) --------|
 *      |---- RESPONDER_ID (winner) -- to all --&gt;|
 *      |                                        |  travels
 *      |&lt;--- ARRIVAL (lease) -------------------|
 *      |---- AGREE ----------------------------&gt;|
 *      |&lt;--- ACK_ACK ---------------------------|  observes, until its lease ends
 * </pre>
 *
 * <p>Start at {@link org.dfra.agent.RecruitmentAgent}. The messages are records of dfra-recruit.
 */
@NullMarked
package org.dfra.agent;

import org.jspecify.annotations.NullMarked;
