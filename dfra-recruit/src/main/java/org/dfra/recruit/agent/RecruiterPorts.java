package org.dfra.recruit.agent;

import java.time.InstantSource;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.recruit.transport.Transport;
import org.dfra.time.Scheduler;

/**
 * The interfaces of an agent to its environment.
 *
 * @param transport the other agents
 * @param robot its robot
 * @param leases the module's own, which grant the lease to a requester while the agent helps it
 * @param clock the robot's wall-clock time, for people: it may be set
 * @param monotonicClock for all timeouts: it is never set, and continues across restarts of the
 *     agent
 * @param scheduler wakes it, by the robot's time
 */
public record RecruiterPorts(
    Transport transport,
    RobotPort robot,
    LeaseRegistry leases,
    InstantSource clock,
    InstantSource monotonicClock,
    Scheduler scheduler) {

  /** With a clock that is never set, such as a simulation's. */
  public RecruiterPorts(
      Transport transport,
      RobotPort body,
      LeaseRegistry leases,
      InstantSource clock,
      Scheduler scheduler) {
    this(transport, body, leases, clock, clock, scheduler);
  }
}
