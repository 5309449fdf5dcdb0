/**
 * Recruitment agents over River: the server of an agent and the proxy that other robots call.
 *
 * <pre>
 *   requester's robot                                     helper's robot
 *   RecruitmentAgentImpl --message--&gt; RecruitmentAgentProxy --AgentMessageEvent--.
 *                                     a RemoteRecruitmentAgent                   v
 *                                     found by its RecruitmentEntry     RecruitmentAgentServer
 *                                                                                |
 *                                     RecruitmentAgentImpl &lt;------message--------'
 * </pre>
 *
 * <p>Enter at {@link org.dfra.recruit.river.RecruitmentAgentServer}. The rest of dfra-recruit is
 * independent of the network.
 */
@NullMarked
package org.dfra.recruit.river;

import org.jspecify.annotations.NullMarked;
