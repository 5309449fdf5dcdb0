/**
 * Recruitment agents over River: what serves an agent to other robots and what they call it by.
 *
 * <pre>
 *   requester's robot                                     helper's robot
 *   RecruitmentAgentImpl --letter--&gt; RecruitmentAgentProxy --AgentMessageEvent--&gt; RecruitmentAgentServer
 *                                     a RemoteRecruitmentAgent                 |
 *                                     found by its RecruitmentEntry            letter
 *                                                                              v
 *                                                                     RecruitmentAgentImpl
 * </pre>
 *
 * <p>Enter at {@link org.dfra.recruit.river.RecruitmentAgentServer}. The rest of dfra-recruit knows
 * no network.
 */
@NullMarked
package org.dfra.recruit.river;

import org.jspecify.annotations.NullMarked;
