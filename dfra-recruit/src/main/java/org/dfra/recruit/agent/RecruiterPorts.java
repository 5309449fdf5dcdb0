package org.dfra.recruit.agent;

import java.time.InstantSource;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.recruit.transport.Transport;
import org.dfra.time.Scheduler;

/**
 * What an agent reaches the world by.
 *
 * @param transport the other agents
 * @param robot its robot
 * @param leases the module's own, in which requesters hold the lease on it while it helps them
 * @param clock what time it is, by the robot's time, for people: somebody may set it
 * @param monotonicClock what every span goes by: nobody sets it, and it goes on over the agent's
 *     deaths
 * @param scheduler wakes it, by the robot's time
 */
public record RecruiterPorts(
    Transport transport,
    RobotPort robot,
    LeaseRegistry leases,
    InstantSource clock,
    InstantSource monotonicClock,
    Scheduler scheduler) {

  /** By a clock that nobody sets, as a simulation's. */
  public RecruiterPorts(
      Transport transport,
      RobotPort body,
      LeaseRegistry leases,
      InstantSource clock,
      Scheduler scheduler) {
    this(transport, body, leases, clock, clock, scheduler);
  }
}
