/**
 * The agent: {@link org.dfra.recruit.agent.Recruiter} combines the two state machines, a strategy,
 * its robot's {@link org.dfra.recruit.agent.RobotPort} and a transport. The same code runs in a
 * simulation and on a robot, where {@link org.dfra.recruit.agent.RecruitmentAgentImpl} is its
 * module.
 */
@NullMarked
package org.dfra.recruit.agent;

import org.jspecify.annotations.NullMarked;
